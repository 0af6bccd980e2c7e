// mistakes-clamp.c - wrong ways to make a colour fit. In formulas c is each of its three numbers.
#include "tests/07-shading/mistakes.h"

static double largest(Color c)
{
    return fmax(c[0], fmax(c[1], c[2]));
}

// The same for each of the three.
#define EACH(name, statement)                                                                      \
    static double name##_number(double c)                                                          \
    {                                                                                              \
        statement;                                                                                 \
    }                                                                                              \
    static Color name(Color c)                                                                     \
    {                                                                                              \
        return vec3_of(name##_number(c[0]), name##_number(c[1]), name##_number(c[2]));             \
    }

EACH(as_it_is, return c)
EACH(only_above, return fmin(1, c))
EACH(only_below, return fmax(0, c))
EACH(limits_swapped, return fmin(0, fmax(1, c)))
EACH(limits_swapped_otherwise, return fmax(1, fmin(0, c)))
EACH(wrapped, return c - floor(c))
EACH(above_wrapped, return c < 0 ? 0 : c > 1 ? c - floor(c) : c)
EACH(above_is_black, return c < 0 || c > 1 ? 0 : c)
EACH(below_is_white, return c < 0 || c > 1 ? 1 : c)
EACH(no_sign, return fmin(1, fabs(c)))
EACH(up_to_255, return fmin(255, fmax(0, c)))
EACH(up_to_255_times, return 255 * fmin(1, fmax(0, c)))
EACH(from_minus_1, return fmin(1, fmax(-1, c)))
EACH(rounded, return c < 0.5 ? 0 : 1)
EACH(compressed, return fmax(0, c) / (1 + fmax(0, c)))
EACH(exposed, return 1 - exp(-fmax(0, c)))

static Color by_the_largest(Color c)
{
    return largest(c) > 1 ? c / largest(c) : c;
}

static Color by_the_largest_and_not_below(Color c)
{
    return only_below(by_the_largest(c));
}

static Color always_by_the_largest(Color c)
{
    return c / largest(c);
}

static Color length_of_1(Color c)
{
    return vec3_length(c) > 1 ? vec3_unit(c) : c;
}

static Color only_red(Color c)
{
    return vec3_of(fmin(1, fmax(0, c[0])), c[1], c[2]);
}

static Color all_but_blue(Color c)
{
    return vec3_of(fmin(1, fmax(0, c[0])), fmin(1, fmax(0, c[1])), c[2]);
}

static Color all_white(Color c)
{
    return largest(c) > 1 ? vec3_of(1, 1, 1) : only_below(c);
}

static Color white_or_black(Color c)
{
    if (largest(c) > 1)
        return vec3_of(1, 1, 1);
    return c[0] < 0 || c[1] < 0 || c[2] < 0 ? vec3_of(0, 0, 0) : c;
}

const Mistake clamp_mistakes[] = {
    MISTAKE("S7", clamp_color, as_it_is, "c unchanged",
            "a number above 1 or below 0 does not fit into a pixel.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("S7-above", clamp_color, only_above, "min(1, c)",
            "a number below 0 does not fit into a pixel either.",
            "speckles of wrong colours in the darkest spots"),
    MISTAKE("S7-below", clamp_color, only_below, "max(0, c)",
            "a number above 1 does not fit into a pixel either.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("CL-0", clamp_color, limits_swapped, "0, whatever c is",
            "min(0, max(1, c)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' "
            "is min(1, ...).",
            "a black picture"),
    MISTAKE("CL-1", clamp_color, limits_swapped_otherwise, "1, whatever c is",
            "max(1, min(0, c)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' "
            "is min(1, ...).",
            "a white picture"),
    MISTAKE("CL-wrap", clamp_color, wrapped, "c - floor(c)",
            "a number a little above 1 starts again at 0.", "dark speckles in the brightest spots"),
    MISTAKE("CL-wrap-above", clamp_color, above_wrapped, "c - floor(c) above 1",
            "a number a little above 1 starts again at 0.", "dark speckles in the brightest spots"),
    MISTAKE("CL-black", clamp_color, above_is_black, "0 if c does not fit",
            "a number that is too bright is nearest to 1, not to 0.",
            "black holes in the brightest spots"),
    MISTAKE("CL-white", clamp_color, below_is_white, "1 if c does not fit",
            "a number below 0 is nearest to 0, not to 1.", "white speckles in the darkest spots"),
    MISTAKE("CL-abs", clamp_color, no_sign, "min(1, |c|)",
            "a negative amount of light is nearest to 0: |c| makes light of it.",
            "bright speckles in the darkest spots"),
    MISTAKE("CL-255", clamp_color, up_to_255, "at most 255",
            "colours go from 0 to 1 here; the image converts them to bytes.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("CL-255-times", clamp_color, up_to_255_times, "255 c",
            "colours go from 0 to 1 here; the image converts them to bytes.",
            "everything that is not black is too bright"),
    MISTAKE("CL-minus", clamp_color, from_minus_1, "at least -1",
            "colours start at 0; cosines start at -1.",
            "speckles of wrong colours in the darkest spots"),
    MISTAKE("CL-round", clamp_color, rounded, "0 or 1, whichever is nearer",
            "a number in between fits, and must not change.", "a poster of eight colours"),
    MISTAKE("CL-compress", clamp_color, compressed, "c / (1 + c)",
            "this also changes colours that fit. A number between 0 and 1 must not change.",
            "a dull picture"),
    MISTAKE("CL-expose", clamp_color, exposed, "1 - e^-c",
            "this also changes colours that fit. A number between 0 and 1 must not change.",
            "a dull picture"),
    MISTAKE("CL-scale", clamp_color, by_the_largest, "divided by the largest, if that is above 1",
            "this also darkens the other two. Each number is clamped by itself.",
            "highlights in the colour of the surface"),
    MISTAKE("CL-scale-0", clamp_color, by_the_largest_and_not_below,
            "divided by the largest above 1, and at least 0",
            "this also darkens the other two. Each number is clamped by itself.",
            "highlights in the colour of the surface"),
    MISTAKE("CL-scale-all", clamp_color, always_by_the_largest, "divided by the largest",
            "this also changes colours that fit, and makes every pixel as bright as possible.",
            "spheres without a dark side"),
    MISTAKE("CL-length", clamp_color, length_of_1, "normalised if it is longer than 1",
            "a colour is not a direction: each of its numbers may be up to 1 by itself.",
            "a picture without white"),
    MISTAKE("CL-red", clamp_color, only_red, "only red clamped", "all three must fit.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("CL-two", clamp_color, all_but_blue, "blue left out",
            "three numbers are 0, 1 and 2: the loop ends too early.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("CL-all", clamp_color, all_white, "all white if one is above 1",
            "each number is clamped by itself, and the others do not change.",
            "white spots with hard edges"),
    MISTAKE("CL-all-both", clamp_color, white_or_black,
            "all white or all black if one does not fit",
            "each number is clamped by itself, and the others do not change.",
            "white and black spots with hard edges"),
    {0},
};
