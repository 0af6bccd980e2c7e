// mistakes-terms.c - wrong ambient and diffuse terms.
#include "tests/07-shading/mistakes.h"

static Color clipped(Color color)
{
    return vec3_of(fmin(1, color[0]), fmin(1, color[1]), fmin(1, color[2]));
}

static double mean(Color color)
{
    return (color[0] + color[1] + color[2]) / 3;
}

// ---- ambient_term -------------------------------------------------------------------------------

#define AMBIENT(name, statement)                                                                   \
    static Color ambient_##name(Color surface, double kd, Color ambient)                           \
    {                                                                                              \
        (void)surface, (void)kd, (void)ambient;                                                    \
        statement;                                                                                 \
    }

AMBIENT(kd_forgotten, return surface * ambient)
AMBIENT(kd_twice, return kd * kd * surface * ambient)
AMBIENT(kd_less_1, return (1 - kd) * surface * ambient)
AMBIENT(surface_forgotten, return kd * ambient)
AMBIENT(ambient_forgotten, return kd * surface)
AMBIENT(as_it_is, return ambient)
AMBIENT(a_tenth, return 0.1 * kd * surface)
AMBIENT(added, return kd * (surface + ambient))
AMBIENT(added_behind, return kd * surface + ambient)
AMBIENT(all_added, return kd + surface + ambient)
AMBIENT(mixed, return kd * surface + (1 - kd) * ambient)
AMBIENT(dotted, return kd * grey(vec3_dot(surface, ambient)))
AMBIENT(crossed, return kd * vec3_cross(surface, ambient))
AMBIENT(grey_light, return kd * mean(ambient) * surface)
AMBIENT(red_light, return kd * ambient[0] * surface)
AMBIENT(no_brighter_than_white, return clipped(kd * surface * ambient))
AMBIENT(through_pi, return kd * surface * ambient / PI)

const Mistake ambient_mistakes[] = {
    MISTAKE("AM-kd", ambient_term, ambient_kd_forgotten, "surface * ambient",
            "only kd of the light is scattered.", "everything in shadow too bright"),
    MISTAKE("AM-kd-twice", ambient_term, ambient_kd_twice, "kd^2 * surface * ambient",
            "kd is the share that is scattered: multiply by it once.",
            "everything in shadow too dark"),
    MISTAKE("AM-kd-less-1", ambient_term, ambient_kd_less_1, "(1 - kd) * surface * ambient",
            "kd is the share that is scattered, not the rest.",
            "bright surfaces dark in the shadow, and dark ones bright"),
    MISTAKE("AM-surface", ambient_term, ambient_surface_forgotten, "kd * ambient",
            "a red surface reflects only red light: its colour is missing.",
            "all spheres the same grey in the shadow"),
    MISTAKE("AM-ambient", ambient_term, ambient_ambient_forgotten, "kd * surface",
            "without ambient light it must be black: the light is missing.",
            "flat discs, as if there were no shadow"),
    MISTAKE("AM-alone", ambient_term, ambient_as_it_is, "ambient",
            "this is the light. The surface reflects kd times its colour of it.",
            "all spheres the same grey in the shadow"),
    MISTAKE("AM-tenth", ambient_term, ambient_a_tenth, "0.1 * kd * surface",
            "a tenth of white is only the default of scenes. Use the argument.",
            "the same, however bright the ambient light"),
    MISTAKE("AM-plus", ambient_term, ambient_added, "kd * (surface + ambient)",
            "colours add up when two lights come together. A surface multiplies the light by its "
            "colour.",
            "pale shadows"),
    MISTAKE("AM-plus-behind", ambient_term, ambient_added_behind, "kd * surface + ambient",
            "colours add up when two lights come together. A surface multiplies the light by its "
            "colour.",
            "pale shadows"),
    MISTAKE("AM-plus-all", ambient_term, ambient_all_added, "kd + surface + ambient",
            "multiply by a share, and by the colour of the surface as well.",
            "nearly white spheres"),
    MISTAKE("AM-mixed", ambient_term, ambient_mixed, "kd * surface + (1 - kd) * ambient",
            "this is a mixture of two colours. A surface multiplies the light by its own colour.",
            "pale shadows"),
    MISTAKE("AM-dot", ambient_term, ambient_dotted, "kd * (surface . ambient)",
            "a dot product adds up the three colours to one number. Red stays with red: * "
            "multiplies component by component.",
            "grey shadows"),
    MISTAKE("AM-cross", ambient_term, ambient_crossed, "kd * (surface x ambient)",
            "a cross product is for directions. Red stays with red: * multiplies component by "
            "component.",
            "odd colours, and some below 0"),
    MISTAKE("AM-grey", ambient_term, ambient_grey_light, "kd * surface * (mean of ambient)",
            "the light also has a colour: red times red, green times green, blue times blue.",
            "shadows that do not take on the light's colour"),
    MISTAKE("AM-red", ambient_term, ambient_red_light, "kd * surface * ambient[0]",
            "this is only the red of the light: red times red, green times green, blue times blue.",
            "shadows that do not take on the light's colour"),
    MISTAKE("AM-clip", ambient_term, ambient_no_brighter_than_white, "no more than 1",
            "light is clamped once, at the end, by clamp_color.",
            "no visible difference at first; sums of bright lights come out too dark"),
    MISTAKE("AM-pi", ambient_term, ambient_through_pi, "kd * surface * ambient / pi",
            "some books divide by pi, with another definition of kd. Here kd is the whole share.",
            "everything in shadow too dark"),
    {0},
};

