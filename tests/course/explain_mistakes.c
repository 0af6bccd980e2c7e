// explain_mistakes.c - see explain_mistakes.h. The words of gcc and clang for each kind of mistake.
#include "tests/course/explain_mistakes.h"

#include <ctype.h>
#include <string.h>

// ---- kinds --------------------------------------------------------------------------------------

static bool is_syntax(const char *text)
{
    return text_says(
        text, "^expected |^unexpected type name|^extraneous|^invalid suffix |^invalid digit ");
}

// A semicolon among the expected tokens, not among those that were found.
bool is_semicolon(const Mistake *mistake)
{
    const char *text = mistake->text;
    return !text_matches(text, " before '\\{'|or '\\)'") &&
           text_matches(text_without(text, " before .*"), "^expected .*';'");
}

static bool has_foreign_byte(const char *text)
{
    for (; *text != '\0'; text++)
        if ((unsigned char)*text >= 0x80)
            return true;
    return false;
}

static bool is_pasted(const Explanation *all, const Mistake *mistake)
{
    const char *behind = mistake->message->behind;
    return (text_begins(mistake->text, "expected") && behind[text_span(behind, " ")] == '?' &&
            has_foreign_byte(answer_text(&all->code.answer, mistake->line))) ||
           text_says(mistake->text,
                     "\\U0000|identifier '?|^stray '\\2|^stray '\\3|^unexpected character <U+|"
                     "^unexpected character U+|^character <U+|^character U+|^treating Unicode|"
                     "^non-ASCII|^source file is not valid UTF-8|^extended character");
}

static bool is_unknown(const char *text)
{
    return text_says(text, "undeclared|^implicit declaration of function|^implicitly declaring|"
                           "^unknown type name|^call to undeclared");
}

static bool is_signature(const char *text)
{
    return text_says(text, "^conflicting types for|^redefinition of|^static declaration of|"
                           "doesn't match prototype|redeclared as different kind");
}

static bool is_missing_return(const char *text)
{
    return text_says(text, "control reaches end of non-void|no return statement in function|"
                           "should return a value|does not return a value|^'return' with no value");
}

static bool is_unused_value(const char *text)
{
    return text_says(text, "^value computed is not used|^expression result unused|"
                           "^statement with no effect|^equality comparison result unused");
}

static bool is_comma(const char *text)
{
    return text_says(text, "left operand of comma|left-hand operand of comma|misuse of comma");
}

static bool may_be_decimal_comma(const char *text)
{
    return is_comma(text) || is_unused_value(text) ||
           text_says(text, "^too many arguments|^excess elements|"
                           "^expected identifier or '(' before numeric constant") ||
           text_is(text, "expected identifier or '('");
}

static bool is_missing_brace(const char *text)
{
    return text_says(text, "^expected declaration or statement at end of input|^expected '}'|"
                           "^function definition is not allowed here");
}

// A statement, or a }, where only functions may be.
static bool is_outside(const char *text, const char *code)
{
    if (text_begins(text, "extraneous closing brace"))
        return true;
    if (!text_begins(text, "expected identifier or '('"))
        return false;
    return text_matches(text, " before ('\\}'|'(for|if|while|return|else|switch|do)')") ||
           (text_is(text, "expected identifier or '('") &&
            text_matches(code, "^ *(for|if|while|return|else|switch|do|\\})([^A-Za-z_0-9]|$)"));
}

// A vector where there should be a number.
bool is_vector_for_number(const Mistake *mistake)
{
    if (mistake->wanted[0] != '\0')
        return is_vector_type(mistake->given) && is_number(mistake->wanted);
    return text_matches(mistake->text,
                        "(double|float|int)' (using|from) type 'vec3'|used vector type where|"
                        "^wrong type argument to unary|^aggregate value used where|"
                        "requires expression of scalar type|invalid conversion between vector type|"
                        "logical expression with vector type|^used type .*vector|"
                        "^invalid argument type .*vector|(convert|conversion).*vec3.*double");
}

// ---- keywords -----------------------------------------------------------------------------------

// The word without the letter at i, or with it and the next one the other way round.
static const char *without_letter(const char *word, size_t i)
{
    return text_format("%.*s%s", (int)i, word, text_from(word, i + 1));
}

static const char *exchanged(const char *word, size_t i)
{
    return text_format("%.*s%c%c%s", (int)i, word, word[i + 1], word[i], text_from(word, i + 2));
}

