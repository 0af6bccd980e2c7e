// explain.c - the parts of a compiler's and a linker's output that help a student.
//
// Read from the text that gcc and clang write for people, not from JSON or SARIF: the head of a
// message, FILE:LINE:COLUMN: error: WORDS, and the quote below it have been the same in all
// versions of both, and the quote is shown as it is. gcc's JSON leaves the quote out and goes away
// with gcc 15; SARIF needs gcc 13 or clang 15; clang 14 has neither.
//
// Each message is of some kinds (the table kinds). Messages that only follow from another are
// dropped (the table consequences). The others are shown, each with the first line of help that
// holds (the table rules): nothing false is printed, because each rule depends on the compiler's
// words and, if that is not enough, on the code.
#include "tests/explain/explain.h"

#include "tests/explain/source.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SHOWN = 3, COLUMNS = 79, MOST_SLIPS = 50 };

// A line of help is not wrapped at its blanks.
#define UNBROKEN "\001"
#define MACRO "^ *# *define +([A-Za-z_0-9]+)"
// The name after the dot or the arrow at the caret: its third group.
#define PART "^((\\.|->) *)?([A-Za-z_0-9]+)"

// ---- a compiler's message about the answer ------------------------------------------------------

// The text in single quotes: the first, and the second.
#define QUOTED "'([^']*)"
#define SECOND_QUOTED "^[^']*'[^']*'[^']*'([^']*)"
// Of code.
#define AHEAD_OF_EQUALS "^([^=]*[^= ]) *="
// What a compiler writes below the code that it quotes.
#define CARET_LINE "^[ |~]*\\^"

// What a message is about. It can be of several kinds.
enum {
    ANY = 0,
    UNKNOWN_FUNCTION = 1 << 0, // nobody has declared the name
    UNKNOWN_TYPE = 1 << 1,
    UNKNOWN_VARIABLE = 1 << 2,
    UNKNOWN = UNKNOWN_FUNCTION | UNKNOWN_TYPE | UNKNOWN_VARIABLE,
    SLIDES_LETTER = 1 << 3, // the name is a letter of the slides
    OTHER_LETTER = 1 << 4,  // or another letter
    LACKS_CONTRACT = 1 << 5,
    SYNTAX = 1 << 6,
    SEMICOLON = 1 << 7,
    PASTED = 1 << 8,     // a character that is not C
    MISSPELLED = 1 << 9, // a keyword
    MISSING_BRACE = 1 << 10,
    OUTSIDE = 1 << 11, // of every function
    COUNT = 1 << 12,   // of arguments
    ARGUMENT = 1 << 13,
    CONFLICT = 1 << 14, // with another declaration
    STATIC = 1 << 15,   // so is this, but only by that word
    MISSING_RETURN = 1 << 16,
    UNUSED_VALUE = 1 << 17,
    COMMA = 1 << 18,        // the operator
    DECIMAL = 1 << 19,      // comma: 0,5
    ENDS_AT_ONCE = 1 << 20, // a loop
    ARROW = 1 << 21,
    UNTERMINATED = 1 << 22,
    AT_END = 1 << 23,
    VECTOR = 1 << 24,        // where a number is expected
    TYPES = 1 << 25,         // one is expected, and another given
    WANTS_POINTER = 1 << 26, // to the given type
    GIVES_POINTER = 1 << 27, // to the expected type
    WARNING = 1 << 28,
    ERROR = 1 << 29 // and not a missing return or }
};

typedef struct {
    const char *first_line; // FILE:LINE:COLUMN: error: WORDS
    const char *text;       // its words
    const char *name;       // the first of them in quotes
    bool is_warning;
    size_t line, column;
    Lines body;         // the quote, what is below it, and the notes
    const char *ahead;  // the quoted line before the caret, without the margin
    const char *behind; // and from the caret on

    // Of notes about other files.
    const char *library;  // <math.h>
    const char *argument; // "expected 'vec3' but argument is of type 'double'"
    const char *declared; // the function that is called

    unsigned kinds;
    bool is_dropped;            // only follows from another
    const char *code;           // of its line
    size_t begins;              // where its function begins, or 0
    size_t statement;           // and its statement
    const char *translation;    // of a letter of the slides: "d is c.distance"; or ""
    const char *slip;           // perhaps a misspelled keyword,
    const char *keyword;        // and that keyword, or ""
    const char *decimal;        // 0,5 or ""
    const char *declares;       // the name after a misspelled type, or ""
    const char *wanted, *given; // types, or ""
} Mistake;

enum { MOST_READ = 60 }; // the other messages are only counted

typedef struct {
    Mistake mistakes[MOST_READ];
    size_t count, unread;
    const char *elsewhere;      // an error in another file, or ""
    const char *where_included; // "FILE:LINE" of the answer, from which that came; or ""
    Lines raw;                  // whatever else looks like an error
    size_t open_function;       // where the function begins that lacks a }, or 0
} Explanation;

static Explanation all;

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

// Plain ASCII without colors, typographic quotes, tabs, or the type behind vec3, which gcc and
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

// ---- the deck's letters, and parts without their whole -----------------------------------------

// The part of a Camera, Ray, Sphere or Resolution that has this letter on the slides, or "".
static const char *part_of_deck(const char *type, const char *letter)
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

// camera.width or camera->width
static const char *part_of(const Variable *variable, const char *part)
{
    return text_format("%s%s%s", variable->name, variable->is_pointer ? "->" : ".", part);
}

