// explain_linker.c - the parts of the linker's output that help a student.
#include "tests/course/explain.h"

#include "tests/course/explain_answer.h"

#include <stdlib.h>
#include <string.h>

// Whether the answer defines it as inline, and not static: then no function of this name is made.
static bool is_inline(const Answer *answer, const char *name)
{
    for (size_t i = 0; i < answer->function_count; i++)
        if (text_is(answer->functions[i].name, name) &&
            text_begins(answer_code(answer, answer->functions[i].line), "inline "))
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

static const char *explained(const Answer *answer, const char *line)
{
    const char *twice = named_after(line, "multiple definition of ");
    const char *missing = named_after(line, "undefined reference to ");
    if (text_is(twice, "main"))
        return "  remove main: the tests have their own";
    if (twice[0] != '\0')
        return text_format("  %s is already the name of something else: make yours static", twice);
    if (missing[0] == '\0')
        return "";
    return is_inline(answer, missing)
               ? text_format("  %s is inline: write static inline", missing)
               : text_format("  %s is not in this file (or is static)", missing);
}

static int in_order(const void *left, const void *right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

void explain_linker(FILE *out, const char *source, const char *words)
{
    Answer answer = answer_read(source);
    Lines lines = {NULL, 0};
    char *rest = text_copy(words);
    for (char *line; (line = text_next_line(&rest)) != NULL;) {
        const char *known = explained(&answer, line);
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
