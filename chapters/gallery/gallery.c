// gallery.c - makes BUILT/gallery/index.html: every picture and figure that is there, by chapter.
//
//   gallery BUILT SCENES-FOLDER
//
// A page that needs no network and no script. Each picture is also described in words: a figure by
// BUILT/figures/NAME/NAME.txt, a chapter's picture by chapters/NN-stem/picture.txt, and a scene by
// its first comment.
#include "common/whole_file.h"

#include <glob.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

typedef struct {
    const char *built, *scenes, *answers; // answers: the folder's name
} Gallery;

typedef struct {
    char s[1000];
} Path;

__attribute__((format(printf, 1, 2))) static Path path_of(const char *format, ...)
{
    Path path;
    va_list list;
    va_start(list, format);
    vsnprintf(path.s, sizeof path.s, format, list);
    va_end(list);
    return path;
}

static bool exists(Path path)
{
    struct stat about;
    return stat(path.s, &about) == 0;
}

static bool is_newer(Path path, Path other)
{
    struct stat a, b;
    if (stat(path.s, &a) != 0 || stat(other.s, &b) != 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

// ---- text
// -----------------------------------------------------------------------------------------

static void put_escaped(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        if (*text == '&')
            fputs("&amp;", out);
        else if (*text == '<')
            fputs("&lt;", out);
        else if (*text == '>')
            fputs("&gt;", out);
        else if (*text == '"')
            fputs("&quot;", out);
        else
            putc(*text, out);
    }
}

// A link to a file whose name may have letters that mean something in a link.
static void put_href(FILE *out, const char *name)
{
    for (; *name != '\0'; name++) {
        if (strchr("%#?", *name) != NULL)
            fprintf(out, "%%%02X", (unsigned char)*name);
        else
            put_escaped(out, (const char[]){*name, '\0'});
    }
}

// Of a text: its first line, and all that follows in one line.
typedef struct {
    char title[500], words[4000];
} Words;

static bool read_words(Path path, Words *words)
{
    *words = (Words){"", ""};
    FILE *file = fopen(path.s, "r");
    if (file == NULL)
        return false;
    if (fgets(words->title, sizeof words->title, file) != NULL)
        words->title[strcspn(words->title, "\n")] = '\0';
    size_t length = fread(words->words, 1, sizeof words->words - 1, file);
    fclose(file);
    char *to = words->words;
    for (size_t i = 0; i < length; i++) {
        bool line_end = words->words[i] == '\n';
        if (!line_end || (to > words->words && to[-1] != ' '))
            *to++ = line_end ? ' ' : words->words[i];
    }
    while (to > words->words && to[-1] == ' ')
        to--;
    *to = '\0';
    return true;
}

// The text after '# ' in the first line of a file; "" if the line does not begin with it.
static void read_heading(Path path, char *heading, size_t size)
{
    FILE *file = fopen(path.s, "r");
    char line[1000] = "";
    if (file != NULL && fgets(line, sizeof line, file) != NULL)
        line[strcspn(line, "\n")] = '\0';
    if (file != NULL)
        fclose(file);
    const char *text = line[0] == '#' ? line + 1 + strspn(line + 1, " ") : "";
    snprintf(heading, size, "%s", text);
}

// ---- pictures
// -------------------------------------------------------------------------------------

// A PNG has its width and height behind 16 bytes, each in four, the largest first.
static void put_size_of_png(FILE *out, Path path)
{
    unsigned char head[24] = {0};
    FILE *file = fopen(path.s, "rb");
    if (file != NULL && fread(head, 1, sizeof head, file) == sizeof head)
        fprintf(out, "width=\"%d\" height=\"%d\"", head[18] * 256 + head[19],
                head[22] * 256 + head[23]);
    if (file != NULL)
        fclose(file);
}

static void put_size_of_svg(FILE *out, Path path)
{
    char line[4000];
    int width, height;
    FILE *file = fopen(path.s, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        const char *box = strstr(line, "viewBox=\"0 0 ");
        if (box != NULL && sscanf(box, "viewBox=\"0 0 %d %d\"", &width, &height) == 2) {
            fprintf(out, "width=\"%d\" height=\"%d\"", width, height);
            break;
        }
    }
    if (file != NULL)
        fclose(file);
}

// The title and the variant are for those who hear only the link.
static void put_link(FILE *out, const char *href, const char *label, const char *title,
                     const char *variant)
{
    fprintf(out, "<li><a href=\"");
    put_href(out, href);
    fprintf(out, "\" download><span class=\"aloud\">");
    put_escaped(out, title);
    fprintf(out, ", %s, </span>%s</a></li>", variant, label);
}

static void put_picture(FILE *out, const Gallery *gallery, const char *name, const Words *words)
{
    bool by_reader = strcmp(gallery->answers, "solutions") != 0;
    Path file = path_of("%s.png", name);
    fprintf(out, "<figure>\n<a href=\"");
    put_href(out, file.s);
    fprintf(out, "\"><img src=\"");
    put_href(out, file.s);
    fprintf(out, "\" alt=\"");
    // A wrong answer draws another picture.
    if (by_reader) {
        fprintf(out, "Drawn by the answers in ");
        put_escaped(out, gallery->answers);
        fprintf(out, "/. What it should show: ");
    }
    put_escaped(out, words->words);
    fprintf(out, "\" ");
    put_size_of_png(out, path_of("%s/gallery/%s.png", gallery->built, name));
    fprintf(out, " loading=\"lazy\"></a>\n<figcaption><h3>");
    put_escaped(out, words->title);
    // The same words as the picture's own: a screen reader must not read them twice.
    fprintf(out, "</h3>\n<p class=\"words\" aria-hidden=\"true\">");
    put_escaped(out, words->words);
    fprintf(out, "</p>\n<dl><dt>cast</dt><dd><ul>");
    put_link(out, file.s, "PNG", words->title, "cast");
    fprintf(out, "</ul></dd></dl>\n</figcaption></figure>\n");
}

// ---- figures
// --------------------------------------------------------------------------------------

// A row of links to all formats of one shape, step and theme; nothing if there is none. Figures
// of an older script are not linked.
static void put_row(FILE *out, const Gallery *gallery, const char *name, const char *suffix,
                    const char *variant, const char *title)
{
    static const char *const endings[] = {"svg", "pdf", "png", "tex"};
    static const char *const labels[] = {"SVG", "PDF", "PNG", "TeX"};
    Path script = path_of("%s/figures/.drawn/%s.gp", gallery->built, name);
    bool begun = false;
    for (int i = 0; i < 4; i++) {
        if (!is_newer(
                path_of("%s/figures/%s/%s%s.%s", gallery->built, name, name, suffix, endings[i]),
                script))
            continue;
        if (!begun)
            fprintf(out, "<dt>%s</dt><dd><ul>", variant);
        begun = true;
        put_link(out, path_of("../figures/%s/%s%s.%s", name, name, suffix, endings[i]).s, labels[i],
                 title, variant);
        if (strcmp(endings[i], "tex") == 0)
            put_link(out, path_of("../figures/%s/%s%s-tex.pdf", name, name, suffix).s, "its PDF",
                     title, path_of("%s, TeX", variant).s);
    }
    if (begun)
        fprintf(out, "</ul></dd>");
}

static void put_rows_of_steps(FILE *out, const Gallery *gallery, const char *name,
                              const char *title)
{
    int steps = 0;
    FILE *file = fopen(path_of("%s/figures/.drawn/%s.steps", gallery->built, name).s, "r");
    if (file == NULL || fscanf(file, "%d", &steps) != 1)
        steps = 0;
    if (file != NULL)
        fclose(file);
    for (int wide = 1; wide >= 0; wide--) {
        for (int step = 1; step <= steps; step++) {
            Path suffix = path_of("%s-step%d", wide ? "" : "-4x3", step);
            Path variant = path_of("step %d%s", step, wide ? "" : ", 4:3");
            put_row(out, gallery, name, suffix.s, variant.s, title);
            put_row(out, gallery, name, path_of("%s-dark", suffix.s).s,
                    path_of("%s, dark", variant.s).s, title);
        }
    }
}

static void put_more(FILE *out, const Gallery *gallery, const char *name, const char *title)
{
    char *more = NULL;
    size_t size;
    FILE *rows = open_memstream(&more, &size);
    if (rows == NULL)
        return;
    put_row(rows, gallery, name, "-4x3", "4:3", title);
    put_row(rows, gallery, name, "-4x3-dark", "4:3, dark", title);
    put_rows_of_steps(rows, gallery, name, title);
    fclose(rows);
    if (size > 0) {
        fprintf(out, "<details><summary>More shapes and steps<span class=\"aloud\"> of ");
        put_escaped(out, title);
        fprintf(out, "</span></summary><dl>%s</dl></details>\n", more);
    }
    free(more);
}

static void put_figure(FILE *out, const Gallery *gallery, const char *name)
{
    Words words;
    Path svg = path_of("%s/figures/%s/%s.svg", gallery->built, name, name);
    if (!exists(svg) ||
        !read_words(path_of("%s/figures/%s/%s.txt", gallery->built, name, name), &words))
        return;
    fprintf(out, "<figure>\n<a href=\"../figures/%s/%s.svg\"><picture>\n", name, name);
    if (exists(path_of("%s/figures/%s/%s-dark.svg", gallery->built, name, name)))
        fprintf(out,
                "<source media=\"(prefers-color-scheme: dark)\" "
                "srcset=\"../figures/%s/%s-dark.svg\">\n",
                name, name);
    fprintf(out, "<img src=\"../figures/%s/%s.svg\" alt=\"", name, name);
    put_escaped(out, words.words);
    fprintf(out, "\" ");
    put_size_of_svg(out, svg);
    fprintf(out, " loading=\"lazy\"></picture></a>\n<figcaption><h3>");
    put_escaped(out, words.title);
    fprintf(out, "</h3>\n<dl>");
    put_row(out, gallery, name, "", "light", words.title);
    put_row(out, gallery, name, "-dark", "dark", words.title);
    fprintf(out, "\n<dt>also</dt><dd><ul>");
    put_link(out, path_of("../figures/%s/%s.txt", name, name).s, "in words", words.title, "words");
    fprintf(out, "\n");
    put_link(out, path_of("../figures/%s/%s.gp", name, name).s, "script", words.title, "gnuplot");
    fprintf(out, "</ul></dd></dl>\n");
    put_more(out, gallery, name, words.title);
    fprintf(out, "</figcaption></figure>\n");
}

// ---- animations
// -------------------------------------------------------------------------------------

// A row of links to the videos of one theme; nothing if there is none.
static void put_videos(FILE *out, const Gallery *gallery, const char *name, const char *suffix,
                       const char *variant, const char *title)
{
    static const char *const endings[] = {"mp4", "webm", "gif", "apng"};
    static const char *const labels[] = {"MP4", "WebM", "GIF", "APNG"};
    bool begun = false;
    for (int i = 0; i < 4; i++) {
        Path file = path_of("animations/%s/%s%s.%s", name, name, suffix, endings[i]);
        if (!exists(path_of("%s/%s", gallery->built, file.s)))
            continue;
        if (!begun)
            fprintf(out, "<dt>%s</dt><dd><ul>", variant);
        begun = true;
        put_link(out, path_of("../%s", file.s).s, labels[i], title, variant);
    }
    if (begun)
        fprintf(out, "</ul></dd>");
}

// Nothing moves before the reader wants it: until then the last frame is shown.
static void put_animation(FILE *out, const Gallery *gallery, const char *name)
{
    Words words;
    glob_t frames;
    if (!read_words(path_of("%s/animations/%s/%s.txt", gallery->built, name, name), &words) ||
        glob(path_of("%s/animations/%s/frames/*.png", gallery->built, name).s, 0, NULL, &frames) !=
            0)
        return;
    const char *last = strrchr(frames.gl_pathv[frames.gl_pathc - 1], '/') + 1;
    fprintf(out,
            "<figure>\n<video controls loop muted playsinline preload=\"none\" width=\"1280\" "
            "height=\"720\" poster=\"../animations/%s/frames/%s\" aria-label=\"",
            name, last);
    put_escaped(out, words.words);
    fprintf(out, "\">\n");
    if (exists(path_of("%s/animations/%s/%s.webm", gallery->built, name, name)))
        fprintf(out, "<source src=\"../animations/%s/%s.webm\" type=\"video/webm\">\n", name, name);
    if (exists(path_of("%s/animations/%s/%s.mp4", gallery->built, name, name)))
        fprintf(out, "<source src=\"../animations/%s/%s.mp4\" type=\"video/mp4\">\n", name, name);
    fprintf(out, "</video>\n<figcaption><h3>");
    put_escaped(out, words.title);
    fprintf(out, "</h3>\n<p class=\"words\" aria-hidden=\"true\">");
    put_escaped(out, words.words);
    fprintf(out, "</p>\n<dl>");
    put_videos(out, gallery, name, "", "light", words.title);
    put_videos(out, gallery, name, "-dark", "dark", words.title);
    fprintf(out, "</dl>\n</figcaption></figure>\n");
    globfree(&frames);
}

// A section of its own, if make animations has made any.
static void put_animations(FILE *contents, FILE *sections, const Gallery *gallery)
{
    static const char *const names[] = {"object-order", "image-order", "closest-hit",
                                        "discriminant", "turntable"};
    char *cards = NULL;
    size_t size;
    FILE *text = open_memstream(&cards, &size);
    if (text == NULL)
        return;
    for (int i = 0; i < 5; i++)
        put_animation(text, gallery, names[i]);
    fclose(text);
    if (size > 0) {
        fprintf(contents, "<li><a href=\"#animations\">Moving pictures</a></li>\n");
        fprintf(sections,
                "<section aria-labelledby=\"animations\">\n<h2 id=\"animations\">Moving "
                "pictures</h2>\n<div class=\"cards\">\n%s</div></section>\n",
                cards);
    }
    free(cards);
}

// ---- chapters
// -------------------------------------------------------------------------------------

typedef struct {
    int count;
    char names[200][100];
} Names;

static bool has_name(const Names *names, const char *name)
{
    for (int i = 0; i < names->count; i++)
        if (strcmp(names->names[i], name) == 0)
            return true;
    return false;
}

static void add_name(Names *names, const char *name)
{
    if (!has_name(names, name) && names->count < (int)(sizeof names->names / sizeof *names->names))
        snprintf(names->names[names->count++], sizeof *names->names, "%s", name);
}

// The names of files, without folder and ending, in the order of the alphabet.
static void add_files(Names *names, Path pattern)
{
    glob_t found;
    if (glob(pattern.s, 0, NULL, &found) != 0)
        return;
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char *name = strrchr(found.gl_pathv[i], '/') + 1, *dot = strrchr(name, '.');
        if (dot != NULL)
            *dot = '\0';
        add_name(names, name);
    }
    globfree(&found);
}

