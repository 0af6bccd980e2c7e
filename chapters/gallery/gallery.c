// gallery.c - makes BUILT/gallery/index.html: every picture, figure and animation that is there.
//
//   gallery BUILT SCENES-FOLDER
//
// A page that needs no network and no script, in the order of the lecture:
// chapters/gallery/contents.txt. What is there and not in that list comes after it. Each picture is
// also described in words: a figure by BUILT/figures/NAME/NAME.txt, an animation by
// BUILT/animations/NAME/NAME.txt, a picture in the list or by chapters/NN-stem/picture.txt, and the
// picture of another scene by the scene's first comment.
#include "common/whole_file.h"

#include <glob.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define CONTENTS "chapters/gallery/contents.txt"

enum { MOST_SECTIONS = 60 };

// What is on the page already: "figure NAME", "picture NAME".
typedef struct {
    int count;
    char names[1000][120];
} Names;

// The cards of one section, in HTML.
typedef struct {
    char heading[500];
    FILE *out;
    char *cards;
    size_t size;
} Section;

typedef struct {
    const char *built, *scenes, *answers; // answers: the folder's name
    Names shown;
    Section sections[MOST_SECTIONS];
    int section_count;
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

// ---- names --------------------------------------------------------------------------------------

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
        snprintf(names->names[names->count++], sizeof *names->names, "%.119s", name);
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

// Whether it is not on the page yet; from now on it is.
static bool show_once(Gallery *gallery, const char *kind, const char *name)
{
    Path what = path_of("%s %s", kind, name);
    if (has_name(&gallery->shown, what.s))
        return false;
    add_name(&gallery->shown, what.s);
    return true;
}

// ---- text ---------------------------------------------------------------------------------------

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

// ---- pictures -----------------------------------------------------------------------------------

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

// A picture by its file's path from the page. A chart has text, which a narrow screen must not
// shrink.
static void put_picture(FILE *out, const Gallery *gallery, const char *file, bool is_copy,
                        const Words *words)
{
    bool by_reader = !is_copy && strcmp(gallery->answers, "solutions") != 0;
    bool chart = strstr(file, ".svg") != NULL;
    Path path = path_of("%s/gallery/%s", gallery->built, file);
    fprintf(out, "<figure%s>\n<a href=\"", chart ? " class=\"chart\"" : "");
    put_href(out, file);
    fprintf(out, "\"><img src=\"");
    put_href(out, file);
    fprintf(out, "\" alt=\"");
    // A wrong answer draws another picture.
    if (by_reader) {
        fprintf(out, "Drawn by the answers in ");
        put_escaped(out, gallery->answers);
        fprintf(out, "/. What it should show: ");
    }
    put_escaped(out, words->words);
    fprintf(out, "\" ");
    if (chart)
        put_size_of_svg(out, path);
    else
        put_size_of_png(out, path);
    fprintf(out, " loading=\"lazy\"></a>\n<figcaption><h3>");
    put_escaped(out, words->title);
    // The same words as the picture's own: a screen reader must not read them twice.
    fprintf(out, "</h3>\n<p class=\"words\" aria-hidden=\"true\">");
    put_escaped(out, words->words);
    fprintf(out, "</p>\n<dl><dt>%s</dt><dd><ul>", chart ? "measured" : "cast");
    put_link(out, file, chart ? "SVG" : "PNG", words->title, chart ? "measured" : "cast");
    fprintf(out, "</ul></dd></dl>\n</figcaption></figure>\n");
}

// ---- figures ------------------------------------------------------------------------------------

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

#define NARROW "(max-width: 600px)"
#define DARK "(prefers-color-scheme: dark)"

// On a narrow screen the text of the shape 4:3 is a third larger.
static void put_source(FILE *out, const Gallery *gallery, const char *name, const char *variant,
                       const char *media)
{
    Path file = path_of("%s/figures/%s/%s%s.svg", gallery->built, name, name, variant);
    if (!exists(file))
        return;
    fprintf(out, "<source media=\"%s\" srcset=\"../figures/%s/%s%s.svg\" ", media, name, name,
            variant);
    put_size_of_svg(out, file);
    fprintf(out, ">\n");
}

static void put_figure(FILE *out, const Gallery *gallery, const char *name)
{
    Words words;
    Path svg = path_of("%s/figures/%s/%s.svg", gallery->built, name, name);
    if (!exists(svg) ||
        !read_words(path_of("%s/figures/%s/%s.txt", gallery->built, name, name), &words))
        return;
    fprintf(out, "<figure>\n<a href=\"../figures/%s/%s.svg\"><picture>\n", name, name);
    put_source(out, gallery, name, "-4x3-dark", NARROW " and " DARK);
    put_source(out, gallery, name, "-4x3", NARROW);
    put_source(out, gallery, name, "-dark", DARK);
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

// ---- animations ---------------------------------------------------------------------------------

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

// A video in one theme; nothing if there is none. Nothing moves before the reader wants it: until
// then the last frame is shown.
static void put_video(FILE *out, const Gallery *gallery, const char *name, const char *suffix,
                      const char *class, const Words *words)
{
    static const char *const endings[] = {"webm", "mp4"};
    glob_t frames;
    if (glob(path_of("%s/animations/%s/frames%s/*.png", gallery->built, name, suffix).s, 0, NULL,
             &frames) != 0)
        return;
    fprintf(out,
            "<video%s controls loop muted playsinline preload=\"none\" width=\"1280\" "
            "height=\"720\" poster=\"../animations/%s/frames%s/%s\" aria-label=\"",
            class, name, suffix, strrchr(frames.gl_pathv[frames.gl_pathc - 1], '/') + 1);
    globfree(&frames);
    put_escaped(out, words->words);
    fprintf(out, "\">\n");
    for (int i = 0; i < 2; i++) {
        Path file = path_of("animations/%s/%s%s.%s", name, name, suffix, endings[i]);
        if (exists(path_of("%s/%s", gallery->built, file.s)))
            fprintf(out, "<source src=\"../%s\" type=\"video/%s\">\n", file.s, endings[i]);
    }
    fprintf(out, "</video>\n");
}

static void put_animation(FILE *out, const Gallery *gallery, const char *name)
{
    Words words;
    Path folder = path_of("%s/animations/%s", gallery->built, name);
    bool light = exists(path_of("%s/frames", folder.s));
    bool dark = exists(path_of("%s/frames-dark", folder.s));
    if ((!light && !dark) || !read_words(path_of("%s/%s.txt", folder.s, name), &words))
        return;
    fprintf(out, "<figure>\n");
    put_video(out, gallery, name, "", dark ? " class=\"in-light\"" : "", &words);
    put_video(out, gallery, name, "-dark", light ? " class=\"in-dark\"" : "", &words);
    fprintf(out, "<figcaption><h3>");
    put_escaped(out, words.title);
    fprintf(out, "</h3>\n<p class=\"words\" aria-hidden=\"true\">");
    put_escaped(out, words.words);
    fprintf(out, "</p>\n<dl>");
    put_videos(out, gallery, name, "", "light", words.title);
    put_videos(out, gallery, name, "-dark", "dark", words.title);
    fprintf(out, "</dl>\n</figcaption></figure>\n");
}

// ---- the list -----------------------------------------------------------------------------------

// The section of that heading, which is new, or the last one if there are too many.
static Section *begin_section(Gallery *gallery, const char *heading)
{
    if (gallery->section_count < MOST_SECTIONS) {
        Section *section = &gallery->sections[gallery->section_count];
        *section = (Section){.out = NULL};
        section->out = open_memstream(&section->cards, &section->size);
        if (section->out == NULL) {
            perror("memory");
            exit(1);
        }
        snprintf(section->heading, sizeof section->heading, "%s", heading);
        gallery->section_count++;
    }
    return &gallery->sections[gallery->section_count - 1];
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
        snprintf(words.words, sizeof words.words, "The picture %s.png, drawn from a scene.", name);
    return words;
}

// A picture of the gallery by its name; words: those of the list, if it has any.
static void show_picture(Gallery *gallery, FILE *out, const char *name, const Words *words)
{
    if (!show_once(gallery, "picture", name) ||
        !exists(path_of("%s/gallery/%s.png", gallery->built, name)))
        return;
    Words own;
    if (words == NULL || words->title[0] == '\0') {
        if (!read_words(path_of("chapters/%s/picture.txt", name), &own))
            own = words_of_scene(gallery, name);
        words = &own;
    }
    put_picture(out, gallery, path_of("%s.png", name).s, false, words);
}

static bool copy_file(FILE *file, const void *given, const char *path, Message *message)
{
    FILE *from = fopen(given, "rb");
    if (from == NULL)
        return message_set(message, "%s: %s cannot be read", path, (const char *)given);
    for (int c; (c = getc(from)) != EOF;)
        putc(c, file);
    fclose(from);
    return true;
}

// A file of the tree, which the page must have beside it.
static void show_copy(Gallery *gallery, FILE *out, const char *path, const Words *words)
{
    const char *slash = strrchr(path, '/');
    Path file = path_of("copies/%s", slash != NULL ? slash + 1 : path);
    Path copy = path_of("%s/gallery/%s", gallery->built, file.s);
    Message message;
    mkdir(path_of("%s/gallery/copies", gallery->built).s, 0777);
    if (!exists(path_of("%s", path)))
        return;
    if (!exists(copy) || is_newer(path_of("%s", path), copy))
        if (!file_write_whole(copy.s, copy_file, path, &message)) {
            fprintf(stderr, "%s\n", message.text);
            return;
        }
    put_picture(out, gallery, file.s, true, words);
}

static void show_figure(Gallery *gallery, FILE *out, const char *name)
{
    if (show_once(gallery, "figure", name))
        put_figure(out, gallery, name);
}

static void show_animation(Gallery *gallery, FILE *out, const char *name)
{
    if (show_once(gallery, "animation", name))
        put_animation(out, gallery, name);
}

// An entry of the list: "figure NAME", "animation NAME", "picture NAME" or "copy FILE".
static void show_entry(Gallery *gallery, const Words *entry, const Words *words)
{
    if (gallery->section_count == 0)
        return;
    FILE *out = gallery->sections[gallery->section_count - 1].out;
    const char *name = entry->words;
    if (strcmp(entry->title, "figure") == 0)
        show_figure(gallery, out, name);
    if (strcmp(entry->title, "animation") == 0)
        show_animation(gallery, out, name);
    if (strcmp(entry->title, "picture") == 0)
        show_picture(gallery, out, name, words);
    if (strcmp(entry->title, "copy") == 0)
        show_copy(gallery, out, name, words);
}

// Adds an indented line: the first one is the title.
static void add_words(Words *words, const char *line)
{
    size_t used = strlen(words->words);
    if (words->title[0] == '\0')
        snprintf(words->title, sizeof words->title, "%s", line);
    else
        snprintf(words->words + used, sizeof words->words - used, "%s%s", used > 0 ? " " : "",
                 line);
}

// An entry's indented lines follow it, so it is shown when they have ended.
static bool show_list(Gallery *gallery, const char *path)
{
    FILE *file = fopen(path, "r");
    char line[1000];
    Words entry = {"", ""}, words = {"", ""};
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        line[strcspn(line, "\n")] = '\0';
        const char *text = line + strspn(line, " ");
        if (text > line) {
            add_words(&words, text);
            continue;
        }
        show_entry(gallery, &entry, &words);
        size_t first = strcspn(line, " ");
        entry = words = (Words){"", ""};
        snprintf(entry.title, sizeof entry.title, "%.*s", (int)first, line);
        snprintf(entry.words, sizeof entry.words, "%s", line + first + strspn(line + first, " "));
        if (strcmp(entry.title, "section") == 0)
            begin_section(gallery, entry.words);
    }
    show_entry(gallery, &entry, &words);
    if (file != NULL)
        fclose(file);
    return file != NULL;
}

// ---- what the list does not have ----------------------------------------------------------------

// The picture and the figures of a chapter.
static void show_chapter(Gallery *gallery, const char *stem)
{
    char heading[500];
    Names layouts = {0};
    read_heading(path_of("chapters/%s/README.md", stem), heading, sizeof heading);
    FILE *out = begin_section(gallery, heading)->out;
    if (exists(path_of("chapters/%s/picture.txt", stem)))
        show_picture(gallery, out, stem, NULL);
    add_files(&layouts, path_of("chapters/%s/figures/*.gp", stem));
    for (int i = 0; i < layouts.count; i++)
        show_figure(gallery, out, layouts.names[i]);
}

static void show_all(Gallery *gallery, const char *heading, const char *files,
                     void (*show)(Gallery *gallery, FILE *out, const char *name))
{
    static Names names;
    names.count = 0;
    add_files(&names, path_of("%s/%s", gallery->built, files));
    FILE *out = begin_section(gallery, heading)->out;
    for (int i = 0; i < names.count; i++)
        show(gallery, out, names.names[i]);
}

static void show_scene(Gallery *gallery, FILE *out, const char *name)
{
    show_picture(gallery, out, name, NULL);
}

static void show_rest(Gallery *gallery)
{
    glob_t chapters;
    if (glob("chapters/[0-9]*", GLOB_ONLYDIR, NULL, &chapters) == 0) {
        for (size_t i = 0; i < chapters.gl_pathc; i++)
            show_chapter(gallery, strchr(chapters.gl_pathv[i], '/') + 1);
        globfree(&chapters);
    }
    show_all(gallery, "Your own figures", "figures/*/*.txt", show_figure);
    show_all(gallery, "More animations", "animations/*/*.txt", show_animation);
    show_all(gallery, "More pictures", "gallery/*.png", show_scene);
}

// ---- the page -----------------------------------------------------------------------------------

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
    fputs(", in the order of the lecture. Figures come light and dark; <code>make\nfigures</code> "
          "draws them in more formats, <code>STEPS=1</code> in steps for slides,\n"
          "<code>SHAPE=4:3</code> in another shape.",
          out);
    if (exists(path_of(".make/toolkit/animations.mk"))) // not in a handout
        fputs(" <code>make animations</code> adds videos.", out);
    fputs("</p>\n", out);
    fprintf(out, "%s\n", has_figures(gallery) ? "" : "<p>No figure is drawn yet.</p>");
    fputs("</header>\n<nav aria-label=\"The lecture\"><ul>\n", out);
    return read;
}