// A letter that nobody declared, by the names of this function: "d is c.distance"; or "". others:
// the letters that mean nothing in it, separated by ", ".
static const char *translated(const char *letter, size_t line, const char *others)
{
    const char *found = "";
    // With a and b, c is that of the quadratic.
    bool is_quadratic = text_is(letter, "c") && text_matches(others, "[ab]");
    for (const Variable *one = NULL; (one = variable_after(one, line)) != NULL;) {
        const char *part = is_quadratic ? "" : part_of_deck(one->type, letter);
        if (part[0] != '\0' && has_parts_yet(one))
            found = one_or_the_other(found, part_of(one, part));
        else if (one->is_parameter && text_matches(text_format("%s %s", letter, one->name),
                                                   "^(r radius|d distance|p eye)$"))
            found = one_or_the_other(found, one->name);
    }
    return found[0] == '\0' ? "" : text_format("%s" UNBROKEN "is" UNBROKEN "%s", letter, found);
}

// Where in this line a value has a part of this name: "camera.width or view.width", or "".
static const char *whole_of(const char *part, size_t line)
{
    const char *found = "";
    for (const Variable *one = NULL; (one = variable_after(one, line)) != NULL;) {
        // Its own parts, or image->size.width.
        const Variables *fields = &declared(one->type, TYPE)->fields;
        for (size_t i = 0; has_parts_yet(one) && i < fields->count; i++) {
            const Variable *field = &fields->item[i];
            bool is_own = text_is(field->name, part);
            if (!is_own && (field->is_pointer || declared_field(field->type, part) == NULL))
                continue;
            const char *whole = part_of(one, field->name);
            found = one_or_the_other(found, is_own ? whole : text_format("%s.%s", whole, part));
        }
    }
    return found;
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

// The letters of the mistakes in a function, of the kind: "a, b" or "d is c.distance, w is
// c.width".
static const char *letters(unsigned kind, size_t begins)
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

static void find_letter(Mistake *mistake)
{
    const char *name = mistake->name;
    size_t line = mistake->line;
    bool is_letter = mistake->kinds & UNKNOWN_VARIABLE && text_matches(name, "^[A-Za-z]$") &&
                     answer_loop_of(name, line) == 0;
    mistake->translation = is_letter
                               ? translated(name, line, letters(OTHER_LETTER, mistake->begins))
                               : letter_of_whole(mistake);
    if (mistake->translation[0] != '\0')
        mistake->kinds |= SLIDES_LETTER;
    else if (is_letter && whole_of(name, line)[0] == '\0')
        mistake->kinds |= OTHER_LETTER;
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

// ---- names that are known elsewhere ------------------------------------------------------------

typedef struct {
    const char *meant, *names;
} Names;

// Names that students know from other languages, and the function here.
static const Names known_names[] = {
    {"vec3_dot", "dot dotp dot_product dotProduct vec3Dot vec_dot scalar_product"},
    {"vec3_cross", "cross crossp cross_product crossProduct vec3Cross vec_cross"},
    {"vec3_length",
     "length len norm magnitude mag vec3_norm vec3_len vec3_magnitude vec_length abs_vec3"},
    {"vec3_unit", "unit unit_vector normalize normalise normalized vec3_normalize vec3_normalise "
                  "vec3_normalized vec_normalize"},
    {"vec3_of", "vec vec_of make_vec3 new_vec3 vec3_new vec3_make vec3_create Vec3 Vector vector"},
    {"printf, of <stdio.h>", "print println echo cout console"},
    {"fmax, of <math.h>", "max maximum"},
    {"fmin, of <math.h>", "min minimum"},
    {"INFINITY, of <math.h>", "infinity Infinity INF inf HUGE"},
    {"true", "True TRUE"},
    {"false", "False FALSE"},
};

// Not every compiler names the header of the C library that declares a function.
static const Names library[] = {
    {"<stdio.h>", "printf fprintf sprintf snprintf puts putchar fputs scanf fflush stdout stderr"},
    {"<stdlib.h>", "malloc calloc realloc free exit rand srand qsort atof atoi"},
    {"<string.h>", "memcpy memset memcmp strlen strcmp"},
    {"<math.h>", "sqrt fabs tan sin cos atan atan2 acos asin pow floor ceil round fmin fmax hypot "
                 "exp log isnan isfinite signbit copysign INFINITY NAN"},
    {"<stdbool.h>", "bool true false"},
    {"<stddef.h>", "NULL size_t"},
    {"<stdint.h>", "uint8_t"},
    {"<float.h>", "DBL_MAX DBL_MIN DBL_EPSILON FLT_MAX FLT_EPSILON"},
    {"<limits.h>", "INT_MAX INT_MIN"},
    {"<assert.h>", "assert"},
};

static const char *meant_by(const char *name, const Names *names, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (text_word(names[i].names, name) != NULL)
            return names[i].meant;
    return "";
}

// ---- types -------------------------------------------------------------------------------------

static const char *with_article(char article, const char *type)
{
    return text_format("%c%s %s", article, strchr("AEIOUaeiou", type[0]) != NULL ? "n" : "", type);
}

// How a value of a type is written, or "".
static const char *written(const char *type)
{
    const char *parts = declared(type, TYPE)->parts;
    const char *how = text_is(type, "vec3")    ? "vec3_of(x, y, z)"
                      : text_is(type, "Color") ? "vec3_of(r, g, b)"
                      : parts[0] != '\0'       ? text_format("(%s){%s}", type, parts)
                                               : "";
    return text_replaced(how, " ", UNBROKEN);
}

// Of (Camera c, double s): a Camera and a double; or, named, Camera c and double s.
static const char *listed(const Variable *list, size_t count, bool is_named)
{
    const char *text = "";
    for (size_t i = 0; i < count; i++) {
        const char *one = is_named ? text_format("%s" UNBROKEN "%s%s", list[i].type,
                                                 list[i].is_pointer ? "*" : "", list[i].name)
                                   : with_article('a', list[i].type);
        text = text_format("%s%s%s", text, i == 0 ? "" : i + 1 < count ? ", " : " and ", one);
    }
    return text;
}

// " The parameters of NAME are Camera c, double s and double t."; "" if there are none.
static const char *parameters(const Mistake *mistake)
{
    const Variable *first = variable_after(NULL, mistake->line);
    size_t count = 0, most = answer.variables.count;
    while (first != NULL && first + count < answer.variables.item + most &&
           first[count].is_parameter && first[count].function == mistake->begins)
        count++;
    return count == 0 ? ""
                      : text_format(" The parameter%s of %s %s %s.", count == 1 ? "" : "s",
                                    answer_function(mistake->line)->name, count == 1 ? "is" : "are",
                                    listed(first, count, true));
}

// The name with its parts that begins at the caret.
static const char *expression_here(const Mistake *mistake)
{
    bool at_sign = text_matches(mistake->behind, "^(\\.|->)");
    const char *before = at_sign ? text_expression_at_end(mistake->ahead) : "";
    return text_group(text_format("%s%s", before, mistake->behind),
                      "^[A-Za-z_][A-Za-z_0-9]*((\\.|->)[A-Za-z_][A-Za-z_0-9]*)*", 0);
}

// A struct in a sum or a product.
static const char *struct_operand(const Mistake *mistake)
{
    const char *found = "";
    Match quoted;
    for (const char *at = mistake->text; text_find(at, QUOTED, &quoted); at += quoted.end) {
        const char *type = bare_type(quoted.group[1]);
        if (declared(type, TYPE)->parts[0] != '\0')
            found = type;
    }
    return found;
}

// ---- functions and their arguments -------------------------------------------------------------

// Whose argument is wrong, or "".
static const char *called(const Mistake *mistake)
{
    if (!text_matches(mistake->text, "argument|^passing"))
        return "";
    if (text_has(mistake->text, " of '"))
        return mistake->name;
    return text_group(text_without_brackets(mistake->ahead), "([A-Za-z_0-9]+)\\([^()]*$", 1);
}

// Functions of this chapter and of earlier ones, except this one, that convert one type to another.
static const char *makers(const Mistake *mistake)
{
    const char *wanted = mistake->wanted, *found = "";
    for (size_t i = 0; declared(wanted, TYPE)->parts[0] != '\0' && i < headers.count; i++) {
        const Declared *maker = &headers.item[i];
        const char *arguments = strchr(maker->prototype, '(');
        if (text_is(maker->type, wanted) && maker->fields.count > 0 &&
            text_is(maker->fields.item[0].type, mistake->given) &&
            text_word(arguments, wanted) == NULL && !text_has(arguments, "*") &&
            !text_is(maker->name, answer_function(mistake->line)->name) &&
            text_begins(maker->header, "exercises") && strcmp(maker->header, headers.contract) <= 0)
            found = one_or_the_other(
                found, text_format("%s (%s) makes %s of %s", maker->name, maker->header,
                                   with_article('a', wanted),
                                   listed(maker->fields.item, maker->fields.count, false)));
    }
    return found;
}

// Who wants which type: "hit_sphere gives back a double (exercises/05-quadratic.h), and this is a
// Roots."
static const char *what_is_wanted(const Mistake *mistake)
{
    const char *here = answer_function(mistake->line)->name, *function = called(mistake),
               *header = declared(here, ANYTHING)->header,
               *wanted = with_article('a', mistake->wanted);
    const char *who = function[0] != '\0' ? text_format("%s expects %s there", function, wanted)
                                          : text_format("%s is expected here", wanted);
    if (text_has(mistake->text, "returning") && here[0] != '\0')
        who = text_format("%s returns %s%s", here, wanted,
                          header[0] != '\0' ? text_format(" (%s)", header) : "");
    return text_format("%s, but this is %s", who, with_article('a', mistake->given));
}

// ---- names -------------------------------------------------------------------------------------

// A name that differs only in its capitals: of a type, or of a constant. Of the exercises' headers,
// those up to the contract are looked into.
static const char *name_like(const Mistake *mistake)
{
    for (size_t i = 0; i < headers.count; i++) {
        const char *other = headers.item[i].name, *header = headers.item[i].header;
        if (strcasecmp(other, mistake->name) == 0 && !text_is(other, mistake->name) &&
            (mistake->kinds & UNKNOWN_TYPE || text_matches(other, "^[A-Z][A-Z_0-9]+$")) &&
            (!text_begins(header, "exercises") || strcmp(header, headers.contract) <= 0))
            return other;
    }
    return "";
}

// Declared here, as far as the text shows, and not by a loop that has ended: the compiler lost it
// because of another mistake.
static bool is_lost(const Mistake *mistake)
{
    return variable_named(mistake->name, mistake->line) != NULL &&
           answer_loop_of(mistake->name, mistake->line) == 0;
}

static bool is_parameter(const Mistake *mistake)
{
    size_t before = mistake->line > mistake->begins ? mistake->line - 1 : mistake->line;
    const Variable *declared_before = variable_named(mistake->name, before);
    return declared_before != NULL && declared_before->is_parameter;
}

// ---- other conditions, and helps with more to find out -----------------------------------------

static bool has_comma(const Mistake *mistake)
{
    for (size_t i = 0; i < all.count; i++)
        if (all.mistakes[i].kinds & COMMA && all.mistakes[i].statement == mistake->statement)
            return mistake->kinds & COMMA || mistake->wanted[0] != '\0';
    return false;
}

#define NO_STAR "^(invalid type argument of unary '\\*'|indirection requires pointer)"

// The line of the loop, or the if, that ends at once: of the mistake, or where its name is
// declared.
static size_t ended_loop(const Mistake *mistake)
{
    size_t line =
        mistake->kinds & UNKNOWN ? answer_loop_of(mistake->name, mistake->line) : mistake->line;
    return answer_ends_at_once(line) ? line : 0;
}

// ---- the rules ---------------------------------------------------------------------------------

// Of abs, which compiles if <stdlib.h> is included, and loses the digits after the point.
#define INTEGER_ABS "abs is for whole numbers. For a double, write fabs (#include <math.h>)."
#define POWER ": write x * x or pow(x, y), and vec3_dot(v, v) for the square of a vector."
#define LOST_COMMA "the value of (a, b) is b alone: the part before the comma is lost."
#define LOST_RETURN "the function ends without return: its return value is then undefined."
#define DECLARE_NEW "declare a new variable with its type, as in double x or vec3 v."
#define LIKE_CALL "A variable gets its value by =, as in Pixel pixel = {column, row};"
#define VECTOR_GIVEN                                                                               \
    "this is a vector, but a number is expected. v * w is also a vector; for a number, write "     \
    "vec3_dot(v, w), vec3_length(v) or v[0]."
#define PROTOTYPE " Its prototype is  {PROTOTYPE CALLED}  in {HEADER CALLED}."
#define WHOSE_PARTS ", whose parts are {PARTS AHEAD_TYPE}.{LOOK?}"
#define ENDED_LOOP                                                                                 \
    "the ; after the bracket in line {ENDED} ends the statement: the next one is no longer part "  \
    "of it. Remove the ;."
#define NOTHING "nothing here is called "

#define WRONG_ARROW                                                                                \
    "invalid type argument of '->'|^member reference type .* is (not )?a pointer|"                 \
    "is a pointer; did you mean"
#define NO_PARTS "^request for member|^member reference base type"
#define OTHER_MEMBER "no member named|does not refer to any field"
#define TYPE_FOUND "^(unexpected type name|expected expression.*'[A-Za-z])"

// The first rule that holds gives the help. Patterns: of the compiler's words, of what is quoted
// ahead of the caret and behind it, of the code of the line and of the line before, of the first
// name that the compiler quotes; NULL: of any. kinds: only of such a mistake.
//
// In the help, {WORD} is filled in (the table is in find_words), or what a header says of it:
// {PARTS WORD}. A rule whose help has a word without a meaning does not hold, unless the word is
// written {WORD?}.
typedef struct {
    unsigned kinds;
    const char *words, *ahead, *behind, *code, *before, *name;
    const char *needs; // a word like those of the help
    const char *help;  // "": there is none
} Rule;

static const Rule rules[] = {
    {PASTED, .help = "a character that is not C was pasted there: a dash, a quote, a sign or a "
                     "space that only looks like one. Delete it and type it again."},
    {MISSPELLED, .help = "{SLIP} is misspelled: {KEYWORD}."},
    {DECIMAL, .help = "{DECIMAL} is two numbers in C. If you mean one number, write {POINT}."},
    {MISSING_BRACE, "^expected", .needs = "{BELOW}", .help = "a } is missing in line {LINE}."},
    {MISSING_BRACE,
     .help = "a } is missing, in or before the function that begins in line {OPEN}."},
    {OUTSIDE, .help = "this is outside of every function: there is one } too many before it."},
    {ANY, .code = "^ *(import|using|from) ",
     .help = "C has no import: headers are included, as in #include \"{CONTRACT}\""},
    {ANY, "^expected", .behind = "^ *(and|or|not) ",
     .help = "and, or and not are written &&, || and ! in C."},
    {ANY, "operand of '[&|]'|^[&|] has lower precedence",
     .help = "&& is and, || is or; & and | work on bits."},
    {ANY, "^comparisons like", .help = "two comparisons are joined by &&: 0 < x && x < 1."},
    {ANY, "^expected identifier or '\\('", .code = "^\\{", .before = "\\);$",
     .help = "the ; at the end of line {BEFORE} separates the function from its { }: remove it."},
    {ANY, "^expected expression", .ahead = "^ *$", .before = ",$",
     .help = "line {BEFORE} ends with a comma, but needs a semicolon."},
    {UNUSED_VALUE, .code = "==", .help = "== compares; to give a variable a value, write =."},
    {ANY, "integer absolute value function", .help = INTEGER_ABS},
    {ANY, "used uninitialized|uninitialized when used",
     .help = "{NAME} is declared, but has no value yet."},
    {ANY, "No such file or directory|file not found",
     .help = "the contract of this chapter is #include \"{CONTRACT}\"; other headers are in "
             "common/."},
    {ANY, "^expected", .behind = "^ *x [A-Za-z(]",
     .help = "x is not an operator in C: * multiplies, and the cross product is vec3_cross(v, w)."},
    {ANY, "^expected '\\)'|^unterminated|at end of input", .needs = "{OPENED}",
     .help = "a ) is missing: there are more ( than )."},
    {ANY, "before '\\)' token|^extraneous '\\)'|^expected expression$", .needs = "{CLOSED}",
     .help = "one ) too many: there are more ) than (."},
    {ANY, "^expected '\\('", .code = BEFORE_WORD "(if|while|for) +[^ (]",
     .help = "if, while and for need parentheses: if (x > 0)."},
    {ANY, "^expected '[})]'", .ahead = "[A-Za-z_0-9)] *$", .behind = "^ *[A-Za-z_(]",
     .help = "an operator or a comma is missing there (2 t is 2 * t)."},
    {ANY, "^expected expression", .ahead = "= *$", .behind = "^[<>]",
     .help = "C writes >= and <=, not => and =<."},
    {ANY, "^(expected expression( before '[A-Za-z]|$)|unexpected type name)", .ahead = "^ *$",
     .needs = "{DECLARED}",
     .help = "a declaration after if, else or for needs braces around it: { }."},
    {ANY, "^subscripted value",
     .help = "{a AHEAD_TYPE} has no numbered parts: they are called {PARTS AHEAD_TYPE}."},
    {ANY, "^invalid operands to binary|^cannot convert between vector and non-scalar",
     .behind = "^([^^]|$)",
     .help = "there is no arithmetic with {a OPERAND} as a whole: its parts are {PARTS OPERAND}."},
    {ANY, "assignment used as truth value|result of an assignment as a condition",
     .help = "= assigns; to compare, write ==."},

    // A type, or a { or [, where there should be a value.
    {ANY, TYPE_FOUND, .behind = "^[A-Za-z0-9]+ *[({]",
     .help = "{NAME} is a type, not a function: write {WRITTEN NAME}."},
    {ANY, TYPE_FOUND, .ahead = "[(,] *$", .needs = "{WRITTEN NAME}",
     .help = "in a call, write only the values, without their types."},
    {ANY, "^expected expression", .behind = "^[{[]",
     .help = "{a TYPE_HERE} is written {WRITTEN TYPE_HERE}."},
    {ANY, "^expected expression", .behind = "^[{[]",
     .help = "put the type in parentheses before the braces, as in (Ray){origin, direction}."},

    {SEMICOLON, .code = BEFORE_WORD "for *\\([^;]*(;[^;]*)?$",
     .help = "for (...; ...; ...) has two semicolons between its three parts."},
    {SEMICOLON, .ahead = "^$", .behind = "^$",
     .help = "a semicolon is missing in line {LINE}, or at the end of the one before."},
    {SEMICOLON, .ahead = "^ *$", .help = "a semicolon is missing at the end of line {BEFORE}."},
    {SEMICOLON, .ahead = "^ *$",
     .help = "what comes first in the file is not C. If it is a comment, write // before it."},
    {SEMICOLON, .behind = "^\\^?[ })]*(//.*)?$",
     .help = "a semicolon is missing at the end of line {LINE}."},
    {SEMICOLON, .help = "in line {LINE} a semicolon is missing, or an operator (2 t is 2 * t)."},

    {ANY, "to use '->'", .needs = "{NO_PART}",
     .help = "{AHEAD} points to {a AHEAD_TYPE}" WHOSE_PARTS},
    {ANY, WRONG_ARROW, .needs = "{NO_PART}", .help = "{AHEAD} is {a AHEAD_TYPE}" WHOSE_PARTS},
    {ANY, "is a pointer; did you mean to use '->'",
     .help = "{AHEAD} is a pointer: write {AHEAD}->{PART}."},
    {ANY, "did you mean to use '->'", .help = "after a pointer comes -> and not a dot: ->{PART}."},
    {ANY, WRONG_ARROW, .help = "{AHEAD} is not a pointer: write {AHEAD}.{PART}."},

    {ANY, NO_PARTS, .ahead = " $",
     .help = "a dot is not a product in C: multiply numbers with *, and write v . w as "
             "vec3_dot(v, w)."},
    {ANY, NO_PARTS, .needs = "{VECTOR_VALUE}",
     .help = "a vec3 has no named parts: its components are v[0], v[1], v[2]."},
    {ANY, NO_PARTS, .needs = "{NUMBER_VALUE}",
     .help = "{VALUE} is a number and has no parts. Write {WHOLE PART}."},
    {ANY, NO_PARTS, .needs = "{NUMBER_VALUE}", .help = "{VALUE} is a number and has no parts."},
    {ANY, NO_PARTS,
     .help = "the value before the dot has no named parts: a number has none, and the components "
             "of a vec3 are v[0], v[1], v[2]."},
    {ANY, OTHER_MEMBER,
     .help = "the parts of {a MEMBER} are {PARTS MEMBER} ({HEADER MEMBER}).{SLIDES?}"},

    {ANY, "^invalid operands to binary", .behind = "^\\^", .help = "^ is exclusive or in C" POWER},
    {ANY, NO_STAR, .code = "\\*\\*", .help = "C has no **" POWER},
    {ANY, NO_STAR,
     .help = "a * in front of a name reads through a pointer, and this is not a pointer: remove "
             "the *."},
    {ANY, "^invalid (suffix|digit) .* (integer|decimal|floating) constant",
     .help = "a * is missing: 2x is 2 * x."},
    {ANY, "^called object",
     .help = "{ELEMENT}(...) is a call of a function; an element of an array is {ELEMENT}[...]."},
    {ANY, "^called object", .code = BEFORE_WORD "[0-9.]+ *\\(|\\) *\\(",
     .help = "a * is missing before the bracket: 2(x) is 2 * (x)."},
    {ANY,
     "^conversion to non-scalar type|^used type '[A-Za-z]*' where arithmetic|"
     "^cannot convert a value of type .* to vector type|"
     "^invalid conversion between vector type",
     .help = "{a CAST} is written {WRITTEN CAST}."},

    {ANY, .needs = "{COMMA}",
     .help = LOST_COMMA " {A COMMA_TYPE} is written {WRITTEN COMMA_TYPE}."},
    {ANY, .needs = "{COMMA}", .help = LOST_COMMA},
    {VECTOR, "initializ", .help = VECTOR_GIVEN " Or is the type of the variable wrong?"},
    {VECTOR, .help = VECTOR_GIVEN},

    // One type is wanted, and another given.
    {TYPES, .needs = "{FUNCTION_GIVEN}", .help = "{HERE} is a function here. " LIKE_CALL},
    {WANTS_POINTER, "assigning", .needs = "{NUMBER_GIVEN}",
     .help = "{WHAT}. One of the numbers there is {TARGET?}[i]."},
    {WANTS_POINTER, "assigning",
     .help = "{WHAT}. To store it where {TARGET?} points, write *{TARGET?} = ..."},
    {TYPES, "assigning", .code = "[^=<>!]=[^=].*\\?", .help = "{WHAT}. To compare, write ==."},
    {GIVES_POINTER, .behind = "^&", .help = "{WHAT}. Remove the &."},
    {GIVES_POINTER, .help = "{WHAT}. One of them is {LIST}[i]."},
    {GIVES_POINTER, .help = "{WHAT}. A * in front of a pointer gives the value it points to."},
    {WANTS_POINTER, .behind = "^\\*",
     .help = "{WHAT}. Remove the *: without it, this is a pointer."},
    {WANTS_POINTER, .help = "{WHAT}. A & in front makes a pointer to it."},
    {TYPES, .help = "{WHAT}. {MAKERS}."},
    {TYPES, .help = "{WHAT}." PROTOTYPE},
    {TYPES, .needs = "{VARIABLE}", .help = "{WHAT}. Is the type of the variable right?"},
    {TYPES, .help = "{WHAT}. Write {WRITTEN WANTED}."},
    {TYPES, .help = "{WHAT}. {A WANTED} is one of {VALUES WANTED} ({HEADER WANTED})."},
    {TYPES, .help = "{WHAT}. Its parts are {PARTS GIVEN}."},
    {TYPES, .help = "{WHAT}."},
    {ENDS_AT_ONCE, .help = ENDED_LOOP},

    // A name that nobody has declared.
    {UNKNOWN, .name = "^M_PI$", .help = "C11 has no M_PI: write PI (common/vec3.h)."},
    {UNKNOWN, .name = "^std$",
     .help = "C has no std:: - the functions of <math.h> have no such prefix, as in sqrt(x)."},
    {UNKNOWN, .name = "^new$",
     .help = "C has no new: a struct is written (Ray){origin, direction}, a vec3 "
             "vec3_of(x, y, z)."},
    {UNKNOWN, .name = "^(let|var|auto|def)$", .help = "C has no {NAME}: " DECLARE_NEW},
    {UNKNOWN, .name = "^l?abs$", .help = INTEGER_ABS},
    {UNKNOWN, .name = "^return[a-z]", .help = "a space is missing: return {RETURNED}"},
    {UNKNOWN, .help = "{NAME} is in the standard library: #include {LIBRARY}"},
    {UNKNOWN_FUNCTION,
     .help = "{NAME} is defined further down, in line {LATER}: move it above its use."},
    {LACKS_CONTRACT, .help = "#include \"{CONTRACT}\" is missing at the top of this file."},
    {UNKNOWN, .help = "the slide's {LETTERS}."},
    {UNKNOWN_VARIABLE, .needs = "{LOST_NAME}", .help = ""},
    {UNKNOWN, .help = NOTHING "{NAME}. It has another name here: write {WHOLE ITS_PART}."},
    {UNKNOWN_VARIABLE | UNKNOWN_TYPE, .help = "{NAME} is the name of a part: write {WHOLE NAME}."},
    {UNKNOWN, .help = "{NAME} is declared in another file: #include \"{OTHER_HEADER}\""},
    {UNKNOWN_TYPE,
     .name = "^([Dd]?[Vv](ec|EC)[34]?|[Vv](ector|ECTOR)3?|[Pp](oint|OINT)3?|"
             "[Ff]loat3|[Dd]ouble3)$",
     .help = "the type of points, vectors and colors is vec3 (common/vec3.h)."},
    {UNKNOWN, .help = "here its name is {KNOWN}: {PROTOTYPE KNOWN}  in {HEADER KNOWN}."},
    {UNKNOWN, .help = "in C its name is {KNOWN}."},
    {UNKNOWN, .name = "^(sqr|sq|square|squared)$", .help = "C has no square: write x * x."},
    {UNKNOWN, .needs = "{NAME_OF_LOOP}",
     .help = "{NAME} is not declared: for (int {NAME} = ...; ...; ...)."},
    {UNKNOWN, .help = ENDED_LOOP},
    {UNKNOWN, .help = "{NAME} is known only inside the loop of line {LOOP}."},
    {UNKNOWN, .help = NOTHING "{NAME}. It is written {LIKE} ({HEADER LIKE})."},
    {UNKNOWN_VARIABLE, .needs = "{PARTS CAPITAL}",
     .help = NOTHING "{NAME}. A {CAPITAL} of your own must be declared first: {CAPITAL}" UNBROKEN
                     "{NAME}" UNBROKEN "=" UNBROKEN "...;"},
    {UNKNOWN, .name = "^..",
     .help = NOTHING "{NAME}. Is it spelled as in {CONTRACT} or common/?{PARAMETERS?}"},
    {UNKNOWN, .help = NOTHING "{OTHERS}.{PARAMETERS?} Declare a variable of your own first, with "
                              "its type."},

    {COUNT, .help = "its prototype is  {PROTOTYPE COUNTED}  in {HEADER COUNTED}."},
    {COUNT, .help = "look at the prototype of the function: it lists the parameters."},

    // A name that is declared twice.
    {CONFLICT | STATIC, "^[^a]", .needs = "{PARAMETER}",
     .help = "{NAME} is already a parameter of {FUNCTION}: give yours another name."},
    {CONFLICT, "^redefinition", .help = "{NAME} is already defined in line {EARLIER}."},
    {CONFLICT, "^redefinition",
     .help = "{NAME} is already in {HEADER NAME}: use it, or give yours another name."},
    {STATIC, .needs = "{PROTOTYPE NAME}",
     .help = "remove the static in front of {NAME}: other files call it."},
    {CONFLICT, "^[^r]",
     .help = "the contract, {CONTRACT}, says  {PROMISED}: your function must begin like that."},
    {CONFLICT, "^[^r]",
     .help = "{DOUBLE} is already in {HEADER DOUBLE}, as  "
             "{PROTOTYPE DOUBLE}: give yours another name."},

    {ANY, "clause does not guard|^misleading indentation",
     .help = "without braces { } only one statement belongs to it."},
    {ANY, "^type defaults to 'int'|^type specifier missing", .code = "^ *auto ",
     .help = "C has no auto: " DECLARE_NEW},
    {ANY, "discards '?(const|qualifiers)",
     .help = "the data it points to must not change: put const in front of the pointer's type."},
    {ANY, "^parameter names .without types|^a parameter list without types",
     .help = "that declares a function. " LIKE_CALL},
    {ANY, "^invalid initializer", .help = "{a WANTED} is expected here: {WRITTEN WANTED}."},
    {ANY, "^'return' with no value|should return a value",
     .help = "return without a value: this function must return one. Write it after return."},
    {MISSING_RETURN, .help = LOST_RETURN " Line {LOST} computes a value, but does not return it."},
    {MISSING_RETURN, .help = LOST_RETURN},
};

// ---- the engine --------------------------------------------------------------------------------

static const char *number(size_t line)
{
    return line == 0 ? "" : text_format("%zu", line);
}

static const char *if_true(bool is_true)
{
    return is_true ? "true" : "";
}

// The first function of this name before the mistake, and the last one after it: its line, or 0.
static size_t defined_before(const Mistake *mistake)
{
    for (size_t i = 1; i <= answer.function_count && answer.functions[i].line < mistake->line; i++)
        if (text_is(answer.functions[i].name, mistake->name))
            return answer.functions[i].line;
    return 0;
}

static size_t defined_after(const Mistake *mistake)
{
    const OwnFunction *own = answer_function_named(mistake->name);
    return own != NULL && own->line > mistake->line ? own->line : 0;
}

// The line of the first value that the function of a mistake computes for nothing.
static size_t lost_value(const Mistake *mistake)
{
    for (size_t i = 0; i < all.count; i++)
        if (all.mistakes[i].kinds & UNUSED_VALUE && all.mistakes[i].begins == mistake->begins)
            return all.mistakes[i].line;
    return 0;
}

typedef struct {
    const char *word, *meaning;
} Word;

// All words that a help may have, of a mistake.
static const Word *find_words(const Mistake *mistake)
{
    const char *text = mistake->text, *name = mistake->name, *code = mistake->code,
               *behind = mistake->behind;
    size_t line = mistake->line;
    bool is_slides = mistake->kinds & SLIDES_LETTER, is_other = mistake->kinds & OTHER_LETTER;
    const char *function = answer_function(line)->name;
    const char *ahead = text_expression_at_end(mistake->ahead), *here = expression_here(mistake),
               *ahead_type = type_of(ahead, line);
    const char *slides = is_slides ? letters(SLIDES_LETTER, mistake->begins) : "";
    const char *target = text_expression_at_end(text_group(code, AHEAD_OF_EQUALS, 1));
    // That a return or an assignment wants.
    const char *type_here = text_matches(code, BEFORE_WORD "return[^A-Za-z_0-9]")
                                ? type_of_function(function)
                                : type_of(target, line);
    // Of a value that has no parts.
    const char *value_type = text_has(text, "base type") ? bare_type(name) : ahead_type;
    const char *counted = mistake->declared[0] != '\0' || text_has(text, "function call")
                              ? mistake->declared // clang tells the name only in its note
                              : text_group(text, "function[^']*'([^']*)", 1);
    const char *doubled = text_begins(text, "argument") ? function : name;
    const Declared *promised = declared(doubled, FUNCTION);
    const char *statement = answer_statement_text(line);
    const char *header = declared(name, ANYTHING)->header, *part = text_group(behind, PART, 3);
    bool is_other_header = !answer_includes(header) && !text_is(header, headers.contract);
    static const char variable[] = "^ *(const )?([A-Za-z_0-9]+) +[A-Za-z_0-9]+ *=",
                      for_name[] = BEFORE_WORD "for *\\( *([A-Za-z_0-9]+) *=";
    int open = text_count(statement, '(') - text_count(statement, ')');
    const Word words[] = {
        {"NAME", name},
        {"LINE", number(line)},
        {"BEFORE", number(answer_code_before(line))},
        {"BELOW", if_true(line < answer.last)},
        {"FUNCTION", function},
        {"PARAMETERS", mistake->kinds & UNKNOWN_VARIABLE ? parameters(mistake) : ""},
        {"CONTRACT", headers.contract},
        {"OTHER_HEADER", is_other_header ? header : ""},
        {"LOOP", number(answer_loop_of(name, line))},
        {"ENDED", number(ended_loop(mistake))},
        {"NAME_OF_LOOP", if_true(text_is(text_group(code, for_name, 2), name))},
        {"DECLARED", if_true(is_known_type(text_group(behind, "^([A-Za-z_0-9]+) +[A-Za-z_]", 1)))},
        {"VARIABLE", if_true(text_is(text_group(code, variable, 2), mistake->wanted))},
        {"LOST_NAME", if_true(is_lost(mistake))},
        {"PARAMETER", if_true(is_parameter(mistake))},
        {"COMMA", if_true(has_comma(mistake))},
        {"OPEN", number(all.open_function)},
        {"OPENED", if_true(open > 0)},
        {"CLOSED", if_true(open < 0)},
        {"SLIP", mistake->slip},
        {"KEYWORD", mistake->keyword},
        {"DECIMAL", mistake->decimal},
        {"POINT", text_replaced(mistake->decimal, ",", ".")},
        {"LETTERS", slides},
        {"SLIDES", is_slides ? text_format(" The slide's %s.", slides) : ""},
        {"OTHERS", is_other ? letters(OTHER_LETTER, mistake->begins) : name},
        {"RETURNED", text_group(name, "^return(.*)", 1)},
        {"AHEAD", ahead},
        {"AHEAD_TYPE", ahead_type},
        {"VALUE", ahead[0] == '\0' ? "this" : ahead},
        {"VECTOR_VALUE", if_true(is_vector_type(value_type))},
        {"NUMBER_VALUE", if_true(is_number(value_type))},
        {"PART", part},
        {"NO_PART", if_true(part[0] != '\0' && declared_field(ahead_type, part) == NULL)},
        {"LOOK", text_is(ahead_type, "Sphere") && declared_field("Surface", part) != NULL
                     ? text_format(" For its look, write scene_surface(scene, i)->%s.", part)
                     : ""},
        {"ITS_PART", text_begins(behind, name)
                         ? text_group(behind + strlen(name), "^(\\.|->)([A-Za-z_0-9]+)", 2)
                         : ""},
        {"HERE", here},
        {"LIST", text_matches(here, "(spheres|lights|surfaces)$") ? here : ""},
        {"TARGET", target},
        {"TYPE_HERE", type_here},
        {"COMMA_TYPE", mistake->wanted[0] != '\0' ? mistake->wanted : type_here},
        {"WANTED", mistake->wanted},
        {"GIVEN", mistake->given},
        {"FUNCTION_GIVEN", if_true(text_has(mistake->given, "(*)"))},
        {"NUMBER_GIVEN", if_true(is_number(mistake->given))},
        {"WHAT", mistake->kinds & TYPES ? what_is_wanted(mistake) : ""},
        {"MAKERS", makers(mistake)},
        {"CALLED", called(mistake)},
        {"COUNTED", counted},
        {"DOUBLE", doubled},
        {"PROMISED", text_is(promised->header, headers.contract) ? promised->prototype : ""},
        {"EARLIER", number(defined_before(mistake))},
        {"LATER", number(defined_after(mistake))},
        {"LOST", number(lost_value(mistake))},
        {"OPERAND", struct_operand(mistake)},
        {"CAST", text_group(code, "\\(([A-Za-z0-9]+)\\) *\\(", 1)},
        {"ELEMENT", text_group(code, "([A-Za-z_0-9]+(\\.|->)[A-Za-z_0-9]+) *\\(", 1)},
        {"MEMBER", bare_type(text[0] == '\'' ? name : text_group(text, SECOND_QUOTED, 1))},
        {"KNOWN", meant_by(name, known_names, sizeof known_names / sizeof *known_names)},
        {"LIBRARY", mistake->library[0] != '\0'
                        ? mistake->library
                        : meant_by(name, library, sizeof library / sizeof *library)},
        {"LIKE", name_like(mistake)},
        {"CAPITAL", text_format("%c%s", toupper((unsigned char)name[0]), name + (name[0] != '\0'))},
        {NULL, ""},
    };
    return memcpy(text_memory(sizeof words), words, sizeof words);
}

// What a verb says of a word: a Ray, the PARTS of a Ray.
static const char *said_of(const char *verb, const char *word, size_t line)
{
    return word[0] == '\0' || verb[0] == '\0' ? word
           : text_is(verb, "PARTS")           ? declared(word, TYPE)->parts
           : text_is(verb, "VALUES")          ? declared(word, TYPE)->values
           : text_is(verb, "WRITTEN")         ? written(word)
           : text_is(verb, "PROTOTYPE")       ? declared(word, FUNCTION)->prototype
           : text_is(verb, "HEADER")          ? declared(word, ANYTHING)->header
           : text_is(verb, "WHOLE")           ? whole_of(word, line) // width: c.width
                                              : with_article(verb[0], word);
}

// The help with its words filled in, or "" if one has no meaning.
static const char *filled(const char *help, const Word *words, size_t line)
{
    static const char pattern[] = "\\{(([A-Za-z]+) )?(([A-Z]+) )?([A-Z_]+)([?]?)\\}";
    const char *text = "";
    for (Match match; text_find(help, pattern, &match); help += match.end) {
        const Word *word = words;
        while (word->word != NULL && !text_is(word->word, match.group[5]))
            word++;
        const char *meaning = said_of(match.group[4], word->meaning, line);
        meaning = said_of(match.group[2], meaning, line);
        if (meaning[0] == '\0' && match.group[6][0] == '\0')
            return "";
        text = text_format("%s%.*s%s", text, (int)match.at, help, meaning);
    }
    return text_format("%s%s", text, help);
}

static bool has(const char *text, const char *pattern)
{
    return pattern == NULL || text_matches(text, pattern);
}

// A line of help, or "".
static const char *help(const Mistake *mistake)
{
    const Word *words = find_words(mistake);
    const char *before = answer_code(answer_code_before(mistake->line));
    for (const Rule *rule = rules; rule < rules + sizeof rules / sizeof *rules; rule++) {
        if ((rule->kinds != 0 && !(rule->kinds & mistake->kinds)) ||
            !has(mistake->text, rule->words) || !has(mistake->ahead, rule->ahead) ||
            !has(mistake->behind, rule->behind) || !has(mistake->code, rule->code) ||
            !has(before, rule->before) || !has(mistake->name, rule->name) ||
            (rule->needs != NULL && filled(rule->needs, words, mistake->line)[0] == '\0'))
            continue;
        const char *said = filled(rule->help, words, mistake->line);
        if (said[0] != '\0' || rule->help[0] == '\0')
            return said;
    }
    return "";
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
