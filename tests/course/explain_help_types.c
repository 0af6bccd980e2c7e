// explain_help_types.c - help for a value of the wrong type, and for parts that it does not have.
#include "tests/course/explain_mistakes.h"

#include <string.h>

// ---- parts --------------------------------------------------------------------------------------

// The name after the dot or the arrow at the caret.
static const char *part_behind(const Mistake *mistake)
{
    const char *part = text_without(mistake->message->behind, "^(\\.|->) *");
    return text_part(part, 0, text_span_of_word(part));
}

const char *help_arrow(const Explanation *all, const Mistake *mistake)
{
    const Headers *headers = &all->code.headers;
    const char *name = text_expression_at_end(mistake->message->ahead),
               *part = part_behind(mistake);
    if (part[0] == '\0')
        return "";
    if (name[0] == '\0')
        return text_has(mistake->text, "did you mean to use '->'")
                   ? text_format("after a pointer comes -> and not a dot: ->%s.", part)
                   : "";
    const char *type = type_of(&all->code, name, mistake->line),
               *parts = header_parts(headers, type);
    if (parts[0] != '\0' && header_field(headers, type, part) == NULL)
        return text_format(
            "%s %s %s, whose parts are %s.%s", name,
            text_has(mistake->text, "to use '->'") ? "points to" : "is", with_article(type), parts,
            text_is(type, "Sphere") && header_field(headers, "Surface", part) != NULL
                ? text_format(" For its look, write scene_surface(scene, i)->%s.", part)
                : "");
    if (text_has(mistake->text, "did you mean to use '->'"))
        return text_format("%s is a pointer: write %s->%s.", name, name, part);
    return text_format("%s is not a pointer: write %s.%s.", name, name, part);
}

const char *help_parts(const Explanation *all, const Mistake *mistake)
{
    const char *ahead = mistake->message->ahead, *name = text_expression_at_end(ahead);
    const char *type = text_has(mistake->text, "base type")
                           ? bare_type(mistake->name)
                           : type_of(&all->code, name, mistake->line);
    if (ahead[0] != '\0' && ahead[strlen(ahead) - 1] == ' ')
        return "a dot is not a product in C: multiply numbers with *, and write v . w as "
               "vec3_dot(v, w).";
    if (is_vector_type(type))
        return "a vec3 has no named parts: its components are v[0], v[1], v[2].";
    if (!is_number(type))
        return "the value before the dot has no named parts: a number has none, and the components "
               "of "
               "a vec3 are v[0], v[1], v[2].";
    const char *owner, *part = part_behind(mistake);
    const char *whole = whole_of(&all->code, part, mistake->line, &owner);
    const char *number =
        text_format("%s is a number and has no parts.", name[0] == '\0' ? "this" : name);
    if (whole[0] == '\0')
        return number;
    return text_format("%s %s is a part of %s. Write %s.", number, part,
                       owner[0] == '\0' ? "others" : with_article(owner), whole);
}

const char *help_member(const Explanation *all, const Mistake *mistake)
{
    const Headers *headers = &all->code.headers;
    bool type_first = mistake->text[0] == '\'';
    const char *type = bare_type(type_first ? mistake->name : quoted_second(mistake->text));
    const char *parts = header_parts(headers, type);
    if (parts[0] == '\0')
        return "";
    const char *letters = all->about[mistake->begins].letters;
    return text_format(
        "the parts of %s are %s (%s).%s", with_article(type), parts, header_of(headers, type),
        mistake->translation[0] == '\0' ? "" : text_format(" The slide's %s.", letters));
}

// ---- the order of arguments ---------------------------------------------------------------------

// The arguments of a call, from after its bracket on.
static Lines arguments_of(const char *text)
{
    Lines arguments = {NULL, 0};
    int depth = 0;
    size_t begin = 0, i = 0;
    for (; text[i] != '\0'; i++) {
        depth += (strchr("({[", text[i]) != NULL) - (strchr(")}]", text[i]) != NULL);
        if (depth < 0)
            break;
        if (text[i] == ',' && depth == 0) {
            lines_add(&arguments, text_part(text, begin, i - begin));
            begin = i + 1;
        }
    }
    lines_add(&arguments, text_part(text, begin, i - begin));
    return arguments;
}

static const char *number_is_double(const char *type)
{
    return is_number(type) ? "double" : type;
}

static size_t how_many(const Lines *types, const char *type)
{
    size_t count = 0;
    for (size_t i = 0; i < types->count; i++)
        count += text_is(types->line[i], type);
    return count;
}

