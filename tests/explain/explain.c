// explain.c - the parts of a compiler's and a linker's output that help a student.
//
// Read from the text that gcc and clang write for people, not from JSON or SARIF: the head of a
// message, FILE:LINE:COLUMN: error: WORDS, and the quote below it have been the same in all
// versions of both, and the quote is shown as it is. gcc's JSON leaves the quote out and goes away
// with gcc 15; SARIF needs gcc 13 or clang 15; clang 14 has neither.
//
// Each message is of some kinds (the table kinds). Messages that only follow from another are
// dropped (the table consequences). The others are shown, each with the first line of help that
// holds (the table in rules.c).
#include "tests/explain/explain.h"

#include "tests/explain/parts.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SHOWN = 3, COLUMNS = 79, MOST_SLIPS = 50 };

#define MACRO "^ *# *define +([A-Za-z_0-9]+)"

Explanation all;

// ---- kinds -------------------------------------------------------------------------------------

static const struct {
    unsigned kinds;
    const char *words;
} kinds[] = {
    {UNKNOWN_FUNCTION,
     "^(implicit declaration of function|implicitly declaring|call to undeclared)"},
    {UNKNOWN_VARIABLE, "undeclared (\\(first|here|identifier)"},
    {UNKNOWN_TYPE, "^unknown type name"},
    {SYNTAX, "^(expected |unexpected type name|extraneous|invalid suffix |invalid digit )"},
    {PASTED | SYNTAX, "\\\\U0000|identifier '[?]|^stray '.[23]|^(unexpected )?character <?U[+]|"
                      "^(treating Unicode|non-ASCII|source file is not valid UTF-8|"
                      "extended character)"},
    {MISSING_BRACE, "^(expected declaration or statement at end of input|expected '}'|"
                    "function definition is not allowed here)"},
    {OUTSIDE, "^extraneous closing brace|"
              "^expected identifier or '\\(' before '(}|for|if|while|return|else|switch|do)'"},
    {COUNT, "^too (few|many) arguments to function"},
    {ARGUMENT, "argument [0-9]+ of '"},
    {CONFLICT, "^(conflicting types for|redefinition of)|doesn't match prototype|"
               "redeclared as different kind"},
    {STATIC, "^static declaration of"},
    {MISSING_RETURN, "control reaches end of non-void|no return statement in function|"
                     "should return a value|does not return a value|^'return' with no value"},
    {UNUSED_VALUE | DECIMAL, "^(value computed is not used|expression result unused|"
                             "statement with no effect|equality comparison result unused)"},
    {COMMA | DECIMAL, "left(-hand)? operand of comma|misuse of comma"},
    {DECIMAL, "^right-hand operand of comma|^too many arguments|^excess elements|"
              "^expected identifier or '\\('( before numeric constant|$)"},
    {ENDS_AT_ONCE, "clause does not guard|empty body"},
    {ARROW, "'->'|member reference type"},
    {UNTERMINATED, "^unterminated function-like macro"},
    {AT_END, "at end of input"},
    {VECTOR, "(double|float|int)' (using|from) type 'vec3'|used vector type where|"
             "^wrong type argument to unary|^aggregate value used where|"
             "requires expression of scalar type|invalid conversion between vector type|"
             "logical expression with vector type|^used type .*vector|"
             "^invalid argument type .*vector|(convert|conversion).*vec3.*double"},
};

// What needs no more than the answer.
static void find_kinds(Mistake *mistake)
{
    const char *text = mistake->text;
    mistake->code = answer_code(mistake->line);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (text_matches(text, kinds[i].words))
            mistake->kinds |= kinds[i].kinds;
    if (text_is(text, "expected identifier or '('") &&
        text_matches(mistake->code, "^ *(for|if|while|return|else|switch|do|})([^A-Za-z_0-9]|$)"))
        mistake->kinds |= OUTSIDE;
    if (text_begins(text, "expected") && text_matches(mistake->behind, "^ *[?]") &&
        text_matches(answer_text(mistake->line), "[^\001-\177]"))
        mistake->kinds |= PASTED;
    // A semicolon among the expected tokens, not among those that were found.
    if (text_matches(text_replaced(text, " before .*", ""), "^expected .*';'") &&
        !text_matches(text, " before '\\{'|or '\\)'"))
        mistake->kinds |= SEMICOLON;
    if (all.open_function == 0)
        mistake->kinds &= ~(unsigned)MISSING_BRACE;
    if (mistake->kinds & MISSING_BRACE)
        mistake->kinds &= ~(unsigned)SYNTAX;
    mistake->decimal = mistake->kinds & DECIMAL ? answer_decimal_comma(mistake->line) : "";
    if (mistake->decimal[0] == '\0')
        mistake->kinds &= ~(unsigned)DECIMAL;
    mistake->kinds |= mistake->is_warning                                   ? WARNING
                      : (mistake->kinds & (MISSING_RETURN | MISSING_BRACE)) ? 0
                                                                            : ERROR;
}

