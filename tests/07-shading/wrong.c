// wrong.c - wrong answers to exercise 07.
//
// The letters of formulas are those of the lesson. In code c is a center, a color or one of its
// numbers.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include "tests/judge/known.h"
#include "tests/judge/numbers.h"

// All three alike.
static vec3 grey(double x)
{
    return vec3_of(x, x, x);
}

static double mean(Color c)
{
    return (c[0] + c[1] + c[2]) / 3;
}

static double largest(vec3 v)
{
    return fmax(v[0], fmax(v[1], v[2]));
}

static double largest_coordinate(vec3 v)
{
    return fmax(largest(v), largest(-v));
}

static Color at_most_1(Color c)
{
    return vec3_of(fmin(1, c[0]), fmin(1, c[1]), fmin(1, c[2]));
}

static Color not_below_0(Color c)
{
    return vec3_of(fmax(0, c[0]), fmax(0, c[1]), fmax(0, c[2]));
}

// ---- wrong normals ------------------------------------------------------------------------------

#define NORMAL(id, formula, why, picture, answer)                                                  \
    WRONG(surface_normal, id, formula, why, picture)                                               \
    {                                                                                              \
        LETTER(vec3, c) = sphere.center;                                                           \
        LETTER(double, r) = sphere.radius;                                                         \
        return answer;                                                                             \
    }

NORMAL("W2", "point / |point|",
       "this points away from the origin of the world. A sphere's normal points away from its own "
       "center.",
       "shading that is right only for a sphere around the origin", vec3_unit(point))
NORMAL("W2-r", "point / r",
       "a radius leads from the center to the point, but the center is missing.",
       "shading that is right only for a sphere around the origin", point / r)
NORMAL("W2-point", "the point itself",
       "this is the vector from the origin of the world, and its length is arbitrary.",
       "spheres too bright, lit from wrong sides", point)
NORMAL("W3", "(c - point) / |c - point|", "this points into the sphere, to its center.",
       "dark where it should be light, and light where it should be dark", vec3_unit(c - point))
NORMAL("W3-length", "c - point", "this points into the sphere, and is as long as its radius.",
       "dark where it should be light, and light where it should be dark", c - point)
NORMAL("W-length", "point - c",
       "this is as long as the radius. A normal has length 1; if it is longer, cosines come out "
       "too large.",
       "large spheres too bright, small ones nearly black", point - c)
NORMAL("W-squared", "(point - c) / r^2",
       "point - c has length r, so dividing by r once normalises it.",
       "small spheres too bright, large ones nearly black", (point - c) / (r * r))
NORMAL("W-times", "(point - c) r", "point - c has length r already: divide by r.",
       "large spheres too bright, small ones nearly black", (point - c) * r)
NORMAL("W-plus", "(point + c) / |point + c|",
       "the vector from the center to the point is the point minus the center.",
       "spheres lit from wrong sides, worse the farther they are from the origin",
       vec3_unit(point + c))
NORMAL("W-scalar", "point - c - r",
       "subtracting a number from a vector subtracts it from each component. To make it shorter, "
       "divide.",
       "spheres that are dark from most sides, and too bright from the others", point - c - r)
NORMAL("W-early", "point / |point| - c / |c|",
       "here the lengths are lost before the subtraction. First subtract, then normalise.",
       "nearly black spheres; nothing at all for one around the origin",
       vec3_unit(point) - vec3_unit(c))
NORMAL("W-other", "(point - c) / |point|", "divide it by its own length, which is |point - c|.",
       "spheres that are darker, the farther they are from the origin",
       (point - c) / vec3_length(point))
NORMAL("W-brackets", "point - c / r",
       "division comes first, so only c is divided. The difference needs parentheses.",
       "spheres too bright, lit from wrong sides", point - c / r)
NORMAL("W-largest", "point - c by its largest component",
       "then the largest component is 1. The length is 1 only at six points.",
       "faint edges across each sphere, as on a cube", (point - c) / largest_coordinate(point - c))

// ---- wrong rays to the light --------------------------------------------------------------------

// l is the position of the light, way the right direction.
#define TO_LIGHT(id, formula, why, picture, ...)                                                   \
    WRONG(ray_to_light, id, formula, why, picture)                                                 \
    {                                                                                              \
        const bool point = light.kind == LIGHT_POINT;                                              \
        const vec3 l = light.position;                                                             \
        LETTER(vec3, way) = point ? l - from : l;                                                  \
        return (Ray){__VA_ARGS__};                                                                 \
    }

TO_LIGHT("S2-ray", "the direction from the light",
         "it must point towards the light: the end minus the start.", "spheres lit on the far side",
         from, -way)
TO_LIGHT("S2-point", "from - position, of a point light",
         "this leads from the light to the surface. The end minus the start: position - from.",
         "spheres lit on the side away from a point light", from, point ? from - l : l)
TO_LIGHT("S2-distant", "-position, of a distant light",
         "scene.h says that a distant light lies in that direction, so it already points towards "
         "the light.",
         "spheres lit on the side away from the sun", from, point ? l - from : -l)
TO_LIGHT("LI-distant", "position, for both kinds",
         "the direction to a point light depends on the start.",
         "lamps that light like the sun: the same side of every sphere", from, l)
TO_LIGHT("LI-point", "position - from, for both kinds",
         "a distant light has no place. It has a direction, the same from everywhere.",
         "a sun that is as near as a lamp", from, l - from)
TO_LIGHT("S2-all-point", "from - position, for both kinds",
         "this points away from a point light; and a distant one has no place at all.",
         "spheres lit on the far side", from, from - l)
TO_LIGHT("LI-kinds", "the kinds swapped", "LIGHT_POINT is the light at a position.",
         "lamps that light like the sun, and a sun like a lamp", from, point ? l : l - from)
TO_LIGHT("LI-unit", "the direction normalised",
         "then t = 1 is not the light any more, and a search for spheres in between uses the wrong "
         "range of t.",
         "shadows that are missing, or cast by spheres behind the light", from, vec3_unit(way))
TO_LIGHT("LI-unit-point", "(position - from) / |position - from|",
         "then t = 1 is not the light any more, and a search for spheres in between uses the wrong "
         "range of t.",
         "shadows that are missing, or cast by spheres behind the light", from,
         point ? vec3_unit(l - from) : l)
TO_LIGHT("LI-unit-distant", "position / |position|, of a distant one",
         "the direction is right, but the contract asks for the light's own direction, unchanged.",
         "no visible difference; the terms normalise it anyway", from,
         point ? l - from : vec3_unit(l))
TO_LIGHT(
    "LI-back", "from the light to the point",
    "the ray starts at the point and leads to the light. From a distant light no ray can start.",
    "spheres lit on the far side", l, -way)
TO_LIGHT("LI-back-point", "from the point light to the point",
         "the same segment, but reversed: the ray starts at the point, and t = 1 is the light.",
         "spheres lit on the far side", point ? l : from, point ? from - l : l)
TO_LIGHT("LI-start", "an origin at the light", "the ray starts at the given point, from.",
         "shadows in odd places", l, way)
TO_LIGHT("LI-origin", "an origin of (0, 0, 0)", "the ray starts at the given point, from.",
         "everything in shadow, or nothing", vec3_of(0, 0, 0), way)
TO_LIGHT("LI-plus", "position + from",
         "the vector from one point to another is the end minus the start.",
         "spheres lit from wrong sides, worse the farther they are from the origin", from,
         point ? l + from : l)
TO_LIGHT("LI-place", "from + position, of a distant light",
         "this is a point on the way, not a direction.", "a sun in another place for every sphere",
         from, point ? l - from : l + from)
TO_LIGHT("LI-swapped", "origin and direction swapped",
         "the origin is a point, where the ray starts; the direction is a difference of points.",
         "light and shadow in odd places", way, from)
TO_LIGHT(
    "LI-ahead", "an origin 0.001 of the way ahead",
    "the caller gives the point, and offset_from_surface has already moved it as far as needed.",
    "shadows that start a little beside their spheres", from + 0.001 * way, way)
TO_LIGHT("LI-ahead-unit", "an origin 0.001 ahead",
         "the caller gives the point, and offset_from_surface has already moved it as far as "
         "needed. In a "
         "tiny scene 0.001 is a long way.",
         "tiny scenes without shadows", from + 0.001 * vec3_unit(way), way)

// ---- wrong mirrors ------------------------------------------------------------------------------

// vn is v.n.
#define MIRRORED(id, formula, why, picture, answer)                                                \
    WRONG(mirror_direction, id, formula, why, picture)                                             \
    {                                                                                              \
        const vec3 v = direction, n = normal;                                                      \
        LETTER(double, vn) = vec3_dot(v, n);                                                       \
        return answer;                                                                             \
    }

MIRRORED("MI-plus", "v + 2 (v.n) n",
         "this makes the part along the normal three times as large, and keeps its sign.",
         "mirrors that show the inside of their own sphere", v + 2 * vn * n)
MIRRORED("MI-once", "v - (v.n) n",
         "this removes the part along the normal, so the rest runs along the surface. To reverse "
         "that part, subtract it twice.",
         "mirrors that show the horizon all over", v - vn * n)
MIRRORED("MI-plus-once", "v + (v.n) n",
         "this doubles the part along the normal instead of reversing it.",
         "mirrors that show the inside of their own sphere", v + vn * n)
MIRRORED("MI-back", "2 (v.n) n - v",
         "this is for a vector that points away from the surface. This one comes in, so its "
         "mirrored direction is the opposite.",
         "mirrors that show the inside of their own sphere", 2 * vn * n - v)
MIRRORED("MI-back-once", "(v.n) n - v",
         "only the part along the surface is left, and it is reversed.",
         "mirrors that show the horizon all over, reversed", -v + vn * n)
MIRRORED(
    "MI-scalar", "v - 2 (v.n)",
    "subtracting a number from a vector subtracts it from each component. The normal is missing.",
    "mirrors that all look towards the same corner", v - 2 * vn)
MIRRORED("MI-opposite", "-v", "only a ray along the normal comes straight back.",
         "mirrors that show only the eye", -v)
MIRRORED("MI-on", "v", "this goes through the surface, as if it were not there.",
         "glass instead of mirrors", v)
MIRRORED("MI-n", "v - 2n", "the part of v along n decides how much to subtract: v.n is missing.",
         "mirrors that show the inside of their own sphere", v - 2 * n)
MIRRORED(
    "MI-normal", "n",
    "the mirrored direction also depends on v. It is as far from n as v is, on the other side.",
    "mirrors that show the same from everywhere", n)
MIRRORED("MI-product", "v - 2 v n n, by components",
         "v * n multiplies component by component. The dot product is vec3_dot.",
         "mirrors that are right only if they face along an axis", v - 2 * v * n * n)
MIRRORED("MI-unit", "(v - 2 (v.n) n) / |v|", "the direction is right, but it must be as long as v.",
         "no visible difference at first; t counts in other lengths", vec3_unit(v - 2 * vn * n))
MIRRORED("MI-part", "v - 2 (v.n / |v|) n",
         "the vector to subtract grows with the length of v: put v itself into the dot product.",
         "mirrors that are right only if v has length 1", v - 2 * vec3_dot(vec3_unit(v), n) * n)
MIRRORED("MI-square", "v - 2 (v.v) n",
         "the part of v along n is v.n; v.v is only its squared length.",
         "mirrors that show what is straight above them", v - 2 * vec3_dot(v, v) * n)
MIRRORED("MI-side", "v unchanged if v.n is not negative",
         "a mirror has two sides, and the formula is the same for both.",
         "no mirror on the inside of a sphere", vn < 0 ? v - 2 * vn * n : v)
MIRRORED("MI-abs", "v + 2 |v.n| n",
         "from the other side of the mirror v.n is positive, and then this is wrong.",
         "mirrors that are wrong on the inside of a sphere", v + 2 * fabs(vn) * n)
MIRRORED("MI-swapped", "n - 2 (v.n) v", "v and n are swapped: this is the normal, mirrored at v.",
         "mirrors full of other parts of the scene", n - 2 * vn * v)

#define AXIS_ROW(axis, x, y, z)                                                                    \
    NORMAL("W-minus-" #axis, #axis " with the wrong sign",                                         \
           "each coordinate is the point's minus the center's.", "spheres lit from a wrong side",  \
           vec3_of(x, y, z) * surface_normal(sphere, point))                                       \
    MIRRORED("MI-minus-" #axis, #axis " with the wrong sign",                                      \
             "all three coordinates are v - 2 (v.n) n.", "mirrors that show the wrong side",       \
             vec3_of(x, y, z) * (v - 2 * vn * n))

AXIS_ROW(x, -1, 1, 1)
AXIS_ROW(y, 1, -1, 1)
AXIS_ROW(z, 1, 1, -1)

// ---- wrong ambient and diffuse terms ------------------------------------------------------------

