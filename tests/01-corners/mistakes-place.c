// mistakes-place.c - wrong ways to any place of the image plane: across and up.
#include "exercises/01-corners.h"
#include "tests/judge/mistake.h"

static vec3 from_the_middle(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up;
}

static vec3 s_from_the_middle(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 t_from_the_middle(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + t * c.height * c.up;
}

static vec3 half_added(Camera c, double s, double t)
{
    return c.distance * c.forward + (s + 0.5) * c.width * c.right + (t + 0.5) * c.height * c.up;
}

static vec3 up_from_the_top(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t + 0.5) * c.height * c.up;
}

static vec3 t_downward(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right - (t - 0.5) * c.height * c.up;
}

static vec3 s_leftward(Camera c, double s, double t)
{
    return c.distance * c.forward - (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 both_turned_over(Camera c, double s, double t)
{
    return c.distance * c.forward - (s - 0.5) * c.width * c.right - (t - 0.5) * c.height * c.up;
}

static vec3 s_and_t_swapped(Camera c, double s, double t)
{
    return c.distance * c.forward + (t - 0.5) * c.width * c.right + (s - 0.5) * c.height * c.up;
}

static vec3 right_and_up_swapped(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.up + (t - 0.5) * c.height * c.right;
}

static vec3 s_for_both(Camera c, double s, double t)
{
    (void)t;
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (s - 0.5) * c.height * c.up;
}

static vec3 shares_of_1(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.right + (t - 0.5) * c.up;
}

static vec3 shares_of_the_half(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width / 2 * c.right +
           (t - 0.5) * c.height / 2 * c.up;
}

static vec3 from_minus_1_to_1(Camera c, double s, double t)
{
    return c.distance * c.forward + (2 * s - 1) * c.width * c.right + (2 * t - 1) * c.height * c.up;
}

static vec3 half_a_unit_less(Camera c, double s, double t)
{
    return c.distance * c.forward + (s * c.width - 0.5) * c.right + (t * c.height - 0.5) * c.up;
}

static vec3 width_for_both(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.width * c.up;
}

static vec3 height_for_both(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.height * c.right + (t - 0.5) * c.height * c.up;
}

static vec3 sizes_swapped(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.height * c.right + (t - 0.5) * c.width * c.up;
}

static vec3 held_on_the_plane(Camera c, double s, double t)
{
    s = fmin(fmax(s, 0), 1);
    t = fmin(fmax(t, 0), 1);
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

const Mistake place_mistakes[] = {
    MISTAKE("G-middle", image_plane_vector, from_the_middle, "d f + s w r + t h u",
            "counted from the middle, but s and t begin at the lower left corner. If a 1 / 2 "
            "stands in your code: of whole numbers it is 0.",
            "the middle of the view in the lower left corner"),
    MISTAKE("G-s", image_plane_vector, s_from_the_middle, "d f + s w r + (t - 1/2) h u",
            "s is counted from the middle, but it begins at the left edge.",
            "shifted sideways by half a picture"),
    MISTAKE("G-t", image_plane_vector, t_from_the_middle, "d f + (s - 1/2) w r + t h u",
            "t is counted from the middle, but it begins at the bottom.",
            "shifted upward by half a picture"),
    MISTAKE("G-plus", image_plane_vector, half_added, "d f + (s + 1/2) w r + (t + 1/2) h u",
            "that begins at the upper right corner. s = 1/2 is to end straight ahead.",
            "shifted by a whole picture: blank, or what is beside the view"),
    MISTAKE("G-over", image_plane_vector, up_from_the_top, "d f + (s - 1/2) w r + (t + 1/2) h u",
            "t is counted upward from the top edge, but it begins at the bottom.",
            "shifted upward by a whole picture"),
    MISTAKE("G-down", image_plane_vector, t_downward, "d f + (s - 1/2) w r - (t - 1/2) h u",
            "t grows upward, as u does. Here t = 0 is at the top.", "upside down"),
    MISTAKE("G-mirror", image_plane_vector, s_leftward, "d f - (s - 1/2) w r + (t - 1/2) h u",
            "s grows to the right, as r does. Here s = 0 is at the right edge.",
            "mirrored: left and right swapped"),
    MISTAKE("G-turned", image_plane_vector, both_turned_over, "d f - (s - 1/2) w r - (t - 1/2) h u",
            "both signs are turned over. Here s and t begin at the upper right corner.",
            "turned by 180 degrees"),
    MISTAKE("G-swap", image_plane_vector, s_and_t_swapped, "d f + (t - 1/2) w r + (s - 1/2) h u",
            "s goes across and t goes up. Here they have changed places.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("G-ru", image_plane_vector, right_and_up_swapped, "d f + (s - 1/2) w u + (t - 1/2) h r",
            "r leads across and u upward. Here they have changed places.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("G-ss", image_plane_vector, s_for_both, "d f + (s - 1/2) w r + (s - 1/2) h u",
            "s for both, so it stays on the diagonal of the plane. How far up is t.",
            "stripes from top to bottom: all rows alike"),
    MISTAKE(
        "G-unit", image_plane_vector, shares_of_1, "d f + (s - 1/2) r + (t - 1/2) u",
        "s and t are shares, without a unit. How far a share is depends on the size of the plane.",
        "right where w = h = 1; elsewhere as if through another lens"),
    MISTAKE("G-half", image_plane_vector, shares_of_the_half,
            "d f + (s - 1/2) w/2 r + (t - 1/2) h/2 u",
            "halved twice. This goes only half as far aside as the edges are.",
            "everything at twice its size"),
    MISTAKE("G-twice", image_plane_vector, from_minus_1_to_1, "d f + (2 s - 1) w r + (2 t - 1) h u",
            "from -1 to 1 across is two planes wide. From its left edge to its right one the plane "
            "is w.",
            "everything at half its size"),
    MISTAKE("G-order", image_plane_vector, half_a_unit_less, "d f + (s w - 1/2) r + (t h - 1/2) u",
            "s w is a length and 1/2 a share. What is taken off is to be half of the plane, not "
            "half a unit.",
            "right where w = h = 1; elsewhere shifted"),
    MISTAKE("G-w", image_plane_vector, width_for_both, "d f + (s - 1/2) w r + (t - 1/2) w u",
            "the width, both times. t is a share of the height.",
            "right where w = h; elsewhere squashed or stretched"),
    MISTAKE("G-h", image_plane_vector, height_for_both, "d f + (s - 1/2) h r + (t - 1/2) h u",
            "the height, both times. s is a share of the width.",
            "right where w = h; elsewhere squashed or stretched"),
    MISTAKE("G-sizes", image_plane_vector, sizes_swapped, "d f + (s - 1/2) h r + (t - 1/2) w u",
            "w is measured along r and h along u. Here they have changed places.",
            "right where w = h; elsewhere squashed or stretched"),
    MISTAKE("G-clamp", image_plane_vector, held_on_the_plane, "s and t held in 0..1",
            "beyond the edges the formula just goes on; nothing stops it there.",
            "the same picture; beyond it the edge repeats"),
    {0},
};