// Two arguments that have each other's types, or all types that are wanted in another order.
static bool is_other_order(const Lines *given, const Lines *wanted)
{
    bool same_types = true, same_order = true;
    for (size_t k = 0; k < wanted->count; k++) {
        for (size_t l = 0; l < k; l++)
            if (text_is(given->line[k], wanted->line[l]) &&
                text_is(given->line[l], wanted->line[k]) &&
                !text_is(given->line[k], given->line[l]))
                return true;
        same_types =
            same_types && how_many(given, wanted->line[k]) == how_many(wanted, wanted->line[k]);
        same_order = same_order && text_is(given->line[k], wanted->line[k]);
    }
    return same_types && !same_order;
}

// Whether a call of this function, in this statement, has its arguments in another order than the
// prototype.
static bool is_swapped(const Explanation *all, const DeclaredFunction *called, size_t line)
{
    enum { MOST = 20 };
    const char *text = answer_statement_text(&all->code.answer, line);
    Lines types = header_parameter_types(called->arguments), wanted = {NULL, 0};
    for (size_t k = 0; k < types.count; k++)
        lines_add(&wanted, number_is_double(types.line[k]));
    for (const char *at = text; (at = strstr(at, called->name)) != NULL;) {
        const char *next = at + strlen(called->name);
        bool is_whole = at > text && !is_word_character(at[-1]);
        next += text_span(next, " ");
        at = next;
        if (!is_whole || *next != '(')
            continue;
        Lines arguments = arguments_of(next + 1), given = {NULL, 0};
        if (arguments.count != wanted.count || wanted.count > MOST)
            continue;
        for (size_t k = 0; k < arguments.count; k++)
            lines_add(&given,
                      number_is_double(type_of_argument(&all->code, arguments.line[k], line)));
        if (is_other_order(&given, &wanted))
            return true;
    }
    return false;
}

// ---- the wrong type -----------------------------------------------------------------------------

// Of (Camera c, double s): a Camera and a double.
static const char *listed_types(const char *arguments)
{
    Lines types = header_parameter_types(arguments);
    const char *list = "";
    for (size_t i = 0; i < types.count; i++)
        list = text_format("%s%s%s", list,
                           i == 0                ? ""
                           : i + 1 < types.count ? ", "
                                                 : " and ",
                           with_article(types.line[i]));
    return list;
}

// Functions of this chapter and of earlier ones, except this one, that convert one type to another.
static const char *makers(const Code *code, const char *wanted, const char *given, const char *but)
{
    const char *found = "";
    if (text_is(wanted, "vec3") || header_parts(&code->headers, wanted)[0] == '\0')
        return "";
    for (size_t i = 0; i < code->headers.function_count; i++) {
        const DeclaredFunction *maker = &code->headers.functions[i];
        if (!text_is(maker->name, but) && text_is(maker->type, wanted) &&
            text_begins(maker->header, "exercises") && strcmp(maker->header, code->contract) <= 0 &&
            text_has_word(maker->arguments, given) && !text_has_word(maker->arguments, wanted) &&
            !text_has(maker->arguments, "*"))
            found = text_format("%s%s%s (%s) makes %s of %s", found, found[0] == '\0' ? "" : " or ",
                                maker->name, maker->header, with_article(wanted),
                                listed_types(maker->arguments));
    }
    return found;
}

// The function whose argument is wrong, or "".
static const char *called_at(const Mistake *mistake)
{
    if (!text_says(mistake->text, "argument|^passing"))
        return "";
    if (text_has(mistake->text, " of '"))
        return mistake->name;
    const char *ahead = mistake->message->ahead;
    while (text_matches(ahead, "\\([^()]*\\)"))
        ahead = text_replaced(ahead, "\\([^()]*\\)", "");
    Match match;
    return text_find(ahead, "[A-Za-z_0-9]+\\([^()]*$", &match) ? text_before(ahead + match.at, "(")
                                                               : "";
}

// The name with its parts that begins at the caret.
static const char *expression_here(const Mistake *mistake)
{
    const Message *message = mistake->message;
    bool at_sign = text_matches(message->behind, "^(\\.|->)");
    const char *text =
        text_format("%s%s", at_sign ? text_expression_at_end(message->ahead) : "", message->behind);
    Match match;
    return text_find(text, "^[A-Za-z_][A-Za-z_0-9]*((\\.|->)[A-Za-z_][A-Za-z_0-9]*)*", &match)
               ? text_part(text, 0, match.length)
               : "";
}

