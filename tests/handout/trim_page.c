// trim_page.c - a page for readers who have less than its writer: a paragraph, an item of a list or
// a row of a table is left out if it links to a file that does not exist.
//
//   trim_page FOLDER PAGE      prints it; FOLDER: where the page's links begin
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *folder;
static bool left_out; // the last paragraph that ended

static bool exists(const char *link, size_t length)
{
    char path[4096];
    int size = snprintf(path, sizeof path, "%s/%.*s", folder, (int)length, link);
    return size < (int)sizeof path && access(path, F_OK) == 0;
}

// [words](link): the part of the link before '#'.
static bool links_to_nothing(const char *text, const char *end)
{
    while ((text = strstr(text, "](")) != NULL && text < end) {
        text += 2;
        size_t length = strcspn(text, ")#");
        if (length > 0 && strncmp(text, "http:", 5) != 0 && strncmp(text, "https:", 6) != 0 &&
            !exists(text, length))
            return true;
    }
    return false;
}

static void end_paragraph(const char *begin, const char *end)
{
    if (begin == end)
        return;
    left_out = links_to_nothing(begin, end);
    if (!left_out)
        fwrite(begin, 1, (size_t)(end - begin), stdout);
}

static void trim(const char *page)
{
    const char *paragraph = page, *next;
    for (const char *line = page; *line != '\0'; line = next) {
        next = line + strcspn(line, "\n");
        next += *next == '\n';
        bool is_empty = *line == '\n', is_row = *line == '|';
        if (is_empty || is_row || strncmp(line, "- ", 2) == 0) {
            end_paragraph(paragraph, line);
            paragraph = line;
        }
        if (is_row)
            end_paragraph(line, next);
        // Of the empty lines around what is left out, one.
        if (is_empty && !left_out)
            putchar('\n');
        if (is_empty || is_row) {
            left_out = false;
            paragraph = next;
        }
    }
    end_paragraph(paragraph, paragraph + strlen(paragraph));
}

int main(int argc, char **argv)
{
    char *page = NULL;
    size_t room = 0;
    FILE *file = argc == 3 ? fopen(argv[2], "r") : NULL;
    if (file == NULL) {
        fprintf(stderr, "Usage: %s FOLDER PAGE\n", argv[0]);
        return 2;
    }
    folder = argv[1];
    if (getdelim(&page, &room, '\0', file) > 0)
        trim(page);
    free(page);
    fclose(file);
    return fflush(stdout) != 0 || ferror(stdout) ? 1 : 0;
}