// ---- reading the compiler's words --------------------------------------------------------------

// Plain ASCII without colours, typographic quotes, tabs, or the type behind vec3, which gcc and
// clang add.
static const char *plain(const char *line)
{
    line = text_replaced(text_part(line, 0, LONGEST_LINE), "\033\\[[0-9;]*[mK]", "");
    line = text_replaced(line, "\342\200\230|\342\200\231", "'");
    char *text = text_copy(line), *end = text;
    for (unsigned char before = 0; *line != '\0'; before = (unsigned char)*line++)
        if (before < 0x80 || ((unsigned char)*line & 0xC0) != 0x80) // one '?' for a character
            *end++ = *line == '\t' ? ' ' : *line >= ' ' && *line <= '~' ? *line : '?';
    while (end > text && end[-1] == ' ')
        end--;
    *end = '\0';
    if (!text_matches(text, "aka |vector"))
        return text;
    line = text_replaced(text, " \\{aka [^}]*\\}| \\(aka '[^']*'\\)", "");
    line = text_replaced(line, " \\(vector of 4 '[a-z ]*' values\\)", "");
    line =
        text_replaced(line, "__attribute__\\(\\(__vector_size__\\([^)]*\\)\\)+ [a-z ]*", "vector");
    return text_replaced(line, "'__vector\\(4\\) double'", "'vec3'");
}

// FILE:LINE:COLUMN: error: WORDS
static const char head_of_message[] =
    "^([^ |][^:]*):([0-9]+):([0-9]+:)? (fatal error|error|warning|note): (.*)";

// About the answer. NULL if there are too many.
static Mistake *begin_mistake(const char *line, const Match *head, const char *words)
{
    if (all.count == MOST_READ) {
        all.unread++;
        return NULL;
    }
    Mistake *mistake = &all.mistakes[all.count++];
    *mistake = (Mistake){.first_line = line,
                         .text = words,
                         .is_warning = text_is(head->group[4], "warning"),
                         .line = strtoul(head->group[2], NULL, 10),
                         .column = strtoul(head->group[3], NULL, 10),
                         .ahead = "",
                         .behind = "",
                         .library = "",
                         .argument = "",
                         .declared = ""};
    return mistake;
}

// Divides the quoted line at the caret below it.
static void find_place(Mistake *mistake, const char *text_line, const char *caret_line)
{
    size_t at = strcspn(caret_line, "^");
    mistake->ahead = text_replaced(text_part(text_line, 0, at), "^ *[0-9]+ \\|", "");
    mistake->behind = text_line + strnlen(text_line, at);
}

// The lines below the head of a message or of its note. The repair and the labels after the caret
// are kept; the following lines that gcc quotes are not.
static void read_quote(Mistake *mistake, const Lines *said, size_t first, bool is_note)
{
    static const char end[] = "^(cc1: |compilation terminated|fatal error: too many errors|"
                              "[0-9]+ (warning|error).* generated\\.$|In file included from |"
                              "                 from |[^ |][^:]*: (In|At) )";
    bool is_pointed = false;
    for (size_t k = first; mistake != NULL && k < said->count; k++) {
        const char *line = said->line[k];
        if (text_matches(line, end) || text_matches(line, head_of_message) ||
            (is_pointed && text_matches(line, "^$|^ *([0-9]+|\\+\\+\\+) \\|")))
            break;
        lines_add(&mistake->body, line);
        if (is_pointed)
            continue;
        is_pointed = text_matches(line, CARET_LINE);
        if (!is_note && k > first && text_has(line, "^")) {
            find_place(mistake, said->line[k - 1], line);
            is_pointed = true;
        }
    }
}

static void read_note(const Lines *said, size_t at, const Match *head)
{
    Mistake *mistake = &all.mistakes[all.count - 1];
    const char *words = head->group[5];
    if (text_matches(words, "column-tracking|silence this warning|near initialization"))
        return;
    if (text_matches(words, "include .*<[a-z_/0-9]+\\.h>"))
        mistake->library = text_group(words, "<[a-z_/0-9]+\\.h>", 0);
    else if (text_matches(words, "^expected .* but argument is of type"))
        mistake->argument = words;
    else if (text_matches(words, "^'[^']*' declared here"))
        mistake->declared = text_group(words, QUOTED, 1);
    else if (text_is(head->group[1], answer.source) &&
             !text_matches(words, "each undeclared identifier|^passing argument to parameter|"
                                  "^declared here")) {
        lines_add(&mistake->body, head->group[0]);
        read_quote(mistake, said, at + 1, true);
    }
}

