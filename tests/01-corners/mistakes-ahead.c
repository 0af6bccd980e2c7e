// mistakes-ahead.c - wrong ways to any place of the image plane: ahead, or with other directions.
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
            "f is one unit long, and the plane is not 1 ahead.",
            "right where d = 1; elsewhere as if through another lens"),
    MISTAKE("G-flat", image_plane_vector, nothing_ahead, "(s - 1/2) w r + (t - 1/2) h u",
            "no step ahead. This stays beside the eye and never reaches the plane.",
            "blank: the rays run off sideways"),
    MISTAKE("G-back", image_plane_vector, behind_the_eye, "-d f + (s - 1/2) w r + (t - 1/2) h u",
            "f points ahead, to the plane. This goes behind the eye.",
            "blank, or what is behind the camera, mirrored"),
    MISTAKE("G-p", image_plane_vector, point_for_vector, "p + d f + (s - 1/2) w r + (t - 1/2) h u",
            "that is the place as a point of the world. The way there from the eye does not depend "
            "on where the eye is.",
            "right with the eye at the origin; elsewhere it looks off to one side"),
    MISTAKE("G-minus-p", image_plane_vector, point_minus_eye,
            "d f + (s - 1/2) w r + (t - 1/2) h u - p",
            "the walk begins in the eye, so there is no eye left to take off.",
            "right with the eye at the origin; elsewhere it looks off to one side"),
    MISTAKE("G-times", image_plane_vector, distance_times_all,
            "d (f + (s - 1/2) w r + (t - 1/2) h u)",
            "the steps aside are multiplied by d as well. The size of the plane does not depend on "
            "how far away it is.",
            "right where d = 1; elsewhere too small or too large"),
    MISTAKE("G-length", image_plane_vector, of_length_1, "the unit vector that way",
            "the direction is right, but it no longer ends on the plane. It is to be as long as "
            "the way there.",
            "the same picture; only distances along the rays differ"),
    MISTAKE("G-one", image_plane_vector, divided_by_distance, "1/d of the vector",
            "the direction is right, but it ends 1 ahead of the eye and not on the plane.",
            "the same picture; only distances along the rays differ"),
    MISTAKE("G-number", image_plane_vector, numbers_plus_vector, "d f + (s - 1/2) w + (t - 1/2) h",
            "a number plus a vector adds it to every component. To go so far across or up takes a "
            "product with r or u.",
            "stripes: every step leads the same way"),
    MISTAKE(
        "G-axes", image_plane_vector, axes_of_the_world, "((s - 1/2) w, (t - 1/2) h, d)",
        "these steps go along the axes of the world. The camera has axes of its own: r, u and f.",
        "right for the deck's camera; turning the camera changes nothing"),
    {0},
};
