// explain_help_names.c - help for names that nobody has declared, and for those that are declared
// twice.
#include "tests/course/explain_mistakes.h"

#include <string.h>

// ---- names that are known elsewhere -------------------------------------------------------------

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
    {"<stdlib.h>", "malloc calloc realloc free abs exit rand srand qsort atof atoi"},
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

// ---- names of other languages -------------------------------------------------------------------

static const char *help_other_language(const char *name)
{
    if (text_is(name, "M_PI"))
        return "C11 has no M_PI: write PI (common/vec3.h).";
    if (text_is(name, "std"))
        return "C has no std:: - the functions of <math.h> have no such prefix, as in sqrt(x).";
    if (text_is(name, "new"))
        return "C has no new: a struct is written (Ray){origin, direction}, a vec3 vec3_of(x, y, "
               "z).";
    if (text_is_one_of(name, "let var auto def"))
        return text_format("C has no %s: declare a new variable with its type, as in double x or "
                           "vec3 v.",
                           name);
    if (text_matches(name, "^return[a-z]"))
        return text_format("a space is missing: return %s", name + strlen("return"));
    return "";
}

static const char *help_known(const Headers *headers, const char *name)
{
    const char *here = known_as(name);
    const DeclaredFunction *function = header_function(headers, here);
    if (function != NULL)
        return text_format("here its name is %s: %s  in %s.", here, function->prototype,
                           function->header);
    return text_format("in C its name is %s.", here);
}

// ---- names that are nearly right ----------------------------------------------------------------

// camera.width, if the camera has another name here.
static const char *help_whole(const Explanation *all, const Mistake *mistake)
{
    const char *behind = mistake->message->behind, *name = mistake->name, *owner;
    if (!text_begins(behind, name))
        return "";
    behind += strlen(name);
    size_t sign = behind[0] == '.' ? 1 : text_begins(behind, "->") ? 2 : 0;
    size_t length = text_span_of_word(behind + sign);
    if (sign == 0 || length == 0)
        return "";
    const char *whole =
        whole_of(&all->code, text_part(behind, sign, length), mistake->line, &owner);
    if (whole[0] == '\0')
        return "";
    return text_format("nothing here is called %s. %s has another name here: write %s.", name,
                       owner[0] == '\0' ? "It" : text_format("The %s", owner), whole);
}

// width, if camera.width is meant.
static const char *help_part(const Explanation *all, const Mistake *mistake)
{
    const char *owner, *whole = whole_of(&all->code, mistake->name, mistake->line, &owner);
    if (whole[0] == '\0')
        return "";
    if (owner[0] == '\0')
        return text_format("%s is the name of parts: write %s.", mistake->name, whole);
    return text_format("%s is a part of %s (%s): write %s.", mistake->name, with_article(owner),
                       header_of(&all->code.headers, owner), whole);
}

// The name that the compiler suggests, if a header declares it.
static const char *help_thought_of(const Explanation *all, const Mistake *mistake)
{
    const Message *message = mistake->message;
    for (size_t i = 0; i <= message->body.count; i++) {
        const char *line = i == 0 ? mistake->text : message->body.line[i - 1];
        Match match;
        if (!text_find(line, "did you mean '[A-Za-z_0-9]+'", &match))
            continue;
        const char *thought = quoted(line + match.at),
                   *header = header_of(&all->code.headers, thought);
        return header == NULL || strcasecmp(thought, mistake->name) == 0
                   ? ""
                   : text_format("nothing here is called %s. %s is in %s.", mistake->name, thought,
                                 header);
    }
    return "";
}

// " The parameters of NAME are Camera c, double s and double t."; "" if there are none.
static const char *parameters_of(const Code *code, size_t line)
{
    Scope scope = scope_of(code, line);
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
                       answer_function_around(&code->answer, line),
                       scope.parameters == 1 ? "is" : "are", list);
}

static const char *help_nothing(const Explanation *all, const Mistake *mistake, bool is_variable)
{
    const Code *code = &all->code;
    const char *given = is_variable ? parameters_of(code, mistake->line) : "";
    if (strlen(mistake->name) > 1)
        return text_format("nothing here is called %s. Is it spelled as in the contract, %s?%s",
                           mistake->name, code->contract, given);
    return text_format(
        "nothing here is called %s.%s Declare a variable of your own first, with its type.",
        mistake->is_letter ? all->about[mistake->begins].strange_letters : mistake->name, given);
}

