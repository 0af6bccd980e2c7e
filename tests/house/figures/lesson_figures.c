// lesson_figures.c - the figures that the lessons show are those that the code draws.
//
//   lesson_figures FOLDER CHAPTER...           says what differs; exit status 1 if anything does
//   lesson_figures --write FOLDER CHAPTER...   writes it afresh
//   lesson_figures --in-steps CHAPTER...       names the figures of which lessons show a step
//
// FOLDER/NAME/ has what draw_figures made: NAME[-4x3][-dark].svg, NAME.txt. Each layout
// CHAPTER/figures/NAME.gp has these pictures beside it, and CHAPTER/README.md shows them on a line
// of its own, light and dark, wide and narrow, with the words of NAME.txt for readers who do not
// see them.
#include <glob.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BYTES = 160000 };

typedef struct {
    char s[1000];
} Path;

// On a narrow screen the text of a figure in the shape 4:3 is a third larger.
static const struct {
    const char *shape, *theme, *media;
} variants[] = {{"", "", ""},
                {"", "-dark", "(prefers-color-scheme: dark)"},
                {"-4x3", "", "(max-width: 600px)"},
                {"-4x3", "-dark", "(max-width: 600px) and (prefers-color-scheme: dark)"}};
enum { VARIANTS = sizeof variants / sizeof variants[0] };

static bool writing;
static int differences;

__attribute__((format(printf, 1, 2))) static Path path_of(const char *format, ...)
{
    Path path;
    va_list list;
    va_start(list, format);
    vsnprintf(path.s, sizeof path.s, format, list);
    va_end(list);
    return path;
}

__attribute__((format(printf, 1, 2))) static void differs(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vprintf(format, list);
    va_end(list);
    putchar('\n');
    differences++;
}

