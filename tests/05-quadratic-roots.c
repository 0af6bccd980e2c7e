// 05-quadratic-roots.c - tests of quadratic_roots.
#include "tests/05-quadratic.h"

// The quadratic with these roots.
static Quadratic with_roots(double a, double t, double u)
{
    return (Quadratic){a, -a * (t + u), a * t * u};
}

// By hand: (9 - 1) / 2.5 and (9 + 1) / 2.5.
START_TEST(the_roots_are_the_t_of_the_hits_drawn_in_the_deck)
{
    expect_roots_of((Quadratic){1.25, -9, 16}, two(3.2, 4), TOLERANCE);
}
END_TEST

START_TEST(the_roots_of_the_arrow_of_the_deck)
{
    expect_roots_of((Quadratic){0.9946, -8.02, 16}, two(3.622, 4.442), 1e-3);
}
END_TEST

START_TEST(roots_that_were_chosen_come_back)
{
    expect_roots_of(with_roots(1, 2, 3), two(2, 3), TOLERANCE);
    expect_roots_of(with_roots(2, -1, 5), two(-1, 5), TOLERANCE);
    expect_roots_of(with_roots(0.5, -6, -4), two(-6, -4), TOLERANCE);
    for (int i = 0; i < 30; i++) {
        double a = random_number(0.1, 5), t = random_number(-9, 9), gap = random_number(0.1, 9);
        expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE);
    }
}
END_TEST

START_TEST(roots_come_in_ascending_order_even_when_a_is_negative)
{
    expect_roots_of(with_roots(-1, 2, 3), two(2, 3), TOLERANCE);
    expect_roots_of(with_roots(-4, -7, 1), two(-7, 1), TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double a = -random_number(0.1, 5), t = random_number(-9, 9), gap = random_number(0.1, 9);
        expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE);
    }
}
END_TEST

// a and the root are powers of two, and so are b and c: nothing is rounded, even by an answer that
// divides by one of them first.
START_TEST(a_double_root_counts_as_two)
{
    expect_roots_of((Quadratic){1, -8, 16}, two(4, 4), TOLERANCE);
    expect_roots_of((Quadratic){2, 8, 8}, two(-2, -2), TOLERANCE);
    expect_roots_of((Quadratic){3, 0, 0}, two(0, 0), TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double a = ldexp(i % 2 == 0 ? 1 : -1, (int)random_number(-10, 10));
        double t = ldexp(i % 4 < 2 ? 1 : -1, (int)random_number(-10, 10));
        expect_roots_of(with_roots(a, t, t), two(t, t), TOLERANCE);
    }
}
END_TEST

START_TEST(there_are_no_roots_where_the_parabola_stays_on_one_side)
{
    Quadratic none[] = {{1, 0, 1}, {2, -4, 9}, {1, 1, 0.5}, {-1, 2, -5}};
    for (int i = 0; i < 4; i++) {
        given_quadratic(none[i]);
        expect_no_roots(quadratic_roots(none[i]));
    }
    // a ((t - lowest)^2 + above^2)
    for (int i = 0; i < 10; i++) {
        double a = random_number(0.1, 5) * (i % 2 == 0 ? 1 : -1);
        double lowest = random_number(-9, 9), above = random_number(0.1, 3);
        Quadratic q = {a, -2 * a * lowest, a * (lowest * lowest + above * above)};
        given_quadratic(q);
        expect_no_roots(quadratic_roots(q));
    }
}
END_TEST

START_TEST(where_b_is_0_the_roots_are_opposite)
{
    expect_roots_of((Quadratic){4, 0, -9}, two(-1.5, 1.5), TOLERANCE);
}
END_TEST

START_TEST(where_c_is_0_one_root_is_0)
{
    expect_roots_of((Quadratic){2, -6, 0}, two(0, 3), TOLERANCE);
    expect_roots_of((Quadratic){2, 6, 0}, two(-3, 0), TOLERANCE);
    expect_roots_of((Quadratic){3e6, -6e6, 0}, two(0, 2), TOLERANCE);
    expect_roots_of((Quadratic){-3e6, 6e6, 0}, two(0, 2), TOLERANCE);
}
END_TEST

