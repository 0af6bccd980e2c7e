// explain_show.c - the messages that are shown, with their quotes, and a line of help below each.
#include "tests/course/explain.h"

#include "tests/course/explain_mistakes.h"

#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 79 };

// A long line goes on in the next one, after the indent. It is divided between words.
static void show_wrapped(FILE *out, const char *line, const char *indent)
{
    size_t first = 0, margin = strlen(indent); // the margin of this line: none of the first
    for (;;) {
        size_t length = strlen(line);
        if (first + length <= COLUMNS)
            break;
        size_t at = COLUMNS - first; // of the blank
        size_t least = margin + 20 - first;
        while (at >= least && line[at] != ' ')
            at--;
        bool between_words = line[at] == ' ';
        if (!between_words)
            at = COLUMNS - first - 1;
        size_t end = at + (between_words ? 0 : 1);
        while (end > 0 && line[end - 1] == ' ')
            end--;
        fprintf(out, "%s%.*s\n", first > 0 ? indent : "", (int)end, line);
        line += at + (between_words ? 0 : 1);
        line += text_span(line, " ");
        first = margin;
    }
    fprintf(out, "%s%s\n", first > 0 ? indent : "", line);
}

static void show_cut(FILE *out, const char *line)
{
    size_t length = strnlen(line, COLUMNS);
    while (length > 0 && line[length - 1] == ' ')
        length--;
    fprintf(out, "%.*s\n", (int)length, line);
}

static bool is_caret_line(const char *line)
{
    return line[text_span(line, " |~")] == '^';
}

// A quote: the text, the caret below it, and the compiler's suggestion. If the caret is far out,
// all lines lose the same columns after the margin.
static void show_quote(FILE *out, const char *const *quote, size_t count)
{
    size_t caret = 0;
    for (size_t k = 0; k < count && caret == 0; k++)
        if (is_caret_line(quote[k]))
            caret = strcspn(quote[k], "^") + 1;
    Match margin = {0, 0};
    if (count > 0)
        text_find(quote[0], "^ *[0-9]+ \\|", &margin);
    size_t gone = caret > COLUMNS - 10 ? caret - 50 : 0;
    for (size_t k = 0; k < count; k++)
        show_cut(out, gone == 0 ? quote[k]
                                : text_format("%s%s%s", text_part(quote[k], 0, margin.length),
                                              k == 0 ? " ..." : "    ",
                                              text_from(quote[k], margin.length + gone + 4)));
}

static void show_message(FILE *out, const Explanation *all, const Mistake *mistake, Lines *helped)
{
    const Lines *body = &mistake->message->body;
    show_wrapped(out, mistake->message->line, "  ");
    size_t first = 0;
    for (size_t k = 0; k < body->count; k++)
        if (text_begins(body->line[k], text_format("%s:", all->code.answer.source))) {
            show_quote(out, body->line + first, k - first);
            show_wrapped(out, body->line[k], "  ");
            first = k + 1;
        }
    if (body->count > 0)
        show_quote(out, body->line + first, body->count - first);
    const char *words = help(all, mistake);
    for (size_t i = 0; i < helped->count; i++)
        if (text_is(helped->line[i], words))
            return;
    if (words[0] == '\0')
        return;
    lines_add(helped, words);
    char *memory = NULL;
    size_t size = 0;
    FILE *wrapped = open_memstream(&memory, &size);
    if (wrapped == NULL)
        return;
    show_wrapped(wrapped, text_format("  help: %s", words), "        ");
    fclose(wrapped);
    for (size_t i = 0; i < size; i++)
        fputc(memory[i] == UNBROKEN[0] ? ' ' : memory[i], out);
    free(memory);
}

// Code before an #include can cause an error in the header.
static void show_elsewhere(FILE *out, const Diagnostics *diagnostics)
{
    show_wrapped(out, diagnostics->elsewhere, "  ");
    if (diagnostics->where_included[0] != '\0')
        show_wrapped(out,
                     text_format("  help: the error shows there, but look at %s and above it.",
                                 diagnostics->where_included),
                     "        ");
}

static void show_all(FILE *out, const Explanation *all)
{
    const Diagnostics *diagnostics = all->diagnostics;
    size_t errors = 0, shown = 0;
    for (size_t i = 0; i < all->count; i++)
        errors += !all->mistakes[i].is_dropped && !all->mistakes[i].message->is_warning;
    if (errors == 0 && diagnostics->elsewhere[0] != '\0')
        show_elsewhere(out, diagnostics);
    Lines helped = {NULL, 0};
    for (int warning = 0; warning <= 1; warning++)
        for (size_t i = 0; i < all->count; i++) {
            const Mistake *mistake = &all->mistakes[i];
            if (!mistake->is_dropped && mistake->message->is_warning == (warning == 1) &&
                shown++ < MOST_SHOWN)
                show_message(out, all, mistake, &helped);
        }
    if (shown + diagnostics->unread > MOST_SHOWN)
        fprintf(out, "... and %zu more\n", shown + diagnostics->unread - MOST_SHOWN);
    // Whatever else a compiler may say.
    if (all->count == 0 && diagnostics->elsewhere[0] == '\0')
        for (size_t i = 0; i < diagnostics->raw_count; i++)
            show_wrapped(out, diagnostics->raw[i], "  ");
}

void explain(FILE *out, const char *source, const char *diagnostics)
{
    Explanation all = explanation_of(source, diagnostics);
    show_all(out, &all);
    texts_free();
}
