// explain_scope.c - what the explainer knows besides the compiler's words: the answer, what the
// headers declare, and the names, types and letters of the deck that are known in a line.

#include "tests/course/explain_inside.h"

#include <ctype.h>
#include <dirent.h>
#include <stdlib.h>
#include <string.h>

Answer answer;
Headers headers;

// ---- the answer --------------------------------------------------------------------------------

// ---- reading -----------------------------------------------------------------------------------

// The code of a line: no comments, nothing between quotes, blanks for tabs. in_comment: of /* */.
static const char *code_of(const char *line, bool *in_comment)
{
    static const char token[] = "^(/\\*|//.*|\"(\\\\.|[^\"\\])*\"|'(\\\\.|[^'\\])'|.)";
    char *code = text_memory(strnlen(line, LONGEST_CODE) + 4);
    size_t size = 0;
    Match match;
    while (line[0] != '\0' && size < LONGEST_CODE) {
        if (*in_comment) {
            const char *end = strstr(line, "*/");
            *in_comment = end == NULL;
            line = end == NULL ? "" : end + 2;
            continue;
        }
        bool is_slash = line[0] == '/',
             is_long = text_find(line, token, &match) && match.length > 1;
        *in_comment = is_slash && is_long && line[1] == '*';
        if (is_slash && is_long) {
            code[size] = ' ';
            size += *in_comment;
        } else if (is_long) {
            code[size++] = line[0];
            code[size] = ' ';
            size += line[0] == '\'';
            code[size++] = line[0];
        } else
            code[size++] = line[0] == '\t' || line[0] == '\r' ? ' ' : line[0];
        line += match.length;
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
    static const char typed[] = "^([A-Za-z_][A-Za-z_0-9 *]*[ *])([A-Za-z_0-9]+)\\((.*[^;])?$",
                      untyped[] = "^()([a-z_][a-z_0-9]*)\\([A-Za-z_0-9 *,]*\\) *\\{?$";
    const char *pattern = text_matches(code, typed) ? typed : untyped;
    function->name = text_group(code, pattern, 2);
    function->type = bare_type(text_group(code, pattern, 1));
    return function->name[0] != '\0' && !text_matches(code, "^(return|else) ") &&
           !text_is_one_of(function->name, "if for while switch");
}

static void read_include(const char *line)
{
    const char *name = text_group(line, "^[ \t]*#[ \t]*include[ \t]*\"([^\"]*)", 1);
    if (name[0] != '\0')
        lines_add(&answer.included, name);
}

void answer_read(const char *source)
{
    answer = (Answer){.source = source};
    char *rest = text_of_file(source);
    if (rest == NULL)
        return;
    size_t most = (size_t)text_count(rest, '\n') + 2;
    answer.text = text_memory(most * sizeof *answer.text);
    answer.code = text_memory(most * sizeof *answer.code);
    answer.functions = text_memory(most * sizeof *answer.functions);
    bool in_comment = false;
    for (char *line; (line = text_next_line(&rest)) != NULL;) {
        size_t number = ++answer.count;
        read_include(line);
        answer.text[number] = line;
        answer.code[number] = code_of(line, &in_comment);
        OwnFunction function = {.line = number};
        if (begins_function(answer.code[number], &function))
            answer.functions[answer.function_count++] = function;
        if (answer.code[number][0] != '\0')
            answer.last = number;
    }
}

// ---- lines and functions -----------------------------------------------------------------------

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
    for (size_t i = 0; i < answer.included.count; i++)
        if (text_is(answer.included.line[i], header))
            return true;
    return false;
}

static const OwnFunction *function_around(size_t line)
{
    const OwnFunction *around = NULL;
    for (size_t i = 0; i < answer.function_count && answer.functions[i].line <= line; i++)
        around = &answer.functions[i];
    return around;
}

const OwnFunction *answer_function_at(size_t line)
{
    const OwnFunction *around = function_around(line);
    return around != NULL && around->line == line ? around : NULL;
}