START_TEST(where_a_is_0_it_is_a_line_with_one_root)
{
    expect_roots_of((Quadratic){0, 2, -6}, (Roots){1, {3}}, TOLERANCE);
    expect_roots_of((Quadratic){0, -4, 0}, (Roots){1, {0}}, TOLERANCE);
    for (int i = 0; i < 10; i++) {
        double b = random_number(0.1, 5) * (i % 2 == 0 ? 1 : -1), t = random_number(-9, 9);
        expect_roots_of((Quadratic){0, b, -b * t}, (Roots){1, {t}}, TOLERANCE);
    }
}
END_TEST

START_TEST(where_a_and_b_are_0_there_are_no_roots)
{
    double c[] = {5, -5, 0};
    for (int i = 0; i < 3; i++) {
        given_quadratic((Quadratic){0, 0, c[i]});
        expect_no_roots(quadratic_roots((Quadratic){0, 0, c[i]}));
    }
}
END_TEST

// The law of scale: whatever a, b and c are all multiplied by, the roots stay; and with b and c
// divided by k and its square, the roots are 1/k of what they were. Nothing is small in itself.
START_TEST(coefficients_and_roots_may_be_large_or_small)
{
    enum { COUNT = 25 };
    for (int i = 0; i < COUNT; i++) {
        double size = random_scale(i, COUNT), bend = random_scale((7 * i) % COUNT, COUNT);
        double a = random_number(0.5, 5) * pow(bend, 3); // size may be anything beside it
        double t = size * random_number(-9, 9), gap = size * random_number(0.1, 9);
        if (i % 5 == 4)
            a = -a;
        if (i % 3 < 2) {
            expect_roots_of(with_roots(a, t, t + gap), two(t, t + gap), TOLERANCE * size);
            continue;
        }
        Quadratic q = {a, -2 * a * t, a * (t * t + gap * gap)}; // a ((x - t)^2 + gap^2)
        given_quadratic(q);
        expect_no_roots(quadratic_roots(q));
    }
}
END_TEST

// D is 4 times the root's square.
START_TEST(a_discriminant_may_be_of_any_size)
{
    for (int power = -16; power <= 16; power++) {
        double root = pow(10, power);
        expect_roots_of((Quadratic){1, 0, -root * root}, two(-root, root), TOLERANCE * root);
        given_quadratic((Quadratic){1, 0, root * root});
        expect_no_roots(quadratic_roots((Quadratic){1, 0, root * root}));
    }
}
END_TEST

START_TEST(a_line_may_be_steep_or_almost_level)
{
    enum { COUNT = 13 };
    for (int i = 0; i < COUNT; i++) {
        double slope = pow(random_scale(i, COUNT), 3);
        double b = random_number(0.5, 5) * slope * (i % 2 == 0 ? 1 : -1);
        double size = random_scale((5 * i) % COUNT, COUNT), t = size * random_number(-9, 9);
        expect_roots_of((Quadratic){0, b, -b * t}, (Roots){1, {t}}, TOLERANCE * size);
    }
}
END_TEST

// Far out it bends all the same: the second root is where the line would never be.
START_TEST(a_parabola_that_hardly_bends_has_two_roots)
{
    for (int i = 0; i < 5; i++) {
        double far = pow(10, 3 + i) * random_number(1, 9) * (i % 2 == 0 ? 1 : -1);
        Quadratic q = with_roots(random_number(0.5, 5) / far, 1, far);
        expect_roots_of(q, two(fmin(1, far), fmax(1, far)), TOLERANCE * fabs(far));
    }
}
END_TEST

void list_tests_of_roots(void)
{
    tests_of("quadratic_roots");
    test(the_roots_are_the_t_of_the_hits_drawn_in_the_deck);
    test(the_roots_of_the_arrow_of_the_deck);
    test(roots_that_were_chosen_come_back);
    test(roots_come_in_ascending_order_even_when_a_is_negative);
    test(a_double_root_counts_as_two);
    test(there_are_no_roots_where_the_parabola_stays_on_one_side);
    test(where_b_is_0_the_roots_are_opposite);
    test(where_c_is_0_one_root_is_0);
    test(where_a_is_0_it_is_a_line_with_one_root);
    test(where_a_and_b_are_0_there_are_no_roots);
    test(coefficients_and_roots_may_be_large_or_small);
    test(a_discriminant_may_be_of_any_size);
    test(a_line_may_be_steep_or_almost_level);
    test(a_parabola_that_hardly_bends_has_two_roots);
}