// In the order in which the chapter's program lists them; without a program, as they come.
static Names figures_of(const Gallery *gallery, const char *stem)
{
    Names layouts = {0}, names = {0};
    add_files(&layouts, path_of("chapters/%s/figures/*.gp", stem));
    Path program = path_of("%s/%s", gallery->built, stem);
    char name[100];
    FILE *list = layouts.count > 0 && exists(program)
                     ? popen(path_of("'%s' --figure list 2>/dev/null", program.s).s, "r")
                     : NULL;
    while (list != NULL && fscanf(list, "%99s", name) == 1)
        if (has_name(&layouts, name))
            add_name(&names, name);
    if (list != NULL)
        pclose(list);
    for (int i = 0; i < layouts.count; i++)
        add_name(&names, layouts.names[i]);
    return names;
}

// A scene's own words, from its first comment.
static Words words_of_scene(const Gallery *gallery, const char *name)
{
    Words words;
    snprintf(words.title, sizeof words.title, "%s", name);
    words.words[0] = '\0';
    glob_t found;
    if (glob(path_of("chapters/*/%s.nff", name).s, 0, NULL, &found) == 0) {
        read_heading(path_of("%s", found.gl_pathv[0]), words.words, sizeof words.words);
        globfree(&found);
    }
    if (words.words[0] == '\0')
        read_heading(path_of("%s/%s.nff", gallery->scenes, name), words.words, sizeof words.words);
    if (words.words[0] == '\0')
        snprintf(words.words, sizeof words.words, "A picture of the scene %s.", name);
    return words;
}

