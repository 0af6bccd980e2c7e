// fill.c - fills the numbers of the example into the source of a lesson (fill.h).
//
// Usage: NN-stem SOURCE.md OUTPUT.txt README.md [marked]
// OUTPUT: of the chapter's program. README: the lesson as it is. With 'marked', each number is
// between private characters, so that a page finds it (chapters/book/site/numbers.mjs):
// U+E000 NAME U+E001 NUMBER U+E002.
#include "chapters/lessons/fill.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_marked;
static int errors;

static const char *value_of(const char *name, size_t length)
{
    int count;
    FilledNumber *numbers = filled_numbers(&count);
    for (int i = 0; i < count; i++)
        if (strlen(numbers[i].name) == length && strncmp(numbers[i].name, name, length) == 0) {
            numbers[i].is_used = true;
            return numbers[i].text;
        }
    return NULL;
}

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
    snprintf(shown, sizeof shown, "](%s.svg)", name);
    const char *at = strstr(lesson, shown);
    if (at == NULL) {
        printf("![%s\n", shown);
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

static void print_number(int length, const char *name, const char *text)
{
    if (is_marked)
        printf("\uE000%.*s\uE001%s\uE002", length, name, text);
    else
        fputs(text, stdout);
}

static void print_filled(const char *line, const char *source, int number)
{
    for (const char *open; (open = strstr(line, "[[")) != NULL;) {
        const char *name = open + 2, *close = strstr(name, "]]");
        size_t length = close == NULL ? strlen(name) : (size_t)(close - name);
        const char *value = value_of(name, length);
        if (value == NULL) {
            fprintf(stderr, "%s:%d: no number has the name '%.*s'\n", source, number, (int)length,
                    name);
            errors++;
        }
        printf("%.*s", (int)(open - line), line);
        if (value != NULL)
            print_number((int)length, name, value);
        line = close == NULL ? name + length : close + 2;
    }
    printf("%s\n", line);
}

static void check_used(const char *source)
{
    int count;
    const FilledNumber *numbers = filled_numbers(&count);
    for (int i = 0; i < count; i++)
        if (!numbers[i].is_used) {
            fprintf(stderr, "%s: does not use the number '%s'\n", source, numbers[i].name);
            errors++;
        }
}

int main(int argc, char **argv)
{
    is_marked = argc == 5 && strcmp(argv[4], "marked") == 0;
    if (argc != 4 && !is_marked) {
        fprintf(stderr, "Usage: %s SOURCE.md OUTPUT.txt README.md [marked]\n", argv[0]);
        return 2;
    }
    fill_numbers();
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
    check_used(argv[1]);
    free(source);
    free(output);
    free(lesson);
    return errors > 0;
}
