// mistakes.c - wrong answers to exercise 02: the list of all, and those to the width of an angle.
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
            "straight ahead cuts the angle in two, and each of the right triangles has only one "
            "part of it at the eye.",
            "far too much: everything small (and nothing at all from 90 degrees on)"),
    MISTAKE("L7", width_from_angle, degrees_into_tan, "w = 2 d tan(angle / 2), in degrees",
            "tan takes what it is given for radians, so 90 goes round the circle many times.",
            "a wild width, sometimes negative"),
    MISTAKE("L7-back", width_from_angle, turned_into_degrees, "w = 2 d tan(angle / 2 * 180 / pi)",
            "a half turn is pi radians, and tan wants radians. This multiplies where it should "
            "divide.",
            "a wild width, sometimes negative"),
    MISTAKE("L7-behind", width_from_angle, radians_behind_tan, "w = 2 d tan(angle / 2) * pi / 180",
            "it is the angle that must be in radians, before tan sees it, not the tangent.",
            "a wild width, mostly tiny"),
    MISTAKE("L6-half", width_from_angle, half_the_width, "w = d tan(angle / 2)",
            "that is from the middle of the plane to one edge, not from edge to edge.",
            "half of the width: everything twice as big"),
    MISTAKE("L6-once", width_from_angle, tangent_of_the_whole_angle, "w = d tan(angle)",
            "the triangle of eye, left edge and right edge has no right angle, so its angle has no "
            "such tangent. Cut it in two first.",
            "too much, and nothing at all from 90 degrees on"),
    MISTAKE("A-distance", width_from_angle, distance_forgotten, "w = 2 tan(angle / 2)",
            "twice as far away the same angle spans twice the width.", "right only where d = 1"),
    MISTAKE("A-divided", width_from_angle, divided_by_the_distance, "w = 2 tan(angle / 2) / d",
            "the farther the plane, the wider it must be to fill the same angle.",
            "right only where d = 1"),
    MISTAKE("A-arc", width_from_angle, length_of_the_arc, "w = d angle",
            "that is the length of an arc round the eye. The image plane is flat, and cuts the "
            "sides of the angle farther out.",
            "a little too narrow, more so under wide angles"),
    MISTAKE("A-chord", width_from_angle, sine_for_tangent, "w = 2 d sin(angle / 2)",
            "d leads to the middle of the plane, so it is a leg of the right triangle, not the "
            "long side.",
            "a little too narrow, more so under wide angles"),
    MISTAKE("A-cotangent", width_from_angle, divided_by_the_tangent, "w = 2 d / tan(angle / 2)",
            "this turns the triangle's legs round: a wider angle would see less.",
            "right only at 90 degrees"),
    MISTAKE("A-pi", width_from_angle, pi_in_three_digits, "w = 2 d tan(angle / 2), with 3.14 as pi",
            "three digits of pi give three digits of the width. common/vec3.h has PI.",
            "no difference to the eye, but it is off in the fourth digit"),
    MISTAKE("A-int", width_from_angle, half_in_whole_numbers,
            "w = 2 d tan(angle * (1 / 2)), in whole numbers",
            "in C, 1 / 2 of two ints is 0, and so is the tangent of no angle. 0.5 or / 2 halves.",
            "nothing: an image plane without a width"),
    MISTAKE("A-whole", width_from_angle, whole_degrees_halved,
            "w = 2 d tan(angle / 2), in whole degrees",
            "in whole numbers 45 / 2 is 22, and what is behind the point is lost.",
            "a little too narrow at odd angles"),
    {0},
};

const Mistake *const mistakes[] = {vector_mistakes,
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
