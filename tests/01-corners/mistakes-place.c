// mistakes-place.c - wrong vectors to any place of the image plane: wrong across and up.
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
            "the steps start from the middle, but s and t start at the lower left corner. If your "
            "code has 1 / 2: in C that is an integer division, and its result is 0.",
            "the middle of the view in the lower left corner"),
    MISTAKE("G-s", image_plane_vector, s_from_the_middle, "d f + s w r + (t - 1/2) h u",
            "s starts from the middle here, but it must start at the left edge.",
            "shifted sideways by half a picture"),
    MISTAKE("G-t", image_plane_vector, t_from_the_middle, "d f + (s - 1/2) w r + t h u",
            "t starts from the middle here, but it must start at the bottom.",
            "shifted upward by half a picture"),
    MISTAKE("G-plus", image_plane_vector, half_added, "d f + (s + 1/2) w r + (t + 1/2) h u",
            "here s = t = 0 is the upper right corner. s = t = 1/2 must be straight ahead.",
            "shifted by a whole picture: blank, or the scene beside the view"),
    MISTAKE("G-over", image_plane_vector, up_from_the_top, "d f + (s - 1/2) w r + (t + 1/2) h u",
            "t starts at the top edge here, but it must start at the bottom.",
            "shifted upward by a whole picture"),
    MISTAKE("G-down", image_plane_vector, t_downward, "d f + (s - 1/2) w r - (t - 1/2) h u",
            "t grows upward, as u does. Here t = 0 is at the top.", "upside down"),
    MISTAKE("G-mirror", image_plane_vector, s_leftward, "d f - (s - 1/2) w r + (t - 1/2) h u",
            "s grows to the right, as r does. Here s = 0 is at the right edge.",
            "mirrored: left and right swapped"),
    MISTAKE("G-turned", image_plane_vector, both_turned_over, "d f - (s - 1/2) w r - (t - 1/2) h u",
            "both signs are reversed. Here s and t start at the upper right corner.",
            "turned by 180 degrees"),
    MISTAKE("G-swap", image_plane_vector, s_and_t_swapped, "d f + (t - 1/2) w r + (s - 1/2) h u",
            "s goes across and t goes up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("G-ru", image_plane_vector, right_and_up_swapped, "d f + (s - 1/2) w u + (t - 1/2) h r",
            "r points across and u points up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("G-ss", image_plane_vector, s_for_both, "d f + (s - 1/2) w r + (s - 1/2) h u",
            "s is used for both, so the vector stays on the diagonal of the plane. How far up it "
            "goes is t.",
            "stripes from top to bottom: all rows are alike"),
    MISTAKE("G-unit", image_plane_vector, shares_of_1, "d f + (s - 1/2) r + (t - 1/2) u",
            "s and t are shares, without a unit. The length of a share depends on the size of the "
            "plane.",
            "right if w = h = 1; if not, a narrower or wider view"),
    MISTAKE("G-half", image_plane_vector, shares_of_the_half,
            "d f + (s - 1/2) w/2 r + (t - 1/2) h/2 u",
            "halved twice. This goes only half as far across and up as the edges are.",
            "everything at twice its size"),
    MISTAKE("G-twice", image_plane_vector, from_minus_1_to_1, "d f + (2 s - 1) w r + (2 t - 1) h u",
            "from -1 to 1 is two widths. From its left edge to its right edge the plane is only w "
            "wide.",
            "everything at half its size"),
    MISTAKE("G-order", image_plane_vector, half_a_unit_less, "d f + (s w - 1/2) r + (t h - 1/2) u",
            "s w is a length and 1/2 is a share. Subtract half of the plane, not half a unit.",
            "right if w = h = 1; if not, shifted"),
    MISTAKE("G-w", image_plane_vector, width_for_both, "d f + (s - 1/2) w r + (t - 1/2) w u",
            "the width is used both times. t is a share of the height.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("G-h", image_plane_vector, height_for_both, "d f + (s - 1/2) h r + (t - 1/2) h u",
            "the height is used both times. s is a share of the width.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("G-sizes", image_plane_vector, sizes_swapped, "d f + (s - 1/2) h r + (t - 1/2) w u",
            "w is the length along r and h the length along u. Here they are swapped.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("G-clamp", image_plane_vector, held_on_the_plane, "s and t limited to 0..1",
            "beyond the edges the same formula holds; there is no limit.",
            "the same picture; beyond the edges, the edge is repeated"),
    {0},
};