// ---- diffuse_term -------------------------------------------------------------------------------

// The cosine with the direction to the light, below 0 if that is behind.
static double cosine_of(vec3 normal, vec3 to_light)
{
    return vec3_dot(normal, vec3_unit(to_light));
}

// cosine is the right one, raw is not limited.
#define DIFFUSE(name, statement)                                                                   \
    static Color diffuse_##name(Color surface, double kd, Color light, vec3 n, vec3 l)             \
    {                                                                                              \
        double raw = cosine_of(n, l), cosine = fmax(0, raw);                                       \
        (void)surface, (void)kd, (void)light, (void)cosine;                                        \
        statement;                                                                                 \
    }

DIFFUSE(reversed, return kd * fmax(0, -raw) * surface * light)
DIFFUSE(not_unit, return kd * fmax(0, vec3_dot(n, l)) * surface * light)
DIFFUSE(not_unit_both_sides, return kd * vec3_dot(n, l) * surface * light)
DIFFUSE(both_sides, return kd * fabs(raw) * surface * light)
DIFFUSE(negative, return kd * raw * surface * light)
DIFFUSE(least, return kd * fmin(0, raw) * surface * light)
DIFFUSE(kd_forgotten, return cosine * surface * light)
DIFFUSE(kd_twice, return kd * kd * cosine * surface * light)
DIFFUSE(kd_less_1, return (1 - kd) * cosine * surface * light)
DIFFUSE(surface_forgotten, return kd * cosine * light)
DIFFUSE(light_forgotten, return kd * cosine * surface)
DIFFUSE(cosine_forgotten, return kd * (raw > 0 ? 1 : 0) * surface * light)
DIFFUSE(cosine_and_side_forgotten, return kd * surface * light)
DIFFUSE(added, return kd * cosine * (surface + light))
DIFFUSE(cosine_added, return kd * surface * light + cosine)
DIFFUSE(dotted, return kd * cosine * grey(vec3_dot(surface, light)))
DIFFUSE(grey_light, return kd * cosine * mean(light) * surface)
DIFFUSE(by_components, return kd * n * vec3_unit(l) * surface * light)
DIFFUSE(clipped, return clipped(kd * cosine * surface * light))
DIFFUSE(through_pi, return kd * cosine * surface * light / PI)
DIFFUSE(falls_off, return kd * cosine / vec3_dot(l, l) * surface * light)
DIFFUSE(falls_off_once, return kd * cosine / vec3_length(l) * surface * light)
DIFFUSE(squared, return kd * cosine * cosine * surface * light)
DIFFUSE(sine, return kd * (raw > 0 ? sqrt(fmax(0, 1 - raw * raw)) : 0) * surface * light)
DIFFUSE(angle, return kd * acos(fmax(-1, fmin(1, raw))) * surface * light)
DIFFUSE(linear, return kd * fmax(0, 1 - acos(fmax(-1, fmin(1, raw))) / (PI / 2)) * surface * light)
DIFFUSE(half, return kd * (raw + 1) / 2 * surface * light)
DIFFUSE(half_squared, return kd * (raw + 1) / 2 * (raw + 1) / 2 * surface * light)
DIFFUSE(never_black, return kd * fmax(0.1, raw) * surface * light)