#define AMBIENT(id, formula, why, picture, statement)                                              \
    WRONG_LINE(ambient_term, id, formula, why, picture, statement)

AMBIENT("AM-kd", "surface * ambient", "only kd of the light is scattered.",
        "everything in shadow too bright", return surface * ambient)
AMBIENT("AM-kd-twice", "kd^2 * surface * ambient",
        "kd is the fraction that is scattered: multiply by it once.",
        "everything in shadow too dark", return kd * kd * surface * ambient)
AMBIENT("AM-kd-less-1", "(1 - kd) * surface * ambient",
        "kd is the fraction that is scattered, not the rest.",
        "bright surfaces dark in the shadow, and dark ones bright",
        return (1 - kd) * surface * ambient)
AMBIENT("AM-surface", "kd * ambient",
        "a red surface reflects only red light: its color is missing.",
        "all spheres the same grey in the shadow", return kd * ambient)
AMBIENT("AM-ambient", "kd * surface",
        "without ambient light it must be black: the light is missing.",
        "flat discs, as if there were no shadow", return kd * surface)
AMBIENT("AM-alone", "ambient", "this is the light. The surface reflects kd times its color of it.",
        "all spheres the same grey in the shadow", return ambient)
AMBIENT("AM-tenth", "0.1 * kd * surface",
        "a tenth of white is only the default of scenes. Use the argument.",
        "the same, however bright the ambient light", return 0.1 * kd * surface)
AMBIENT("AM-plus", "kd * (surface + ambient)",
        "colors add up when two lights come together. A surface multiplies the light by its color.",
        "pale shadows", return kd * (surface + ambient))
AMBIENT("AM-plus-behind", "kd * surface + ambient",
        "colors add up when two lights come together. A surface multiplies the light by its color.",
        "pale shadows", return kd * surface + ambient)
AMBIENT("AM-plus-all", "kd + surface + ambient",
        "multiply by the fraction, and by the color of the surface as well.",
        "nearly white spheres", return kd + surface + ambient)
AMBIENT("AM-mixed", "kd * surface + (1 - kd) * ambient",
        "this is a mixture of two colors. A surface multiplies the light by its own color.",
        "pale shadows", return kd * surface + (1 - kd) * ambient)
AMBIENT("AM-dot", "kd * (surface . ambient)",
        "a dot product adds up the three colors to one number. Red stays with red: * multiplies "
        "component by component.",
        "grey shadows", return kd * grey(vec3_dot(surface, ambient)))
AMBIENT(
    "AM-cross", "kd * (surface x ambient)",
    "a cross product is for directions. Red stays with red: * multiplies component by component.",
    "odd colors, and some below 0", return kd * vec3_cross(surface, ambient))
AMBIENT("AM-grey", "kd * surface * (mean of ambient)",
        "the light also has a color: red times red, green times green, blue times blue.",
        "shadows that do not take on the light's color", return kd * mean(ambient) * surface)
AMBIENT("AM-red", "kd * surface * ambient[0]",
        "this is only the red of the light: red times red, green times green, blue times blue.",
        "shadows that do not take on the light's color", return kd * ambient[0] * surface)
AMBIENT("AM-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",
        "no visible difference at first; sums of bright lights come out too dark",
        return at_most_1(kd * surface * ambient))
AMBIENT("AM-pi", "kd * surface * ambient / pi",
        "some books divide by pi, with another definition of kd. Here kd is the whole factor.",
        "everything in shadow too dark", return kd * surface * ambient / PI)

// cosine is the right one, raw is below 0 if the light is behind; color both colors.
#define DIFFUSE(id, formula, why, picture, statement)                                              \
    WRONG(diffuse_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        const double raw = vec3_dot(normal, vec3_unit(to_light));                                  \
        LETTER(double, cosine) = fmax(0, raw);                                                     \
        LETTER(Color, color) = surface * light;                                                    \
        statement;                                                                                 \
    }

DIFFUSE("S2", "max(0, -(n.l))", "to_light already points towards the light.",
        "spheres lit on the far side", return kd * fmax(0, -raw) * color)
DIFFUSE("S3", "max(0, n.l) with an l that is not normalised",
        "n.l is |l| times the cosine. Normalise l first.",
        "spheres with large white areas, larger the farther the light is",
        return kd * fmax(0, vec3_dot(normal, to_light)) * color)
DIFFUSE("S3-sides", "n.l unchanged",
        "n.l is |l| times the cosine: normalise l first. And behind the surface it is negative, "
        "which would subtract light.",
        "spheres with large white areas, and black on the other side",
        return kd * vec3_dot(normal, to_light) * color)
DIFFUSE("S4", "|n.l|", "if n.l is negative the light is behind the surface, and does not reach it.",
        "spheres lit on the far side as well", return kd * fabs(raw) * color)
DIFFUSE("S4-negative", "n.l without max(0, ...)",
        "if the light is behind the surface, this is negative and subtracts from the other lights.",
        "far sides darker than the ambient light", return kd * raw * color)
DIFFUSE("DI-min", "min(0, n.l)",
        "this keeps the light behind the surface and drops the light in front of it. It is max(0, "
        "...).",
        "a black picture except for the ambient light", return kd * fmin(0, raw) * color)
DIFFUSE("DI-kd", "kd left out", "only kd of the light is scattered.", "spheres too bright",
        return cosine * color)
DIFFUSE("DI-kd-twice", "kd^2", "kd is the fraction that is scattered: multiply by it once.",
        "spheres too dark", return kd * kd * cosine * color)
DIFFUSE("DI-kd-less-1", "1 - kd", "kd is the fraction that is scattered, not the rest.",
        "bright surfaces dark, and dark ones bright", return (1 - kd) * cosine * color)
DIFFUSE("DI-surface", "kd * light * max(0, n.l)",
        "a red surface reflects only red light: its color is missing.",
        "spheres of plaster, all in the color of the light", return kd * cosine * light)
DIFFUSE("DI-light", "kd * surface * max(0, n.l)",
        "the brightness and the color of the light are missing.",
        "the same picture, whatever the color of the light", return kd * cosine * surface)
DIFFUSE("DI-cosine", "1 if n.l > 0",
        "the lower the light, the wider it is spread: the cosine is missing.",
        "flat half-moons with a hard edge", return kd * (raw > 0 ? 1 : 0) * color)
DIFFUSE("DI-flat", "kd * surface * light",
        "the lower the light, the wider it is spread: the cosine is missing.", "flat discs",
        return kd * color)
DIFFUSE("DI-plus", "surface + light",
        "colors add up when two lights come together. A surface multiplies the light by its color.",
        "pale spheres", return kd * cosine * (surface + light))
DIFFUSE("DI-plus-cosine", "kd * surface * light + cosine",
        "the cosine is the fraction of the light that arrives: multiply by it.",
        "pale spheres with large white areas", return kd * color + cosine)
DIFFUSE("DI-dot", "surface . light",
        "a dot product adds up the three colors to one number. Red stays with red: * multiplies "
        "component by component.",
        "grey spheres", return kd * cosine * grey(vec3_dot(surface, light)))
DIFFUSE("DI-grey", "surface * (mean of light)",
        "the light also has a color: red times red, green times green, blue times blue.",
        "spheres that do not take on the light's color", return kd * cosine * mean(light) * surface)
DIFFUSE(
    "DI-product", "n * l, by components",
    "* multiplies component by component, which is for colors. The cosine is vec3_dot of the two.",
    "spheres in the colors of the rainbow", return kd * normal * vec3_unit(to_light) * color)
DIFFUSE("DI-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",
        "no visible difference at first; sums of bright lights come out too dark",
        return at_most_1(kd * cosine * color))
DIFFUSE("DI-pi", "divided by pi",
        "some books divide by pi, with another definition of kd. Here kd is the whole factor.",
        "spheres too dark", return kd * cosine * color / PI)
DIFFUSE("DI-far", "divided by |l|^2",
        "real lamps fade with the distance, but these do not: only the direction counts.",
        "nearly black, unless the light is close",
        return kd * cosine / vec3_dot(to_light, to_light) * color)
DIFFUSE("DI-far-once", "divided by |l| once more",
        "to normalise l, divide it by its length once. Lights do not fade here.",
        "nearly black, unless the light is close",
        return kd * cosine / vec3_length(to_light) * color)
DIFFUSE("DI-squared", "the cosine squared",
        "Lambert's law has the cosine itself; a power is for highlights.",
        "spheres that fade too soon towards the shadow", return kd * cosine * cosine * color)
DIFFUSE("DI-sine", "the sine of the angle",
        "this is 0 if the light is straight above, where the cosine is 1.",
        "spheres dark in the middle of the lit side",
        return kd * (raw > 0 ? sqrt(fmax(0, 1 - raw * raw)) : 0) * color)
DIFFUSE("DI-angle", "the angle itself",
        "n.l with unit vectors is the cosine already: use it, not the angle.",
        "spheres lit on the far side", return kd * acos(fmax(-1, fmin(1, raw))) * color)
DIFFUSE(
    "DI-linear", "1 - angle / 90 degrees",
    "the light on a tilted surface is proportional to the cosine of the angle, not to the angle.",
    "spheres that look like cones",
    return kd * fmax(0, 1 - acos(fmax(-1, fmin(1, raw))) / (PI / 2)) * color)
DIFFUSE("DI-half", "(n.l + 1) / 2",
        "this light reaches around the surface, a trick of games. Lambert's law is the cosine, and "
        "nothing behind the surface.",
        "soft spheres without a dark side", return kd * (raw + 1) / 2 * color)
DIFFUSE("DI-half-squared", "((n.l + 1) / 2)^2",
        "this light reaches around the surface, a trick of games. Lambert's law is the cosine, and "
        "nothing behind the surface.",
        "soft spheres without a dark side", return kd * (raw + 1) / 2 * (raw + 1) / 2 * color)
DIFFUSE("DI-tenth", "max(0.1, n.l)",
        "the ambient term already gives the light that does not come from lamps.",
        "far sides lit a little by each light", return kd * fmax(0.1, raw) * color)

#define DIFFUSE_FROM(number, digits, picture)                                                      \
    DIFFUSE("DI-" #number, "nothing if n.l is below " digits,                                      \
            "a low light gives little, but not nothing: only below 0 it gives nothing.", picture,  \
            return raw < number ? grey(0) : kd * cosine * color)

DIFFUSE_FROM(1e-2, "0.01", "a dark edge before the shadow starts")
DIFFUSE_FROM(1e-3, "0.001", "hardly anything")
DIFFUSE_FROM(1e-6, "1e-6", "hardly anything")

// ---- wrong highlights ---------------------------------------------------------------------------

// One highlight. cosine is the one that is raised to the power of shine; low is n.l.
typedef struct {
    double ks, shine;
    Color light;
    double cosine, low;
} Highlight;

// A cosine below 0 is cut off by a condition, or in another style (answer_style) by fmax: then 0 to
// the power of 0 is 1.
static double power(Highlight h)
{
    if (answer_style != 0)
        return h.low > 0 ? pow(fmax(0, h.cosine), h.shine) : 0;
    return h.low > 0 && h.cosine > 0 ? pow(h.cosine, h.shine) : 0;
}

// m is the mirrored light.
static double mirrored_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(2 * vec3_dot(n, l) * n - l, e);
}

// Of the right highlight something is changed, or something else is returned. l and e are unit
// vectors.
#define PHONG(id, formula, why, picture, ...)                                                      \
    WRONG(phong_term, id, formula, why, picture)                                                   \
    {                                                                                              \
        const vec3 n = normal, l = vec3_unit(to_light), e = vec3_unit(to_eye);                     \
        Highlight h = {ks, shine, light, mirrored_cosine(n, l, e), vec3_dot(n, l)};                \
        __VA_ARGS__;                                                                               \
        return h.ks * power(h) * h.light;                                                          \
    }

// h is the halfway vector, a unit vector.
#define HALFWAY(id, formula, why, picture, ...)                                                    \
    WRONG(halfway_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        const vec3 n = normal, l = vec3_unit(to_light), e = vec3_unit(to_eye);                     \
        Highlight h = {ks, shine, light, vec3_dot(n, vec3_unit(l + e)), vec3_dot(n, l)};           \
        __VA_ARGS__;                                                                               \
        return h.ks * power(h) * h.light;                                                          \
    }

