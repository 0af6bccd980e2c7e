// explain_help.c - a line of help for each of the common mistakes. Nothing false is printed: each
// line depends on the compiler's words and, if that is not enough, on the code.

#include "tests/course/explain_inside.h"

#include <ctype.h>
#include <string.h>

// Of abs, which compiles if <stdlib.h> is included, and loses the digits after the point.
#define INTEGER_ABS "abs is for whole numbers. For a double, write fabs (#include <math.h>)."

static const char *capital(const char *words)
{
    return text_format("%c%s", toupper((unsigned char)words[0]), text_from(words, 1));
}

static const char *after_blanks(const char *text)
{
    return text + text_span(text, " ");
}

// ---- semicolons, brackets, braces --------------------------------------------------------------

static const char *help_brace(const Mistake *mistake)
{
    if (mistake->line < answer.last && !text_begins(mistake->text, "function"))
        return text_format("a } is missing in line %zu.", mistake->line);
    return text_format("a } is missing, in or before the function that begins in line %zu.",
                       all.open_function);
}

static const char *help_semicolon(const Mistake *mistake)
{
    if (!is_semicolon(mistake))
        return "";
    const Message *message = mistake->message;
    const char *rest = message->behind + (message->behind[0] == '^');
    rest = text_replaced(text_without(rest, "//.*"), "[ })]+", "");
    if (text_matches(mistake->code, "(^|[^A-Za-z_0-9])for *\\([^;]*(;[^;]*)?$"))
        return "for (...; ...; ...) has two semicolons between its three parts.";
    if (message->quoted_line[0] == '\0')
        return text_format("a semicolon is missing in line %zu, or at the end of the one before.",
                           mistake->line);
    size_t before = answer_code_before(mistake->line);
    if (after_blanks(message->ahead)[0] == '\0')
        return before > 0 ? text_format("a semicolon is missing at the end of line %zu.", before)
                          : "what comes first in the file is not C. If it is a comment, write // "
                            "before it.";
    if (rest[0] == '\0')
        return text_format("a semicolon is missing at the end of line %zu.", mistake->line);
    return text_format("in line %zu a semicolon is missing, or an operator (2 t is 2 * t).",
                       mistake->line);
}

static const char *help_loop(size_t line)
{
    bool is_for = text_matches(answer_code(line), "(^|[^A-Za-z_0-9])for *\\(");
    return text_format(
        "the ; after %s%zu %s: the next statement is no longer part of it. Remove the ;.",
        is_for ? "for (...) in line " : "the bracket in line ", line,
        is_for ? "ends the loop" : "ends the statement");
}

static const char *help_missing_return(const Mistake *mistake)
{
    size_t lost = all.about[mistake->begins].lost;
    const char *words = "the function ends without return: its return value is then undefined.";
    return lost == 0
               ? words
               : text_format("%s Line %zu computes a value, but does not return it.", words, lost);
}

// ---- values ------------------------------------------------------------------------------------

// The type that a return or an assignment wants.
static const char *type_here(const Mistake *mistake)
{
    if (text_matches(mistake->code, "(^|[^A-Za-z_0-9])return[^A-Za-z_0-9]"))
        return function_type(answer_function_around(mistake->line));
    return type_of(text_expression_at_end(text_before(mistake->code, "=")), mistake->line);
}

