// vec3.c - tests of common/vec3.h. Expected: the definitions of the products, worked out by hand,
// and the laws that hold for every vector.
#include "common/vec3.h"

#include "tests/judge/test.h"

#include <stdalign.h>
#include <stdlib.h>

static const double tolerance = 1e-12;

// The same vector with something in the lane that is nobody's.
static vec3 with_fourth_lane(vec3 v, double lane)
{
    v[3] = lane;
    return v;
}

START_TEST(the_dot_product_adds_up_the_products_of_the_components)
{
    vec3 v = vec3_of(1, 2, 3), w = vec3_of(4, -5, 6);
    given_vec3("v", v);
    given_vec3("w", w);
    expect_number(vec3_dot(v, w), 12, 0);
}
END_TEST

START_TEST(the_dot_product_of_unit_vectors_is_the_cosine_between_them)
{
    for (int degrees = 0; degrees <= 180; degrees += 15) {
        double angle = degrees * PI / 180;
        given_number("degrees", degrees);
        expect_number(vec3_dot(vec3_of(0, 1, 0), vec3_of(0, cos(angle), sin(angle))), cos(angle),
                      tolerance);
    }
}
END_TEST

START_TEST(x_cross_y_is_z_and_so_on_round)
{
    vec3 x = vec3_of(1, 0, 0), y = vec3_of(0, 1, 0), z = vec3_of(0, 0, 1);
    expect_vec3(vec3_cross(x, y), z, 0);
    expect_vec3(vec3_cross(y, z), x, 0);
    expect_vec3(vec3_cross(z, x), y, 0);
    expect_vec3(vec3_cross(y, x), -z, 0);
}
END_TEST

// Columns 1 2 3 and 4 5 7: (2*7 - 3*5, 3*4 - 1*7, 1*5 - 2*4).
START_TEST(the_cross_product_of_two_vectors_worked_out_by_hand)
{
    expect_vec3(vec3_cross(vec3_of(1, 2, 3), vec3_of(4, 5, 7)), vec3_of(-1, 5, -3), 0);
}
END_TEST

START_TEST(the_cross_product_is_at_right_angles_to_both)
{
    for (int i = 0; i < 50; i++) {
        vec3 v = random_vec3(-3, 3), w = random_vec3(-3, 3);
        given_vec3("v", v);
        given_vec3("w", w);
        expect_number(vec3_dot(vec3_cross(v, w), v), 0, tolerance);
        expect_number(vec3_dot(vec3_cross(v, w), w), 0, tolerance);
    }
}
END_TEST

// Lagrange: |v x w|^2 = |v|^2 |w|^2 - (v . w)^2.
START_TEST(the_length_of_the_cross_product_is_the_area_that_both_span)
{
    for (int i = 0; i < 50; i++) {
        vec3 v = random_vec3(-3, 3), w = random_vec3(-3, 3), n = vec3_cross(v, w);
        double dot = vec3_dot(v, w);
        given_vec3("v", v);
        given_vec3("w", w);
        expect_number(vec3_dot(n, n), vec3_dot(v, v) * vec3_dot(w, w) - dot * dot, 1e-10);
    }
}
END_TEST

START_TEST(the_cross_product_of_parallel_vectors_is_zero)
{
    vec3 v = vec3_of(1, -2, 4);
    expect_vec3(vec3_cross(v, -2 * v), vec3_of(0, 0, 0), 0);
}
END_TEST

START_TEST(the_length_of_2_minus_3_6_is_7)
{
    expect_number(vec3_length(vec3_of(2, -3, 6)), 7, 0);
}
END_TEST

START_TEST(lengths_are_right_from_1e_minus_150_to_1e150)
{
    given_number("scale", 1e149);
    expect_number(vec3_length(1e149 * vec3_of(2, 3, 6)) / 1e149, 7, tolerance);
    given_number("scale", 1e-150);
    expect_number(vec3_length(1e-150 * vec3_of(2, 3, 6)) / 1e-150, 7, tolerance);
}
END_TEST

START_TEST(the_unit_vector_has_length_1_and_the_same_direction)
{
    expect_vec3(vec3_unit(vec3_of(2, -3, 6)), vec3_of(2, -3, 6) / 7, tolerance);
    for (int i = 0; i < 50; i++) {
        vec3 v = random_vec3(-9, 9), unit = vec3_unit(v);
        given_vec3("v", v);
        expect_number(sqrt(vec3_dot(unit, unit)), 1, tolerance);
        given_vec3("v", v);
        expect_vec3(vec3_length(v) * unit, v, tolerance);
    }
}
END_TEST

