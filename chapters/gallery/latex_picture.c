// latex_picture.c - makes gnuplot's LaTeX picture one that any document can take in.
#include "chapters/gallery/latex_picture.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// Letters that LaTeX does not know, wherever they are.
static const struct {
    const char *letter, *mathematics;
} letters[] = {
    {"−", "-"},
    {"½", "1/2"},
    {"¼", "1/4"},
    {"⅓", "1/3"},
    {"·", "\\cdot{}"},
    {"×", "\\times{}"},
    {"±", "\\pm{}"},
    {"²", "^2"},
    {"³", "^3"},
    {"₀", "_0"},
    {"₁", "_1"},
    {"₂", "_2"},
    {"′", "^\\prime"},
    {"°", "^\\circ"},
    {"√", "\\surd{}"},
    {"…", "\\ldots{}"},
    {"∞", "\\infty{}"},
    {"≤", "\\le{}"},
    {"≥", "\\ge{}"},
    {"≠", "\\ne{}"},
    {"≈", "\\approx{}"},
    {"∈", "\\in{}"},
    {"⟂", "\\perp{}"},
    {"•", "\\bullet{}"},
    {"→", "\\to{}"},
    {"←", "\\leftarrow{}"},
    {"↑", "\\uparrow{}"},
    {"↓", "\\downarrow{}"},
    {"⇒", "\\Rightarrow{}"},
    {"Δ", "\\Delta{}"},
    {"α", "\\alpha{}"},
    {"β", "\\beta{}"},
    {"θ", "\\theta{}"},
    {"λ", "\\lambda{}"},
    {"π", "\\pi{}"},
    {"φ", "\\varphi{}"},
};

static bool begins(const char *text, size_t size, const char *with)
{
    return size >= strlen(with) && memcmp(text, with, strlen(with)) == 0;
}

static bool holds(const char *text, size_t size, const char *words)
{
    for (size_t i = 0; i < size; i++)
        if (begins(text + i, size - i, words))
            return true;
    return false;
}

// Bytes of the first letter of UTF-8.
static size_t letter_size(const char *text, size_t size)
{
    size_t bytes = size > 0;
    while (bytes < size && ((unsigned char)text[bytes] & 0xc0) == 0x80)
        bytes++;
    return bytes;
}

// A piece of text as it is, but for letters that LaTeX does not know.
static void put_known(FILE *out, const char *text, size_t size)
{
    for (size_t i = 0; i < size;) {
        size_t bytes = letter_size(text + i, size - i);
        const char *known = NULL;
        for (size_t k = 0; known == NULL && k < sizeof letters / sizeof letters[0]; k++)
            if (begins(text + i, size - i, letters[k].letter))
                known = letters[k].mathematics;
        if (known != NULL)
            fprintf(out, "\\ensuremath{%s}", known);
        else
            fwrite(text + i, 1, bytes, out);
        i += bytes;
    }
}

// {/:Italic x}, {/'DejaVu Serif':Bold x}, {/*0.8 x}: up to the space before x. 0 if there is none.
static size_t font_size(const char *text, size_t size)
{
    size_t i = 1;
    if (i < size && text[i] == '\'') {
        const char *quote = memchr(text + i + 1, '\'', size - i - 1);
        i = quote != NULL ? (size_t)(quote - text) + 1 : i;
    }
    while (i < size && text[i] != ' ')
        i++;
    return i < size ? i + 1 : 0;
}

static void put_font(FILE *out, const char *font, size_t size)
{
    const char *star = memchr(font, '*', size);
    fprintf(out, "{%s%s%s", holds(font, size, "Italic") ? "\\itshape " : "",
            holds(font, size, "Bold") ? "\\bfseries " : "",
            holds(font, size, "*0") ? "\\small "
            : star != NULL          ? "\\large "
                                    : "");
}

static void put_plain(FILE *out, const char *text, size_t size)
{
    if (strchr("%&#", text[0]) != NULL)
        fprintf(out, "\\%c", text[0]);
    else if (strchr("<>|", text[0]) != NULL)
        fprintf(out, "\\ensuremath{%c}", text[0]);
    else if (text[0] == '~')
        fputs("\\~{}", out);
    else
        put_known(out, text, size);
}

static bool is_letter(char c)
{
    return isalpha((unsigned char)c) != 0;
}

// Outside mathematics, gnuplot's own marks: x_1, x^2, {/:Italic x}, {/*0.8 small}.
static void put_marks(FILE *out, const char *text, size_t size)
{
    for (size_t i = 0; i < size;) {
        const char *rest = text + i + 1;
        size_t left = size - i - 1, used = 1;
        char c = text[i];
        if (c == '\\') {
            // \small, \%: that is LaTeX already.
            used += letter_size(rest, left);
            fwrite(text + i, 1, used, out);
        } else if (c == '_' && i >= 2 && is_letter(text[i - 1]) && is_letter(text[i - 2]) &&
                   left >= 2 && is_letter(rest[0]) && is_letter(rest[1])) {
            fputs("\\_", out); // of a name, as in upper_left
        } else if (c == '_' || c == '^') {
            const char *close = left > 0 && rest[0] == '{' ? memchr(rest, '}', left) : NULL;
            size_t part = close != NULL ? (size_t)(close - rest) + 1 : letter_size(rest, left);
            fputs(c == '_' ? "\\textsubscript{" : "\\textsuperscript{", out);
            put_known(out, rest, part);
            putc('}', out);
            used += part;
        } else if (c == '{' && left > 0 && rest[0] == '/') {
            size_t font = font_size(rest, left);
            put_font(out, rest, font);
            used += font;
        } else {
            used = letter_size(text + i, size - i);
            put_plain(out, text + i, used);
        }
        i += used;
    }
}