// The slips of both: which is "PH" or "HW".
// clang-format off
#define SLIPS(SLIP, which, COSINE)                                                                 \
    SLIP(which "-behind", "no test for n.l > 0",                                                   \
         "a light behind the surface does not reach it, whatever " COSINE " is.",                  \
         "highlights on the dark side", h.low = 1)                                                 \
    SLIP(which "-negative", "no test for " COSINE " > 0",                                          \
         "an even power of a negative cosine is positive, and a power that is not a whole "        \
         "number is NaN.", "a second highlight where there should be none, or black specks",       \
         return h.low > 0 ? ks * pow(h.cosine, shine) * light : grey(0))                           \
    SLIP(which "-tests", "neither n.l > 0 nor " COSINE " > 0",                                     \
         "a light behind the surface does not reach it; and an even power of a negative cosine "   \
         "is positive.", "highlights on the dark side, or black specks",                           \
         return ks * pow(h.cosine, shine) * light)                                                 \
    SLIP(which "-abs", "|" COSINE "|",                                                             \
         "a negative cosine means an angle of more than 90 degrees, without a highlight.",         \
         "a second highlight where there should be none", h.cosine = fabs(h.cosine))               \
    SLIP(which "-abs-tests", "|" COSINE "|, whatever n.l",                                         \
         "a negative cosine means an angle of more than 90 degrees, and a light behind the "       \
         "surface does not reach it.", "highlights on all sides",                                  \
         return ks * pow(fabs(h.cosine), shine) * light)                                           \
    SLIP(which "-ks", "ks left out", "only ks of the light is reflected like this.",               \
         "highlights too bright", h.ks = 1)                                                        \
    SLIP(which "-ks-twice", "ks^2", "ks is a fraction: multiply by it once.", "highlights too dark",  \
         h.ks *= ks)                                                                               \
    SLIP(which "-ks-less-1", "1 - ks", "ks is the fraction that is reflected, not the rest.",         \
         "dull surfaces with bright highlights, and polished ones without", h.ks = 1 - ks)         \
    SLIP(which "-light", "the light left out",                                                     \
         "a highlight is an image of the light and has its color.",                               \
         "white highlights, whatever the light", h.light = grey(1))                                \
    SLIP(which "-plus", "power + light",                                                           \
         "the power is the fraction of the light that is seen: multiply the light by it.",            \
         "highlights as large as half of the sphere",                                              \
         return power(h) > 0 ? ks * (grey(power(h)) + light) : grey(0))                            \
    SLIP(which "-grey", "the mean of the light",                                                   \
         "a highlight is an image of the light and has its color.", "grey highlights",            \
         h.light = grey(mean(light)))                                                              \
    SLIP(which "-power", "shine left out", "the power makes the highlight small.",                 \
         "highlights that are wide and dull", h.shine = 1)                                         \
    SLIP(which "-times", COSINE " times shine",                                                    \
         "the cosine is raised to the power of shine: pow.", "wide highlights, and too bright",    \
         h.ks *= shine; h.shine = 1)                                                               \
    SLIP(which "-outside", "(ks (" COSINE "))^shine",                                              \
         "only the cosine is raised to the power, without ks.", "hardly any highlights",           \
         h.cosine *= ks; h.ks = 1)                                                                 \
    SLIP(which "-swapped", "shine^(" COSINE ")",                                                   \
         "the first argument of pow is the base, the second the exponent.",                        \
         "discs that are too bright",                                                              \
         return power(h) > 0 ? ks * pow(shine, h.cosine) * light : grey(0))                        \
    SLIP(which "-whole", "shine without its fraction",                                             \
         "shine is a double, and need not be a whole number: pow accepts any.",                    \
         "highlights a little too large",                                                          \
         return power(h) > 0 ? ks * pow(h.cosine, floor(shine)) * light : grey(0))                 \
    SLIP(which "-root", "(" COSINE ")^(1 / shine)",                                                \
         "this is a root, and makes the highlight large instead of small.",                        \
         "highlights that cover half of the sphere",                                               \
         return power(h) > 0 ? ks * pow(h.cosine, 1 / shine) * light : grey(0))                    \
    SLIP(which "-low", "times n.l",                                                                \
         "the cosine n.l belongs to the diffuse term. A mirror reflects all of the light.",        \
         "highlights that fade towards the edge", h.ks *= h.low)                                   \
    SLIP(which "-energy", "times (shine + 2) / (2 pi)",                                            \
         "this keeps the sum of all light constant, in later models. Here there is only ks.",      \
         "small highlights, and too bright", h.ks *= (shine + 2) / (2 * PI))                       \
    SLIP(which "-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",    \
         "no visible difference at first; sums of bright lights come out too dark",                \
         return at_most_1(ks * power(h) * light))
// clang-format on

SLIPS(PHONG, "PH", "m.e")
PHONG("PH-reversed", "-(m.e)",
      "mirror_direction takes the incoming direction, which is -l, and e points to the eye: one of "
      "them has the wrong sign.",
      "highlights missing, or on the opposite side", h.cosine = -h.cosine)
PHONG("PH-light-reversed", "-l instead of l", "to_light already points towards the light.",
      "highlights on the dark side", h.low = -h.low;
      h.cosine = -h.cosine)
PHONG("PH-eye-side", "n.e > 0 instead of n.l > 0",
      "the light must be on the side of the normal: if it is not, it does not reach the surface.",
      "highlights on the dark side", h.low = vec3_dot(n, e))
PHONG("PH-nl", "n.l instead of m.e",
      "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
      "highlights that stay where they are when the eye moves", h.cosine = vec3_dot(n, l))
PHONG("PH-ne", "n.e instead of m.e",
      "a highlight also depends on where the light is: mirror it, then compare with e.",
      "a highlight in the middle of every sphere", h.cosine = vec3_dot(n, e))
PHONG("PH-le", "l.e instead of m.e",
      "the surface mirrors the light before it reaches the eye: the normal is missing.",
      "whole spheres too bright when the light is behind the eye", h.cosine = vec3_dot(l, e))
PHONG("PH-unit-light", "m.e with an l that is not normalised",
      "then it is not the cosine, but |l| times the cosine.", "spheres with large white areas",
      h.cosine = mirrored_cosine(n, to_light, e))
PHONG("PH-unit-eye", "m.e with an e that is not normalised",
      "then it is not the cosine, but |e| times the cosine.", "spheres with large white areas",
      h.cosine = mirrored_cosine(n, l, to_eye))
PHONG("PH-unit", "m.e with vectors that are not normalised",
      "then it is not the cosine, but both lengths times the cosine.",
      "spheres with large white areas", h.cosine = mirrored_cosine(n, to_light, to_eye))
PHONG("PH-unit-half", "2 (n.l / |l|) n - l",
      "normalise l in both places, or in neither and then m.",
      "highlights missing, or in odd places", h.cosine = vec3_dot(2 * h.low * n - to_light, e))
PHONG("PH-unit-late", "2 (n.l / |l|) n - l, normalised",
      "normalise l in both places, or in neither: this has another direction.",
      "highlights missing, or in odd places",
      h.cosine = vec3_dot(vec3_unit(2 * h.low * n - to_light), e))
PHONG("PH-once", "m = (n.l) n - l",
      "this ends on the surface. The other side of the normal is 2 (n.l) n - l.",
      "highlights missing, or near the edge", h.cosine = vec3_dot(h.low * n - l, e))
PHONG("PH-halfway", "n.h, with the halfway vector h",
      "this is Blinn's highlight, which is larger. Phong's is m.e.",
      "highlights of twice the width", h.cosine = vec3_dot(n, vec3_unit(l + e)))

SLIPS(HALFWAY, "HW", "n.h")
HALFWAY("HW-reversed", "-(n.h)", "l and e already point away from the surface, as n does.",
        "no highlights at all", h.cosine = -h.cosine)
HALFWAY("HW-light-reversed", "-l instead of l", "to_light already points towards the light.",
        "highlights on the dark side", h.low = -h.low;
        h.cosine = vec3_dot(n, vec3_unit(e - l)))
HALFWAY("HW-sum", "n.(l + e), not normalised",
        "the sum of two unit vectors is up to 2 long. Normalise it: only then is the dot product a "
        "cosine.",
        "spheres with large white areas", h.cosine = vec3_dot(n, l + e))
HALFWAY("HW-mean", "n.(l + e) / 2",
        "the mean of two unit vectors is shorter than 1, unless they are equal. Normalise it.",
        "no highlights, except where the light is behind the eye",
        h.cosine = vec3_dot(n, l + e) / 2)
HALFWAY("HW-lengths", "l + e with lengths that are not 1",
        "the longer one pulls the sum to its side. The sum is halfway only if both are normalised "
        "first.",
        "highlights in odd places, which move with the distance of the light",
        h.cosine = vec3_dot(n, vec3_unit(to_light + to_eye)))
HALFWAY("HW-unit", "n.(l + e), nothing normalised",
        "l and e must be normalised before they are added, and the sum afterwards.",
        "spheres with large white areas", h.cosine = vec3_dot(n, to_light + to_eye))
HALFWAY("HW-unit-mean", "n.(l + e) / 2, nothing normalised",
        "l and e must be normalised before they are added, and the sum afterwards.",
        "spheres with large white areas", h.cosine = vec3_dot(n, to_light + to_eye) / 2)
HALFWAY("HW-unit-light", "l + e with an l that is not normalised",
        "the longer one pulls the sum to its side. The sum is halfway only if both are normalised "
        "first.",
        "highlights in odd places, which move with the distance of the light",
        h.cosine = vec3_dot(n, vec3_unit(to_light + e)))
HALFWAY("HW-unit-eye", "l + e with an e that is not normalised",
        "the longer one pulls the sum to its side. The sum is halfway only if both are normalised "
        "first.",
        "highlights in the middle of every sphere", h.cosine = vec3_dot(n, vec3_unit(l + to_eye)))
HALFWAY("HW-minus", "l - e",
        "this leads from one to the other. Between them is their sum, and to_eye already points "
        "from the surface to the eye.",
        "highlights near the edge, towards the light", h.cosine = vec3_dot(n, vec3_unit(l - e)))
HALFWAY("HW-eye-minus", "e - l", "this leads from one to the other. Between them is their sum.",
        "highlights near the edge, away from the light", h.cosine = vec3_dot(n, vec3_unit(e - l)))
HALFWAY("HW-phong", "m.e, with the mirrored light m",
        "this is Phong's highlight. This function mirrors nothing: it needs n.h.",
        "highlights of half the width", h.cosine = mirrored_cosine(n, l, e))
HALFWAY("HW-nl", "n.l instead of n.h",
        "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
        "highlights that stay where they are when the eye moves", h.cosine = vec3_dot(n, l))
HALFWAY("HW-ne", "n.e instead of n.h",
        "a highlight also depends on where the light is: h is halfway to it.",
        "a highlight in the middle of every sphere", h.cosine = vec3_dot(n, e))
HALFWAY("HW-le", "l.e instead of n.h",
        "this does not depend on the surface: the normal is missing.",
        "whole spheres too bright when the light is behind the eye", h.cosine = vec3_dot(l, e))
HALFWAY("HW-he", "h.e instead of n.h",
        "h is equally far from the eye and from the light, anywhere on the surface. The angle "
        "between h and the normal counts.",
        "whole spheres too bright", h.cosine = vec3_dot(vec3_unit(l + e), e))
HALFWAY("HW-nl-e", "halfway between n and l, with e",
        "the halfway vector is between light and eye; compare it with the normal.",
        "highlights in odd places", h.cosine = vec3_dot(vec3_unit(n + l), e))
HALFWAY("HW-four", "(n.h)^(4 shine)",
        "this makes the highlight about as small as Phong's. Here the power is shine itself.",
        "small highlights", h.shine *= 4)

#define BOTH(id, formula, why, picture, ...)                                                       \
    PHONG("PH-" id, formula, why, picture, __VA_ARGS__)                                            \
    HALFWAY("HW-" id, formula, why, picture, __VA_ARGS__)
#define AT_MOST(number)                                                                            \
    BOTH("most" #number, "a shine of at most " #number, "a polished surface may have any shine.",  \
         "highlights of polished surfaces too large", h.shine = fmin(number, shine))

BOTH("near1", "all of ks if the cosine is above 0.999999",
     "with a high shine the highlight is already weaker there: raise every cosine to the power.",
     "a flat spot in the middle of small highlights", if (h.cosine > 0.999999) h.cosine = 1)
BOTH("shine0", "nothing if shine is 0",
     "any number to the power of 0 is 1: with a shine of 0 all of ks is seen.",
     "no highlight where it should be widest", if (shine == 0) h.ks = 0)
BOTH("shine1", "a shine of at least 1",
     "a shine below 1 makes the highlight wider still: use it unchanged.",
     "highlights of dull surfaces too small", h.shine = fmax(1, shine))
AT_MOST(10)
AT_MOST(100)
AT_MOST(128)
AT_MOST(1000)
BOTH("rounded", "shine rounded to an integer",
     "shine is a double, and need not be a whole number: pow accepts any.",
     "highlights a little too large or too small", h.shine = floor(shine + 0.5))
BOTH("ks-shine", "ks and shine swapped",
     "shine is the power, ks multiplies the result. Look at the order of the arguments.",
     "wide highlights, and too bright", h.ks = shine;
     h.shine = ks)
