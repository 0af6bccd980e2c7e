// table.c - a stem's table as a file. The same on every machine, whatever its byte order.
//
// Reading and writing are one walk, so that they cannot differ. Whole numbers are short; only the
// differences between a wrong result and the right one are kept.
#include "tests/judge/table.h"

#include <math.h>
#include <string.h>
#include <sys/stat.h>

typedef struct {
    FILE *file; // NULL while it is read
    const uint8_t *bytes;
    size_t size, next; // of what is read
    bool reading, bad;
    uint8_t mask; // on each byte
} Stream;

// The sentences about mistakes are for students who make them, so they cannot be read in the file.
enum { UNREAD = 0xd5 };

static const char magic[] = "ray casting, table: 4";
enum { MOST_COUNT = 1 << 24, SMALL = 248, INFINITE = 254, WIDE = 255 };

void *table_grow(void *items, int *count, size_t size)
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
        stream->bad = stream->bad || stream->next >= stream->size;
        *byte = stream->bad ? 0 : stream->bytes[stream->next++] ^ stream->mask;
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

static void carry_text(Stream *stream, const char **text)
{
    int length = stream->reading ? 0 : (int)strlen(*text);
    uint8_t *bytes = carry_items(stream, (char *)*text, &length, 1);
    for (int i = 0; i < length; i++)
        carry_byte(stream, bytes + i);
    *text = (const char *)bytes;
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
    uint8_t byte = small ? (uint8_t)*number : *number == INFINITY ? INFINITE : WIDE;
    carry_byte(stream, &byte);
    if (byte != WIDE) {
        *number = byte == INFINITE ? INFINITY : byte;
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

// The differences: the distance from the previous one, and the number. No numbers: reads past them.
static void carry_differences(Stream *stream, Numbers *numbers, const Numbers *from)
{
    int count = 0, last = 0;
    double ignored = 0;
    for (int i = 0; !stream->reading && i < from->count; i++)
        count += !same_bits(numbers->at[i], from->at[i]);
    carry_count(stream, &count);
    for (; count > 0 && !stream->bad; count--) {
        int next = last;
        while (!stream->reading && same_bits(numbers->at[next], from->at[next]))
            next++;
        int gap = next - last;
        carry_count(stream, &gap);
        next = last + gap;
        stream->bad = stream->bad || next >= from->count;
        if (!stream->bad)
            carry_number(stream, numbers != NULL ? &numbers->at[next] : &ignored);
        last = next + 1;
    }
}

const Numbers *question_result(const Question *question, int i)
{
    Numbers *result = &question->results[i];
    if (result->at == NULL && i > 0) {
        Stream stream = {.reading = true, .bytes = question->differences[i], .size = SIZE_MAX};
        *result = numbers_copy(&question->results[0]);
        carry_differences(&stream, result, &question->results[0]);
    }
    return result;
}

// What a right answer needs.
static void carry_question(Stream *stream, Question *question)
{
    carry_text(stream, &question->given);
    carry_count(stream, &question->hidden);
    carry_numbers(stream, &question->arguments);
    if (stream->reading)
        question->results = calloc(1, sizeof *question->results);
    if (question->results == NULL)
        abort();
    carry_numbers(stream, &question->results[0]);
    if (stream->reading)
        question->expected = numbers_copy(&question->results[0]);
    carry_differences(stream, &question->expected, &question->results[0]);
    carry_number(stream, &question->tolerance);
    carry_numbers(stream, &question->within);
    carry_count(stream, &question->reasons);
    carry_count(stream, &question->length_is_free);
    carry_number(stream, &question->least);
    carry_number(stream, &question->most);
    carry_count(stream, &question->is_seen_along_axes);
}

// What a wrong one needs as well.
static void carry_mistakes(Stream *stream, Question *question)
{
    Numbers right = question->results[0];
    question->results =
        carry_items(stream, question->results, &question->result_count, sizeof right);
    question->differences =
        calloc((size_t)question->result_count + 1, sizeof *question->differences);
    if (question->differences == NULL)
        abort();
    question->results[0] = right;
    for (int i = 1; i < question->result_count && !stream->bad; i++) {
        question->differences[i] = stream->bytes + stream->next;
        carry_differences(stream, stream->reading ? NULL : &question->results[i], &right);
    }
    question->of_mistake =
        carry_items(stream, question->of_mistake, &question->mistake_count, sizeof(int));
    for (int i = 0; i < question->mistake_count; i++) {
        carry_count(stream, &question->of_mistake[i]);
        stream->bad = stream->bad || question->of_mistake[i] >= question->result_count;
    }
    carry_numbers(stream, &question->corners);
    carry_numbers(stream, &question->facts);
}

static void carry_magic(Stream *stream)
{
    for (size_t i = 0; i < sizeof magic; i++) {
        uint8_t byte = (uint8_t)magic[i];
        carry_byte(stream, &byte);
        stream->bad = stream->bad || byte != (uint8_t)magic[i];
    }
}

static void carry_test(Stream *stream, TableTest *test)
{
    carry_text(stream, &test->function);
    carry_text(stream, &test->name);
    carry_count(stream, &test->extra);
    carry_count(stream, &test->probe);
    test->questions =
        carry_items(stream, test->questions, &test->question_count, sizeof *test->questions);
    for (int i = 0; i < test->question_count && !stream->bad; i++)
        carry_question(stream, &test->questions[i]);
}

static bool carry(Stream *stream, Table *table)
{
    carry_magic(stream);
    table->mistakes =
        carry_items(stream, table->mistakes, &table->mistake_count, sizeof *table->mistakes);
    for (int i = 0; i < table->mistake_count && !stream->bad; i++) {
        Mistake *mistake = &table->mistakes[i];
        carry_text(stream, &mistake->exercise);
        stream->mask = UNREAD;
        carry_text(stream, &mistake->id);
        carry_text(stream, &mistake->formula);
        carry_text(stream, &mistake->why);
        carry_text(stream, &mistake->picture);
        stream->mask = 0;
    }
    table->tests = carry_items(stream, table->tests, &table->test_count, sizeof *table->tests);
    for (int i = 0; i < table->test_count && !stream->bad; i++)
        carry_test(stream, &table->tests[i]);
    return !stream->bad;
}

// The second part of the file, which ends as it begins.
static bool carry_all_mistakes(Stream *stream, Table *table)
{
    for (int i = 0; i < table->test_count; i++)
        for (int k = 0; k < table->tests[i].question_count && !stream->bad; k++)
            carry_mistakes(stream, &table->tests[i].questions[k]);
    carry_magic(stream);
    return !stream->bad;
}

static const char *folder(void)
{
    const char *wanted = getenv("JUDGE_TABLES");
    return wanted != NULL ? wanted : TABLES;
}

static void must_be(bool good, const char *stem)
{
    if (good)
        return;
    fprintf(stderr, "%s/%s.table: cannot be read, or is not a table of this version\n", folder(),
            stem);
    exit(2);
}

// The whole file, which stays in memory. False if it cannot be read.
static bool read_file(const char *stem, Stream *stream)
{
    char path[4096];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s.table", folder(), stem);
    if (stat(path, &about) != 0 || about.st_size < (off_t)sizeof magic)
        return false;
    FILE *file = fopen(path, "rb");
    void *bytes = malloc((size_t)about.st_size);
    if (file == NULL || bytes == NULL)
        return false;
    stream->bytes = bytes;
    stream->size = fread(bytes, 1, (size_t)about.st_size, file);
    fclose(file);
    return stream->size == (size_t)about.st_size &&
           memcmp(stream->bytes + stream->size - sizeof magic, magic, sizeof magic) == 0;
}

void table_load(const char *stem, Table *table)
{
    Stream stream = {.reading = true};
    *table = (Table){0};
    bool good = read_file(stem, &stream) && carry(&stream, table);
    for (int i = 0; good && i < table->test_count; i++)
        good = exercise_number(table->tests[i].function) >= 0;
    must_be(good, stem);
    table->stem = stem;
    table->bytes = stream.bytes + stream.next;
    table->size = stream.size - stream.next;
}

void table_load_mistakes(Table *table)
{
    Stream stream = {.reading = true, .bytes = table->bytes, .size = table->size};
    if (table->bytes != NULL)
        must_be(carry_all_mistakes(&stream, table), table->stem);
    table->bytes = NULL;
}

bool table_write(const char *path, Table *table)
{
    Stream stream = {.file = fopen(path, "wb")};
    bool good = stream.file != NULL && carry(&stream, table) && carry_all_mistakes(&stream, table);
    if (stream.file != NULL)
        good = fclose(stream.file) == 0 && good;
    if (!good)
        perror(path);
    return good;
}
