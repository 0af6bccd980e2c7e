// text.c - tests of common/text.c and common/answers.c: numbers, words, messages, blanks.
// Expected: the contracts in their headers. A blank fails the test that calls one, so what
// concerns blanks runs in a child, whose exit status says which of its lines was not true.
#include "common/text.h"

#include "common/answers.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static void expect_reads(const char *text, double expected, const char *rest)
{
    double number = -12345;
    const char *end = read_number(text, &number);
    given("text", "'%s'", text);
    expect_law(end != NULL, "a number", "refused");
    expect_number(number, expected, 0);
    expect_text(end, rest);
}

START_TEST(numbers_are_read_as_they_are_written)
{
    expect_reads("0", 0, "");
    expect_reads("4", 4, "");
    expect_reads("-0.4", -0.4, "");
    expect_reads("+2.5", 2.5, "");
    expect_reads(".5", 0.5, "");
    expect_reads("-.5", -0.5, "");
    expect_reads("5.", 5, "");
    expect_reads("007", 7, "");
    expect_reads("1e3", 1000, "");
    expect_reads("1E-3", 0.001, "");
    expect_reads("1.7976931348623157e308", 1.7976931348623157e308, "");
    expect_reads("0.1000000000000000055511151231257827021181583404541015625", 0.1, "");
}
END_TEST

START_TEST(minus_zero_is_a_zero)
{
    expect_reads("-0", 0, "");
    expect_reads("-0.0e9", 0, "");
}
END_TEST

START_TEST(what_is_too_small_for_a_double_is_about_zero)
{
    expect_reads("1e-999", 0, "");
    double number = 1;
    ck_assert_ptr_nonnull(read_number("1e-320", &number));
    ck_assert_double_ge(number, 0);
    ck_assert_double_le(number, 1e-319);
}
END_TEST

START_TEST(what_follows_a_number_is_handed_back)
{
    expect_reads("1,2", 1, ",2");
    expect_reads("640x480", 640, "x480");
    expect_reads("1.5.5", 1.5, ".5");
    expect_reads("1e", 1, "e");
    expect_reads("3 4", 3, " 4");
}
END_TEST

START_TEST(what_is_no_finite_decimal_number_is_refused)
{
    static const char *const bad[] = {
        "",         "+",         "-",        ".",    "-.",   "+.",  "--1",  "+-1",
        "e5",       "abc",       "inf",      "-inf", "INF",  "nan", "-nan", "NaN(1)",
        "infinity", "0x10",      "-0X1",     "0x",   " 1",   "\t1", "\n1",  "1e999",
        "-1e999",   "1e9999999", "\xD9\xA3", ",1",   "x480", "$1",  "'1'",  "1e309"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        double number = 7;
        const char *end = read_number(bad[i], &number);
        given("text", "'%s'", bad[i]);
        expect_law(end == NULL, "refused", "%g, then '%s'", number, end != NULL ? end : "");
        expect_number(number, 7, 0);
    }
}
END_TEST

START_TEST(numbers_are_shown_to_six_digits_without_idle_zeros)
{
    expect_text(number_text(4).s, "4");
    expect_text(number_text(-0.4).s, "-0.4");
    expect_text(number_text(1.0 / 6).s, "0.166667");
    expect_text(number_text(1e300).s, "1e+300");
    expect_text(number_text_to(1.0 / 3, 3).s, "0.333");
    expect_text(number_text_to(0.1, 17).s, "0.10000000000000001");
}
END_TEST

START_TEST(no_minus_stands_before_a_zero)
{
    expect_text(number_text(-0.0).s, "0");
    expect_text(number_text_to(-0.0, 17).s, "0");
    expect_text(vec3_text(vec3_of(-0.0, 0, -0.0)).s, "(0, 0, 0)");
    expect_text(pair_text(-0.0, -0.0).s, "(0, 0)");
}
END_TEST

// 0 / 0 is -nan on some machines and nan on others.
START_TEST(what_is_not_finite_is_shown_alike_everywhere)
{
    expect_text(number_text(NAN).s, "nan");
    expect_text(number_text(copysign(NAN, -1)).s, "nan");
    expect_text(number_text(INFINITY).s, "inf");
    expect_text(number_text(-INFINITY).s, "-inf");
}
END_TEST