const OwnFunction *answer_function_named(const char *name)
{
    for (size_t i = answer.function_count; i > 0; i--)
        if (text_is(answer.functions[i - 1].name, name))
            return &answer.functions[i - 1];
    return NULL;
}

size_t answer_beginning(size_t line)
{
    const OwnFunction *around = function_around(line);
    return around != NULL ? around->line : 0;
}

const char *answer_function_around(size_t line)
{
    const OwnFunction *around = function_around(line);
    return around != NULL ? around->name : "";
}

size_t answer_unclosed(void)
{
    int depth = 0;
    size_t last = 0;
    for (size_t i = 1; i <= answer.last; i++) {
        if (answer_function_at(i) != NULL) {
            if (depth > 0)
                break;
            last = i;
        }
        depth += text_count(answer.code[i], '{') - text_count(answer.code[i], '}');
    }
    return depth > 0 ? last : 0;
}

// ---- statements --------------------------------------------------------------------------------

static bool ends_statement(const char *code)
{
    return code[0] != '\0' && strchr(";{}", code[strlen(code) - 1]) != NULL;
}

size_t answer_statement(size_t line)
{
    for (size_t least = line > LONGEST_STATEMENT ? line - LONGEST_STATEMENT : 1; line > least;
         line--) {
        const char *before = answer_code(line - 1);
        if (before[0] == '\0' || before[0] == '#' || ends_statement(before))
            break;
    }
    return line;
}

const char *answer_statement_text(size_t line)
{
    size_t first = answer_statement(line), end = first, length = 1;
    while (end <= answer.last && end < first + 2 * LONGEST_STATEMENT) {
        const char *code = answer_code(end++);
        length += 1 + strlen(code);
        if (ends_statement(code))
            break;
    }
    char *text = text_memory(length), *at = text;
    for (size_t i = first; i < end; i++) {
        *at++ = ' ';
        at = stpcpy(at, answer_code(i));
    }
    return text;
}

size_t answer_code_before(size_t line)
{
    if (line > answer.count)
        line = answer.count + 1;
    for (line -= line > 0; line > 0; line--) {
        const char *code = answer_code(line);
        if (code[text_span(code, " ")] != '\0')
            return line;
    }
    return 0;
}

int answer_brackets(size_t line)
{
    const char *text = answer_statement_text(line);
    return text_count(text, '(') - text_count(text, ')');
}

bool answer_ends_at_once(size_t line)
{
    const char *code = answer_code(line);
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
    static const char declaration[] =
        "(^|[^A-Za-z_0-9])for *\\( *[A-Za-z_0-9]+[ *]+([A-Za-z_0-9]+) *=";
    Match match;
    for (; text_find(code, declaration, &match); code += match.at + match.length)
        if (text_is(text_group(code, declaration, 2), name))
            return true;
    return false;
}

size_t answer_loop_of(const char *name, size_t line)
{
    size_t first = answer_beginning(line);
    if (line > answer.count)
        line = answer.count;
    while (line > first && !loop_declares(answer_code(line), name))
        line--;
    return line > first ? line : 0;
}

const char *answer_decimal_comma(size_t line)
{
    return text_group(text_format("%s ", answer_statement_text(line)),
                      "[^A-Za-z_0-9.,]([0-9]+,[0-9]+)([^A-Za-z_0-9.,]|, )", 1);
}

// ---- the headers that an answer may include ----------------------------------------------------

// The headers are ours, and laid out by clang-format: a declaration begins in the first column,
// lines inside braces do not.

// ---- lists that grow ---------------------------------------------------------------------------

static void *grown(void *list, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return list;
    *room = *room == 0 ? 64 : 2 * *room;
    void *larger = text_memory(*room * size);
    if (count > 0)
        memcpy(larger, list, count * size);
    return larger;
}

static void add_name(const char *name, const char *header)
{
    if (name[0] == '\0')
        return;
    headers.names =
        grown(headers.names, headers.name_count, &headers.name_room, sizeof *headers.names);
    headers.names[headers.name_count++] = (DeclaredName){name, header};
}