// Sections without a card are left out.
static bool put_page(FILE *out, const void *given, const char *path, Message *message)
{
    const Gallery *gallery = given;
    if (!put_head(out, gallery))
        return message_set(message, "%s: chapters/gallery/gallery.css cannot be read", path);
    for (int i = 0; i < gallery->section_count; i++)
        if (gallery->sections[i].size > 0) {
            fprintf(out, "<li><a href=\"#section-%d\">", i + 1);
            put_escaped(out, gallery->sections[i].heading);
            fprintf(out, "</a></li>\n");
        }
    fprintf(out, "</ul></nav>\n<main id=\"pictures\">\n");
    for (int i = 0; i < gallery->section_count; i++)
        if (gallery->sections[i].size > 0) {
            fprintf(out, "<section aria-labelledby=\"section-%d\">\n<h2 id=\"section-%d\">", i + 1,
                    i + 1);
            put_escaped(out, gallery->sections[i].heading);
            fprintf(out, "</h2>\n<div class=\"cards\">\n%s</div></section>\n",
                    gallery->sections[i].cards);
        }
    fprintf(out, "</main>\n</body>\n</html>\n");
    return true;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "Usage: %s BUILT SCENES-FOLDER\n", argv[0]);
        return 2;
    }
    const char *slash = strrchr(argv[1], '/');
    static Gallery gallery;
    gallery.built = argv[1];
    gallery.scenes = argv[2];
    gallery.answers = slash != NULL ? slash + 1 : argv[1];
    Message message;
    mkdir(path_of("%s/gallery", gallery.built).s, 0777);
    if (!show_list(&gallery, CONTENTS)) {
        perror(CONTENTS);
        return 1;
    }
    show_rest(&gallery);
    for (int i = 0; i < gallery.section_count; i++)
        fclose(gallery.sections[i].out);
    if (!file_write_whole(path_of("%s/gallery/index.html", gallery.built).s, put_page, &gallery,
                          &message)) {
        fprintf(stderr, "%s\n", message.text);
        return 1;
    }
    return 0;
}
