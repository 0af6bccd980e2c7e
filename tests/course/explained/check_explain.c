// check_explain.c - tests of what a student reads of a compiler's and a linker's words.
//
// Expected: explained/*.txt. Each case there is an answer, what compilers said of it, and what a
// student reads. They were recorded from an earlier explainer; a case that
// changes is a change for students.
#include "tests/course/explain.h"

#include "tests/judge/test.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- a folder of its own, in which the headers are ----------------------------------------------

static char top[4000];
static char folder[100];

static void link_to(const char *name)
{
    char path[5000];
    snprintf(path, sizeof path, "%s/%s", top, name);
    ck_assert_int_eq(symlink(path, name), 0);
}

static void enter_folder(void)
{
    ck_assert_ptr_nonnull(getcwd(top, sizeof top));
    strcpy(folder, "/tmp/explain-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    link_to("exercises");
    link_to("common");
}

static void leave_folder(void)
{
    unlink("exercises");
    unlink("common");
    ck_assert_int_eq(chdir(top), 0);
    ck_assert_int_eq(rmdir(folder), 0);
}

static void write_answer(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    ck_assert_int_eq(fclose(file), 0);
}

// ---- the output ---------------------------------------------------------------------------------

typedef void Explainer(FILE *out, const char *source, const char *words);

// To free.
static char *said_by(Explainer *explainer, const char *source, const char *words)
{
    char *said = NULL;
    size_t size;
    FILE *out = open_memstream(&said, &size);
    ck_assert_ptr_nonnull(out);
    explainer(out, source, words);
    ck_assert_int_eq(fclose(out), 0);
    return said;
}

static void expect_said(Explainer *explainer, const char *answer, const char *words,
                        const char *expected)
{
    enter_folder();
    write_answer("01-corners.c", answer);
    char *said = said_by(explainer, "01-corners.c", words);
    unlink("01-corners.c");
    leave_folder();
    expect_text(said, expected);
    free(said);
}

// ---- the cases ----------------------------------------------------------------------------------

static char *file_text(const char *path)
{
    char *text = NULL;
    size_t size;
    FILE *file = fopen(path, "rb"), *copy = open_memstream(&text, &size);
    ck_assert_ptr_nonnull(file);
    ck_assert_ptr_nonnull(copy);
    for (int c; (c = getc(file)) != EOF;)
        putc(c, copy);
    fclose(file);
    ck_assert_int_eq(fclose(copy), 0);
    return text;
}

// Cuts a part off the text: name is what follows the mark in its first line, and what is below ends
// where the rest begins. False if the text does not begin with the mark.
static bool cut(char **rest, const char *mark, char **name, char **below)
{
    if (strncmp(*rest, mark, strlen(mark)) != 0)
        return false;
    *name = *rest + strlen(mark);
    char *end = strchr(*name, '\n');
    ck_assert_ptr_nonnull(end);
    *end = '\0';
    *below = end + 1;
    char *next = end + 1;
    while (*next != '\0' && strncmp(next, "== ", 3) != 0 && strncmp(next, "-- ", 3) != 0) {
        next += strcspn(next, "\n");
        next += *next == '\n';
    }
    *rest = next;
    return true;
}

static char *part_to(const char *begin, const char *end)
{
    char *part = strndup(begin, (size_t)(end - begin));
    ck_assert_ptr_nonnull(part);
    return part;
}

static void try_case(const char *title, const char *compiler, const char *source, const char *words,
                     const char *expected)
{
    char *said = said_by(explain, source, words);
    given("case", "%s, %s", title, compiler);
    expect_text(said, expected);
    free(said);
}

static void try_cases(const char *name)
{
    char path[200];
    snprintf(path, sizeof path, "tests/course/explained/%s.txt", name);
    char *text = file_text(path), *rest = text, *title, *source, *compiler, *mark, *begin;
    int count = 0;
    enter_folder();
    while (cut(&rest, "== ", &title, &begin)) {
        ck_assert(cut(&rest, "-- ", &source, &begin));
        char *answer = part_to(begin, rest);
        write_answer(source, answer);
        while (cut(&rest, "-- ", &compiler, &begin)) {
            char *words = part_to(begin, rest);
            ck_assert(cut(&rest, "-- said", &mark, &begin));
            char *expected = part_to(begin, rest);
            try_case(title, compiler, source, words, expected);
            count++;
            free(words);
            free(expected);
        }
        unlink(source);
        free(answer);
    }
    leave_folder();
    given("what is not a case", "'%.40s'", rest);
    expect_law(*rest == '\0' && count >= 10, "some cases, and nothing else", "%d", count);
    free(text);
}

START_TEST(semicolons_and_braces)
{
    try_cases("semicolons");
}
END_TEST

START_TEST(returns)
{
    try_cases("returns");
}
END_TEST

START_TEST(letters_of_the_slides)
{
    try_cases("letters");
}
END_TEST

START_TEST(names)
{
    try_cases("names");
}
END_TEST

START_TEST(types)
{
    try_cases("types");
}
END_TEST

START_TEST(signatures)
{
    try_cases("signatures");
}
END_TEST

START_TEST(numbers)
{
    try_cases("numbers");
}
END_TEST

START_TEST(bytes)
{
    try_cases("bytes");
}
END_TEST

// ---- what is false is not said ------------------------------------------------------------------

#define UPPER_LEFT "#include \"exercises/01-corners.h\"\n\nvec3 upper_left(Camera c)\n"

START_TEST(a_parameter_that_the_compiler_has_lost_is_not_called_unknown)
{
    expect_said(explain, UPPER_LEFT ";\n{\n    return c.up;\n}\n",
                "01-corners.c:6:12: error: 'c' undeclared (first use in this function)\n",
                "01-corners.c:6:12: error: 'c' undeclared (first use in this function)\n"
                "    6 |     return c.up;\n"
                "      |            ^\n");
}
END_TEST

START_TEST(a_keyword_is_not_its_own_misspelling)
{
    expect_said(explain, UPPER_LEFT "{\n    if () return c.up;\n}\n",
                "01-corners.c:5:9: error: expected expression before ')' token\n"
                "    5 |     if () return c.up;\n"
                "      |         ^\n",
                "01-corners.c:5:9: error: expected expression before ')' token\n"
                "    5 |     if () return c.up;\n"
                "      |         ^\n");
}
END_TEST

START_TEST(what_is_declared_in_a_function_is_not_given_to_it)
{
    expect_said(explain, "static double f(void)\n{\n    double x = 1;\n    return y;\n}\n",
                "01-corners.c:4:12: error: 'y' undeclared (first use in this function)\n",
                "01-corners.c:4:12: error: 'y' undeclared (first use in this function)\n"
                "    4 |     return y;\n"
                "      |            ^\n"
                "  help: nothing here is called y. Declare a variable of your own first, with\n"
                "        its type.\n");
}
END_TEST

START_TEST(no_words_are_explained_by_none)
{
    expect_said(explain, UPPER_LEFT, "", "");
}
END_TEST

START_TEST(a_compiler_that_crashes_is_quoted)
{
    expect_said(explain, UPPER_LEFT,
                "cc1: internal compiler error: Segmentation fault\nPlease submit\n",
                "cc1: internal compiler error: Segmentation fault\n");
}
END_TEST

START_TEST(a_line_that_is_not_there_is_not_looked_for)
{
    expect_said(explain, UPPER_LEFT, "01-corners.c:4000000000:7: error: expected ';' before 'x'\n",
                "01-corners.c:4000000000:7: error: expected ';' before 'x'\n"
                "4000000000 |\n"
                "      |       ^\n"
                "  help: a semicolon is missing at the end of line 3.\n");
}
END_TEST

// A program may have written it, to keep this one busy.
START_TEST(a_statement_without_end_is_not_read_to_its_end)
{
    char *answer = NULL;
    size_t size;
    FILE *out = open_memstream(&answer, &size);
    ck_assert_ptr_nonnull(out);
    fputs(UPPER_LEFT "{\n    c\n", out);
    for (int i = 0; i < 1000; i++)
        fputs("    +\n", out);
    fputs("    0,5;\n}\n", out);
    ck_assert_int_eq(fclose(out), 0);
    expect_said(explain, answer, "01-corners.c:5:5: warning: value computed is not used\n",
                "01-corners.c:5:5: warning: value computed is not used\n"
                "    5 |     c\n"
                "      |     ^\n");
    free(answer);
}
END_TEST

// ---- the linker ---------------------------------------------------------------------------------

START_TEST(a_main_of_ones_own_is_to_be_left_out)
{
    expect_said(explain_linker, UPPER_LEFT,
                "/usr/bin/ld: answer.o: in function `main':\n"
                "a.c:(.text+0x0): multiple definition of `main'; answering.o: first defined here\n"
                "collect2: error: ld returned 1 exit status\n",
                "  remove main: the tests have their own\n");
}
END_TEST

START_TEST(names_are_sorted_and_said_once)
{
    expect_said(explain_linker, "inline double half(double x)\n{\n    return x / 2;\n}\n",
                "a.c:(.text+0x1): undefined reference to `upper_left'\n"
                "a.c:(.text+0x1): undefined reference to `half'\n"
                "a.c:(.text+0x9): undefined reference to `upper_left'\n"
                "b.o: multiple definition of 'helper'; c.o: first defined here\n",
                "  half is inline: write static inline\n"
                "  helper is already the name of something else: make yours static\n"
                "  upper_left is not in this file (or is static)\n");
}
END_TEST

START_TEST(other_words_of_the_linker_are_quoted)
{
    expect_said(explain_linker, UPPER_LEFT, "ld: a.o: undefined reference to `no name'\n",
                "ld: a.o: undefined reference to `no name'\n");
}
END_TEST

// ---- slips --------------------------------------------------------------------------------------

static void expect_slips(const char *answer, const char *words, const char *help, bool is_comma)
{
    static const char *const judged[] = {"upper_left", "upper_right"};
    enter_folder();
    write_answer("01-corners.c", answer);
    ExplainedSlips slips = explain_slips("01-corners.c", words, "upper_left", judged, 2);
    unlink("01-corners.c");
    leave_folder();
    expect_text(slips.help != NULL ? slips.help : "", help);
    expect_int(slips.is_comma, is_comma);
    free(slips.help);
}

START_TEST(a_division_of_whole_numbers_is_seen)
{
    expect_slips(UPPER_LEFT "{\n    return (0.3 - 1/2) * c.up;\n}\n", "",
                 "in line 5, 1/2 is 0: C divides whole numbers without a remainder. Write 1.0/2.\n",
                 false);
}
END_TEST

START_TEST(in_a_helper_and_a_macro_too)
{
    expect_slips("#define HALF (1/2)\nstatic double third(void)\n{\n    return 4/3;\n}\n" UPPER_LEFT
                 "{\n    return HALF * third() * c.up;\n}\n",
                 "",
                 "in line 4, 4/3 is 1: C divides whole numbers without a remainder. Write 4.0/3.\n"
                 "in line 1, 1/2 is 0: C divides whole numbers without a remainder. Write 1.0/2.\n",
                 false);
}
END_TEST

START_TEST(a_division_that_is_right_is_not_accused)
{
    expect_slips(UPPER_LEFT
                 "{\n    return (c.width * 1/2 + 1/2.0 + (double)1/2 + 4/2) * c.up; // 1/2\n}\n",
                 "", "", false);
    expect_slips(
        UPPER_LEFT
        "{\n    return c.up;\n}\n\nvec3 upper_right(Camera c)\n{\n    return 1/2 * c.up;\n}\n",
        "", "", false);
}
END_TEST

START_TEST(a_decimal_comma_is_not_another_mistake)
{
    expect_slips(
        UPPER_LEFT "{\n    return (0,5) * c.up;\n}\n",
        "01-corners.c:5:14: warning: left-hand operand of comma expression has no effect\n", "",
        true);
}
END_TEST

static void list_tests(void)
{
    tests_of("explain");
    test(semicolons_and_braces);
    test(returns);
    test(letters_of_the_slides);
    test(names);
    test(types);
    test(signatures);
    test(numbers);
    test(bytes);
    test(a_parameter_that_the_compiler_has_lost_is_not_called_unknown);
    test(a_keyword_is_not_its_own_misspelling);
    test(what_is_declared_in_a_function_is_not_given_to_it);
    test(no_words_are_explained_by_none);
    test(a_compiler_that_crashes_is_quoted);
    test(a_line_that_is_not_there_is_not_looked_for);
    test(a_statement_without_end_is_not_read_to_its_end);
    tests_of("explain_linker");
    test(a_main_of_ones_own_is_to_be_left_out);
    test(names_are_sorted_and_said_once);
    test(other_words_of_the_linker_are_quoted);
    tests_of("explain_slips");
    test(a_division_of_whole_numbers_is_seen);
    test(in_a_helper_and_a_macro_too);
    test(a_division_that_is_right_is_not_accused);
    test(a_decimal_comma_is_not_another_mistake);
}

OF_STEM(list_tests)
