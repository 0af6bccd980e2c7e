// 02-cameras-no-look-at.c - tests of the look-at: what must be refused.
#include "tests/02-cameras.h"

// In either world.
static void look_refuses_also(LookAt view, int reasons, int also)
{
    Camera after;
    CameraFault fault = look(view, RIGHT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
    fault = look(view, LEFT_HANDED, &after);
    expect_refused(fault, after, reasons, also);
}

static void look_refuses(LookAt view, int reasons)
{
    look_refuses_also(view, reasons, 0);
}

// The plane passes through the point looked at, so there is no distance either.
START_TEST(looking_at_the_eye_itself_is_refused)
{
    LookAt view = look_at_of_the_deck();
    view.at = view.eye;
    look_refuses_also(view, DIRECTION, DISTANCE);
}
END_TEST

START_TEST(an_up_of_zero_is_refused)
{
    look_refuses(deck_with(vec3_of(0, 0, 0), 2, 1), UP);
}
END_TEST

// Once in round numbers, then where rounding leaves a little to the side.
static void look_refuses_an_up_along_the_view(double sign)
{
    LookAt view = deck_with(vec3_of(0, 0, 5 * sign), 2, 1);
    look_refuses(view, UP);
    for (int i = 0; i < 10; i++) {
        vec3 forward = random_unit();
        view.at = view.eye + 3 * forward;
        view.up = sign * random_number(0.1, 9) * forward;
        look_refuses(view, UP);
    }
}

START_TEST(an_up_along_the_view_is_refused)
{
    look_refuses_an_up_along_the_view(1);
}
END_TEST

START_TEST(an_up_against_the_view_is_refused)
{
    look_refuses_an_up_along_the_view(-1);
}
END_TEST

START_TEST(a_width_that_is_not_positive_is_refused)
{
    look_refuses(deck_with_size(0, 1), WIDTH | HEIGHT);
    look_refuses(deck_with_size(-2, 1), WIDTH | HEIGHT);
    for (int i = 0; i < 5; i++)
        look_refuses(deck_with_size(-random_number(0.1, 9), 1.5), WIDTH | HEIGHT);
}
END_TEST

// By an aspect of 0 the height is infinite.
START_TEST(an_aspect_that_is_not_positive_is_refused)
{
    look_refuses_also(deck_with_size(2, 0), HEIGHT, FINITE);
    look_refuses(deck_with_size(2, -1), HEIGHT);
    for (int i = 0; i < 5; i++)
        look_refuses(deck_with_size(3, -random_number(0.1, 9)), HEIGHT);
}
END_TEST

// From infinitely far above the view is along up, and so is an up that is infinite along the view.
START_TEST(a_look_at_whose_vectors_are_not_finite_is_refused)
{
    for (int axis = 0; axis < 3; axis++) {
        LookAt view = look_at_of_the_deck();
        view.eye[axis] = not_finite(axis);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.at[axis] = not_finite(axis + 1);
        look_refuses_also(view, FINITE, axis == 1 ? UP : 0);
        view = look_at_of_the_deck();
        view.up[axis] = not_finite(axis + 2);
        look_refuses_also(view, FINITE, axis == 2 ? UP : 0);
    }
}
END_TEST

// NaN and minus infinity are not positive either, and an infinite aspect leaves no height.
START_TEST(a_width_or_aspect_that_is_not_finite_is_refused)
{
    for (int i = 0; i < 3; i++) {
        look_refuses(deck_with_size(not_finite(i), 1), FINITE | WIDTH | HEIGHT);
        look_refuses(deck_with_size(2, not_finite(i)), FINITE | HEIGHT);
    }
}
END_TEST

void list_refusals_of_look_at(void)
{
    test(looking_at_the_eye_itself_is_refused);
    test(an_up_of_zero_is_refused);
    test(an_up_along_the_view_is_refused);
    test(an_up_against_the_view_is_refused);
    test(a_width_that_is_not_positive_is_refused);
    test(an_aspect_that_is_not_positive_is_refused);
    test(a_look_at_whose_vectors_are_not_finite_is_refused);
    test(a_width_or_aspect_that_is_not_finite_is_refused);
}
