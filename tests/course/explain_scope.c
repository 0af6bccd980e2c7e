// explain_scope.c - see explain_scope.h.
#include "tests/course/explain_scope.h"

#include <string.h>

// ---- declarations -------------------------------------------------------------------------------

// A declaration in a line: the type begins at type, the name at name; both end with the word.
typedef struct {
    size_t type, name;
    bool is_pointer;
} Declaration;

// The next TYPE NAME, TYPE *NAME from this place on.
static bool next_declaration(const Headers *headers, const char *line, size_t from,
                             Declaration *found)
{
    for (size_t at = from; line[at] != '\0';) {
        size_t length = text_span_of_word(line + at);
        if (length == 0) {
            at++;
            continue;
        }
        size_t name = at + length + text_span(line + at + length, " *");
        if (name > at + length && is_word_character(line[name]) &&
            strchr("0123456789", line[name]) == NULL &&
            header_type(headers, text_part(line, at, length))) {
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

bool begins_declaration(const Code *code, const char *text)
{
    Declaration found;
    return next_declaration(&code->headers, text, 0, &found) && found.type == 0 &&
           !found.is_pointer;
}

static void put_in_scope(Scope *scope, Variable variable)
{
    size_t i = 0;
    while (i < scope->count && !text_is(scope->variables[i].name, variable.name))
        i++;
    scope->variables[i] = variable;
    scope->count += i == scope->count;
}

Scope scope_of(const Code *code, size_t line)
{
    const Answer *answer = &code->answer;
    size_t first = answer_beginning(answer, line),
           last = line < answer->count ? line : answer->count;
    if (last > first + LONGEST_FUNCTION)
        last = first + LONGEST_FUNCTION;
    size_t most = 0;
    for (size_t i = first; first > 0 && i <= last; i++)
        most += strlen(answer->code[i]);
    Scope scope = {.variables = text_memory((most / 3 + 1) * sizeof(Variable))};
    bool closed = false; // the ) of the parameters
    for (size_t i = first; first > 0 && i <= last; i++) {
        const char *text = answer->code[i];
        size_t at = 0;
        for (Declaration found; next_declaration(&code->headers, text, at, &found);) {
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

// ---- types --------------------------------------------------------------------------------------

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

const char *written(const Code *code, const char *type)
{
    if (text_is(type, "vec3"))
        return "vec3_of(x," UNBROKEN "y," UNBROKEN "z)";
    if (text_is(type, "Color"))
        return "vec3_of(r," UNBROKEN "g," UNBROKEN "b)";
    const char *parts = header_parts(&code->headers, type);
    return parts[0] == '\0' ? ""
                            : text_replaced(text_format("(%s){%s}", type, parts), " ", UNBROKEN);
}

// Without everything in brackets, innermost first.
static const char *without_brackets(const char *line)
{
    while (text_matches(line, "\\([^()]*\\)"))
        line = text_replaced(line, "\\([^()]*\\)", "");
    return line;
}

// One of several:  vec3 p = f(x), v = g(y);
static bool declares_among_others(const Code *code, const char *line, const char *name,
                                  const char **type)
{
    size_t at = text_span(line, " ");
    if (at == 0)
        return false;
    if (text_begins(line + at, "const "))
        at += strlen("const ");
    *type = word_at(line, at);
    if (line[at + strlen(*type)] != ' ' || !header_type(&code->headers, *type))
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
static const char *type_of_name(const Code *code, const char *name, size_t line)
{
    const Answer *answer = &code->answer;
    size_t first = answer_beginning(answer, line);
    if (line > answer->count)
        line = answer->count;
    if (line > first + LONGEST_FUNCTION)
        first = line - LONGEST_FUNCTION;
    for (; line >= first && line > 0; line--) {
        const char *text = answer->code[line], *type;
        size_t at = 0;
        for (Declaration found; next_declaration(&code->headers, text, at, &found);) {
            if (text_is(word_at(text, found.name), name))
                return word_at(text, found.type);
            at = found.name;
        }
        if (declares_among_others(code, text, name, &type))
            return type;
    }
    return "";
}

const char *type_of(const Code *code, const char *expression, size_t line)
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
        const Field *field = header_field(&code->headers, type_of(code, whole, line), name);
        type = field != NULL ? field->type : "";
    } else if (name[0] != '\0' && name[text_span_of_word(name)] == '\0' &&
               strchr("0123456789", name[0]) == NULL)
        type = type_of_name(code, name, line);
    return element && text_is(type, "vec3") ? "double" : type;
}

const char *function_type(const Code *code, const char *function)
{
    const DeclaredFunction *declared = header_function(&code->headers, function);
    const OwnFunction *own = answer_function_named(&code->answer, function);
    return declared != NULL ? declared->type : own != NULL ? own->type : "";
}

const char *type_of_argument(const Code *code, const char *expression, size_t line)
{
    size_t length = strlen(expression += text_span(expression, " *&-"));
    while (length > 0 && expression[length - 1] == ' ')
        length--;
    expression = text_part(expression, 0, length);
    if (text_matches(expression, "^[0-9.][0-9.e]*$"))
        return strpbrk(expression, ".e") != NULL ? "double" : "int";
    if (text_matches(expression, "^[A-Za-z_0-9]+ *\\(.*\\)$"))
        return function_type(code, text_before(expression, "("));
    if (text_matches(expression, "^\\([A-Za-z0-9]+\\) *\\{.*\\}$"))
        return text_part(expression, 1, strcspn(expression, ")") - 1);
    return text_is(text_expression_at_end(expression), expression) ? type_of(code, expression, line)
                                                                   : "";
}

// ---- the deck's letters -------------------------------------------------------------------------

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

const char *translated(const Code *code, const char *letter, size_t line, const char *others)
{
    Scope scope = scope_of(code, line);
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

const char *whole_of(const Code *code, const char *part, size_t line, const char **owner)
{
    Scope scope = scope_of(code, line);
    const char *found = "";
    *owner = "";
    for (size_t i = 0; i < scope.count; i++) {
        const Variable *variable = &scope.variables[i];
        if (!has_parts_yet(variable))
            continue;
        const char *name = text_format("%s%s", variable->name, variable->is_pointer ? "->" : ".");
        if (header_field(&code->headers, variable->type, part) != NULL)
            found = add_whole(found, text_format("%s%s", name, part), variable->type, owner);
        // image->size.width
        for (size_t t = 0; t < code->headers.type_count; t++) {
            const DeclaredType *type = &code->headers.types[t];
            for (size_t k = 0; text_is(type->name, variable->type) && k < type->field_count; k++) {
                const Field *field = &type->fields[k];
                if (!field->is_pointer && header_field(&code->headers, field->type, part) != NULL)
                    found = add_whole(found, text_format("%s%s.%s", name, field->name, part),
                                      field->type, owner);
            }
        }
    }
    return found;
}