// Pictures of scenes have the names of the scenes: first the chapter's own.
static void put_scenes(FILE *out, const Gallery *gallery, const char *stem)
{
    Names names = {0};
    add_files(&names, path_of("chapters/%s/*.nff", stem));
    if (names.count == 0)
        return;
    add_files(&names, path_of("%s/gallery/*.png", gallery->built));
    for (int i = 0; i < names.count; i++) {
        const char *name = names.names[i];
        if (!exists(path_of("%s/gallery/%s.png", gallery->built, name)) ||
            exists(path_of("chapters/%s", name)))
            continue;
        Words words = words_of_scene(gallery, name);
        put_picture(out, gallery, name, &words);
    }
}

static void put_cards(FILE *out, const Gallery *gallery, const char *stem)
{
    Words words;
    if (exists(path_of("%s/gallery/%s.png", gallery->built, stem)) &&
        read_words(path_of("chapters/%s/picture.txt", stem), &words))
        put_picture(out, gallery, stem, &words);
    Names figures = figures_of(gallery, stem);
    for (int i = 0; i < figures.count; i++)
        put_figure(out, gallery, figures.names[i]);
    put_scenes(out, gallery, stem);
}

// An entry of the table of contents and its section; neither if there is nothing to show.
static void put_chapter(FILE *contents, FILE *sections, const Gallery *gallery, const char *stem)
{
    char *cards = NULL, heading[500];
    size_t size;
    FILE *text = open_memstream(&cards, &size);
    if (text == NULL)
        return;
    put_cards(text, gallery, stem);
    fclose(text);
    if (size > 0) {
        read_heading(path_of("chapters/%s/README.md", stem), heading, sizeof heading);
        fprintf(contents, "<li><a href=\"#%s\">", stem);
        put_escaped(contents, heading);
        fprintf(contents, "</a></li>\n");
        fprintf(sections, "<section aria-labelledby=\"%s\">\n<h2 id=\"%s\">", stem, stem);
        put_escaped(sections, heading);
        fprintf(sections, "</h2>\n<div class=\"cards\">\n%s</div></section>\n", cards);
    }
    free(cards);
}

