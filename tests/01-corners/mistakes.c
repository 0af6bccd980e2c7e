// mistakes.c - wrong answers to exercise 01: cameras of unit distance, and the list of all tables.
#include "exercises/01-corners.h"
#include "tests/judge/mistake.h"

extern const Mistake corner_size_mistakes[], corner_way_mistakes[];
extern const Mistake across_mistakes[], place_mistakes[], place_ahead_mistakes[],
    place_limit_mistakes[];

// The right answer, for mistakes that change it afterwards.
static Camera width_and_height_divided(Camera c)
{
    c.width /= c.distance;
    c.height /= c.distance;
    return c;
}

static Camera left_as_it_was(Camera c)
{
    return c;
}

static Camera only_the_distance(Camera c)
{
    c.distance = 1;
    return c;
}

static Camera only_the_width(Camera c)
{
    c.width /= c.distance;
    c.distance = 1;
    return c;
}

static Camera only_the_height(Camera c)
{
    c.height /= c.distance;
    c.distance = 1;
    return c;
}

static Camera distance_left(Camera c)
{
    return width_and_height_divided(c);
}

static Camera times_the_distance(Camera c)
{
    c.width *= c.distance;
    c.height *= c.distance;
    c.distance = 1;
    return c;
}

static Camera fractions_upside_down(Camera c)
{
    c.width = c.distance / c.width;
    c.height = c.distance / c.height;
    c.distance = 1;
    return c;
}

static Camera halved(Camera c)
{
    c.width /= 2;
    c.height /= 2;
    c.distance = 1;
    return c;
}

static Camera doubled(Camera c)
{
    c.width *= 2;
    c.height *= 2;
    c.distance *= 2;
    return c;
}

static Camera sizes_swapped(Camera c)
{
    double width = c.width;
    c.width = c.height / c.distance;
    c.height = width / c.distance;
    c.distance = 1;
    return c;
}

static Camera width_for_both(Camera c)
{
    c.width /= c.distance;
    c.height = c.width;
    c.distance = 1;
    return c;
}

static Camera eye_moved_to_the_plane(Camera c)
{
    c = width_and_height_divided(c);
    c.origin += (c.distance - 1) * c.forward;
    c.distance = 1;
    return c;
}

static Camera eye_divided(Camera c)
{
    c = width_and_height_divided(c);
    c.origin /= c.distance;
    c.distance = 1;
    return c;
}

static Camera forward_divided(Camera c)
{
    c = width_and_height_divided(c);
    c.forward /= c.distance;
    c.distance = 1;
    return c;
}

static Camera forward_times_distance(Camera c)
{
    c = width_and_height_divided(c);
    c.forward *= c.distance;
    c.distance = 1;
    return c;
}

static const Mistake unit_distance_mistakes[] = {
    MISTAKE("D-same", with_unit_distance, left_as_it_was, "d, w, h as they were",
            "the camera is returned unchanged. If you changed a copy of it, return the copy.",
            "the same picture, but d is still not 1"),
    MISTAKE("D-only", with_unit_distance, only_the_distance, "1, w, h",
            "the plane comes nearer but keeps its size. If you divide after setting d to 1, you "
            "divide by 1.",
            "a wider view if d was more than 1"),
    MISTAKE("D-w", with_unit_distance, only_the_width, "1, w/d, h",
            "the height is unchanged, so the plane changes its shape. If you set d to 1 in "
            "between, you divide by 1.",
            "everything squashed if d was more than 1"),
    MISTAKE("D-h", with_unit_distance, only_the_height, "1, w, h/d",
            "the width is unchanged, so the plane changes its shape.",
            "everything narrower if d was more than 1"),
    MISTAKE("D-left", with_unit_distance, distance_left, "d, w/d, h/d",
            "the plane shrinks but stays at its distance. d must become 1.",
            "a narrower view if d was more than 1"),
    MISTAKE("D-times", with_unit_distance, times_the_distance, "1, w d, h d",
            "a plane that comes nearer must shrink to fill the same view; this one grows.",
            "a much wider view if d was more than 1"),
    MISTAKE("D-over", with_unit_distance, fractions_upside_down, "1, d/w, d/h",
            "the fractions are upside down. A wider plane would give a narrower view.",
            "another view, of another shape"),
    MISTAKE("D-half", with_unit_distance, halved, "1, w/2, h/2",
            "halving is right only if d was 2. How much the plane shrinks depends on its distance.",
            "right if d = 2; if not, a narrower or wider view"),
    MISTAKE("D-double", with_unit_distance, doubled, "2 d, 2 w, 2 h",
            "this shows that doubling does not matter; but the exercise asks for the camera with d "
            "= 1.",
            "the same picture, but d is not 1"),
    MISTAKE("D-sizes", with_unit_distance, sizes_swapped, "1, h/d, w/d", "w and h are swapped.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("D-width", with_unit_distance, width_for_both, "1, w/d, w/d",
            "the width is used both times. The plane must keep its shape.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("D-eye", with_unit_distance, eye_moved_to_the_plane, "1, w/d, h/d and p + (d - 1) f",
            "the eye has moved. The same picture is seen from the same eye: only the plane moves.",
            "other objects hide each other; near ones are larger"),
    MISTAKE("D-p", with_unit_distance, eye_divided, "1, w/d, h/d and p/d",
            "the eye has moved. The plane shrinks towards the eye, but the world does not.",
            "right if the eye is at the origin; if not, another view"),
    MISTAKE("D-f", with_unit_distance, forward_divided, "1, w/d, h/d and f/d",
            "f is a direction and keeps its length 1. d alone says how far away the plane is.",
            "a wider view if d was more than 1"),
    MISTAKE("D-d-f", with_unit_distance, forward_times_distance, "1, w/d, h/d and d f",
            "f is a direction and keeps its length 1. Now the plane is as far away as before, but "
            "smaller.",
            "a narrower view if d was more than 1"),
    {0},
};

static const Mistake *const mistakes[] = {
    corner_size_mistakes, corner_way_mistakes,    across_mistakes,      place_mistakes,
    place_ahead_mistakes, unit_distance_mistakes, place_limit_mistakes, NULL};
OF_STEM(mistakes)
