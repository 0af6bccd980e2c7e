// svg_picture.c - makes gnuplot's SVG one that can be read aloud, and that shows the same
// everywhere.
#include "chapters/gallery/svg_picture.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

// Spaces that stand for nothing go: what a sentence is left out of has one too many.
void tidy_words(char *text)
{
    char *to = text;
    for (const char *from = text; *from != '\0'; from++) {
        if (*from == ' ' && to > text && to[-1] == ' ')
            continue;
        if (*from == '\n' && to > text && to[-1] == ' ')
            to--;
        *to++ = *from;
    }
    *to = '\0';
}

const char *split_words(char *text)
{
    char *description = text + strcspn(text, "\n");
    if (*description != '\0')
        *description++ = '\0';
    description += strspn(description, "\n");
    for (char *c = description; *c != '\0'; c++)
        if (*c == '\n')
            *c = c[1] == '\0' ? '\0' : ' ';
    return description;
}

static void put_escaped(FILE *out, const char *text)
{
    for (; *text != '\0'; text++)
        if (*text == '&' || *text == '<' || *text == '>')
            fputs(*text == '&' ? "&amp;" : *text == '<' ? "&lt;" : "&gt;", out);
        else
            putc(*text, out);
}

static void put_replaced(FILE *out, const char *line, const char *what, const char *by)
{
    for (const char *at; (at = strstr(line, what)) != NULL; line = at + strlen(what))
        fprintf(out, "%.*s%s", (int)(at - line), line, by);
    fputs(line, out);
}

// Fonts get a family to fall back on.
static void put_svg_line(FILE *out, const char *line)
{
    char *text = NULL;
    size_t size;
    FILE *sans = open_memstream(&text, &size);
    if (sans == NULL)
        abort();
    put_replaced(sans, line, "font-family=\"DejaVu Sans\"",
                 "font-family=\"DejaVu Sans, Verdana, sans-serif\"");
    fclose(sans);
    put_replaced(out, text, "font-family=\"DejaVu Serif\"",
                 "font-family=\"DejaVu Serif, Georgia, serif\"");
    free(text);
    putc('\n', out);
}

// ---- pictures inside a figure -------------------------------------------------------------------

#define PICTURE "<title>picture "

// The pictures of a script, and the one whose frame comes next.
typedef struct {
    const char *script;
    const char *rows; // its rows in the script; NULL: no frame comes
} Pictures;

// The line of a frame's title without the picture's name: "<title>picture $flat: flat</title>".
static bool put_frame_title(FILE *out, const char *line, Pictures *pictures)
{
    const char *at = pictures->script != NULL ? strstr(line, PICTURE) : NULL;
    const char *colon = at != NULL ? strchr(at, ':') : NULL;
    if (colon == NULL)
        return false;
    fprintf(out, "%.*s<title>", (int)(at - line), line);
    put_svg_line(out, colon + strspn(colon, ": "));
    at += strlen(PICTURE);
    char block[100];
    snprintf(block, sizeof block, "\n%.*s << EOD\n", (int)(colon - at), at);
    const char *found = strstr(pictures->script, block);
    pictures->rows = found != NULL ? found + strlen(block) : NULL;
    return true;
}

// From "d='M12.48,456.30 L473.28,456.30 ...": the rectangle around a frame.
static bool read_frame(const char *line, double low[2], double high[2])
{
    const char *d = strstr(line, "d='M");
    low[0] = low[1] = INFINITY;
    high[0] = high[1] = -INFINITY;
    for (const char *c = d != NULL ? d + 4 : ""; *c != '\0' && *c != '\'';) {
        double at[2];
        int used = 0;
        if (sscanf(c, "%lf,%lf%n", &at[0], &at[1], &used) == 2 && used > 0) {
            for (int i = 0; i < 2; i++) {
                low[i] = fmin(low[i], at[i]);
                high[i] = fmax(high[i], at[i]);
            }
            c += used;
        } else {
            c++;
        }
    }
    return low[0] < high[0] && low[1] < high[1];
}

// The picture itself instead of its frame: the same PNG that the script has, in base64.
static bool put_picture(FILE *out, const char *line, Pictures *pictures)
{
    double low[2], high[2];
    if (pictures->rows == NULL || !read_frame(line, low, high))
        return false;
    fprintf(out,
            "<image x='%.2f' y='%.2f' width='%.2f' height='%.2f' preserveAspectRatio='none' "
            "xlink:href='data:image/png;base64,",
            low[0], low[1], high[0] - low[0], high[1] - low[1]);
    for (const char *c = pictures->rows; strncmp(c, "EOD", 3) != 0 && *c != '\0';) {
        size_t length = strcspn(c, "\n");
        if (*c != '#')
            fwrite(c, 1, length, out);
        c += length + (c[length] == '\n');
    }
    fputs("'/>\n", out);
    pictures->rows = NULL;
    return true;
}

// ---- all of it ----------------------------------------------------------------------------------

void write_svg_picture(FILE *out, char *svg, const char *title, const char *description,
                       const char *script)
{
    bool titled = false, described = false;
    Pictures pictures = {.script = script};
    for (char *line; (line = strsep(&svg, "\n")) != NULL && !(svg == NULL && *line == '\0');) {
        const char *point = strstr(line, "id="), *width = strstr(line, "stroke-width=");
        if (strncmp(line, "<svg", 4) == 0) {
            fprintf(out, "<svg role=\"img\" aria-labelledby=\"title description\" "
                         "xml:space=\"preserve\"");
            put_svg_line(out, line + 4);
        } else if (!titled && strstr(line, "<title>") != NULL) {
            titled = true;
            fprintf(out, "<title id=\"title\">");
            put_escaped(out, title);
            fprintf(out, "</title>\n");
        } else if (!described && strstr(line, "<desc>") != NULL) {
            described = true;
            fprintf(out, "<desc id=\"description\">");
            put_escaped(out, description);
            fprintf(out, "</desc>\n");
        } else if (point != NULL && strncmp(point + 4, "gpPt", 4) == 0 && width != NULL) {
            // Rings and crosses are hairlines in the SVG of gnuplot 5.4, whatever their width.
            const char *number = width + strlen("stroke-width='");
            fprintf(out, "%.*sstroke-width='0.6", (int)(width - line), line);
            put_svg_line(out, number + strspn(number, "0123456789."));
        } else if (!put_frame_title(out, line, &pictures) && !put_picture(out, line, &pictures)) {
            put_svg_line(out, line);
        }
    }
}