// gcc does not quote a line again that it quoted for the message before, which may be left out.
static void quote_again(Mistake *mistake)
{
    const char *text = answer_text(mistake->line);
    if (mistake->ahead[0] != '\0' || mistake->behind[0] != '\0' || mistake->column == 0 ||
        mistake->column > LONGEST_LINE || text_has(text, "\t"))
        return;
    Lines body = {NULL, 0};
    lines_add(&body, text_format("%5zu | %s", mistake->line, plain(text)));
    lines_add(&body, text_format("      | %*s", (int)mistake->column, "^"));
    find_place(mistake, body.line[0], body.line[1]);
    for (size_t i = 0; i < mistake->body.count; i++)
        lines_add(&body, mistake->body.line[i]);
    mistake->body = body;
}

static void read_messages(const char *words)
{
    all = (Explanation){.elsewhere = "", .where_included = "", .open_function = answer_unclosed()};
    Lines said = {NULL, 0};
    char *rest = text_copy(words);
    for (char *line; (line = strsep(&rest, "\n")) != NULL;)
        if (rest != NULL || line[0] != '\0')
            lines_add(&said, plain(line));
    const char *in_macro = ""; // an error in a macro that the answer may use
    for (size_t k = 0; k < said.count; k++) {
        const char *line = said.line[k], *where = strstr(line, text_format("%s:", answer.source));
        Match head;
        if (all.raw.count < MOST_SHOWN && text_matches(line, "[Ee]rror"))
            lines_add(&all.raw, line);
        if (where != NULL && text_matches(line, "^(In file included|                ) from "))
            all.where_included = text_replaced(where, "[:,]$", "");
        if (!text_find(line, head_of_message, &head))
            continue;
        bool own = text_is(head.group[1], answer.source);
        if (!text_is(head.group[4], "note") && own) {
            read_quote(begin_mistake(line, &head, head.group[5]), &said, k + 1, false);
            in_macro = "";
        } else if (!text_is(head.group[4], "note")) {
            bool is_error = !text_is(head.group[4], "warning");
            in_macro = is_error ? head.group[5] : "";
            if (is_error && all.elsewhere[0] == '\0')
                all.elsewhere = line;
        } else if (own && in_macro[0] != '\0' &&
                   text_begins(head.group[5], "in expansion of macro")) {
            // gcc places an error in a macro where the macro is defined.
            line = text_format("%s:%s:%s error: %s", head.group[1], head.group[2], head.group[3],
                               in_macro);
            read_quote(begin_mistake(line, &head, in_macro), &said, k + 1, false);
            in_macro = "";
        } else if (all.count > 0 && all.unread == 0)
            read_note(&said, k, &head);
    }
    for (size_t i = 0; i < all.count; i++) {
        quote_again(&all.mistakes[i]);
        find_kinds(&all.mistakes[i]);
    }
}

// ---- keywords ----------------------------------------------------------------------------------

// One slip of the fingers: two letters the wrong way round, or in longer words another letter, one
// too many, or one too few.
static bool is_near(const char *name, const char *word)
{
    size_t size = strlen(word), same = 0;
    if (strcasecmp(name, word) == 0)
        return !text_is(name, word);
    while (name[same] != '\0' && name[same] == word[same])
        same++;
    name += same;
    word += same;
    bool more_of_name = name[0] != '\0', more_of_word = word[0] != '\0';
    return (more_of_name && more_of_word && name[0] == word[1] && name[1] == word[0] &&
            text_is(name + 2, word + 2)) ||
           (size > 3 && more_of_word && text_is(name, word + 1)) ||
           (size > 3 && more_of_name && text_is(name + 1, word)) ||
           (size > 5 && more_of_name && more_of_word && text_is(name + 1, word + 1));
}

// The keyword that a name in this code was meant to be, by its letters and what is around it; or
// "".
static const char *misspelled(const char *name, const char *code)
{
    static const char begins[] = "(^|[;{})]|[^A-Za-z_0-9]else) *$";
    static const struct {
        const char *keywords, *ahead, *behind;
    } places[] = {
        {"return else break continue", begins, "^ *([^]+*=.,)/ ]|$)"},
        {"while for if switch", begins, "^ *\\("},
        {"double float int bool const void static struct", "", "^ *\\*?[A-Za-z_]"},
    };
    const char *at = text_word(code, name);
    for (size_t i = 0; at != NULL && i < sizeof places / sizeof *places; i++) {
        if (!text_matches(text_part(code, 0, (size_t)(at - code)), places[i].ahead) ||
            !text_matches(at + strlen(name), places[i].behind))
            continue;
        char *rest = text_copy(places[i].keywords);
        for (char *keyword; (keyword = strtok_r(rest, " ", &rest)) != NULL;)
            if (is_near(name, keyword))
                return keyword;
    }
    return "";
}