// The name in a loop: declared in another one, or in none.
static const char *help_name_of_loop(const Explanation *all, const Mistake *mistake)
{
    const Answer *answer = &all->code.answer;
    const char *name = mistake->name;
    Match match;
    if (text_find(mistake->code, "(^|[^A-Za-z_0-9])for *\\( *", &match)) {
        const char *first = mistake->code + match.at + match.length;
        if (text_begins(first, name) && text_matches(first + strlen(name), "^ *="))
            return text_format("%s is not declared: for (int %s = ...; ...; ...).", name, name);
    }
    size_t loop = answer_loop_of(answer, name, mistake->line);
    if (loop == 0)
        return "";
    return answer_ends_at_once(answer, loop)
               ? help_loop(all, loop)
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
static const char *help_declared_elsewhere(const Explanation *all, const Mistake *mistake,
                                           bool is_function)
{
    const Answer *answer = &all->code.answer;
    const char *name = mistake->name, *standard = library_of(mistake);
    const OwnFunction *own = answer_function_named(answer, name);
    if (standard[0] != '\0')
        return text_format("%s is in the standard library: #include %s", name, standard);
    if (own != NULL && own->line > mistake->line && is_function)
        return text_format("%s is defined further down, in line %zu: move it above its use.", name,
                           own->line);
    if (mistake->lacks_contract)
        return text_format("#include \"%s\" is missing at the top of this file.",
                           all->code.contract);
    return "";
}

static const char *help_spelling(const Explanation *all, const Mistake *mistake, bool is_function,
                                 bool is_type)
{
    const Headers *headers = &all->code.headers;
    const char *name = mistake->name;
    if (text_begins(mistake->text, "unknown type name") && is_vector_of_others(name))
        return "the type of points, vectors and colours is vec3 (common/vec3.h).";
    if (known_as(name)[0] != '\0')
        return help_known(headers, name);
    if (text_is_one_of(name, "sqr sq square squared"))
        return "C has no square: write x * x.";
    const char *loop = help_name_of_loop(all, mistake);
    if (loop[0] != '\0')
        return loop;
    const DeclaredName *like = header_name_like(headers, name, is_type, all->code.contract);
    if (like != NULL)
        return text_format("nothing here is called %s. It is written %s (%s).", name, like->name,
                           like->header);
    const char *thought = help_thought_of(all, mistake), *type = capital(name);
    if (thought[0] != '\0')
        return thought;
    if (!is_function && !is_type && header_parts(headers, type)[0] != '\0')
        return text_format(
            "nothing here is called %s. A %s of your own must be declared first: %s" UNBROKEN
            "%s" UNBROKEN "=" UNBROKEN "...;",
            name, type, type, name);
    return "";
}

// Declared here, as far as the text shows, and not by a loop that has ended: the compiler lost it
// because of another mistake.
static bool is_lost(const Code *code, const char *name, size_t line)
{
    Scope scope = scope_of(code, line);
    for (size_t i = 0; i < scope.count; i++)
        if (text_is(scope.variables[i].name, name))
            return answer_loop_of(&code->answer, name, line) == 0;
    return false;
}

const char *help_unknown(const Explanation *all, const Mistake *mistake)
{
    const Headers *headers = &all->code.headers;
    const char *name = mistake->is_unknown ? mistake->name : "auto";
    bool is_function = text_has(mistake->text, "function '"),
         is_type = text_has(mistake->text, "unknown type");
    const char *words = help_other_language(name);
    if (words[0] == '\0')
        words = help_declared_elsewhere(all, mistake, is_function);
    if (words[0] == '\0' && mistake->translation[0] != '\0')
        words = text_format("the slide's %s.", all->about[mistake->begins].letters);
    if (words[0] == '\0' && !is_function && !is_type && is_lost(&all->code, name, mistake->line))
        return "";
    if (words[0] == '\0')
        words = help_whole(all, mistake);
    if (words[0] == '\0' && !is_function)
        words = help_part(all, mistake);
    const char *header = header_of(headers, name);
    if (words[0] == '\0' && header != NULL && !answer_includes(&all->code.answer, header) &&
        !text_is(header, all->code.contract))
        words = text_format("%s is declared in another file: #include \"%s\"", name, header);
    if (words[0] == '\0')
        words = help_spelling(all, mistake, is_function, is_type);
    return words[0] == '\0' ? help_nothing(all, mistake, !is_function && !is_type) : words;
}

// ---- names that are declared twice --------------------------------------------------------------

static const char *help_redefinition(const Explanation *all, const Mistake *mistake,
                                     const char *name)
{
    const Answer *answer = &all->code.answer;
    const char *header = header_of(&all->code.headers, name);
    for (size_t i = 0; i < answer->function_count && answer->functions[i].line < mistake->line; i++)
        if (text_is(answer->functions[i].name, name))
            return text_format("%s is already defined in line %zu.", name,
                               answer->functions[i].line);
    return header == NULL ? ""
                          : text_format("%s is already in %s: use it, or give yours another name.",
                                        name, header);
}

const char *help_signature(const Explanation *all, const Mistake *mistake)
{
    const Code *code = &all->code;
    const char *here = answer_function_around(&code->answer, mistake->line);
    const char *name = text_begins(mistake->text, "argument") ? here : mistake->name;
    Scope scope = scope_of(code, mistake->line);
    for (size_t i = 0; i < scope.parameters; i++)
        if (text_is(scope.variables[i].name, name))
            return text_format("%s is already a parameter of %s: give yours another name.", name,
                               here);
    if (text_begins(mistake->text, "redefinition"))
        return help_redefinition(all, mistake, name);
    const DeclaredFunction *function = header_function(&code->headers, name);
    if (function == NULL)
        return "";
    if (text_has(mistake->text, "static declaration"))
        return text_format("remove the static in front of %s: other files call it.", name);
    if (text_is(function->header, code->contract))
        return text_format("the contract, %s, says  %s: your function must begin like that.",
                           code->contract, function->prototype);
    return text_format("%s is already in %s, as  %s: give yours another name.", name,
                       function->header, function->prototype);
}