BOTH("1e-3", "nothing if n.l is below 0.001",
     "a low light also makes a highlight: only below 0 there is none.",
     "highlights cut off at edges", if (h.low < 1e-3) h.ks = 0)
BOTH("1e-6", "nothing if n.l is below 1e-6",
     "a low light also makes a highlight: only below 0 there is none.", "hardly anything",
     if (h.low < 1e-6) h.ks = 0)

// ---- wrong ways to make a color fit, and to encode it for a gamma ------------------------------

// In formulas c is each of the three numbers.

#define CLAMPED(id, formula, why, picture, answer)                                                 \
    WRONG_LINE(clamp_color, id, formula, why, picture, return answer)

#define EACH(id, formula, why, picture, value)                                                     \
    WRONG(clamp_color, id, formula, why, picture)                                                  \
    {                                                                                              \
        for (int i = 0; i < 3; i++) {                                                              \
            const double c = color[i];                                                             \
            LETTER(double, right) = fmin(1, fmax(0, c));                                           \
            color[i] = value;                                                                      \
        }                                                                                          \
        return color;                                                                              \
    }

EACH("S7", "I unchanged", "a number above 1 or below 0 does not fit into a pixel.",
     "speckles of wrong colors in the brightest spots", c)
EACH("S7-above", "min(1, I)", "a number below 0 does not fit into a pixel either.",
     "speckles of wrong colors in the darkest spots", fmin(1, c))
EACH("S7-below", "max(0, I)", "a number above 1 does not fit into a pixel either.",
     "speckles of wrong colors in the brightest spots", fmax(0, c))
EACH("CL-0", "0, whatever I is",
     "min(0, max(1, I)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' is "
     "min(1, ...).",
     "a black picture", fmin(0, fmax(1, c)))
EACH("CL-1", "1, whatever I is",
     "max(1, min(0, I)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' is "
     "min(1, ...).",
     "a white picture", fmax(1, fmin(0, c)))
EACH("CL-wrap", "I - floor(I)", "a number a little above 1 starts again at 0.",
     "dark speckles in the brightest spots", c - floor(c))
EACH("CL-wrap-above", "I - floor(I) above 1", "a number a little above 1 starts again at 0.",
     "dark speckles in the brightest spots", c > 1 ? c - floor(c) : fmax(0, c))
EACH("CL-black", "0 if I does not fit", "a number that is too bright is nearest to 1, not to 0.",
     "black holes in the brightest spots", c<0 || c> 1 ? 0 : c)
EACH("CL-white", "1 if I does not fit", "a number below 0 is nearest to 0, not to 1.",
     "white speckles in the darkest spots", c<0 || c> 1 ? 1 : c)
EACH("CL-abs", "min(1, |I|)", "a negative number is nearest to 0, not to the positive one.",
     "bright speckles in the darkest spots", fmin(1, fabs(c)))
EACH("CL-255", "at most 255", "colors go from 0 to 1 here; the image converts them to bytes.",
     "speckles of wrong colors in the brightest spots", fmin(255, fmax(0, c)))
EACH("CL-255-times", "255 I", "colors go from 0 to 1 here; the image converts them to bytes.",
     "everything that is not black is too bright", 255 * right)
EACH("CL-minus", "at least -1", "colors start at 0; cosines start at -1.",
     "speckles of wrong colors in the darkest spots", fmin(1, fmax(-1, c)))
EACH("CL-round", "0 or 1, whichever is nearer", "a number in between fits, and must not change.",
     "a poster of eight colors", c < 0.5 ? 0 : 1)
EACH("CL-compress", "I / (1 + I)",
     "this also changes colors that fit. A number between 0 and 1 must not change.",
     "a dull picture", fmax(0, c) / (1 + fmax(0, c)))
EACH("CL-expose", "1 - exp(-I)",
     "this also changes colors that fit. A number between 0 and 1 must not change.",
     "a dull picture", 1 - exp(-fmax(0, c)))
CLAMPED("CL-scale", "divided by the largest, if that is above 1",
        "this also darkens the other two. Each number is clamped by itself.",
        "highlights in the color of the surface", color / fmax(1, largest(color)))
CLAMPED("CL-scale-0", "divided by the largest above 1, and at least 0",
        "this also darkens the other two. Each number is clamped by itself.",
        "highlights in the color of the surface", not_below_0(color / fmax(1, largest(color))))
CLAMPED("CL-scale-all", "divided by the largest",
        "this also changes colors that fit, and makes every pixel as bright as possible.",
        "spheres without a dark side", color / largest(color))
CLAMPED("CL-length", "normalised if it is longer than 1",
        "a color is not a direction: each of its numbers may be up to 1 by itself.",
        "a picture without white", color / fmax(1, vec3_length(color)))
EACH("CL-red", "only red clamped", "all three must fit.",
     "speckles of wrong colors in the brightest spots", i == 0 ? right : c)
EACH("CL-two", "blue left out", "three numbers are 0, 1 and 2: the loop ends too early.",
     "speckles of wrong colors in the brightest spots", i < 2 ? right : c)
CLAMPED("CL-all", "all white if one is above 1",
        "each number is clamped by itself, and the others do not change.",
        "white spots with hard edges", largest(color) > 1 ? grey(1) : not_below_0(color))
CLAMPED("CL-all-both", "all white or all black if one does not fit",
        "each number is clamped by itself, and the others do not change.",
        "white and black spots with hard edges",
        largest(color) > 1    ? grey(1)
        : largest(-color) > 0 ? grey(0)
                              : color)

static double srgb(double c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

#define GAMMA(id, formula, why, picture, value)                                                    \
    WRONG(gamma_encode, id, formula, why, picture)                                                 \
    {                                                                                              \
        for (int i = 0; i < 3; i++) {                                                              \
            const double c = color[i];                                                             \
            LETTER(double, right) = pow(c, 1 / gamma);                                             \
            color[i] = value;                                                                      \
        }                                                                                          \
        return color;                                                                              \
    }

GAMMA("GA-wrong-way", "I^gamma",
      "that is what the display does. To make up for it, the power is 1 / gamma.",
      "everything too dark", pow(c, gamma))
GAMMA("GA-times", "gamma I", "gamma is a power, not a factor.",
      "everything too bright, with white areas", (c * gamma))
GAMMA("GA-through", "I / gamma", "gamma is a power, not a factor.", "everything too dark",
      c / gamma)
GAMMA("GA-2.2", "I^(1 / 2.2), whatever gamma",
      "most displays have 2.2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", pow(c, 1 / 2.2))
GAMMA("GA-2", "sqrt(I), whatever gamma",
      "this is right for a gamma of 2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", sqrt(c))
GAMMA("GA-none", "I unchanged", "this is right only for a gamma of 1.",
      "everything too dark, as without gamma", c)
GAMMA("GA-minus", "I^(-gamma)",
      "a negative power is 1 divided by that power. The inverse of a power is the root: 1 / gamma.",
      "a white picture", pow(c, -gamma))
GAMMA("GA-swapped", "(1 / gamma)^I",
      "the first argument of pow is the base, the second the exponent.",
      "a negative, pale and grey", pow(1 / gamma, c))
GAMMA("GA-swapped-too", "gamma^I",
      "the first argument of pow is the base, the second the exponent; and the exponent is 1 / "
      "gamma.",
      "a white picture", pow(gamma, c))
GAMMA("GA-whole", "gamma rounded to an integer", "gamma is a double, 2.2 for example.",
      "everything a little too dark or too bright", pow(c, 1 / floor(gamma + 0.5)))
GAMMA("GA-integers", "1 / gamma in integers",
      "in integers 1 / 2 is 0, and every number to the power of 0 is 1.", "a white picture",
      pow(c, gamma > 1 ? 0 : 1 / gamma))
GAMMA("GA-twice", "encoded twice", "the display undoes it only once.", "a pale picture",
      pow(right, 1 / gamma))
GAMMA("GA-srgb", "the curve of sRGB, whatever gamma",
      "this is close to a gamma of 2.2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", srgb(c))
GAMMA("GA-inverted", "1 - I^(1 / gamma)", "black stays black, and white stays white.", "a negative",
      1 - right)
GAMMA("GA-turned", "1 - (1 - I)^gamma",
      "this is brighter as well, but the display does not undo it. It undoes I^(1 / gamma).",
      "bright parts too bright", 1 - pow(1 - c, gamma))
GAMMA("GA-255", "255 I^(1 / gamma)",
      "colors go from 0 to 1 here; the image converts them to bytes.",
      "everything that is not black is too bright", 255 * right)
GAMMA("GA-255-in", "(I / 255)^(1 / gamma)", "colors already go from 0 to 1.",
      "a picture far too dark", pow(c / 255, 1 / gamma))
GAMMA("GA-255-both", "255 (I / 255)^(1 / gamma)", "colors already go from 0 to 1.",
      "everything that is not black is too bright", 255 * pow(c / 255, 1 / gamma))
GAMMA("GA-red", "only red encoded", "the display does the same to all three.", "a reddish picture",
      i == 0 ? right : c)
GAMMA("GA-two", "blue left out", "three numbers are 0, 1 and 2: the loop ends too early.",
      "a yellowish picture", i < 2 ? right : c)

WRONG_LINE(gamma_encode, "GA-mean", "the mean encoded, the hue kept",
           "the display raises each of the three to the power by itself.",
           "colors that are too strong",
           return mean(color) > 0 ? color / mean(color) * pow(mean(color), 1 / gamma) : color)

WRONG(gamma_encode, "GA-length", "the length encoded",
      "a color is not a direction. The display raises each of the three to the power by itself.",
      "colors that are too strong")
{
    double length = vec3_length(color);
    return length > 0 ? color / length * pow(length, 1 / gamma) : color;
}

#define ONLY_ROW(id, what, which)                                                                  \
    EACH("CL-" id, what " clamped", "all three must fit.",                                         \
         "speckles of wrong colors in the brightest spots", which ? right : c)                     \
    GAMMA("GA-" id, what " encoded", "the display does the same to all three.",                    \
          "a picture in false colors", which ? right : c)

ONLY_ROW("green", "only green", i == 1)
ONLY_ROW("blue", "only blue", i == 2)
ONLY_ROW("but-red", "only green and blue", i != 0)
ONLY_ROW("but-green", "only red and blue", i != 1)

WRONG(clamp_color, "CL-and", "clamped only if all three do not fit",
      "each number is clamped by itself, whether the others fit or not.",
      "speckles of wrong colors in the brightest spots")
{
    bool above = color[0] > 1 && color[1] > 1 && color[2] > 1,
         below = color[0] < 0 && color[1] < 0 && color[2] < 0;
    return above || below ? clamp_color(color) : color;
}

CLAMPED("CL-black-below", "all black if one is below 0",
        "each number is clamped by itself, and the others do not change.",
        "black spots with hard edges", largest(-color) > 0 ? grey(0) : clamp_color(color))

// ---- wrong steps off a surface ------------------------------------------------------------------

// s is the size of the numbers, e the fraction of it.
#define OFF(id, formula, why, picture, answer)                                                     \
    WRONG(offset_from_surface, id, formula, why, picture)                                          \
    {                                                                                              \
        const vec3 c = sphere.center;                                                              \
        const double r = sphere.radius;                                                            \
        LETTER(vec3, p) = point;                                                                   \
        LETTER(vec3, n) = normal;                                                                  \
        LETTER(double, s) = r + largest_coordinate(c);                                             \
        LETTER(double, e) = 0x1p-30;                                                               \
        return answer;                                                                             \
    }

OFF("O-none", "p",
    "rounding leaves p on either side of its surface. From the wrong side a ray hits the surface "
    "that it starts from.",
    "black speckles on all lit surfaces", p)
OFF("O-other", "p - 2^-30 size n",
    "the point must go to the side of the normal; on the other side it is below its own surface.",
    "everything in its own shadow", p - e * s * n)
OFF("O-outward", "p + 2^-30 size (p - c) / |p - c|",
    "this is always outward. Seen from inside, the given normal points inward, and the point must "
    "go there.",
    "right outside; hollow spheres dark inside", p + e * s * vec3_unit(p - c))
OFF("O-inward", "p - 2^-30 size (p - c) / |p - c|",
    "this is always inward. The normal gives the side; mostly it is outward.",
    "everything in its own shadow, except hollow spheres", p - e * s * vec3_unit(p - c))
OFF("O-plus", "p + 2^-30 size",
    "adding a number to a vector adds it to each coordinate. Multiply the normal by it, and add "
    "that.",
    "speckles on half of every sphere", p + e * s)
OFF("O-center", "c + (r + 2^-30 size) n",
    "if the normal points inward, this is a point on the opposite side of the sphere.",
    "right outside; hollow spheres dark inside", c + (r + e * s) * n)
OFF("O-step", "2^-30 size n", "this is only the step: start at p and add it.",
    "shadows and mirrors as if everything were at the origin of the world", (e * s) * n)
OFF("O-radius", "p + 2^-30 r n",
    "far from the origin of the world numbers are coarse, even on a small sphere: include the "
    "coordinates of the center.",
    "speckles on small spheres that are far away from the origin", p + e * r * n)
OFF("O-coordinate", "p + 2^-30 max(|cx|, |cy|, |cz|) n",
    "near the origin of the world that is almost 0. Include the radius.",
    "speckles on spheres around the origin", p + e * largest_coordinate(c) * n)
OFF("O-point", "p + 2^-30 max(|px|, |py|, |pz|) n",
    "near the origin of the world that is almost 0, but p was computed from large numbers: radius "
    "and center.",
    "speckles where a large sphere passes near the origin", p + e * largest_coordinate(p) * n)
OFF("O-x", "p + 2^-30 (r + |cx|) n", "the largest of the three coordinates counts, x, y or z.",
    "speckles on spheres that are far up or far ahead", p + e * (r + fabs(c[0])) * n)
OFF("O-sign", "p + 2^-30 (r + max(cx, cy, cz)) n",
    "-1000 is as large and as coarse as 1000: use absolute values.",
    "speckles on spheres with negative coordinates", p + e * (r + largest(c)) * n)
OFF("O-sum", "p + 2^-30 (r + cx + cy + cz) n",
    "negative coordinates cancel the others. The largest absolute value counts.",
    "speckles here and there, depending on where a sphere is", p + e * (r + c[0] + c[1] + c[2]) * n)
OFF("O-square", "p + 2^-30 size^2 n",
    "in a scene of twice the size, the step must be twice as long, not four times.",
    "speckles in small scenes; in large ones shadows that start too late", p + e * s * s * n)
OFF("O-1e-3s", "p + 1e-3 size n",
    "this step is so long that it jumps over objects close to the surface.",
    "light under objects on a surface", p + 1e-3 * s * n)
OFF("O-1e-5s", "p + 1e-5 size n",
    "doubles have 16 digits: a smaller step is enough, and objects close to the surface still cast "
    "their shadows.",
    "light under small objects on a surface", p + 1e-5 * s * n)
OFF("O-1e-6s", "p + 1e-6 size n",
    "doubles have 16 digits: 1e-9 is enough, and objects close to the surface still cast their "
    "shadows.",
    "hardly anything; an edge of light under very small objects", p + 1e-6 * s * n)
OFF("O-float", "p + 2^-23 size n", "this is the precision of a float. A double is much finer.",
    "hardly anything; an edge of light under very small objects", p + 0x1p-23 * s * n)
OFF("O-1", "p + n",
    "the normal has length 1, and that may be more than the whole sphere: only a tiny part of it "
    "is needed.",
    "shadows and mirrors that belong to some other place", p + n)

#define FIXED_ROW(number)                                                                          \
    OFF("O-" #number, "p + " #number " n",                                                         \
        #number " is huge in a scene of the size of an atom and nothing in one of the size of a "  \
                "galaxy. Let it grow with the numbers.",                                           \
        "right in scenes of one size, speckles or lost shadows in others", p + number * n)

FIXED_ROW(0.1)
FIXED_ROW(0.01)
FIXED_ROW(0.001)
FIXED_ROW(1e-4)
FIXED_ROW(1e-5)
FIXED_ROW(1e-6)
FIXED_ROW(1e-7)
FIXED_ROW(1e-8)
FIXED_ROW(1e-9)

// ---- wrong answers to visibility ----------------------------------------------------------------

// Up to which t a hit is nearer than the light.
static double reach_of(Light light)
{
    return light.kind == LIGHT_DISTANT ? NO_HIT : 1;
}

// How many of the spheres from first up to end, without that one, the ray hits at such a t.
static int hits_of(const Scene *scene, int first, int end, Ray ray, double least, double reach)
{
    int count = 0;
    for (int i = first; i < end && i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        count += t > least && t < reach;
    }
    return count;
}

static bool is_free(const Scene *scene, Ray ray, double least, double reach)
{
    return hits_of(scene, 0, scene->sphere_count, ray, least, reach) == 0;
}

// No near root (0) or no far root (1) of any sphere is there.
static bool is_free_of_roots(const Scene *scene, int which, Ray ray, double least, double reach)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        if (roots.count > 0 && roots.t[which] > least && roots.t[which] < reach)
            return false;
    }
    return true;
}