// gcc reports only once that the function fro does not exist.
static void find_keyword(Mistake *mistake)
{
    mistake->slip = mistake->kinds & UNKNOWN ? mistake->name : "";
    if (text_begins(mistake->text, "expected expression before '"))
        mistake->slip = text_group(mistake->ahead, "([a-z]+) *\\($", 1);
    mistake->keyword = misspelled(mistake->slip, mistake->code);
    if (mistake->keyword[0] != '\0')
        mistake->kinds |= MISSPELLED | SYNTAX;
}

// ---- types and letters -------------------------------------------------------------------------

// Which type was wanted and which was given, if the message says so.
static void find_types(Mistake *mistake)
{
    const char *words = mistake->argument[0] != '\0' ? mistake->argument : mistake->text;
    const char *first = bare_type(text_group(words, QUOTED, 1)),
               *second = bare_type(text_group(words, SECOND_QUOTED, 1));
    mistake->wanted = mistake->given = "";
    if (text_matches(words, "^incompatible types when (initializing|assigning)|^assigning to '|"
                            "^expected '.*' but argument is of type|"
                            "^initializing '.*' with an expression of incompatible")) {
        mistake->wanted = first;
        mistake->given = second;
    } else if (text_matches(words, "^incompatible (types when returning|pointer types passing)|"
                                   "^returning '.*' from a function|^passing '.*' to parameter")) {
        mistake->given = first;
        mistake->wanted = second;
    } else if (text_begins(words, "invalid initializer")) {
        const char *name = text_expression_at_end(text_group(mistake->code, AHEAD_OF_EQUALS, 1));
        mistake->wanted = type_of(name, mistake->line);
        const char *value = text_group(mistake->code, "=([^;]*);", 1);
        mistake->given = type_of_argument(value, mistake->line);
    }
    mistake->given = text_replaced(mistake->given, " ?\\* ?const$", " *");
    if (mistake->wanted[0] != '\0') {
        mistake->kinds &= ~(unsigned)VECTOR;
        if (is_vector_type(mistake->given) && is_number(mistake->wanted))
            mistake->kinds |= VECTOR;
        if (mistake->given[0] != '\0')
            mistake->kinds |= TYPES;
        if (text_is(mistake->wanted, text_format("%s *", mistake->given)))
            mistake->kinds |= WANTS_POINTER;
        if (text_is(mistake->given, text_format("%s *", mistake->wanted)) ||
            text_is(mistake->given, text_format("%s*", mistake->wanted)))
            mistake->kinds |= GIVES_POINTER;
    }
}

// The deck's letter of c.d, which no Camera has: "d is c.distance".
static const char *letter_of_whole(const Mistake *mistake)
{
    const char *first = text_group(mistake->text, QUOTED, 1),
               *second = text_group(mistake->text, SECOND_QUOTED, 1);
    bool name_first = mistake->text[0] == '\'';
    const char *type = bare_type(name_first ? first : second),
               *letter = name_first ? second : first;
    const char *name = text_expression_at_end(text_replaced(mistake->ahead, " *(\\.|->) *$", ""));
    const char *part = part_of_deck(type, letter);
    return !text_has(mistake->text, "no member named") || name[0] == '\0' || part[0] == '\0'
               ? ""
               : text_format("%s" UNBROKEN "is" UNBROKEN "%s.%s", letter, name, part);
}

static void find_letter(Mistake *mistake)
{
    const char *owner, *name = mistake->name;
    size_t line = mistake->line;
    bool is_letter = mistake->kinds & UNKNOWN_VARIABLE && text_matches(name, "^[A-Za-z]$") &&
                     answer_loop_of(name, line) == 0;
    mistake->translation = is_letter
                               ? translated(name, line, letters(OTHER_LETTER, mistake->begins))
                               : letter_of_whole(mistake);
    if (mistake->translation[0] != '\0')
        mistake->kinds |= SLIDES_LETTER;
    else if (is_letter && whole_of(name, line, &owner)[0] == '\0')
        mistake->kinds |= OTHER_LETTER;
}

