// explain_help.c - a line of help for each of the common mistakes. Nothing false is printed: each
// line depends on the compiler's words and, if that is not enough, on the code.
#include "tests/course/explain_mistakes.h"

#include <ctype.h>
#include <string.h>

const char *capital(const char *words)
{
    return text_format("%c%s", toupper((unsigned char)words[0]), text_from(words, 1));
}

static const char *after_blanks(const char *text)
{
    return text + text_span(text, " ");
}

// ---- semicolons, brackets, braces ---------------------------------------------------------------

static const char *help_brace(const Explanation *all, const Mistake *mistake)
{
    if (mistake->line < all->code.answer.last && !text_begins(mistake->text, "function"))
        return text_format("a } is missing in line %zu.", mistake->line);
    return text_format("a } is missing, in or before the function that begins in line %zu.",
                       all->open_function);
}

static const char *help_semicolon(const Explanation *all, const Mistake *mistake)
{
    const Message *message = mistake->message;
    const char *rest = message->behind + (message->behind[0] == '^');
    rest = text_replaced(text_without(rest, "//.*"), "[ })]+", "");
    if (text_matches(mistake->code, "(^|[^A-Za-z_0-9])for *\\([^;]*(;[^;]*)?$"))
        return "for (...; ...; ...) has two semicolons between its three parts.";
    if (message->quoted_line[0] == '\0')
        return text_format("a semicolon is missing in line %zu, or at the end of the one before.",
                           mistake->line);
    if (after_blanks(message->ahead)[0] == '\0')
        return text_format("a semicolon is missing at the end of line %zu.",
                           answer_code_before(&all->code.answer, mistake->line));
    if (rest[0] == '\0')
        return text_format("a semicolon is missing at the end of line %zu.", mistake->line);
    return text_format("in line %zu a semicolon is missing, or an operator (2 t is 2 * t).",
                       mistake->line);
}

const char *help_loop(const Explanation *all, size_t line)
{
    bool is_for = text_matches(answer_code(&all->code.answer, line), "(^|[^A-Za-z_0-9])for *\\(");
    return text_format(
        "the ; after %s%zu %s: the next statement is no longer part of it. Remove the ;.",
        is_for ? "for (...) in line " : "the bracket in line ", line,
        is_for ? "ends the loop" : "ends the statement");
}

static const char *help_missing_return(size_t lost)
{
    const char *words = "the function ends without return: its return value is then undefined.";
    return lost == 0
               ? words
               : text_format("%s Line %zu computes a value, but does not return it.", words, lost);
}

// ---- values -------------------------------------------------------------------------------------

// The type that a return or an assignment wants.
static const char *type_here(const Explanation *all, const Mistake *mistake)
{
    const Answer *answer = &all->code.answer;
    if (text_matches(mistake->code, "(^|[^A-Za-z_0-9])return[^A-Za-z_0-9]"))
        return function_type(&all->code, answer_function_around(answer, mistake->line));
    return type_of(&all->code, text_expression_at_end(text_before(mistake->code, "=")),
                   mistake->line);
}

// A type, or a { or [, where there should be a value.
static const char *help_expression(const Explanation *all, const Mistake *mistake)
{
    const char *behind = mistake->message->behind;
    if (text_matches(mistake->text, "^unexpected type|'[A-Za-z]")) {
        const char *type = mistake->name, *how = written(&all->code, type);
        if (how[0] != '\0' && text_matches(text_from(behind, strlen(type)), "^ *[({]"))
            return text_is(type, "vec3")
                       ? text_format("%s is a type, not a function: write %s.", type, how)
                       : text_format("%s is a type, not a function: %s makes one.", type, how);
        return how[0] != '\0' && text_matches(mistake->message->ahead, "[(,] *$")
                   ? "in a call, write only the values, without their types."
                   : "";
    }
    if (behind[0] != '{' && behind[0] != '[')
        return "";
    const char *type = type_here(all, mistake), *how = written(&all->code, type);
    if (text_is(type, "vec3"))
        return text_format("a vec3 is written %s.", how);
    return how[0] != '\0' ? text_format("put the type in parentheses before the braces: %s.", how)
                          : "put the type in parentheses before the braces, as in (Ray){origin, "
                            "direction}.";
}

static const char *help_comma(const Explanation *all, const Mistake *mistake)
{
    const char *type = mistake->wanted[0] != '\0' ? mistake->wanted : type_here(all, mistake);
    const char *how = written(&all->code, type);
    const char *words = "the value of (a, b) is b alone: the part before the comma is lost.";
    return how[0] == '\0'
               ? words
               : text_format("%s %s is written %s.", words, capital(with_article(type)), how);
}

// ---- operators ----------------------------------------------------------------------------------

