// nff_line.c - a scene file line by line.
//
// A scene may be anything: empty, truncated, binary, without an end. One line at a time is held,
// of a length that no honest scene needs, so that nothing a file says makes it costly to refuse.
#include "common/nff_line.h"

#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <string.h>

void nff_begin(NffLine *line, FILE *file, const char *file_name, Message *message)
{
    *line = (NffLine){.file = file, .file_name = file_name, .message = message};
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

// One line without its end, into text. False at the end of the file or on an error.
static bool read_text(NffLine *line)
{
    size_t length = 0;
    int c;
    errno = 0;
    while ((c = getc(line->file)) != EOF && c != '\n') {
        if (c == '\0')
            return nff_wrong(line, "a zero byte: this is no text, expected an NFF scene");
        if (length == NFF_LONGEST_LINE)
            return nff_wrong(line, "a line of more than %d characters, expected an NFF scene",
                             NFF_LONGEST_LINE);
        line->text[length++] = (char)c;
    }
    line->text[length] = '\0';
    if (ferror(line->file))
        return nff_wrong(line, "cannot be read: %s", strerror(errno));
    return c == '\n' || length > 0;
}

static bool split(NffLine *line)
{
    static const char blanks[] = " \t\r\f\v";
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    char *text = line->text;
    if (line->number == 1 && strncmp(text, byte_order_mark, 3) == 0)
        text += 3;
    text[strcspn(text, "#")] = '\0';
    line->word_count = 0;
    for (text += strspn(text, blanks); *text != '\0'; text += strspn(text, blanks)) {
        if (line->word_count == NFF_MOST_WORDS)
            return nff_wrong(line, "more than %d words in a line", NFF_MOST_WORDS);
        line->words[line->word_count++] = text;
        text += strcspn(text, blanks);
        if (*text != '\0')
            *text++ = '\0';
    }
    return true;
}

bool nff_next(NffLine *line)
{
    do {
        if (line->number == INT_MAX)
            return nff_wrong(line, "more lines than can be counted");
        line->number++;
        if (!read_text(line)) {
            if (!line->failed && line->number > 1)
                line->number--; // the end of the file is in its last line
            return false;
        }
        if (!split(line))
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
        return nff_wrong(line, "'%s' is no finite number, expected %s", word_text(word).s,
                         expected);
    return true;
}

// What is passed over is looked at, or a line too few would swallow what follows unseen.
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
