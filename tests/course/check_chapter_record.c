// check_chapter_record.c - tests of tests/course/chapter_record.c and entries.c.
// Expected: the format in their headers; what is written comes back.
#include "tests/course/chapter_record.h"

#include "tests/course/whole_text.h"
#include "tests/judge/test.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/record-XXXXXX";
static char path[100];

// A record of two functions, as a run writes it.
static void write_record(const char *words)
{
    if (strstr(folder, "XXXXXX") != NULL && mkdtemp(folder) == NULL)
        abort();
    snprintf(path, sizeof path, "%s/01-corners.record", folder);
    FILE *out = record_begin(folder, "01-corners");
    entry_put(out, "record", "1");
    entry_put(out, "stem", "01-corners");
    entry_put(out, "state", "judged");
    entry_put(out, "words", words);
    entry_put(out, "function", "upper_left");
    entry_put(out, "state", "right");
    entry_put(out, "function", "upper_right");
    entry_put(out, "state", "crashed");
    entry_put(out, "case", "3");
    expect_law(record_finish(out, folder, "01-corners"), "written", "not written");
}

static void remove_record(void)
{
    unlink(path);
    rmdir(folder);
    strcpy(folder + strlen(folder) - 6, "XXXXXX");
}

// The file with one change: a byte of it, or its length.
static void damage(long at, int byte, size_t left_out)
{
    size_t size;
    char *text = whole_text(path, &size);
    if (byte != 0)
        text[at] = (char)byte;
    FILE *file = fopen(path, "wb");
    fwrite(text, 1, size - left_out, file);
    fclose(file);
    free(text);
}

static void expect_no_record(const char *why)
{
    ChapterRecord record;
    given("record", "%s", why);
    expect_law(!record_read(path, &record), "no record", "a record");
    chapter_record_free(&record);
}

START_TEST(what_is_written_comes_back)
{
    const char *words[] = {"a line",       "two\nlines\n", "a\ttab",
                           "a \\ and \\n", "caf\xc3\xa9",  "\x1b[31m\x7f"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        ChapterRecord record;
        write_record(words[i]);
        given("words", "number %d", (int)i);
        expect_law(record_read(path, &record), "a record", "none");
        expect_text(record_value(&record, "words"), words[i]);
        expect_int(record.function_count, 2);
        expect_text(record.functions[1].name, "upper_right");
        expect_text(function_value(&record.functions[1], "case"), "3");
        expect_text(function_value(&record.functions[0], "case"), "");
        chapter_record_free(&record);
    }
    remove_record();
}
END_TEST

START_TEST(a_record_that_is_cut_short_is_none)
{
    write_record("words");
    size_t size;
    free(whole_text(path, &size));
    for (size_t left_out = 1; left_out <= size; left_out++) {
        write_record("words");
        damage(0, 0, left_out);
        expect_no_record("cut short");
    }
    remove_record();
}
END_TEST

START_TEST(a_record_that_was_changed_is_none)
{
    write_record("words");
    size_t size;
    free(whole_text(path, &size));
    for (size_t at = 0; at < size; at++) {
        write_record("words");
        damage((long)at, '#', 0);
        expect_no_record("changed");
    }
    remove_record();
}
END_TEST

START_TEST(no_file_is_no_record)
{
    snprintf(path, sizeof path, "/nowhere/01-corners.record");
    expect_no_record("not there");
}
END_TEST

START_TEST(a_run_that_does_not_finish_leaves_the_record)
{
    ChapterRecord record;
    write_record("older");
    FILE *out = record_begin(folder, "01-corners");
    entry_put(out, "record", "1");
    entry_put(out, "words", "newer");
    fclose(out); // and here it is killed
    expect_law(record_read(path, &record), "the older record", "none");
    expect_text(record_value(&record, "words"), "older");
    chapter_record_free(&record);
    char left[120];
    snprintf(left, sizeof left, "%s.new", path);
    unlink(left);
    remove_record();
}
END_TEST

static const char *state_with(const char *key, const char *value)
{
    static FunctionRecord function;
    static Entry entries[2];
    entries[0] = (Entry){"state", strcmp(key, "state") == 0 ? value : "wrong"};
    entries[1] = (Entry){key, value};
    function = (FunctionRecord){"f", entries, 2};
    given("function", "%s: %s", key, value);
    return function_state(&function);
}

START_TEST(a_function_has_one_state)
{
    expect_text(state_with("state", "right"), "right");
    expect_text(state_with("state", "unanswered"), "unanswered");
    expect_text(state_with("state", "crashed"), "wrong");
    expect_text(state_with("state", "timed out"), "wrong");
    expect_text(state_with("waits", "g"), "waiting");
    expect_text(state_with("unsure", "g h"), "unsure");
}
END_TEST

static void list_tests(void)
{
    tests_of("chapter_record");
    test(what_is_written_comes_back);
    test(a_record_that_is_cut_short_is_none);
    test(a_record_that_was_changed_is_none);
    test(no_file_is_no_record);
    test(a_run_that_does_not_finish_leaves_the_record);
    test(a_function_has_one_state);
}

OF_STEM(list_tests)