// One slip of the fingers; in short words only two letters the wrong way round.
static bool is_near(const char *name, const char *word)
{
    size_t size = strlen(word), length = strlen(name);
    if (length + 1 < size || length > size + 1 || text_is(name, word))
        return false;
    if (strcasecmp(name, word) == 0)
        return true;
    for (size_t i = 0; i < size + 1; i++) {
        if (i + 1 < size && text_is(name, exchanged(word, i)))
            return true;
        if (size > 3 && i < size && text_is(name, without_letter(word, i)))
            return true;
        if (size > 3 && i < length && text_is(word, without_letter(name, i)))
            return true;
        if (size > 5 && i < size && length == size &&
            text_is(without_letter(name, i), without_letter(word, i)))
            return true;
    }
    return false;
}

// The keyword that a name in this code was meant to be, by its letters and what is around it; or
// "".
static const char *misspelled(const char *name, const char *code)
{
    static const char *const begin_statements[] = {"return", "else",   "while", "for",
                                                   "if",     "switch", "break", "continue"};
    static const char *const types[] = {"double", "float", "int",    "bool",
                                        "const",  "void",  "static", "struct"};
    if (!text_has_word(code, name))
        return "";
    const char *at = strstr(code, name);
    while ((at > code && is_word_character(at[-1])) || is_word_character(at[strlen(name)]))
        at = strstr(at + 1, name);
    const char *before = text_part(code, 0, (size_t)(at - code)), *after = at + strlen(name);
    if (text_matches(before, "(^|[;{})]|[^A-Za-z_0-9]else) *$") &&
        !text_matches(after, "^ *([+*=.,)]|/|])"))
        for (size_t i = 0; i < sizeof begin_statements / sizeof *begin_statements; i++)
            if (is_near(name, begin_statements[i]) &&
                (!text_is_one_of(begin_statements[i], "while for if switch") ||
                 after[text_span(after, " ")] == '('))
                return begin_statements[i];
    if (text_matches(after, "^ *\\*?[A-Za-z_]"))
        for (size_t i = 0; i < sizeof types / sizeof *types; i++)
            if (is_near(name, types[i]))
                return types[i];
    return "";
}

// ---- types --------------------------------------------------------------------------------------

// Which type was wanted and which was given, if the message says so.
static void find_types(const Explanation *all, Mistake *mistake)
{
    const char *words =
        mistake->message->argument[0] != '\0' ? mistake->message->argument : mistake->text;
    if (text_says(words, "^incompatible types when initializing|"
                         "^incompatible types when assigning|^assigning to '") ||
        (text_begins(words, "expected '") && text_has(words, "' but argument is of type")) ||
        (text_begins(words, "initializing '") &&
         text_has(words, "' with an expression of incompatible"))) {
        mistake->wanted = bare_type(quoted(words));
        mistake->given = bare_type(quoted_second(words));
    } else if (text_says(words, "^incompatible types when returning|"
                                "^incompatible pointer types passing") ||
               (text_begins(words, "returning '") && text_has(words, "' from a function")) ||
               (text_begins(words, "passing '") && text_has(words, "' to parameter"))) {
        mistake->given = bare_type(quoted(words));
        mistake->wanted = bare_type(quoted_second(words));
    } else if (text_begins(words, "invalid initializer")) {
        const char *name = text_expression_at_end(text_before(mistake->code, "="));
        mistake->wanted = type_of(&all->code, name, mistake->line);
        const char *value = text_before(text_without(mistake->code, "[^=]*= *"), ";");
        mistake->given = type_of_argument(&all->code, value, mistake->line);
    }
    Match match;
    if (text_find(mistake->given, " ?\\* ?const$", &match))
        mistake->given = text_format("%s *", text_part(mistake->given, 0, match.at));
}

// The name that a line with a misspelled type declares.
static const char *declared_by(const Mistake *mistake)
{
    Match match;
    if (!mistake->is_unknown || !text_has_word(mistake->code, mistake->name) ||
        text_has(mistake->text, "function '"))
        return "";
    const char *after = strstr(mistake->code, mistake->name) + strlen(mistake->name);
    return text_find(after, "^ +\\**[A-Za-z_][A-Za-z_0-9]*", &match)
               ? text_replaced(text_part(after, 0, match.length), "[ *]+", "")
               : "";
}

// ---- letters ------------------------------------------------------------------------------------

static void add_to(const char **list, const char *what)
{
    if (!text_has(text_format(", %s,", *list), text_format(", %s,", what)))
        *list = text_format("%s%s%s", *list, (*list)[0] == '\0' ? "" : ", ", what);
}

static bool is_one_letter(const char *name)
{
    return isalpha((unsigned char)name[0]) && name[1] == '\0';
}