// A type, or a { or [, where there should be a value.
static const char *help_expression(const Mistake *mistake)
{
    const char *behind = mistake->message->behind;
    if (text_matches(mistake->text, "^unexpected type|'[A-Za-z]")) {
        const char *type = mistake->name, *how = written(type);
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
    const char *type = type_here(mistake), *how = written(type);
    if (text_is(type, "vec3"))
        return text_format("a vec3 is written %s.", how);
    return how[0] != '\0' ? text_format("put the type in parentheses before the braces: %s.", how)
                          : "put the type in parentheses before the braces, as in (Ray){origin, "
                            "direction}.";
}

static const char *help_comma(const Mistake *mistake)
{
    const char *type = mistake->wanted[0] != '\0' ? mistake->wanted : type_here(mistake);
    const char *how = written(type);
    const char *words = "the value of (a, b) is b alone: the part before the comma is lost.";
    return how[0] == '\0'
               ? words
               : text_format("%s %s is written %s.", words, capital(with_article(type)), how);
}

// ---- operators ---------------------------------------------------------------------------------

// x^2 and x**2.
static const char *help_power(const Mistake *mistake, const char *what)
{
    const char *ahead = mistake->message->ahead, *power = mistake->message->behind;
    size_t length = strlen(ahead);
    while (length > 0 && (ahead[length - 1] == ' ' || ahead[length - 1] == '*'))
        length--;
    const char *name = text_expression_at_end(text_part(ahead, 0, length));
    if (name[0] == '\0')
        name = "x";
    if (text_has(mistake->text, "'vec3'") || text_is(type_of(name, mistake->line), "vec3"))
        return text_format("%s: for v . v, write vec3_dot(%s, %s).", what, name, name);
    power += text_span(power, "*^ ");
    power = text_group(power, "^[A-Za-z_0-9.]+", 0);
    if (power[0] != '\0' && !text_is(power, "2"))
        return text_format("%s: write pow(%s, %s).", what, name, power);
    return text_format("%s: write %s * %s.", what, name, name);
}

// 2x
static const char *help_times(const Mistake *mistake)
{
    static const char times[] = "(^|[^A-Za-z_0-9.])([0-9][0-9.]*)([A-Za-z_][A-Za-z_0-9.]*)";
    return !text_matches(mistake->code, times)
               ? "a * is missing: 2x is 2 * x."
               : text_format("a * is missing: %s * %s.", text_group(mistake->code, times, 2),
                             text_group(mistake->code, times, 3));
}

// Whether two vectors are multiplied in this line.
static bool has_vector_product(const Mistake *mistake)
{
    for (const char *at = mistake->code; (at = strchr(at, '*')) != NULL; at++) {
        const char *left =
            text_before(text_part(mistake->code, 0, (size_t)(at - mistake->code) + 1), "*");
        const char *right = text_group(at, "^\\* *([A-Za-z_0-9.]*(->[A-Za-z_0-9.]*)*)", 1);
        if (text_is(type_of(text_expression_at_end(left), mistake->line), "vec3") &&
            text_is(type_of(right, mistake->line), "vec3"))
            return true;
    }
    return false;
}

static const char *help_vector(const Mistake *mistake)
{
    if (has_vector_product(mistake))
        return "v * w multiplies component by component and gives a vector; for a number, write "
               "vec3_dot(v, w).";
    return text_format(
        "this is a vector, but a number is expected. v * w is also a vector; for a number, "
        "write vec3_dot(v, w), vec3_length(v) or v[0].%s",
        text_has(mistake->text, "initializ") ? " Or is the type of the variable wrong?" : "");
}

// A struct in a sum or a product.
static const char *help_operands(const Mistake *mistake)
{
    const char *found = "";
    for (const char *at = mistake->text; at != NULL; at = strchr(at, '\'')) {
        at += *at == '\'';
        const char *type = bare_type(text_part(at, 0, strcspn(at, "'")));
        const char *parts = header_parts(type);
        if (parts[0] != '\0')
            found = text_format("there is no arithmetic with %s as a whole: its parts are %s.",
                                with_article(type), parts);
    }
    return found;
}

// The type whose name is in parentheses before another pair, if students write a value of the type
// in that way; or "".
static const char *cast_to(const char *code)
{
    const char *type = text_group(code, "\\(([A-Za-z0-9]+)\\) *\\(", 1);
    return written(type)[0] != '\0' ? type : "";
}

static const char *help_call(const Mistake *mistake)
{
    const char *code = mistake->code,
               *name = text_group(code, "([A-Za-z_0-9]+(\\.|->)[A-Za-z_0-9]+) *\\(", 1);
    return name[0] != '\0'
               ? text_format("%s(...) is a call of a function; an element of an array is %s[...].",
                             name, name)
           : text_matches(code, "(^|[^A-Za-z_0-9])[0-9.]+ *\\(|\\) *\\(")
               ? "a * is missing before the bracket: 2(x) is 2 * (x)."
               : "";
}

static const char *help_subscript(const Mistake *mistake)
{
    const char *type = type_of(text_expression_at_end(mistake->message->ahead), mistake->line);
    const char *parts = header_parts(type);
    return parts[0] != '\0' ? text_format("%s has no numbered parts: they are called %s.",
                                          with_article(type), parts)
                            : "";
}

// ---- arguments ---------------------------------------------------------------------------------

static const char *help_count(const Mistake *mistake)
{
    const char *declared = mistake->message->declared,
               *function = strstr(mistake->text, "function");
    const char *name = declared[0] != '\0' ? declared : function != NULL ? quoted(function) : "";
    // clang tells the name only in its note, and none if the function is built in.
    if (name[0] == '\0' || (text_has(mistake->text, "function call") && declared[0] == '\0'))
        return "look at the prototype of the function: it lists the parameters.";
    const DeclaredFunction *known = header_function(name);
    if (known != NULL)
        return text_format("its prototype is  %s  in %s.", known->prototype, known->header);
    return text_format("look at the prototype of %s: it lists the parameters.", name);
}

// ---- names that are known elsewhere ------------------------------------------------------------

// Names that students know from other languages, and the function here.
static const struct {
    const char *names, *here;
} known[] = {
    {"dot dotp dot_product dotProduct vec3Dot vec_dot scalar_product", "vec3_dot"},
    {"cross crossp cross_product crossProduct vec3Cross vec_cross", "vec3_cross"},
    {"length len norm magnitude mag vec3_norm vec3_len vec3_magnitude vec_length abs_vec3",
     "vec3_length"},
    {"unit unit_vector normalize normalise normalized vec3_normalize vec3_normalise "
     "vec3_normalized "
     "vec_normalize",
     "vec3_unit"},
    {"vec vec_of make_vec3 new_vec3 vec3_new vec3_make vec3_create Vec3 Vector vector", "vec3_of"},
    {"print println echo cout console", "printf, of <stdio.h>"},
    {"max maximum", "fmax, of <math.h>"},
    {"min minimum", "fmin, of <math.h>"},
    {"infinity Infinity INF inf HUGE", "INFINITY, of <math.h>"},
    {"True TRUE", "true"},
    {"False FALSE", "false"},
};

// Not every compiler names the header of the C library that declares a function.
static const struct {
    const char *header, *names;
} library[] = {
    {"<stdio.h>", "printf fprintf sprintf snprintf puts putchar fputs scanf fflush stdout stderr"},
    {"<stdlib.h>", "malloc calloc realloc free exit rand srand qsort atof atoi"},
    {"<string.h>", "memcpy memset memcmp strlen strcmp"},
    {"<math.h>",
     "sqrt fabs tan sin cos atan atan2 acos asin pow floor ceil round fmin fmax hypot exp log "
     "isnan isfinite signbit copysign INFINITY NAN"},
    {"<stdbool.h>", "bool true false"},
    {"<stddef.h>", "NULL size_t"},
    {"<stdint.h>", "uint8_t"},
    {"<float.h>", "DBL_MAX DBL_MIN DBL_EPSILON FLT_MAX FLT_EPSILON"},
    {"<limits.h>", "INT_MAX INT_MIN"},
    {"<assert.h>", "assert"},
};

static const char *known_as(const char *name)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (text_is_one_of(name, known[i].names))
            return known[i].here;
    return "";
}

