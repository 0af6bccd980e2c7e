// vec3.c - tests of common/vec3.h at its edges: extreme lengths, what is not finite, the fourth
// lane, memory. That products and lengths are right is seen by the tests of every exercise.
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

TEST(vec3_length, lengths_are_right_from_1e_minus_150_to_1e150)
{
    given_number("scale", 1e149);
    expect_number(vec3_length(1e149 * vec3_of(2, 3, 6)) / 1e149, 7, tolerance);
    given_number("scale", 1e-150);
    expect_number(vec3_length(1e-150 * vec3_of(2, 3, 6)) / 1e-150, 7, tolerance);
}

TEST(vec3_unit, the_zero_vector_has_no_direction)
{
    vec3 unit = vec3_unit(vec3_of(0, 0, 0));
    for (int i = 0; i < 3; i++)
        ck_assert(isnan(unit[i]));
}

// v / w leaves 0 / 0 in the fourth lane, so it may hold anything.
TEST(vec3, the_fourth_lane_leaks_into_nothing)
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

TEST(vec3, one_component_that_is_not_finite_is_enough)
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

TEST(vec3, arrays_from_malloc_hold_vectors)
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
