// option_readers.c - tests of common/options.c: what each kind of option takes, and what not.
// Expected: the contract in common/options.h.
#include "common/options.h"

#include "common/image.h"
#include "tests/judge/test.h"

#include <string.h>

static void expect_size(const char *text, int width, int height)
{
    Resolution size = {0, 0};
    given("text", "'%s'", text);
    expect_law(option_size(text, &size), "a size", "refused");
    given("text", "'%s'", text);
    expect_pair(size.width, size.height, width, height, 0);
}

START_TEST(a_size_is_two_whole_numbers_with_x_between)
{
    expect_size("640x480", 640, 480);
    expect_size("1x1", 1, 1);
    expect_size("16384x16384", 16384, 16384);
    expect_size("064x048", 64, 48);
}
END_TEST

// Values that must not be touched where the text is refused.
static void expect_all_refused(OptionReader *read, const char *const *texts, void *into,
                               size_t size)
{
    char before[64];
    ck_assert_uint_le(size, sizeof before);
    memcpy(before, into, size);
    for (; *texts != NULL; texts++) {
        given("text", "'%s'", *texts);
        expect_law(!read(*texts, into), "refused", "taken");
        ck_assert_mem_eq(into, before, size);
    }
}

START_TEST(what_is_no_size_is_refused)
{
    static const char *const bad[] = {"",
                                      "x",
                                      "10",
                                      "10x",
                                      "x10",
                                      "axb",
                                      "0x0",
                                      "0x5",
                                      "5x0",
                                      "-1x5",
                                      "5x-1",
                                      "+5x5",
                                      "5x+5",
                                      "5 x5",
                                      "5x 5",
                                      " 5x5",
                                      "5x5 ",
                                      "5x5x5",
                                      "5X5",
                                      "5,5",
                                      "5.0x5",
                                      "1e2x5",
                                      "16385x1",
                                      "1x16385",
                                      "1000000000x1000000000",
                                      "4294967297x1",
                                      "18446744073709551617x1",
                                      "99999999999999999999x1",
                                      "nanxinf",
                                      NULL};
    Resolution size = {3, 4};
    expect_all_refused(option_size, bad, &size, sizeof size);
}
END_TEST

START_TEST(a_pixel_is_column_and_row_from_0)
{
    Pixel pixel = {-1, -1};
    expect_law(option_pixel("300,400", &pixel), "a pixel", "refused");
    expect_pair(pixel.column, pixel.row, 300, 400, 0);
    expect_law(option_pixel("0,16383", &pixel), "a pixel", "refused");
    expect_pair(pixel.column, pixel.row, 0, 16383, 0);
    static const char *const bad[] = {"",        "1",     "1,",    ",1",   "-1,0",  "0,-1",
                                      "1.5,2",   "1,2,3", "1x2",   "a,b",  "1, 2",  " 1,2",
                                      "16384,0", "0,1e3", "1,2 ",  "+1,2", "nan,1", "1 ,2",
                                      "0,16384", "1;2",   "(1,2)", NULL};
    expect_all_refused(option_pixel, bad, &pixel, sizeof pixel);
}
END_TEST

START_TEST(a_number_is_finite_and_decimal)
{
    double number = 0;
    expect_law(option_number("-2.5e1", &number), "a number", "refused");
    expect_number(number, -25, 0);
    expect_law(option_number(".5", &number), "a number", "refused");
    expect_number(number, 0.5, 0);
    static const char *const bad[] = {"",    "nan", "inf",   "-inf", "1e999", "0x10", " 1", "1 ",
                                      "1,2", "1,",  "1.2.3", "one",  "+",     "-.",   NULL};
    for (int i = 0; bad[i] != NULL; i++) {
        given("text", "'%s'", bad[i]);
        expect_law(!option_number(bad[i], &number), "refused", "taken");
    }
}
END_TEST

START_TEST(a_vector_is_three_numbers_with_commas_between)
{
    vec3 v = vec3_of(7, 8, 9);
    static const char *const bad[] = {"",          "1",       "1,2",     "1,2,",      "1,2,3,",
                                      "1,2,3,4",   "1,,3",    ",1,2",    "1 2 3",     "1, 2,3",
                                      "(1,2,3)",   "nan,0,0", "0,inf,0", "0,0,1e999", "a,b,c",
                                      "0x1,0x2,3", "1;2;3",   "1,2,3 ",  NULL};
    expect_all_refused(option_vec3, bad, &v, 24);
    expect_law(option_vec3("1,-2.5,1e3", &v), "a vector", "refused");
    expect_vec3(v, vec3_of(1, -2.5, 1000), 0);
}
END_TEST

START_TEST(a_pair_is_two_numbers_with_a_comma_between)
{
    double pair[2] = {7, 8};
    expect_law(option_pair("0.5,-2", pair), "a pair", "refused");
    expect_pair(pair[0], pair[1], 0.5, -2, 0);
    static const char *const bad[] = {"", "1", "1,", ",1", "1,2,3", "nan,1", "1,inf", "1x2", NULL};
    for (int i = 0; bad[i] != NULL; i++) {
        given("text", "'%s'", bad[i]);
        expect_law(!option_pair(bad[i], pair), "refused", "taken");
    }
}
END_TEST

START_TEST(a_string_is_anything_but_nothing)
{
    const char *string = NULL;
    expect_law(option_string("my picture.png", &string), "a string", "refused");
    expect_text(string, "my picture.png");
    expect_law(!option_string("", &string), "refused", "taken");
}
END_TEST

START_TEST(a_flag_is_set)
{
    bool flag = false;
    expect_law(option_flag(NULL, &flag), "taken", "refused");
    ck_assert(flag);
}
END_TEST

static void list_tests(void)
{
    tests_of("option_size");
    test(a_size_is_two_whole_numbers_with_x_between);
    test(what_is_no_size_is_refused);
    tests_of("option_pixel");
    test(a_pixel_is_column_and_row_from_0);
    tests_of("option_number");
    test(a_number_is_finite_and_decimal);
    tests_of("option_vec3");
    test(a_vector_is_three_numbers_with_commas_between);
    tests_of("option_pair");
    test(a_pair_is_two_numbers_with_a_comma_between);
    tests_of("option_string");
    test(a_string_is_anything_but_nothing);
    tests_of("option_flag");
    test(a_flag_is_set);
}

OF_STEM(list_tests)