const char *letters(unsigned kind, size_t begins)
{
    Lines list = {NULL, 0};
    const char *text = "";
    for (size_t i = 0; i < all.count; i++) {
        const Mistake *mistake = &all.mistakes[i];
        const char *letter = kind == OTHER_LETTER ? mistake->name : mistake->translation;
        if (!(mistake->kinds & kind) || mistake->begins != begins || lines_have(&list, letter))
            continue;
        text = text_format("%s%s%s", text, list.count == 0 ? "" : ", ", letter);
        lines_add(&list, letter);
    }
    return text;
}

static void understand(Mistake *mistake)
{
    const char *name = mistake->name = text_group(mistake->text, QUOTED, 1);
    mistake->begins = answer_function(mistake->line)->line;
    mistake->statement = answer_statement(mistake->line);
    find_letter(mistake);
    find_keyword(mistake);
    find_types(mistake);
    if (mistake->kinds & UNKNOWN && !answer_includes(headers.contract) &&
        declared(name, ANYTHING)->name[0] != '\0')
        mistake->kinds |= LACKS_CONTRACT;
    if (mistake->kinds & UNKNOWN && text_word("std new let var def", name) != NULL)
        mistake->kinds |= SYNTAX;
    const char *at =
        mistake->kinds & (UNKNOWN_TYPE | UNKNOWN_VARIABLE) ? text_word(mistake->code, name) : NULL;
    mistake->declares =
        at == NULL ? "" : text_group(at + strlen(name), "^ +\\**([A-Za-z_][A-Za-z_0-9]*)", 1);
    if (text_matches(mistake->declares, "^(and|or|not)$")) // operators of other languages
        mistake->declares = "";
}

// ---- consequences ------------------------------------------------------------------------------

// An undeclared name is treated as a function that returns an int; gcc says so only once.
#define OF_INT                                                                                     \
    "'int'|invalid initializer|subscripted value|incompatible implicit|"                           \
    "integer absolute value|type mismatch in conditional"

enum Condition {
    NO_CONDITION,
    SAME_TEXT,
    SAME_NAME,
    NAME_IN_WORDS,
    NAME_IN_CODE,
    DECLARED_IN_CODE,
    LOOP_OF_NAME,
    FROM_FIRST_LINE,
    BELOW_OPEN_FUNCTION
};

// A message only follows from another if a row holds.
static const struct {
    enum { ANYWHERE, SAME_LINE, SAME_STATEMENT, SAME_FUNCTION } where;
    unsigned from;     // the kinds of the other; 0: any
    unsigned what;     // its own kinds; 0: any
    const char *words; // its own; NULL: any
    bool is_later;
    enum Condition holds;
} consequences[] = {
    {ANYWHERE, LACKS_CONTRACT, .is_later = true},
    {ANYWHERE, LACKS_CONTRACT, .what = WARNING},
    // image_set is a macro: without its ) it takes the rest of the file, at whose end gcc says so.
    {ANYWHERE, AT_END, .words = "^unterminated argument"},
    {ANYWHERE, UNTERMINATED, .is_later = true},
    {ANYWHERE, MISSING_BRACE, .what = MISSING_BRACE | MISSING_RETURN, .holds = BELOW_OPEN_FUNCTION},
    {ANYWHERE, MISSING_BRACE, .holds = BELOW_OPEN_FUNCTION,
     .words = "defined but not used|^unused |invalid storage class|[Mm]isleading|nested function|"
              "clause does not guard|declared .* but never defined|follows non-static"},
    {ANYWHERE, CONFLICT | STATIC, .is_later = true, .holds = NAME_IN_WORDS},
    {ANYWHERE, UNKNOWN, .words = OF_INT, .holds = NAME_IN_CODE},
    {SAME_LINE, .from = PASTED},
    {SAME_STATEMENT, DECIMAL, .what = DECIMAL | WARNING},
    {SAME_STATEMENT, SYNTAX, .what = ERROR | MISSING_RETURN | MISSING_BRACE},
    {SAME_STATEMENT, SYNTAX,
     .words = "clause does not guard|^misleading|operand of comma|no effect"},
    {SAME_STATEMENT, COUNT, .words = "^incompatible type for argument|^passing "},
    {SAME_STATEMENT, ERROR, .what = COMMA},
    {SAME_STATEMENT, .is_later = true, .holds = SAME_TEXT},
    {SAME_STATEMENT, ARGUMENT, .what = ARGUMENT, .holds = SAME_NAME},
    {SAME_STATEMENT, ARROW, .words = "'->'|no member named", .is_later = true},
    {SAME_STATEMENT, COMMA, .what = COMMA},
    {SAME_STATEMENT, UNKNOWN, .words = OF_INT},
    {SAME_FUNCTION, SLIDES_LETTER, .what = SLIDES_LETTER},
    {SAME_FUNCTION, OTHER_LETTER, .what = OTHER_LETTER},
    {SAME_FUNCTION, .from = CONFLICT},
    {SAME_FUNCTION, OUTSIDE, .is_later = true},
    {SAME_FUNCTION, OUTSIDE, .what = WARNING | MISSING_RETURN},
    {SAME_FUNCTION, MISSING_RETURN, .what = UNUSED_VALUE},
    {SAME_FUNCTION, ERROR, .what = MISSING_RETURN},
    {SAME_FUNCTION, ERROR, .words = "^missing initializer|^unused variable|set but not used"},
    {SAME_FUNCTION, UNKNOWN, .what = UNKNOWN, .holds = SAME_NAME},
    {SAME_FUNCTION, UNKNOWN, .what = ENDS_AT_ONCE, .holds = LOOP_OF_NAME},
    {SAME_FUNCTION, UNKNOWN, .words = "'int'", .holds = FROM_FIRST_LINE},
    {SAME_FUNCTION, UNKNOWN, .is_later = true, .holds = DECLARED_IN_CODE},
    // The declaration that lost its semicolon took the next one with it; brackets, the function.
    {SAME_FUNCTION, SYNTAX, .words = "undeclared", .is_later = true},
    {SAME_FUNCTION, SYNTAX, .what = OUTSIDE, .is_later = true},
};

