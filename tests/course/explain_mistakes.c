// explain_mistakes.c - the compiler's messages: which mistake each is about, by the words of gcc
// and clang, and which are left out because they only follow from another.

#include "tests/course/explain_inside.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

Explanation all;

// ---- words -------------------------------------------------------------------------------------

static bool is_continuation(char c)
{
    return ((unsigned char)c & 0xC0) == 0x80;
}

// Of several bytes, one character: a typographic quote is a plain one, all else '?'.
static char plain_character(const char *at, size_t *length)
{
    const unsigned char *byte = (const unsigned char *)at;
    *length = 1;
    if (byte[0] == '\t')
        return ' ';
    if (byte[0] < 0xC0)
        return byte[0] >= ' ' && byte[0] <= '~' ? at[0] : '?';
    if (byte[0] == 0xE2 && byte[1] == 0x80 && (byte[2] == 0x98 || byte[2] == 0x99)) {
        *length = 3;
        return '\'';
    }
    while (is_continuation(at[*length]))
        ++*length;
    return '?';
}

// The note of gcc and clang on the type behind vec3 does not help a student.
static const char *without_vector(const char *line)
{
    line = text_replaced(line, " \\{aka [^}]*\\}", "");
    line = text_replaced(line, " \\(aka '[^']*'\\)", "");
    line = text_replaced(line, " \\(vector of 4 '[a-z ]*' values\\)", "");
    line =
        text_replaced(line, "__attribute__\\(\\(__vector_size__\\([^)]*\\)\\)+ [a-z ]*", "vector");
    return text_replaced(line, "'__vector\\(4\\) double'", "'vec3'");
}

// Plain ASCII without colours, typographic quotes, or the type behind vec3.
static const char *plain(const char *line)
{
    line = text_replaced(line, "\033\\[[0-9;]*[mK]", ""); // colours, and the erasing of a line
    char *text = text_memory(strnlen(line, LONGEST_LINE) + 1);
    size_t size = 0;
    for (size_t i = 0, length; line[i] != '\0' && size < LONGEST_LINE; i += length)
        text[size++] = plain_character(line + i, &length);
    text[size] = '\0';
    const char *words =
        text_has(text, "aka ") || text_has(text, "vector") ? without_vector(text) : text;
    size = strlen(words);
    while (size > 0 && words[size - 1] == ' ') // no pattern: that takes long for many blanks
        size--;
    return text_part(words, 0, size);
}

// The part that is between the quotes number first and first + 1.
static const char *between_quotes(const char *text, int first)
{
    for (; first > 0; first--) {
        text = strchr(text, '\'');
        if (text == NULL)
            return "";
        text++;
    }
    return text_part(text, 0, strcspn(text, "'"));
}

const char *quoted(const char *text)
{
    return between_quotes(text, 1);
}

const char *quoted_second(const char *text)
{
    return between_quotes(text, 3);
}

// ---- reading -----------------------------------------------------------------------------------

typedef struct {
    Message *message;     // that is being read, or NULL
    bool inside;          // lines still belong to it
    bool inside_note;     // or to its note
    bool pointed;         // the caret has come
    const char *before;   // the line before this one; "" at the beginning
    const char *in_macro; // an error in a macro that the answer may use; or ""
} Reader;

// "FILE:LINE:COLUMN: error: WORDS" about the answer.
static void begin_message(Reader *reader, const char *line, const char *text, bool is_warning)
{
    reader->inside = false;
    if (all.count == MOST_READ) {
        all.unread++;
        return;
    }
    const char *place = text_from(line, strlen(answer.source) + 1);
    char *end;
    unsigned long number = strtoul(place, &end, 10);
    unsigned long column = *end == ':' ? strtoul(end + 1, NULL, 10) : 0;
    reader->message = &all.messages[all.count++];
    *reader->message = (Message){.line = line,
                                 .text = text,
                                 .is_warning = is_warning,
                                 .line_number = number,
                                 .column = column,
                                 .quoted_line = "",
                                 .ahead = "",
                                 .behind = "",
                                 .library = "",
                                 .argument = "",
                                 .declared = ""};
    reader->inside = true;
    reader->inside_note = reader->pointed = false;
    reader->before = reader->in_macro = "";
}

