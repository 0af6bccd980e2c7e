// mistakes-highlights.h - slips in both highlights: a wrong use of the right cosine.
#ifndef TESTS_07_SHADING_MISTAKES_HIGHLIGHTS_H
#define TESTS_07_SHADING_MISTAKES_HIGHLIGHTS_H

#include "tests/07-shading/mistakes.h"

// One highlight. cosine is the one that is raised to the power of shine; low is that of the normal
// and the direction to the light.
typedef struct {
    double ks, shine;
    Color light;
    double cosine, low;
} Highlight;

static inline Color as_it_should_be(Highlight h)
{
    return h.low > 0 && h.cosine > 0 ? h.ks * pow(h.cosine, h.shine) * h.light : grey(0);
}

static inline double power(Highlight h)
{
    return h.low > 0 && h.cosine > 0 ? pow(h.cosine, h.shine) : 0;
}

// The slips, each for both.
#define SLIPS(SLIP)                                                                                \
    SLIP(light_behind_forgotten,                                                                   \
         return h.cosine > 0 ? h.ks * pow(h.cosine, h.shine) * h.light : grey(0))                  \
    SLIP(negative_forgotten, return h.low > 0 ? h.ks * pow(h.cosine, h.shine) * h.light : grey(0)) \
    SLIP(both_forgotten, return h.ks * pow(h.cosine, h.shine) * h.light)                           \
    SLIP(no_sign, return h.low > 0 ? h.ks * pow(fabs(h.cosine), h.shine) * h.light : grey(0))      \
    SLIP(no_sign_at_all, return h.ks * pow(fabs(h.cosine), h.shine) * h.light)                     \
    SLIP(reversed, return as_it_should_be((Highlight){h.ks, h.shine, h.light, -h.cosine, h.low}))  \
    SLIP(ks_forgotten, return power(h) * h.light)                                                  \
    SLIP(ks_twice, return h.ks * h.ks * power(h) * h.light)                                        \
    SLIP(ks_less_1, return (1 - h.ks) * power(h) * h.light)                                        \
    SLIP(light_forgotten, return h.ks * grey(power(h)))                                            \
    SLIP(light_added, return power(h) > 0 ? h.ks * (grey(power(h)) + h.light) : grey(0))           \
    SLIP(grey_light, return h.ks * grey(power(h) * (h.light[0] + h.light[1] + h.light[2]) / 3))    \
    SLIP(power_forgotten, return power(h) > 0 ? h.ks * h.cosine * h.light : grey(0))               \
    SLIP(multiplied, return power(h) > 0 ? h.ks * h.cosine * h.shine * h.light : grey(0))          \
    SLIP(power_outside, return power(h) > 0 ? pow(h.ks * h.cosine, h.shine) * h.light : grey(0))   \
    SLIP(swapped, return power(h) > 0 ? h.ks * pow(h.shine, h.cosine) * h.light : grey(0))         \
    SLIP(whole_shine,                                                                              \
         return power(h) > 0 ? h.ks * pow(h.cosine, floor(h.shine)) * h.light : grey(0))           \
    SLIP(root, return power(h) > 0 ? h.ks * pow(h.cosine, 1 / h.shine) * h.light : grey(0))        \
    SLIP(times_low, return h.ks * power(h) * h.low * h.light)                                      \
    SLIP(as_much_as_scattered, return h.ks * (h.shine + 2) / (2 * PI) * power(h) * h.light)        \
    SLIP(clipped, return vec3_of(fmin(1, h.ks * power(h) * h.light[0]),                            \
                                 fmin(1, h.ks * power(h) * h.light[1]),                            \
                                 fmin(1, h.ks * power(h) * h.light[2])))

#define SLIP_FUNCTION(slip, statement)                                                             \
    static Color slip(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)                \
    {                                                                                              \
        Highlight h = {ks, shine, light, cosine_to_power(n, l, e), vec3_dot(n, vec3_unit(l))};     \
        statement;                                                                                 \
    }

// Another cosine, and the rest right.
#define OTHER_COSINE(slip, other)                                                                  \
    static Color slip(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)                \
    {                                                                                              \
        (void)l, (void)e;                                                                          \
        return as_it_should_be((Highlight){ks, shine, light, other, vec3_dot(n, vec3_unit(l))});   \
    }