static bool condition_holds(enum Condition condition, const Mistake *mistake, const Mistake *from)
{
    switch (condition) {
    case SAME_TEXT:
        return text_is(from->text, mistake->text);
    case SAME_NAME:
        return text_is(from->name, mistake->name);
    case NAME_IN_WORDS:
        return text_word(mistake->text, from->name) != NULL;
    case NAME_IN_CODE:
        return text_word(mistake->code, from->name) != NULL;
    case DECLARED_IN_CODE:
        return text_word(mistake->code, from->declares) != NULL;
    case LOOP_OF_NAME:
        return answer_ends_at_once(mistake->line) &&
               answer_loop_of(from->name, from->line) == mistake->line;
    case FROM_FIRST_LINE:
        return from->line == from->begins;
    case BELOW_OPEN_FUNCTION:
        return mistake->line >= all.open_function;
    case NO_CONDITION:
        break;
    }
    return true;
}

static bool follows(const Mistake *mistake, const Mistake *from)
{
    const bool is_at[] = {[ANYWHERE] = true,
                          [SAME_LINE] = from->line == mistake->line,
                          [SAME_STATEMENT] = from->statement == mistake->statement,
                          [SAME_FUNCTION] = from->begins != 0 && from->begins == mistake->begins};
    for (size_t i = 0; i < sizeof consequences / sizeof *consequences; i++)
        if (is_at[consequences[i].where] && (!consequences[i].is_later || mistake > from) &&
            (consequences[i].from == 0 || consequences[i].from & from->kinds) &&
            (consequences[i].what == 0 || consequences[i].what & mistake->kinds) &&
            (consequences[i].words == NULL || text_matches(mistake->text, consequences[i].words)) &&
            condition_holds(consequences[i].holds, mistake, from))
            return true;
    return false;
}

static void explanation_read(const char *source, const char *words)
{
    const char *stem = text_group(source, "([^/]*)\\.c$", 1);
    headers_read(text_format("exercises/%s.h", stem));
    answer_read(source);
    read_messages(words);
    for (size_t i = 0; i < all.count; i++)
        understand(&all.mistakes[i]);
    for (size_t i = 0; i < all.count; i++)
        for (size_t j = 0; j < all.count; j++)
            if (j != i && !all.mistakes[i].is_dropped && !all.mistakes[j].is_dropped &&
                follows(&all.mistakes[j], &all.mistakes[i]))
                all.mistakes[j].is_dropped = true;
}

// ---- showing -----------------------------------------------------------------------------------

// A long line goes on in the next one, after the indent. It is divided between words.
static const char *wrapped(const char *line, const char *indent)
{
    const char *text = "", *margin = "";
    for (size_t room; room = COLUMNS - strlen(margin), strlen(line) > room; margin = indent) {
        size_t end = room, least = strlen(indent) - strlen(margin) + 20;
        while (end >= least && line[end] != ' ')
            end--;
        if (line[end] != ' ')
            end = room;
        const char *next = line + end + strspn(line + end, " ");
        while (end > 0 && line[end - 1] == ' ')
            end--;
        text = text_format("%s%s%.*s\n", text, margin, (int)end, line);
        line = next;
    }
    return text_format("%s%s%s\n", text, margin, line);
}