static void read_note(Reader *reader, const char *line, const char *head, const char *words,
                      bool own)
{
    if (own && text_begins(words, "in expansion of macro") && reader->in_macro[0] != '\0') {
        // gcc places an error in a macro where the macro is defined.
        const char *where = text_without(head, ": note: $");
        begin_message(reader, text_format("%s: error: %s", where, reader->in_macro),
                      reader->in_macro, false);
        return;
    }
    Message *message = reader->message;
    if (message == NULL || all.unread > 0 ||
        text_says(words, "column-tracking|silence this warning|near initialization"))
        return;
    if (text_matches(words, "include .*<[a-z_/0-9]+\\.h>"))
        message->library = text_group(words, "<[a-z_/0-9]+\\.h>", 0);
    else if (text_matches(words, "^expected .* but argument is of type"))
        message->argument = words;
    else if (text_matches(words, "^('[^']*' )?declared here")) {
        if (quoted(words)[0] != '\0')
            message->declared = quoted(words);
    } else if (own &&
               !text_says(words, "each undeclared identifier|^passing argument to parameter")) {
        lines_add(&message->body, line);
        reader->inside = reader->inside_note = true;
        reader->pointed = false;
        reader->before = "";
    }
}

// Divides the quoted line at the caret below it.
static void find_place(Message *message, const char *text_line, const char *caret_line)
{
    size_t at = strcspn(caret_line, "^");
    message->ahead = text_without(text_part(text_line, 0, at), "^ *[0-9]+ \\|");
    message->behind = text_from(text_line, at);
    message->quoted_line = text_line;
}

bool is_caret_line(const char *line)
{
    return line[text_span(line, " |~")] == '^';
}

static void read_below(Reader *reader, const char *line)
{
    Message *message = reader->message;
    if (!reader->pointed) {
        lines_add(&message->body, line);
        if (!reader->inside_note && text_has(line, "^") && reader->before[0] != '\0') {
            find_place(message, reader->before, line);
            reader->pointed = true;
        } else
            reader->pointed = is_caret_line(line);
        reader->before = line;
    } else if (line[0] != '\0' && !text_matches(line, "^ *([0-9]+|\\+\\+\\+) \\|"))
        // The repair and the labels after the caret are kept; the following lines that gcc quotes
        // are not.
        lines_add(&message->body, line);
    else
        reader->inside = false;
}

// FILE:LINE:COLUMN: error: WORDS, about the answer or about another file.
static void read_first_line(Reader *reader, const char *line, size_t head, bool own)
{
    const char *beginning = text_part(line, 0, head), *words = text_from(line, head);
    bool is_error = text_matches(beginning, "error: $");
    reader->inside = false;
    if (text_matches(beginning, " note: $"))
        read_note(reader, line, beginning, words, own);
    else if (own)
        begin_message(reader, line, words, !is_error);
    else {
        if (is_error && all.elsewhere[0] == '\0')
            all.elsewhere = line;
        reader->in_macro = is_error ? words : "";
    }
}

// Lines of a compiler about itself, or before a message: In function 'f':
static bool is_about_nothing(const char *line, bool own, size_t name)
{
    return (own && line[name + 1] == ' ') ||
           text_says(line, "^cc1: |^compilation terminated|^fatal error: too many errors") ||
           (isdigit((unsigned char)line[0]) &&
            text_matches(line, "^[0-9]+ (warning|error).* generated\\.$"));
}

static void read_line(Reader *reader, const char *line)
{
    const char *source = answer.source;
    bool own = text_begins(line, source) && line[strlen(source)] == ':';
    Match head;
    if (all.raw_count < MOST_SHOWN && text_says(line, "error|Error"))
        all.raw[all.raw_count++] = line;
    if (is_about_nothing(line, own, strlen(source)))
        reader->inside = false;
    else if (text_says(line, "^In file included from |^                 from ")) {
        reader->inside = false;
        const char *where = strstr(line, text_format("%s:", source));
        if (where != NULL)
            all.where_included = text_without(where, "[:,]$");
    } else if (text_find(line,
                         "^[^ |][^:]*:[0-9]+:([0-9]+:)? (fatal error|error|warning|note): ", &head))
        read_first_line(reader, line, head.length, own);
    else if (reader->inside)
        read_below(reader, line);
}

