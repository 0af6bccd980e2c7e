// fill.c - fills the numbers of the example into the source of a lesson (fill.h).
#include "chapters/lessons/fill.h"

#include "common/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NAMES = 100 };

typedef struct {
    const char *name;
    char text[400];
    bool used;
} Value;

static Value values[MOST_NAMES];
static int value_count, errors;

// ---- the values -------------------------------------------------------------------------------

void fill_text(const char *name, const char *format, ...)
{
    if (value_count == MOST_NAMES) {
        fprintf(stderr, "%s: there is room for %d names only\n", name, MOST_NAMES);
        exit(2);
    }
    Value *value = &values[value_count++];
    value->name = name;
    va_list list;
    va_start(list, format);
    vsnprintf(value->text, sizeof value->text, format, list);
    va_end(list);
}

void fill_number(const char *name, double x)
{
    fill_text(name, "%s", number_text(x).s);
}

void fill_number_to(const char *name, double x, int digits)
{
    fill_text(name, "%s", number_text_to(x, digits).s);
}

void fill_vector(const char *name, vec3 v)
{
    fill_text(name, "%s", vec3_text(v).s);
}

void fill_term(const char *name, double x, int digits)
{
    fill_text(name, "%c %s", x < 0 ? '-' : '+', number_text_to(fabs(x), digits).s);
}

void fill_result(const char *name, double x, int digits)
{
    Text text = number_text_to(x, digits);
    bool exact = fabs(strtod(text.s, NULL) - x) <= 1e-14 * fabs(x);
    fill_text(name, "%s %s", exact ? "=" : "\\approx", text.s);
}

void fill_option(const char *name, vec3 v)
{
    fill_text(name, "%s,%s,%s", number_text(v[0]).s, number_text(v[1]).s, number_text(v[2]).s);
}

void fill_camera(Camera c)
{
    fill_number("d", c.distance);
    fill_number("w", c.width);
    fill_number("h", c.height);
    fill_vector("eye", c.origin);
    fill_vector("right", c.right);
    fill_vector("up", c.up);
    fill_vector("forward", c.forward);
}

static const Value *value_of(const char *name, size_t length)
{
    for (int i = 0; i < value_count; i++)
        if (strlen(values[i].name) == length && strncmp(values[i].name, name, length) == 0) {
            values[i].used = true;
            return &values[i];
        }
    return NULL;
}

// ---- the lesson -------------------------------------------------------------------------------

static char *text_of(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL, part[4096];
    size_t size;
    FILE *copy = open_memstream(&text, &size);
    if (file == NULL || copy == NULL) {
        perror(path);
        exit(2);
    }
    for (size_t n; (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    fclose(file);
    fclose(copy);
    return text;
}

static const char *end_of_line(const char *at)
{
    return at + strcspn(at, "\n");
}

// The first line that begins with such a text; NULL if there is none.
static const char *line_beginning(const char *text, const char *with)
{
    for (; *text != '\0'; text = end_of_line(text) + (*end_of_line(text) != '\0'))
        if (strncmp(text, with, strlen(with)) == 0)
            return text;
    return NULL;
}

// Prints the lines from a heading to the next empty line.
static bool print_section(const char *output, const char *heading)
{
    const char *at = line_beginning(output, heading);
    if (at == NULL)
        return false;
    const char *end = strstr(at, "\n\n");
    size_t length = end == NULL ? strlen(at) : (size_t)(end - at);
    while (length > 0 && at[length - 1] == '\n')
        length--;
    printf("%.*s\n", (int)length, at);
    return true;
}

static void print_figure(const char *lesson, const char *name)
{
    char shown[200];
    snprintf(shown, sizeof shown, "src=\"figures/%s.svg\"", name);
    const char *at = strstr(lesson, shown);
    if (at == NULL) {
        printf("<picture><img %s></picture>\n", shown);
        return;
    }
    while (at > lesson && at[-1] != '\n')
        at--;
    printf("%.*s\n", (int)(end_of_line(at) - at), at);
}

// The rest of [[WORD REST]], if the line is nothing else; NULL if it is.
static const char *rest_of(const char *line, const char *word, char rest[200])
{
    size_t length = strlen(line), skip = strlen(word) + 3;
    if (length < skip + 2 || strncmp(line, "[[", 2) != 0 ||
        strncmp(line + 2, word, skip - 3) != 0 || line[skip - 1] != ' ' ||
        strcmp(line + length - 2, "]]") != 0)
        return NULL;
    snprintf(rest, 200, "%.*s", (int)(length - skip - 2), line + skip);
    return rest;
}

static void print_filled(const char *line, const char *source, int number)
{
    for (const char *open; (open = strstr(line, "[[")) != NULL;) {
        const char *name = open + 2, *close = strstr(name, "]]");
        size_t length = close == NULL ? strlen(name) : (size_t)(close - name);
        const Value *value = value_of(name, length);
        if (value == NULL) {
            fprintf(stderr, "%s:%d: no number has the name '%.*s'\n", source, number, (int)length,
                    name);
            errors++;
        }
        printf("%.*s%s", (int)(open - line), line, value == NULL ? "" : value->text);
        line = close == NULL ? name + length : close + 2;
    }
    printf("%s\n", line);
}

int fill_lesson(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "Usage: %s SOURCE.md OUTPUT.txt README.md\n", argv[0]);
        return 2;
    }
    char *source = text_of(argv[1]), *output = text_of(argv[2]), *lesson = text_of(argv[3]);
    char *after = source, rest[200];
    int number = 0;
    for (char *line; (line = strsep(&after, "\n")) != NULL && (after != NULL || *line != '\0');) {
        number++;
        if (rest_of(line, "figure", rest) != NULL)
            print_figure(lesson, rest);
        else if (rest_of(line, "output", rest) == NULL)
            print_filled(line, argv[1], number);
        else if (!print_section(output, rest)) {
            fprintf(stderr, "%s:%d: the program prints no line that begins with '%s'\n", argv[1],
                    number, rest);
            errors++;
        }
    }
    for (int i = 0; i < value_count; i++)
        if (!values[i].used) {
            fprintf(stderr, "%s: does not use the number '%s'\n", argv[1], values[i].name);
            errors++;
        }
    free(source);
    free(output);
    free(lesson);
    return errors > 0;
}