// ---- the page
// -------------------------------------------------------------------------------------

static bool put_file(FILE *out, const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return false;
    for (int c; (c = getc(file)) != EOF;)
        putc(c, out);
    fclose(file);
    return true;
}

static bool has_figures(const Gallery *gallery)
{
    glob_t found;
    bool any = glob(path_of("%s/figures/*/*.svg", gallery->built).s, 0, NULL, &found) == 0;
    if (any)
        globfree(&found);
    return any;
}

static bool put_head(FILE *out, const Gallery *gallery)
{
    fputs("<!DOCTYPE html>\n"
          "<html lang=\"en\">\n"
          "<head>\n"
          "<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
          "<title>Ray casting, step by step: pictures and figures</title>\n"
          "<link rel=\"icon\" href=\"data:,\">\n"
          "<style>\n",
          out);
    bool read = put_file(out, "chapters/gallery/gallery.css");
    fputs("</style>\n"
          "</head>\n"
          "<body>\n"
          "<a class=\"skip\" href=\"#pictures\">To the pictures</a>\n"
          "<header>\n"
          "<h1>Ray casting, step by step: pictures and figures</h1>\n"
          "<p>Cast and computed by ",
          out);
    if (strcmp(gallery->answers, "solutions") == 0) {
        fputs("the solutions", out);
    } else {
        fputs("the answers in ", out);
        put_escaped(out, gallery->answers);
        putc('/', out);
    }
    fputs(". Figures come light and dark; <code>make figures</code> draws them in\n"
          "more formats, <code>STEPS=1</code> in steps for slides, <code>SHAPE=4:3</code> in "
          "another shape.</p>\n",
          out);
    fprintf(out, "%s\n", has_figures(gallery) ? "" : "<p>No figure is drawn yet.</p>");
    fputs("</header>\n<nav aria-label=\"Chapters\"><ul>\n", out);
    return read;
}