// x^2 and x**2.
static const char *help_power(const Explanation *all, const Mistake *mistake, const char *what)
{
    const char *ahead = mistake->message->ahead, *power = mistake->message->behind;
    size_t length = strlen(ahead);
    while (length > 0 && (ahead[length - 1] == ' ' || ahead[length - 1] == '*'))
        length--;
    const char *name = text_expression_at_end(text_part(ahead, 0, length));
    if (name[0] == '\0')
        name = "x";
    if (text_has(mistake->text, "'vec3'") ||
        text_is(type_of(&all->code, name, mistake->line), "vec3"))
        return text_format("%s: for v . v, write vec3_dot(%s, %s).", what, name, name);
    power += text_span(power, "*^ ");
    Match match;
    if (!text_matches(power, "^2([^0-9.]|$)") && text_find(power, "^[A-Za-z_0-9.]+", &match))
        return text_format("%s: write pow(%s, %s).", what, name, text_part(power, 0, match.length));
    return text_format("%s: write %s * %s.", what, name, name);
}

// 2x
static const char *help_times(const char *code)
{
    Match match;
    code = text_format(" %s", code);
    if (!text_find(code, "[^A-Za-z_0-9.][0-9][0-9.]*[A-Za-z_][A-Za-z_0-9.]*", &match))
        return "a * is missing: 2x is 2 * x.";
    const char *both = text_part(code, match.at + 1, match.length - 1);
    size_t digits = text_span(both, "0123456789.");
    return text_format("a * is missing: %s * %s.", text_part(both, 0, digits), both + digits);
}

// Whether two vectors are multiplied in this line.
static bool has_vector_product(const Explanation *all, const Mistake *mistake)
{
    for (const char *at = mistake->code; (at = strchr(at, '*')) != NULL; at++) {
        const char *left =
            text_before(text_part(mistake->code, 0, (size_t)(at - mistake->code) + 1), "*");
        const char *right = after_blanks(at + 1);
        Match match;
        if (!text_find(right, "^[A-Za-z_0-9.]*(->[A-Za-z_0-9.]*)*", &match))
            continue;
        if (text_is(type_of(&all->code, text_expression_at_end(left), mistake->line), "vec3") &&
            text_is(type_of(&all->code, text_part(right, 0, match.length), mistake->line), "vec3"))
            return true;
    }
    return false;
}

static const char *help_vector(const Explanation *all, const Mistake *mistake)
{
    if (has_vector_product(all, mistake))
        return "v * w multiplies component by component and gives a vector; for a number, write "
               "vec3_dot(v, w).";
    return text_format(
        "this is a vector, but a number is expected. v * w is also a vector; for a number, "
        "write vec3_dot(v, w), vec3_length(v) or v[0].%s",
        text_has(mistake->text, "initializ") ? " Or is the type of the variable wrong?" : "");
}

// A struct in a sum or a product.
static const char *help_operands(const Explanation *all, const Mistake *mistake)
{
    const char *found = "";
    for (const char *at = mistake->text; at != NULL; at = strchr(at, '\'')) {
        at += *at == '\'';
        const char *type = bare_type(text_part(at, 0, strcspn(at, "'")));
        const char *parts = header_parts(&all->code.headers, type);
        if (parts[0] != '\0')
            found = text_format("there is no arithmetic with %s as a whole: its parts are %s.",
                                with_article(type), parts);
    }
    return found;
}

// The type whose name is in parentheses before another pair, if students write a value of the type
// in that way; or "".
static const char *cast_to(const Explanation *all, const char *code)
{
    Match match;
    if (!text_find(code, "\\([A-Za-z0-9]+\\) *\\(", &match))
        return "";
    const char *type = text_part(code, match.at + 1, strcspn(code + match.at + 1, ")"));
    return written(&all->code, type)[0] != '\0' ? type : "";
}

static const char *help_call(const char *code)
{
    Match match;
    if (text_find(code, "[A-Za-z_0-9]+(\\.|->)[A-Za-z_0-9]+ *\\(", &match)) {
        const char *name = text_before(code + match.at, "(");
        return text_format("%s(...) is a call of a function; an element of an array is %s[...].",
                           name, name);
    }
    return text_matches(code, "(^|[^A-Za-z_0-9])[0-9.]+ *\\(|\\) *\\(")
               ? "a * is missing before the bracket: 2(x) is 2 * (x)."
               : "";
}

static const char *help_subscript(const Explanation *all, const Mistake *mistake)
{
    const char *type =
        type_of(&all->code, text_expression_at_end(mistake->message->ahead), mistake->line);
    const char *parts = header_parts(&all->code.headers, type);
    return parts[0] != '\0' ? text_format("%s has no numbered parts: they are called %s.",
                                          with_article(type), parts)
                            : "";
}