static const char *library_of(const Mistake *mistake)
{
    if (mistake->message->library[0] != '\0')
        return mistake->message->library;
    for (size_t i = 0; i < sizeof library / sizeof *library; i++)
        if (text_is_one_of(mistake->name, library[i].names))
            return library[i].header;
    return "";
}

// ---- names of other languages ------------------------------------------------------------------

static const struct {
    const char *names, *help;
} of_other_languages[] = {
    {"M_PI", "C11 has no M_PI: write PI (common/vec3.h)."},
    {"std", "C has no std:: - the functions of <math.h> have no such prefix, as in sqrt(x)."},
    {"new", "C has no new: a struct is written (Ray){origin, direction}, a vec3 vec3_of(x, y, z)."},
    {"let var auto def",
     "C has no NAME: declare a new variable with its type, as in double x or vec3 v."},
    {"abs labs", INTEGER_ABS},
};

static const char *help_other_language(const char *name)
{
    for (size_t i = 0; i < sizeof of_other_languages / sizeof *of_other_languages; i++)
        if (text_is_one_of(name, of_other_languages[i].names))
            return text_replaced(of_other_languages[i].help, "NAME", name);
    return text_matches(name, "^return[a-z]")
               ? text_format("a space is missing: return %s", name + strlen("return"))
               : "";
}

static const char *help_known(const char *name)
{
    const char *here = known_as(name);
    const DeclaredFunction *function = header_function(here);
    if (function != NULL)
        return text_format("here its name is %s: %s  in %s.", here, function->prototype,
                           function->header);
    return text_format("in C its name is %s.", here);
}

// ---- names that are nearly right ---------------------------------------------------------------

// camera.width, if the camera has another name here.
static const char *help_whole(const Mistake *mistake)
{
    const char *behind = mistake->message->behind, *name = mistake->name, *owner;
    if (!text_begins(behind, name))
        return "";
    behind += strlen(name);
    size_t sign = behind[0] == '.' ? 1 : text_begins(behind, "->") ? 2 : 0;
    size_t length = text_span_of_word(behind + sign);
    if (sign == 0 || length == 0)
        return "";
    const char *whole = whole_of(text_part(behind, sign, length), mistake->line, &owner);
    if (whole[0] == '\0')
        return "";
    return text_format("nothing here is called %s. %s has another name here: write %s.", name,
                       owner[0] == '\0' ? "It" : text_format("The %s", owner), whole);
}

