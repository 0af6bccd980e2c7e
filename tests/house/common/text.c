// text.c - tests of common/text.c: numbers, words, messages.
// Expected: the contracts in its header.
#include "common/text.h"

#include "tests/judge/test.h"

#include <string.h>

static void expect_reads(const char *text, double expected, const char *rest)
{
    double number = -12345;
    const char *end = read_number(text, &number);
    given("text", "'%s'", text);
    expect_law(end != NULL, "a number", "refused");
    expect_number(number, expected, 0);
    expect_text(end, rest);
}

TEST(read_number, numbers_are_read_as_they_are_written)
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
    expect_reads("-0.0e9", 0, "");
    expect_reads("1,2", 1, ",2");
    expect_reads("640x480", 640, "x480");
    expect_reads("1.5.5", 1.5, ".5");
    expect_reads("1e", 1, "e");
    expect_reads("3 4", 3, " 4");
}

TEST(read_number, what_is_too_small_for_a_double_is_about_zero)
{
    expect_reads("1e-999", 0, "");
    double number = 1;
    ck_assert_ptr_nonnull(read_number("1e-320", &number));
    ck_assert_double_ge(number, 0);
    ck_assert_double_le(number, 1e-319);
}

TEST(read_number, what_is_no_finite_decimal_number_is_refused)
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

TEST(number_text, numbers_are_shown_to_six_digits_without_idle_zeros)
{
    expect_text(number_text(4).s, "4");
    expect_text(number_text(-0.4).s, "-0.4");
    expect_text(number_text(1.0 / 6).s, "0.166667");
    expect_text(number_text(1e300).s, "1e+300");
    expect_text(number_text_to(1.0 / 3, 3).s, "0.333");
    expect_text(number_text_to(0.1, 17).s, "0.10000000000000001");
}

TEST(number_text, no_minus_stands_before_a_zero)
{
    expect_text(number_text(-0.0).s, "0");
    expect_text(number_text_to(-0.0, 17).s, "0");
    expect_text(vec3_text(vec3_of(-0.0, 0, -0.0)).s, "(0, 0, 0)");
    expect_text(pair_text(-0.0, -0.0).s, "(0, 0)");
}

// 0 / 0 is -nan on some machines and nan on others.
TEST(number_text, what_is_not_finite_is_shown_alike_everywhere)
{
    expect_text(number_text(NAN).s, "nan");
    expect_text(number_text(copysign(NAN, -1)).s, "nan");
    expect_text(number_text(INFINITY).s, "inf");
    expect_text(number_text(-INFINITY).s, "-inf");
}

TEST(number_text, vectors_and_pairs_stand_in_parentheses)
{
    expect_text(vec3_text(vec3_of(2, 2, -4)).s, "(2, 2, -4)");
    expect_text(vec3_text(vec3_of(-0.4, 1.0 / 6, 1e-9)).s, "(-0.4, 0.166667, 1e-09)");
    expect_text(vec3_text_to(vec3_of(1.0 / 3, 0, 2), 2).s, "(0.33, 0, 2)");
    expect_text(pair_text(0.5, 0.25).s, "(0.5, 0.25)");
}

TEST(word_text, control_characters_of_a_word_are_harmless)
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

TEST(word_text, long_words_are_cut)
{
    expect_text(word_text("~ !\"%s'").s, "~ !\"%s'");
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

TEST(message_set, a_message_that_is_too_long_is_cut)
{
    Message message;
    ck_assert(!message_set(&message, "%1000d", 1));
    expect_int((long)strlen(message.text), (long)sizeof message.text - 1);
}

TEST(duration_text, times_have_three_digits_or_two_units)
{
    const struct {
        double seconds;
        const char *text;
    } times[] = {{0, "0 ms"},           {0.0000123, "0.0123 ms"},
                 {0.00234, "2.34 ms"},  {0.999, "999 ms"},
                 {0.9996, "1 s"},       {1.5, "1.5 s"},
                 {37.24, "37.2 s"},     {59.9, "59.9 s"},
                 {59.96, "1 min"},      {119.6, "2 min"},
                 {218.6, "3 min 39 s"}, {3599.4, "59 min 59 s"},
                 {3599.6, "1 h"},       {7199, "2 h"},
                 {7500, "2 h 5 min"},   {360000, "100 h"},
                 {NAN, "nan ms"},       {-2, "-2 s"}};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        given("seconds", "%.17g", times[i].seconds);
        expect_text(duration_text(times[i].seconds).s, times[i].text);
    }
}