// Their rows of the table: which is "PH" or "HW", exercise a string, because its name would already
// be replaced by the reference's.
#define ROW(id, exercise, answer, formula, why, picture)                                           \
    {                                                                                              \
        id, exercise, (AnyFunction *)(answer), formula, why, picture                               \
    }
#define ROWS_OF_SLIPS(which, exercise, cosine)                                                     \
    ROW(which "-behind", exercise, light_behind_forgotten, "no test for n.l > 0",                  \
        "a light behind the surface does not reach it, whatever " cosine " is.",                   \
        "highlights on the dark side"),                                                            \
        ROW(which "-negative", exercise, negative_forgotten, "no test for " cosine " > 0",         \
            "an even power of a negative cosine is positive, and a power that is not a whole "     \
            "number is NaN.",                                                                      \
            "a second highlight where there should be none, or black specks"),                     \
        ROW(which "-tests", exercise, both_forgotten, "neither n.l > 0 nor " cosine " > 0",        \
            "a light behind the surface does not reach it; and an even power of a negative "       \
            "cosine is positive.",                                                                 \
            "highlights on the dark side, or black specks"),                                       \
        ROW(which "-abs", exercise, no_sign, "|" cosine "|",                                       \
            "a negative cosine means an angle of more than 90 degrees, without a highlight.",      \
            "a second highlight where there should be none"),                                      \
        ROW(which "-abs-tests", exercise, no_sign_at_all, "|" cosine "|, whatever n.l",            \
            "a negative cosine means an angle of more than 90 degrees, and a light behind the "    \
            "surface does not reach it.",                                                          \
            "highlights on all sides"),                                                            \
        ROW(which "-ks", exercise, ks_forgotten, "ks left out",                                    \
            "only ks of the light is reflected like this.", "highlights too bright"),              \
        ROW(which "-ks-twice", exercise, ks_twice, "ks^2", "ks is a share: multiply by it once.",  \
            "highlights too dark"),                                                                \
        ROW(which "-ks-less-1", exercise, ks_less_1, "1 - ks",                                     \
            "ks is the share that is reflected, not the rest.",                                    \
            "dull surfaces with bright highlights, and polished ones without"),                    \
        ROW(which "-light", exercise, light_forgotten, "the light left out",                       \
            "a highlight is an image of the light and has its colour.",                            \
            "white highlights, whatever the light"),                                               \
        ROW(which "-plus", exercise, light_added, "power + light",                                 \
            "the power is the share of the light that is seen: multiply the light by it.",         \
            "highlights as large as half of the sphere"),                                          \
        ROW(which "-grey", exercise, grey_light, "the mean of the light",                          \
            "a highlight is an image of the light and has its colour.", "grey highlights"),        \
        ROW(which "-power", exercise, power_forgotten, "shine left out",                           \
            "the power makes the highlight small.", "highlights that are wide and dull"),          \
        ROW(which "-times", exercise, multiplied, cosine " times shine",                           \
            "the cosine is raised to the power of shine: pow.",                                    \
            "wide highlights, and too bright"),                                                    \
        ROW(which "-outside", exercise, power_outside, "(ks (" cosine "))^shine",                  \
            "only the cosine is raised to the power, without ks.", "hardly any highlights"),       \
        ROW(which "-swapped", exercise, swapped, "shine^(" cosine ")",                             \
            "the first argument of pow is the base, the second the exponent.",                     \
            "discs that are too bright"),                                                          \
        ROW(which "-whole", exercise, whole_shine, "shine without its fraction",                   \
            "shine is a double, and need not be a whole number: pow accepts any.",                 \
            "highlights a little too large"),                                                      \
        ROW(which "-root", exercise, root, "(" cosine ")^(1 / shine)",                             \
            "this is a root, and makes the highlight large instead of small.",                     \
            "highlights that cover half of the sphere"),                                           \
        ROW(which "-low", exercise, times_low, "times n.l",                                        \
            "the cosine n.l belongs to the diffuse term. A mirror reflects all of the light.",     \
            "highlights that fade towards the edge"),                                              \
        ROW(which "-energy", exercise, as_much_as_scattered, "times (shine + 2) / (2 pi)",         \
            "this keeps the sum of all light constant, in later models. Here there is only "       \
            "ks.",                                                                                 \
            "small highlights, and too bright"),                                                   \
        ROW(which "-clip", exercise, clipped, "no more than 1",                                    \
            "light is clamped once, at the end, by clamp_color.",                                  \
            "no visible difference at first; sums of bright lights come out too dark")

#endif