// ---- arguments ----------------------------------------------------------------------------------

static const char *help_count(const Explanation *all, const Mistake *mistake)
{
    const char *declared = mistake->message->declared,
               *function = strstr(mistake->text, "function");
    const char *name = declared[0] != '\0' ? declared : function != NULL ? quoted(function) : "";
    // clang tells the name only in its note, and none if the function is built in.
    if (name[0] == '\0' || (text_has(mistake->text, "function call") && declared[0] == '\0'))
        return "look at the prototype of the function: it lists the parameters.";
    const DeclaredFunction *known = header_function(&all->code.headers, name);
    if (known != NULL)
        return text_format("its prototype is  %s  in %s.", known->prototype, known->header);
    return text_format("look at the prototype of %s: it lists the parameters.", name);
}

// ---- which of them ------------------------------------------------------------------------------

// Slips that are seen in the code as well as in the compiler's words.
static const char *help_slip(const Explanation *all, const Mistake *mistake)
{
    const Answer *answer = &all->code.answer;
    const char *text = mistake->text, *code = mistake->code, *ahead = mistake->message->ahead,
               *behind = mistake->message->behind;
    size_t before = answer_code_before(answer, mistake->line);
    if (text_matches(code, "^ *(import|using|from) "))
        return text_format("C has no import: headers are included, as in #include \"%s\"",
                           all->code.contract);
    if (text_begins(text, "expected") && text_matches(behind, "^ *(and|or|not) "))
        return "and, or and not are written &&, || and ! in C.";
    if (text_matches(text, "operand of '[&|]'|^[&|] has lower precedence"))
        return "&& is and, || is or; & and | work on bits.";
    if (text_begins(text, "comparisons like"))
        return "two comparisons are joined by &&: 0 < x && x < 1.";
    if (text_begins(text, "expected identifier or '('") && code[0] == '{' &&
        text_matches(answer_code(answer, before), "\\);$"))
        return text_format(
            "the ; at the end of line %zu separates the function from its { }: remove it.", before);
    if (text_begins(text, "expected expression") && after_blanks(ahead)[0] == '\0' &&
        text_matches(answer_code(answer, before), ",$"))
        return text_format("line %zu ends with a comma, but needs a semicolon.", before);
    if (mistake->is_unused_value && text_has(code, "=="))
        return "== compares; to give a variable a value, write =.";
    if (text_says(text, "used uninitialized|uninitialized when used"))
        return text_format("%s is declared, but has no value yet.", mistake->name);
    if (text_says(text, "No such file or directory|file not found"))
        return text_format(
            "the contract of this chapter is #include \"%s\"; other headers are in common/.",
            all->code.contract);
    if (text_begins(text, "expected") && text_matches(behind, "^ *x [A-Za-z(]"))
        return "x is not an operator in C: * multiplies, and the cross product is vec3_cross(v, "
               "w).";
    if (text_begins(text, "expected ')'") && answer_brackets(answer, mistake->line) > 0)
        return "a ) is missing: there are more ( than ).";
    if ((text_says(text, "before ')' token|^extraneous ')'") ||
         text_is(text, "expected expression")) &&
        answer_brackets(answer, mistake->line) < 0)
        return "one ) too many: there are more ) than (.";
    if (text_begins(text, "expected '('") &&
        text_matches(code, "(^|[^A-Za-z_0-9])(if|while|for) +[^ (]"))
        return "if, while and for need parentheses: if (x > 0).";
    if (text_says(text, "^expected '}'|^expected ')'") && text_matches(ahead, "[A-Za-z_0-9)] *$") &&
        text_matches(behind, "^ *[A-Za-z_(]"))
        return "an operator or a comma is missing there (2 t is 2 * t).";
    if (text_begins(text, "expected expression") && (behind[0] == '<' || behind[0] == '>') &&
        text_matches(ahead, "= *$"))
        return "C writes >= and <=, not => and =<.";
    if (text_matches(text, "^(expected expression( before '[A-Za-z]|$)|unexpected type name)") &&
        after_blanks(ahead)[0] == '\0' && begins_declaration(&all->code, behind))
        return "a declaration after if, else or for needs braces around it: { }.";
    return "";
}