// width, if camera.width is meant.
static const char *help_part(const Mistake *mistake)
{
    const char *owner, *whole = whole_of(mistake->name, mistake->line, &owner);
    if (whole[0] == '\0')
        return "";
    if (owner[0] == '\0')
        return text_format("%s is the name of parts: write %s.", mistake->name, whole);
    return text_format("%s is a part of %s (%s): write %s.", mistake->name, with_article(owner),
                       header_of(owner), whole);
}

// The name that the compiler suggests, if a header declares it.
static const char *help_thought_of(const Mistake *mistake)
{
    const Lines *body = &mistake->message->body;
    const char *thought = "";
    for (size_t i = 0; i <= body->count && thought[0] == '\0'; i++)
        thought = text_group(i == 0 ? mistake->text : body->line[i - 1],
                             "did you mean '([A-Za-z_0-9]+)'", 1);
    const char *header = header_of(thought);
    return header == NULL || strcasecmp(thought, mistake->name) == 0
               ? ""
               : text_format("nothing here is called %s. %s is in %s.", mistake->name, thought,
                             header);
}

// " The parameters of NAME are Camera c, double s and double t."; "" if there are none.
static const char *parameters_of(size_t line)
{
    Scope scope = scope_of(line);
    if (scope.parameters == 0)
        return "";
    const char *list = "";
    for (size_t i = 0; i < scope.parameters; i++)
        list = text_format("%s%s%s" UNBROKEN "%s%s", list,
                           i == 0                     ? ""
                           : i + 1 < scope.parameters ? ", "
                                                      : " and ",
                           scope.variables[i].type, scope.variables[i].is_pointer ? "*" : "",
                           scope.variables[i].name);
    return text_format(" The parameter%s of %s %s %s.", scope.parameters == 1 ? "" : "s",
                       answer_function_around(line), scope.parameters == 1 ? "is" : "are", list);
}

static const char *help_nothing(const Mistake *mistake, bool is_variable)
{
    const char *given = is_variable ? parameters_of(mistake->line) : "";
    if (strlen(mistake->name) > 1)
        return text_format("nothing here is called %s. Is it spelled as in the contract, %s?%s",
                           mistake->name, headers.contract, given);
    return text_format(
        "nothing here is called %s.%s Declare a variable of your own first, with its type.",
        mistake->is_letter ? all.about[mistake->begins].strange_letters : mistake->name, given);
}

// The name in a loop: declared in another one, or in none.
static const char *help_name_of_loop(const Mistake *mistake)
{
    const char *name = mistake->name;
    if (text_is(text_group(mistake->code, "(^|[^A-Za-z_0-9])for *\\( *([A-Za-z_0-9]+) *=", 2),
                name))
        return text_format("%s is not declared: for (int %s = ...; ...; ...).", name, name);
    size_t loop = answer_loop_of(name, mistake->line);
    if (loop == 0)
        return "";
    return answer_ends_at_once(loop)
               ? help_loop(loop)
               : text_format("%s is known only inside the loop of line %zu.", name, loop);
}

static bool is_vector_of_others(const char *name)
{
    char lower[16];
    size_t length = strlen(name);
    if (length >= sizeof lower)
        return false;
    for (size_t i = 0; i <= length; i++)
        lower[i] = (char)(name[i] >= 'A' && name[i] <= 'Z' ? name[i] + ('a' - 'A') : name[i]);
    return text_matches(lower, "^(d?vec[34]?|vector3?|point3?|float3|double3)$");
}

// Declared elsewhere: in the C library, further down, in a header that is not included.
static const char *help_declared_elsewhere(const Mistake *mistake, bool is_function)
{
    const char *name = mistake->name, *standard = library_of(mistake);
    const OwnFunction *own = answer_function_named(name);
    if (standard[0] != '\0')
        return text_format("%s is in the standard library: #include %s", name, standard);
    if (own != NULL && own->line > mistake->line && is_function)
        return text_format("%s is defined further down, in line %zu: move it above its use.", name,
                           own->line);
    if (mistake->lacks_contract)
        return text_format("#include \"%s\" is missing at the top of this file.", headers.contract);
    return "";
}

static const char *help_spelling(const Mistake *mistake, bool is_function, bool is_type)
{
    const char *name = mistake->name;
    if (text_begins(mistake->text, "unknown type name") && is_vector_of_others(name))
        return "the type of points, vectors and colours is vec3 (common/vec3.h).";
    if (known_as(name)[0] != '\0')
        return help_known(name);
    if (text_is_one_of(name, "sqr sq square squared"))
        return "C has no square: write x * x.";
    const char *loop = help_name_of_loop(mistake);
    if (loop[0] != '\0')
        return loop;
    const DeclaredName *like = header_name_like(name, is_type);
    if (like != NULL)
        return text_format("nothing here is called %s. It is written %s (%s).", name, like->name,
                           like->header);
    const char *thought = help_thought_of(mistake), *type = capital(name);
    if (thought[0] != '\0')
        return thought;
    if (!is_function && !is_type && header_parts(type)[0] != '\0')
        return text_format(
            "nothing here is called %s. A %s of your own must be declared first: %s" UNBROKEN
            "%s" UNBROKEN "=" UNBROKEN "...;",
            name, type, type, name);
    return "";
}