static bool is_pointer_to(const char *pointer, const char *type)
{
    return text_is(pointer, text_format("%s *", type)) ||
           text_is(pointer, text_format("%s*", type));
}

// Whether this declares a variable of this type and gives it a value:  Roots roots =
static bool declares_with_value(const char *code, const char *type)
{
    code += text_span(code, " ");
    code += text_begins(code, "const ") ? strlen("const ") : 0;
    if (!text_begins(code, type))
        return false;
    code += strlen(type);
    size_t blanks = text_span(code, " "), name = text_span_of_word(code + blanks);
    code += blanks + name;
    return blanks > 0 && name > 0 && code[text_span(code, " ")] == '=';
}

// Who wants which type: "hit_sphere gives back a double (exercises/05-quadratic.h), and this is a
// Roots."
static const char *what_is_wanted(const Explanation *all, const Mistake *mistake, const char *here,
                                  const char *called)
{
    const char *header = header_of(&all->code.headers, here),
               *wanted = with_article(mistake->wanted);
    const char *who = called[0] != '\0' ? text_format("%s expects %s there", called, wanted)
                                        : text_format("%s is expected here", wanted);
    if (text_has(mistake->text, "returning") && here[0] != '\0')
        who = text_format("%s returns %s%s", here, wanted,
                          header != NULL ? text_format(" (%s)", header) : "");
    return text_format("%s, but this is %s", who, with_article(mistake->given));
}

static const char *help_pointer(const Mistake *mistake)
{
    const char *here = expression_here(mistake), *behind = mistake->message->behind;
    if (is_pointer_to(mistake->given, mistake->wanted))
        return behind[0] == '&' ? "Remove the &."
               : text_matches(here, "(spheres|lights|surfaces)$")
                   ? text_format("One of them is %s[i].", here)
                   : "A * in front of a pointer gives the value it points to.";
    return behind[0] == '*' ? "Remove the *: without it, this is a pointer."
                            : "A & in front makes a pointer to it.";
}

const char *help_types(const Explanation *all, const Mistake *mistake)
{
    const Code *code = &all->code;
    const char *wanted = mistake->wanted, *given = mistake->given, *text = mistake->text;
    if (text_has(given, "(*)"))
        return text_format(
            "%s is a function here. A variable gets its value by =, as in Pixel pixel = "
            "{column, row};",
            expression_here(mistake));
    const char *here = answer_function_around(&code->answer, mistake->line),
               *called = called_at(mistake);
    const char *what = what_is_wanted(all, mistake, here, called);
    const DeclaredFunction *function = header_function(&code->headers, called);
    if (function != NULL && is_swapped(all, function, mistake->line))
        return text_format("%s: the arguments are in another order. Its prototype is  %s  in %s.",
                           what, function->prototype, function->header);
    if (text_has(text, "assigning") && text_is(wanted, text_format("%s *", given))) {
        const char *target = text_expression_at_end(text_before(mistake->code, "="));
        return is_number(given)
                   ? text_format("%s. One of the numbers there is %s[i].", what, target)
                   : text_format("%s. To store it where %s points, write *%s = ...", what, target,
                                 target);
    }
    if (text_has(text, "assigning") && text_matches(mistake->code, "[^=<>!]=[^=].*\\?"))
        return text_format("%s. To compare, write ==.", what);
    if (is_pointer_to(given, wanted) || text_is(wanted, text_format("%s *", given)))
        return text_format("%s. %s", what, help_pointer(mistake));
    const char *by = makers(code, wanted, given, here);
    if (by[0] != '\0')
        return text_format("%s. %s.", what, by);
    if (function != NULL)
        return text_format("%s. Its prototype is  %s  in %s.", what, function->prototype,
                           function->header);
    if (declares_with_value(mistake->code, wanted))
        return text_format("%s. Is the type of the variable right?", what);
    const char *how = written(code, wanted), *values = header_values(&code->headers, wanted);
    if (how[0] != '\0')
        return text_format("%s. Write %s.", what, how);
    if (values[0] != '\0')
        return text_format("%s. %s is one of %s (%s).", what, capital(with_article(wanted)), values,
                           header_of(&code->headers, wanted));
    const char *parts = header_parts(&code->headers, given);
    return text_format("%s.%s", what,
                       parts[0] == '\0' ? "" : text_format(" Its parts are %s.", parts));
}