// l is the position of the light; ray is the right one to it, and reach the t at which
// the light is. The result is the last expression.
#define SHADOW(id, formula, why, picture, ...)                                                     \
    WRONG(visibility, id, formula, why, picture)                                                   \
    {                                                                                              \
        const Ray ray = ray_to_light(from, light);                                                 \
        const double reach = reach_of(light);                                                      \
        const int count = scene->sphere_count;                                                     \
        LETTER(int, hiding) = hits_of(scene, 0, count, ray, 0, reach);                             \
        LETTER(vec3, v) = ray.direction;                                                           \
        LETTER(vec3, l) = light.position;                                                          \
        return __VA_ARGS__;                                                                        \
    }

SHADOW("V-beyond", "any hit at all",
       "a point light is at t = 1 of its ray, and a sphere behind the light is not in its way.",
       "shadows of objects behind the lamp", is_free(scene, ray, 0, NO_HIT))
SHADOW("V-reach1", "hits with t < 1, even of a distant light",
       "the tip of its direction is at t = 1; the light itself is beyond everything.",
       "in sunlight only very close objects cast a shadow", is_free(scene, ray, 0, 1))
SHADOW("V-unit", "hits with t < 1, of a direction of length 1",
       "then the point light is at t = its distance. If you do not normalise the direction, it is "
       "at t = 1.",
       "shadows of objects behind the lamp, or hardly any",
       is_free(scene, (Ray){from, vec3_unit(v)}, 0, reach))
SHADOW("V-distance", "hits with t < |position - from|",
       "t counts in lengths of the direction, which is as long as the distance of the light: it is "
       "at t = 1.",
       "shadows of objects behind the lamp", is_free(scene, ray, 0, vec3_length(v)))
SHADOW("V-reversed", "the ray away from the light",
       "from the point to the light it is position - from, and a sphere on the other side of the "
       "point is not in the way.",
       "shadows on the wrong side", is_free(scene, (Ray){from, -v}, 0, reach))
SHADOW("V-minus", "position as direction, even of a point light",
       "position is a point here. The vector to it is position - from.",
       "shadows in one direction, as in the sun, and at wrong places",
       is_free(scene, (Ray){from, l}, 0, reach))
SHADOW("V-always-minus", "position - from, even of a distant light",
       "a distant light is in the same direction from everywhere: position is that direction.",
       "shadows in the sun that spread as from a lamp",
       is_free(scene, (Ray){from, l - from}, 0, reach))
SHADOW("V-lamp", "a distant light like a point light",
       "a distant light has no place: position is its direction, and nothing is behind the light.",
       "shadows in the sun that spread as from a lamp", is_free(scene, (Ray){from, l - from}, 0, 1))
SHADOW("V-origin", "the ray from the world's origin",
       "test visibility from the given point: does the light arrive there?",
       "everything dark or everything lit", is_free(scene, (Ray){vec3_of(0, 0, 0), l}, 0, reach))
SHADOW("V-swapped", "position as origin, from as direction",
       "a ray needs a point to start from, and a direction: position - from.",
       "shadows in random places", is_free(scene, (Ray){l, from}, 0, reach))
SHADOW("V-through", "any hit of the ray from the light",
       "a hit behind the point is not between the two: 0 < t < 1 only.",
       "surfaces with an object behind them are dark as well",
       is_free(scene, (Ray){from + v, -v}, 0, NO_HIT))

#define SHADOW_FROM(number, digits, objects)                                                       \
    SHADOW("V-" #number, "hits with t > " digits,                                                  \
           "a sphere close to the surface also casts a shadow. The point is off its surface "      \
           "already: t > "                                                                         \
           "0.",                                                                                   \
           "light under " objects " on a surface", is_free(scene, ray, number, reach))
#define SHADOW_BEFORE(number)                                                                      \
    SHADOW("V-" #number, "hits with t < " #number,                                                 \
           "the light is at t = 1, and a sphere just in front of it hides it.",                    \
           "a lamp that shines through its own shade", is_free(scene, ray, 0, (number)*reach))

SHADOW_FROM(1e-3, "0.001", "objects")
SHADOW_FROM(1e-4, "1e-4", "objects")
SHADOW_FROM(1e-5, "1e-5", "small objects")
SHADOW_FROM(1e-6, "1e-6", "small objects")
SHADOW_FROM(1e-7, "1e-7", "small objects")
SHADOW_FROM(1e-8, "1e-8", "small objects")
SHADOW_FROM(1e-9, "1e-9", "small objects")
SHADOW_BEFORE(0.999)
SHADOW_BEFORE(0.9999)
SHADOW("V-only-beyond", "hits with t > 1",
       "those are behind the light. In between means 0 < t < 1.",
       "shadows of objects behind the lamp, and of no others", is_free(scene, ray, reach, NO_HIT))
SHADOW("V-last", "only the last sphere",
       "each sphere overwrites what was found before. One that hides the light is enough: return "
       "at once.",
       "shadows of one sphere only",
       hits_of(scene, count > 0 ? count - 1 : 0, count, ray, 0, reach) == 0)
SHADOW("V-first", "only the first sphere",
       "if the first does not hide the light, another one may: only after the loop you know that "
       "none does.",
       "shadows of one sphere only", hits_of(scene, 0, 1, ray, 0, reach) == 0)
SHADOW("V-all", "0 only if every sphere is in between", "one sphere in between is enough.",
       "hardly any shadow", count == 0 || hiding < count)
SHADOW("V-from1", "sphere 0 left out", "spheres are counted from 0.",
       "the first sphere casts no shadow", hits_of(scene, 1, count, ray, 0, reach) == 0)
SHADOW("V-but-last", "the last sphere left out",
       "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
       "the last sphere casts no shadow", hits_of(scene, 0, count - 1, ray, 0, reach) == 0)
SHADOW("V-behind", "near roots with t < 1, even negative ones",
       "a hit with t < 0 is on the other side of the point, away from the light.",
       "objects behind a surface cast shadows on it",
       is_free_of_roots(scene, 0, ray, -INFINITY, reach))
SHADOW("V-line", "any root, even behind the point or the light", "in between means 0 < t < 1.",
       "far too many shadows", is_free_of_roots(scene, 0, ray, -INFINITY, INFINITY))
SHADOW("R8-shadow", "near roots only",
       "from inside a sphere the near root is behind the point, but the way to a light outside "
       "still hits the far side.",
       "light inside closed spheres", is_free_of_roots(scene, 0, ray, 0, reach))
SHADOW("R6-shadow", "far roots only",
       "a light inside a sphere is hidden by the side where the ray enters.",
       "lamps that shine out of closed spheres", is_free_of_roots(scene, 1, ray, 0, reach))

WRONG(visibility, "V-center", "hits of spheres whose center is nearer than the light",
      "light and point may be in front of a sphere's center, or inside it. The hit on its surface "
      "counts.",
      "parts of shadows missing near lamps")
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count; i++) {
        double away = vec3_length(scene->spheres[i].center - from) / vec3_length(ray.direction);
        if (hit_sphere(ray, scene->spheres[i]) < NO_HIT && away < reach_of(light))
            return 0;
    }
    return 1;
}

SHADOW("V-inverted", "1 in the shadow, 0 in the light",
       "the return value is the fraction of the light that arrives: 0 if a sphere is in between.",
       "light only where shadows should be", hiding > 0)
SHADOW("V-1", "1", "spheres in between hide the light.", "no shadows", 1)
SHADOW("V-0", "0", "if no sphere is in between, all of the light arrives.", "no light at all", 0)
SHADOW("V-half", "1/2 in the shadow",
       "none of this light arrives there. Shadows are not black because of the ambient light.",
       "pale shadows", hiding == 0 ? 1 : 0.5)
SHADOW("V-halves", "half for each sphere in between",
       "one is enough to hide the light, and more spheres hide no more than that.",
       "pale shadows, darker where they overlap", ldexp(1, -hiding))
SHADOW("V-less", "minus 1 for each sphere in between",
       "light cannot be negative: with two spheres in between this is below 0.",
       "shadows too dark where they overlap", 1 - hiding)

WRONG(visibility, "V-glass", "times the transmittance of the spheres in between",
      "here any sphere hides the light, glass as well as stone.", "pale shadows of glass")
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light))
            visible *= scene_surface(scene, i)->transmittance;
    return visible;
}