// ---- structs and enums -------------------------------------------------------------------------

#define NO_COMMENT "[ \t]*//.*"

static const char *letters_of(const char *text)
{
    return text_replaced(text, "[^A-Za-z_0-9]+", "");
}

// "double x, y", "const Sphere *spheres", "double t[2]", "void (*progress)(const Image *image)".
static void read_fields(DeclaredType *type, const char *declaration)
{
    declaration = text_replaced(declaration, "[ \t]+", " ");
    declaration = text_without(declaration, "^ ?(const )?");
    const char *function = text_group(declaration, "\\(\\*([a-z_]+)\\)", 1);
    if (function[0] != '\0')
        declaration = text_format("function %s", function);
    size_t kind = strcspn(declaration, " ");
    if (kind == 0 || declaration[kind] == '\0' || declaration[kind + 1] == '\0')
        return;
    for (const char *at = declaration + kind; at != NULL;) {
        size_t length = strcspn(at, ",");
        const char *field = text_part(at, 0, length);
        field = text_part(field, 0, strcspn(field, "["));
        const char *name = letters_of(field);
        type->parts = text_format("%s%s%s", type->parts, type->parts[0] != '\0' ? ", " : "", name);
        type->fields[type->field_count++] =
            (Field){name, text_part(declaration, 0, kind), text_has(field, "*")};
        at = at[length] == ',' ? at + length + 1 : NULL;
    }
}

static void read_struct(DeclaredType *type, const char *content)
{
    type->fields = text_memory((size_t)(text_count(content, ',') + text_count(content, ';') + 1) *
                               sizeof(Field));
    for (const char *end; (end = strchr(content, ';')) != NULL; content = end + 1)
        read_fields(type, text_part(content, 0, (size_t)(end - content)));
}

static void read_enum(DeclaredType *type, const char *content)
{
    content = text_replaced(text_replaced(content, "=[^,]*", ""), " +", "");
    for (int i = 1; content[0] != '\0'; i++) {
        size_t length = strcspn(content, ",");
        const char *name = text_part(content, 0, length);
        content += length + (content[length] == ',');
        add_name(name, type->header);
        if (i <= 3)
            type->values = text_format("%s%s%s%s", type->values, i > 1 ? ", " : "", name,
                                       i == 3 && content[0] != '\0' ? ", ..." : "");
    }
}

// From  typedef struct {  or  enum Tag {  to the closing brace and its name.
static void read_type(const char *line, size_t length, char **rest, const char *header)
{
    bool is_enum = text_has(text_part(line, 0, length), "enum");
    const char *tag = letters_of(text_group(line, "(struct|enum)([^{]*)", 2));
    const char *content = line + length;
    for (char *more; !text_has(content, "}") && (more = text_next_line(rest)) != NULL;)
        content = text_format("%s %s", content, text_without(more, NO_COMMENT));
    size_t inside = strcspn(content, "}");
    const char *name = letters_of(text_from(content, inside));
    DeclaredType type = {
        .name = name[0] != '\0' ? name : tag, .header = header, .parts = "", .values = ""};
    add_name(type.name, header);
    content = text_part(content, 0, inside);
    if (is_enum)
        read_enum(&type, content);
    else
        read_struct(&type, content);
    if (type.name[0] == '\0')
        return;
    headers.types =
        grown(headers.types, headers.type_count, &headers.type_room, sizeof *headers.types);
    headers.types[headers.type_count++] = type;
}

// ---- functions and other names -----------------------------------------------------------------