// NULL if it is about none of them.
static const char *help_parts_and_powers(const Explanation *all, const Mistake *mistake)
{
    const char *text = mistake->text, *code = mistake->code;
    if (text_matches(text,
                     "invalid type argument of '->'|^member reference type .* is (not )?a pointer|"
                     "is a pointer; did you mean"))
        return help_arrow(all, mistake);
    if (text_says(text, "^request for member|^member reference base type"))
        return help_parts(all, mistake);
    if (text_says(text, "no member named|does not refer to any field"))
        return help_member(all, mistake);
    if (text_begins(text, "invalid operands to binary") && mistake->message->behind[0] == '^')
        return help_power(all, mistake, "^ is exclusive or in C");
    if (text_matches(text, "^invalid type argument of unary '\\*'|^indirection requires pointer"))
        return text_has(code, "**")
                   ? help_power(all, mistake, "C has no **")
                   : "a * in front of a name reads through a pointer, and this is not a "
                     "pointer: remove the *.";
    if (text_matches(text, "^invalid (suffix|digit) .* (integer|decimal|floating) constant"))
        return help_times(code);
    if (text_begins(text, "called object"))
        return help_call(code);
    return NULL;
}

// Loops, declarations, and return values.
static const char *help_declaration(const Explanation *all, const Mistake *mistake)
{
    const char *text = mistake->text;
    const char *wanted_parts = header_parts(&all->code.headers, mistake->wanted);
    if (answer_ends_at_once(&all->code.answer, mistake->line) &&
        text_says(text, "clause does not guard|empty body"))
        return help_loop(all, mistake->line);
    if (text_says(text, "clause does not guard|^misleading indentation"))
        return "without braces { } only one statement belongs to it.";
    if (mistake->is_unknown ||
        (text_says(text, "^type defaults to 'int'|^type specifier missing") &&
         text_matches(mistake->code, "^ *auto ")))
        return help_unknown(all, mistake);
    if (mistake->is_count)
        return help_count(all, mistake);
    if (mistake->is_signature)
        return help_signature(all, mistake);
    if (text_matches(text, "discards '?(const|qualifiers)"))
        return "the data it points to must not change: put const in front of the pointer's "
               "type.";
    if (text_matches(text, "^parameter names .without types|^a parameter list without types"))
        return "that declares a function. A variable gets its value by =, as in Pixel pixel = "
               "{column, row};";
    if (text_begins(text, "invalid initializer") && wanted_parts[0] != '\0')
        return text_format("%s is expected here: %s.", with_article(mistake->wanted),
                           written(&all->code, mistake->wanted));
    if (text_says(text, "^'return' with no value|should return a value"))
        return "return without a value: this function must return one. Write it after return.";
    if (mistake->is_missing_return)
        return help_missing_return(all->about[mistake->begins].lost);
    return "";
}

const char *help(const Explanation *all, const Mistake *mistake)
{
    const char *text = mistake->text;
    if (mistake->is_pasted)
        return "a character that is not C was pasted there: a dash, a quote, a sign or a space "
               "that only looks like one. Delete it and type it again.";
    if (mistake->keyword[0] != '\0')
        return text_format("%s is misspelled: %s.", mistake->slip, mistake->keyword);
    if (mistake->decimal[0] != '\0')
        return text_format("%s is two numbers in C. If you mean one number, write %s.",
                           mistake->decimal, text_replaced(mistake->decimal, ",", "."));
    if (mistake->is_missing_brace)
        return help_brace(all, mistake);
    if (mistake->is_outside)
        return "this is outside of every function: there is one } too many before it.";
    const char *slip = help_slip(all, mistake);
    if (slip[0] != '\0')
        return slip;
    if (text_begins(text, "subscripted value"))
        return help_subscript(all, mistake);
    if (text_says(text,
                  "^invalid operands to binary|^cannot convert between vector and non-scalar") &&
        mistake->message->behind[0] != '^')
        return help_operands(all, mistake);
    if (text_says(text, "assignment used as truth value|result of an assignment as a condition"))
        return "= assigns; to compare, write ==.";
    if (text_says(text, "^expected expression|^unexpected type name"))
        return help_expression(all, mistake);
    if (is_semicolon(mistake))
        return help_semicolon(all, mistake);
    const char *parts = help_parts_and_powers(all, mistake);
    if (parts != NULL)
        return parts;
    const char *cast = cast_to(all, mistake->code);
    if (cast[0] != '\0' &&
        text_matches(text, "^conversion to non-scalar type|^used type '[A-Za-z]*' where arithmetic|"
                           "^cannot convert a value of type .* to vector type|"
                           "^invalid conversion between vector type"))
        return text_format("%s is written %s.", with_article(cast), written(&all->code, cast));
    if (mistake->is_comma || (mistake->wanted[0] != '\0' && has_comma_in_statement(all, mistake)))
        return help_comma(all, mistake);
    if (is_vector_for_number(mistake))
        return help_vector(all, mistake);
    if (mistake->wanted[0] != '\0' && mistake->given[0] != '\0')
        return help_types(all, mistake);
    return help_declaration(all, mistake);
}
