// mistakes.c - wrong answers to exercise 02: those to the width from an angle, and the list of all
// tables.
#include "tests/02-cameras/mistakes.h"

#include <stddef.h>

static double whole_angle(double degrees, double distance)
{
    return 2 * distance * tan(degrees * PI / 180);
}

static double degrees_into_tan(double degrees, double distance)
{
    return 2 * distance * tan(degrees / 2);
}

static double turned_into_degrees(double degrees, double distance)
{
    return 2 * distance * tan(degrees / 2 * 180 / PI);
}

static double radians_behind_tan(double degrees, double distance)
{
    return 2 * distance * tan(degrees / 2) * PI / 180;
}

static double half_the_width(double degrees, double distance)
{
    return distance * tan(degrees * PI / 360);
}

static double tangent_of_the_whole_angle(double degrees, double distance)
{
    return distance * tan(degrees * PI / 180);
}

static double distance_forgotten(double degrees, double distance)
{
    (void)distance;
    return 2 * tan(degrees * PI / 360);
}

static double divided_by_the_distance(double degrees, double distance)
{
    return 2 * tan(degrees * PI / 360) / distance;
}

static double length_of_the_arc(double degrees, double distance)
{
    return distance * degrees * PI / 180;
}

static double sine_for_tangent(double degrees, double distance)
{
    return 2 * distance * sin(degrees * PI / 360);
}

static double divided_by_the_tangent(double degrees, double distance)
{
    return 2 * distance / tan(degrees * PI / 360);
}

static double pi_in_three_digits(double degrees, double distance)
{
    return 2 * distance * tan(degrees * 3.14 / 360);
}

static double whole_degrees_halved(double degrees, double distance)
{
    return 2 * distance * tan((int)degrees / 2 * PI / 180);
}

static double half_in_whole_numbers(double degrees, double distance)
{
    return 2 * distance * tan(degrees * (1 / 2) * PI / 180);
}

static const Mistake angle_mistakes[] = {
    MISTAKE("L6", width_from_angle, whole_angle, "w = 2 d tan(angle)",
            "the view direction cuts the angle in two, and each of the two right triangles has "
            "only half of it at the eye.",
            "far too much: everything small (and nothing at all from 90 degrees on)"),
    MISTAKE("L7", width_from_angle, degrees_into_tan, "w = 2 d tan(angle / 2), in degrees",
            "tan expects radians, so 90 is many times round the circle.",
            "a wild width, sometimes negative"),
    MISTAKE(
        "L7-back", width_from_angle, turned_into_degrees, "w = 2 d tan(angle / 2 * 180 / pi)",
        "half a turn is pi radians, and tan expects radians. This multiplies instead of dividing.",
        "a wild width, sometimes negative"),
    MISTAKE("L7-behind", width_from_angle, radians_behind_tan, "w = 2 d tan(angle / 2) * pi / 180",
            "convert the angle to radians before tan, not the tangent after it.",
            "a wild width, mostly tiny"),
    MISTAKE("L6-half", width_from_angle, half_the_width, "w = d tan(angle / 2)",
            "this is the width from the middle of the plane to one edge, not from edge to edge.",
            "half of the width: everything twice as big"),
    MISTAKE("L6-once", width_from_angle, tangent_of_the_whole_angle, "w = d tan(angle)",
            "the triangle of eye, left edge and right edge has no right angle, so the tangent of "
            "its whole angle does not help. Cut it in two first.",
            "too much, and nothing at all from 90 degrees on"),
    MISTAKE("A-distance", width_from_angle, distance_forgotten, "w = 2 tan(angle / 2)",
            "twice as far away, the same angle spans twice the width.", "right only if d = 1"),
    MISTAKE("A-divided", width_from_angle, divided_by_the_distance, "w = 2 tan(angle / 2) / d",
            "the farther the plane, the wider it must be to fill the same angle.",
            "right only if d = 1"),
    MISTAKE("A-arc", width_from_angle, length_of_the_arc, "w = d angle",
            "this is the length of an arc around the eye. The image plane is flat, and cuts the "
            "sides of the angle farther out.",
            "a little too narrow, more so for wide angles"),
    MISTAKE("A-chord", width_from_angle, sine_for_tangent, "w = 2 d sin(angle / 2)",
            "d leads to the middle of the plane, so it is a leg of the right triangle, not the "
            "hypotenuse.",
            "a little too narrow, more so for wide angles"),
    MISTAKE("A-cotangent", width_from_angle, divided_by_the_tangent, "w = 2 d / tan(angle / 2)",
            "this swaps the triangle's legs: a wider angle would see less.",
            "right only at 90 degrees"),
    MISTAKE("A-pi", width_from_angle, pi_in_three_digits, "w = 2 d tan(angle / 2), with 3.14 as pi",
            "three digits of pi give three digits of the width. common/vec3.h has PI.",
            "no visible difference, but the fourth digit is wrong"),
    MISTAKE("A-int", width_from_angle, half_in_whole_numbers,
            "w = 2 d tan(angle * (1 / 2)), in integers",
            "in C, 1 / 2 is an integer division with the result 0, so this is the tangent of 0. "
            "Use 0.5, or / 2.",
            "nothing: the image plane has width 0"),
    MISTAKE("A-whole", width_from_angle, whole_degrees_halved,
            "w = 2 d tan(angle / 2), in whole degrees",
            "in integers 45 / 2 is 22: the digits after the decimal point are lost.",
            "a little too narrow at odd angles"),
    {0},
};

static const Mistake *const mistakes[] = {vector_mistakes,
                                          vector_refusal_mistakes,
                                          vector_unchecked_mistakes,
                                          point_mistakes,
                                          corner_mistakes,
                                          look_at_mistakes,
                                          look_at_refusal_mistakes,
                                          look_at_unchecked_mistakes,
                                          angle_mistakes,
                                          camera_limit_mistakes,
                                          NULL};
OF_STEM(mistakes)
