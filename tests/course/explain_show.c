// explain_show.c - what a student reads: the compiler's messages with their quotes and a line of
// help below each, causes of a wrong value that only the code shows, and the linker's words.
#include "tests/course/explain.h"

#include "tests/course/explain_inside.h"

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

static void show_message(FILE *out, const Mistake *mistake, Lines *helped)
{
    const Lines *body = &mistake->message->body;
    show_wrapped(out, mistake->message->line, "  ");
    size_t first = 0;
    for (size_t k = 0; k < body->count; k++)
        if (text_begins(body->line[k], text_format("%s:", answer.source))) {
            show_quote(out, body->line + first, k - first);
            show_wrapped(out, body->line[k], "  ");
            first = k + 1;
        }
    if (body->count > 0)
        show_quote(out, body->line + first, body->count - first);
    const char *words = help(mistake);
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
static void show_elsewhere(FILE *out)
{
    show_wrapped(out, all.elsewhere, "  ");
    if (all.where_included[0] != '\0')
        show_wrapped(out,
                     text_format("  help: the error shows there, but look at %s and above it.",
                                 all.where_included),
                     "        ");
}

static void show_all(FILE *out)
{
    size_t errors = 0, shown = 0;
    for (size_t i = 0; i < all.count; i++)
        errors += !all.mistakes[i].is_dropped && !all.mistakes[i].message->is_warning;
    if (errors == 0 && all.elsewhere[0] != '\0')
        show_elsewhere(out);
    Lines helped = {NULL, 0};
    for (int warning = 0; warning <= 1; warning++)
        for (size_t i = 0; i < all.count; i++) {
            const Mistake *mistake = &all.mistakes[i];
            if (!mistake->is_dropped && mistake->message->is_warning == (warning == 1) &&
                shown++ < MOST_SHOWN)
                show_message(out, mistake, &helped);
        }
    if (shown + all.unread > MOST_SHOWN)
        fprintf(out, "... and %zu more\n", shown + all.unread - MOST_SHOWN);
    // Whatever else a compiler may say.
    if (all.count == 0 && all.elsewhere[0] == '\0')
        for (size_t i = 0; i < all.raw_count; i++)
            show_wrapped(out, all.raw[i], "  ");
}

// Some editors for Windows save text as UTF-16, which begins with these bytes.
static bool is_utf_16(const char *source)
{
    FILE *file = fopen(source, "rb");
    int first = file != NULL ? fgetc(file) : EOF, second = file != NULL ? fgetc(file) : EOF;
    if (file != NULL)
        fclose(file);
    return (first == 0xFF && second == 0xFE) || (first == 0xFE && second == 0xFF);
}

void explain(FILE *out, const char *source, const char *diagnostics)
{
    if (is_utf_16(source)) {
        fprintf(out, "%s: error: this file is saved as UTF-16\n", source);
        fputs("  help: save it as UTF-8 in your editor. Nothing in it is lost.\n", out);
        return;
    }
    explanation_read(source, diagnostics);
    show_all(out);
    texts_free();
}

// ---- causes that only the text of a wrong answer shows -----------------------------------------

typedef struct {
    const char *const *judged;
    size_t judged_count;
    bool *has_comma; // by line: the compiler warned of a decimal comma
    Lines seen;      // functions and macros
    Lines help;      // on divisions and powers
    bool comma;
} Slips;

static bool is_in(const char *name, const char *const *list, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (text_is(list[i], name))
            return true;
    return false;
}

// x * 1/2, (double)1/2 and 1/2.0 do not divide whole numbers.
static void find_divisions(Slips *slips, size_t line)
{
    const char *code = answer_code(line);
    size_t from = 0;
    for (Match match; text_find(code + from, "[0-9]+ */ *[0-9]+", &match);) {
        size_t begin = from + match.at, end = begin + match.length;
        const char *before = text_part(code, 0, begin), *after = code + end;
        from = end;
        if (text_matches(before, "[A-Za-z_0-9.]$|[0-9.][eE][-+]$|[*/%)] *$") ||
            is_word_character(*after) || *after == '.')
            continue;
        char *rest;
        unsigned long upper = strtoul(code + begin, &rest, 10);
        unsigned long lower = strtoul(rest + text_span(rest, " /"), NULL, 10);
        if (lower == 0 || upper % lower == 0)
            continue;
        const char *words =
            text_format("in line %zu, %lu/%lu is %lu: C divides whole numbers without a remainder. "
                        "Write %lu.0/%lu.\n",
                        line, upper, lower, upper / lower, upper, lower);
        if (!is_in(words, slips->help.line, slips->help.count))
            lines_add(&slips->help, words);
    }
}

// Between whole numbers ^ compiles, and no exercise is about bits.
static void find_powers(Slips *slips, size_t line)
{
    const char *code = answer_code(line);
    const char *power =
        text_group(code, "([A-Za-z_0-9.]+|\\)) *\\^ *(- *)?([A-Za-z_0-9.]+|\\()", 0);
    if (power[0] == '\0')
        return;
    const char *base = text_before(power, "^"), *exponent = strchr(power, '^') + 1;
    exponent += text_span(exponent, " ");
    const char *call =
        text_matches(power, "[()]") ? "pow(x, y)" : text_format("pow(%s, %s)", base, exponent);
    lines_add(&slips->help, text_format("in line %zu, %s is exclusive or, not a power: write %s.\n",
                                        line, text_matches(power, "[()]") ? "^" : power, call));
}

static void look_at_line(Slips *slips, size_t line)
{
    find_divisions(slips, line);
    find_powers(slips, line);
}

// The macros of a line.
static void look_at_macros(Slips *slips, const char *code)
{
    for (size_t i = 1; i <= answer.last; i++) {
        const char *name = text_group(answer.code[i], "^ *# *define +([A-Za-z_0-9]+)", 1);
        if (is_in(name, slips->seen.line, slips->seen.count) || !text_has_word(code, name))
            continue;
        lines_add(&slips->seen, name);
        look_at_line(slips, i);
    }
}

// The lines of a function, and of the helpers and macros that it uses.
static void look_at(Slips *slips, const OwnFunction *function)
{
    lines_add(&slips->seen, function->name);
    size_t line = function->line;
    do {
        const char *code = answer.code[line];
        look_at_line(slips, line);
        slips->comma = slips->comma || slips->has_comma[line];
        for (size_t i = 0; i < answer.function_count; i++) {
            const OwnFunction *other = answer_function_named(answer.functions[i].name);
            if (!is_in(other->name, slips->seen.line, slips->seen.count) &&
                !is_in(other->name, slips->judged, slips->judged_count) &&
                text_has_word(code, other->name))
                look_at(slips, other);
        }
        look_at_macros(slips, code);
        line++;
    } while (line <= answer.last && answer_function_at(line) == NULL);
}

static void read_commas(Slips *slips, const char *diagnostics)
{
    size_t length = strlen(answer.source);
    slips->has_comma = text_memory((answer.count + 1) * sizeof *slips->has_comma);
    char *rest = text_copy(diagnostics);
    for (char *words; (words = text_next_line(&rest)) != NULL;) {
        if (!text_begins(words, answer.source) || words[length] != ':' ||
            !text_says(words, "comma|excess elements|not used|unused"))
            continue;
        size_t line = strtoul(words + length + 1, NULL, 10);
        if (line >= 1 && line <= answer.count && answer_decimal_comma(line)[0] != '\0')
            slips->has_comma[line] = true;
    }
}

ExplainedSlips explain_slips(const char *source, const char *diagnostics, const char *function,
                             const char *const *judged, size_t judged_count)
{
    answer_read(source);
    Slips slips = {.judged = judged, .judged_count = judged_count};
    const OwnFunction *own = answer_function_named(function);
    ExplainedSlips explained = {NULL, false};
    if (own != NULL) {
        read_commas(&slips, diagnostics);
        look_at(&slips, own);
    }
    size_t size;
    FILE *out = slips.help.count > 0 ? open_memstream(&explained.help, &size) : NULL;
    for (size_t i = 0; out != NULL && i < slips.help.count; i++)
        fputs(slips.help.line[i], out);
    if (out != NULL)
        fclose(out);
    explained.is_comma = slips.comma;
    texts_free();
    return explained;
}

// ---- the parts of the linker's output that help a student --------------------------------------

// Whether the answer defines it as inline, and not static: then no function of this name is made.
static bool is_inline(const char *name)
{
    for (size_t i = 0; i < answer.function_count; i++)
        if (text_is(answer.functions[i].name, name) &&
            text_begins(answer_code(answer.functions[i].line), "inline "))
            return true;
    return false;
}

// The name in `quotes' or 'quotes' after these words, or "". Others than those of C are not quoted.
static const char *named_after(const char *line, const char *words)
{
    const char *at = strstr(line, words);
    if (at == NULL)
        return "";
    at += strlen(words);
    size_t length = at[0] == '`' || at[0] == '\'' ? text_span_of_word(at + 1) : 0;
    return length > 0 && at[length + 1] == '\'' ? text_part(at, 1, length) : "";
}

static const char *explained(const char *line)
{
    const char *twice = named_after(line, "multiple definition of ");
    const char *missing = named_after(line, "undefined reference to ");
    if (text_is(twice, "main"))
        return "  remove main: the tests have their own";
    if (twice[0] != '\0')
        return text_format("  %s is already the name of something else: make yours static", twice);
    if (missing[0] == '\0')
        return "";
    return is_inline(missing) ? text_format("  %s is inline: write static inline", missing)
                              : text_format("  %s is not in this file (or is static)", missing);
}

static int in_order(const void *left, const void *right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

void explain_linker(FILE *out, const char *source, const char *words)
{
    answer_read(source);
    Lines lines = {NULL, 0};
    char *rest = text_copy(words);
    for (char *line; (line = text_next_line(&rest)) != NULL;) {
        const char *known = explained(line);
        if (known[0] != '\0')
            lines_add(&lines, known);
    }
    if (lines.count > 0)
        qsort(lines.line, lines.count, sizeof *lines.line, in_order);
    else
        fputs(words, out);
    for (size_t i = 0; i < lines.count; i++)
        if (i == 0 || !text_is(lines.line[i], lines.line[i - 1]))
            fprintf(out, "%s\n", lines.line[i]);
    texts_free();
}