SHADOW("V-t", "t of the hit",
       "the return value is 0 or 1. The distance of the sphere in between does not matter.",
       "shadows with a gradient", hiding > 0 ? nearest_hit(ray, scene).t : 1)

#define SHADOW_ROOM(number)                                                                        \
    SHADOW("V-room" #number, "the first " #number " spheres",                                      \
           "the number of spheres in the scene is sphere_count.",                                  \
           "no visible difference, until a scene has more spheres",                                \
           hits_of(scene, 0, number, ray, 0, reach) == 0)
#define SHADOW_TO(number)                                                                          \
    SHADOW("V-to-" #number, "of a distant light, hits with t < " #number,                          \
           "a distant light is beyond everything, and its direction has any length: t of a hit "   \
           "has no upper limit.",                                                                  \
           "in sunlight distant objects cast no shadow",                                           \
           is_free(scene, ray, 0, fmin(number, reach)))

SHADOW_ROOM(8)
SHADOW_ROOM(10)
SHADOW_ROOM(16)
SHADOW_ROOM(32)
SHADOW_ROOM(64)
SHADOW_ROOM(100)
SHADOW_ROOM(128)
SHADOW_ROOM(256)
SHADOW_TO(1000)
SHADOW_TO(1e6)
SHADOW_TO(1e9)
SHADOW("V-points", "1 for every distant light",
       "a sphere in between hides a distant light like any other.", "no shadows in sunlight",
       light.kind == LIGHT_DISTANT || hiding == 0)
SHADOW("V-sun", "1 for every point light",
       "a sphere in between hides a point light like any other.", "no shadows by lamps",
       light.kind == LIGHT_POINT || hiding == 0)

WRONG(visibility, "V-break", "the spheres up to the first miss",
      "a sphere that is missed says nothing about the next one: only after the loop you know that "
      "none is in between.",
      "shadows missing, depending on the order of the scene")
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t == NO_HIT)
            return 1;
        if (t < reach_of(light))
            return 0;
    }
    return 1;
}

// ---- wrong answers to shade ---------------------------------------------------------------------

// What is known at a hit, and then of one light. The normal is on the side of the eye; visible is
// the share of the light that arrives; scattered and mirrored are that light for the two terms.
typedef struct {
    const Scene *scene;
    Sphere sphere;
    const Surface *surface;
    double kd, ks, shine;
    vec3 point, normal, start, to_eye;
    vec3 to_light;
    double visible;
    Color color, scattered, mirrored;
} Lit;

static Lit place_on(const Surface *s, const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
    if (vec3_dot(normal, ray.direction) > 0)
        normal = -normal;
    return (Lit){.scene = scene,
                 .sphere = sphere,
                 .surface = s,
                 .kd = s->diffuse,
                 .ks = s->specular,
                 .shine = s->shine,
                 .point = point,
                 .normal = normal,
                 .start = offset_from_surface(sphere, point, normal),
                 .to_eye = -ray.direction};
}

static Lit place_of(const Scene *scene, Ray ray, Hit hit)
{
    return place_on(scene_surface(scene, hit.sphere), scene, ray, hit);
}

static Lit lit_by(Lit l, Light light)
{
    l.to_light = ray_to_light(l.point, light).direction;
    l.visible = visibility(l.scene, l.start, light);
    l.color = light.color;
    l.scattered = l.mirrored = l.visible * light.color;
    return l;
}

static Color ambient_of(Lit p)
{
    return ambient_term(p.surface->color, p.surface->diffuse, p.scene->ambient);
}

static Color diffuse_of(Lit l)
{
    return diffuse_term(l.surface->color, l.kd, l.scattered, l.normal, l.to_light);
}

static Color both_of(Lit l)
{
    return diffuse_of(l) + phong_term(l.ks, l.shine, l.mirrored, l.normal, l.to_light, l.to_eye);
}

static Color lights_of(Lit p)
{
    Color sum = grey(0);
    for (int i = 0; i < p.scene->light_count; i++)
        sum += both_of(lit_by(p, p.scene->lights[i]));
    return sum;
}

static Color all_of(Lit p)
{
    return ambient_of(p) + lights_of(p);
}

// At the right place p something is changed before the usual sum, or another sum is returned.
#define AT(id, formula, why, picture, ...)                                                         \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        Lit p = place_of(scene, ray, hit);                                                         \
        __VA_ARGS__;                                                                               \
        return all_of(p);                                                                          \
    }

AT("S-ambient", "the lights alone",
   "the scene also has a light that is everywhere: add its term once.", "pitch-black shadows",
   return lights_of(p))
AT("S-only-ambient", "ambient alone",
   "each light that arrives adds its diffuse and its specular term. If you add them: does the ray "
   "to the light start on the eye's side of the surface, or below it? And does the vector point to "
   "the light, or away from it?",
   "flat and dark spheres", return ambient_of(p))
AT("S-flat", "the surface's color",
   "that is chapter 06: now the lights decide how much of it is seen.", "flat spheres, as before",
   return p.surface->color)
AT("S-clamp", "the sum, at most 1",
   "colors are clamped only at the very end, by clamp_color; in a mirror this one may be just "
   "right.",
   "no visible difference, except for dull highlights in mirrors", return clamp_color(all_of(p)))
AT("S-twice", "the whole sum times the surface's color",
   "the terms contain the color already; and highlights have that of the light.",
   "colors too dark, highlights as if of colored metal", return all_of(p) * p.surface->color)
AT("S-each", "ambient once for each light",
   "it does not depend on the lights: add it once, before the loop.",
   "pale shadows where there are several lights",
   return scene->light_count * ambient_of(p) + lights_of(p))
AT("S-average", "the mean of the lights", "two lamps give more light than one: they add up.",
   "darker with every light that is added",
   return ambient_of(p) + lights_of(p) / fmax(1, scene->light_count))
AT("S-average-all", "the mean of ambient and all lights",
   "two lamps give more light than one: all of it adds up.",
   "darker with every light that is added", return all_of(p) / (1 + scene->light_count))
AT("S-raw", "the ambient light itself",
   "the surface reflects only its part of it: ambient_term has kd and the color.",
   "grey shadows on surfaces of any color", return scene->ambient + lights_of(p))
AT("S-kd", "ambient without kd",
   "the surface scatters only kd of the ambient light as well: ambient_term.", "pale shadows",
   return p.surface->color * scene->ambient + lights_of(p))
AT("S-nff", "SCENE_AMBIENT instead of the scene's ambient light",
   "that is the initial value for a scene from a file. Use the value of this scene.",
   "no visible difference, until a scene has another ambient light",
   return SCENE_AMBIENT * p.kd * p.surface->color + lights_of(p))
AT("S-background", "the background as ambient light", "the scene has both, and they differ.",
   "shadows in the color of the sky",
   return ambient_term(p.surface->color, p.kd, scene->background) + lights_of(p))
AT("S-mirror", "plus ks times the background",
   "mirrors come later, in trace_ray; here there are only lights.", "everything glows a little",
   return all_of(p) + p.ks * scene->background)
AT("S-index", "the surface of the sphere's number",
   "spheres and surfaces are numbered separately; each sphere has the number of its surface: "
   "scene_surface.",
   "spheres in each other's colors", p = place_on(&scene->surfaces[hit.sphere], scene, ray, hit))
AT("S-surface0", "always surface 0", "each sphere has the number of its surface: scene_surface.",
   "all spheres in one color", p = place_on(&scene->surfaces[0], scene, ray, hit))
AT("S-sphere0", "the surface of sphere 0", "the hit has the index of its sphere.",
   "all spheres in the color of the first", p = place_on(scene_surface(scene, 0), scene, ray, hit))
AT("S-turn", "the normal outward, even from inside",
   "from inside the other side of the surface is visible: reverse the normal if it points away "
   "from the eye.",
   "hollow spheres dark inside, lit by the lights outside",
   p.normal = surface_normal(p.sphere, p.point);
   p.start = offset_from_surface(p.sphere, p.point, p.normal))
AT("W3-shade", "the normal on the side away from the eye",
   "it must point to the side of the eye: if the dot product of the normal and the ray's direction "
   "is positive, reverse it.",
   "dark spheres", p.normal = -p.normal;
   p.start = offset_from_surface(p.sphere, p.point, p.normal))
AT("W-unit", "p - c as normal", "this is as long as the radius: divide by it.",
   "large spheres too bright", p.normal *= p.sphere.radius)
AT("W2-shade", "p / |p| as normal", "the vector from the center to the point is p - c.",
   "right only for a sphere at the origin of the world", p.normal = vec3_unit(p.point))
AT("S-eye", "the ray's direction as direction to the eye",
   "the ray comes from the eye. The direction to the eye is the opposite, -v.",
   "highlights only at edges, opposite the light", p.to_eye = ray.direction)
AT("S-eye-place", "the ray's origin as direction to the eye",
   "this is a point. The vector from the hit to it is -v, or origin - p.",
   "highlights at wrong places", p.to_eye = ray.origin)
AT("S-eye-origin", "-p as direction to the eye",
   "this is the direction to the origin of the world; the eye is where the ray starts.",
   "highlights at wrong places, unless the eye is at the origin", p.to_eye = -p.point)
AT("S-t", "origin + t v / |v|", "t counts in lengths of v, unchanged: origin + t v.",
   "right only for rays of length 1",
   p = place_of(scene, (Ray){ray.origin, vec3_unit(ray.direction)}, hit))
AT("S-from-eye", "visibility from the eye",
   "test visibility from the surface: does the light arrive there?",
   "no shadows, or all dark when the eye is in one", p.start = ray.origin)
AT("S-acne", "visibility from p itself",
   "rounding leaves p on either side of its surface, and from below the surface hides every light: "
   "offset_from_surface.",
   "black speckles on all lit surfaces", p.start = p.point)
AT("S-outside", "inside, the normal reversed for only one of the two",
   "the terms and offset_from_surface both need the normal on the eye's side; if not, the surface "
   "hides "
   "its own light.",
   "hollow spheres dark inside",
   p.start = offset_from_surface(p.sphere, p.point, surface_normal(p.sphere, p.point)))
AT("S-back", "visibility from origin + (1 - 1e-9) t v",
   "this step depends on the distance of the eye. The precision of the numbers depends on the "
   "sphere: offset_from_surface.",
   "speckles on objects close to the eye; lost shadows far away",
   p.start = ray.origin + hit.t * (1 - 1e-9) * ray.direction)

#define START_ROW(number, digits)                                                                  \
    AT("S-" #number, "visibility from p + " digits " n",                                           \
       "this is too far in a small scene and nothing in a huge one: offset_from_surface.",         \
       "right in scenes of one size, speckles or lost shadows in others",                          \
       p.start = p.point + number * p.normal)

START_ROW(1e-3, "0.001")
START_ROW(1e-4, "1e-4")
START_ROW(1e-5, "1e-5")
START_ROW(1e-6, "1e-6")
START_ROW(1e-9, "1e-9")

// Of each light l something is changed before it is added; or something else is added, and then the
// loop continues.
#define EACH_LIGHT(id, formula, why, picture, ...)                                                 \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        Lit p = place_of(scene, ray, hit);                                                         \
        Color sum = ambient_of(p);                                                                 \
        for (int i = 0; i < scene->light_count; i++) {                                             \
            Lit l = lit_by(p, scene->lights[i]);                                                   \
            __VA_ARGS__;                                                                           \
            sum += both_of(l);                                                                     \
        }                                                                                          \
        return sum;                                                                                \
    }

AT("L-diffuse", "no diffuse term",
   "each light that arrives adds both: the diffuse term and the highlight.",
   "highlights on dark spheres", p.kd = 0)
// The guard of the answering process comes after the last light.
AT("L-count", "a loop up to i <= light_count",
   "n lights have the numbers 0 to n - 1. There is no light number light_count: reading past the "
   "end of an array can give anything.",
   "a light that was never set, in any color, or a crash",
   return all_of(p) + both_of(lit_by(p, GUARD_LIGHT)))
AT("L-specular", "no specular term",
   "each light that arrives adds both: the diffuse term and the highlight.",
   "everything as dull as chalk", p.ks = 0)
EACH_LIGHT("L-shadow", "lights added whether they arrive or not", "call visibility first.",
           "no shadows", l.scattered = l.mirrored = l.color)
EACH_LIGHT("L-shadow-d", "diffuse added whether the light arrives or not",
           "without light nothing is scattered. visibility counts for both terms.",
           "no shadows, but highlights that end where shadows should start", l.scattered = l.color)
EACH_LIGHT("L-shadow-s", "specular added whether the light arrives or not",
           "without light there is no highlight. visibility counts for both terms.",
           "highlights in the shadow", l.mirrored = l.color)
EACH_LIGHT("L-inverted", "lights added only if they do not arrive",
           "visibility is 1 if the light arrives.", "light only where shadows should be",
           l.scattered = l.mirrored = (1 - l.visible) * l.color)