// gcc does not quote a line again that it quoted for the message before, which may be left out.
static void quote_again(Message *message)
{
    const char *text = answer_text(message->line_number);
    if (message->quoted_line[0] != '\0' || message->column == 0 || message->column > LONGEST_LINE ||
        text_has(text, "\t"))
        return;
    const char *line = text_format("%5zu | %s", message->line_number, plain(text));
    const char *caret = text_format("      | %*s", (int)message->column, "^");
    Lines body = {NULL, 0};
    lines_add(&body, line);
    lines_add(&body, caret);
    for (size_t i = 0; i < message->body.count; i++)
        lines_add(&body, message->body.line[i]);
    message->body = body;
    find_place(message, line, caret);
}

static void read_messages(const char *words)
{
    all.elsewhere = all.where_included = "";
    Reader reader = {.before = "", .in_macro = ""};
    char *rest = text_copy(words);
    for (char *line; (line = text_next_line(&rest)) != NULL;)
        read_line(&reader, plain(line));
    for (size_t i = 0; i < all.count; i++)
        quote_again(&all.messages[i]);
}

// ---- kinds -------------------------------------------------------------------------------------

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

static bool is_pasted(const Mistake *mistake)
{
    const char *behind = mistake->message->behind;
    return (text_begins(mistake->text, "expected") && behind[text_span(behind, " ")] == '?' &&
            has_foreign_byte(answer_text(mistake->line))) ||
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

// ---- keywords ----------------------------------------------------------------------------------

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

// ---- types -------------------------------------------------------------------------------------

// Which type was wanted and which was given, if the message says so.
static void find_types(Mistake *mistake)
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
        mistake->wanted = type_of(name, mistake->line);
        const char *value = text_before(text_without(mistake->code, "[^=]*= *"), ";");
        mistake->given = type_of_argument(value, mistake->line);
    }
    if (text_matches(mistake->given, " ?\\* ?const$"))
        mistake->given = text_format("%s *", text_without(mistake->given, " ?\\* ?const$"));
}

// The name that a line with a misspelled type declares.
static const char *declared_by(const Mistake *mistake)
{
    if (!mistake->is_unknown || !text_has_word(mistake->code, mistake->name) ||
        text_has(mistake->text, "function '"))
        return "";
    const char *after = strstr(mistake->code, mistake->name) + strlen(mistake->name);
    return text_group(after, "^ +\\**([A-Za-z_][A-Za-z_0-9]*)", 1);
}

// ---- letters -----------------------------------------------------------------------------------

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

static void find_letters(Mistake *mistake)
{
    AboutFunction *about = &all.about[mistake->begins];
    const char *owner;
    bool is_letter = mistake->is_unknown && is_one_letter(mistake->name) &&
                     !text_says(mistake->text, "function '|unknown type") &&
                     answer_loop_of(mistake->name, mistake->line) == 0;
    mistake->translation = is_letter
                               ? translated(mistake->name, mistake->line, about->strange_letters)
                               : letter_of_whole(mistake);
    if (mistake->translation[0] != '\0')
        add_to(&about->letters, mistake->translation);
    else if (is_letter && whole_of(mistake->name, mistake->line, &owner)[0] == '\0')
        add_to(&about->strange_letters, mistake->name);
    else
        is_letter = false;
    mistake->is_letter = is_letter || mistake->translation[0] != '\0';
}

// ---- consequences ------------------------------------------------------------------------------

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
static bool follows_in_function(const Mistake *j, const Mistake *i)
{
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
        answer_ends_at_once(j->line) && answer_loop_of(i->name, i->line) == j->line)
        return true;
    if (i->is_unknown && i->line == i->begins && text_has(j->text, "'int'"))
        return true;
    if (later && i->declares[0] != '\0' && text_has_word(j->code, i->declares))
        return true;
    // The declaration that lost its semicolon took the next one with it; brackets, the function.
    return i->is_syntax && later && (j->is_outside || text_has(j->text, "undeclared"));
}

