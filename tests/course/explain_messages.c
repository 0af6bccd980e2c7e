// explain_messages.c - see explain_messages.h.
#include "tests/course/explain_messages.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// ---- words --------------------------------------------------------------------------------------

// A colour, or the erasing of a line; 0 if there is none.
static size_t escape_sequence(const char *at)
{
    if (at[0] != '\033' || at[1] != '[')
        return 0;
    size_t length = 2 + text_span(at + 2, "0123456789;");
    return at[length] == 'm' || at[length] == 'K' ? length + 1 : 0;
}

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

const char *plain(const char *line)
{
    char *text = text_memory(strnlen(line, LONGEST_LINE) + 1);
    size_t size = 0;
    for (size_t i = 0, length; line[i] != '\0' && size < LONGEST_LINE; i += length)
        if ((length = escape_sequence(line + i)) == 0)
            text[size++] = plain_character(line + i, &length);
    text[size] = '\0';
    const char *words =
        text_has(text, "aka ") || text_has(text, "vector") ? without_vector(text) : text;
    size = strlen(words);
    while (size > 0 && words[size - 1] == ' ')
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

// ---- reading ------------------------------------------------------------------------------------

typedef struct {
    Diagnostics *found;
    const Answer *answer;
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
    if (reader->found->count == MOST_READ) {
        reader->found->unread++;
        return;
    }
    const char *place = text_from(line, strlen(reader->answer->source) + 1);
    char *end;
    unsigned long number = strtoul(place, &end, 10);
    unsigned long column = *end == ':' ? strtoul(end + 1, NULL, 10) : 0;
    reader->message = &reader->found->messages[reader->found->count++];
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
    Match match;
    if (message == NULL || reader->found->unread > 0 ||
        text_says(words, "column-tracking|silence this warning|near initialization"))
        return;
    if (text_matches(words, "include .*<[a-z_/0-9]+\\.h>")) {
        if (text_find(words, "<[a-z_/0-9]+\\.h>", &match))
            message->library = text_part(words, match.at, match.length);
    } else if (text_matches(words, "^expected .* but argument is of type"))
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

static bool is_caret_line(const char *line)
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
    Diagnostics *found = reader->found;
    const char *beginning = text_part(line, 0, head), *words = text_from(line, head);
    bool is_error = text_matches(beginning, "error: $");
    reader->inside = false;
    if (text_matches(beginning, " note: $"))
        read_note(reader, line, beginning, words, own);
    else if (own)
        begin_message(reader, line, words, !is_error);
    else {
        if (is_error && found->elsewhere[0] == '\0')
            found->elsewhere = line;
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
    Diagnostics *found = reader->found;
    const char *source = reader->answer->source;
    bool own = text_begins(line, source) && line[strlen(source)] == ':';
    Match head;
    if (found->raw_count < MOST_SHOWN && text_says(line, "error|Error"))
        found->raw[found->raw_count++] = line;
    if (is_about_nothing(line, own, strlen(source)))
        reader->inside = false;
    else if (text_says(line, "^In file included from |^                 from ")) {
        reader->inside = false;
        const char *where = strstr(line, text_format("%s:", source));
        if (where != NULL)
            found->where_included = text_without(where, "[:,]$");
    } else if (text_find(line,
                         "^[^ |][^:]*:[0-9]+:([0-9]+:)? (fatal error|error|warning|note): ", &head))
        read_first_line(reader, line, head.length, own);
    else if (reader->inside)
        read_below(reader, line);
}

// gcc does not quote a line again that it quoted for the message before, which may be left out.
static void quote_again(const Answer *answer, Message *message)
{
    const char *text = answer_text(answer, message->line_number);
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

Diagnostics *diagnostics_read(const Answer *answer, const char *words)
{
    Diagnostics *found = text_memory(sizeof *found);
    found->elsewhere = found->where_included = "";
    Reader reader = {.found = found, .answer = answer, .before = "", .in_macro = ""};
    char *rest = text_copy(words);
    for (char *line; (line = text_next_line(&rest)) != NULL;)
        read_line(&reader, plain(line));
    for (size_t i = 0; i < found->count; i++)
        quote_again(answer, &found->messages[i]);
    return found;
}