// The deck's letter of c.d, which no Camera has: "d is c.distance".
static const char *letter_of_whole(const Mistake *mistake)
{
    if (!text_has(mistake->text, "no member named"))
        return "";
    bool name_first = mistake->text[0] == '\'';
    const char *first = quoted(mistake->text), *second = quoted_second(mistake->text);
    const char *type = bare_type(name_first ? first : second),
               *letter = name_first ? second : first;
    const char *name =
        text_expression_at_end(text_without(mistake->message->ahead, " *(\\.|->) *$"));
    const char *part = part_of_deck(type, letter);
    return name[0] == '\0' || part[0] == '\0'
               ? ""
               : text_format("%s" UNBROKEN "is" UNBROKEN "%s.%s", letter, name, part);
}

static void find_letters(Explanation *all, Mistake *mistake)
{
    AboutFunction *about = &all->about[mistake->begins];
    const char *owner;
    bool is_letter = mistake->is_unknown && is_one_letter(mistake->name) &&
                     !text_says(mistake->text, "function '|unknown type") &&
                     answer_loop_of(&all->code.answer, mistake->name, mistake->line) == 0;
    mistake->translation =
        is_letter ? translated(&all->code, mistake->name, mistake->line, about->strange_letters)
                  : letter_of_whole(mistake);
    if (mistake->translation[0] != '\0')
        add_to(&about->letters, mistake->translation);
    else if (is_letter && whole_of(&all->code, mistake->name, mistake->line, &owner)[0] == '\0')
        add_to(&about->strange_letters, mistake->name);
    else
        is_letter = false;
    mistake->is_letter = is_letter || mistake->translation[0] != '\0';
}

// ---- consequences ----------------------------------------------------------------------------

static bool is_about_argument(const char *text)
{
    return text_matches(text, "argument [0-9]+ of '");
}

// Of the same statement.
static bool follows_in_statement(const Mistake *j, const Mistake *i)
{
    bool later = j > i, is_warning = j->message->is_warning;
    if (i->decimal[0] != '\0' && (j->decimal[0] != '\0' ? later : is_warning))
        return true;
    if (i->is_syntax && (!j->is_syntax || later) &&
        (!is_warning ||
         text_says(j->text, "clause does not guard|^misleading|operand of comma|no effect")))
        return true;
    if (i->is_count && text_says(j->text, "^incompatible type for argument|^passing "))
        return true;
    if (!i->message->is_warning && j->is_comma)
        return true;
    if (!later)
        return false;
    return text_is(i->text, j->text) ||
           (is_about_argument(i->text) && is_about_argument(j->text) &&
            text_is(i->name, j->name)) ||
           (text_says(i->text, "'->'|member reference type") &&
            text_says(j->text, "'->'|no member named")) ||
           (i->is_comma && j->is_comma);
}

// Of the same function.
static bool follows_in_function(const Explanation *all, const Mistake *j, const Mistake *i)
{
    const Answer *answer = &all->code.answer;
    bool later = j > i, is_warning = j->message->is_warning;
    if (i->is_letter && j->is_letter && later &&
        (i->translation[0] == '\0') == (j->translation[0] == '\0'))
        return true;
    if (i->is_signature && !text_begins(i->text, "static"))
        return true;
    if (i->is_outside)
        return later || is_warning || j->is_missing_return;
    if (i->is_missing_return)
        return j->is_unused_value;
    if (!i->message->is_warning &&
        (j->is_missing_return ||
         text_says(j->text, "^missing initializer|^unused variable|set but not used")))
        return true;
    if (later && i->is_unknown && j->is_unknown && text_is(i->name, j->name))
        return true;
    if (i->is_unknown && text_says(j->text, "clause does not guard|empty body") &&
        answer_ends_at_once(answer, j->line) && answer_loop_of(answer, i->name, i->line) == j->line)
        return true;
    if (i->is_unknown && i->line == i->begins && text_has(j->text, "'int'"))
        return true;
    if (later && i->declares[0] != '\0' && text_has_word(j->code, i->declares))
        return true;
    // The declaration that lost its semicolon took the next one with it; brackets, the function.
    return i->is_syntax && later && (j->is_outside || text_has(j->text, "undeclared"));
}

// Whether message j only follows from message i.
static bool follows(const Explanation *all, const Mistake *j, const Mistake *i)
{
    bool later = j > i, is_warning = j->message->is_warning;
    if (i->lacks_contract && (later || is_warning))
        return true;
    if (i->is_pasted && i->line == j->line && (later || !j->is_pasted))
        return true;
    if (i->is_missing_brace && j->line >= all->open_function)
        return j->is_missing_brace
                   ? later
                   : j->is_missing_return ||
                         text_matches(j->text,
                                      "defined but not used|^unused |invalid storage class|"
                                      "[Mm]isleading|clause does not guard|nested function|"
                                      "declared .* but never defined|follows non-static");
    if (i->statement == j->statement && follows_in_statement(j, i))
        return true;
    if (i->is_signature && later && text_has_word(j->text, i->name))
        return true;
    // An undeclared name is treated as a function that returns an int; gcc says so only once.
    if (i->is_unknown && (i->statement == j->statement || text_has_word(j->code, i->name)) &&
        text_says(j->text, "'int'|invalid initializer|subscripted value|incompatible implicit|"
                           "type mismatch in conditional"))
        return true;
    return i->begins != 0 && i->begins == j->begins && follows_in_function(all, j, i);
}

