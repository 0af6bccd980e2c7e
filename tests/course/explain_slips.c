// explain_slips.c - causes that only the text of a wrong answer shows: 1/2, and 0,5.
#include "tests/course/explain.h"

#include "tests/course/explain_answer.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    const Answer *answer;
    const char *const *judged;
    size_t judged_count;
    bool *has_comma; // by line: the compiler warned of a decimal comma
    Lines seen;      // functions and macros
    Lines divisions; // a line of help each
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
    const char *code = answer_code(slips->answer, line);
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
        if (!is_in(words, slips->divisions.line, slips->divisions.count))
            lines_add(&slips->divisions, words);
    }
}

// The macros of a line.
static void look_at_macros(Slips *slips, const char *code)
{
    for (size_t i = 1; i <= slips->answer->last; i++) {
        Match match;
        const char *macro = slips->answer->code[i];
        if (!text_find(macro, "^ *# *define +", &match))
            continue;
        const char *name = text_part(macro, match.length, text_span_of_word(macro + match.length));
        if (is_in(name, slips->seen.line, slips->seen.count) || !text_has_word(code, name))
            continue;
        lines_add(&slips->seen, name);
        find_divisions(slips, i);
    }
}

// The lines of a function, and of the helpers and macros that it uses.
static void look_at(Slips *slips, const OwnFunction *function)
{
    const Answer *answer = slips->answer;
    lines_add(&slips->seen, function->name);
    size_t line = function->line;
    do {
        const char *code = answer->code[line];
        find_divisions(slips, line);
        slips->comma = slips->comma || slips->has_comma[line];
        for (size_t i = 0; i < answer->function_count; i++) {
            const OwnFunction *other = answer_function_named(answer, answer->functions[i].name);
            if (!is_in(other->name, slips->seen.line, slips->seen.count) &&
                !is_in(other->name, slips->judged, slips->judged_count) &&
                text_has_word(code, other->name))
                look_at(slips, other);
        }
        look_at_macros(slips, code);
        line++;
    } while (line <= answer->last && answer_function_at(answer, line) == NULL);
}

static void read_commas(Slips *slips, const char *diagnostics)
{
    const Answer *answer = slips->answer;
    size_t length = strlen(answer->source);
    slips->has_comma = text_memory((answer->count + 1) * sizeof *slips->has_comma);
    char *rest = text_copy(diagnostics);
    for (char *words; (words = text_next_line(&rest)) != NULL;) {
        if (!text_begins(words, answer->source) || words[length] != ':' ||
            !text_says(words, "comma|excess elements|not used|unused"))
            continue;
        size_t line = strtoul(words + length + 1, NULL, 10);
        if (line >= 1 && line <= answer->count && answer_decimal_comma(answer, line)[0] != '\0')
            slips->has_comma[line] = true;
    }
}

ExplainedSlips explain_slips(const char *source, const char *diagnostics, const char *function,
                             const char *const *judged, size_t judged_count)
{
    Answer answer = answer_read(source);
    Slips slips = {.answer = &answer, .judged = judged, .judged_count = judged_count};
    const OwnFunction *own = answer_function_named(&answer, function);
    ExplainedSlips explained = {NULL, false};
    if (own != NULL) {
        read_commas(&slips, diagnostics);
        look_at(&slips, own);
    }
    size_t size;
    FILE *out = slips.divisions.count > 0 ? open_memstream(&explained.help, &size) : NULL;
    for (size_t i = 0; out != NULL && i < slips.divisions.count; i++)
        fputs(slips.divisions.line[i], out);
    if (out != NULL)
        fclose(out);
    explained.is_comma = slips.comma;
    texts_free();
    return explained;
}
