// mistakes-gamma.c - wrong ways to encode for a gamma. In formulas c is each of the three
// numbers.
#include "tests/07-shading/mistakes.h"

#define GAMMA(name, statement)                                                                     \
    static double name##_number(double c, double gamma, int i)                                     \
    {                                                                                              \
        (void)gamma, (void)i;                                                                      \
        statement;                                                                                 \
    }                                                                                              \
    static Color gamma_##name(Color c, double gamma)                                               \
    {                                                                                              \
        return vec3_of(name##_number(c[0], gamma, 0), name##_number(c[1], gamma, 1),               \
                       name##_number(c[2], gamma, 2));                                             \
    }

static double srgb(double c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

GAMMA(of_the_display, return pow(c, gamma))
GAMMA(times, return c * gamma)
GAMMA(through, return c / gamma)
GAMMA(hard_wired, return pow(c, 1 / 2.2))
GAMMA(square_root, return sqrt(c))
GAMMA(nothing, return c)
GAMMA(minus, return pow(c, -gamma))
GAMMA(swapped, return pow(1 / gamma, c))
GAMMA(swapped_too, return pow(gamma, c))
GAMMA(whole, return pow(c, 1 / floor(gamma + 0.5)))
GAMMA(integers, return pow(c, gamma > 1 ? 0 : 1 / gamma))
GAMMA(twice, return pow(pow(c, 1 / gamma), 1 / gamma))
GAMMA(of_srgb, return srgb(c))
GAMMA(turned_round, return 1 - pow(1 - c, gamma))
GAMMA(inverted, return 1 - pow(c, 1 / gamma))
GAMMA(bytes, return 255 * pow(c, 1 / gamma))
GAMMA(bytes_in, return pow(c / 255, 1 / gamma))
GAMMA(bytes_both, return 255 * pow(c / 255, 1 / gamma))
GAMMA(only_red, return i == 0 ? pow(c, 1 / gamma) : c)
GAMMA(all_but_blue, return i < 2 ? pow(c, 1 / gamma) : c)

static Color gamma_of_the_mean(Color c, double gamma)
{
    double mean = (c[0] + c[1] + c[2]) / 3;
    return mean > 0 ? c / mean * pow(mean, 1 / gamma) : c;
}

static Color gamma_of_the_length(Color c, double gamma)
{
    double length = vec3_length(c);
    return length > 0 ? c / length * pow(length, 1 / gamma) : c;
}

const Mistake gamma_mistakes[] = {
    MISTAKE("GA-wrong-way", gamma_encode, gamma_of_the_display, "c^gamma",
            "that is what the display does. To make up for it, the power is 1 / gamma.",
            "everything too dark"),
    MISTAKE("GA-times", gamma_encode, gamma_times, "gamma c", "gamma is a power, not a factor.",
            "everything too bright, with white areas"),
    MISTAKE("GA-through", gamma_encode, gamma_through, "c / gamma",
            "gamma is a power, not a factor.", "everything too dark"),
    MISTAKE("GA-2.2", gamma_encode, gamma_hard_wired, "c^(1 / 2.2), whatever gamma",
            "most displays have 2.2, but gamma is an argument: use it.",
            "the same picture, whatever the gamma"),
    MISTAKE("GA-2", gamma_encode, gamma_square_root, "sqrt(c), whatever gamma",
            "this is right for a gamma of 2, but gamma is an argument: use it.",
            "the same picture, whatever the gamma"),
    MISTAKE("GA-none", gamma_encode, gamma_nothing, "c unchanged",
            "this is right only for a gamma of 1.", "everything too dark, as without gamma"),
    MISTAKE("GA-minus", gamma_encode, gamma_minus, "c^(-gamma)",
            "a negative power is 1 divided by that power. The inverse of a power is the root: 1 / "
            "gamma.",
            "a white picture"),
    MISTAKE("GA-swapped", gamma_encode, gamma_swapped, "(1 / gamma)^c",
            "the first argument of pow is the base, the second the exponent.",
            "a negative, pale and grey"),
    MISTAKE("GA-swapped-too", gamma_encode, gamma_swapped_too, "gamma^c",
            "the first argument of pow is the base, the second the exponent; and the exponent is 1 "
            "/ gamma.",
            "a white picture"),
    MISTAKE("GA-whole", gamma_encode, gamma_whole, "gamma rounded to an integer",
            "gamma is a double, 2.2 for example.", "everything a little too dark or too bright"),
    MISTAKE("GA-integers", gamma_encode, gamma_integers, "1 / gamma in integers",
            "in integers 1 / 2 is 0, and every number to the power of 0 is 1.", "a white picture"),
    MISTAKE("GA-twice", gamma_encode, gamma_twice, "encoded twice",
            "the display undoes it only once.", "a pale picture"),
    MISTAKE("GA-srgb", gamma_encode, gamma_of_srgb, "the curve of sRGB, whatever gamma",
            "this is close to a gamma of 2.2, but gamma is an argument: use it.",
            "the same picture, whatever the gamma"),
    MISTAKE("GA-inverted", gamma_encode, gamma_inverted, "1 - c^(1 / gamma)",
            "black stays black, and white stays white.", "a negative"),
    MISTAKE("GA-turned", gamma_encode, gamma_turned_round, "1 - (1 - c)^gamma",
            "this is brighter as well, but the display does not undo it. It undoes c^(1 / gamma).",
            "bright parts too bright"),
    MISTAKE("GA-255", gamma_encode, gamma_bytes, "255 c^(1 / gamma)",
            "colours go from 0 to 1 here; the image converts them to bytes.",
            "everything that is not black is too bright"),
    MISTAKE("GA-255-in", gamma_encode, gamma_bytes_in, "(c / 255)^(1 / gamma)",
            "colours already go from 0 to 1.", "a picture far too dark"),
    MISTAKE("GA-255-both", gamma_encode, gamma_bytes_both, "255 (c / 255)^(1 / gamma)",
            "colours already go from 0 to 1.", "everything that is not black is too bright"),
    MISTAKE("GA-red", gamma_encode, gamma_only_red, "only red encoded",
            "the display does the same to all three.", "a reddish picture"),
    MISTAKE("GA-two", gamma_encode, gamma_all_but_blue, "blue left out",
            "three numbers are 0, 1 and 2: the loop ends too early.", "a yellowish picture"),
    MISTAKE("GA-mean", gamma_encode, gamma_of_the_mean, "the mean encoded, the hue kept",
            "the display raises each of the three to the power by itself.",
            "colours that are too strong"),
    MISTAKE(
        "GA-length", gamma_encode, gamma_of_the_length, "the length encoded",
        "a colour is not a direction. The display raises each of the three to the power by itself.",
        "colours that are too strong"),
    {0},
};
