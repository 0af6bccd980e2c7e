// check_page.c - tests of tests/course/page.c: wrapping, colours, a program's output.
// Expected: written down by hand, line by line.
#include "tests/course/page.h"

#include "tests/judge/test.h"

#include <stdlib.h>
#include <string.h>

static char *written;
static size_t written_size;

static Page page_of(int columns, bool colors)
{
    free(written);
    written = NULL;
    return (Page){open_memstream(&written, &written_size), columns, colors};
}

static void expect_page(Page page, const char *expected)
{
    fclose(page.out);
    expect_text(written, expected);
}

START_TEST(words_wrap_under_each_other)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_field(&page, PLAIN, "looks like", "one two three four five six seven eight");
    expect_page(page, "  looks like one two three four five six\n"
                      "             seven eight\n");
}
END_TEST

START_TEST(a_wider_terminal_has_longer_lines)
{
    given("columns", "60");
    Page page = page_of(60, false);
    page_field(&page, PLAIN, "but", "one two three four five six seven eight");
    expect_page(page, "  but        one two three four five six seven eight\n");
}
END_TEST

START_TEST(a_vector_stays_in_one_piece)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_field(&page, PLAIN, "camera", "eye (2, 2, -4), right (100, 200, 300)");
    expect_page(page, "  camera     eye (2, 2, -4), right\n"
                      "             (100, 200, 300)\n");
}
END_TEST

START_TEST(what_is_longer_than_a_line_is_broken_at_its_blanks)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_field(&page, PLAIN, "yours", "(1.00000000001, 1.00000000001, 1.00000000001)");
    expect_page(page, "  yours      (1.00000000001,\n"
                      "             1.00000000001,\n"
                      "             1.00000000001)\n");
}
END_TEST

START_TEST(a_tilde_is_a_blank_that_does_not_break)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_field(&page, PLAIN, "expected", "sphere 1 at~t~=~4.25 and~nothing~else");
    expect_page(page, "  expected   sphere 1 at t = 4.25\n"
                      "             and nothing else\n");
}
END_TEST

START_TEST(colours_are_in_each_line_by_itself)
{
    given("colours", "yes");
    Page page = page_of(40, true);
    page_field(&page, RED, "yours", "one two three four five six seven eight");
    page_line(&page, BOLD, "done");
    page_line(&page, PLAIN, "plain");
    expect_page(page, "  yours      \033[31mone two three four five six\033[0m\n"
                      "             \033[31mseven eight\033[0m\n"
                      "\033[1mdone\033[0m\n"
                      "plain\n");
}
END_TEST

START_TEST(what_was_printed_is_harmless_and_short)
{
    given("columns", "40");
    Page page = page_of(40, false);
    page_printed(&page, "it printed", "\033[31mred\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
    expect_page(page, "  it printed ?[31mred\n"
                      "             1\n             2\n             3\n             4\n"
                      "             5\n             6\n             7\n"
                      "             ... and more\n");
}
END_TEST

// The output is not a terminal.
START_TEST(the_environment_says_how_wide)
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
END_TEST

static void list_tests(void)
{
    tests_of("page");
    test(words_wrap_under_each_other);
    test(a_wider_terminal_has_longer_lines);
    test(a_vector_stays_in_one_piece);
    test(what_is_longer_than_a_line_is_broken_at_its_blanks);
    test(a_tilde_is_a_blank_that_does_not_break);
    test(colours_are_in_each_line_by_itself);
    test(what_was_printed_is_harmless_and_short);
    test(the_environment_says_how_wide);
}

OF_STEM(list_tests)
