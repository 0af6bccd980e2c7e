// hints.c - one hint more each time it is asked for; from the start again after the answer changed.
#include "tests/course/hints.h"

#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>

// The next line of a text, without blanks at its end; NULL after the last.
static char *next_line(char **rest)
{
    char *line = *rest != NULL && **rest != '\0' ? strsep(rest, "\n") : NULL;
    for (size_t length = line != NULL ? strlen(line) : 0;
         length > 0 && strchr(" \r", line[length - 1]);)
        line[--length] = '\0';
    return line;
}

static const char *section_name(char *line)
{
    line += 1 + strspn(line + 1, " ");
    line[strcspn(line, " ")] = '\0';
    return line;
}

// Prints hint NUMBER of a function, as it is wrapped in the file; how many there are. If function
// is NULL, prints the names of all functions instead.
static int go_through(const Page *page, const char *hints, const char *function, int number)
{
    size_t size;
    char *text = whole_text(hints, &size), *rest = text;
    bool inside = false;
    int count = 0;
    for (char *line; (line = next_line(&rest)) != NULL;) {
        if (line[0] == '#') {
            const char *name = section_name(line);
            inside = function != NULL && strcmp(name, function) == 0;
            if (function == NULL)
                fprintf(page->out, "  %s\n", name);
        } else if (inside && line[0] != '\0') {
            bool begins = strncmp(line, "- ", 2) == 0;
            count += begins;
            if (count > 0 && count == number)
                fprintf(page->out, "%s%s\n", begins ? "  " : "", line + (begins ? 2 : 0));
        }
    }
    free(text);
    return count;
}

static int shown_so_far(const char *state, const char *function, const char *hash)
{
    char last_function[100] = "", last_hash[HASH_WORD] = "";
    int count = 0;
    FILE *file = fopen(state, "r");
    if (file == NULL)
        return 0;
    bool good = fscanf(file, "%99s %16s %4d", last_function, last_hash, &count) == 3;
    fclose(file);
    return good && count > 0 && strcmp(last_function, function) == 0 && strcmp(last_hash, hash) == 0
               ? count
               : 0;
}

int hint_next(const Page *page, const char *stem, const char *hints, const char *function,
              const char *answer, const char *state)
{
    FILE *there = fopen(hints, "r");
    if (there == NULL) {
        fprintf(stderr,
                "%s: there are no hints (%s is missing). The lesson: chapters/%s/README.md\n", stem,
                hints, stem);
        return 1;
    }
    fclose(there);
    int total = go_through(page, hints, function, 0);
    if (total == 0) {
        fprintf(stderr, "%s: there is no hint for '%s'. There are some for:\n", stem, function);
        go_through(&(Page){stderr, page->columns, false}, hints, NULL, 0);
        return 1;
    }
    // By its text, not its date: saving it again unchanged is not a new attempt.
    char hash[HASH_WORD];
    hash_word(hash, hash_file(HASH_BEGIN, answer));
    int shown = shown_so_far(state, function, hash), number = shown < total ? shown + 1 : total;
    fprintf(page->out, "%s  %s  hint %d of %d\n", stem, function, number, total);
    go_through(page, hints, function, number);
    if (number < total)
        fprintf(page->out, "(next hint: make hint EX=%.2s)\n", stem);
    else
        fprintf(page->out, "(that was the last one; the lesson is chapters/%s/README.md)\n", stem);
    FILE *file = fopen(state, "w");
    if (file != NULL) {
        fprintf(file, "%s %s %d\n", function, hash, number);
        fclose(file);
    }
    return 0;
}
