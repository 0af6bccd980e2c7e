// own_words.c - words of a lecturer's own in figures, or another language: FIGURE_WORDS=FILE, a
// copy of chapters/words.txt. A program that is not given such a file says its own words.
#include "common/figure/plot_internal.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1000 };

// What is said, and what is said instead.
static struct {
    char *english, *own;
} texts[MOST];
static int count;

// A text begins its line. Where the next line begins with a blank, that is said instead.
static void read_texts(FILE *file)
{
    char *line = NULL, *english = NULL;
    size_t size = 0;
    for (ssize_t length; (length = getline(&line, &size, file)) > 0;) {
        while (length > 0 && strchr(" \r\n", line[length - 1]) != NULL)
            line[--length] = '\0';
        char *own = line + strspn(line, " \t");
        if (own > line && *own != '\0' && english != NULL && count < MOST) {
            texts[count].english = english;
            texts[count++].own = strdup(own);
            english = NULL;
        } else if (own == line) {
            free(english);
            english = *line == '#' || *line == '\0' ? NULL : strdup(line);
        }
    }
    free(english);
    free(line);
}

static void read_once(void)
{
    static bool is_read;
    const char *path = getenv("FIGURE_WORDS");
    if (is_read || path == NULL)
        return;
    is_read = true;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
        exit(EXIT_WRONG_USAGE);
    }
    read_texts(file);
    fclose(file);
}

static bool is_place(const char *text)
{
    return text[0] == '%' && (text[1] == 's' || text[1] == 'd');
}

// A part of a text.
typedef struct {
    const char *begin;
    size_t length;
} Part;

enum { MOST_PARTS = 10 };

// Is it this text, if each %s and %d of the English one stands for anything? For these parts, then.
static bool is_text(const char *english, Part text, Part *parts, int room)
{
    while (!is_place(english)) {
        if (*english == '\0' || text.length == 0)
            return *english == '\0' && text.length == 0;
        if (*english++ != *text.begin)
            return false;
        text = (Part){text.begin + 1, text.length - 1};
    }
    for (size_t n = 0; room > 0 && n <= text.length; n++)
        if (is_text(english + 2, (Part){text.begin + n, text.length - n}, parts + 1, room - 1)) {
            *parts = (Part){text.begin, n};
            return true;
        }
    return false;
}

static void print_part(FILE *out, Part text)
{
    Part parts[MOST_PARTS] = {{"", 0}};
    int i = 0, part = 0;
    while (i < count && !is_text(texts[i].english, text, parts, MOST_PARTS))
        i++;
    if (i == count) {
        fwrite(text.begin, 1, text.length, out);
        return;
    }
    for (const char *c = texts[i].own; *c != '\0'; c++)
        if (is_place(c) && part < MOST_PARTS) {
            print_part(out, parts[part++]);
            c++;
        } else {
            putc(*c, out);
        }
}

void own_words_print(FILE *out, const char *text, size_t length)
{
    read_once();
    print_part(out, (Part){text, length});
}

char *own_words(const char *text)
{
    char *own;
    size_t size;
    FILE *out = open_memstream(&own, &size);
    own_words_print(out, text, strlen(text));
    fclose(out);
    return own;
}

void own_words_define(FILE *out)
{
    read_once();
    if (count > 0)
        fprintf(out, "own_count = %d\narray own_english[%d]\narray own_text[%d]\n", count, count,
                count);
    for (int i = 0; i < count; i++) {
        char *english = gnuplot_string(texts[i].english), *own = gnuplot_string(texts[i].own);
        fprintf(out, "own_english[%d] = %s\nown_text[%d] = %s\n", i + 1, english, i + 1, own);
        free(english);
        free(own);
    }
}