static void read_function(const char *line, char **rest, const char *header)
{
    line = text_without(line, "^static inline ");
    for (char *more; !text_has(line, ")") && (more = text_next_line(rest)) != NULL;)
        line = text_format("%s%s", line, more);
    line = text_replaced(text_part(line, 0, strcspn(line, ")") + 1), "  +", " ");
    static const char parts[] = "^(.*[^A-Za-z_0-9])([A-Za-z_0-9]+)(\\(.*)$";
    DeclaredFunction function = {.name = text_group(line, parts, 2),
                                 .header = header,
                                 .prototype = line,
                                 .arguments = text_group(line, parts, 3),
                                 .type = bare_type(text_group(line, parts, 1))};
    add_name(function.name, header);
    headers.functions = grown(headers.functions, headers.function_count, &headers.function_room,
                              sizeof *headers.functions);
    headers.functions[headers.function_count++] = function;
}

static void read_typedef(const char *line, const char *header)
{
    line = text_without(line, " *(__attribute__|\\(|;).*");
    const char *last = strrchr(line, ' ');
    add_name(last == NULL ? line : last + 1, header);
}

static void read_header(const char *header)
{
    char *rest = text_of_file(header);
    if (rest == NULL)
        return;
    for (const char *line; (line = text_next_line(&rest)) != NULL;) {
        Match match;
        if (!isalpha((unsigned char)line[0]) && line[0] != '#')
            continue;
        line = text_without(line, NO_COMMENT);
        if (text_begins(line, "#define ")) {
            const char *name = line + strlen("#define ");
            add_name(text_part(name, 0, text_span_of_word(name)), header);
        } else if (text_has(line, "{") &&
                   text_find(line, "^[a-z ]*(struct|enum)[A-Za-z ]*\\{", &match))
            read_type(line, match.length, &rest, header);
        else if (text_begins(line, "typedef "))
            read_typedef(line, header);
        else if (text_has(line, "(") &&
                 text_matches(line, "^[A-Za-z_][A-Za-z_0-9 *]*[ *][A-Za-z_0-9]+\\("))
            read_function(line, &rest, header);
    }
}