START_TEST(vectors_and_pairs_stand_in_parentheses)
{
    expect_text(vec3_text(vec3_of(2, 2, -4)).s, "(2, 2, -4)");
    expect_text(vec3_text(vec3_of(-0.4, 1.0 / 6, 1e-9)).s, "(-0.4, 0.166667, 1e-09)");
    expect_text(vec3_text_to(vec3_of(1.0 / 3, 0, 2), 2).s, "(0.33, 0, 2)");
    expect_text(pair_text(0.5, 0.25).s, "(0.5, 0.25)");
}
END_TEST

START_TEST(the_longest_vector_fits)
{
    double x = -1.2345678901234568e-300;
    expect_text(vec3_text_to(vec3_of(x, x, x), 17).s,
                "(-1.2345678901234568e-300, -1.2345678901234568e-300, -1.2345678901234568e-300)");
}
END_TEST

START_TEST(plain_words_stay_as_they_are)
{
    expect_text(word_text("").s, "");
    expect_text(word_text("sphere").s, "sphere");
    expect_text(word_text("~ !\"%s'").s, "~ !\"%s'");
}
END_TEST

START_TEST(control_characters_of_a_word_are_harmless)
{
    expect_text(word_text("\x1b[31mred\a\r\n").s, "?[31mred???");
    expect_text(word_text("caf\xc3\xa9\x7f\x9b").s, "caf????");
    for (int c = 1; c < 256; c++) {
        Text text = word_text((char[]){(char)c, '\0'});
        given("byte", "%d", c);
        expect_law(text.s[0] >= ' ' && text.s[0] <= '~' && text.s[1] == '\0', "one plain character",
                   "byte %d", (unsigned char)text.s[0]);
    }
}
END_TEST

