// show.c - one test's outcome in words.
#include "tests/judge/show.h"

#include "common/text.h"

#include <string.h>

enum { COLUMNS = SHOW_COLUMNS, LABEL = 13, MOST_LINES = 8 };

// Up to the next blank outside parentheses: a vector stays in one piece.
static int length_of_word(const char *words)
{
    int length = 0, depth = 0;
    for (; words[length] != '\0' && (words[length] != ' ' || depth > 0); length++)
        depth += (words[length] == '(') - (words[length] == ')');
    return length < COLUMNS - LABEL ? length : (int)strcspn(words, " ");
}

// A label, then words that wrap under each other. A ~ is a blank that does not break.
void show_field(FILE *out, const char *label, const char *words)
{
    int column = fprintf(out, "  %-*s", LABEL - 2, label);
    while (*words != '\0') {
        int length = length_of_word(words);
        if (column + 1 + length > COLUMNS && column > LABEL)
            column = fprintf(out, "\n%*s", LABEL, "") - 1;
        else if (column > LABEL)
            column += fprintf(out, " ");
        for (int i = 0; i < length; i++)
            putc(words[i] == '~' ? ' ' : words[i], out);
        column += length;
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
static void show_printed(FILE *out, const char *text)
{
    int column = 0, lines = 0;
    for (; *text != '\0' && lines < MOST_LINES; text++) {
        if (column == 0)
            fprintf(out, lines == 0 ? "  it printed " : "%*s", LABEL, "");
        if (*text == '\n' || column == COLUMNS - LABEL) {
            putc('\n', out);
            column = 0;
            lines++;
        }
        if (*text != '\n') {
            putc((*text >= ' ' && *text < 127) ? *text : '?', out);
            column++;
        }
    }
    if (column > 0)
        putc('\n', out);
    if (*text != '\0')
        fprintf(out, "%*s... and more\n", LABEL, "");
}

void show_outcome(FILE *out, const Outcome *outcome)
{
    const Record *record = outcome->record;
    if (record->hidden) {
        show_field(out, "given", "random numbers of this run, not shown");
        if (record->missing[0] != '\0')
            show_field(out, "yours", "not answered yet");
        else if (record->expected[0] == '\0')
            show_field(out, "it", outcome->how);
        return;
    }
    show_given(out, record->given);
    if (record->expected[0] != '\0') {
        show_field(out, "expected", record->expected);
        show_field(out, "yours", record->missing[0] != '\0' ? "not answered yet" : record->yours);
    } else {
        show_field(out, "it", outcome->how);
    }
    show_printed(out, record->printed);
}
