// table.c - a stem's table as a file. The same on every machine, whatever its byte order.
//
// Reading and writing are one walk, so that they cannot differ. Whole numbers are short; only the
// differences between a wrong result and the right one are kept.
#include "tests/handout/replay/table.h"

#include <math.h>
#include <string.h>

typedef struct {
    FILE *file;
    bool reading, bad;
    uint8_t mask; // on each byte
} Stream;

// The sentences about mistakes are for students who make them, so they cannot be read in the file.
enum { UNREAD = 0xd5 };

static const char magic[] = "ray casting, told: 4";
enum { MOST_COUNT = 1 << 24, SMALL = 248, WIDE = 255 };

void *told_grow(void *items, int *count, size_t size)
{
    items = realloc(items, (size_t)(*count + 1) * size);
    if (items == NULL)
        abort();
    memset((char *)items + (size_t)*count * size, 0, size);
    ++*count;
    return items;
}

static void carry_byte(Stream *stream, uint8_t *byte)
{
    if (stream->reading) {
        int c = stream->bad ? EOF : getc(stream->file);
        stream->bad = stream->bad || c == EOF;
        *byte = c == EOF ? 0 : (uint8_t)(c ^ stream->mask);
    } else if (putc(*byte ^ stream->mask, stream->file) == EOF) {
        stream->bad = true;
    }
}

// Seven bits a byte, the lowest first.
static void carry_count(Stream *stream, int *count)
{
    unsigned left = (unsigned)*count, read = 0;
    uint8_t byte;
    for (int shift = 0; shift < 28; shift += 7) {
        byte = (uint8_t)((left & 127) | (left > 127 ? 128 : 0));
        carry_byte(stream, &byte);
        read |= (unsigned)(byte & 127) << shift;
        left >>= 7;
        if (byte < 128)
            break;
    }
    stream->bad = stream->bad || read > MOST_COUNT || left > 0;
    *count = stream->bad ? 0 : (int)read;
}

static void *carry_items(Stream *stream, void *items, int *count, size_t size)
{
    carry_count(stream, count);
    if (stream->reading)
        items = calloc((size_t)*count + 1, size);
    if (items == NULL && *count > 0)
        abort();
    return items;
}

static void carry_text(Stream *stream, char **text)
{
    int length = stream->reading ? 0 : (int)strlen(*text);
    *text = carry_items(stream, *text, &length, 1);
    for (int i = 0; i < length; i++)
        carry_byte(stream, (uint8_t *)*text + i);
}

static uint64_t bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

static bool same_bits(double a, double b)
{
    return bits_of(a) == bits_of(b);
}

static void carry_number(Stream *stream, double *number)
{
    bool small = *number >= 0 && *number < SMALL && *number == floor(*number) && !signbit(*number);
    uint8_t byte = small ? (uint8_t)*number : WIDE;
    carry_byte(stream, &byte);
    if (byte != WIDE) {
        *number = byte;
        return;
    }
    uint64_t bits = bits_of(*number), read = 0;
    for (int i = 0; i < 8; i++) {
        byte = (uint8_t)(bits >> 8 * i);
        carry_byte(stream, &byte);
        read |= (uint64_t)byte << 8 * i;
    }
    memcpy(number, &read, sizeof read);
}

static void carry_numbers(Stream *stream, Numbers *numbers)
{
    numbers->at = carry_items(stream, numbers->at, &numbers->count, sizeof *numbers->at);
    for (int i = 0; i < numbers->count; i++)
        carry_number(stream, &numbers->at[i]);
}

// The differences: the distance from the previous one, and the number.
static void carry_differences(Stream *stream, Numbers *numbers, const Numbers *from)
{
    int count = 0, last = 0;
    for (int i = 0; !stream->reading && i < from->count; i++)
        count += !same_bits(numbers->at[i], from->at[i]);
    carry_count(stream, &count);
    for (int i = 0; stream->reading && i < from->count; i++)
        numbers_add(numbers, from->at[i]);
    for (; count > 0 && !stream->bad; count--) {
        int next = last;
        while (!stream->reading && same_bits(numbers->at[next], from->at[next]))
            next++;
        int gap = next - last;
        carry_count(stream, &gap);
        next = last + gap;
        stream->bad = stream->bad || next >= numbers->count;
        if (!stream->bad)
            carry_number(stream, &numbers->at[next]);
        last = next + 1;
    }
}

static void carry_call(Stream *stream, ToldCall *call)
{
    carry_text(stream, &call->given);
    carry_numbers(stream, &call->arguments);
    call->results = carry_items(stream, call->results, &call->result_count, sizeof(Numbers));
    for (int i = 0; i < call->result_count && !stream->bad; i++) {
        if (i == 0)
            carry_numbers(stream, &call->results[i]);
        else
            carry_differences(stream, &call->results[i], &call->results[0]);
    }
    call->of_mistake = carry_items(stream, call->of_mistake, &call->mistake_count, sizeof(int));
    for (int i = 0; i < call->mistake_count; i++) {
        carry_count(stream, &call->of_mistake[i]);
        stream->bad = stream->bad || call->of_mistake[i] >= call->result_count;
    }
    carry_number(stream, &call->tolerance);
    carry_count(stream, &call->reasons);
    carry_count(stream, &call->length_is_free);
    carry_number(stream, &call->least);
    carry_number(stream, &call->most);
    carry_numbers(stream, &call->corners);
    stream->bad = stream->bad || call->result_count == 0;
}

static void carry_test(Stream *stream, ToldTest *test)
{
    carry_text(stream, &test->function);
    carry_text(stream, &test->name);
    carry_count(stream, &test->extra);
    carry_count(stream, &test->probe);
    test->calls = carry_items(stream, test->calls, &test->call_count, sizeof *test->calls);
    for (int i = 0; i < test->call_count && !stream->bad; i++)
        carry_call(stream, &test->calls[i]);
}

static bool carry(Stream *stream, Told *told)
{
    for (size_t i = 0; i < sizeof magic; i++) {
        uint8_t byte = (uint8_t)magic[i];
        carry_byte(stream, &byte);
        stream->bad = stream->bad || byte != (uint8_t)magic[i];
    }
    told->mistakes =
        carry_items(stream, told->mistakes, &told->mistake_count, sizeof *told->mistakes);
    for (int i = 0; i < told->mistake_count && !stream->bad; i++) {
        carry_text(stream, &told->mistakes[i].function);
        stream->mask = UNREAD;
        carry_text(stream, &told->mistakes[i].why);
        carry_text(stream, &told->mistakes[i].picture);
        stream->mask = 0;
        carry_count(stream, &told->mistakes[i].digits);
    }
    told->tests = carry_items(stream, told->tests, &told->test_count, sizeof *told->tests);
    for (int i = 0; i < told->test_count && !stream->bad; i++)
        carry_test(stream, &told->tests[i]);
    return !stream->bad;
}

void told_load(const char *stem, Told *told)
{
    char path[1000];
    snprintf(path, sizeof path, TABLES "/%s.table", stem);
    FILE *file = fopen(path, "rb");
    Stream stream = {.file = file, .reading = true};
    *told = (Told){0};
    bool good = file != NULL && carry(&stream, told);
    for (int i = 0; good && i < told->test_count; i++)
        good = exercise_number(told->tests[i].function) >= 0;
    if (!good) {
        fprintf(stderr, "%s: cannot be read, or is not a table of this version\n", path);
        exit(2);
    }
    fclose(file);
}

bool told_write(FILE *file, Told *told)
{
    Stream stream = {.file = file};
    return carry(&stream, told) && fflush(file) == 0 && !ferror(file);
}