START_TEST(long_words_are_cut)
{
    const char forty[] = "0123456789012345678901234567890123456789";
    expect_text(word_text(forty).s, forty);
    char word[100001];
    memset(word, 'a', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    const char cut[] = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...";
    expect_text(word_text(word).s, cut);
    word[41] = '\0';
    expect_text(word_text(word).s, cut);
}
END_TEST

START_TEST(a_message_is_set_and_false)
{
    Message message;
    ck_assert(!message_set(&message, "%s:%d: %s", "a.nff", 12, "wrong"));
    expect_text(message.text, "a.nff:12: wrong");
}
END_TEST

START_TEST(a_message_that_is_too_long_is_cut)
{
    Message message;
    ck_assert(!message_set(&message, "%1000d", 1));
    expect_int((long)strlen(message.text), (long)sizeof message.text - 1);
}
END_TEST

// Runs lines in a child; each returns the number of its first claim that is not true, or 0.
static void expect_all_true(int (*claims)(void))
{
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        _exit(claims());
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    given("in a child", "which of its claims is not true");
    expect_int(WEXITSTATUS(status), 0);
}

#define CLAIM(number, holds)                                                                       \
    do {                                                                                           \
        if (!(holds))                                                                              \
            return number;                                                                         \
    } while (0)

static double blank_number(void)
{
    return NOT_ANSWERED(double);
}

static int blank_int(void)
{
    return NOT_ANSWERED(int);
}

static Camera blank_camera(void)
{
    return NOT_ANSWERED(Camera);
}

static void blank_void(void)
{
    NOT_ANSWERED_YET();
}

static int a_blank_returns_the_impossible(void)
{
    CLAIM(1, isnan(blank_number()));
    CLAIM(2, blank_int() == -1);
    Camera c = blank_camera();
    CLAIM(3, isnan(c.origin[0]) && isnan(c.right[1]) && isnan(c.forward[2]));
    CLAIM(4, isnan(c.distance) && isnan(c.width) && isnan(c.height));
    CLAIM(5, camera_check(c) == CAMERA_NOT_FINITE);
    return 0;
}

static int blanks_are_remembered_once_each_in_order(void)
{
    CLAIM(1, answers_missing() == 0);
    blank_void();
    CLAIM(2, answers_missing() == 1);
    blank_int();
    blank_int();
    blank_void();
    CLAIM(3, answers_missing() == 2);
    CLAIM(4, strcmp(answer_missing(0), "blank_void") == 0);
    CLAIM(5, strcmp(answer_missing(1), "blank_int") == 0);
    return 0;
}

static int more_blanks_than_anybody_has_do_no_harm(void)
{
    static char names[1000][8];
    for (int i = 0; i < 1000; i++) {
        snprintf(names[i], sizeof names[i], "f%d", i);
        CLAIM(1, not_answered(names[i], "file.c", NULL, 0) == NULL);
    }
    CLAIM(2, answers_missing() > 0 && answers_missing() <= 1000);
    CLAIM(3, strcmp(answer_missing(answers_missing() - 1), "") != 0);
    return 0;
}

static int a_blanks_number_is_shown_as_not_answered(void)
{
    CLAIM(1, strcmp(number_text(NAN).s, "nan") == 0);
    double blank = blank_number();
    vec3 blanks = vec3_of(blank, blank, blank);
    CLAIM(2, strcmp(number_text(blank).s, "not answered yet") == 0);
    CLAIM(3, strcmp(vec3_text(blanks).s, "not answered yet") == 0);
    CLAIM(4, strcmp(pair_text(blank, blank).s, "not answered yet") == 0);
    CLAIM(5, strcmp(number_text(2).s, "2") == 0);
    return 0;
}

// answers_report writes to stderr; a pipe holds what it wrote.
static int the_report_names_file_and_function(void)
{
    int ends[2];
    CLAIM(1, pipe(ends) == 0 && dup2(ends[1], STDERR_FILENO) >= 0);
    CLAIM(2, answers_report() == 0);
    not_answered("upper_left", "exercises/01-corners.c", NULL, 0);
    not_answered("upper_right", "exercises/01-corners.c", NULL, 0);
    CLAIM(3, answers_report() == 1);
    char words[400] = "";
    CLAIM(4, read(ends[0], words, sizeof words - 1) > 0);
    CLAIM(5, strstr(words, "exercises/01-corners.c: not answered yet: upper_left\n") == words);
    CLAIM(6, strstr(words, "\nexercises/01-corners.c: not answered yet: upper_right\n") != NULL);
    return 0;
}

START_TEST(a_blank_returns_nan_and_minus_1)
{
    expect_all_true(a_blank_returns_the_impossible);
}
END_TEST

START_TEST(each_blank_is_remembered_once_in_order_of_its_first_call)
{
    expect_all_true(blanks_are_remembered_once_each_in_order);
}
END_TEST

START_TEST(a_thousand_blanks_do_no_harm)
{
    expect_all_true(more_blanks_than_anybody_has_do_no_harm);
}
END_TEST

START_TEST(what_a_blank_returns_is_shown_as_not_answered_yet)
{
    expect_all_true(a_blanks_number_is_shown_as_not_answered);
}
END_TEST

START_TEST(the_report_names_each_blank_and_its_file)
{
    expect_all_true(the_report_names_file_and_function);
}
END_TEST

void list_tests(void)
{
    tests_of("read_number");
    test(numbers_are_read_as_they_are_written);
    test(minus_zero_is_a_zero);
    test(what_is_too_small_for_a_double_is_about_zero);
    test(what_follows_a_number_is_handed_back);
    test(what_is_no_finite_decimal_number_is_refused);
    tests_of("number_text");
    test(numbers_are_shown_to_six_digits_without_idle_zeros);
    test(no_minus_stands_before_a_zero);
    test(what_is_not_finite_is_shown_alike_everywhere);
    test(vectors_and_pairs_stand_in_parentheses);
    test(the_longest_vector_fits);
    tests_of("word_text");
    test(plain_words_stay_as_they_are);
    test(control_characters_of_a_word_are_harmless);
    test(long_words_are_cut);
    tests_of("message_set");
    test(a_message_is_set_and_false);
    test(a_message_that_is_too_long_is_cut);
    tests_of("not_answered");
    test(a_blank_returns_nan_and_minus_1);
    test(each_blank_is_remembered_once_in_order_of_its_first_call);
    test(a_thousand_blanks_do_no_harm);
    test(what_a_blank_returns_is_shown_as_not_answered_yet);
    test(the_report_names_each_blank_and_its_file);
}