// Declared here, as far as the text shows, and not by a loop that has ended: the compiler lost it
// because of another mistake.
static bool is_lost(const char *name, size_t line)
{
    Scope scope = scope_of(line);
    for (size_t i = 0; i < scope.count; i++)
        if (text_is(scope.variables[i].name, name))
            return answer_loop_of(name, line) == 0;
    return false;
}

static const char *help_unknown(const Mistake *mistake)
{
    const char *name = mistake->is_unknown ? mistake->name : "auto";
    bool is_function = text_has(mistake->text, "function '"),
         is_type = text_has(mistake->text, "unknown type");
    const char *words = help_other_language(name);
    if (words[0] == '\0')
        words = help_declared_elsewhere(mistake, is_function);
    if (words[0] == '\0' && mistake->translation[0] != '\0')
        words = text_format("the slide's %s.", all.about[mistake->begins].letters);
    if (words[0] == '\0' && !is_function && !is_type && is_lost(name, mistake->line))
        return "";
    if (words[0] == '\0')
        words = help_whole(mistake);
    if (words[0] == '\0' && !is_function)
        words = help_part(mistake);
    const char *header = header_of(name);
    if (words[0] == '\0' && header != NULL && !answer_includes(header) &&
        !text_is(header, headers.contract))
        words = text_format("%s is declared in another file: #include \"%s\"", name, header);
    if (words[0] == '\0')
        words = help_spelling(mistake, is_function, is_type);
    return words[0] == '\0' ? help_nothing(mistake, !is_function && !is_type) : words;
}

// ---- names that are declared twice -------------------------------------------------------------

static const char *help_redefinition(const Mistake *mistake, const char *name)
{
    const char *header = header_of(name);
    for (size_t i = 0; i < answer.function_count && answer.functions[i].line < mistake->line; i++)
        if (text_is(answer.functions[i].name, name))
            return text_format("%s is already defined in line %zu.", name,
                               answer.functions[i].line);
    return header == NULL ? ""
                          : text_format("%s is already in %s: use it, or give yours another name.",
                                        name, header);
}

static const char *help_signature(const Mistake *mistake)
{
    const char *here = answer_function_around(mistake->line);
    const char *name = text_begins(mistake->text, "argument") ? here : mistake->name;
    Scope scope = scope_of(mistake->line);
    for (size_t i = 0; i < scope.parameters; i++)
        if (text_is(scope.variables[i].name, name))
            return text_format("%s is already a parameter of %s: give yours another name.", name,
                               here);
    if (text_begins(mistake->text, "redefinition"))
        return help_redefinition(mistake, name);
    const DeclaredFunction *function = header_function(name);
    if (function == NULL)
        return "";
    if (text_has(mistake->text, "static declaration"))
        return text_format("remove the static in front of %s: other files call it.", name);
    if (text_is(function->header, headers.contract))
        return text_format("the contract, %s, says  %s: your function must begin like that.",
                           headers.contract, function->prototype);
    return text_format("%s is already in %s, as  %s: give yours another name.", name,
                       function->header, function->prototype);
}

// ---- parts -------------------------------------------------------------------------------------

// The name after the dot or the arrow at the caret.
static const char *part_behind(const Mistake *mistake)
{
    const char *part = text_without(mistake->message->behind, "^(\\.|->) *");
    return text_part(part, 0, text_span_of_word(part));
}

static const char *help_arrow(const Mistake *mistake)
{
    const char *name = text_expression_at_end(mistake->message->ahead),
               *part = part_behind(mistake);
    if (part[0] == '\0')
        return "";
    if (name[0] == '\0')
        return text_has(mistake->text, "did you mean to use '->'")
                   ? text_format("after a pointer comes -> and not a dot: ->%s.", part)
                   : "";
    const char *type = type_of(name, mistake->line), *parts = header_parts(type);
    if (parts[0] != '\0' && header_field(type, part) == NULL)
        return text_format(
            "%s %s %s, whose parts are %s.%s", name,
            text_has(mistake->text, "to use '->'") ? "points to" : "is", with_article(type), parts,
            text_is(type, "Sphere") && header_field("Surface", part) != NULL
                ? text_format(" For its look, write scene_surface(scene, i)->%s.", part)
                : "");
    if (text_has(mistake->text, "did you mean to use '->'"))
        return text_format("%s is a pointer: write %s->%s.", name, name, part);
    return text_format("%s is not a pointer: write %s.%s.", name, name, part);
}