EACH_LIGHT("L-white", "all lights white, with brightness 1",
           "each light has its own color: how much red, green and blue it sends.",
           "colored lights look white, weak ones as bright as others",
           l.scattered = l.mirrored = grey(l.visible))
EACH_LIGHT("L-white-d", "diffuse as if of a white light",
           "the diffuse term is the color of the surface times that of the light.",
           "only highlights show the color of the light", l.scattered = grey(l.visible))
EACH_LIGHT("L-white-s", "highlights always white", "highlights have the color of the light.",
           "white highlights in colored light", l.mirrored = grey(l.visible))
EACH_LIGHT("L-metal", "specular times the surface's color",
           "Phong's highlight has the color of the light, whatever the surface's is.",
           "highlights as if of colored metal", l.mirrored *= l.surface->color)
AT("L-swapped", "kd and ks swapped", "kd belongs to the diffuse term, ks to the highlight.",
   "shiny objects dull, dull objects shiny", p.kd = p.surface->specular;
   p.ks = p.surface->diffuse)
AT("L-kd", "diffuse without kd", "kd says how much of the light is scattered.",
   "everything too bright", p.kd = 1)
AT("L-ks", "specular without ks",
   "ks says how much of the light is reflected as by a mirror: chalk reflects nothing.",
   "highlights on everything, even on chalk", p.ks = 1)
AT("L-shine", "a shine of 1", "each surface has its own shine, the power of the cosine.",
   "broad, blurred highlights", p.shine = 1)
AT("L-shine2", "twice the shine", "the power of the cosine is shine itself.",
   "highlights too small", p.shine *= 2)
EACH_LIGHT("L-halfway", "Blinn's highlight", "this function needs Phong's: phong_term.",
           "highlights too broad", sum += diffuse_of(l);
           sum += halfway_term(l.ks, l.shine, l.mirrored, l.normal, l.to_light, l.to_eye); continue)
EACH_LIGHT("L-square", "light divided by the distance squared",
           "it is so in reality; here a light has the same brightness at any distance.",
           "dark, except right beside the lamps",
           l.scattered = l.mirrored /= vec3_dot(l.to_light, l.to_light))
EACH_LIGHT("L-root", "light divided by the distance",
           "here a light has the same brightness at any distance.",
           "dark, except right beside the lamps",
           l.scattered = l.mirrored /= vec3_length(l.to_light))
EACH_LIGHT("L-eye", "the direction to the eye instead of the direction to the light",
           "the ray comes from the eye; the light is elsewhere.",
           "as if there were a lamp at the eye", l.to_light = l.to_eye)
EACH_LIGHT("L-clamp", "each light at most 1",
           "colors are clamped only at the very end, by clamp_color.",
           "no visible difference, except for bright lights in mirrors",
           sum += at_most_1(both_of(l));
           continue)
EACH_LIGHT("L-distant", "position as direction to a light, not position - p",
           "only a distant light is a direction; the vector to a point light is position - p. "
           "ray_to_light does this.",
           "light as if of the sun, from a wrong direction", l.to_light += l.point)

static Color with_lights(const Scene *scene, int first, int end, Ray ray, Hit hit)
{
    Scene some = *scene;
    some.lights += first;
    some.light_count = end > first ? end - first : 0;
    return shade(&some, ray, hit);
}

// The first light that arrives, or that does not; light_count if there is none.
static int first_light(const Scene *scene, Ray ray, Hit hit, bool arrives)
{
    Lit p = place_of(scene, ray, hit);
    int i = 0;
    while (i < scene->light_count && (lit_by(p, scene->lights[i]).visible > 0) != arrives)
        i++;
    return i;
}

// hidden is the first light that is hidden, or count; lit says whether any light arrives.
#define LIGHTS(id, formula, why, picture, answer)                                                  \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        const int count = scene->light_count;                                                      \
        LETTER(int, hidden) = first_light(scene, ray, hit, false);                                 \
        LETTER(bool, lit) = first_light(scene, ray, hit, true) < count;                            \
        return answer;                                                                             \
    }

LIGHTS("L-first", "the first light only", "all lights add up.",
       "too dark, shadows of one lamp only", with_lights(scene, 0, count > 0, ray, hit))
LIGHTS("L-last", "the last light only", "each light overwrites the one before. They add up: +=.",
       "too dark, shadows of one lamp only",
       with_lights(scene, count > 0 ? count - 1 : 0, count, ray, hit))
LIGHTS("L-from1", "light 0 left out", "lights are counted from 0.", "the first lamp is off",
       with_lights(scene, count > 0, count, ray, hit))
LIGHTS("L-but-last", "the last light left out",
       "counted from 0, the last of n lights has the index n - 1, and it must be added.",
       "the last lamp is off", with_lights(scene, 0, count - 1, ray, hit))
LIGHTS("L-break", "lights up to the first that is hidden",
       "the next light may still arrive: go on with it.", "shadows of one lamp darken the others",
       with_lights(scene, 0, hidden, ray, hit))
LIGHTS("L-any", "ambient only, if any light is hidden",
       "a hidden light does not take away the others.", "shadows of one lamp where another shines",
       with_lights(scene, 0, hidden < count ? 0 : count, ray, hit))
LIGHTS("L-black", "black if no light arrives",
       "the ambient light is everywhere, also in the shadow.", "pitch-black shadows",
       lit || count == 0 ? shade(scene, ray, hit) : grey(0))
LIGHTS("L-black-any", "black if any light is hidden",
       "the ambient light is everywhere; and the other lights may arrive.",
       "pitch-black shadows, also where another lamp shines",
       hidden < count ? grey(0) : shade(scene, ray, hit))
// Ambient light as if it came from each light, and were hidden with it.

WRONG(shade, "L-ambient", "ambient with each light that arrives",
      "ambient light comes from no particular place and nothing hides it: add it once.",
      "pitch-black shadows; too bright where several lights arrive")
{
    Lit p = place_of(scene, ray, hit);
    Color sum = lights_of(p);
    for (int i = 0; i < scene->light_count; i++)
        sum += lit_by(p, scene->lights[i]).visible * ambient_of(p);
    return sum;
}

LIGHTS("L-sky", "the background if no light arrives",
       "the surface is still there, in ambient light.", "holes instead of shadows",
       lit ? shade(scene, ray, hit) : scene->background)

#define LIGHTS_ROW(number)                                                                         \
    LIGHTS("L-room" #number, "the first " #number " lights",                                       \
           "the number of lights in the scene is light_count.",                                    \
           "no visible difference, until a scene has more lights",                                 \
           with_lights(scene, 0, count < number ? count : number, ray, hit))
#define FIELDS(id, formula, why, ...)                                                              \
    AT(id, formula, why, "highlights or colors of another surface", __VA_ARGS__)

LIGHTS_ROW(4)
LIGHTS_ROW(8)
LIGHTS_ROW(10)
LIGHTS_ROW(16)
LIGHTS_ROW(32)
FIELDS("L-ks-shine", "ks instead of shine",
       "ks is the strength of the highlight; shine is the power.", p.shine = p.ks)
FIELDS("L-shine-ks", "shine instead of ks",
       "shine is the power; ks is the strength of the highlight.", p.ks = p.shine)
FIELDS("L-ks-and-shine", "ks and shine swapped", "phong_term takes ks first, then shine.",
       p.ks = p.surface->shine;
       p.shine = p.surface->specular)
FIELDS("L-kd-ks", "kd instead of ks",
       "kd belongs to the diffuse term; the highlight has ks, the surface's specular.", p.ks = p.kd)
FIELDS("L-ks-kd", "ks instead of kd",
       "ks belongs to the highlight; the diffuse term has kd, the surface's diffuse.", p.kd = p.ks)
FIELDS("L-rest-ks", "1 - kd instead of ks", "kd + ks need not be 1: the surface has its own ks.",
       p.ks = 1 - p.kd)
FIELDS("L-rest-kd", "1 - ks instead of kd", "kd + ks need not be 1: the surface has its own kd.",
       p.kd = 1 - p.ks)

// ---- wrong answers to trace_ray -----------------------------------------------------------------

// A ray, and what is made of the color that it sees.
typedef struct {
    const Scene *scene;
    Ray ray;
    int depth;
    int mirrors;            // that it comes from
    double share, first_ks; // how much of its color they return, and the ks of the first
    int unseen;             // a sphere that it does not hit; -1: none
    Hit hit;
    Lit p;           // the place of the hit
    Color own, seen; // the colors of that place and of the mirrored ray
    Ray mirrored;
    int mirrored_depth;
    Color sum;
} Look;

// When a slip changes something: if nothing is hit; before the mirrored ray is followed; after its
// color was added; or in any case at the end.
typedef enum { MISSES, AIMS, ADDS, ENDS } Moment;
typedef void Slip(Look *look, Moment now);

static Hit hit_of(const Look *look)
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < look->scene->sphere_count; i++) {
        double t = hit_sphere(look->ray, look->scene->spheres[i]);
        if (t < best.t && i != look->unseen)
            best = (Hit){t, i};
    }
    return best;
}

static Color look_along(Slip *slip, Look look)
{
    look.hit = hit_of(&look);
    look.sum = look.scene->background;
    if (look.hit.sphere < 0) {
        slip(&look, MISSES);
        slip(&look, ENDS);
        return look.sum;
    }
    look.p = place_of(look.scene, look.ray, look.hit);
    look.own = shade(look.scene, look.ray, look.hit);
    look.mirrored = (Ray){look.p.start, mirror_direction(look.ray.direction, look.p.normal)};
    look.mirrored_depth = look.depth - 1;
    look.first_ks = look.mirrors == 0 ? look.p.ks : look.first_ks;
    slip(&look, AIMS);
    look.sum = look.own;
    if (look.depth > 0 && look.p.ks != 0) {
        Look next = look;
        next.ray = look.mirrored;
        next.depth = look.mirrored_depth;
        next.mirrors++;
        next.share *= look.p.ks;
        look.seen = look_along(slip, next);
        look.sum += look.p.ks * look.seen;
        slip(&look, ADDS);
    }
    slip(&look, ENDS);
    return look.sum;
}