static void drop_what_follows(Explanation *all)
{
    for (size_t i = 0; i < all->count; i++)
        for (size_t j = 0; j < all->count; j++)
            if (j != i && !all->mistakes[i].is_dropped && !all->mistakes[j].is_dropped &&
                follows(all, &all->mistakes[j], &all->mistakes[i]))
                all->mistakes[j].is_dropped = true;
}

// ---- all together -------------------------------------------------------------------------------

bool has_comma_in_statement(const Explanation *all, const Mistake *mistake)
{
    for (size_t i = 0; i < all->count; i++)
        if (all->mistakes[i].is_comma && all->mistakes[i].statement == mistake->statement)
            return true;
    return false;
}

static void understand(Explanation *all, Mistake *mistake)
{
    const Code *code = &all->code;
    const char *text = mistake->text, *name = mistake->name;
    Match match;
    mistake->begins = answer_beginning(&code->answer, mistake->line);
    mistake->statement = answer_statement(&code->answer, mistake->line);
    mistake->is_unknown = is_unknown(text);
    find_letters(all, mistake);
    mistake->lacks_contract = mistake->is_unknown &&
                              !answer_includes(&code->answer, code->contract) &&
                              header_of(&code->headers, name) != NULL;
    mistake->is_pasted = is_pasted(all, mistake);
    // gcc reports only once that the function fro does not exist.
    mistake->slip = name;
    if (text_begins(text, "expected expression before '") &&
        text_find(mistake->message->ahead, "[a-z]+ *\\($", &match))
        mistake->slip = text_before(mistake->message->ahead + match.at, "(");
    mistake->keyword = mistake->is_unknown || !text_is(mistake->slip, name)
                           ? misspelled(mistake->slip, mistake->code)
                           : "";
    mistake->is_syntax = is_syntax(text) || mistake->is_pasted || mistake->keyword[0] != '\0' ||
                         (mistake->is_unknown && text_is_one_of(name, "std new let var def"));
    mistake->is_count =
        text_says(text, "^too few arguments to function|^too many arguments to function");
    mistake->is_signature = is_signature(text);
    mistake->is_missing_return = is_missing_return(text);
    mistake->is_missing_brace = all->open_function != 0 && is_missing_brace(text);
    mistake->is_outside = is_outside(text, mistake->code);
    find_types(all, mistake);
    mistake->decimal =
        may_be_decimal_comma(text) ? answer_decimal_comma(&code->answer, mistake->line) : "";
    mistake->is_comma = is_comma(text);
    mistake->is_unused_value = is_unused_value(text);
    if (mistake->is_unused_value && all->about[mistake->begins].lost == 0)
        all->about[mistake->begins].lost = mistake->line;
    mistake->declares = declared_by(mistake);
}

Explanation explanation_of(const char *source, const char *words)
{
    const char *slash = strrchr(source, '/'), *stem = slash == NULL ? source : slash + 1;
    size_t length = strlen(stem);
    length -= length > 2 && text_is(stem + length - 2, ".c") ? 2 : 0;
    Explanation all = {.code = {.answer = answer_read(source),
                                .headers = headers_read(),
                                .contract = text_format("exercises/%.*s.h", (int)length, stem)}};
    all.diagnostics = diagnostics_read(&all.code.answer, words);
    all.count = all.diagnostics->count;
    all.mistakes = text_memory((all.count + 1) * sizeof *all.mistakes);
    all.open_function = answer_unclosed(&all.code.answer);
    all.about = text_memory((all.code.answer.count + 1) * sizeof *all.about);
    for (size_t i = 0; i <= all.code.answer.count; i++)
        all.about[i].letters = all.about[i].strange_letters = "";
    for (size_t i = 0; i < all.count; i++) {
        const Message *message = &all.diagnostics->messages[i];
        all.mistakes[i] = (Mistake){.message = message,
                                    .text = message->text,
                                    .line = message->line_number,
                                    .code = answer_code(&all.code.answer, message->line_number),
                                    .name = quoted(message->text),
                                    .wanted = "",
                                    .given = ""};
        understand(&all, &all.mistakes[i]);
    }
    drop_what_follows(&all);
    return all;
}
