// 05-quadratic-digits.c - tests of quadratic_roots beyond the slide's formula, which loses digits.
// They cost no marks.
#include "tests/05-quadratic.h"

#include <stdlib.h>

// t^2 - 10^8 t + 1: the product of the roots is 1, their sum 10^8; so 10^-8 to 16 digits.
START_TEST(a_small_root_beside_a_large_one_keeps_its_digits)
{
    given_quadratic((Quadratic){1, -1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, -1e8, 1}).t[0], 1e-8, 1e-17);
    given_quadratic((Quadratic){1, 1e8, 1});
    expect_number(quadratic_roots((Quadratic){1, 1e8, 1}).t[1], -1e-8, 1e-17);
}
END_TEST

// Kahan's example: a + b + c is exactly 0, so 1 is a root, and the other is c / a.
START_TEST(roots_that_are_nearly_equal_keep_their_digits)
{
    Quadratic q = {94906265.625, -189812534, 94906268.375};
    expect_roots_of(q, two(1, 94906268.375 / 94906265.625), 1e-12);
}
END_TEST

START_TEST(enormous_and_tiny_coefficients_neither_overflow_nor_vanish)
{
    expect_roots_of((Quadratic){1e200, -3e200, 2e200}, two(1, 2), TOLERANCE);
    expect_roots_of((Quadratic){1e-200, -3e-200, 2e-200}, two(1, 2), TOLERANCE);
}
END_TEST

// The same, its t counted in two thirds: then a and c are far apart.
START_TEST(nearly_equal_roots_keep_their_digits_where_a_and_c_differ)
{
    Quadratic q = {2.25 * 94906265.625, 1.5 * -189812534, 94906268.375};
    expect_roots_of(q, two(1 / 1.5, 94906268.375 / 94906265.625 / 1.5), 1e-12);
}
END_TEST

// 1.25 (t - 1.5)(t - 3), times a power of two, for t times a power of two.
START_TEST(coefficients_and_roots_may_be_of_any_size)
{
    for (int size = -900; size <= 900; size += 300)
        for (int t = -400; t <= 400; t += 100)
            if (abs(size + 2 * t) < 1000)
                expect_roots_of((Quadratic){ldexp(1.25, size), ldexp(-5.625, size + t),
                                            ldexp(5.625, size + 2 * t)},
                                two(ldexp(1.5, t), ldexp(3, t)), ldexp(1e-12, t));
}
END_TEST

START_TEST(where_b_is_0_or_nearly_coefficients_may_be_of_any_size)
{
    expect_roots_of((Quadratic){0x1p600, 0, -0x1p-600}, two(-0x1p-600, 0x1p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p-600, 0, -0x1p600}, two(-0x1p600, 0x1p600), 0x1p560);
    expect_roots_of((Quadratic){0x1p600, 0x1p-1000, -0x1p-600}, two(-0x1p-600, 0x1p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p600, 0, -0x1p600}, two(-1, 1), 1e-12);
    expect_roots_of((Quadratic){0x1p-600, 0, -0x1p-600}, two(-1, 1), 1e-12);
    given_quadratic((Quadratic){0x1p-600, 0, 0x1p-600});
    expect_no_roots(quadratic_roots((Quadratic){0x1p-600, 0, 0x1p-600}));
}
END_TEST

START_TEST(where_c_is_0_coefficients_may_be_of_any_size)
{
    expect_roots_of((Quadratic){0x1p500, -0x3p-300, 0}, two(0, 0x3p-800), 0x1p-840);
    expect_roots_of((Quadratic){0x1p-100, -0x3p-700, 0}, two(0, 0x3p-600), 0x1p-640);
    expect_roots_of((Quadratic){0x1p-100, -0x3p700, 0}, two(0, 0x3p800), 0x1p760);
}
END_TEST

// Then the roots are -c / b and -b / a to the last digit.
START_TEST(b_may_outweigh_the_others_by_far)
{
    expect_roots_of((Quadratic){1, -0x1p400, 0}, two(0, 0x1p400), 0x1p360);
    Quadratic q = {0x1p-300, -0x1p100, -0x1p-50};
    given_quadratic(q);
    given("looking at", "the first root");
    expect_number(quadratic_roots(q).t[0], -0x1p-150, 0x1p-190);
    given_quadratic(q);
    given("looking at", "the second root");
    expect_number(quadratic_roots(q).t[1], 0x1p400, 0x1p360);
}
END_TEST

START_TEST(what_is_no_number_has_no_roots)
{
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 9; i++) {
        double q[] = {1, -3, 2};
        q[i / 3] = none[i % 3];
        given_quadratic((Quadratic){q[0], q[1], q[2]});
        expect_no_roots(quadratic_roots((Quadratic){q[0], q[1], q[2]}));
    }
}
END_TEST

void list_tests_of_digits(void)
{
    tests_of_extra("quadratic_roots");
    test(a_small_root_beside_a_large_one_keeps_its_digits);
    test(roots_that_are_nearly_equal_keep_their_digits);
    test(enormous_and_tiny_coefficients_neither_overflow_nor_vanish);
    test(nearly_equal_roots_keep_their_digits_where_a_and_c_differ);
    test(coefficients_and_roots_may_be_of_any_size);
    test(where_b_is_0_or_nearly_coefficients_may_be_of_any_size);
    test(where_c_is_0_coefficients_may_be_of_any_size);
    test(b_may_outweigh_the_others_by_far);
    test(what_is_no_number_has_no_roots);
}