const Mistake diffuse_mistakes[] = {
    MISTAKE("S2", diffuse_term, diffuse_reversed, "max(0, -(n.l))",
            "to_light already points towards the light.", "spheres lit on the far side"),
    MISTAKE("S3", diffuse_term, diffuse_not_unit, "max(0, n.l) with an l that is not normalised",
            "n.l is |l| times the cosine. Normalise l first.",
            "spheres with large white areas, larger the farther the light is"),
    MISTAKE("S3-sides", diffuse_term, diffuse_not_unit_both_sides, "n.l unchanged",
            "n.l is |l| times the cosine: normalise l first. And behind the surface it is "
            "negative, which would subtract light.",
            "spheres with large white areas, and black on the other side"),
    MISTAKE("S4", diffuse_term, diffuse_both_sides, "|n.l|",
            "if n.l is negative the light is behind the surface, and does not reach it.",
            "spheres lit on the far side as well"),
    MISTAKE(
        "S4-negative", diffuse_term, diffuse_negative, "n.l without max(0, ...)",
        "if the light is behind the surface, this is negative and subtracts from the other lights.",
        "far sides darker than the ambient light"),
    MISTAKE("DI-min", diffuse_term, diffuse_least, "min(0, n.l)",
            "this keeps the light behind the surface and drops the light in front of it. It is "
            "max(0, ...).",
            "a black picture except for the ambient light"),
    MISTAKE("DI-kd", diffuse_term, diffuse_kd_forgotten, "kd left out",
            "only kd of the light is scattered.", "spheres too bright"),
    MISTAKE("DI-kd-twice", diffuse_term, diffuse_kd_twice, "kd^2",
            "kd is the share that is scattered: multiply by it once.", "spheres too dark"),
    MISTAKE("DI-kd-less-1", diffuse_term, diffuse_kd_less_1, "1 - kd",
            "kd is the share that is scattered, not the rest.",
            "bright surfaces dark, and dark ones bright"),
    MISTAKE("DI-surface", diffuse_term, diffuse_surface_forgotten, "kd * light * max(0, n.l)",
            "a red surface reflects only red light: its colour is missing.",
            "spheres of plaster, all in the colour of the light"),
    MISTAKE("DI-light", diffuse_term, diffuse_light_forgotten, "kd * surface * max(0, n.l)",
            "the brightness and the colour of the light are missing.",
            "the same picture, whatever the colour of the light"),
    MISTAKE("DI-cosine", diffuse_term, diffuse_cosine_forgotten, "1 if n.l > 0",
            "the lower the light, the wider it is spread: the cosine is missing.",
            "flat half-moons with a hard edge"),
    MISTAKE("DI-flat", diffuse_term, diffuse_cosine_and_side_forgotten, "kd * surface * light",
            "the lower the light, the wider it is spread: the cosine is missing.", "flat discs"),
    MISTAKE("DI-plus", diffuse_term, diffuse_added, "surface + light",
            "colours add up when two lights come together. A surface multiplies the light by its "
            "colour.",
            "pale spheres"),
    MISTAKE("DI-plus-cosine", diffuse_term, diffuse_cosine_added, "kd * surface * light + cosine",
            "the cosine is the share of the light that arrives: multiply by it.",
            "pale spheres with large white areas"),
    MISTAKE("DI-dot", diffuse_term, diffuse_dotted, "surface . light",
            "a dot product adds up the three colours to one number. Red stays with red: * "
            "multiplies component by component.",
            "grey spheres"),
    MISTAKE("DI-grey", diffuse_term, diffuse_grey_light, "surface * (mean of light)",
            "the light also has a colour: red times red, green times green, blue times blue.",
            "spheres that do not take on the light's colour"),
    MISTAKE("DI-product", diffuse_term, diffuse_by_components, "n * l, by components",
            "* multiplies component by component, which is for colours. The cosine is vec3_dot of "
            "the two.",
            "spheres in the colours of the rainbow"),
    MISTAKE("DI-clip", diffuse_term, diffuse_clipped, "no more than 1",
            "light is clamped once, at the end, by clamp_color.",
            "no visible difference at first; sums of bright lights come out too dark"),
    MISTAKE("DI-pi", diffuse_term, diffuse_through_pi, "divided by pi",
            "some books divide by pi, with another definition of kd. Here kd is the whole share.",
            "spheres too dark"),
    MISTAKE("DI-far", diffuse_term, diffuse_falls_off, "divided by |l|^2",
            "real lamps fade with the distance, but these do not: only the direction counts.",
            "nearly black, unless the light is close"),
    MISTAKE("DI-far-once", diffuse_term, diffuse_falls_off_once, "divided by |l| once more",
            "to normalise l, divide it by its length once. Lights do not fade here.",
            "nearly black, unless the light is close"),
    MISTAKE("DI-squared", diffuse_term, diffuse_squared, "the cosine squared",
            "Lambert's law has the cosine itself; a power is for highlights.",
            "spheres that fade too soon towards the shadow"),
    MISTAKE("DI-sine", diffuse_term, diffuse_sine, "the sine of the angle",
            "this is 0 if the light is straight above, where the cosine is 1.",
            "spheres dark in the middle of the lit side"),
    MISTAKE("DI-angle", diffuse_term, diffuse_angle, "the angle itself",
            "n.l with unit vectors is the cosine already: use it, not the angle.",
            "spheres lit on the far side"),
    MISTAKE("DI-linear", diffuse_term, diffuse_linear, "1 - angle / 90 degrees",
            "the light on a tilted surface is the cosine of the angle, not a linear share of it.",
            "spheres that look like cones"),
    MISTAKE("DI-half", diffuse_term, diffuse_half, "(n.l + 1) / 2",
            "this light reaches around the surface, a trick of games. Lambert's law is the cosine, "
            "and nothing behind the surface.",
            "soft spheres without a dark side"),
    MISTAKE("DI-half-squared", diffuse_term, diffuse_half_squared, "((n.l + 1) / 2)^2",
            "this light reaches around the surface, a trick of games. Lambert's law is the cosine, "
            "and nothing behind the surface.",
            "soft spheres without a dark side"),
    MISTAKE("DI-tenth", diffuse_term, diffuse_never_black, "max(0.1, n.l)",
            "the ambient term already gives the light that does not come from lamps.",
            "far sides lit a little by each light"),
    {0},
};