static bool put_page(FILE *out, const void *given, const char *path, Message *message)
{
    const Gallery *gallery = given;
    char *text = NULL;
    size_t size;
    glob_t chapters;
    FILE *sections = open_memstream(&text, &size);
    if (sections == NULL || !put_head(out, gallery)) {
        message_set(message, "%s: chapters/gallery/gallery.css cannot be read", path);
        if (sections != NULL)
            fclose(sections);
        free(text);
        return false;
    }
    if (glob("chapters/[0-9]*", GLOB_ONLYDIR, NULL, &chapters) == 0) {
        for (size_t i = 0; i < chapters.gl_pathc; i++)
            put_chapter(out, sections, gallery, strchr(chapters.gl_pathv[i], '/') + 1);
        globfree(&chapters);
    }
    put_animations(out, sections, gallery);
    fclose(sections);
    fprintf(out, "</ul></nav>\n<main id=\"pictures\">\n%s</main>\n</body>\n</html>\n", text);
    free(text);
    return true;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "Usage: %s BUILT SCENES-FOLDER\n", argv[0]);
        return 2;
    }
    const char *slash = strrchr(argv[1], '/');
    Gallery gallery = {argv[1], argv[2], slash != NULL ? slash + 1 : argv[1]};
    Message message;
    mkdir(path_of("%s/gallery", gallery.built).s, 0777);
    if (!file_write_whole(path_of("%s/gallery/index.html", gallery.built).s, put_page, &gallery,
                          &message)) {
        fprintf(stderr, "%s\n", message.text);
        return 1;
    }
    return 0;
}
