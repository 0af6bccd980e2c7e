// check_course.c - tests of what the course program is made of.
// Expected: the contracts in the headers; pages are written down by hand, line by line.
#include "tests/course/chapter_record.h"
#include "tests/course/page.h"
#include "tests/judge/test.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// ---- the record of a chapter -------------------------------------------------------------------

static char record_folder[] = "/tmp/record-XXXXXX";
static char record_path[100];

// A record of two functions, as a run writes it.
static void write_record(const char *words)
{
    if (strstr(record_folder, "XXXXXX") != NULL && mkdtemp(record_folder) == NULL)
        abort();
    snprintf(record_path, sizeof record_path, "%s/01-corners.record", record_folder);
    FILE *out = record_begin(record_path);
    entry_put(out, "record", "1");
    entry_put(out, "stem", "01-corners");
    entry_put(out, "state", "judged");
    entry_put(out, "words", words);
    entry_put(out, "function", "upper_left");
    entry_put(out, "state", "right");
    entry_put(out, "function", "upper_right");
    entry_put(out, "state", "crashed");
    entry_put(out, "case", "3");
    expect_law(record_finish(out, record_path), "written", "not written");
}

static void remove_record(void)
{
    unlink(record_path);
    rmdir(record_folder);
    strcpy(record_folder + strlen(record_folder) - 6, "XXXXXX");
}

TEST(chapter_record, what_is_written_comes_back)
{
    const char *words[] = {"a line",       "two\nlines\n", "a\ttab",
                           "a \\ and \\n", "caf\xc3\xa9",  "\x1b[31m\x7f"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        ChapterRecord record;
        write_record(words[i]);
        given("words", "number %d", (int)i);
        expect_law(record_read(record_path, &record), "a record", "none");
        expect_text(record_value(&record, "words"), words[i]);
        expect_int(record.function_count, 2);
        expect_text(record.functions[1].name, "upper_right");
        expect_text(function_value(&record.functions[1], "case"), "3");
        expect_text(function_value(&record.functions[0], "case"), "");
        chapter_record_free(&record);
    }
    remove_record();
}

TEST(chapter_record, a_record_that_is_cut_short_is_none)
{
    write_record("words");
    size_t size;
    free(whole_text(record_path, &size));
    while (size-- > 0) {
        ChapterRecord record;
        given("bytes that are left", "%zu", size);
        expect_int(truncate(record_path, (off_t)size), 0);
        expect_law(!record_read(record_path, &record), "no record", "a record");
        chapter_record_free(&record);
    }
    remove_record();
}

TEST(chapter_record, a_run_that_does_not_finish_leaves_the_record)
{
    ChapterRecord record;
    write_record("older");
    FILE *out = record_begin(record_path);
    entry_put(out, "record", "1");
    entry_put(out, "words", "newer");
    fclose(out); // and here it is killed
    expect_law(record_read(record_path, &record), "the older record", "none");
    expect_text(record_value(&record, "words"), "older");
    chapter_record_free(&record);
    char left[120];
    snprintf(left, sizeof left, "%s.new", record_path);
    unlink(left);
    remove_record();
}

// Of f, g and h: the state, and what it calls.
static void expect_excuses(const char *const *known, const char *expected)
{
    char names[MOST_NAMES];
    ChapterRecord record = {.function_count = 3};
    const char *function_names[] = {"f", "g", "h"};
    Entry entries[6];
    for (int i = 0; i < 6; i++)
        entries[i] = (Entry){i % 2 == 0 ? "state" : "calls", known[i]};
    for (int i = 0; i < 3; i++)
        record.functions[i] = (FunctionRecord){function_names[i], entries + 2 * i, 2};
    names_that_may_excuse(&record, &record.functions[0], names);
    given("calls", "f: %s; g: %s; h: %s", known[1], known[3], known[5]);
    expect_text(names, expected);
}

TEST(chapter_record, only_what_it_calls_and_is_not_right_excuses)
{
    expect_excuses((const char *[]){"wrong", "g h", "wrong", "", "right", ""}, "g");
    expect_excuses((const char *[]){"wrong", "g h", "wrong", "h", "unanswered", ""}, "g h");
    expect_excuses((const char *[]){"wrong", "", "wrong", "", "wrong", ""}, "");
    expect_excuses((const char *[]){"wrong", "g", "wrong", "f", "wrong", ""}, "");
}

// ---- a page: wrapping, colors, a program's output ---------------------------------------------

static char *written;
static size_t written_size;

static Page page_of(int columns, bool colors)
{
    free(written);
    written = NULL;
    return (Page){
        .out = open_memstream(&written, &written_size), .columns = columns, .colors = colors};
}

static void expect_page(Page page, const char *expected)
{
    fclose(page.out);
    expect_text(written, expected);
}

TEST(page, words_wrap_under_each_other)
{
    static const struct {
        const char *what;
        int columns;
        const char *label, *words, *expected;
    } cases[] = {
        {"wraps", 40, "looks like", "one two three four five six seven eight",
         "  looks like one two three four five six\n             seven eight\n"},
        {"a wider terminal", 60, "but", "one two three four five six seven eight",
         "  but        one two three four five six seven eight\n"},
        {"a vector stays in one piece", 40, "camera", "eye (2, 2, -4), right (100, 200, 300)",
         "  camera     eye (2, 2, -4), right\n             (100, 200, 300)\n"},
        {"if it is not too long", 40, "yours", "(1.00000000001, 1.00000000001, 1.00000000001)",
         "  yours      (1.00000000001,\n             1.00000000001,\n             "
         "1.00000000001)\n"},
        {"a tilde is a blank that does not break", 40, "expected",
         "sphere 1 at~t~=~4.25 and~nothing~else",
         "  expected   sphere 1 at t = 4.25\n             and nothing else\n"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        Page page = page_of(cases[i].columns, false);
        given("words", "%s", cases[i].what);
        page_field(&page, PLAIN, cases[i].label, cases[i].words);
        expect_page(page, cases[i].expected);
    }
}

TEST(page, colors_are_in_each_line_by_itself)
{
    given("colors", "yes");
    Page page = page_of(40, true);
    page_field(&page, RED, "yours", "one two three four five six seven eight");
    page_line(&page, BOLD, "done");
    page_line(&page, PLAIN, "plain");
    expect_page(page, "  yours      \033[31mone two three four five six\033[0m\n"
                      "             \033[31mseven eight\033[0m\n"
                      "\033[1mdone\033[0m\n"
                      "plain\n");
}

TEST(page, what_was_printed_is_harmless_and_short)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_printed(&page, "it printed", "\033[31mred\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
    expect_page(page, "  it printed ?[31mred\n"
                      "             1\n             2\n             3\n             4\n"
                      "             5\n             6\n             7\n"
                      "             ... and more\n");
}

// The output is not a terminal.
TEST(page, the_environment_says_how_wide)
{
    FILE *file = tmpfile();
    const struct {
        const char *columns;
        int expected;
    } cases[] = {{NULL, 79}, {"60", 59}, {"120", 119}, {"5", 39},
                 {"", 79},   {"-3", 79}, {"wide", 79}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        given("COLUMNS", "%s", cases[i].columns != NULL ? cases[i].columns : "not set");
        if (cases[i].columns != NULL)
            setenv("COLUMNS", cases[i].columns, 1);
        else
            unsetenv("COLUMNS");
        Page page = page_on(file);
        expect_int(page.columns, cases[i].expected);
        expect_int(page.colors, false);
    }
    fclose(file);
}
