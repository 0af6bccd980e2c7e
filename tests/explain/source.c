// source.c - the student's answer, what the headers declare, and the names and types that are known
// in a line; below them the strings of the explainer, which are made, searched, and freed at once.
#include "tests/explain/source.h"

#include <ctype.h>
#include <dirent.h>
#include <regex.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

Answer answer;
Headers headers;

// ---- memory ------------------------------------------------------------------------------------

typedef struct Block {
    struct Block *next;
    max_align_t memory[];
} Block;

static Block *blocks;

void *text_memory(size_t size)
{
    Block *block = size > SIZE_MAX / 2 ? NULL : calloc(1, sizeof *block + size);
    if (block == NULL) {
        fprintf(stderr, "out of memory\n");
        exit(1);
    }
    block->next = blocks;
    blocks = block;
    return block->memory;
}

void texts_free(void)
{
    answer = (Answer){.source = ""};
    headers = (Headers){.contract = ""};
    while (blocks != NULL) {
        Block *next = blocks->next;
        free(blocks);
        blocks = next;
    }
}

// A list with room for one more: it is copied when it is full.
static void *text_grown(const void *list, size_t count, size_t size)
{
    // Room for 16, and twice as many whenever it is full.
    if (count > 0 && (count < 16 || (count & (count - 1)) != 0))
        return (void *)list;
    void *larger = text_memory((count == 0 ? 16 : 2 * count) * size);
    return count == 0 ? larger : memcpy(larger, list, count * size);
}

// ---- strings -----------------------------------------------------------------------------------

const char *text_format(const char *format, ...)
{
    va_list words, again;
    va_start(words, format);
    va_copy(again, words);
    int length = vsnprintf(NULL, 0, format, words);
    va_end(words);
    char *text = text_memory((size_t)(length < 0 ? 0 : length) + 1);
    if (length > 0)
        vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    return text;
}

const char *text_part(const char *text, size_t from, size_t length)
{
    text += strnlen(text, from);
    length = strnlen(text, length);
    return memcpy(text_memory(length + 1), text, length);
}

char *text_copy(const char *text)
{
    return strcpy(text_memory(strlen(text) + 1), text);
}

char *text_read(FILE *file)
{
    enum { LONGEST = 1 << 20 }; // what is longer only repeats itself
    static char text[LONGEST + 1];
    size_t size = file != NULL ? fread(text, 1, LONGEST, file) : 0;
    for (size_t i = 0; i < size; i++)
        if (text[i] == '\0')
            text[i] = '?';
    text[size] = '\0';
    return text_copy(text);
}

void lines_add(Lines *lines, const char *line)
{
    lines->line = text_grown(lines->line, lines->count, sizeof *lines->line);
    lines->line[lines->count++] = line;
}

bool lines_have(const Lines *lines, const char *line)
{
    for (size_t i = 0; i < lines->count; i++)
        if (text_is(lines->line[i], line))
            return true;
    return false;
}

