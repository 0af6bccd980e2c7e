// explain_answer.c - see explain_answer.h.
#include "tests/course/explain_answer.h"

#include <ctype.h>
#include <string.h>

// ---- reading ------------------------------------------------------------------------------------

// The code of a line: no comments, nothing between quotes, blanks for tabs. in_comment: of /* */.
static const char *code_of(const char *line, bool *in_comment)
{
    char *code = text_memory(strnlen(line, LONGEST_CODE) + 4);
    size_t size = 0;
    for (size_t i = 0; line[i] != '\0' && size < LONGEST_CODE;) {
        if (*in_comment) {
            *in_comment = !(line[i] == '*' && line[i + 1] == '/');
            i += *in_comment ? 1 : 2;
        } else if (line[i] == '/' && line[i + 1] == '/') {
            break;
        } else if (line[i] == '/' && line[i + 1] == '*') {
            *in_comment = true;
            code[size++] = ' ';
            i += 2;
        } else if (line[i] == '"') {
            size_t end = i + 1;
            while (line[end] != '\0' && line[end] != '"')
                end += line[end] == '\\' && line[end + 1] != '\0' ? 2 : 1;
            code[size++] = '"';
            if (line[end] == '"') {
                code[size++] = '"';
                i = end + 1;
            } else
                i++;
        } else if (line[i] == '\'') {
            size_t length = line[i + 1] == '\\' ? 2 : 1;
            bool ends = line[i + 1] != '\0' && line[i + 1] != '\'' && line[i + length] != '\0' &&
                        line[i + length + 1] == '\'';
            code[size++] = '\'';
            if (ends) {
                code[size++] = ' ';
                code[size++] = '\'';
            }
            i += ends ? length + 2 : 1;
        } else {
            code[size++] = line[i] == '\t' || line[i] == '\r' ? ' ' : line[i];
            i++;
        }
    }
    while (size > 0 && code[size - 1] == ' ')
        size--;
    code[size] = '\0';
    return code;
}

// A function's first line:  vec3 upper_left(Camera c)  or, where the type was forgotten, from its
// name.
static bool begins_function(const char *code, OwnFunction *function)
{
    Match match;
    size_t end = strlen(code);
    bool typed = text_find(code, "^[A-Za-z_][A-Za-z_0-9 *]*[ *][A-Za-z_0-9]+\\(", &match) &&
                 code[end - 1] != ';';
    if (!typed && !(text_find(code, "^[a-z_][a-z_0-9]*\\(", &match) &&
                    text_matches(code, "^[a-z_0-9]+\\([A-Za-z_0-9 *,]*\\) *\\{?$")))
        return false;
    size_t name_end = match.length - 1, name = name_end;
    while (name > 0 && is_word_character(code[name - 1]))
        name--;
    function->name = text_part(code, name, name_end - name);
    if (text_begins(code, "return ") || text_begins(code, "else ") ||
        text_is_one_of(function->name, "if for while switch"))
        return false;
    function->type = bare_type(text_part(code, 0, name));
    return true;
}

static void read_include(Answer *answer, const char *line)
{
    Match match;
    if (!text_find(line, "^[ \t]*#[ \t]*include[ \t]*\"", &match))
        return;
    const char *name = line + match.length;
    lines_add(&answer->included, text_part(name, 0, strcspn(name, "\"")));
}

Answer answer_read(const char *source)
{
    Answer answer = {.source = source};
    char *rest = text_of_file(source);
    if (rest == NULL)
        return answer;
    size_t most = (size_t)text_count(rest, '\n') + 2;
    answer.text = text_memory(most * sizeof *answer.text);
    answer.code = text_memory(most * sizeof *answer.code);
    answer.functions = text_memory(most * sizeof *answer.functions);
    bool in_comment = false;
    for (char *line; (line = text_next_line(&rest)) != NULL;) {
        size_t number = ++answer.count;
        read_include(&answer, line);
        answer.text[number] = line;
        answer.code[number] = code_of(line, &in_comment);
        OwnFunction function = {.line = number};
        if (begins_function(answer.code[number], &function))
            answer.functions[answer.function_count++] = function;
        if (answer.code[number][0] != '\0')
            answer.last = number;
    }
    return answer;
}

// ---- lines and functions ------------------------------------------------------------------------

const char *answer_text(const Answer *answer, size_t line)
{
    return line >= 1 && line <= answer->count ? answer->text[line] : "";
}

const char *answer_code(const Answer *answer, size_t line)
{
    return line >= 1 && line <= answer->count ? answer->code[line] : "";
}

bool answer_includes(const Answer *answer, const char *header)
{
    for (size_t i = 0; i < answer->included.count; i++)
        if (text_is(answer->included.line[i], header))
            return true;
    return false;
}

static const OwnFunction *function_around(const Answer *answer, size_t line)
{
    const OwnFunction *around = NULL;
    for (size_t i = 0; i < answer->function_count && answer->functions[i].line <= line; i++)
        around = &answer->functions[i];
    return around;
}