// All of a file, for freeing; NULL if it cannot be read.
static char *text_of(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL, part[4096];
    size_t size;
    if (file == NULL)
        return NULL;
    FILE *copy = open_memstream(&text, &size);
    for (size_t n; copy != NULL && (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    fclose(file);
    if (copy != NULL)
        fclose(copy);
    return text;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0) {
        perror(path);
        exit(2);
    }
    printf("wrote %s\n", path);
}

// Writes the right file in the place of the committed one, or reports the difference.
static void same(const char *path, const char *right, const char *remedy)
{
    char *text = text_of(path);
    if (text == NULL || strcmp(text, right) != 0) {
        if (writing)
            write_text(path, right);
        else
            differs("%s %s: %s", path, text == NULL ? "is missing" : "is not what the code draws",
                    remedy);
    }
    free(text);
}

// An <img> shows an SVG without anything from elsewhere, and runs nothing.
static void stands_alone(const char *name, const char *svg)
{
    static const char *const forbidden[] = {
        "<script", "<foreignObject", "href='http", "href=\"http", "@import", "url(", NULL};
    for (int i = 0; forbidden[i] != NULL; i++)
        if (strstr(svg, forbidden[i]) != NULL)
            differs("%s.svg has '%s', which an <img> does not show", name, forbidden[i]);
    if (strlen(svg) > MOST_BYTES)
        differs("%s.svg has %zu bytes, which is more than %d", name, strlen(svg), MOST_BYTES);
}

// The file of a figure or a step, as draw_figures names it: NAME[-4x3][-stepN][-dark].
static Path variant(const char *name, size_t v)
{
    const char *step = strstr(name, "-step");
    size_t length = step == NULL ? strlen(name) : (size_t)(step - name);
    return path_of("%.*s%s%s%s", (int)length, name, variants[v].shape, name + length,
                   variants[v].theme);
}

// The line of a lesson that shows a figure, for freeing. A figure in words is its title, an empty
// line, and sentences.
static char *line_of(const char *name, const char *in_words)
{
    char *line = NULL;
    size_t size;
    FILE *out = open_memstream(&line, &size);
    if (out == NULL)
        exit(2);
    fprintf(out, "<picture>");
    for (size_t v = VARIANTS - 1; v > 0; v--)
        fprintf(out, "<source media=\"%s\" srcset=\"figures/%s.svg\">", variants[v].media,
                variant(name, v).s);
    fprintf(out, "<img alt=\"");
    const char *words = strchr(in_words, '\n');
    for (words = words == NULL ? in_words : words + strspn(words, "\n"); *words != '\0'; words++)
        if (*words == '\n')
            fputs(words[1] == '\0' ? "" : " ", out);
        else if (strchr("&<>\"", *words) != NULL)
            fputs(*words == '&'   ? "&amp;"
                  : *words == '<' ? "&lt;"
                  : *words == '>' ? "&gt;"
                                  : "&quot;",
                  out);
        else
            putc(*words, out);
    fprintf(out, "\" src=\"figures/%s.svg\"></picture>", name);
    fclose(out);
    return line;
}

// Each line of the lesson that shows the figure is what it should be, and there is one; returns the
// lesson as it should be, for freeing.
static char *shown(const char *chapter, char *lesson, const char *name, const char *right)
{
    Path here = path_of("src=\"figures/%s.svg\"", name);
    char *new = NULL, *rest = lesson;
    size_t size;
    int found = 0;
    FILE *out = open_memstream(&new, &size);
    if (out == NULL)
        exit(2);
    for (char *line; (line = strsep(&rest, "\n")) != NULL;) {
        bool shows = strstr(line, here.s) != NULL;
        found += shows;
        if (shows && !writing && strcmp(line, right) != 0)
            differs("%s/README.md shows %s with other words than the figure's: make lesson-figures",
                    chapter, name);
        fprintf(out, "%s%s", shows ? right : line, rest == NULL ? "" : "\n");
    }
    fclose(out);
    free(lesson);
    if (found == 0)
        differs("%s/README.md does not show the figure %s. Add a line:\n%s", chapter, name, right);
    return new;
}

// A figure that was drawn, its copies in a chapter and the line of the lesson; returns the lesson
// as it should be, for freeing.
static char *check_figure(const char *drawn, const char *chapter, char *lesson, const char *name,
                          const char *in_words)
{
    const char *step = strstr(name, "-step");
    Path folder =
        path_of("%s/%.*s", drawn, (int)(step == NULL ? strlen(name) : (size_t)(step - name)), name);
    for (size_t v = 0; v < VARIANTS; v++) {
        Path file = variant(name, v);
        char *svg = text_of(path_of("%s/%s.svg", folder.s, file.s).s);
        if (svg == NULL || in_words == NULL) {
            fprintf(stderr, "%s/%s.svg: not drawn\n", folder.s, file.s);
            exit(2);
        }
        stands_alone(file.s, svg);
        same(path_of("%s/figures/%s.svg", chapter, file.s).s, svg, "make lesson-figures");
        free(svg);
    }
    char *right = line_of(name, in_words);
    lesson = shown(chapter, lesson, name, right);
    free(right);
    return lesson;
}

// The line that shows a figure, or NULL.
static const char *line_that_shows(const char *lesson, const char *name)
{
    const char *at = strstr(lesson, path_of("src=\"figures/%s.svg\"", name).s);
    while (at != NULL && at > lesson && at[-1] != '\n')
        at--;
    return at;
}

// The end of the first sentences of a text: a full stop before a space, a quote or a line's end.
static const char *after_sentences(const char *text, int count)
{
    for (; *text != '\0' && count > 0; text++)
        if (*text == '.' && strchr(" \"\n", text[1]) != NULL)
            count--;
    return text;
}

static int sentences_in(const char *line)
{
    const char *at = strstr(line, " alt=\""), *end = at == NULL ? NULL : strchr(at + 6, '"');
    int count = 0;
    while (end != NULL && count < 100 && after_sentences(at, count + 1) <= end)
        count++;
    return count;
}

// A lesson may also show a step of a figure, so that a question does not show its answer. Its words
// are the first sentences of the figure's: as many as the lesson has now.
static char *check_step(const char *drawn, const char *chapter, char *lesson, const char *name,
                        const char *in_words)
{
    int sentences = sentences_in(line_that_shows(lesson, name));
    const char *begin = in_words + strcspn(in_words, "\n");
    char *words = strdup(in_words);
    words[after_sentences(begin, sentences > 0 ? sentences : 1) - in_words] = '\0';
    lesson = check_figure(drawn, chapter, lesson, name, words);
    free(words);
    return lesson;
}

enum { MOST_STEPS = 9 };

// Prints the name of each figure of which a step is shown, or checks a chapter's figures.
static char *go_through(const char *drawn, const char *chapter, char *lesson, bool only_names)
{
    glob_t layouts;
    if (glob(path_of("%s/figures/*.gp", chapter).s, 0, NULL, &layouts) != 0)
        return lesson;
    for (size_t k = 0; k < layouts.gl_pathc; k++) {
        Path layout = path_of("%s", layouts.gl_pathv[k]);
        *strrchr(layout.s, '.') = '\0';
        const char *name = strrchr(layout.s, '/') + 1;
        char *in_words = only_names ? NULL : text_of(path_of("%s/%s/%s.txt", drawn, name, name).s);
        if (!only_names)
            lesson = check_figure(drawn, chapter, lesson, name, in_words);
        bool named = false;
        for (int step = 1; step <= MOST_STEPS; step++) {
            Path at_step = path_of("%s-step%d", name, step);
            if (line_that_shows(lesson, at_step.s) == NULL)
                continue;
            if (!only_names)
                lesson = check_step(drawn, chapter, lesson, at_step.s, in_words);
            else if (!named)
                puts(name);
            named = true;
        }
        free(in_words);
    }
    globfree(&layouts);
    return lesson;
}

int main(int argc, char *argv[])
{
    writing = argc > 1 && strcmp(argv[1], "--write") == 0;
    bool only_names = argc > 1 && strcmp(argv[1], "--in-steps") == 0;
    argv += writing;
    argc -= writing;
    if (argc < 3) {
        fprintf(stderr, "Usage: lesson_figures [--write] FOLDER CHAPTER...\n"
                        "       lesson_figures --in-steps CHAPTER...\n");
        return 2;
    }
    for (int i = 2; i < argc; i++) {
        Path readme = path_of("%s/README.md", argv[i]);
        char *lesson = text_of(readme.s), *before = text_of(readme.s);
        if (lesson == NULL || before == NULL) {
            perror(readme.s);
            return 2;
        }
        lesson = go_through(argv[1], argv[i], lesson, only_names);
        if (writing && strcmp(lesson, before) != 0)
            write_text(readme.s, lesson);
        free(lesson);
        free(before);
    }
    return differences > 0;
}