static int by_name(const void *left, const void *right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

void lines_sort(Lines *lines)
{
    if (lines->count > 0)
        qsort(lines->line, lines->count, sizeof *lines->line, by_name);
}

bool text_is(const char *text, const char *other)
{
    return strcmp(text, other) == 0;
}

bool text_begins(const char *text, const char *beginning)
{
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

bool text_has(const char *text, const char *part)
{
    return strstr(text, part) != NULL;
}

static bool is_word_character(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

const char *text_word(const char *text, const char *name)
{
    size_t length = strlen(name);
    if (!text_matches(name, "^[A-Za-z_0-9]+$"))
        return NULL;
    for (const char *at = text; (at = strstr(at, name)) != NULL; at++)
        if ((at == text || !is_word_character(at[-1])) && !is_word_character(at[length]))
            return at;
    return NULL;
}

int text_count(const char *text, char c)
{
    int count = 0;
    for (; *text != '\0'; text++)
        count += *text == c;
    return count;
}

// ---- patterns ----------------------------------------------------------------------------------

// A pattern is compiled when it is first looked for. Patterns are literals, so that their addresses
// tell them apart.
static const regex_t *compiled(const char *pattern)
{
    enum { ROOM = 1024 };
    static struct {
        const char *pattern;
        regex_t compiled;
    } patterns[ROOM];
    size_t i = (uintptr_t)pattern / 8 % ROOM;
    for (size_t tried = 0; tried < ROOM; tried++, i = (i + 1) % ROOM) {
        if (patterns[i].pattern == NULL &&
            regcomp(&patterns[i].compiled, pattern, REG_EXTENDED) == 0)
            patterns[i].pattern = pattern;
        if (patterns[i].pattern == pattern)
            return &patterns[i].compiled;
    }
    fprintf(stderr, "not a pattern, or too many: %s\n", pattern);
    abort();
}

bool text_matches(const char *text, const char *pattern)
{
    return regexec(compiled(pattern), text, 0, NULL, 0) == 0;
}

bool text_find(const char *text, const char *pattern, Match *match)
{
    regmatch_t found[MOST_GROUPS];
    if (regexec(compiled(pattern), text, MOST_GROUPS, found, 0) != 0)
        return false;
    *match = (Match){.at = (size_t)found[0].rm_so, .end = (size_t)found[0].rm_eo};
    for (size_t i = 0; i < MOST_GROUPS; i++)
        match->group[i] = found[i].rm_so < 0 ? ""
                                             : text_part(text, (size_t)found[i].rm_so,
                                                         (size_t)(found[i].rm_eo - found[i].rm_so));
    return true;
}

const char *text_group(const char *text, const char *pattern, int group)
{
    Match match;
    return text_find(text, pattern, &match) ? match.group[group] : "";
}

const char *text_replaced(const char *text, const char *pattern, const char *by)
{
    if (!text_matches(text, pattern))
        return text;
    size_t length = strlen(text);
    char *replaced = text_memory(length + (length + 1) * strlen(by) + 1), *end = replaced;
    regmatch_t found;
    for (int flags = 0; regexec(compiled(pattern), text, 1, &found, flags) == 0;
         flags = REG_NOTBOL) {
        memcpy(end, text, (size_t)found.rm_so);
        end = stpcpy(end + found.rm_so, by);
        text += found.rm_eo;
        if (found.rm_eo == found.rm_so || *text == '\0')
            break;
    }
    strcpy(end, text);
    return replaced;
}

// A name, and then .name, ->name and [...], back from the end.
const char *text_expression_at_end(const char *text)
{
    return text_group(text, "[A-Za-z_][A-Za-z_0-9]*((\\.|->)[A-Za-z_][A-Za-z_0-9]*|\\[[^]]*\\])*$",
                      0);
}

const char *text_without_brackets(const char *text)
{
    char *without = text_copy(text), *end = without;
    for (; *text != '\0'; text++) {
        *end++ = *text;
        *end = '\0';
        char *open = *text == ')' ? strrchr(without, '(') : NULL;
        if (open != NULL)
            *(end = open) = '\0';
    }
    return without;
}

// ---- the answer --------------------------------------------------------------------------------

// The length of "..." or 'x'; 1 if it does not end in its line.
static size_t length_of_quoted(const char *text)
{
    size_t i = 1;
    while (text[i] != text[0] && text[i] != '\n' && text[i] != '\0')
        i += text[i] == '\\' && text[i + 1] != '\n' && text[i + 1] != '\0' ? 2 : 1;
    return text[i] == text[0] ? i + 1 : 1;
}

// The same lines with a blank for a comment or a tab, and with nothing between quotes.
static char *code_of(const char *text)
{
    char *code = text_copy(text), *end = code;
    for (size_t length; *text != '\0'; text += length) {
        const char *close = text_begins(text, "/*") ? strstr(text + 2, "*/") : NULL;
        length = *text == '"' || *text == '\'' ? length_of_quoted(text)
                 : text_begins(text, "//")     ? strcspn(text, "\n")
                 : close != NULL               ? (size_t)(close + 2 - text)
                 : text_begins(text, "/*")     ? strlen(text)
                                               : 1;
        *end++ = (*text == '/' && length > 1) || strchr("\t\r", *text) != NULL ? ' ' : *text;
        if (*text == '/')
            for (size_t i = 1; i < length; i++) {
                *end = '\n';
                end += text[i] == '\n';
            }
        else if (length > 1)
            *end++ = *text;
    }
    *end = '\0';
    return code;
}

// A function's first line:  vec3 upper_left(Camera c)  or, where the type was forgotten, from its
// name.
static bool begins_function(const char *code, OwnFunction *function)
{
    static const char typed[] = "^([A-Za-z_][A-Za-z_0-9 *]*[ *])([A-Za-z_0-9]+)\\((.*[^;])?$",
                      untyped[] = "^()([a-z_][a-z_0-9]*)\\([A-Za-z_0-9 *,]*\\) *\\{?$";
    Match match;
    if (!isalpha((unsigned char)code[0]) ||
        (!text_find(code, typed, &match) && !text_find(code, untyped, &match)) ||
        text_matches(code, "^(return|else) ") || text_word("if for while switch", match.group[2]))
        return false;
    function->name = match.group[2];
    function->type = bare_type(match.group[1]);
    return true;
}

// where: of a variable of the answer; NULL: of a field or a parameter in a header.
static void add_variable(Variables *list, const char *type, const char *stars, const char *name,
                         const Variable *where)
{
    list->item = text_grown(list->item, list->count, sizeof *list->item);
    Variable *variable = &list->item[list->count++];
    *variable = where != NULL ? *where : (Variable){.line = 0};
    variable->name = name;
    variable->type = type;
    variable->is_pointer = text_has(stars, "*");
}

// Adds what the code declares:  TYPE NAME, *NAME  in the answer with a type that is known.
static void add_declared(Variables *list, const char *code, const Variable *where)
{
    static const char declaration[] = "([A-Za-z_][A-Za-z_0-9]*)( +\\**| *\\*+ *)"
                                      "([A-Za-z_][A-Za-z_0-9]*)( +[^ (]|[^A-Za-z_0-9 (]|$)",
                      another[] = "^[^,;]*, *(\\**)([A-Za-z_][A-Za-z_0-9]*) *([[,;=])";
    for (Match match, next; list->count < MOST_VARIABLES && text_find(code, declaration, &match);) {
        const char *type = match.group[1], *stars = match.group[2], *name = match.group[3];
        code += match.at + strlen(type);
        if (where != NULL && !is_known_type(type))
            continue;
        add_variable(list, type, stars, name, where);
        code += strlen(stars) + strlen(name);
        const char *more = text_without_brackets(code);
        for (; text_find(more, another, &next) && !is_known_type(next.group[2]);
             more += next.end - 1)
            add_variable(list, type, next.group[1], next.group[2], where);
    }
}

static void read_variables(void)
{
    bool in_head = false; // of a function: its parameters
    for (size_t i = 1; i <= answer.last; i++) {
        const OwnFunction *function = answer_function(i);
        in_head = in_head || function->line == i;
        Variable where = {.line = i, .function = function->line, .is_parameter = in_head};
        add_declared(&answer.variables, answer.code[i], &where);
        in_head = in_head && !text_has(answer.code[i], ")");
    }
}

void answer_read(const char *source)
{
    answer = (Answer){.source = source};
    FILE *file = fopen(source, "rb");
    char *rest = text_read(file), *code = code_of(rest);
    if (file != NULL)
        fclose(file);
    size_t most = (size_t)text_count(rest, '\n') + 2;
    answer.text = text_memory(most * sizeof *answer.text);
    answer.code = text_memory(most * sizeof *answer.code);
    answer.functions = text_memory(most * sizeof *answer.functions);
    answer.functions[0] = (OwnFunction){.name = "", .type = ""};
    answer.in_function = text_memory(most * sizeof *answer.in_function);
    for (char *line; (line = strsep(&rest, "\n")) != NULL;) {
        size_t number = ++answer.count;
        answer.text[number] = line;
        line = strsep(&code, "\n");
        size_t length = strnlen(line, LONGEST_LINE);
        while (length > 0 && line[length - 1] == ' ')
            length--;
        line[length] = '\0';
        answer.code[number] = line;
        OwnFunction function = {.line = number};
        if (begins_function(line, &function))
            answer.functions[++answer.function_count] = function;
        answer.functions[answer.function_count].last = number;
        answer.in_function[number] = answer.function_count;
        if (line[0] != '\0')
            answer.last = number;
    }
    read_variables();
}

const char *answer_text(size_t line)
{
    return line >= 1 && line <= answer.count ? answer.text[line] : "";
}

const char *answer_code(size_t line)
{
    return line >= 1 && line <= answer.count ? answer.code[line] : "";
}

bool answer_includes(const char *header)
{
    for (size_t i = 1; i <= answer.count; i++)
        if (text_has(answer.text[i], header) &&
            text_is(text_group(answer.text[i], "^[ \t]*#[ \t]*include[ \t]*\"([^\"]*)", 1), header))
            return true;
    return false;
}

const OwnFunction *answer_function(size_t line)
{
    return &answer.functions[answer.in_function[line < answer.count ? line : answer.count]];
}

const OwnFunction *answer_function_named(const char *name)
{
    for (size_t i = answer.function_count; i > 0; i--)
        if (text_is(answer.functions[i].name, name))
            return &answer.functions[i];
    return NULL;
}

size_t answer_unclosed(void)
{
    int depth = 0;
    size_t last = 0;
    for (size_t i = 1; i <= answer.last; i++) {
        if (answer_function(i)->line == i) {
            if (depth > 0)
                break;
            last = i;
        }
        depth += text_count(answer.code[i], '{') - text_count(answer.code[i], '}');
    }
    return depth > 0 ? last : 0;
}

size_t answer_statement(size_t line)
{
    for (size_t least = line > LONGEST_STATEMENT ? line - LONGEST_STATEMENT : 1; line > least;
         line--)
        if (text_matches(answer_code(line - 1), "^$|^#|[;{}]$"))
            break;
    return line;
}

const char *answer_statement_text(size_t line)
{
    char *text = text_memory(2 * LONGEST_LINE), *end = text;
    line = answer_statement(line);
    for (size_t i = line; i <= answer.last && i < line + 2 * LONGEST_STATEMENT; i++) {
        *end++ = ' ';
        end = stpcpy(end, answer_code(i));
        if (end - text > LONGEST_LINE - 2 || text_matches(answer_code(i), "[;{}]$"))
            break;
    }
    return text;
}

size_t answer_code_before(size_t line)
{
    line = line > answer.count ? answer.count + 1 : line;
    while (line > 1 && answer_code(line - 1)[0] == '\0')
        line--;
    return line > 1 ? line - 1 : 0;
}

bool answer_ends_at_once(size_t line)
{
    return text_matches(text_without_brackets(answer_code(line)), BEFORE_WORD "(for|if|while) *;");
}

size_t answer_loop_of(const char *name, size_t line)
{
    static const char loop[] = BEFORE_WORD "for *\\( *[A-Za-z_0-9]+[ *]+([A-Za-z_0-9]+) *=";
    size_t first = answer_function(line)->line;
    Match match;
    for (line = line < answer.count ? line : answer.count; line > first; line--)
        for (const char *code = answer_code(line);
             text_has(code, name) && text_find(code, loop, &match); code += match.end)
            if (text_is(match.group[2], name))
                return line;
    return 0;
}

const char *answer_decimal_comma(size_t line)
{
    return text_group(text_format("%s ", answer_statement_text(line)),
                      "[^A-Za-z_0-9.,]([0-9]+,[0-9]+)([^A-Za-z_0-9.,]|, )", 1);
}

// ---- the headers that an answer may include ----------------------------------------------------

// The headers are ours, and laid out by clang-format: a declaration begins in the first column,
// lines inside braces do not.

static Declared *add_name(const char *name, const char *header, enum Kind kind)
{
    headers.item = text_grown(headers.item, headers.count, sizeof *headers.item);
    headers.item[headers.count] = (Declared){.kind = kind,
                                             .name = name,
                                             .header = header,
                                             .prototype = "",
                                             .type = "",
                                             .parts = "",
                                             .values = ""};
    return &headers.item[headers.count++];
}

// "double x, y; const Sphere *spheres; double t[2]; void (*progress)(const Image *image);"
static void read_fields(Declared *type, const char *content)
{
    content = text_replaced(text_replaced(content, "\\)\\([^)]*\\)", ""), "\\(\\*", "*");
    add_declared(&type->fields, text_replaced(content, "const ", ""), NULL);
    for (size_t i = 0; i < type->fields.count; i++)
        type->parts =
            text_format("%s%s%s", type->parts, i == 0 ? "" : ", ", type->fields.item[i].name);
}

static void read_values(const char *name, const char *content, const char *header)
{
    size_t type = headers.count;
    add_name(name, header, TYPE);
    content = text_replaced(content, "=[^,]*", "");
    Match value;
    for (int i = 1; text_find(content, "[A-Za-z_0-9]+", &value); i++) {
        const char **values = &headers.item[type].values;
        if (i <= 4)
            *values =
                text_format("%s%s%s", *values, i == 1 ? "" : ", ", i == 4 ? "..." : value.group[0]);
        add_name(value.group[0], header, ANYTHING);
        content += value.end;
    }
}

// To its closing brace or bracket.
static void read_declaration(const char *code, const char *header)
{
    const char *inside = strchr(code, '{'), *end = strrchr(code, '}'),
               *arguments = strchr(code, '(');
    Match match;
    if (text_find(code, "^#define ([A-Za-z_0-9]+)", &match))
        add_name(match.group[1], header, ANYTHING);
    else if (end != NULL && text_find(code, "^[a-z ]*(struct|enum) *([A-Za-z]*) *\\{", &match)) {
        const char *name = text_group(end, "[A-Za-z_0-9]+", 0),
                   *content = text_part(inside, 1, (size_t)(end - inside) - 1);
        name = name[0] != '\0' ? name : match.group[2];
        if (text_is(match.group[1], "enum"))
            read_values(name, content, header);
        else
            read_fields(add_name(name, header, TYPE), content);
    } else if (text_begins(code, "typedef ")) {
        code = text_replaced(code, " *(__attribute__|\\(|;).*", "");
        add_name(text_group(code, "[A-Za-z_0-9]+$", 0), header, ANYTHING);
    } else if (arguments != NULL &&
               text_find(text_part(code, 0, (size_t)(arguments - code)),
                         "^(static inline )?([A-Za-z_].*[ *])([A-Za-z_0-9]+)$", &match)) {
        Declared *function = add_name(match.group[3], header, FUNCTION);
        arguments = text_part(arguments, 0, strcspn(arguments, ")") + 1);
        function->type = bare_type(match.group[2]);
        function->prototype = text_replaced(
            text_format("%s%s%s", match.group[2], match.group[3], arguments), "  +", " ");
        add_declared(&function->fields, text_replaced(arguments, "const ", ""), NULL);
    }
}

static void read_header(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *rest = code_of(text_read(file));
    if (file != NULL)
        fclose(file);
    for (const char *line; (line = strsep(&rest, "\n")) != NULL;) {
        if (!isalpha((unsigned char)line[0]) && line[0] != '#')
            continue;
        // To its closing bracket or brace.
        for (const char *more; text_count(line, '{') + text_count(line, '(') >
                                   text_count(line, '}') + text_count(line, ')') &&
                               (more = strsep(&rest, "\n")) != NULL;)
            line = text_format("%s %s", line, more);
        read_declaration(line, path);
    }
}

static void read_folder(const char *folder)
{
    DIR *files = opendir(folder);
    if (files == NULL)
        return;
    Lines paths = {NULL, 0};
    for (const struct dirent *file; (file = readdir(files)) != NULL;)
        if (text_matches(file->d_name, "^[^.].*\\.h$"))
            lines_add(&paths, text_format("%s/%s", folder, file->d_name));
    closedir(files);
    lines_sort(&paths);
    for (size_t i = 0; i < paths.count; i++)
        read_header(paths.line[i]);
}

void headers_read(const char *contract)
{
    headers = (Headers){.contract = contract};
    read_folder("exercises");
    read_folder("common");
}

const Declared *declared(const char *name, enum Kind kind)
{
    static const Declared nothing = {ANYTHING, "", "", "", "", {NULL, 0}, "", ""};
    for (size_t i = name[0] == '\0' ? 0 : headers.count; i > 0; i--)
        if (text_is(headers.item[i - 1].name, name) &&
            (kind == ANYTHING || headers.item[i - 1].kind == kind))
            return &headers.item[i - 1];
    return &nothing;
}

const Variable *declared_field(const char *type, const char *field)
{
    const Variables *fields = &declared(type, TYPE)->fields;
    for (size_t i = 0; i < fields->count; i++)
        if (text_is(fields->item[i].name, field))
            return &fields->item[i];
    return NULL;
}

// ---- what is known in a line -------------------------------------------------------------------

const Variable *variable_named(const char *name, size_t line)
{
    for (size_t i = answer.variables.count; i > 0; i--) {
        const Variable *variable = &answer.variables.item[i - 1];
        if (variable->line <= line && variable->function == answer_function(line)->line &&
            text_is(variable->name, name))
            return variable;
    }
    return NULL;
}

const Variable *variable_after(const Variable *before, size_t line)
{
    size_t i = before == NULL ? 0 : (size_t)(before - answer.variables.item) + 1;
    for (; i < answer.variables.count; i++)
        if (variable_named(answer.variables.item[i].name, line) == &answer.variables.item[i])
            return &answer.variables.item[i];
    return NULL;
}

bool is_number(const char *type)
{
    return text_is(type, "unsigned int") ||
           text_word("double float int long unsigned _Bool bool", type) != NULL;
}

bool is_vector_type(const char *type)
{
    return text_word("vec3 Color", type) != NULL;
}

bool is_known_type(const char *type)
{
    return text_word("double int float bool vec3 Color", type) != NULL ||
           declared(type, TYPE)->name[0] != '\0';
}

const char *bare_type(const char *type)
{
    type = text_replaced(type, "(const|struct|static|inline|extern) ", "");
    return text_group(type, "[^ ](.*[^ ])?", 0);
}

const char *type_of(const char *expression, size_t line)
{
    static const char part[] = "^(.*)(\\.|->)([A-Za-z_0-9]+)$";
    if (strlen(expression) > 200) // nobody writes it
        return "";
    bool is_element = text_matches(expression, "\\]$");
    expression = text_replaced(expression, "\\[[^]]*\\]", "");
    const char *name = text_group(expression, part, 3);
    const Variable *found =
        name[0] == '\0' ? variable_named(expression, line)
                        : declared_field(type_of(text_group(expression, part, 1), line), name);
    const char *type = found == NULL ? "" : found->type;
    return is_element && text_is(type, "vec3") ? "double" : type;
}

const char *type_of_function(const char *name)
{
    const Declared *function = declared(name, FUNCTION);
    const OwnFunction *own = answer_function_named(name);
    return function->name[0] != '\0' || own == NULL ? function->type : own->type;
}

const char *type_of_argument(const char *expression, size_t line)
{
    expression = text_group(expression, "[^ *&-](.*[^ ])?", 0);
    if (text_matches(expression, "^[0-9.][0-9.e]*$"))
        return strpbrk(expression, ".e") != NULL ? "double" : "int";
    const char *function = text_group(expression, "^([A-Za-z_0-9]+) *\\(.*\\)$", 1),
               *literal = text_group(expression, "^\\(([A-Za-z0-9]+)\\) *\\{.*\\}$", 1);
    if (function[0] != '\0' || literal[0] != '\0')
        return literal[0] != '\0' ? literal : type_of_function(function);
    return text_is(text_expression_at_end(expression), expression) ? type_of(expression, line) : "";
}