// A quote: the text, the caret below it, and the compiler's suggestion. If the caret is far out,
// all lines lose the same columns after the margin.
static void show_quote(FILE *out, const Lines *quote, size_t first, size_t end)
{
    size_t caret = 0;
    for (size_t k = end; k > first; k--)
        if (text_matches(quote->line[k - 1], CARET_LINE))
            caret = strcspn(quote->line[k - 1], "^") + 1;
    size_t gone = caret > COLUMNS - 10 ? caret - 50 : 0;
    for (size_t k = first; k < end; k++) {
        const char *line = quote->line[k];
        if (gone > 0) {
            size_t margin = strlen(text_group(quote->line[first], "^ *[0-9]+ \\|", 0));
            line = text_format("%s%s%s", text_part(line, 0, margin), k == first ? " ..." : "    ",
                               line + strnlen(line, margin + gone + 4));
        }
        fprintf(out, "%s\n", text_replaced(text_part(line, 0, COLUMNS), " +$", ""));
    }
}

static void show_message(FILE *out, const Mistake *mistake, Lines *helped)
{
    const Lines *body = &mistake->body;
    fputs(wrapped(mistake->first_line, "  "), out);
    size_t first = 0;
    for (size_t k = 0; k <= body->count; k++)
        if (k == body->count || text_begins(body->line[k], text_format("%s:", answer.source))) {
            show_quote(out, body, first, k);
            if (k < body->count)
                fputs(wrapped(body->line[k], "  "), out);
            first = k + 1;
        }
    const char *words = help(mistake);
    if (words[0] == '\0' || lines_have(helped, words))
        return;
    lines_add(helped, words);
    words = wrapped(text_format("  help: %s", words), "        ");
    fputs(text_replaced(words, UNBROKEN, " "), out);
}

static void show_all(FILE *out)
{
    size_t errors = 0, shown = 0;
    for (size_t i = 0; i < all.count; i++)
        errors += !all.mistakes[i].is_dropped && !all.mistakes[i].is_warning;
    // Code before an #include can cause an error in the header.
    if (errors == 0 && all.elsewhere[0] != '\0') {
        fputs(wrapped(all.elsewhere, "  "), out);
        if (all.where_included[0] != '\0')
            fputs(wrapped(text_format("  help: the error shows there, but look at %s and above it.",
                                      all.where_included),
                          "        "),
                  out);
    }
    Lines helped = {NULL, 0};
    for (int warning = 0; warning <= 1; warning++)
        for (size_t i = 0; i < all.count; i++) {
            const Mistake *mistake = &all.mistakes[i];
            if (!mistake->is_dropped && mistake->is_warning == (warning == 1) &&
                shown++ < MOST_SHOWN)
                show_message(out, mistake, &helped);
        }
    if (shown + all.unread > MOST_SHOWN)
        fprintf(out, "... and %zu more\n", shown + all.unread - MOST_SHOWN);
    // Whatever else a compiler may say.
    if (all.count == 0 && all.elsewhere[0] == '\0')
        for (size_t i = 0; i < all.raw.count; i++)
            fputs(wrapped(all.raw.line[i], "  "), out);
}

void explain(FILE *out, const char *source, const char *diagnostics)
{
    explanation_read(source, diagnostics);
    // Some editors for Windows save text as UTF-16, which begins with these bytes.
    if (text_begins(answer_text(1), "\377\376") || text_begins(answer_text(1), "\376\377"))
        fprintf(out,
                "%s: error: this file is saved as UTF-16\n"
                "  help: save it as UTF-8 in your editor. Nothing in it is lost.\n",
                source);
    else
        show_all(out);
    texts_free();
}

// ---- causes that only the text of a wrong answer shows -----------------------------------------

typedef struct {
    const char *const *judged;
    size_t judged_count;
    Lines seen; // functions and macros
    Lines help; // on divisions and powers
    bool is_comma;
} Slips;

static void add_slip(Slips *slips, const char *words)
{
    if (!lines_have(&slips->help, words) && slips->help.count < MOST_SLIPS)
        lines_add(&slips->help, words);
}

// x * 1/2, (double)1/2 and 1/2.0 do not divide whole numbers.
static void find_divisions(Slips *slips, size_t line)
{
    const char *code = answer_code(line), *rest = code;
    for (Match match; text_find(rest, "([0-9]+) */ *([0-9]+)", &match);) {
        rest += match.end;
        const char *before = text_part(code, 0, (size_t)(rest - code) - strlen(match.group[0]));
        unsigned long upper = strtoul(match.group[1], NULL, 10),
                      lower = strtoul(match.group[2], NULL, 10);
        if (!text_matches(before, "[A-Za-z_0-9.]$|[0-9.][eE][-+]$|[*/%)] *$") &&
            !text_matches(rest, "^[A-Za-z_0-9.]") && lower != 0 && upper % lower != 0)
            add_slip(slips, text_format("in line %zu, %lu/%lu is %lu: C divides whole numbers "
                                        "without a remainder. Write %lu.0/%lu.\n",
                                        line, upper, lower, upper / lower, upper, lower));
    }
}