static const char *help_parts(const Mistake *mistake)
{
    const char *ahead = mistake->message->ahead, *name = text_expression_at_end(ahead);
    const char *type = text_has(mistake->text, "base type") ? bare_type(mistake->name)
                                                            : type_of(name, mistake->line);
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
    const char *whole = whole_of(part, mistake->line, &owner);
    const char *number =
        text_format("%s is a number and has no parts.", name[0] == '\0' ? "this" : name);
    if (whole[0] == '\0')
        return number;
    return text_format("%s %s is a part of %s. Write %s.", number, part,
                       owner[0] == '\0' ? "others" : with_article(owner), whole);
}

static const char *help_member(const Mistake *mistake)
{
    bool type_first = mistake->text[0] == '\'';
    const char *type = bare_type(type_first ? mistake->name : quoted_second(mistake->text));
    const char *parts = header_parts(type);
    if (parts[0] == '\0')
        return "";
    const char *letters = all.about[mistake->begins].letters;
    return text_format("the parts of %s are %s (%s).%s", with_article(type), parts, header_of(type),
                       mistake->translation[0] == '\0' ? ""
                                                       : text_format(" The slide's %s.", letters));
}

// ---- the order of arguments --------------------------------------------------------------------

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
static bool is_swapped(const DeclaredFunction *called, size_t line)
{
    enum { MOST = 20 };
    const char *text = answer_statement_text(line);
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
            lines_add(&given, number_is_double(type_of_argument(arguments.line[k], line)));
        if (is_other_order(&given, &wanted))
            return true;
    }
    return false;
}