START_TEST(the_zero_vector_has_no_direction)
{
    vec3 unit = vec3_unit(vec3_of(0, 0, 0));
    for (int i = 0; i < 3; i++)
        ck_assert(isnan(unit[i]));
}
END_TEST

START_TEST(an_expression_of_the_slide_is_code)
{
    double d = 4, w = 2, h = 6;
    vec3 r = vec3_of(1, 2, 3), u = vec3_of(10, 20, 30), f = vec3_of(100, 200, 300);
    expect_vec3(d * f - w / 2 * r + h / 2 * u, vec3_of(429, 858, 1287), 0);
    expect_vec3(-r + f / 4, vec3_of(24, 48, 72), 0);
}
END_TEST

START_TEST(v_times_w_multiplies_component_by_component)
{
    expect_vec3(vec3_of(1, 2, 3) * vec3_of(0.5, -4, 0), vec3_of(0.5, -8, 0), 0);
}
END_TEST

// v / w leaves 0 / 0 in the fourth lane, so it may hold anything.
START_TEST(the_fourth_lane_leaks_into_nothing)
{
    const double lanes[] = {NAN, INFINITY, -1e300, 5};
    for (int i = 0; i < 4; i++) {
        vec3 v = with_fourth_lane(vec3_of(2, -3, 6), lanes[i]);
        vec3 w = with_fourth_lane(vec3_of(1, 1, 1), lanes[i]);
        given_number("fourth lane", lanes[i]);
        expect_number(vec3_dot(v, w), 5, 0);
        expect_number(vec3_length(v), 7, 0);
        expect_vec3(vec3_unit(v), vec3_of(2, -3, 6) / 7, tolerance);
        expect_vec3(vec3_cross(v, w), vec3_of(-9, 4, 5), 0);
        ck_assert(vec3_is_finite(v));
    }
    ck_assert(vec3_is_finite(vec3_of(1, 2, 3) / vec3_of(4, 5, 6)));
}
END_TEST

START_TEST(one_component_that_is_not_finite_is_enough)
{
    const double bad[] = {NAN, INFINITY, -INFINITY};
    ck_assert(vec3_is_finite(vec3_of(0, -1e308, 1e-320)));
    for (int i = 0; i < 9; i++) {
        vec3 v = vec3_of(1, 2, 3);
        v[i / 3] = bad[i % 3];
        given_vec3("v", v);
        expect_law(!vec3_is_finite(v), "not finite", "finite");
    }
}
END_TEST

START_TEST(arrays_from_malloc_hold_vectors)
{
    ck_assert_uint_eq(sizeof(vec3), 32);
    ck_assert_uint_le(alignof(vec3), alignof(max_align_t));
    for (int count = 1; count < 40; count++) {
        vec3 *many = malloc((size_t)count * sizeof *many);
        ck_assert_ptr_nonnull(many);
        for (int i = 0; i < count; i++)
            many[i] = vec3_of(i, 2 * i, 3 * i);
        vec3 sum = vec3_of(0, 0, 0);
        for (int i = 0; i < count; i++)
            sum += many[i];
        free(many);
        given_number("count", count);
        expect_vec3(sum, count * (count - 1) * vec3_of(0.5, 1, 1.5), 0);
    }
}
END_TEST

START_TEST(pi_is_half_the_way_round)
{
    expect_number(PI, acos(-1), 0);
}
END_TEST

static void list_tests(void)
{
    tests_of("vec3_dot");
    test(the_dot_product_adds_up_the_products_of_the_components);
    test(the_dot_product_of_unit_vectors_is_the_cosine_between_them);
    tests_of("vec3_cross");
    test(x_cross_y_is_z_and_so_on_round);
    test(the_cross_product_of_two_vectors_worked_out_by_hand);
    test(the_cross_product_is_at_right_angles_to_both);
    test(the_length_of_the_cross_product_is_the_area_that_both_span);
    test(the_cross_product_of_parallel_vectors_is_zero);
    tests_of("vec3_length");
    test(the_length_of_2_minus_3_6_is_7);
    test(lengths_are_right_from_1e_minus_150_to_1e150);
    tests_of("vec3_unit");
    test(the_unit_vector_has_length_1_and_the_same_direction);
    test(the_zero_vector_has_no_direction);
    tests_of("vec3");
    test(an_expression_of_the_slide_is_code);
    test(v_times_w_multiplies_component_by_component);
    test(the_fourth_lane_leaks_into_nothing);
    test(one_component_that_is_not_finite_is_enough);
    test(arrays_from_malloc_hold_vectors);
    test(pi_is_half_the_way_round);
}

OF_STEM(list_tests)