// Between whole numbers ^ compiles, and no exercise is about bits.
static void find_powers(Slips *slips, size_t line)
{
    static const char sign[] = "([A-Za-z_0-9.]+|\\)) *\\^ *((- *)?([A-Za-z_0-9.]+|\\())";
    Match power;
    if (!text_find(answer_code(line), sign, &power))
        return;
    bool has_brackets = text_matches(power.group[0], "[()]");
    add_slip(slips,
             text_format("in line %zu, %s is exclusive or, not a power: write pow(%s, %s).\n", line,
                         has_brackets ? "^" : power.group[0], has_brackets ? "x" : power.group[1],
                         has_brackets ? "y" : power.group[2]));
}

static bool is_to_be_seen(const Slips *slips, const char *code, const char *name)
{
    for (size_t i = 0; i < slips->judged_count; i++)
        if (text_is(slips->judged[i], name))
            return false;
    return text_word(code, name) != NULL && !lines_have(&slips->seen, name) &&
           slips->seen.count < MOST_SLIPS;
}

// These lines, and the helpers and macros that they use.
static void look_at(Slips *slips, const char *name, size_t line, size_t last)
{
    lines_add(&slips->seen, name);
    for (; line <= last; line++) {
        const char *code = answer_code(line);
        find_divisions(slips, line);
        find_powers(slips, line);
        for (size_t i = 0; i < all.count; i++)
            if (all.mistakes[i].line == line && all.mistakes[i].kinds & DECIMAL)
                slips->is_comma = true;
        for (size_t i = 1; i <= answer.function_count; i++) {
            const OwnFunction *other = answer_function_named(answer.functions[i].name);
            if (is_to_be_seen(slips, code, other->name))
                look_at(slips, other->name, other->line, other->last);
        }
        for (size_t i = 1; i <= answer.last; i++) {
            const char *macro =
                text_has(answer_code(i), "#") ? text_group(answer_code(i), MACRO, 1) : "";
            if (is_to_be_seen(slips, code, macro))
                look_at(slips, macro, i, i);
        }
    }
}

ExplainedSlips explain_slips(const char *source, const char *diagnostics, const char *function,
                             const char *const *judged, size_t judged_count)
{
    answer_read(source);
    read_messages(diagnostics);
    Slips slips = {.judged = judged, .judged_count = judged_count};
    const OwnFunction *own = answer_function_named(function);
    if (own != NULL)
        look_at(&slips, function, own->line, own->last);
    const char *help = "";
    for (size_t i = 0; i < slips.help.count; i++)
        help = text_format("%s%s", help, slips.help.line[i]);
    ExplainedSlips explained = {help[0] == '\0' ? NULL : strdup(help), slips.is_comma};
    texts_free();
    return explained;
}

// ---- the parts of the linker's output that help a student --------------------------------------

// Whether the answer defines it as inline, and not static: then no function of this name is made.
static bool is_inline(const char *name)
{
    for (size_t i = 1; i <= answer.function_count; i++)
        if (text_is(answer.functions[i].name, name) &&
            text_begins(answer_code(answer.functions[i].line), "inline "))
            return true;
    return false;
}

static const char *linker_help(const char *line)
{
    const char *twice = text_group(line, "multiple definition of [`']([A-Za-z_0-9]+)'", 1),
               *missing = text_group(line, "undefined reference to [`']([A-Za-z_0-9]+)'", 1);
    if (text_is(twice, "main"))
        return "  remove main: the tests have their own";
    if (twice[0] != '\0')
        return text_format("  %s is already the name of something else: make yours static", twice);
    if (missing[0] == '\0')
        return "";
    return is_inline(missing) ? text_format("  %s is inline: write static inline", missing)
                              : text_format("  %s is not in this file (or is static)", missing);
}

void explain_linker(FILE *out, const char *source, const char *words)
{
    answer_read(source);
    Lines lines = {NULL, 0};
    char *rest = text_copy(words);
    for (char *line; (line = strsep(&rest, "\n")) != NULL;) {
        const char *help = linker_help(line);
        if (help[0] != '\0')
            lines_add(&lines, help);
    }
    lines_sort(&lines);
    if (lines.count == 0)
        fputs(words, out);
    for (size_t i = 0; i < lines.count; i++)
        if (i == 0 || !text_is(lines.line[i], lines.line[i - 1]))
            fprintf(out, "%s\n", lines.line[i]);
    texts_free();
}