// Of two spaces LaTeX would leave one.
static void put_text(FILE *out, const char *text, size_t size)
{
    char *marked = NULL, *at, *spaces;
    size_t marked_size;
    FILE *copy = open_memstream(&marked, &marked_size);
    if (copy == NULL)
        return;
    put_marks(copy, text, size);
    fclose(copy);
    for (at = marked; (spaces = strstr(at, "  ")) != NULL; at = spaces + 2)
        fprintf(out, "%.*s~ ", (int)(spaces - at), at);
    fputs(at, out);
    free(marked);
}

// Factors are apart: LaTeX would set d f like the name of one thing. Spaces at its ends are spaces.
static void put_mathematics(FILE *out, const char *text, size_t size)
{
    size_t begin = 0, end = size;
    while (begin < end && text[begin] == ' ')
        begin++;
    while (end > begin && text[end - 1] == ' ')
        end--;
    putc('$', out);
    if (begin > 0)
        fputs("\\ ", out);
    for (size_t i = begin; i < end;) {
        size_t bytes = letter_size(text + i, end - i);
        bool ends_factor = i > begin && (isalnum((unsigned char)text[i - 1]) || text[i - 1] == ')');
        if (text[i] == ' ' && ends_factor && (is_letter(text[i + 1]) || text[i + 1] == '('))
            fputs("\\,", out);
        else if (text[i] == '%')
            fputs("\\%", out);
        else
            put_known(out, text + i, bytes);
        i += bytes;
    }
    if (end < size)
        fputs("\\ ", out);
    putc('$', out);
}

// Text, and mathematics between two $.
static void put_label(FILE *out, const char *label, size_t size)
{
    bool is_text = true;
    for (const char *end = label + size;; is_text = !is_text) {
        const char *dollar = memchr(label, '$', (size_t)(end - label));
        const char *stop = dollar != NULL ? dollar : end;
        if (is_text)
            put_text(out, label, (size_t)(stop - label));
        else
            put_mathematics(out, label, (size_t)(stop - label));
        if (dollar == NULL)
            return;
        label = dollar + 1;
    }
}

static const char *last_of(const char *line, const char *words)
{
    const char *last = NULL;
    while ((line = strstr(line, words)) != NULL)
        last = line++;
    return last;
}

static bool put_line(FILE *out, const char *line, const char *graphics)
{
    const char *put = strstr(line, "\\put("), *box, *name;
    const char *strut = put != NULL ? last_of(put, "\\strut{}") : NULL;
    double width, height;
    if (strncmp(line, "% GNUPLOT", strlen("% GNUPLOT")) == 0) {
        fputs("% Drawn by gnuplot. Needs the packages graphicx and color; if it is not in the "
              "folder of "
              "the document,\n% \\graphicspath must also name its folder.\n",
              out);
    } else if (strstr(line, "colorbox{gpBackground}") != NULL &&
               (box = strstr(line, "makebox(")) != NULL &&
               sscanf(box, "makebox(%lf,%lf)", &width, &height) == 2) {
        fprintf(
            out,
            "    \\put(0,0){\\color{gpBackground}\\rule{%.2f\\unitlength}{%.2f\\unitlength}}%%\n",
            width, height);
    } else if (strstr(line, "\\includegraphics[") != NULL && (name = last_of(line, "{")) != NULL &&
               strcmp(name + strcspn(name, "}"), "}}%") == 0) {
        fprintf(out, "%.*s{%s}}%%\n", (int)(name - line), line, graphics);
    } else if (strut != NULL) {
        const char *label = strut + strlen("\\strut{}");
        const char *rotated = strstr(line, "rotatebox");
        const char *after = rotated != NULL && rotated < strut ? "}}}%" : "}}%";
        size_t size = strlen(label);
        size = size > strlen(after) ? size - strlen(after) : 0;
        fwrite(line, 1, (size_t)(label - line), out);
        put_label(out, label, size);
        fprintf(out, "%s\n", after);
    } else if (put == line + strspn(line, " ") && strstr(put, "\\makebox(0,0)") != NULL) {
        // gnuplot takes a label that begins with a brace or a bracket for one that says where it
        // is.
        fprintf(stderr, "a label of LaTeX begins with { or [, and would be misplaced: %s\n", line);
        return false;
    } else {
        fprintf(out, "%s\n", line);
    }
    return true;
}

bool write_latex_picture(FILE *out, const char *drawn, const char *words, const char *graphics)
{
    char *text = strdup(words), *rest = text;
    for (char *line; rest != NULL && (line = strsep(&rest, "\n")) != NULL;)
        if (rest != NULL)
            fprintf(out, "%%%s%s\n", line[0] == '\0' ? "" : " ", line);
    free(text);
    text = strdup(drawn);
    rest = text;
    bool good = text != NULL;
    for (char *line; good && rest != NULL && (line = strsep(&rest, "\n")) != NULL;)
        if (rest != NULL || line[0] != '\0')
            good = put_line(out, line, graphics);
    free(text);
    return good;
}
