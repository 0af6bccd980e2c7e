// mistakes-ahead.c - wrong vectors to any place of the image plane: wrong ahead, or with other
// directions.
#include "exercises/01-corners.h"
#include "tests/judge/mistake.h"

static vec3 forward_without_distance(Camera c, double s, double t)
{
    return c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 nothing_ahead(Camera c, double s, double t)
{
    return (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 behind_the_eye(Camera c, double s, double t)
{
    return -c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 point_for_vector(Camera c, double s, double t)
{
    return c.origin + image_plane_vector(c, s, t);
}

static vec3 point_minus_eye(Camera c, double s, double t)
{
    return image_plane_vector(c, s, t) - c.origin;
}

static vec3 distance_times_all(Camera c, double s, double t)
{
    return c.distance * (c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up);
}

static vec3 of_length_1(Camera c, double s, double t)
{
    return vec3_unit(image_plane_vector(c, s, t));
}

static vec3 divided_by_distance(Camera c, double s, double t)
{
    return image_plane_vector(c, s, t) / c.distance;
}

static vec3 numbers_plus_vector(Camera c, double s, double t)
{
    return (s - 0.5) * c.width + (t - 0.5) * c.height + c.distance * c.forward;
}

static vec3 axes_of_the_world(Camera c, double s, double t)
{
    return vec3_of((s - 0.5) * c.width, (t - 0.5) * c.height, c.distance);
}

const Mistake place_ahead_mistakes[] = {
    MISTAKE("G-f", image_plane_vector, forward_without_distance,
            "f + (s - 1/2) w r + (t - 1/2) h u",
            "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
            "right if d = 1; if not, a narrower or wider view"),
    MISTAKE("G-flat", image_plane_vector, nothing_ahead, "(s - 1/2) w r + (t - 1/2) h u",
            "the step d f is missing. The vector goes only sideways and never reaches the plane.",
            "blank: the rays go off sideways"),
    MISTAKE("G-back", image_plane_vector, behind_the_eye, "-d f + (s - 1/2) w r + (t - 1/2) h u",
            "f points ahead, to the plane. This vector goes backwards from the eye.",
            "blank, or the scene behind the camera, mirrored"),
    MISTAKE("G-p", image_plane_vector, point_for_vector, "p + d f + (s - 1/2) w r + (t - 1/2) h u",
            "this is the place as a point of the world. The vector from the eye to it does not "
            "depend on where the eye is.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("G-minus-p", image_plane_vector, point_minus_eye,
            "d f + (s - 1/2) w r + (t - 1/2) h u - p",
            "the vector starts at the eye already, so do not subtract the eye again.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("G-times", image_plane_vector, distance_times_all,
            "d (f + (s - 1/2) w r + (t - 1/2) h u)",
            "the steps across and up are multiplied by d as well. The size of the plane does not "
            "depend on its distance.",
            "right if d = 1; if not, too small or too large"),
    MISTAKE("G-length", image_plane_vector, of_length_1, "the unit vector in that direction",
            "the direction is right, but the vector no longer ends on the plane. Its length must "
            "be the distance to the point.",
            "the same picture; only distances along the rays differ"),
    MISTAKE("G-one", image_plane_vector, divided_by_distance, "1/d of the vector",
            "the direction is right, but the vector ends at distance 1 and not on the plane.",
            "the same picture; only distances along the rays differ"),
    MISTAKE("G-number", image_plane_vector, numbers_plus_vector, "d f + (s - 1/2) w + (t - 1/2) h",
            "adding a number to a vector adds it to every component. To move across or up, "
            "multiply r or u by the number.",
            "stripes: every step goes in the same direction"),
    MISTAKE("G-axes", image_plane_vector, axes_of_the_world, "((s - 1/2) w, (t - 1/2) h, d)",
            "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
            "right for the deck's camera; turning the camera changes nothing"),
    {0},
};