// ---- the wrong type ----------------------------------------------------------------------------

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
static const char *makers(const char *wanted, const char *given, const char *but)
{
    const char *found = "";
    if (text_is(wanted, "vec3") || header_parts(wanted)[0] == '\0')
        return "";
    for (size_t i = 0; i < headers.function_count; i++) {
        const DeclaredFunction *maker = &headers.functions[i];
        if (!text_is(maker->name, but) && text_is(maker->type, wanted) &&
            text_begins(maker->header, "exercises") &&
            strcmp(maker->header, headers.contract) <= 0 &&
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
    return text_group(without_brackets(mistake->message->ahead), "([A-Za-z_0-9]+)\\([^()]*$", 1);
}

// The name with its parts that begins at the caret.
static const char *expression_here(const Mistake *mistake)
{
    const Message *message = mistake->message;
    bool at_sign = text_matches(message->behind, "^(\\.|->)");
    return text_group(
        text_format("%s%s", at_sign ? text_expression_at_end(message->ahead) : "", message->behind),
        "^[A-Za-z_][A-Za-z_0-9]*((\\.|->)[A-Za-z_][A-Za-z_0-9]*)*", 0);
}

static bool is_pointer_to(const char *pointer, const char *type)
{
    return text_is(pointer, text_format("%s *", type)) ||
           text_is(pointer, text_format("%s*", type));
}

// Whether this declares a variable of this type and gives it a value:  Roots roots =
static bool declares_with_value(const char *code, const char *type)
{
    return text_is(text_group(code, "^ *(const )?([A-Za-z_0-9]+) +[A-Za-z_0-9]+ *=", 2), type);
}

// Who wants which type: "hit_sphere gives back a double (exercises/05-quadratic.h), and this is a
// Roots."
static const char *what_is_wanted(const Mistake *mistake, const char *here, const char *called)
{
    const char *header = header_of(here), *wanted = with_article(mistake->wanted);
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

static const char *help_types(const Mistake *mistake)
{
    const char *wanted = mistake->wanted, *given = mistake->given, *text = mistake->text;
    if (text_has(given, "(*)"))
        return text_format(
            "%s is a function here. A variable gets its value by =, as in Pixel pixel = "
            "{column, row};",
            expression_here(mistake));
    const char *here = answer_function_around(mistake->line), *called = called_at(mistake);
    const char *what = what_is_wanted(mistake, here, called);
    const DeclaredFunction *function = header_function(called);
    if (function != NULL && is_swapped(function, mistake->line))
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
    const char *by = makers(wanted, given, here);
    if (by[0] != '\0')
        return text_format("%s. %s.", what, by);
    if (function != NULL)
        return text_format("%s. Its prototype is  %s  in %s.", what, function->prototype,
                           function->header);
    if (declares_with_value(mistake->code, wanted))
        return text_format("%s. Is the type of the variable right?", what);
    const char *how = written(wanted), *values = header_values(wanted);
    if (how[0] != '\0')
        return text_format("%s. Write %s.", what, how);
    if (values[0] != '\0')
        return text_format("%s. %s is one of %s (%s).", what, capital(with_article(wanted)), values,
                           header_of(wanted));
    const char *parts = header_parts(given);
    return text_format("%s.%s", what,
                       parts[0] == '\0' ? "" : text_format(" Its parts are %s.", parts));
}

// ---- which of them -----------------------------------------------------------------------------

static bool lacks_closing_bracket(const Mistake *mistake)
{
    return answer_brackets(mistake->line) > 0;
}

static bool has_too_many_brackets(const Mistake *mistake)
{
    return answer_brackets(mistake->line) < 0;
}

static bool is_declaration(const Mistake *mistake)
{
    return begins_declaration(mistake->message->behind);
}

static const char *help_misspelled(const Mistake *mistake)
{
    if (mistake->keyword[0] != '\0')
        return text_format("%s is misspelled: %s.", mistake->slip, mistake->keyword);
    return mistake->decimal[0] == '\0'
               ? ""
               : text_format("%s is two numbers in C. If you mean one number, write %s.",
                             mistake->decimal, text_replaced(mistake->decimal, ",", "."));
}

// The end of the line before: a ; between a function and its {, or a comma.
static const char *help_line_before(const Mistake *mistake)
{
    size_t before = answer_code_before(mistake->line);
    const char *code = answer_code(before);
    if (text_begins(mistake->text, "expected identifier"))
        return !text_matches(code, "\\);$")
                   ? ""
                   : text_format("the ; at the end of line %zu separates the function from its "
                                 "{ }: remove it.",
                                 before);
    return !text_matches(code, ",$")
               ? ""
               : text_format("line %zu ends with a comma, but needs a semicolon.", before);
}

static const char *help_power_sign(const Mistake *mistake)
{
    return help_power(mistake, mistake->message->behind[0] == '^' ? "^ is exclusive or in C"
                                                                  : "C has no **");
}

static const char *help_cast(const Mistake *mistake)
{
    const char *cast = cast_to(mistake->code);
    return cast[0] == '\0' ? ""
                           : text_format("%s is written %s.", with_article(cast), written(cast));
}

// What depends on the kind of the mistake, and not on words of one message.
static const char *help_kind(const Mistake *mistake)
{
    bool has_wanted = mistake->wanted[0] != '\0';
    if (mistake->is_comma || (has_wanted && has_comma_in_statement(mistake)))
        return help_comma(mistake);
    if (is_vector_for_number(mistake))
        return help_vector(mistake);
    if (has_wanted && mistake->given[0] != '\0')
        return help_types(mistake);
    if (answer_ends_at_once(mistake->line) &&
        text_says(mistake->text, "clause does not guard|empty body"))
        return help_loop(mistake->line);
    return "";
}

static const char *help_initializer(const Mistake *mistake)
{
    return header_parts(mistake->wanted)[0] == '\0'
               ? ""
               : text_format("%s is expected here: %s.", with_article(mistake->wanted),
                             written(mistake->wanted));
}

// The first rule that holds and has words gives them. Patterns: of the compiler's words, of what is
// quoted ahead of the caret and behind it, and of the code of the line; NULL: of any. KIND: only of
// such a mistake. In the help,
// NAME is the first name that the compiler quotes, and CONTRACT the header of the chapter.
#define KIND(is_it) .kind = offsetof(Mistake, is_it)
static const struct {
    const char *words, *ahead, *behind, *code;
    size_t kind;
    bool (*holds)(const Mistake *mistake);
    const char *help;
    const char *(*by)(const Mistake *mistake);
} rules[] = {
    {KIND(is_pasted),
     .help = "a character that is not C was pasted there: a dash, a quote, a sign or a space that "
             "only looks like one. Delete it and type it again."},
    {.by = help_misspelled},
    {KIND(is_missing_brace), .by = help_brace},
    {KIND(is_outside),
     .help = "this is outside of every function: there is one } too many before it."},
    {.code = "^ *(import|using|from) ",
     .help = "C has no import: headers are included, as in #include \"CONTRACT\""},
    {"^expected", .behind = "^ *(and|or|not) ",
     .help = "and, or and not are written &&, || and ! in C."},
    {"operand of '[&|]'|^[&|] has lower precedence",
     .help = "&& is and, || is or; & and | work on bits."},
    {"^comparisons like", .help = "two comparisons are joined by &&: 0 < x && x < 1."},
    {"^expected identifier or '\\('", .code = "^\\{", .by = help_line_before},
    {"^expected expression", .ahead = "^ *$", .by = help_line_before},
    {KIND(is_unused_value),
     .code = "==", .help = "== compares; to give a variable a value, write =."},
    {"integer absolute value function", .help = INTEGER_ABS},
    {"used uninitialized|uninitialized when used",
     .help = "NAME is declared, but has no value yet."},
    {"No such file or directory|file not found",
     .help =
         "the contract of this chapter is #include \"CONTRACT\"; other headers are in common/."},
    {"^expected", .behind = "^ *x [A-Za-z(]",
     .help = "x is not an operator in C: * multiplies, and the cross product is vec3_cross(v, w)."},
    {"^expected '\\)'|^unterminated|at end of input", .holds = lacks_closing_bracket,
     .help = "a ) is missing: there are more ( than )."},
    {"before '\\)' token|^extraneous '\\)'|^expected expression$", .holds = has_too_many_brackets,
     .help = "one ) too many: there are more ) than (."},
    {"^expected '\\('", .code = "(^|[^A-Za-z_0-9])(if|while|for) +[^ (]",
     .help = "if, while and for need parentheses: if (x > 0)."},
    {"^expected '[})]'", "[A-Za-z_0-9)] *$", "^ *[A-Za-z_(]",
     .help = "an operator or a comma is missing there (2 t is 2 * t)."},
    {"^expected expression", "= *$", "^[<>]", .help = "C writes >= and <=, not => and =<."},
    {"^(expected expression( before '[A-Za-z]|$)|unexpected type name)", "^ *$",
     .holds = is_declaration,
     .help = "a declaration after if, else or for needs braces around it: { }."},
    {"^subscripted value", .by = help_subscript},
    {"^invalid operands to binary|^cannot convert between vector and non-scalar",
     .behind = "^([^^]|$)", .by = help_operands},
    {"assignment used as truth value|result of an assignment as a condition",
     .help = "= assigns; to compare, write ==."},
    {"^expected expression|^unexpected type name", .by = help_expression},
    {.by = help_semicolon},
    {"invalid type argument of '->'|^member reference type .* is (not )?a pointer|"
     "is a pointer; did you mean",
     .by = help_arrow},
    {"^request for member|^member reference base type", .by = help_parts},
    {"no member named|does not refer to any field", .by = help_member},
    {"^invalid operands to binary", .behind = "^\\^", .by = help_power_sign},
    {"^invalid type argument of unary '\\*'|^indirection requires pointer", .code = "\\*\\*",
     .by = help_power_sign},
    {"^invalid type argument of unary '\\*'|^indirection requires pointer",
     .help =
         "a * in front of a name reads through a pointer, and this is not a pointer: remove the "
         "*."},
    {"^invalid (suffix|digit) .* (integer|decimal|floating) constant", .by = help_times},
    {"^called object", .by = help_call},
    {"^conversion to non-scalar type|^used type '[A-Za-z]*' where arithmetic|"
     "^cannot convert a value of type .* to vector type|^invalid conversion between vector type",
     .by = help_cast},
    {.by = help_kind},
    {KIND(is_unknown), .by = help_unknown},
    {KIND(is_count), .by = help_count},
    {KIND(is_signature), .by = help_signature},
    {"clause does not guard|^misleading indentation",
     .help = "without braces { } only one statement belongs to it."},
    {"^type defaults to 'int'|^type specifier missing", .code = "^ *auto ", .by = help_unknown},
    {"discards '?(const|qualifiers)",
     .help = "the data it points to must not change: put const in front of the pointer's type."},
    {"^parameter names .without types|^a parameter list without types",
     .help = "that declares a function. A variable gets its value by =, as in Pixel pixel = "
             "{column, row};"},
    {"^invalid initializer", .by = help_initializer},
    {"^'return' with no value|should return a value",
     .help = "return without a value: this function must return one. Write it after return."},
    {KIND(is_missing_return), .by = help_missing_return},
};

static bool has(const char *text, const char *pattern)
{
    return pattern == NULL || text_matches(text, pattern);
}

const char *help(const Mistake *mistake)
{
    const char *said = "";
    for (size_t i = 0; i < sizeof rules / sizeof *rules && said[0] == '\0'; i++)
        if (has(mistake->text, rules[i].words) && has(mistake->message->ahead, rules[i].ahead) &&
            has(mistake->message->behind, rules[i].behind) && has(mistake->code, rules[i].code) &&
            (rules[i].kind == 0 || *(const bool *)((const char *)mistake + rules[i].kind)) &&
            (rules[i].holds == NULL || rules[i].holds(mistake)))
            said = rules[i].by != NULL
                       ? rules[i].by(mistake)
                       : text_replaced(text_replaced(rules[i].help, "NAME", mistake->name),
                                       "CONTRACT", headers.contract);
    return said;
}
