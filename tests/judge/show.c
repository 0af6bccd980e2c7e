// show.c - one test's outcome in words.
#include "tests/judge/show.h"

#include "common/text.h"

#include <string.h>

enum { COLUMNS = 79, LABEL = 13, MOST_LINES = 8 };

// A label, then words that wrap under each other.
static void show_field(FILE *out, const char *label, const char *words)
{
    int column = fprintf(out, "  %-*s", LABEL - 2, label);
    while (*words != '\0') {
        int length = (int)strcspn(words, " ");
        // A vector stays in one piece.
        if (*words == '(')
            length = (int)strcspn(words, ")");
        length += (int)strcspn(words + length, " ");
        if (column + length > COLUMNS && column > LABEL)
            column = fprintf(out, "\n%*s", LABEL, "") - 1;
        else if (column > LABEL)
            column += fprintf(out, " ");
        column += fprintf(out, "%.*s", length, words);
        words += length;
        words += strspn(words, " ");
    }
    fprintf(out, "\n");
}

static void show_given(FILE *out, const char *given)
{
    while (*given != '\0') {
        char label[64], value[1300];
        int used = 0;
        if (sscanf(given, "%63[^\t]\t%1299[^\n]\n%n", label, value, &used) != 2)
            return;
        show_field(out, label, value);
        given += used;
    }
}

// A student's own output: only what is safe to show, and not all of it.
static void show_printed(FILE *out, const char *path)
{
    FILE *file = path == NULL ? NULL : fopen(path, "r");
    if (file == NULL)
        return;
    int column = 0, lines = 0, c;
    while ((c = getc(file)) != EOF && lines < MOST_LINES) {
        if (column == 0)
            fprintf(out, lines == 0 ? "  it printed " : "%*s", LABEL, "");
        if (c == '\n' || column == COLUMNS - LABEL) {
            putc('\n', out);
            column = 0;
            lines++;
        }
        if (c != '\n') {
            putc((c >= ' ' && c < 127) ? c : '?', out);
            column++;
        }
    }
    if (column > 0)
        putc('\n', out);
    if (c != EOF)
        fprintf(out, "%*s... and more\n", LABEL, "");
    fclose(file);
}

void show_outcome(FILE *out, const Outcome *outcome, const char *printed)
{
    const Record *record = outcome->record;
    show_given(out, record->given);
    if (record->expected[0] != '\0') {
        show_field(out, "expected", record->expected);
        show_field(out, "yours", record->missing[0] != '\0' ? "not answered yet" : record->yours);
    } else {
        show_field(out, "it", outcome->how);
    }
    show_printed(out, printed);
}
