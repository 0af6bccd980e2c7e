// nff_line.c - a scene file line by line.
//
// A scene may be anything: empty, truncated, binary, without an end. One piece at a time is held,
// and no line may be longer than an honest scene needs, so that nothing a file says makes it costly
// to refuse.
#include "common/nff_line.h"

#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool nff_begin(NffLine *line, FILE *file, const char *file_name, Message *message)
{
    *line = (NffLine){.file = file, .file_name = file_name, .message = message, .room = NFF_HELD};
    line->held = malloc(line->room + NUMBER_PADDING);
    line->next = line->end = line->held;
    if (line->held == NULL)
        return message_set(message, "%.200s: no memory to read it", file_name);
    memset(line->end, 0, NUMBER_PADDING);
    return true;
}

void nff_end(NffLine *line)
{
    free(line->held);
}

bool nff_wrong(NffLine *line, const char *format, ...)
{
    Message what;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what.text, sizeof what.text, format, arguments);
    va_end(arguments);
    line->failed = true;
    int room = (int)sizeof line->message->text;
    snprintf(line->message->text, (size_t)room, "%.200s:%d: %.180s", line->file_name, line->number,
             what.text);
    return false;
}

// Moves the rest to the front and reads more after it. False if there is no more.
static bool hold_more(NffLine *line)
{
    size_t left = (size_t)(line->end - line->next);
    memmove(line->held, line->next, left);
    errno = 0;
    size_t more = fread(line->held + left, 1, line->room - left, line->file);
    if (ferror(line->file) && line->error == 0)
        line->error = errno;
    line->next = line->held;
    line->end = line->held + left + more;
    memset(line->end, 0, NUMBER_PADDING);
    return more > 0;
}

void nff_hold(NffLine *line, size_t size)
{
    if ((size_t)(line->end - line->next) < size)
        hold_more(line);
}

off_t nff_tell(const NffLine *line)
{
    return ftello(line->file) - (line->end - line->next);
}

bool nff_seek(NffLine *line, off_t start)
{
    line->next = line->end = line->held;
    memset(line->end, 0, NUMBER_PADDING);
    return fseeko(line->file, start, SEEK_SET) == 0 ||
           nff_wrong(line, "cannot be read: %s", strerror(errno));
}

// One line without its end, a 0 in the place of that. NULL at the end of the file or on an error.
static char *read_text(NffLine *line)
{
    char *stop;
    do {
        size_t held = (size_t)(line->end - line->next);
        stop = memchr(line->next, '\n', held);
        size_t length = stop != NULL ? (size_t)(stop - line->next) : held;
        size_t seen = length <= NFF_LONGEST_LINE ? length : NFF_LONGEST_LINE + 1;
        if (memchr(line->next, '\0', seen) != NULL)
            nff_wrong(line, "a zero byte: this is not text, expected an NFF scene");
        else if (length > NFF_LONGEST_LINE)
            nff_wrong(line, "a line of more than %d characters, expected an NFF scene",
                      NFF_LONGEST_LINE);
        if (line->failed)
            return NULL;
    } while (stop == NULL && hold_more(line));
    if (stop == NULL && ferror(line->file))
        nff_wrong(line, "cannot be read: %s", strerror(line->error));
    if (stop == NULL && (line->failed || line->next == line->end))
        return NULL;
    char *text = line->next;
    line->next = stop != NULL ? stop + 1 : line->end;
    if (stop != NULL)
        *stop = '\0';
    return text;
}

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r'); // \t \n \v \f \r
}

static bool split(NffLine *line, char *text)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    if (line->number == 1 && strncmp(text, byte_order_mark, 3) == 0)
        text += 3;
    line->word_count = 0;
    for (;;) {
        while (is_blank(*text))
            text++;
        if (*text == '\0' || *text == '#')
            return true;
        if (line->word_count == NFF_MOST_WORDS)
            return nff_wrong(line, "more than %d words in a line", NFF_MOST_WORDS);
        line->words[line->word_count++] = text;
        while (*text != '\0' && *text != '#' && !is_blank(*text))
            text++;
        bool last = *text == '\0' || *text == '#';
        *text++ = '\0';
        if (last)
            return true;
    }
}

bool nff_next(NffLine *line)
{
    do {
        if (line->number == INT_MAX)
            return nff_wrong(line, "more lines than can be counted");
        line->number++;
        char *text = read_text(line);
        if (text == NULL && !line->failed && line->number > 1)
            line->number--; // the end of the file is in its last line
        if (text == NULL || !split(line, text))
            return false;
    } while (line->word_count == 0);
    return true;
}

// The word of this index as a number.
static bool read_word(NffLine *line, int index, const char *expected, double *number)
{
    const char *word = line->words[index];
    const char *end = read_number(word, number);
    if (end == NULL || *end != '\0')
        return nff_wrong(line, "'%s' is not a finite number, expected %s", word_text(word).s,
                         expected);
    return true;
}

// Skipped lines are also checked: if one were missing, the next entity would be lost without a
// word.
bool nff_skip(NffLine *line, int lines)
{
    char expected[80];
    double unused;
    snprintf(expected, sizeof expected, "%d lines of numbers after line %d", lines, line->number);
    for (int i = 0; i < lines; i++) {
        if (!nff_next(line))
            return line->failed ? false
                                : nff_wrong(line, "the end of the file, expected %s", expected);
        for (int k = 0; k < line->word_count; k++)
            if (!read_word(line, k, expected, &unused))
                return false;
    }
    return true;
}

bool nff_numbers(NffLine *line, const char *expected, int least, int most, double *numbers)
{
    int count = line->word_count - 1;
    if (count < least || count > most)
        return nff_wrong(line, "%d numbers, expected %s", count, expected);
    for (int i = 0; i < count; i++)
        if (!read_word(line, i + 1, expected, &numbers[i]))
            return false;
    return true;
}

bool nff_vec3(NffLine *line, const char *expected, vec3 *v)
{
    double n[3] = {0};
    if (!nff_numbers(line, expected, 3, 3, n))
        return false;
    *v = vec3_of(n[0], n[1], n[2]);
    return true;
}
