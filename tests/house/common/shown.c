// shown.c - tests of common/shown.c: numbers as people write them.
// Expected: what a person writes.
#include "common/shown.h"

#include "tests/judge/test.h"

#include <math.h>

static void expect_shown(double x, const char *expected)
{
    given("number", "%.17g", x);
    expect_text(number_shown(x).s, expected);
}

TEST(number_shown, short_numbers_have_all_their_digits)
{
    expect_shown(4, "4");
    expect_shown(-0.4, "\u22120.4");
    expect_shown(0.1 * 3, "0.3");
    expect_shown(0.46875, "0.46875");
    expect_shown(1919.5, "1919.5");
    expect_shown(12345.6, "12,345.6");
    expect_shown(123456, "123,456");
    expect_shown(-0.0609375, "\u22120.0609375");
    expect_shown(0, "0");
    expect_shown(-0.0, "0");
}

TEST(number_shown, other_numbers_have_four_and_all_before_the_point)
{
    expect_shown(1.0 / 6, "0.1667");
    expect_shown(-2.0 / 3, "\u22120.6667");
    expect_shown(PI, "3.142");
    expect_shown(9.99996, "9.99996");
    expect_shown(9.999961, "10");
    expect_shown(12345.678, "12,346");
    expect_shown(1234567.89, "1,234,568");
    expect_shown(9999999.9, "10\u2077");
}

TEST(number_shown, thousands_are_apart_from_five_digits_on)
{
    expect_shown(1000, "1000");
    expect_shown(9999, "9999");
    expect_shown(10000, "10,000");
    expect_shown(-2500, "\u22122500");
    expect_shown(1e6, "1,000,000");
    expect_shown(99999.96, "100,000");
}

TEST(number_shown, very_large_and_very_small_numbers_have_a_power_of_ten)
{
    expect_shown(1.2e-6, "1.2 \u00b7 10\u207b\u2076");
    expect_shown(-1e-6, "\u221210\u207b\u2076");
    expect_shown(2.50609e-6, "2.506 \u00b7 10\u207b\u2076");
    expect_shown(0.0001, "0.0001");
    expect_shown(0.00009999996, "0.0001");
    expect_shown(1e10, "10\u00b9\u2070");
    expect_shown(2.0 / 3 * 1e201, "6.667 \u00b7 10\u00b2\u2070\u2070");
    expect_shown(INFINITY, "\u221e");
    expect_shown(-INFINITY, "\u2212\u221e");
    expect_shown(NAN, "nan");
}

TEST(number_shown_to, more_digits_are_shown_if_there_are_more)
{
    expect_text(number_shown_to(PI, 8).s, "3.1415927");
    expect_text(number_shown_to(2, 8).s, "2");
    expect_text(number_shown_to(100000.25, 8).s, "100,000.25");
}

TEST(vec3_shown, what_rounding_has_left_is_nothing)
{
    expect_text(vec3_shown(vec3_of(0.1 + 0.2 - 0.3, -2, 10000)).s, "(0, \u22122, 10,000)");
    expect_text(vec3_shown(vec3_of(1e-6, 0, 1e6)).s, "(10\u207b\u2076, 0, 1,000,000)");
    expect_text(pair_shown(0.5, -1.0 / 3).s, "(0.5, \u22120.3333)");
    expect_text(pair_shown_to(0.5, -1.0 / 3, 5).s, "(0.5, \u22120.33333)");
}