// Whether message j only follows from message i.
static bool follows(const Mistake *j, const Mistake *i)
{
    bool later = j > i, is_warning = j->message->is_warning;
    if (i->lacks_contract && (later || is_warning))
        return true;
    // image_set is a macro: without its ) it takes the rest of the file, at whose end gcc says so.
    if ((text_begins(j->text, "unterminated argument") && text_has(i->text, "at end of input")) ||
        (text_begins(i->text, "unterminated function-like macro") && later))
        return true;
    if (i->is_pasted && i->line == j->line && (later || !j->is_pasted))
        return true;
    if (i->is_missing_brace && j->line >= all.open_function)
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
                           "integer absolute value|type mismatch in conditional"))
        return true;
    return i->begins != 0 && i->begins == j->begins && follows_in_function(j, i);
}

static void drop_what_follows(void)
{
    for (size_t i = 0; i < all.count; i++)
        for (size_t j = 0; j < all.count; j++)
            if (j != i && !all.mistakes[i].is_dropped && !all.mistakes[j].is_dropped &&
                follows(&all.mistakes[j], &all.mistakes[i]))
                all.mistakes[j].is_dropped = true;
}

// ---- all together ------------------------------------------------------------------------------

bool has_comma_in_statement(const Mistake *mistake)
{
    for (size_t i = 0; i < all.count; i++)
        if (all.mistakes[i].is_comma && all.mistakes[i].statement == mistake->statement)
            return true;
    return false;
}

static void understand(Mistake *mistake)
{
    const char *text = mistake->text, *name = mistake->name;
    mistake->begins = answer_beginning(mistake->line);
    mistake->statement = answer_statement(mistake->line);
    mistake->is_unknown = is_unknown(text);
    find_letters(mistake);
    mistake->lacks_contract =
        mistake->is_unknown && !answer_includes(headers.contract) && header_of(name) != NULL;
    mistake->is_pasted = is_pasted(mistake);
    // gcc reports only once that the function fro does not exist.
    mistake->slip = name;
    if (text_begins(text, "expected expression before '") &&
        text_matches(mistake->message->ahead, "[a-z]+ *\\($"))
        mistake->slip = text_group(mistake->message->ahead, "([a-z]+) *\\($", 1);
    mistake->keyword = mistake->is_unknown || !text_is(mistake->slip, name)
                           ? misspelled(mistake->slip, mistake->code)
                           : "";
    mistake->is_syntax = is_syntax(text) || mistake->is_pasted || mistake->keyword[0] != '\0' ||
                         (mistake->is_unknown && text_is_one_of(name, "std new let var def"));
    mistake->is_count =
        text_says(text, "^too few arguments to function|^too many arguments to function");
    mistake->is_signature = is_signature(text);
    mistake->is_missing_return = is_missing_return(text);
    mistake->is_missing_brace = all.open_function != 0 && is_missing_brace(text);
    mistake->is_outside = is_outside(text, mistake->code);
    find_types(mistake);
    mistake->decimal = may_be_decimal_comma(text) ? answer_decimal_comma(mistake->line) : "";
    mistake->is_comma = is_comma(text);
    mistake->is_unused_value = is_unused_value(text);
    if (mistake->is_unused_value && all.about[mistake->begins].lost == 0)
        all.about[mistake->begins].lost = mistake->line;
    mistake->declares = declared_by(mistake);
}

void explanation_read(const char *source, const char *words)
{
    const char *slash = strrchr(source, '/'), *stem = slash == NULL ? source : slash + 1;
    answer_read(source);
    headers_read(text_format("exercises/%s.h", text_without(stem, "\\.c$")));
    all = (Explanation){.open_function = answer_unclosed()};
    read_messages(words);
    all.about = text_memory((answer.count + 1) * sizeof *all.about);
    for (size_t i = 0; i <= answer.count; i++)
        all.about[i].letters = all.about[i].strange_letters = "";
    for (size_t i = 0; i < all.count; i++) {
        const Message *message = &all.messages[i];
        all.mistakes[i] = (Mistake){.message = message,
                                    .text = message->text,
                                    .line = message->line_number,
                                    .code = answer_code(message->line_number),
                                    .name = quoted(message->text),
                                    .wanted = "",
                                    .given = ""};
        understand(&all.mistakes[i]);
    }
    drop_what_follows();
}