#define MIRROR(moment, ...) MIRROR_OF(__COUNTER__, moment, __VA_ARGS__)
#define MIRROR_OF(number, ...) MIRROR_BY(number, __VA_ARGS__)
#define MIRROR_BY(number, moment, id, formula, why, picture, ...)                                  \
    static void slip_##number(Look *look, Moment now)                                              \
    {                                                                                              \
        if (now == moment) {                                                                       \
            __VA_ARGS__;                                                                           \
        }                                                                                          \
    }                                                                                              \
    WRONG(trace_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        Look look = {.scene = scene, .ray = ray, .depth = depth, .share = 1, .unseen = -1};        \
        return look_along(slip_##number, look);                                                    \
    }

MIRROR(AIMS, "T-into", "a direction into the surface: v, v + 2 (v.n) n or -(v - 2 (v.n) n)",
       "a mirror sends the ray away from its surface, at the same angle: mirror_direction. This "
       "one hits the same place again.",
       "shiny objects too bright, with nothing in them but themselves",
       look->mirrored.direction = look->ray.direction)
MIRROR(AIMS, "T-back", "the ray goes back to where it came from",
       "that is right only straight ahead. In general the ray leaves at the same angle, on the "
       "other side of the normal: mirror_direction.",
       "every mirror shows the scene behind the eye",
       look->mirrored.direction = -look->ray.direction)
MIRROR(AIMS, "T-normal", "along the normal",
       "the ray leaves at the same angle as it arrives: mirror_direction.",
       "mirrors show the same from everywhere", look->mirrored.direction = look->p.normal)
MIRROR(AIMS, "T-once", "v - (v.n) n",
       "this runs along the surface. Subtract twice as much: mirror_direction.",
       "mirrors show the scene beside them",
       look->mirrored.direction = (look->ray.direction + look->mirrored.direction) / 2)
MIRROR(AIMS, "T-eye", "the mirrored ray from the eye", "it starts at the point of the hit.",
       "mirrors show the scene beside the eye", look->mirrored.origin = look->ray.origin)
MIRROR(AIMS, "T-center", "the mirrored ray from the center", "it starts at the point of the hit.",
       "every ball shows its own inside", look->mirrored.origin = look->p.sphere.center)
MIRROR(AIMS, "T-acne", "the mirrored ray from the surface itself",
       "rounding leaves the point on either side of the surface, and from below the ray hits the "
       "surface that it starts from: offset_from_surface.",
       "speckles in mirrors", look->mirrored.origin = look->p.point)
MIRROR(AIMS, "T-below", "the mirrored ray from below the surface",
       "offset_from_surface moves to the side of the normal: give it the normal on the eye's side.",
       "every ball shows its own inside",
       look->mirrored.origin = offset_from_surface(look->p.sphere, look->p.point, -look->p.normal))
MIRROR(AIMS, "T-outside", "the mirrored ray from outside, even from inside a sphere",
       "from inside it must stay inside: give offset_from_surface the normal on the eye's side.",
       "hollow mirrors show the scene outside",
       look->mirrored.origin = offset_from_surface(look->p.sphere, look->p.point,
                                                   surface_normal(look->p.sphere, look->p.point)))
MIRROR(AIMS, "T-along", "the mirrored ray from origin + (1 - 1e-9) t v",
       "this step depends on the distance of the eye. The precision of the numbers depends on the "
       "sphere: offset_from_surface.",
       "speckles in mirrors that are close to the eye or far from the origin",
       look->mirrored.origin = look->ray.origin + look->hit.t * (1 - 1e-9) * look->ray.direction)

#define MIRROR_ROW(number, digits)                                                                 \
    MIRROR(AIMS, "T-" #number, "the mirrored ray from p + " digits " n",                           \
           "this is too far in a small scene and nothing in a huge one: offset_from_surface.",     \
           "right in scenes of one size, speckles in others",                                      \
           look->mirrored.origin = look->p.point + number * look->p.normal)

MIRROR_ROW(1e-3, "0.001")
MIRROR_ROW(1e-6, "1e-6")
MIRROR_ROW(1e-9, "1e-9")
MIRROR(AIMS, "T-itself", "a mirrored ray that cannot hit its own sphere",
       "from outside it does not, but inside a hollow ball it hits the other side.",
       "hollow mirrors without mirror images", look->unseen = look->hit.sphere)
MIRROR(AIMS, "T-ks", "all of the mirrored color", "specular says how much of it comes back.",
       "every shiny object a perfect mirror", look->p.ks = look->p.ks == 0 ? 0 : 1)
MIRROR(AIMS, "T-kd", "kd times the mirrored color",
       "kd belongs to the diffuse term; the mirror has ks.",
       "bright objects mirror, whether shiny or not", look->p.ks = look->p.ks == 0 ? 0 : look->p.kd)
MIRROR(AIMS, "T-rest", "1 - kd times the mirrored color",
       "kd + ks need not be 1: the surface has its own ks.", "mirrors too strong or too weak",
       look->p.ks = look->p.ks == 0 ? 0 : 1 - look->p.kd)
MIRROR(AIMS, "T-square", "ks times ks of the mirrored color",
       "each mirror multiplies by its ks once.", "mirrors too weak", look->p.ks *= look->p.ks)
MIRROR(ADDS, "T-blend", "(1 - ks) times shade + ks times the mirror",
       "kd and ks already say how much there is of each; keep the whole color of shade.",
       "shiny objects too dark", look->sum -= look->p.ks * look->own)
MIRROR(ADDS, "T-color", "the mirror in the surface's color",
       "here mirrors are like highlights: they do not change the color.",
       "mirrors as if of colored metal",
       look->sum = look->own + look->p.ks * look->p.surface->color * look->seen)
MIRROR(ADDS, "T-only", "ks times the mirror, without shade",
       "the surface still reflects its lights: add the color of shade.",
       "shiny objects without their own color", look->sum -= look->own)
MIRROR(ADDS, "T-both", "ks times (shade + the mirror)",
       "the color of shade has its kd and ks already; multiply only the mirror.",
       "shiny objects too dark", look->sum = look->p.ks * (look->own + look->seen))
MIRROR(ADDS, "T-times", "shade times the mirror", "light adds up: add the two colors.",
       "shiny objects too dark", look->sum = look->own * look->seen)
MIRROR(ADDS, "T-mean", "the mean of shade and the mirror",
       "specular says how much of the mirror is added.", "all mirrors are alike",
       look->sum = (look->own + look->seen) / 2)
MIRROR(ADDS, "T-clamp", "the sum, at most 1",
       "colors are clamped only at the very end, by clamp_color; in the next mirror this one may "
       "be just right.",
       "dull highlights in mirrors", look->sum = at_most_1(look->sum))
MIRROR(ADDS, "T-clamp-seen", "the mirrored color, at most 1",
       "colors are clamped only at the very end, by clamp_color; in a mirror this one may be just "
       "right.",
       "dull highlights in mirrors", look->sum = look->own + look->p.ks * at_most_1(look->seen))
MIRROR(MISSES, "T-black", "black instead of the background in mirrors",
       "a mirrored ray that hits nothing sees the background, like any other.",
       "mirrors too dark where they show the sky", if (look->mirrors > 0) look->sum = grey(0))
MIRROR(MISSES, "T-night", "black if nothing is hit", "the scene has its own background color.",
       "everything on black", look->sum = grey(0))
MIRROR(MISSES, "T-ambient-sky", "the ambient light if nothing is hit",
       "the scene has both, and they differ: use its background.", "a grey background",
       look->sum = look->scene->ambient)
MIRROR(AIMS, "T-flat", "flat colors", "a surface that is hit is lit: shade.",
       "flat spheres with mirror images", look->own = look->p.surface->color)
MIRROR(AIMS, "T-ambient", "ambient light only",
       "a surface that is hit is lit by every light that arrives: shade.",
       "dark spheres with mirror images", look->own = ambient_of(look->p))
MIRROR(AIMS, "T-highlight", "shade without highlights",
       "the highlight is the mirror image of the lamp, which no ray can hit. Keep it.",
       "mirrors without highlights", Lit dull = look->p;
       dull.ks = 0; look->own = all_of(dull))
MIRROR(AIMS, "T-away", "shade with the normal turned away from the eye",
       "the lit side is the one that the eye sees, and the normal points to that side.",
       "dark spheres with mirror images", Lit p = look->p;
       p.normal = -p.normal; p.start = offset_from_surface(p.sphere, p.point, p.normal);
       look->own = all_of(p))

// The usual color for another depth.
#define DEPTH(id, formula, why, picture, other)                                                    \
    WRONG_LINE(trace_ray, id, formula, why, picture, return trace_ray(scene, ray, other))

// Without a limit it ends where it leaves the scene. Between mirrors it would go on until the stack
// overflows; here as long as any of it is visible.
DEPTH("T-endless", "no end at depth 0",
      "between two mirrors a ray goes to and fro for ever. If depth is 0, return the color of "
      "shade.",
      "no visible difference, until two mirrors face each other: a stack overflow", 200)
DEPTH("T-deep", "a mirrored ray at depth 0 as well",
      "depth > 0, not >= 0: at 0 there are no more mirrors.",
      "mirror images in mirrors once too often", depth + 1)
DEPTH("T-shallow", "no mirrored ray at depth 1",
      "depth > 0, not > 1: at 1 there is one more mirror.", "mirror images in mirrors once too few",
      depth > 0 ? depth - 1 : 0)
MIRROR(AIMS, "T-two", "depth - 2 at each mirror",
       "each mirror subtracts 1. Do you subtract it twice?",
       "mirror images in mirrors half as deep", look->mirrored_depth = look->depth - 2)
MIRROR(AIMS, "T-halved", "depth halved at each mirror", "each mirror subtracts 1 from it.",
       "mirror images in mirrors not deep enough", look->mirrored_depth = (look->depth + 1) / 2 - 1)
DEPTH("T-one", "depth 1, whatever the argument is",
      "depth is the number of mirrors, one after the other.", "no mirrors in mirrors", 1)
DEPTH("T-once-only", "depth 0 for the mirrored ray", "it has depth - 1 left.",
      "no mirrors in mirrors", depth > 0 ? 1 : 0)
DEPTH("T-least", "a mirror at depth 0 as well, but no deeper",
      "at depth 0 there are no mirrors: return the color of shade.",
      "mirrors where there should be none", depth > 0 ? depth : 1)
DEPTH("T-0", "shade only",
      "if depth > 0 and the surface has specular, add what the mirrored ray sees.", "no mirrors", 0)
DEPTH("T-5", "a depth of at most 5",
      "the caller may ask for a greater depth: depth alone says where it ends.",
      "the deepest mirrors missing", depth < 5 ? depth : 5)
// Reversed: the deeper, the less is left.
DEPTH("T-until", "mirrors only at depth 0",
      "depth is the number of mirrors that are left: it must be more than 0.",
      "mirrors only where there should be none", depth == 0 ? 1 : 0)
MIRROR(ENDS, "T-black0", "black at depth 0",
       "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
       "black; in mirrors black holes", if (look->depth == 0) look->sum = grey(0))
MIRROR(ENDS, "T-sky0", "the background at depth 0",
       "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
       "nothing but background; mirrors show only the sky",
       if (look->depth == 0) look->sum = look->scene->background)
MIRROR(AIMS, "T-sky-behind", "ks times the background at depth 0",
       "at depth 0 return the color of shade.", "the deepest mirrors too bright",
       if (look->depth == 0) look->own += look->p.ks * look->scene->background)
MIRROR(AIMS, "T-flat-end", "flat colors in the last mirror",
       "objects in a mirror are lit like all others: call trace_ray with depth - 1.",
       "flat spheres in mirrors",
       if (look->depth == 0 && look->mirrors > 0) look->own = look->p.surface->color)
MIRROR(AIMS, "T-dull-sky", "the background if ks is 0",
       "a surface without a mirror is still there, and lit: shade.", "dull objects vanish",
       if (look->p.ks == 0) look->own = look->scene->background)
MIRROR(AIMS, "T-dull-black", "black if ks is 0",
       "a surface without a mirror is still there, and lit: shade.", "dull objects are black",
       if (look->p.ks == 0) look->own = grey(0))
MIRROR(AIMS, "T-ks-first", "the first mirror's ks for all", "each surface has its own ks.",
       "mirrors in mirrors too strong or too weak", look->p.ks = look->first_ks)
MIRROR(AIMS, "T-ks-0", "the ks of sphere 0 for all",
       "each surface has its own ks: use that of the sphere that is hit.", "all mirrors are alike",
       look->p.ks = scene_surface(look->scene, 0)->specular)
MIRROR(AIMS, "T-strong", "mirrors only if ks is at least 0.5",
       "a weak mirror is also a mirror: its specular is not 0.", "weak mirrors do not mirror",
       if (look->p.ks < 0.5) look->p.ks = 0)
MIRROR(AIMS, "T-perfect", "mirrors only if ks is 1",
       "a weak mirror is also a mirror: its specular is not 0.", "hardly any mirrors",
       if (look->p.ks < 1) look->p.ks = 0)

#define DEEPEST_ROW(number)                                                                        \
    DEPTH("T-most" #number, "a depth of at most " #number, "the caller may ask for any depth.",    \
          "no visible difference, until mirrors face each other", depth < number ? depth : number)
#define KS_ROW(number)                                                                             \
    MIRROR(AIMS, "T-ks-" #number, "mirrors only if ks is more than " #number,                      \
           "a weak mirror is also a mirror: its specular is not 0.", "weak mirrors do not mirror", \
           if (look->p.ks <= number) look->p.ks = 0)
#define SHARE_ROW(number)                                                                          \
    MIRROR(AIMS, "T-share-" #number,                                                               \
           "mirrors only while more than " #number " of them comes through",                       \
           "only depth and ks decide where it ends: the mirrored object may be bright.",           \
           "mirrors in mirrors missing", if (look->share * look->p.ks < number) look->p.ks = 0)

DEEPEST_ROW(2)
DEEPEST_ROW(3)
DEEPEST_ROW(4)
DEEPEST_ROW(6)
DEEPEST_ROW(8)
DEEPEST_ROW(10)
DEEPEST_ROW(16)
DEEPEST_ROW(20)
DEEPEST_ROW(32)
DEEPEST_ROW(50)
DEEPEST_ROW(100)
KS_ROW(0.1)
KS_ROW(0.01)
KS_ROW(0.001)
KS_ROW(1e-6)
SHARE_ROW(0.01)
SHARE_ROW(0.001)
SHARE_ROW(1e-4)
SHARE_ROW(1e-6)

// ---- wrong answers that are not known mistakes, and the verdict on each -------------------------

UNNAMED(clamp_color, NOBODY, "above 1 only if all three are")
{
    if (color[0] > 1 && color[1] > 1 && color[2] > 1)
        return grey(1);
    return not_below_0(color);
}

UNNAMED(surface_normal, NOBODY, "turned by the sign of n.point")
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, point) < 0 ? -normal : normal;
}

UNNAMED_LINE(shade, NOBODY, "hit point without the origin",
             return shade(scene, (Ray){vec3_of(0, 0, 0), ray.direction}, hit))
UNNAMED_LINE(shade, NOBODY " your function returns the same", "black", return grey(0))

UNNAMED(diffuse_term, NOBODY, "kd squared, and away from the light")
{
    return diffuse_term(surface, kd * kd, light, -normal, to_light);
}

static const int styles = 2;

OF_STEM(styles)