const OwnFunction *answer_function_at(const Answer *answer, size_t line)
{
    const OwnFunction *around = function_around(answer, line);
    return around != NULL && around->line == line ? around : NULL;
}

const OwnFunction *answer_function_named(const Answer *answer, const char *name)
{
    for (size_t i = answer->function_count; i > 0; i--)
        if (text_is(answer->functions[i - 1].name, name))
            return &answer->functions[i - 1];
    return NULL;
}

size_t answer_beginning(const Answer *answer, size_t line)
{
    const OwnFunction *around = function_around(answer, line);
    return around != NULL ? around->line : 0;
}

const char *answer_function_around(const Answer *answer, size_t line)
{
    const OwnFunction *around = function_around(answer, line);
    return around != NULL ? around->name : "";
}

size_t answer_unclosed(const Answer *answer)
{
    int depth = 0;
    size_t last = 0;
    for (size_t i = 1; i <= answer->last; i++) {
        if (answer_function_at(answer, i) != NULL) {
            if (depth > 0)
                break;
            last = i;
        }
        depth += text_count(answer->code[i], '{') - text_count(answer->code[i], '}');
    }
    return depth > 0 ? last : 0;
}

// ---- statements ---------------------------------------------------------------------------------

static bool ends_statement(const char *code)
{
    return code[0] != '\0' && strchr(";{}", code[strlen(code) - 1]) != NULL;
}

size_t answer_statement(const Answer *answer, size_t line)
{
    for (size_t least = line > LONGEST_STATEMENT ? line - LONGEST_STATEMENT : 1; line > least;
         line--) {
        const char *before = answer_code(answer, line - 1);
        if (before[0] == '\0' || before[0] == '#' || ends_statement(before))
            break;
    }
    return line;
}

const char *answer_statement_text(const Answer *answer, size_t line)
{
    size_t first = answer_statement(answer, line), end = first, length = 1;
    while (end <= answer->last && end < first + 2 * LONGEST_STATEMENT) {
        const char *code = answer_code(answer, end++);
        length += 1 + strlen(code);
        if (ends_statement(code))
            break;
    }
    char *text = text_memory(length), *at = text;
    for (size_t i = first; i < end; i++) {
        *at++ = ' ';
        at = stpcpy(at, answer_code(answer, i));
    }
    return text;
}

size_t answer_code_before(const Answer *answer, size_t line)
{
    if (line > answer->count)
        line = answer->count + 1;
    for (line -= line > 0; line > 0; line--) {
        const char *code = answer_code(answer, line);
        if (code[text_span(code, " ")] != '\0')
            return line;
    }
    return 0;
}

int answer_brackets(const Answer *answer, size_t line)
{
    const char *text = answer_statement_text(answer, line);
    return text_count(text, '(') - text_count(text, ')');
}

bool answer_ends_at_once(const Answer *answer, size_t line)
{
    const char *code = answer_code(answer, line);
    Match match;
    if (!text_find(code, "(^|[^A-Za-z_0-9])(for|if|while) *\\(", &match))
        return false;
    int depth = 0;
    for (size_t i = match.at + match.length - 1; code[i] != '\0'; i++) {
        depth += (code[i] == '(') - (code[i] == ')');
        if (depth == 0)
            return code[i + 1 + text_span(code + i + 1, " ")] == ';';
    }
    return false;
}

// Whether there is  for (TYPE NAME =  in this code.
static bool loop_declares(const char *code, const char *name)
{
    for (const char *at = code; (at = strstr(at, "for")) != NULL; at++) {
        if (at > code && is_word_character(at[-1]))
            continue;
        const char *next = at + strlen("for");
        next += text_span(next, " ");
        if (*next != '(')
            continue;
        next += 1 + text_span(next + 1, " ");
        size_t type = text_span_of_word(next), blanks = text_span(next + type, " *");
        if (type == 0 || blanks == 0)
            continue;
        next += type + blanks;
        if (text_begins(next, name) &&
            next[strlen(name) + text_span(next + strlen(name), " ")] == '=')
            return true;
    }
    return false;
}

size_t answer_loop_of(const Answer *answer, const char *name, size_t line)
{
    size_t first = answer_beginning(answer, line);
    if (line > answer->count)
        line = answer->count;
    while (line > first && !loop_declares(answer_code(answer, line), name))
        line--;
    return line > first ? line : 0;
}

const char *answer_decimal_comma(const Answer *answer, size_t line)
{
    const char *text = text_format("%s ", answer_statement_text(answer, line));
    Match match;
    if (!text_find(text, "[^A-Za-z_0-9.,][0-9]+,[0-9]+([^A-Za-z_0-9.,]|, )", &match))
        return "";
    const char *number = text + match.at + 1, *digits = "0123456789";
    size_t whole = text_span(number, digits) + 1;
    return text_part(number, 0, whole + text_span(number + whole, digits));
}