static int by_name(const void *left, const void *right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

static void read_folder(const char *folder)
{
    DIR *files = opendir(folder);
    if (files == NULL)
        return;
    Lines paths = {NULL, 0};
    for (const struct dirent *file; (file = readdir(files)) != NULL;) {
        size_t length = strlen(file->d_name);
        if (file->d_name[0] != '.' && length > 2 && text_is(file->d_name + length - 2, ".h"))
            lines_add(&paths, text_format("%s/%s", folder, file->d_name));
    }
    closedir(files);
    if (paths.count > 0)
        qsort(paths.line, paths.count, sizeof *paths.line, by_name);
    for (size_t i = 0; i < paths.count; i++)
        read_header(paths.line[i]);
}

void headers_read(const char *contract)
{
    headers = (Headers){.contract = contract};
    read_folder("exercises");
    read_folder("common");
}

// ---- asking ------------------------------------------------------------------------------------

const char *header_of(const char *name)
{
    for (size_t i = headers.name_count; i > 0; i--)
        if (text_is(headers.names[i - 1].name, name))
            return headers.names[i - 1].header;
    return NULL;
}

static bool is_constant(const char *name)
{
    return text_matches(name, "^[A-Z][A-Z_0-9]+$");
}

const DeclaredName *header_name_like(const char *name, bool is_type)
{
    for (size_t i = 0; i < headers.name_count; i++) {
        const DeclaredName *other = &headers.names[i];
        if (strcasecmp(other->name, name) == 0 && !text_is(other->name, name) &&
            (is_type || is_constant(other->name)) &&
            (!text_begins(other->header, "exercises") ||
             strcmp(other->header, headers.contract) <= 0))
            return other;
    }
    return NULL;
}

const DeclaredFunction *header_function(const char *name)
{
    for (size_t i = headers.function_count; i > 0; i--)
        if (text_is(headers.functions[i - 1].name, name))
            return &headers.functions[i - 1];
    return NULL;
}

static const DeclaredType *type_named(const char *name)
{
    for (size_t i = headers.type_count; i > 0; i--)
        if (text_is(headers.types[i - 1].name, name))
            return &headers.types[i - 1];
    return NULL;
}

static bool header_type(const char *name)
{
    return text_is_one_of(name, "double int float bool vec3 Color") || type_named(name) != NULL;
}

const char *header_parts(const char *type)
{
    const DeclaredType *declared = type_named(type);
    return declared != NULL ? declared->parts : "";
}

const Field *header_field(const char *type, const char *field)
{
    const DeclaredType *declared = type_named(type);
    for (size_t i = 0; declared != NULL && i < declared->field_count; i++)
        if (text_is(declared->fields[i].name, field))
            return &declared->fields[i];
    return NULL;
}

const char *header_values(const char *type)
{
    const DeclaredType *declared = type_named(type);
    return declared != NULL ? declared->values : "";
}

Lines header_parameter_types(const char *arguments)
{
    Lines types = {NULL, 0};
    const char *at = arguments + (arguments[0] == '(');
    for (size_t length; at != NULL && at[0] != '\0' && at[0] != ')';
         at = at[length] == ',' ? at + length + 1 : NULL) {
        length = strcspn(at, ",)");
        const char *type = text_without(text_part(at, 0, length), "^ *(const )?");
        lines_add(&types, text_part(type, 0, strcspn(type, " *")));
    }
    return types;
}

// ---- declarations ------------------------------------------------------------------------------

// A declaration in a line: the type begins at type, the name at name; both end with the word.
typedef struct {
    size_t type, name;
    bool is_pointer;
} Declaration;

// The next TYPE NAME, TYPE *NAME from this place on.
static bool next_declaration(const char *line, size_t from, Declaration *found)
{
    for (size_t at = from; line[at] != '\0';) {
        size_t length = text_span_of_word(line + at);
        if (length == 0) {
            at++;
            continue;
        }
        size_t name = at + length + text_span(line + at + length, " *");
        if (name > at + length && is_word_character(line[name]) &&
            strchr("0123456789", line[name]) == NULL && header_type(text_part(line, at, length))) {
            *found = (Declaration){at, name,
                                   memchr(line + at + length, '*', name - at - length) != NULL};
            return true;
        }
        at += length;
    }
    return false;
}

static const char *word_at(const char *line, size_t at)
{
    return text_part(line, at, text_span_of_word(line + at));
}

bool begins_declaration(const char *text)
{
    Declaration found;
    return next_declaration(text, 0, &found) && found.type == 0 && !found.is_pointer;
}

static void put_in_scope(Scope *scope, Variable variable)
{
    size_t i = 0;
    while (i < scope->count && !text_is(scope->variables[i].name, variable.name))
        i++;
    scope->variables[i] = variable;
    scope->count += i == scope->count;
}

Scope scope_of(size_t line)
{
    size_t first = answer_beginning(line), last = line < answer.count ? line : answer.count;
    if (last > first + LONGEST_FUNCTION)
        last = first + LONGEST_FUNCTION;
    size_t most = 0;
    for (size_t i = first; first > 0 && i <= last; i++)
        most += strlen(answer.code[i]);
    Scope scope = {.variables = text_memory((most / 3 + 1) * sizeof(Variable))};
    bool closed = false; // the ) of the parameters
    for (size_t i = first; first > 0 && i <= last; i++) {
        const char *text = answer.code[i];
        size_t at = 0;
        for (Declaration found; next_declaration(text, at, &found);) {
            at = found.name + text_span_of_word(text + found.name);
            if (text[at + text_span(text + at, " ")] != '(')
                put_in_scope(&scope, (Variable){word_at(text, found.name),
                                                word_at(text, found.type), found.is_pointer});
        }
        if (!closed)
            scope.parameters = scope.count;
        closed = closed || text_has(text + at, ")");
    }
    return scope;
}

// ---- types -------------------------------------------------------------------------------------

bool is_number(const char *type)
{
    return text_is(type, "unsigned int") ||
           text_is_one_of(type, "double float int long unsigned _Bool bool");
}

bool is_vector_type(const char *type)
{
    return text_is_one_of(type, "vec3 Color");
}

const char *with_article(const char *type)
{
    return text_format("%s %s",
                       type[0] != '\0' && strchr("AEIOUaeiou", type[0]) != NULL ? "an" : "a", type);
}

const char *written(const char *type)
{
    if (text_is(type, "vec3"))
        return "vec3_of(x," UNBROKEN "y," UNBROKEN "z)";
    if (text_is(type, "Color"))
        return "vec3_of(r," UNBROKEN "g," UNBROKEN "b)";
    const char *parts = header_parts(type);
    return parts[0] == '\0' ? ""
                            : text_replaced(text_format("(%s){%s}", type, parts), " ", UNBROKEN);
}

// Without everything in brackets, innermost first.
const char *without_brackets(const char *line)
{
    while (text_matches(line, "\\([^()]*\\)"))
        line = text_replaced(line, "\\([^()]*\\)", "");
    return line;
}

// One of several:  vec3 p = f(x), v = g(y);
static bool declares_among_others(const char *line, const char *name, const char **type)
{
    size_t at = text_span(line, " ");
    if (at == 0)
        return false;
    if (text_begins(line + at, "const "))
        at += strlen("const ");
    *type = word_at(line, at);
    if (line[at + strlen(*type)] != ' ' || !header_type(*type))
        return false;
    line = without_brackets(line);
    for (const char *comma = line; (comma = strchr(comma, ',')) != NULL;) {
        comma++;
        if (text_is(word_at(comma, text_span(comma, " ")), name))
            return true;
    }
    return false;
}

// A struct's field with its type, or the declaration of a variable.
static const char *type_of_name(const char *name, size_t line)
{
    size_t first = answer_beginning(line);
    if (line > answer.count)
        line = answer.count;
    if (line > first + LONGEST_FUNCTION)
        first = line - LONGEST_FUNCTION;
    for (; line >= first && line > 0; line--) {
        const char *text = answer.code[line], *type;
        size_t at = 0;
        for (Declaration found; next_declaration(text, at, &found);) {
            if (text_is(word_at(text, found.name), name))
                return word_at(text, found.type);
            at = found.name;
        }
        if (declares_among_others(text, name, &type))
            return type;
    }
    return "";
}

const char *type_of(const char *expression, size_t line)
{
    bool element = expression[0] != '\0' && expression[strlen(expression) - 1] == ']';
    expression = text_replaced(expression, "\\[[^]]*\\]", "");
    size_t end = strlen(expression), begin = end;
    while (begin > 0 && expression[begin - 1] != '.' && expression[begin - 1] != '>')
        begin--;
    const char *name = expression + begin, *type = "";
    if (begin > 0) {
        size_t sign = expression[begin - 1] == '.' ? 1 : 2;
        if (begin < sign || (sign == 2 && expression[begin - 2] != '-'))
            return "";
        const char *whole = text_part(expression, 0, begin - sign);
        const Field *field = header_field(type_of(whole, line), name);
        type = field != NULL ? field->type : "";
    } else if (name[0] != '\0' && name[text_span_of_word(name)] == '\0' &&
               strchr("0123456789", name[0]) == NULL)
        type = type_of_name(name, line);
    return element && text_is(type, "vec3") ? "double" : type;
}

const char *function_type(const char *function)
{
    const DeclaredFunction *declared = header_function(function);
    const OwnFunction *own = answer_function_named(function);
    return declared != NULL ? declared->type : own != NULL ? own->type : "";
}

const char *type_of_argument(const char *expression, size_t line)
{
    size_t length = strlen(expression += text_span(expression, " *&-"));
    while (length > 0 && expression[length - 1] == ' ')
        length--;
    expression = text_part(expression, 0, length);
    if (text_matches(expression, "^[0-9.][0-9.e]*$"))
        return strpbrk(expression, ".e") != NULL ? "double" : "int";
    if (text_matches(expression, "^[A-Za-z_0-9]+ *\\(.*\\)$"))
        return function_type(text_before(expression, "("));
    if (text_matches(expression, "^\\([A-Za-z0-9]+\\) *\\{.*\\}$"))
        return text_part(expression, 1, strcspn(expression, ")") - 1);
    return text_is(text_expression_at_end(expression), expression) ? type_of(expression, line) : "";
}

// ---- the deck's letters ------------------------------------------------------------------------

const char *part_of_deck(const char *type, const char *letter)
{
    static const struct {
        const char *type, *letter, *part;
    } deck[] = {
        {"Camera", "p", "origin"},    {"Camera", "r", "right"},    {"Camera", "u", "up"},
        {"Camera", "f", "forward"},   {"Camera", "d", "distance"}, {"Camera", "w", "width"},
        {"Camera", "h", "height"},    {"Ray", "p", "origin"},      {"Ray", "v", "direction"},
        {"Sphere", "c", "center"},    {"Sphere", "r", "radius"},   {"Resolution", "W", "width"},
        {"Resolution", "H", "height"}};
    for (size_t i = 0; i < sizeof deck / sizeof *deck; i++)
        if (text_is(deck[i].type, type) && text_is(deck[i].letter, letter))
            return deck[i].part;
    return "";
}

// A camera that is given as a pointer is made there: it has no parts yet.
static bool has_parts_yet(const Variable *variable)
{
    return !(text_is(variable->type, "Camera") && variable->is_pointer);
}

static const char *one_or_the_other(const char *found, const char *other)
{
    return found[0] == '\0' ? other : text_format("%s or %s", found, other);
}

static bool is_parameter_of_deck(const char *letter, const char *name)
{
    return (text_is(letter, "r") && text_is(name, "radius")) ||
           (text_is(letter, "d") && text_is(name, "distance")) ||
           (text_is(letter, "p") && text_is(name, "eye"));
}

const char *translated(const char *letter, size_t line, const char *others)
{
    Scope scope = scope_of(line);
    const char *found = "";
    for (size_t i = 0; i < scope.count; i++) {
        const Variable *variable = &scope.variables[i];
        const char *part = part_of_deck(variable->type, letter);
        // With a and b, c is that of the quadratic.
        if (text_is(letter, "c") && (text_has_word(others, "a") || text_has_word(others, "b")))
            part = "";
        if (part[0] != '\0' && has_parts_yet(variable))
            part = text_format("%s%s%s", variable->name, variable->is_pointer ? "->" : ".", part);
        else if (i < scope.parameters && is_parameter_of_deck(letter, variable->name))
            part = variable->name;
        else
            continue;
        found = one_or_the_other(found, part);
    }
    return found[0] == '\0' ? "" : text_format("%s" UNBROKEN "is" UNBROKEN "%s", letter, found);
}

static const char *add_whole(const char *found, const char *whole, const char *type,
                             const char **owner)
{
    *owner = found[0] == '\0' || text_is(*owner, type) ? type : "";
    return one_or_the_other(found, whole);
}

const char *whole_of(const char *part, size_t line, const char **owner)
{
    Scope scope = scope_of(line);
    const char *found = "";
    *owner = "";
    for (size_t i = 0; i < scope.count; i++) {
        const Variable *variable = &scope.variables[i];
        if (!has_parts_yet(variable))
            continue;
        const char *name = text_format("%s%s", variable->name, variable->is_pointer ? "->" : ".");
        if (header_field(variable->type, part) != NULL)
            found = add_whole(found, text_format("%s%s", name, part), variable->type, owner);
        // image->size.width
        for (size_t t = 0; t < headers.type_count; t++) {
            const DeclaredType *type = &headers.types[t];
            for (size_t k = 0; text_is(type->name, variable->type) && k < type->field_count; k++) {
                const Field *field = &type->fields[k];
                if (!field->is_pointer && header_field(field->type, part) != NULL)
                    found = add_whole(found, text_format("%s%s.%s", name, field->name, part),
                                      field->type, owner);
            }
        }
    }
    return found;
}
