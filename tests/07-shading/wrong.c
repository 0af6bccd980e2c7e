// wrong.c - wrong answers to exercise 07.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include "tests/judge/known.h"
#include "tests/judge/wire.h"

#include <limits.h>

// ---- wrong normals ------------------------------------------------------------------------------

// All three alike.
static vec3 grey(double x)
{
    return vec3_of(x, x, x);
}

WRONG_LINE(surface_normal, "W2", "point / |point|",
           "this points away from the origin of the world. A sphere's normal points away from its "
           "own centre.",
           "shading that is right only for a sphere around the origin", return vec3_unit(point))
WRONG_LINE(surface_normal, "W2-r", "point / r",
           "a radius leads from the centre to the point, but the centre is missing.",
           "shading that is right only for a sphere around the origin",
           return point / sphere.radius)
WRONG_LINE(surface_normal, "W2-point", "the point itself",
           "this is the vector from the origin of the world, and its length is arbitrary.",
           "spheres too bright, lit from wrong sides", return point)
WRONG_LINE(surface_normal, "W3", "(c - point) / |c - point|",
           "this points into the sphere, to its centre.",
           "dark where it should be light, and light where it should be dark",
           return vec3_unit(sphere.center - point))
WRONG_LINE(surface_normal, "W3-length", "c - point",
           "this points into the sphere, and is as long as its radius.",
           "dark where it should be light, and light where it should be dark",
           return sphere.center - point)
WRONG_LINE(surface_normal, "W-length", "point - c",
           "this is as long as the radius. A normal has length 1; if it is longer, cosines come "
           "out too large.",
           "large spheres too bright, small ones nearly black", return point - sphere.center)
WRONG_LINE(surface_normal, "W-squared", "(point - c) / r^2",
           "point - c has length r, so dividing by r once normalises it.",
           "small spheres too bright, large ones nearly black",
           return (point - sphere.center) / (sphere.radius * sphere.radius))
WRONG_LINE(surface_normal, "W-times", "(point - c) r",
           "point - c has length r already: divide by r.",
           "large spheres too bright, small ones nearly black",
           return (point - sphere.center) * sphere.radius)
WRONG_LINE(surface_normal, "W-plus", "(point + c) / |point + c|",
           "the vector from the centre to the point is the point minus the centre.",
           "spheres lit from wrong sides, worse the farther they are from the origin",
           return vec3_unit(point + sphere.center))
WRONG_LINE(surface_normal, "W-scalar", "point - c - r",
           "subtracting a number from a vector subtracts it from each component. To make it "
           "shorter, divide.",
           "spheres that are dark from most sides, and too bright from the others",
           return point - sphere.center - sphere.radius)
WRONG_LINE(surface_normal, "W-early", "point / |point| - c / |c|",
           "here the lengths are lost before the subtraction. First subtract, then normalise.",
           "nearly black spheres; nothing at all for one around the origin",
           return vec3_unit(point) - vec3_unit(sphere.center))
WRONG_LINE(surface_normal, "W-other", "(point - c) / |point|",
           "divide it by its own length, which is |point - c|.",
           "spheres that are darker, the farther they are from the origin",
           return (point - sphere.center) / vec3_length(point))
WRONG_LINE(surface_normal, "W-brackets", "point - c / r",
           "division comes first, so only c is divided. The difference needs parentheses.",
           "spheres too bright, lit from wrong sides", return point - sphere.center / sphere.radius)

WRONG(surface_normal, "W-largest", "point - c by its largest component",
      "then the largest component is 1. The length is 1 only at six points.",
      "faint edges across each sphere, as on a cube")
{
    vec3 v = point - sphere.center;
    return v / fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

// ---- wrong rays to the light --------------------------------------------------------------------

static bool is_point(Light light)
{
    return light.kind == LIGHT_POINT;
}

// The right direction, for mistakes that change it.
static vec3 way(vec3 from, Light light)
{
    return is_point(light) ? light.position - from : light.position;
}

WRONG_LINE(ray_to_light, "S2-ray", "the direction from the light",
           "it must point towards the light: the end minus the start.",
           "spheres lit on the far side", return (Ray){from, -way(from, light)})
WRONG_LINE(ray_to_light, "S2-point", "from - position, of a point light",
           "this leads from the light to the surface. The end minus the start: position - from.",
           "spheres lit on the side away from a point light",
           return (Ray){from, is_point(light) ? from - light.position : light.position})
WRONG_LINE(ray_to_light, "S2-distant", "-position, of a distant light",
           "scene.h says that a distant light lies in that direction, so it already points towards "
           "the light.",
           "spheres lit on the side away from the sun",
           return (Ray){from, is_point(light) ? light.position - from : -light.position})
WRONG_LINE(ray_to_light, "LI-distant", "position, for both kinds",
           "the direction to a point light depends on the start.",
           "lamps that light like the sun: the same side of every sphere",
           return (Ray){from, light.position})
WRONG_LINE(ray_to_light, "LI-point", "position - from, for both kinds",
           "a distant light has no place. It has a direction, the same from everywhere.",
           "a sun that is as near as a lamp", return (Ray){from, light.position - from})
WRONG_LINE(ray_to_light, "S2-all-point", "from - position, for both kinds",
           "this points away from a point light; and a distant one has no place at all.",
           "spheres lit on the far side", return (Ray){from, from - light.position})
WRONG_LINE(ray_to_light, "LI-kinds", "the kinds swapped", "LIGHT_POINT is the light at a position.",
           "lamps that light like the sun, and a sun like a lamp",
           return (Ray){from, is_point(light) ? light.position : light.position - from})
WRONG_LINE(ray_to_light, "LI-unit", "the direction normalised",
           "then t = 1 is not the light any more, and a search for spheres in between uses the "
           "wrong range of t.",
           "shadows that are missing, or cast by spheres behind the light",
           return (Ray){from, vec3_unit(way(from, light))})
WRONG_LINE(ray_to_light, "LI-unit-point", "(position - from) / |position - from|",
           "then t = 1 is not the light any more, and a search for spheres in between uses the "
           "wrong range of t.",
           "shadows that are missing, or cast by spheres behind the light",
           return (Ray){from, is_point(light) ? vec3_unit(light.position - from) : light.position})
WRONG_LINE(
    ray_to_light, "LI-unit-distant", "position / |position|, of a distant one",
    "the direction is right, but the contract asks for the light's own direction, unchanged.",
    "no visible difference; the terms normalise it anyway",
    return (Ray){from, is_point(light) ? light.position - from : vec3_unit(light.position)})
WRONG_LINE(
    ray_to_light, "LI-back", "from the light to the point",
    "the ray starts at the point and leads to the light. From a distant light no ray can start.",
    "spheres lit on the far side", return (Ray){light.position, -way(from, light)})
WRONG_LINE(ray_to_light, "LI-back-point", "from the point light to the point",
           "the same segment, but reversed: the ray starts at the point, and t = 1 is the light.",
           "spheres lit on the far side",
           return (Ray){is_point(light) ? light.position : from,
                        is_point(light) ? from - light.position : light.position})
WRONG_LINE(ray_to_light, "LI-start", "an origin at the light",
           "the ray starts at the given point, from.", "shadows in odd places",
           return (Ray){light.position, way(from, light)})
WRONG_LINE(ray_to_light, "LI-origin", "an origin of (0, 0, 0)",
           "the ray starts at the given point, from.", "everything in shadow, or nothing",
           return (Ray){vec3_of(0, 0, 0), way(from, light)})
WRONG_LINE(ray_to_light, "LI-plus", "position + from",
           "the vector from one point to another is the end minus the start.",
           "spheres lit from wrong sides, worse the farther they are from the origin",
           return (Ray){from, is_point(light) ? light.position + from : light.position})
WRONG_LINE(ray_to_light, "LI-place", "from + position, of a distant light",
           "this is a point on the way, not a direction.",
           "a sun in another place for every sphere",
           return (Ray){from, is_point(light) ? light.position - from : light.position + from})
WRONG_LINE(ray_to_light, "LI-swapped", "origin and direction swapped",
           "the origin is a point, where the ray starts; the direction is a difference of points.",
           "light and shadow in odd places", return (Ray){way(from, light), from})
WRONG_LINE(ray_to_light, "LI-ahead", "an origin 0.001 of the way ahead",
           "the caller gives the point, and off_surface has already moved it as far as needed.",
           "shadows that start a little beside their spheres",
           return (Ray){from + 0.001 * way(from, light), way(from, light)})
WRONG_LINE(ray_to_light, "LI-ahead-unit", "an origin 0.001 ahead",
           "the caller gives the point, and off_surface has already moved it as far as needed. In "
           "a tiny scene 0.001 is a long way.",
           "tiny scenes without shadows",
           return (Ray){from + 0.001 * vec3_unit(way(from, light)), way(from, light)})

// ---- wrong mirrors ------------------------------------------------------------------------------

WRONG_LINE(mirror_direction, "MI-plus", "v + 2 (v.n) n",
           "this makes the part along the normal three times as large, and keeps its sign.",
           "mirrors that show the inside of their own sphere",
           return direction + 2 * vec3_dot(direction, normal) * normal)
WRONG_LINE(mirror_direction, "MI-once", "v - (v.n) n",
           "this removes the part along the normal, so the rest runs along the surface. To reverse "
           "that part, subtract it twice.",
           "mirrors that show the horizon all over",
           return direction - vec3_dot(direction, normal) * normal)
WRONG_LINE(mirror_direction, "MI-plus-once", "v + (v.n) n",
           "this doubles the part along the normal instead of reversing it.",
           "mirrors that show the inside of their own sphere",
           return direction + vec3_dot(direction, normal) * normal)
WRONG_LINE(mirror_direction, "MI-back", "2 (v.n) n - v",
           "this is for a vector that points away from the surface. This one comes in, so its "
           "mirrored direction is the opposite.",
           "mirrors that show the inside of their own sphere",
           return 2 * vec3_dot(direction, normal) * normal - direction)
WRONG_LINE(mirror_direction, "MI-back-once", "(v.n) n - v",
           "only the part along the surface is left, and it is reversed.",
           "mirrors that show the horizon all over, reversed",
           return vec3_dot(direction, normal) * normal - direction)
WRONG_LINE(
    mirror_direction, "MI-scalar", "v - 2 (v.n)",
    "subtracting a number from a vector subtracts it from each component. The normal is missing.",
    "mirrors that all look towards the same corner",
    return direction - 2 * vec3_dot(direction, normal))
WRONG_LINE(mirror_direction, "MI-opposite", "-v",
           "only a ray along the normal comes straight back.", "mirrors that show only the eye",
           return -direction)
WRONG_LINE(mirror_direction, "MI-on", "v",
           "this goes through the surface, as if it were not there.", "glass instead of mirrors",
           return direction)
WRONG_LINE(mirror_direction, "MI-n", "v - 2n",
           "the part of v along n decides how much to subtract: v.n is missing.",
           "mirrors that show the inside of their own sphere", return direction - 2 * normal)
WRONG_LINE(
    mirror_direction, "MI-normal", "n",
    "the mirrored direction also depends on v. It is as far from n as v is, on the other side.",
    "mirrors that show the same from everywhere", return normal)
WRONG_LINE(mirror_direction, "MI-product", "v - 2 v n n, by components",
           "v * n multiplies component by component. The dot product is vec3_dot.",
           "mirrors that are right only if they face along an axis",
           return direction - 2 * direction * normal * normal)
WRONG_LINE(mirror_direction, "MI-unit", "(v - 2 (v.n) n) / |v|",
           "the direction is right, but it must be as long as v.",
           "no visible difference at first; t counts in other lengths",
           return vec3_unit(direction - 2 * vec3_dot(direction, normal) * normal))
WRONG_LINE(mirror_direction, "MI-part", "v - 2 (v.n / |v|) n",
           "the vector to subtract grows with the length of v: put v itself into the dot product.",
           "mirrors that are right only if v has length 1",
           return direction - 2 * vec3_dot(vec3_unit(direction), normal) * normal)
WRONG_LINE(mirror_direction, "MI-square", "v - 2 (v.v) n",
           "the part of v along n is v.n; v.v is only its squared length.",
           "mirrors that show what is straight above them",
           return direction - 2 * vec3_dot(direction, direction) * normal)
WRONG_LINE(mirror_direction, "MI-side", "v unchanged if v.n is not negative",
           "a mirror has two sides, and the formula is the same for both.",
           "no mirror on the inside of a sphere",
           return vec3_dot(direction, normal) < 0
                      ? direction - 2 * vec3_dot(direction, normal) * normal
                      : direction)
WRONG_LINE(mirror_direction, "MI-abs", "v + 2 |v.n| n",
           "from the other side of the mirror v.n is positive, and then this is wrong.",
           "mirrors that are wrong on the inside of a sphere",
           return direction + 2 * fabs(vec3_dot(direction, normal)) * normal)
WRONG_LINE(mirror_direction, "MI-swapped", "n - 2 (v.n) v",
           "v and n are swapped: this is the normal, mirrored at v.",
           "mirrors full of other parts of the scene",
           return normal - 2 * vec3_dot(direction, normal) * direction)

// ---- wrong ambient and diffuse terms ------------------------------------------------------------

static Color clipped(Color color)
{
    return vec3_of(fmin(1, color[0]), fmin(1, color[1]), fmin(1, color[2]));
}

static double mean(Color color)
{
    return (color[0] + color[1] + color[2]) / 3;
}

// ---- ambient_term -------------------------------------------------------------------------------

#define AMBIENT(id, formula, why, picture, statement)                                              \
    WRONG(ambient_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        statement;                                                                                 \
    }

// ---- diffuse_term -------------------------------------------------------------------------------

// The cosine with the direction to the light, below 0 if that is behind.
static double cosine_of(vec3 normal, vec3 to_light)
{
    return vec3_dot(normal, vec3_unit(to_light));
}

// cosine is the right one, raw is not limited.
#define DIFFUSE(id, formula, why, picture, statement)                                              \
    WRONG(diffuse_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        double raw = cosine_of(normal, to_light), cosine = fmax(0, raw);                           \
        (void)surface, (void)kd, (void)light, (void)cosine;                                        \
        statement;                                                                                 \
    }

AMBIENT("AM-kd", "surface * ambient", "only kd of the light is scattered.",
        "everything in shadow too bright", return surface * ambient)
AMBIENT("AM-kd-twice", "kd^2 * surface * ambient",
        "kd is the share that is scattered: multiply by it once.", "everything in shadow too dark",
        return kd * kd * surface * ambient)
AMBIENT("AM-kd-less-1", "(1 - kd) * surface * ambient",
        "kd is the share that is scattered, not the rest.",
        "bright surfaces dark in the shadow, and dark ones bright",
        return (1 - kd) * surface * ambient)
AMBIENT("AM-surface", "kd * ambient",
        "a red surface reflects only red light: its colour is missing.",
        "all spheres the same grey in the shadow", return kd * ambient)
AMBIENT("AM-ambient", "kd * surface",
        "without ambient light it must be black: the light is missing.",
        "flat discs, as if there were no shadow", return kd * surface)
AMBIENT("AM-alone", "ambient", "this is the light. The surface reflects kd times its colour of it.",
        "all spheres the same grey in the shadow", return ambient)
AMBIENT("AM-tenth", "0.1 * kd * surface",
        "a tenth of white is only the default of scenes. Use the argument.",
        "the same, however bright the ambient light", return 0.1 * kd * surface)
AMBIENT(
    "AM-plus", "kd * (surface + ambient)",
    "colours add up when two lights come together. A surface multiplies the light by its colour.",
    "pale shadows", return kd * (surface + ambient))
AMBIENT(
    "AM-plus-behind", "kd * surface + ambient",
    "colours add up when two lights come together. A surface multiplies the light by its colour.",
    "pale shadows", return kd * surface + ambient)
AMBIENT("AM-plus-all", "kd + surface + ambient",
        "multiply by a share, and by the colour of the surface as well.", "nearly white spheres",
        return kd + surface + ambient)
AMBIENT("AM-mixed", "kd * surface + (1 - kd) * ambient",
        "this is a mixture of two colours. A surface multiplies the light by its own colour.",
        "pale shadows", return kd * surface + (1 - kd) * ambient)
AMBIENT("AM-dot", "kd * (surface . ambient)",
        "a dot product adds up the three colours to one number. Red stays with red: * multiplies "
        "component by component.",
        "grey shadows", return kd * grey(vec3_dot(surface, ambient)))
AMBIENT(
    "AM-cross", "kd * (surface x ambient)",
    "a cross product is for directions. Red stays with red: * multiplies component by component.",
    "odd colours, and some below 0", return kd * vec3_cross(surface, ambient))
AMBIENT("AM-grey", "kd * surface * (mean of ambient)",
        "the light also has a colour: red times red, green times green, blue times blue.",
        "shadows that do not take on the light's colour", return kd * mean(ambient) * surface)
AMBIENT("AM-red", "kd * surface * ambient[0]",
        "this is only the red of the light: red times red, green times green, blue times blue.",
        "shadows that do not take on the light's colour", return kd * ambient[0] * surface)
AMBIENT("AM-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",
        "no visible difference at first; sums of bright lights come out too dark",
        return clipped(kd * surface * ambient))
AMBIENT("AM-pi", "kd * surface * ambient / pi",
        "some books divide by pi, with another definition of kd. Here kd is the whole share.",
        "everything in shadow too dark", return kd * surface * ambient / PI)

DIFFUSE("S2", "max(0, -(n.l))", "to_light already points towards the light.",
        "spheres lit on the far side", return kd * fmax(0, -raw) * surface * light)
DIFFUSE("S3", "max(0, n.l) with an l that is not normalised",
        "n.l is |l| times the cosine. Normalise l first.",
        "spheres with large white areas, larger the farther the light is",
        return kd * fmax(0, vec3_dot(normal, to_light)) * surface * light)
DIFFUSE("S3-sides", "n.l unchanged",
        "n.l is |l| times the cosine: normalise l first. And behind the surface it is negative, "
        "which would subtract light.",
        "spheres with large white areas, and black on the other side",
        return kd * vec3_dot(normal, to_light) * surface * light)
DIFFUSE("S4", "|n.l|", "if n.l is negative the light is behind the surface, and does not reach it.",
        "spheres lit on the far side as well", return kd * fabs(raw) * surface * light)
DIFFUSE("S4-negative", "n.l without max(0, ...)",
        "if the light is behind the surface, this is negative and subtracts from the other lights.",
        "far sides darker than the ambient light", return kd * raw * surface * light)
DIFFUSE("DI-min", "min(0, n.l)",
        "this keeps the light behind the surface and drops the light in front of it. It is max(0, "
        "...).",
        "a black picture except for the ambient light", return kd * fmin(0, raw) * surface * light)
DIFFUSE("DI-kd", "kd left out", "only kd of the light is scattered.", "spheres too bright",
        return cosine * surface * light)
DIFFUSE("DI-kd-twice", "kd^2", "kd is the share that is scattered: multiply by it once.",
        "spheres too dark", return kd * kd * cosine * surface * light)
DIFFUSE("DI-kd-less-1", "1 - kd", "kd is the share that is scattered, not the rest.",
        "bright surfaces dark, and dark ones bright", return (1 - kd) * cosine * surface * light)
DIFFUSE("DI-surface", "kd * light * max(0, n.l)",
        "a red surface reflects only red light: its colour is missing.",
        "spheres of plaster, all in the colour of the light", return kd * cosine * light)
DIFFUSE("DI-light", "kd * surface * max(0, n.l)",
        "the brightness and the colour of the light are missing.",
        "the same picture, whatever the colour of the light", return kd * cosine * surface)
DIFFUSE("DI-cosine", "1 if n.l > 0",
        "the lower the light, the wider it is spread: the cosine is missing.",
        "flat half-moons with a hard edge", return kd * (raw > 0 ? 1 : 0) * surface * light)
DIFFUSE("DI-flat", "kd * surface * light",
        "the lower the light, the wider it is spread: the cosine is missing.", "flat discs",
        return kd * surface * light)
DIFFUSE(
    "DI-plus", "surface + light",
    "colours add up when two lights come together. A surface multiplies the light by its colour.",
    "pale spheres", return kd * cosine * (surface + light))
DIFFUSE("DI-plus-cosine", "kd * surface * light + cosine",
        "the cosine is the share of the light that arrives: multiply by it.",
        "pale spheres with large white areas", return kd * surface * light + cosine)
DIFFUSE("DI-dot", "surface . light",
        "a dot product adds up the three colours to one number. Red stays with red: * multiplies "
        "component by component.",
        "grey spheres", return kd * cosine * grey(vec3_dot(surface, light)))
DIFFUSE("DI-grey", "surface * (mean of light)",
        "the light also has a colour: red times red, green times green, blue times blue.",
        "spheres that do not take on the light's colour",
        return kd * cosine * mean(light) * surface)
DIFFUSE(
    "DI-product", "n * l, by components",
    "* multiplies component by component, which is for colours. The cosine is vec3_dot of the two.",
    "spheres in the colours of the rainbow",
    return kd * normal * vec3_unit(to_light) * surface * light)
DIFFUSE("DI-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",
        "no visible difference at first; sums of bright lights come out too dark",
        return clipped(kd * cosine * surface * light))
DIFFUSE("DI-pi", "divided by pi",
        "some books divide by pi, with another definition of kd. Here kd is the whole share.",
        "spheres too dark", return kd * cosine * surface * light / PI)
DIFFUSE("DI-far", "divided by |l|^2",
        "real lamps fade with the distance, but these do not: only the direction counts.",
        "nearly black, unless the light is close",
        return kd * cosine / vec3_dot(to_light, to_light) * surface * light)
DIFFUSE("DI-far-once", "divided by |l| once more",
        "to normalise l, divide it by its length once. Lights do not fade here.",
        "nearly black, unless the light is close",
        return kd * cosine / vec3_length(to_light) * surface * light)
DIFFUSE("DI-squared", "the cosine squared",
        "Lambert's law has the cosine itself; a power is for highlights.",
        "spheres that fade too soon towards the shadow",
        return kd * cosine * cosine * surface * light)
DIFFUSE("DI-sine", "the sine of the angle",
        "this is 0 if the light is straight above, where the cosine is 1.",
        "spheres dark in the middle of the lit side",
        return kd * (raw > 0 ? sqrt(fmax(0, 1 - raw * raw)) : 0) * surface * light)
DIFFUSE("DI-angle", "the angle itself",
        "n.l with unit vectors is the cosine already: use it, not the angle.",
        "spheres lit on the far side", return kd * acos(fmax(-1, fmin(1, raw))) * surface * light)
DIFFUSE("DI-linear", "1 - angle / 90 degrees",
        "the light on a tilted surface is the cosine of the angle, not a linear share of it.",
        "spheres that look like cones",
        return kd * fmax(0, 1 - acos(fmax(-1, fmin(1, raw))) / (PI / 2)) * surface * light)
DIFFUSE("DI-half", "(n.l + 1) / 2",
        "this light reaches around the surface, a trick of games. Lambert's law is the cosine, and "
        "nothing behind the surface.",
        "soft spheres without a dark side", return kd * (raw + 1) / 2 * surface * light)
DIFFUSE("DI-half-squared", "((n.l + 1) / 2)^2",
        "this light reaches around the surface, a trick of games. Lambert's law is the cosine, and "
        "nothing behind the surface.",
        "soft spheres without a dark side",
        return kd * (raw + 1) / 2 * (raw + 1) / 2 * surface * light)
DIFFUSE("DI-tenth", "max(0.1, n.l)",
        "the ambient term already gives the light that does not come from lamps.",
        "far sides lit a little by each light", return kd * fmax(0.1, raw) * surface * light)

// ---- wrong highlights after Phong ---------------------------------------------------------------

// In formulas m is the mirrored light.

// One highlight. cosine is the one that is raised to the power of shine; low is that of the normal
// and the direction to the light.
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

static Color as_it_should_be(Highlight h)
{
    return h.ks * power(h) * h.light;
}

#define PHONG(id, formula, why, picture, statement)                                                \
    WRONG(phong_term, id, formula, why, picture)                                                   \
    {                                                                                              \
        Highlight h = {ks, shine, light, phong_cosine(normal, to_light, to_eye),                   \
                       vec3_dot(normal, vec3_unit(to_light))};                                     \
        statement;                                                                                 \
    }

#define HALFWAY(id, formula, why, picture, statement)                                              \
    WRONG(halfway_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        Highlight h = {ks, shine, light, halfway_cosine(normal, to_light, to_eye),                 \
                       vec3_dot(normal, vec3_unit(to_light))};                                     \
        statement;                                                                                 \
    }

// The slips of both: which is "PH" or "HW".
// clang-format off
#define SLIPS(SLIP, which, COSINE)                                                                 \
    SLIP(which "-behind", "no test for n.l > 0",                                                   \
         "a light behind the surface does not reach it, whatever " COSINE " is.",                  \
         "highlights on the dark side",                                                            \
         return h.cosine > 0 ? h.ks * pow(h.cosine, h.shine) * h.light : grey(0))                  \
    SLIP(which "-negative", "no test for " COSINE " > 0",                                          \
         "an even power of a negative cosine is positive, and a power that is not a whole "        \
         "number is NaN.", "a second highlight where there should be none, or black specks",       \
         return h.low > 0 ? h.ks * pow(h.cosine, h.shine) * h.light : grey(0))                     \
    SLIP(which "-tests", "neither n.l > 0 nor " COSINE " > 0",                                     \
         "a light behind the surface does not reach it; and an even power of a negative cosine "   \
         "is positive.", "highlights on the dark side, or black specks",                           \
         return h.ks * pow(h.cosine, h.shine) * h.light)                                           \
    SLIP(which "-abs", "|" COSINE "|",                                                             \
         "a negative cosine means an angle of more than 90 degrees, without a highlight.",         \
         "a second highlight where there should be none",                                          \
         return h.low > 0 ? h.ks * pow(fabs(h.cosine), h.shine) * h.light : grey(0))               \
    SLIP(which "-abs-tests", "|" COSINE "|, whatever n.l",                                         \
         "a negative cosine means an angle of more than 90 degrees, and a light behind the "       \
         "surface does not reach it.", "highlights on all sides",                                  \
         return h.ks * pow(fabs(h.cosine), h.shine) * h.light)                                     \
    SLIP(which "-ks", "ks left out", "only ks of the light is reflected like this.",               \
         "highlights too bright", return power(h) * h.light)                                       \
    SLIP(which "-ks-twice", "ks^2", "ks is a share: multiply by it once.", "highlights too dark",  \
         return h.ks * h.ks * power(h) * h.light)                                                  \
    SLIP(which "-ks-less-1", "1 - ks", "ks is the share that is reflected, not the rest.",         \
         "dull surfaces with bright highlights, and polished ones without",                        \
         return (1 - h.ks) * power(h) * h.light)                                                   \
    SLIP(which "-light", "the light left out",                                                     \
         "a highlight is an image of the light and has its colour.",                               \
         "white highlights, whatever the light", return h.ks * grey(power(h)))                     \
    SLIP(which "-plus", "power + light",                                                           \
         "the power is the share of the light that is seen: multiply the light by it.",            \
         "highlights as large as half of the sphere",                                              \
         return power(h) > 0 ? h.ks * (grey(power(h)) + h.light) : grey(0))                        \
    SLIP(which "-grey", "the mean of the light",                                                   \
         "a highlight is an image of the light and has its colour.", "grey highlights",            \
         return h.ks * grey(power(h) * (h.light[0] + h.light[1] + h.light[2]) / 3))                \
    SLIP(which "-power", "shine left out", "the power makes the highlight small.",                 \
         "highlights that are wide and dull",                                                      \
         return power(h) > 0 ? h.ks * h.cosine * h.light : grey(0))                                \
    SLIP(which "-times", COSINE " times shine",                                                    \
         "the cosine is raised to the power of shine: pow.", "wide highlights, and too bright",    \
         return power(h) > 0 ? h.ks * h.cosine * h.shine * h.light : grey(0))                      \
    SLIP(which "-outside", "(ks (" COSINE "))^shine",                                              \
         "only the cosine is raised to the power, without ks.", "hardly any highlights",           \
         return power(h) > 0 ? pow(h.ks * h.cosine, h.shine) * h.light : grey(0))                  \
    SLIP(which "-swapped", "shine^(" COSINE ")",                                                   \
         "the first argument of pow is the base, the second the exponent.",                        \
         "discs that are too bright",                                                              \
         return power(h) > 0 ? h.ks * pow(h.shine, h.cosine) * h.light : grey(0))                  \
    SLIP(which "-whole", "shine without its fraction",                                             \
         "shine is a double, and need not be a whole number: pow accepts any.",                    \
         "highlights a little too large",                                                          \
         return power(h) > 0 ? h.ks * pow(h.cosine, floor(h.shine)) * h.light : grey(0))           \
    SLIP(which "-root", "(" COSINE ")^(1 / shine)",                                                \
         "this is a root, and makes the highlight large instead of small.",                        \
         "highlights that cover half of the sphere",                                               \
         return power(h) > 0 ? h.ks * pow(h.cosine, 1 / h.shine) * h.light : grey(0))              \
    SLIP(which "-low", "times n.l",                                                                \
         "the cosine n.l belongs to the diffuse term. A mirror reflects all of the light.",        \
         "highlights that fade towards the edge", return h.ks * power(h) * h.low * h.light)        \
    SLIP(which "-energy", "times (shine + 2) / (2 pi)",                                            \
         "this keeps the sum of all light constant, in later models. Here there is only ks.",      \
         "small highlights, and too bright",                                                       \
         return h.ks * (h.shine + 2) / (2 * PI) * power(h) * h.light)                              \
    SLIP(which "-clip", "no more than 1", "light is clamped once, at the end, by clamp_color.",    \
         "no visible difference at first; sums of bright lights come out too dark",                \
         return vec3_of(fmin(1, h.ks * power(h) * h.light[0]), fmin(1, h.ks * power(h) *           \
             h.light[1]), fmin(1, h.ks * power(h) * h.light[2])))

// clang-format on

// For unit vectors: of the mirrored l with e.
static double mirrored_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(2 * vec3_dot(n, l) * n - l, e);
}

static double phong_cosine(vec3 n, vec3 l, vec3 e)
{
    return mirrored_cosine(n, vec3_unit(l), vec3_unit(e));
}

// 2 (n.l) n - l, with only one of the two l normalised.
static double first_is_unit(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(2 * vec3_dot(n, vec3_unit(l)) * n - l, vec3_unit(e));
}

static double first_is_unit_then_all(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(vec3_unit(2 * vec3_dot(n, vec3_unit(l)) * n - l), vec3_unit(e));
}

static double once(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(vec3_dot(n, vec3_unit(l)) * n - vec3_unit(l), vec3_unit(e));
}

static double of_halfway(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(n, vec3_unit(vec3_unit(l) + vec3_unit(e)));
}

// Another cosine, and the rest right.
#define PHONG_OF(id, formula, why, picture, other)                                                 \
    WRONG(phong_term, id, formula, why, picture)                                                   \
    {                                                                                              \
        return as_it_should_be(                                                                    \
            (Highlight){ks, shine, light, other, vec3_dot(normal, vec3_unit(to_light))});          \
    }

SLIPS(PHONG, "PH", "m.e")
PHONG("PH-reversed", "-(m.e)",
      "mirror_direction takes the incoming direction, which is -l, and e points to the eye: one of "
      "them has the wrong sign.",
      "highlights missing, or on the opposite side",
      return as_it_should_be((Highlight){h.ks, h.shine, h.light, -h.cosine, h.low}))
WRONG_LINE(phong_term, "PH-light-reversed", "-l instead of l",
           "to_light already points towards the light.", "highlights on the dark side",
           return phong_term(ks, shine, light, normal, -to_light, to_eye))

WRONG(phong_term, "PH-eye-side", "n.e > 0 instead of n.l > 0",
      "the light must be on the side of the normal: if it is not, it does not reach the surface.",
      "highlights on the dark side")
{
    double cosine = phong_cosine(normal, to_light, to_eye);
    return vec3_dot(normal, to_eye) > 0 && cosine > 0 ? ks * pow(cosine, shine) * light : grey(0);
}

PHONG_OF("PH-nl", "n.l instead of m.e",
         "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
         "highlights that stay where they are when the eye moves",
         vec3_dot(normal, vec3_unit(to_light)))
PHONG_OF("PH-ne", "n.e instead of m.e",
         "a highlight also depends on where the light is: mirror it, then compare with e.",
         "a highlight in the middle of every sphere", vec3_dot(normal, vec3_unit(to_eye)))
PHONG_OF("PH-le", "l.e instead of m.e",
         "the surface mirrors the light before it reaches the eye: the normal is missing.",
         "whole spheres too bright when the light is behind the eye",
         vec3_dot(vec3_unit(to_light), vec3_unit(to_eye)))
PHONG_OF("PH-unit-light", "m.e with an l that is not normalised",
         "then it is not the cosine, but |l| times the cosine.", "spheres with large white areas",
         mirrored_cosine(normal, to_light, vec3_unit(to_eye)))
PHONG_OF("PH-unit-eye", "m.e with an e that is not normalised",
         "then it is not the cosine, but |e| times the cosine.", "spheres with large white areas",
         mirrored_cosine(normal, vec3_unit(to_light), to_eye))
PHONG_OF("PH-unit", "m.e with vectors that are not normalised",
         "then it is not the cosine, but both lengths times the cosine.",
         "spheres with large white areas", mirrored_cosine(normal, to_light, to_eye))
PHONG_OF("PH-unit-half", "2 (n.l / |l|) n - l",
         "normalise l in both places, or in neither and then m.",
         "highlights missing, or in odd places", first_is_unit(normal, to_light, to_eye))
PHONG_OF("PH-unit-late", "2 (n.l / |l|) n - l, normalised",
         "normalise l in both places, or in neither: this has another direction.",
         "highlights missing, or in odd places", first_is_unit_then_all(normal, to_light, to_eye))
PHONG_OF("PH-once", "m = (n.l) n - l",
         "this ends on the surface. The other side of the normal is 2 (n.l) n - l.",
         "highlights missing, or near the edge", once(normal, to_light, to_eye))
PHONG_OF("PH-halfway", "n.h, with the half-way vector h",
         "this is Blinn's highlight, which is larger. Phong's is m.e.",
         "highlights of twice the width", of_halfway(normal, to_light, to_eye))

// ---- wrong highlights after Blinn ---------------------------------------------------------------

// In formulas h is the half-way vector, normalised.

static double halfway_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(n, vec3_unit(vec3_unit(l) + vec3_unit(e)));
}

static vec3 sum(vec3 l, vec3 e)
{
    return vec3_unit(l) + vec3_unit(e);
}

static double of_mirrored(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(vec3_unit(2 * vec3_dot(n, l) * n - l), vec3_unit(e));
}

// Another cosine, and the rest right.
#define HALFWAY_OF(id, formula, why, picture, other)                                               \
    WRONG(halfway_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        return as_it_should_be(                                                                    \
            (Highlight){ks, shine, light, other, vec3_dot(normal, vec3_unit(to_light))});          \
    }

SLIPS(HALFWAY, "HW", "n.h")
HALFWAY("HW-reversed", "-(n.h)", "l and e already point away from the surface, as n does.",
        "no highlights at all",
        return as_it_should_be((Highlight){h.ks, h.shine, h.light, -h.cosine, h.low}))
WRONG_LINE(halfway_term, "HW-light-reversed", "-l instead of l",
           "to_light already points towards the light.", "highlights on the dark side",
           return halfway_term(ks, shine, light, normal, -to_light, to_eye))
HALFWAY_OF("HW-sum", "n.(l + e), not normalised",
           "the sum of two unit vectors is up to 2 long. Normalise it: only then is the dot "
           "product a cosine.",
           "spheres with large white areas", vec3_dot(normal, sum(to_light, to_eye)))
HALFWAY_OF("HW-mean", "n.(l + e) / 2",
           "the mean of two unit vectors is shorter than 1, unless they are equal. Normalise it.",
           "no highlights, except where the light is behind the eye",
           vec3_dot(normal, sum(to_light, to_eye) / 2))
HALFWAY_OF("HW-lengths", "l + e with lengths that are not 1",
           "the longer one pulls the sum to its side. The sum is half-way only if both are "
           "normalised first.",
           "highlights in odd places, which move with the distance of the light",
           vec3_dot(normal, vec3_unit(to_light + to_eye)))
HALFWAY_OF("HW-unit", "n.(l + e), nothing normalised",
           "l and e must be normalised before they are added, and the sum afterwards.",
           "spheres with large white areas", vec3_dot(normal, to_light + to_eye))
HALFWAY_OF("HW-unit-mean", "n.(l + e) / 2, nothing normalised",
           "l and e must be normalised before they are added, and the sum afterwards.",
           "spheres with large white areas", vec3_dot(normal, (to_light + to_eye) / 2))
HALFWAY_OF("HW-unit-light", "l + e with an l that is not normalised",
           "the longer one pulls the sum to its side. The sum is half-way only if both are "
           "normalised first.",
           "highlights in odd places, which move with the distance of the light",
           vec3_dot(normal, vec3_unit(to_light + vec3_unit(to_eye))))
HALFWAY_OF("HW-unit-eye", "l + e with an e that is not normalised",
           "the longer one pulls the sum to its side. The sum is half-way only if both are "
           "normalised first.",
           "highlights in the middle of every sphere",
           vec3_dot(normal, vec3_unit(vec3_unit(to_light) + to_eye)))
HALFWAY_OF("HW-minus", "l - e",
           "this leads from one to the other. Between them is their sum, and to_eye already points "
           "from the surface to the eye.",
           "highlights near the edge, towards the light",
           vec3_dot(normal, vec3_unit(vec3_unit(to_light) - vec3_unit(to_eye))))
HALFWAY_OF("HW-eye-minus", "e - l", "this leads from one to the other. Between them is their sum.",
           "highlights near the edge, away from the light",
           vec3_dot(normal, vec3_unit(vec3_unit(to_eye) - vec3_unit(to_light))))
HALFWAY_OF("HW-phong", "m.e, with the mirrored light m",
           "this is Phong's highlight. This function mirrors nothing: it needs n.h.",
           "highlights of half the width", of_mirrored(normal, to_light, to_eye))
HALFWAY_OF("HW-nl", "n.l instead of n.h",
           "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
           "highlights that stay where they are when the eye moves",
           vec3_dot(normal, vec3_unit(to_light)))
HALFWAY_OF("HW-ne", "n.e instead of n.h",
           "a highlight also depends on where the light is: h is half-way to it.",
           "a highlight in the middle of every sphere", vec3_dot(normal, vec3_unit(to_eye)))
HALFWAY_OF("HW-le", "l.e instead of n.h",
           "this does not depend on the surface: the normal is missing.",
           "whole spheres too bright when the light is behind the eye",
           vec3_dot(vec3_unit(to_light), vec3_unit(to_eye)))
HALFWAY_OF("HW-he", "h.e instead of n.h",
           "h is equally far from the eye and from the light, anywhere on the surface. The angle "
           "between h and the normal counts.",
           "whole spheres too bright",
           vec3_dot(vec3_unit(sum(to_light, to_eye)), vec3_unit(to_eye)))
HALFWAY_OF("HW-nl-e", "half-way between n and l, with e",
           "the vector is half-way between light and eye; compare it with the normal.",
           "highlights in odd places",
           vec3_dot(vec3_unit(normal + vec3_unit(to_light)), vec3_unit(to_eye)))
WRONG_LINE(halfway_term, "HW-four", "(n.h)^(4 shine)",
           "this makes the highlight about as small as Phong's. Here the power is shine itself.",
           "small highlights", return halfway_term(ks, 4 * shine, light, normal, to_light, to_eye))

// ---- wrong ways to make a colour fit ------------------------------------------------------------

// In formulas c is each of its three numbers.

static double largest(Color c)
{
    return fmax(c[0], fmax(c[1], c[2]));
}

// The same for each of the three.
#define EACH(id, formula, why, picture, statement)                                                 \
    WRONG(clamp_color, id, formula, why, picture)                                                  \
    {                                                                                              \
        for (int i = 0; i < 3; i++) {                                                              \
            double c = color[i];                                                                   \
            statement;                                                                             \
            color[i] = c;                                                                          \
        }                                                                                          \
        return color;                                                                              \
    }

static Color not_below(Color c)
{
    return vec3_of(fmax(0, c[0]), fmax(0, c[1]), fmax(0, c[2]));
}

static Color by_the_largest(Color c)
{
    return largest(c) > 1 ? c / largest(c) : c;
}

EACH("S7", "c unchanged", "a number above 1 or below 0 does not fit into a pixel.",
     "speckles of wrong colours in the brightest spots", c = c)
EACH("S7-above", "min(1, c)", "a number below 0 does not fit into a pixel either.",
     "speckles of wrong colours in the darkest spots", c = fmin(1, c))
EACH("S7-below", "max(0, c)", "a number above 1 does not fit into a pixel either.",
     "speckles of wrong colours in the brightest spots", c = fmax(0, c))
EACH("CL-0", "0, whatever c is",
     "min(0, max(1, c)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' is "
     "min(1, ...).",
     "a black picture", c = fmin(0, fmax(1, c)))
EACH("CL-1", "1, whatever c is",
     "max(1, min(0, c)) gives this, for example. 'At least 0' is max(0, ...), 'at most 1' is "
     "min(1, ...).",
     "a white picture", c = fmax(1, fmin(0, c)))
EACH("CL-wrap", "c - floor(c)", "a number a little above 1 starts again at 0.",
     "dark speckles in the brightest spots", c = c - floor(c))
EACH("CL-wrap-above", "c - floor(c) above 1", "a number a little above 1 starts again at 0.",
     "dark speckles in the brightest spots",
     c = c < 0   ? 0
         : c > 1 ? c - floor(c)
                 : c)
EACH("CL-black", "0 if c does not fit", "a number that is too bright is nearest to 1, not to 0.",
     "black holes in the brightest spots", c = c < 0 || c > 1 ? 0 : c)
EACH("CL-white", "1 if c does not fit", "a number below 0 is nearest to 0, not to 1.",
     "white speckles in the darkest spots", c = c < 0 || c > 1 ? 1 : c)
EACH("CL-abs", "min(1, |c|)", "a negative amount of light is nearest to 0: |c| makes light of it.",
     "bright speckles in the darkest spots", c = fmin(1, fabs(c)))
EACH("CL-255", "at most 255", "colours go from 0 to 1 here; the image converts them to bytes.",
     "speckles of wrong colours in the brightest spots", c = fmin(255, fmax(0, c)))
EACH("CL-255-times", "255 c", "colours go from 0 to 1 here; the image converts them to bytes.",
     "everything that is not black is too bright", c = 255 * fmin(1, fmax(0, c)))
EACH("CL-minus", "at least -1", "colours start at 0; cosines start at -1.",
     "speckles of wrong colours in the darkest spots", c = fmin(1, fmax(-1, c)))
EACH("CL-round", "0 or 1, whichever is nearer", "a number in between fits, and must not change.",
     "a poster of eight colours", c = c < 0.5 ? 0 : 1)
EACH("CL-compress", "c / (1 + c)",
     "this also changes colours that fit. A number between 0 and 1 must not change.",
     "a dull picture", c = fmax(0, c) / (1 + fmax(0, c)))
EACH("CL-expose", "1 - e^-c",
     "this also changes colours that fit. A number between 0 and 1 must not change.",
     "a dull picture", c = 1 - exp(-fmax(0, c)))
WRONG_BY(by_the_largest, clamp_color, "CL-scale", "divided by the largest, if that is above 1",
         "this also darkens the other two. Each number is clamped by itself.",
         "highlights in the colour of the surface")
WRONG_LINE(clamp_color, "CL-scale-0", "divided by the largest above 1, and at least 0",
           "this also darkens the other two. Each number is clamped by itself.",
           "highlights in the colour of the surface", return not_below(by_the_largest(color)))
WRONG_LINE(clamp_color, "CL-scale-all", "divided by the largest",
           "this also changes colours that fit, and makes every pixel as bright as possible.",
           "spheres without a dark side", return color / largest(color))
WRONG_LINE(clamp_color, "CL-length", "normalised if it is longer than 1",
           "a colour is not a direction: each of its numbers may be up to 1 by itself.",
           "a picture without white", return vec3_length(color) > 1 ? vec3_unit(color) : color)
WRONG_LINE(clamp_color, "CL-red", "only red clamped", "all three must fit.",
           "speckles of wrong colours in the brightest spots",
           return vec3_of(fmin(1, fmax(0, color[0])), color[1], color[2]))
WRONG_LINE(clamp_color, "CL-two", "blue left out",
           "three numbers are 0, 1 and 2: the loop ends too early.",
           "speckles of wrong colours in the brightest spots",
           return vec3_of(fmin(1, fmax(0, color[0])), fmin(1, fmax(0, color[1])), color[2]))
WRONG_LINE(clamp_color, "CL-all", "all white if one is above 1",
           "each number is clamped by itself, and the others do not change.",
           "white spots with hard edges",
           return largest(color) > 1 ? vec3_of(1, 1, 1) : not_below(color))

WRONG(clamp_color, "CL-all-both", "all white or all black if one does not fit",
      "each number is clamped by itself, and the others do not change.",
      "white and black spots with hard edges")
{
    if (largest(color) > 1)
        return vec3_of(1, 1, 1);
    return color[0] < 0 || color[1] < 0 || color[2] < 0 ? vec3_of(0, 0, 0) : color;
}

// ---- wrong ways to encode for a gamma -----------------------------------------------------------

// In formulas c is each of the three numbers.

#define GAMMA(id, formula, why, picture, statement)                                                \
    WRONG(gamma_encode, id, formula, why, picture)                                                 \
    {                                                                                              \
        for (int i = 0; i < 3; i++) {                                                              \
            double c = color[i];                                                                   \
            statement;                                                                             \
            color[i] = c;                                                                          \
        }                                                                                          \
        return color;                                                                              \
    }

static double srgb(double c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

GAMMA("GA-wrong-way", "c^gamma",
      "that is what the display does. To make up for it, the power is 1 / gamma.",
      "everything too dark", c = pow(c, gamma))
GAMMA("GA-times", "gamma c", "gamma is a power, not a factor.",
      "everything too bright, with white areas", c = c * gamma)
GAMMA("GA-through", "c / gamma", "gamma is a power, not a factor.", "everything too dark",
      c = c / gamma)
GAMMA("GA-2.2", "c^(1 / 2.2), whatever gamma",
      "most displays have 2.2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", c = pow(c, 1 / 2.2))
GAMMA("GA-2", "sqrt(c), whatever gamma",
      "this is right for a gamma of 2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", c = sqrt(c))
GAMMA("GA-none", "c unchanged", "this is right only for a gamma of 1.",
      "everything too dark, as without gamma", c = c)
GAMMA("GA-minus", "c^(-gamma)",
      "a negative power is 1 divided by that power. The inverse of a power is the root: 1 / gamma.",
      "a white picture", c = pow(c, -gamma))
GAMMA("GA-swapped", "(1 / gamma)^c",
      "the first argument of pow is the base, the second the exponent.",
      "a negative, pale and grey", c = pow(1 / gamma, c))
GAMMA("GA-swapped-too", "gamma^c",
      "the first argument of pow is the base, the second the exponent; and the exponent is 1 / "
      "gamma.",
      "a white picture", c = pow(gamma, c))
GAMMA("GA-whole", "gamma rounded to an integer", "gamma is a double, 2.2 for example.",
      "everything a little too dark or too bright", c = pow(c, 1 / floor(gamma + 0.5)))
GAMMA("GA-integers", "1 / gamma in integers",
      "in integers 1 / 2 is 0, and every number to the power of 0 is 1.", "a white picture",
      c = pow(c, gamma > 1 ? 0 : 1 / gamma))
GAMMA("GA-twice", "encoded twice", "the display undoes it only once.", "a pale picture",
      c = pow(pow(c, 1 / gamma), 1 / gamma))
GAMMA("GA-srgb", "the curve of sRGB, whatever gamma",
      "this is close to a gamma of 2.2, but gamma is an argument: use it.",
      "the same picture, whatever the gamma", c = srgb(c))
GAMMA("GA-inverted", "1 - c^(1 / gamma)", "black stays black, and white stays white.", "a negative",
      c = 1 - pow(c, 1 / gamma))
GAMMA("GA-turned", "1 - (1 - c)^gamma",
      "this is brighter as well, but the display does not undo it. It undoes c^(1 / gamma).",
      "bright parts too bright", c = 1 - pow(1 - c, gamma))
GAMMA("GA-255", "255 c^(1 / gamma)",
      "colours go from 0 to 1 here; the image converts them to bytes.",
      "everything that is not black is too bright", c = 255 * pow(c, 1 / gamma))
GAMMA("GA-255-in", "(c / 255)^(1 / gamma)", "colours already go from 0 to 1.",
      "a picture far too dark", c = pow(c / 255, 1 / gamma))
GAMMA("GA-255-both", "255 (c / 255)^(1 / gamma)", "colours already go from 0 to 1.",
      "everything that is not black is too bright", c = 255 * pow(c / 255, 1 / gamma))
GAMMA("GA-red", "only red encoded", "the display does the same to all three.", "a reddish picture",
      c = i == 0 ? pow(c, 1 / gamma) : c)
GAMMA("GA-two", "blue left out", "three numbers are 0, 1 and 2: the loop ends too early.",
      "a yellowish picture", c = i < 2 ? pow(c, 1 / gamma) : c)

WRONG(gamma_encode, "GA-mean", "the mean encoded, the hue kept",
      "the display raises each of the three to the power by itself.", "colours that are too strong")
{
    double mean = (color[0] + color[1] + color[2]) / 3;
    return mean > 0 ? color / mean * pow(mean, 1 / gamma) : color;
}

WRONG(gamma_encode, "GA-length", "the length encoded",
      "a colour is not a direction. The display raises each of the three to the power by itself.",
      "colours that are too strong")
{
    double length = vec3_length(color);
    return length > 0 ? color / length * pow(length, 1 / gamma) : color;
}

// ---- wrong answers to off_surface ---------------------------------------------------------------

// In formulas c, r is the sphere, p the point, n the normal, s the size, e a step of 2^-30.

// ---- where a ray starts -------------------------------------------------------------------------

typedef vec3 Start(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t);

static vec3 start_there(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)sphere, (void)normal, (void)ray, (void)t;
    return point;
}

static vec3 start_inward(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)ray, (void)t;
    return off_surface(sphere, point, -normal);
}

static vec3 start_outward(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)normal, (void)ray, (void)t;
    return off_surface(sphere, point, surface_normal(sphere, point));
}

static vec3 start_back_along_the_ray(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)sphere, (void)point, (void)normal;
    return ray.origin + t * (1 - 1e-9) * ray.direction;
}

#define STEP(name, epsilon)                                                                        \
    static inline vec3 name(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)             \
    {                                                                                              \
        (void)sphere, (void)ray, (void)t;                                                          \
        return point + (epsilon)*normal;                                                           \
    }

STEP(start_a_thousandth_off, 1e-3)
STEP(start_1e_4_off, 1e-4)
STEP(start_1e_5_off, 1e-5)
STEP(start_a_millionth_off, 1e-6)
STEP(start_a_billionth_off, 1e-9)

// Up to which t a hit is nearer than the light.
static double reach_of(Light light)
{
    return light.kind == LIGHT_DISTANT ? NO_HIT : 1;
}

// The normal at a hit, on the side from which the ray came.
static vec3 normal_turned(Sphere sphere, vec3 point, Ray ray)
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
}

static const double step = 0x1p-30;

static double largest_coordinate(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static double size_of(Sphere sphere)
{
    return sphere.radius + largest_coordinate(sphere.center);
}

// ---- by the wrong amount ------------------------------------------------------------------------

#define RELATIVE(id, formula, why, picture, epsilon)                                               \
    WRONG(off_surface, id, formula, why, picture)                                                  \
    {                                                                                              \
        return point + (epsilon)*size_of(sphere) * normal;                                         \
    }

// ---- fixed steps --------------------------------------------------------------------------------

#define FIXED(id, formula, why, picture, epsilon)                                                  \
    WRONG(off_surface, id, formula, why, picture)                                                  \
    {                                                                                              \
        return point + (epsilon)*normal;                                                           \
    }

// The row of the table for such a step.
#define FIXED_ROW(digits, epsilon)                                                                 \
    FIXED("O-" digits, "p + " digits " n",                                                         \
          digits " is huge in a scene of the size of an atom and nothing in one of the size of a " \
                 "galaxy. Let it grow with the numbers.",                                          \
          "right in scenes of one size, speckles or lost shadows in others", epsilon)

WRONG_LINE(off_surface, "O-none", "p",
           "rounding leaves p on either side of its surface. From the wrong side a ray hits the "
           "surface that it starts from.",
           "black speckles on all lit surfaces", return point)
WRONG_LINE(
    off_surface, "O-other", "p - e s n",
    "the point must go to the side of the normal; on the other side it is below its own surface.",
    "everything in its own shadow", return point - step * size_of(sphere) * normal)
WRONG_LINE(off_surface, "O-outward", "p + e s (p - c) / |p - c|",
           "this is always outward. Seen from inside, the given normal points inward, and the "
           "point must go there.",
           "right outside; hollow spheres dark inside",
           return point + step * size_of(sphere) * vec3_unit(point - sphere.center))
WRONG_LINE(off_surface, "O-inward", "p - e s (p - c) / |p - c|",
           "this is always inward. The normal gives the side; mostly it is outward.",
           "everything in its own shadow, except hollow spheres",
           return point - step * size_of(sphere) * vec3_unit(point - sphere.center))
WRONG_LINE(off_surface, "O-plus", "p + e s",
           "adding a number to a vector adds it to each coordinate. Multiply the normal by it, and "
           "add that.",
           "speckles on half of every sphere", return point + step * size_of(sphere))
WRONG_LINE(off_surface, "O-centre", "c + (r + e s) n",
           "if the normal points inward, this is a point on the opposite side of the sphere.",
           "right outside; hollow spheres dark inside",
           return sphere.center + (sphere.radius + step * size_of(sphere)) * normal)
WRONG_LINE(off_surface, "O-step", "e s n", "this is only the step: start at p and add it.",
           "shadows and mirrors as if everything were at the origin of the world",
           return step * size_of(sphere) * normal)
WRONG_LINE(off_surface, "O-radius", "p + e r n",
           "far from the origin of the world numbers are coarse, even on a small sphere: include "
           "the coordinates of the centre.",
           "speckles on small spheres that are far away from the origin",
           return point + step * sphere.radius * normal)
WRONG_LINE(off_surface, "O-coordinate", "p + e max(|cx|, |cy|, |cz|) n",
           "near the origin of the world that is almost 0. Include the radius.",
           "speckles on spheres around the origin",
           return point + step * largest_coordinate(sphere.center) * normal)
WRONG_LINE(off_surface, "O-point", "p + e max(|px|, |py|, |pz|) n",
           "near the origin of the world that is almost 0, but p was computed from large numbers: "
           "radius and centre.",
           "speckles where a large sphere passes near the origin",
           return point + step * largest_coordinate(point) * normal)
WRONG_LINE(off_surface, "O-x", "p + e (r + |cx|) n",
           "the largest of the three coordinates counts, x, y or z.",
           "speckles on spheres that are far up or far ahead",
           return point + step * (sphere.radius + fabs(sphere.center[0])) * normal)

WRONG(off_surface, "O-sign", "p + e (r + max(cx, cy, cz)) n",
      "-1000 is as large and as coarse as 1000: use absolute values.",
      "speckles on spheres with negative coordinates")
{
    vec3 c = sphere.center;
    return point + step * (sphere.radius + fmax(c[0], fmax(c[1], c[2]))) * normal;
}

WRONG(off_surface, "O-sum", "p + e (r + cx + cy + cz) n",
      "negative coordinates cancel the others. The largest absolute value counts.",
      "speckles here and there, depending on where a sphere is")
{
    vec3 c = sphere.center;
    return point + step * (sphere.radius + c[0] + c[1] + c[2]) * normal;
}

WRONG_LINE(off_surface, "O-square", "p + e s^2 n",
           "in a scene of twice the size, the step must be twice as long, not four times.",
           "speckles in small scenes; in large ones shadows that start too late",
           return point + step * size_of(sphere) * size_of(sphere) * normal)
RELATIVE("O-1e-3s", "p + 1e-3 s n",
         "this step is so long that it jumps over objects close to the surface.",
         "light under objects on a surface", 1e-3)
RELATIVE("O-1e-5s", "p + 1e-5 s n",
         "doubles have 16 digits: a smaller step is enough, and objects close to the surface still "
         "cast their shadows.",
         "light under small objects on a surface", 1e-5)
RELATIVE("O-1e-6s", "p + 1e-6 s n",
         "doubles have 16 digits: 1e-9 is enough, and objects close to the surface still cast "
         "their shadows.",
         "hardly anything; an edge of light under very small objects", 1e-6)
RELATIVE("O-float", "p + 2^-23 s n", "this is the precision of a float. A double is much finer.",
         "hardly anything; an edge of light under very small objects", 0x1p-23)

FIXED("O-1", "p + n",
      "the normal has length 1, and that may be more than the whole sphere: only a tiny part of it "
      "is needed.",
      "shadows and mirrors that belong to some other place", 1)
FIXED_ROW("0.1", 1e-1)
FIXED_ROW("0.01", 1e-2)
FIXED_ROW("0.001", 1e-3)
FIXED_ROW("1e-4", 1e-4)
FIXED_ROW("1e-5", 1e-5)
FIXED_ROW("1e-6", 1e-6)
FIXED_ROW("1e-7", 1e-7)
FIXED_ROW("1e-8", 1e-8)
FIXED_ROW("1e-9", 1e-9)

// ---- one loop, and possible slips in it ---------------------------------------------------------

static double visible_if(bool visible)
{
    return visible ? 1 : 0;
}

static bool is_hidden(const Scene *scene, Ray ray, double least, double reach)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t > least && t < reach)
            return true;
    }
    return false;
}

#define SHADOW(id, formula, why, picture, ray, least, reach)                                       \
    WRONG(visibility, id, formula, why, picture)                                                   \
    {                                                                                              \
        return visible_if(!is_hidden(scene, ray, least, reach));                                   \
    }

static Ray unit_ray(vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    return (Ray){from, vec3_unit(ray.direction)};
}

static double way_to(vec3 from, Light light)
{
    return vec3_length(ray_to_light(from, light).direction);
}

static Ray light_reversed(vec3 from, Light light)
{
    return (Ray){from, -ray_to_light(from, light).direction};
}

static Ray from_the_light(vec3 from, Light light)
{
    vec3 way = ray_to_light(from, light).direction;
    return (Ray){from + way, -way};
}

SHADOW("V-beyond", "any hit at all",
       "a point light is at t = 1 of its ray, and a sphere behind the light is not in its way.",
       "shadows of objects behind the lamp", ray_to_light(from, light), 0, NO_HIT)
SHADOW("V-reach1", "hits with t < 1, even of a distant light",
       "the tip of its direction is at t = 1; the light itself is beyond everything.",
       "in sunlight only very close objects cast a shadow", ray_to_light(from, light), 0, 1)
SHADOW("V-unit", "hits with t < 1, of a direction of length 1",
       "then the point light is at t = its distance. If you do not normalise the direction, it is "
       "at t = 1.",
       "shadows of objects behind the lamp, or hardly any", unit_ray(from, light), 0,
       reach_of(light))
SHADOW("V-distance", "hits with t < |l - p|",
       "t counts in lengths of the direction, which is as long as the distance of the light: it is "
       "at t = 1.",
       "shadows of objects behind the lamp", ray_to_light(from, light), 0, way_to(from, light))
SHADOW("V-reversed", "the ray away from the light",
       "from the point to the light it is l - p, and a sphere on the other side of the point is "
       "not in the way.",
       "shadows on the wrong side", light_reversed(from, light), 0, reach_of(light))
SHADOW("V-minus", "direction l, even of a point light",
       "l is a point. The vector to it from p is l - p.",
       "shadows in one direction, as in the sun, and at wrong places",
       ((Ray){from, light.position}), 0, reach_of(light))
SHADOW("V-always-minus", "direction l - p, even of a distant light",
       "a distant light is in the same direction from everywhere: l is that direction.",
       "shadows in the sun that spread as from a lamp", ((Ray){from, light.position - from}), 0,
       reach_of(light))
SHADOW("V-lamp", "a distant light like a point light",
       "a distant light has no place: l is its direction, and nothing is behind the light.",
       "shadows in the sun that spread as from a lamp", ((Ray){from, light.position - from}), 0, 1)
SHADOW("V-origin", "the ray from the world's origin",
       "test visibility from p: does the light arrive there?", "everything dark or everything lit",
       ((Ray){from - from, light.position}), 0, reach_of(light))
SHADOW("V-swapped", "origin l, direction p",
       "a ray needs a point to start from, p, and a direction, l - p.", "shadows in random places",
       ((Ray){light.position, from}), 0, reach_of(light))
SHADOW("V-through", "any hit of the ray from the light",
       "a hit behind the point is not between the two: 0 < t < 1 only.",
       "surfaces with an object behind them are dark as well", from_the_light(from, light), 0,
       NO_HIT)
SHADOW("V-1e-3", "hits with t > 0.001",
       "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
       "light under objects on a surface", ray_to_light(from, light), 1e-3, reach_of(light))
SHADOW("V-1e-4", "hits with t > 1e-4",
       "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
       "light under objects on a surface", ray_to_light(from, light), 1e-4, reach_of(light))
SHADOW("V-1e-5", "hits with t > 1e-5",
       "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
       "light under small objects on a surface", ray_to_light(from, light), 1e-5, reach_of(light))
SHADOW("V-1e-6", "hits with t > 1e-6",
       "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
       "light under small objects on a surface", ray_to_light(from, light), 1e-6, reach_of(light))
SHADOW("V-0.999", "hits with t < 0.999",
       "the light is at t = 1, and a sphere just in front of it hides it.",
       "a lamp that shines through its own shade", ray_to_light(from, light), 0,
       (1 - 1e-3) * reach_of(light))
SHADOW("V-0.9999", "hits with t < 0.9999",
       "the light is at t = 1, and a sphere just in front of it hides it.",
       "a lamp that shines through its own shade", ray_to_light(from, light), 0,
       (1 - 1e-4) * reach_of(light))
SHADOW("V-only-beyond", "hits with t > 1",
       "those are behind the light. In between means 0 < t < 1.",
       "shadows of objects behind the lamp, and of no others", ray_to_light(from, light),
       reach_of(light), NO_HIT)

// ---- wrong answers to visibility: which spheres, and the return value ---------------------------

static bool hides(const Scene *scene, int i, vec3 from, Light light)
{
    return hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light);
}

// The number of spheres from first up to end, without that one.
static int count_hiding(const Scene *scene, int first, int end, vec3 from, Light light)
{
    int count = 0;
    for (int i = first; i < end; i++)
        count += hides(scene, i, from, light);
    return count;
}

// ---- which sphere, and which of its roots -------------------------------------------------------

// Of some sphere, the near root (0) or the far one (1).
static bool any_root(const Scene *scene, int which, Ray ray, double least, double reach)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        if (roots.count > 0 && roots.t[which] > least && roots.t[which] < reach)
            return true;
    }
    return false;
}

#define SHADOW_OF_ROOTS(id, formula, why, picture, which, least, reach)                            \
    WRONG(visibility, id, formula, why, picture)                                                   \
    {                                                                                              \
        return visible_if(!any_root(scene, which, ray_to_light(from, light), least, reach));       \
    }

// ---- other answers ------------------------------------------------------------------------------

// The result of the loop counts only for the last sphere.
WRONG(visibility, "V-last", "only the last sphere",
      "each sphere overwrites what was found before. One that hides the light is enough: return at "
      "once.",
      "shadows of one sphere only")
{
    bool visible = true;
    for (int i = 0; i < scene->sphere_count; i++)
        visible = !hides(scene, i, from, light);
    return visible_if(visible);
}

WRONG_LINE(visibility, "V-first", "only the first sphere",
           "if the first does not hide the light, another one may: only after the loop you know "
           "that none does.",
           "shadows of one sphere only",
           return visible_if(count_hiding(scene, 0, scene->sphere_count > 0, from, light) == 0))

WRONG(visibility, "V-all", "0 only if every sphere is in between",
      "one sphere in between is enough.", "hardly any shadow")
{
    int count = scene->sphere_count;
    return visible_if(count == 0 || count_hiding(scene, 0, count, from, light) < count);
}

WRONG_LINE(visibility, "V-from1", "sphere 0 left out", "spheres are counted from 0.",
           "the first sphere casts no shadow",
           return visible_if(count_hiding(scene, 1, scene->sphere_count, from, light) == 0))
WRONG_LINE(visibility, "V-but-last", "the last sphere left out",
           "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
           "the last sphere casts no shadow",
           return visible_if(count_hiding(scene, 0, scene->sphere_count - 1, from, light) == 0))
SHADOW_OF_ROOTS("V-behind", "near roots with t < 1, even negative ones",
                "a hit with t < 0 is on the other side of the point, away from the light.",
                "objects behind a surface cast shadows on it", 0, -INFINITY, reach_of(light))
SHADOW_OF_ROOTS("V-line", "any root, even behind the point or the light",
                "in between means 0 < t < 1.", "far too many shadows", 0, -INFINITY, INFINITY)
SHADOW_OF_ROOTS("R8-shadow", "near roots only",
                "from inside a sphere the near root is behind the point, but the way to a light "
                "outside still hits the far side.",
                "light inside closed spheres", 0, 0, reach_of(light))
SHADOW_OF_ROOTS("R6-shadow", "far roots only",
                "a light inside a sphere is hidden by the side where the ray enters.",
                "lamps that shine out of closed spheres", 1, 0, reach_of(light))

WRONG(visibility, "V-centre", "hits of spheres whose centre is nearer than the light",
      "light and point may be in front of a sphere's centre, or inside it. The hit on its surface "
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

WRONG_LINE(visibility, "V-inverted", "1 in the shadow, 0 in the light",
           "the return value is the share of the light that arrives: 0 if a sphere is in between.",
           "light only where shadows should be", return 1 - visibility(scene, from, light))
WRONG_LINE(visibility, "V-1", "1", "spheres in between hide the light.", "no shadows", return 1)
WRONG_LINE(visibility, "V-0", "0", "if no sphere is in between, all of the light arrives.",
           "no light at all", return 0)
WRONG_LINE(visibility, "V-half", "1/2 in the shadow",
           "none of this light arrives there. Shadows are not black because of the ambient light.",
           "pale shadows", return visibility(scene, from, light) > 0 ? 1 : 0.5)
WRONG_LINE(visibility, "V-halves", "half for each sphere in between",
           "one is enough to hide the light, and more spheres hide no more than that.",
           "pale shadows, darker where they overlap",
           return ldexp(1, -count_hiding(scene, 0, scene->sphere_count, from, light)))
WRONG_LINE(visibility, "V-less", "minus 1 for each sphere in between",
           "light cannot be negative: with two spheres in between this is below 0.",
           "shadows too dark where they overlap",
           return 1 - count_hiding(scene, 0, scene->sphere_count, from, light))

WRONG(visibility, "V-glass", "times the transmittance of the spheres in between",
      "here any sphere hides the light, glass as well as stone.", "pale shadows of glass")
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hides(scene, i, from, light))
            visible *= scene_surface(scene, i)->transmittance;
    return visible;
}

WRONG(visibility, "V-t", "t of the hit",
      "the return value is 0 or 1. The distance of the sphere in between does not matter.",
      "shadows with a gradient")
{
    Hit hit = nearest_hit(ray_to_light(from, light), scene);
    return hit.t < reach_of(light) ? hit.t : 1;
}

// ---- wrong answers to shade: the terms of the sum, and the surface ------------------------------

// The values that are known at a hit.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, start, to_eye;
} Place;

static Place place_of(const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    return (Place){scene,  scene_surface(scene, hit.sphere),   point,
                   normal, off_surface(sphere, point, normal), -ray.direction};
}

static Color ambient_at(const Place *p)
{
    return ambient_term(p->surface->color, p->surface->diffuse, p->scene->ambient);
}

static Color lit_by(const Place *p, Light light, double visible)
{
    const Surface *s = p->surface;
    vec3 to_light = ray_to_light(p->point, light).direction;
    Color color = visible * light.color;
    return diffuse_term(s->color, s->diffuse, color, p->normal, to_light) +
           phong_term(s->specular, s->shine, color, p->normal, to_light, p->to_eye);
}

static Color lights_at(const Place *p)
{
    Color sum = vec3_of(0, 0, 0);
    for (int i = 0; i < p->scene->light_count; i++)
        sum += lit_by(p, p->scene->lights[i], visibility(p->scene, p->start, p->scene->lights[i]));
    return sum;
}

static Color sum_of(Place p)
{
    return ambient_at(&p) + lights_at(&p);
}

// ---- the sum ------------------------------------------------------------------------------------

// A place that differs from the right one in some way, and the usual sum.
#define AT(id, formula, why, picture, ...)                                                         \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        Place p = place_of(scene, ray, hit);                                                       \
        __VA_ARGS__;                                                                               \
        return sum_of(p);                                                                          \
    }

// Another sum at the right place.
#define SUM(id, formula, why, picture, sum)                                                        \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        Place p = place_of(scene, ray, hit);                                                       \
        return sum;                                                                                \
    }

static Color clamped(Color color)
{
    for (int i = 0; i < 3; i++)
        color[i] = fmin(1, fmax(0, color[i]));
    return color;
}

// ---- the place ----------------------------------------------------------------------------------

#define START_AT(id, formula, why, picture, start_of)                                              \
    AT(id, formula, why, picture,                                                                  \
       p.start = start_of(scene->spheres[hit.sphere], p.point, p.normal, ray, hit.t))

SUM("S-ambient", "the lights alone",
    "the scene also has a light that is everywhere: add its term once.", "pitch-black shadows",
    lights_at(&p))
SUM("S-only-ambient", "ambient alone",
    "each light that arrives adds its diffuse and its specular term. If you add them: does the ray "
    "to the light start on the eye's side of the surface, or below it? And does the vector point "
    "to the light, or away from it?",
    "flat and dark spheres", ambient_at(&p))
SUM("S-flat", "the surface's colour",
    "that is chapter 06: now the lights decide how much of it is seen.", "flat spheres, as before",
    p.surface->color)
SUM("S-clamp", "the sum, at most 1",
    "colours are clamped only at the very end, by clamp_color; in a mirror this one may be just "
    "right.",
    "no visible difference, except for dull highlights in mirrors", clamped(sum_of(p)))
SUM("S-twice", "the whole sum times the surface's colour",
    "the terms contain the colour already; and highlights have that of the light.",
    "colours too dark, highlights as if of coloured metal", sum_of(p) * p.surface->color)
SUM("S-each", "ambient once for each light",
    "it does not depend on the lights: add it once, before the loop.",
    "pale shadows where there are several lights",
    scene->light_count *ambient_at(&p) + lights_at(&p))
SUM("S-average", "the mean of the lights", "two lamps give more light than one: they add up.",
    "darker with every light that is added",
    ambient_at(&p) + lights_at(&p) / fmax(1, scene->light_count))
SUM("S-average-all", "the mean of ambient and all lights",
    "two lamps give more light than one: all of it adds up.",
    "darker with every light that is added", sum_of(p) / (1 + scene->light_count))
SUM("S-raw", "the ambient light itself",
    "the surface reflects only its part of it: ambient_term has kd and the colour.",
    "grey shadows on surfaces of any colour", scene->ambient + lights_at(&p))
SUM("S-kd", "ambient without kd",
    "the surface scatters only kd of the ambient light as well: ambient_term.", "pale shadows",
    p.surface->color * scene->ambient + lights_at(&p))
SUM("S-nff", "SCENE_AMBIENT instead of the scene's ambient light",
    "that is the initial value for a scene from a file. Use the value of this scene.",
    "no visible difference, until a scene has another ambient light",
    SCENE_AMBIENT *p.surface->diffuse *p.surface->color + lights_at(&p))
SUM("S-background", "the background as ambient light", "the scene has both, and they differ.",
    "shadows in the colour of the sky",
    ambient_term(p.surface->color, p.surface->diffuse, scene->background) + lights_at(&p))
SUM("S-mirror", "plus ks times the background",
    "mirrors come later, in trace_ray; here there are only lights.", "everything glows a little",
    sum_of(p) + p.surface->specular * scene->background)
AT("S-index", "the surface of the sphere's number",
   "spheres and surfaces are numbered separately; each sphere has the number of its surface: "
   "scene_surface.",
   "spheres in each other's colours", p.surface = &scene->surfaces[hit.sphere])
AT("S-surface0", "always surface 0", "each sphere has the number of its surface: scene_surface.",
   "all spheres in one colour", p.surface = &scene->surfaces[0])
AT("S-sphere0", "the surface of sphere 0", "the hit has the index of its sphere.",
   "all spheres in the colour of the first", p.surface = scene_surface(scene, 0))
AT("S-turn", "the normal outward, even from inside",
   "from inside the other side of the surface is visible: reverse the normal if it points away "
   "from the eye.",
   "hollow spheres dark inside, lit by the lights outside",
   p.normal = surface_normal(scene->spheres[hit.sphere], p.point);
   p.start = off_surface(scene->spheres[hit.sphere], p.point, p.normal))
AT("W3-shade", "the normal on the side away from the eye",
   "it must point to the side of the eye: if the dot product of the normal and the ray's direction "
   "is positive, reverse it.",
   "dark spheres", p.normal = -p.normal;
   p.start = off_surface(scene->spheres[hit.sphere], p.point, p.normal))
AT("W-unit", "p - c as normal", "this is as long as the radius: divide by it.",
   "large spheres too bright", p.normal *= scene->spheres[hit.sphere].radius)
AT("W2-shade", "p / |p| as normal", "the vector from the centre to the point is p - c.",
   "right only for a sphere at the origin of the world", p.normal = vec3_unit(p.point))
AT("S-eye", "the ray's direction as direction to the eye",
   "the ray comes from the eye. The direction to the eye is the opposite, -v.",
   "highlights only at edges, opposite the light", p.to_eye = ray.direction)
AT("S-eye-place", "the ray's origin as direction to the eye",
   "this is a point. The vector from the hit to it is -v, or o - p.", "highlights at wrong places",
   p.to_eye = ray.origin)
AT("S-eye-origin", "-p as direction to the eye",
   "this is the direction to the origin of the world; the eye is where the ray starts.",
   "highlights at wrong places, unless the eye is at the origin", p.to_eye = -p.point)
AT("S-t", "o + t v / |v|", "t counts in lengths of v, unchanged: o + t v.",
   "right only for rays of length 1",
   p = place_of(scene, (Ray){ray.origin, vec3_unit(ray.direction)}, hit))
AT("S-from-eye", "visibility from the eye",
   "test visibility from the surface: does the light arrive there?",
   "no shadows, or all dark when the eye is in one", p.start = ray.origin)
START_AT("S-acne", "visibility from p itself",
         "rounding leaves p on either side of its surface, and from below the surface hides every "
         "light: off_surface.",
         "black speckles on all lit surfaces", start_there)
START_AT("S-outside", "inside, the normal reversed for only one of the two",
         "the terms and off_surface both need the normal on the eye's side; if not, the surface "
         "hides its own light.",
         "hollow spheres dark inside", start_outward)
START_AT("S-back", "visibility from o + (1 - 1e-9) t v",
         "this step depends on the distance of the eye. The precision of the numbers depends on "
         "the sphere: off_surface.",
         "speckles on objects close to the eye; lost shadows far away", start_back_along_the_ray)
START_AT("S-1e-3", "visibility from p + 0.001 n",
         "this is too far in a small scene and nothing in a huge one: off_surface.",
         "right in scenes of one size, speckles or lost shadows in others", start_a_thousandth_off)
START_AT("S-1e-4", "visibility from p + 1e-4 n",
         "this is too far in a small scene and nothing in a huge one: off_surface.",
         "right in scenes of one size, speckles or lost shadows in others", start_1e_4_off)
START_AT("S-1e-5", "visibility from p + 1e-5 n",
         "this is too far in a small scene and nothing in a huge one: off_surface.",
         "right in scenes of one size, speckles or lost shadows in others", start_1e_5_off)
START_AT("S-1e-6", "visibility from p + 1e-6 n",
         "this is too far in a small scene and nothing in a huge one: off_surface.",
         "right in scenes of one size, speckles or lost shadows in others", start_a_millionth_off)
START_AT("S-1e-9", "visibility from p + 1e-9 n",
         "this is too far in a small scene and nothing in a huge one: off_surface.",
         "right in scenes of one size, speckles or lost shadows in others", start_a_billionth_off)

// ---- wrong answers to shade: what each light adds -----------------------------------------------

// One light at a hit, and the arguments of its terms.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, to_light, to_eye;
    Color color; // of the light
    double visible;
    double kd, ks, shine;
} Lit;

static Color diffuse_of(Lit l)
{
    return diffuse_term(l.surface->color, l.kd, l.visible * l.color, l.normal, l.to_light);
}

static Color specular_of(Lit l)
{
    return phong_term(l.ks, l.shine, l.visible * l.color, l.normal, l.to_light, l.to_eye);
}

static Color both_of(Lit l)
{
    return diffuse_of(l) + specular_of(l);
}

static Lit shadowless(Lit l)
{
    l.visible = 1;
    return l;
}

typedef Color Give(Lit lit);

// One light too many: the guard of the answering process comes after the last one.
static Color shade_lights(bool too_many, Give *give, const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    const Surface *s = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Color sum = ambient_term(s->color, s->diffuse, scene->ambient);
    int lights = scene->light_count + (too_many ? 1 : 0);
    for (int i = 0; i < lights; i++) {
        Light light = i < scene->light_count ? scene->lights[i] : GUARD_LIGHT;
        sum += give((Lit){.scene = scene,
                          .surface = s,
                          .point = point,
                          .normal = normal,
                          .to_light = ray_to_light(point, light).direction,
                          .to_eye = -ray.direction,
                          .color = light.color,
                          .visible = visibility(scene, off_surface(sphere, point, normal), light),
                          .kd = s->diffuse,
                          .ks = s->specular,
                          .shine = s->shine});
    }
    return sum;
}

static Color shade_with(Give *give, const Scene *scene, Ray ray, Hit hit)
{
    return shade_lights(false, give, scene, ray, hit);
}

// Each light adds something else than it should.
#define GIVES(...) GIVES_OF(__COUNTER__, __VA_ARGS__)
#define GIVES_OF(number, ...) GIVES_BY(number, __VA_ARGS__)
#define GIVES_BY(number, id, formula, why, picture, ...)                                           \
    static Color give_##number(Lit l)                                                              \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }                                                                                              \
    WRONG_LINE(shade, id, formula, why, picture, return shade_with(give_##number, scene, ray, hit))

GIVES("L-diffuse", "no diffuse term",
      "each light that arrives adds both: the diffuse term and the highlight.",
      "highlights on dark spheres", return specular_of(l))
WRONG_LINE(shade, "L-count", "a loop up to i <= light_count",
           "n lights have the numbers 0 to n - 1. There is no light number light_count: reading "
           "past the end of an array can give anything.",
           "a light that was never set, in any colour, or a crash",
           return shade_lights(true, both_of, scene, ray, hit))
GIVES("L-specular", "no specular term",
      "each light that arrives adds both: the diffuse term and the highlight.",
      "everything as dull as chalk", return diffuse_of(l))
GIVES("L-shadow", "lights added whether they arrive or not", "call visibility first.", "no shadows",
      return both_of(shadowless(l)))
GIVES("L-shadow-d", "diffuse added whether the light arrives or not",
      "without light nothing is scattered. visibility counts for both terms.",
      "no shadows, but highlights that end where shadows should start",
      return diffuse_of(shadowless(l)) + specular_of(l))
GIVES("L-shadow-s", "specular added whether the light arrives or not",
      "without light there is no highlight. visibility counts for both terms.",
      "highlights in the shadow", return diffuse_of(l) + specular_of(shadowless(l)))
GIVES("L-inverted", "lights added only if they do not arrive",
      "visibility is 1 if the light arrives.", "light only where shadows should be",
      l.visible = 1 - l.visible;
      return both_of(l))
GIVES("L-white", "all lights white, with brightness 1",
      "each light has its own colour: how much red, green and blue it sends.",
      "coloured lights look white, weak ones as bright as others", l.color = vec3_of(1, 1, 1);
      return both_of(l))
GIVES("L-white-d", "diffuse as if of a white light",
      "the diffuse term is the colour of the surface times that of the light.",
      "only highlights show the colour of the light", Lit white = l;
      white.color = vec3_of(1, 1, 1); return diffuse_of(white) + specular_of(l))
GIVES("L-white-s", "highlights always white", "highlights have the colour of the light.",
      "white highlights in coloured light", Lit white = l;
      white.color = vec3_of(1, 1, 1); return diffuse_of(l) + specular_of(white))
GIVES("L-metal", "specular times the surface's colour",
      "Phong's highlight has the colour of the light, whatever the surface's is.",
      "highlights as if of coloured metal",
      return diffuse_of(l) + l.surface->color * specular_of(l))
GIVES("L-swapped", "kd and ks swapped", "kd belongs to the diffuse term, ks to the highlight.",
      "shiny objects dull, dull objects shiny", l.kd = l.surface->specular;
      l.ks = l.surface->diffuse; return both_of(l))
GIVES("L-kd", "diffuse without kd", "kd says how much of the light is scattered.",
      "everything too bright", l.kd = 1;
      return both_of(l))
GIVES("L-ks", "specular without ks",
      "ks says how much of the light is reflected as by a mirror: chalk reflects nothing.",
      "highlights on everything, even on chalk", l.ks = 1;
      return both_of(l))
GIVES("L-shine", "a shine of 1", "each surface has its own shine, the power of the cosine.",
      "broad, blurred highlights", l.shine = 1;
      return both_of(l))
GIVES("L-shine2", "twice the shine", "the power of the cosine is shine itself.",
      "highlights too small", l.shine *= 2;
      return both_of(l))
GIVES("L-halfway", "Blinn's highlight", "this function needs Phong's: phong_term.",
      "highlights too broad",
      return diffuse_of(l) +
             halfway_term(l.ks, l.shine, l.visible *l.color, l.normal, l.to_light, l.to_eye))
GIVES("L-square", "light divided by the distance squared",
      "it is so in reality; here a light has the same brightness at any distance.",
      "dark, except right beside the lamps", return both_of(l) / vec3_dot(l.to_light, l.to_light))
GIVES("L-root", "light divided by the distance",
      "here a light has the same brightness at any distance.",
      "dark, except right beside the lamps", return both_of(l) / vec3_length(l.to_light))
GIVES("L-eye", "the direction to the eye instead of the direction to the light",
      "the ray comes from the eye; the light is elsewhere.", "as if there were a lamp at the eye",
      l.to_light = l.to_eye;
      return both_of(l))
GIVES("L-clamp", "each light at most 1",
      "colours are clamped only at the very end, by clamp_color.",
      "no visible difference, except for bright lights in mirrors", Color sum = both_of(l);
      for (int i = 0; i < 3; i++) sum[i] = fmin(1, sum[i]); return sum)
GIVES("L-distant", "l as direction to a light, not l - p",
      "only a distant light is a direction; the vector to a point light is l - p. ray_to_light "
      "does this.",
      "light as if of the sun, from a wrong direction", l.to_light += l.point;
      return both_of(l))

// ---- wrong answers to shade: which lights count, and what is left in the shadow -----------------

static Color with_lights(const Scene *scene, int first, int end, Ray ray, Hit hit)
{
    Scene some = *scene;
    some.lights += first;
    some.light_count = end > first ? end - first : 0;
    return shade(&some, ray, hit);
}

// Which lights arrive.
static bool arrives(const Scene *scene, Ray ray, Hit hit, int light)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 start = off_surface(sphere, point, normal_turned(sphere, point, ray));
    return visibility(scene, start, scene->lights[light]) > 0;
}

static int first_hidden(const Scene *scene, Ray ray, Hit hit)
{
    int i = 0;
    while (i < scene->light_count && arrives(scene, ray, hit, i))
        i++;
    return i;
}

static bool any_hidden(const Scene *scene, Ray ray, Hit hit)
{
    return first_hidden(scene, ray, hit) < scene->light_count;
}

static bool any_arrives(const Scene *scene, Ray ray, Hit hit)
{
    for (int i = 0; i < scene->light_count; i++)
        if (arrives(scene, ray, hit, i))
            return true;
    return false;
}

WRONG_LINE(shade, "L-first", "the first light only", "all lights add up.",
           "too dark, shadows of one lamp only",
           return with_lights(scene, 0, scene->light_count > 0, ray, hit))

WRONG(shade, "L-last", "the last light only",
      "each light overwrites the one before. They add up: +=.",
      "too dark, shadows of one lamp only")
{
    int last = scene->light_count > 0 ? scene->light_count - 1 : 0;
    return with_lights(scene, last, scene->light_count, ray, hit);
}

WRONG_LINE(shade, "L-from1", "light 0 left out", "lights are counted from 0.",
           "the first lamp is off",
           return with_lights(scene, scene->light_count > 0, scene->light_count, ray, hit))
WRONG_LINE(shade, "L-but-last", "the last light left out",
           "counted from 0, the last of n lights has the index n - 1, and it must be added.",
           "the last lamp is off", return with_lights(scene, 0, scene->light_count - 1, ray, hit))
WRONG_LINE(shade, "L-break", "lights up to the first that is hidden",
           "the next light may still arrive: go on with it.",
           "shadows of one lamp darken the others",
           return with_lights(scene, 0, first_hidden(scene, ray, hit), ray, hit))
WRONG_LINE(shade, "L-any", "ambient only, if any light is hidden",
           "a hidden light does not take away the others.",
           "shadows of one lamp where another shines",
           return with_lights(scene, 0, any_hidden(scene, ray, hit) ? 0 : scene->light_count, ray,
                              hit))

WRONG(shade, "L-black", "black if no light arrives",
      "the ambient light is everywhere, also in the shadow.", "pitch-black shadows")
{
    bool lit = scene->light_count == 0 || any_arrives(scene, ray, hit);
    return lit ? shade(scene, ray, hit) : vec3_of(0, 0, 0);
}

WRONG_LINE(shade, "L-black-any", "black if any light is hidden",
           "the ambient light is everywhere; and the other lights may arrive.",
           "pitch-black shadows, also where another lamp shines",
           return any_hidden(scene, ray, hit) ? vec3_of(0, 0, 0) : shade(scene, ray, hit))

// Ambient light as if it came from each light, and were hidden with it.
WRONG(shade, "L-ambient", "ambient with each light that arrives",
      "ambient light comes from no particular place and nothing hides it: add it once.",
      "pitch-black shadows; too bright where several lights arrive")
{
    Color ambient = with_lights(scene, 0, 0, ray, hit), sum = -ambient;
    for (int i = 0; i < scene->light_count; i++)
        sum += arrives(scene, ray, hit, i) ? ambient : vec3_of(0, 0, 0);
    return shade(scene, ray, hit) + sum;
}

WRONG_LINE(shade, "L-sky", "the background if no light arrives",
           "the surface is still there, in ambient light.", "holes instead of shadows",
           return any_arrives(scene, ray, hit) ? shade(scene, ray, hit) : scene->background)

// ---- wrong answers to trace_ray: where a mirrored ray goes --------------------------------------

// A mirrored ray, and what is made of the colour that it sees. Members that are not set are right.
typedef struct {
    Start *start;
    vec3 (*direction)(vec3 direction, vec3 normal);
    double (*share)(const Surface *surface);
    Color (*sum)(Color own, double share, Color seen, const Surface *surface);
    Color (*own)(const Scene *scene, Ray ray, Hit hit);
    Color (*nothing)(const Scene *scene, bool mirrored);
    bool own_sphere_left_out;
} Slips;

static double ks_of(const Surface *surface)
{
    return surface->specular;
}

static vec3 right_start(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)ray, (void)t;
    return off_surface(sphere, point, normal);
}

static Color plus_share(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return own + share * seen;
}

static Color background_of(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->background;
}

static Hit hit_of(const Slips *slips, const Scene *scene, Ray ray, int own)
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best.t && !(slips->own_sphere_left_out && i == own))
            best = (Hit){t, i};
    }
    return best;
}

static Color trace_with(const Slips *slips, const Scene *scene, Ray ray, int depth, int own)
{
    Hit hit = hit_of(slips, scene, ray, own);
    if (hit.sphere < 0)
        return (slips->nothing != NULL ? slips->nothing : background_of)(scene, own >= 0);
    const Surface *surface = scene_surface(scene, hit.sphere);
    double share = (slips->share != NULL ? slips->share : ks_of)(surface);
    Color color = (slips->own != NULL ? slips->own : shade)(scene, ray, hit);
    if (depth <= 0 || share == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {
        (slips->start != NULL ? slips->start : right_start)(sphere, point, normal, ray, hit.t),
        (slips->direction != NULL ? slips->direction : mirror_direction)(ray.direction, normal)};
    Color seen = trace_with(slips, scene, mirrored, depth - 1, hit.sphere);
    return (slips->sum != NULL ? slips->sum : plus_share)(color, share, seen, surface);
}

#define MIRROR(id, formula, why, picture, ...)                                                     \
    WRONG(trace_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        return trace_with(&(Slips){__VA_ARGS__}, scene, ray, depth, -1);                           \
    }

// ---- where to -----------------------------------------------------------------------------------

static vec3 straight_on(vec3 direction, vec3 normal)
{
    (void)normal;
    return direction;
}

static vec3 back(vec3 direction, vec3 normal)
{
    (void)normal;
    return -direction;
}

static vec3 along_the_normal(vec3 direction, vec3 normal)
{
    (void)direction;
    return normal;
}

static vec3 without_the_2(vec3 direction, vec3 normal)
{
    return direction - vec3_dot(direction, normal) * normal;
}

static vec3 start_at_the_eye(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)sphere, (void)point, (void)normal, (void)t;
    return ray.origin;
}

static vec3 start_at_the_centre(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)point, (void)normal, (void)ray, (void)t;
    return sphere.center;
}

MIRROR("T-into", "a direction into the surface: v, v + 2 (v.n) n or -(v - 2 (v.n) n)",
       "a mirror sends the ray away from its surface, at the same angle: mirror_direction. This "
       "one hits the same place again.",
       "shiny objects too bright, with nothing in them but themselves", .direction = straight_on)
MIRROR("T-back", "the ray goes back to where it came from",
       "that is right only straight ahead. In general the ray leaves at the same angle, on the "
       "other side of the normal: mirror_direction.",
       "every mirror shows the scene behind the eye", .direction = back)
MIRROR("T-normal", "along the normal",
       "the ray leaves at the same angle as it arrives: mirror_direction.",
       "mirrors show the same from everywhere", .direction = along_the_normal)
MIRROR("T-once", "v - (v.n) n",
       "this runs along the surface. Subtract twice as much: mirror_direction.",
       "mirrors show the scene beside them", .direction = without_the_2)
MIRROR("T-eye", "the mirrored ray from the eye", "it starts at the point of the hit.",
       "mirrors show the scene beside the eye", .start = start_at_the_eye)
MIRROR("T-centre", "the mirrored ray from the centre", "it starts at the point of the hit.",
       "every ball shows its own inside", .start = start_at_the_centre)
MIRROR("T-acne", "the mirrored ray from the surface itself",
       "rounding leaves the point on either side of the surface, and from below the ray hits the "
       "surface that it starts from: off_surface.",
       "speckles in mirrors", .start = start_there)
MIRROR("T-below", "the mirrored ray from below the surface",
       "off_surface moves to the side of the normal: give it the normal on the eye's side.",
       "every ball shows its own inside", .start = start_inward)
MIRROR("T-outside", "the mirrored ray from outside, even from inside a sphere",
       "from inside it must stay inside: give off_surface the normal on the eye's side.",
       "hollow mirrors show the scene outside", .start = start_outward)
MIRROR("T-along", "the mirrored ray from o + (1 - 1e-9) t v",
       "this step depends on the distance of the eye. The precision of the numbers depends on the "
       "sphere: off_surface.",
       "speckles in mirrors that are close to the eye or far from the origin",
       .start = start_back_along_the_ray)
MIRROR("T-1e-3", "the mirrored ray from p + 0.001 n",
       "this is too far in a small scene and nothing in a huge one: off_surface.",
       "right in scenes of one size, speckles in others", .start = start_a_thousandth_off)
MIRROR("T-1e-6", "the mirrored ray from p + 1e-6 n",
       "this is too far in a small scene and nothing in a huge one: off_surface.",
       "right in scenes of one size, speckles in others", .start = start_a_millionth_off)
MIRROR("T-1e-9", "the mirrored ray from p + 1e-9 n",
       "this is too far in a small scene and nothing in a huge one: off_surface.",
       "right in scenes of one size, speckles in others", .start = start_a_billionth_off)
MIRROR("T-itself", "a mirrored ray that cannot hit its own sphere",
       "from outside it does not, but inside a hollow ball it hits the other side.",
       "hollow mirrors without mirror images", .own_sphere_left_out = true)

// Wrong answers to trace_ray: how much of the mirrored colour is added, and which colour that is.

static double all_of_it(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1;
}

static double kd_of_mirrors(const Surface *surface)
{
    return surface->specular == 0 ? 0 : surface->diffuse;
}

static double what_is_not_diffuse(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1 - surface->diffuse;
}

static double squared(const Surface *surface)
{
    return surface->specular * surface->specular;
}

static Color blended(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return (1 - share) * own + share * seen;
}

static Color in_the_color(Color own, double share, Color seen, const Surface *surface)
{
    return own + share * surface->color * seen;
}

static Color only_what_is_seen(Color own, double share, Color seen, const Surface *surface)
{
    (void)own, (void)surface;
    return share * seen;
}

static Color of_both(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return share * (own + seen);
}

static Color multiplied(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return own * seen;
}

static Color average(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return (own + seen) / 2;
}

static Color clamped_sum(Color own, double share, Color seen, const Surface *surface)
{
    Color sum = plus_share(own, share, seen, surface);
    for (int i = 0; i < 3; i++)
        sum[i] = fmin(1, sum[i]);
    return sum;
}

static Color seen_clamped(Color own, double share, Color seen, const Surface *surface)
{
    for (int i = 0; i < 3; i++)
        seen[i] = fmin(1, seen[i]);
    return plus_share(own, share, seen, surface);
}

static Color black_in_mirrors(const Scene *scene, bool mirrored)
{
    return mirrored ? vec3_of(0, 0, 0) : scene->background;
}

static Color always_black(const Scene *scene, bool mirrored)
{
    (void)scene, (void)mirrored;
    return vec3_of(0, 0, 0);
}

static Color ambient_of_the_scene(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->ambient;
}

static Color flat(const Scene *scene, Ray ray, Hit hit)
{
    (void)ray;
    return scene_surface(scene, hit.sphere)->color;
}

static Color ambient_only(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    (void)ray;
    return ambient_term(surface->color, surface->diffuse, scene->ambient);
}

static Color without_highlight(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    Color sum = ambient_only(scene, ray, hit);
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        sum += diffuse_term(surface->color, surface->diffuse, color, normal,
                            ray_to_light(point, light).direction);
    }
    return sum;
}

static Color turned_away(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *s = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    Color sum = ambient_only(scene, ray, hit);
    vec3 point = ray.origin + hit.t * ray.direction, normal = -normal_turned(sphere, point, ray);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        vec3 to_light = ray_to_light(point, light).direction;
        sum += diffuse_term(s->color, s->diffuse, color, normal, to_light) +
               phong_term(s->specular, s->shine, color, normal, to_light, -ray.direction);
    }
    return sum;
}

MIRROR("T-ks", "all of the mirrored colour", "specular says how much of it comes back.",
       "every shiny object a perfect mirror", .share = all_of_it)
MIRROR("T-kd", "kd times the mirrored colour", "kd belongs to the diffuse term; the mirror has ks.",
       "bright objects mirror, whether shiny or not", .share = kd_of_mirrors)
MIRROR("T-rest", "1 - kd times the mirrored colour",
       "kd + ks need not be 1: the surface has its own ks.", "mirrors too strong or too weak",
       .share = what_is_not_diffuse)
MIRROR("T-square", "ks times ks of the mirrored colour", "each mirror multiplies by its ks once.",
       "mirrors too weak", .share = squared)
MIRROR("T-blend", "(1 - ks) times shade + ks times the mirror",
       "kd and ks already say how much there is of each; keep the whole colour of shade.",
       "shiny objects too dark", .sum = blended)
MIRROR("T-color", "the mirror in the surface's colour",
       "here mirrors are like highlights: they do not change the colour.",
       "mirrors as if of coloured metal", .sum = in_the_color)
MIRROR("T-only", "ks times the mirror, without shade",
       "the surface still reflects its lights: add the colour of shade.",
       "shiny objects without their own colour", .sum = only_what_is_seen)
MIRROR("T-both", "ks times (shade + the mirror)",
       "the colour of shade has its kd and ks already; multiply only the mirror.",
       "shiny objects too dark", .sum = of_both)
MIRROR("T-times", "shade times the mirror", "light adds up: add the two colours.",
       "shiny objects too dark", .sum = multiplied)
MIRROR("T-mean", "the mean of shade and the mirror",
       "specular says how much of the mirror is added.", "all mirrors are alike", .sum = average)
MIRROR("T-clamp", "the sum, at most 1",
       "colours are clamped only at the very end, by clamp_color; in the next mirror this one may "
       "be just right.",
       "dull highlights in mirrors", .sum = clamped_sum)
MIRROR("T-clamp-seen", "the mirrored colour, at most 1",
       "colours are clamped only at the very end, by clamp_color; in a mirror this one may be just "
       "right.",
       "dull highlights in mirrors", .sum = seen_clamped)
MIRROR("T-black", "black instead of the background in mirrors",
       "a mirrored ray that hits nothing sees the background, like any other.",
       "mirrors too dark where they show the sky", .nothing = black_in_mirrors)
MIRROR("T-night", "black if nothing is hit", "the scene has its own background colour.",
       "everything on black", .nothing = always_black)
MIRROR("T-ambient-sky", "the ambient light if nothing is hit",
       "the scene has both, and they differ: use its background.", "a grey background",
       .nothing = ambient_of_the_scene)
MIRROR("T-flat", "flat colours", "a surface that is hit is lit: shade.",
       "flat spheres with mirror images", .own = flat)
MIRROR("T-ambient", "ambient light only",
       "a surface that is hit is lit by every light that arrives: shade.",
       "dark spheres with mirror images", .own = ambient_only)
MIRROR("T-highlight", "shade without highlights",
       "the highlight is the mirror image of the lamp, which no ray can hit. Keep it.",
       "mirrors without highlights", .own = without_highlight)
MIRROR("T-away", "shade with the normal turned away from the eye",
       "the lit side is the one that the eye sees, and the normal points to that side.",
       "dark spheres with mirror images", .own = turned_away)

// ---- wrong answers to trace_ray: how many mirrors deep, and which surfaces mirror ---------------

// Right, except that the mirrored ray has another depth, or something else in its place.
typedef Color Rest(const Scene *scene, Ray mirrored, int depth);

static Color trace_once(Rest *rest, bool mirrors, const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (!mirrors || ks == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * rest(scene, mirrored, depth - 1);
}

static Color sky(const Scene *scene, Ray ray, int depth)
{
    (void)ray, (void)depth;
    return scene->background;
}

static Color surface_color(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    (void)depth;
    return hit.sphere < 0 ? scene->background : scene_surface(scene, hit.sphere)->color;
}

// ---- how deep -----------------------------------------------------------------------------------

static Color two_at_a_time(const Scene *scene, Ray ray, int depth)
{
    return trace_once(two_at_a_time, depth > 0, scene, ray, depth - 1);
}

static Color half_of_it(const Scene *scene, Ray ray, int depth)
{
    return trace_once(half_of_it, depth > 0, scene, ray, (depth + 1) / 2);
}

// ---- at the end ---------------------------------------------------------------------------------

static Color black_at_depth_0(const Scene *scene, Ray ray, int depth)
{
    return depth == 0 ? vec3_of(0, 0, 0) : trace_once(black_at_depth_0, true, scene, ray, depth);
}

static Color background_at_depth_0(const Scene *scene, Ray ray, int depth)
{
    return depth == 0 ? scene->background
                      : trace_once(background_at_depth_0, true, scene, ray, depth);
}

static Color background_behind_the_last(const Scene *scene, Ray ray, int depth)
{
    return trace_once(depth > 0 ? background_behind_the_last : sky, true, scene, ray, depth);
}

static Color flat_at_the_end(const Scene *scene, Ray ray, int depth)
{
    return trace_once(depth > 1 ? flat_at_the_end : surface_color, depth > 0, scene, ray, depth);
}

static Color background_for_the_dull(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular == 0)
        return scene->background;
    return trace_once(background_for_the_dull, depth > 0, scene, ray, depth);
}

static Color black_for_the_dull(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular == 0)
        return vec3_of(0, 0, 0);
    return trace_once(black_for_the_dull, depth > 0, scene, ray, depth);
}

// ---- which surfaces -----------------------------------------------------------------------------

// The ks of the first hit is used for all mirrors after it.
static Color share_of_the_first(double ks, const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    ks = ks < 0 ? scene_surface(scene, hit.sphere)->specular : ks;
    if (depth <= 0 || ks == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * share_of_the_first(ks, scene, mirrored, depth - 1);
}

static Color strong_mirrors_only(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    bool strong = hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular >= 0.5;
    return trace_once(strong_mirrors_only, depth > 0 && strong, scene, ray, depth);
}

static Color perfect_mirrors_only(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    bool perfect = hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular >= 1;
    return trace_once(perfect_mirrors_only, depth > 0 && perfect, scene, ray, depth);
}

// Without a limit it ends where it leaves the scene. Between mirrors it would go on until the stack
// overflows; here as long as any of it is visible.
WRONG(trace_ray, "T-endless", "no end at depth 0",
      "between two mirrors a ray goes to and fro for ever. If depth is 0, return the colour of "
      "shade.",
      "no visible difference, until two mirrors face each other: a stack overflow")
{
    enum { AS_GOOD_AS_ENDLESS = 200 };
    return trace_ray(scene, ray, AS_GOOD_AS_ENDLESS);
}

WRONG_LINE(trace_ray, "T-deep", "a mirrored ray at depth 0 as well",
           "depth > 0, not >= 0: at 0 there are no more mirrors.",
           "mirror images in mirrors once too often", return trace_ray(scene, ray, depth + 1))
WRONG_LINE(trace_ray, "T-shallow", "no mirrored ray at depth 1",
           "depth > 0, not > 1: at 1 there is one more mirror.",
           "mirror images in mirrors once too few",
           return trace_ray(scene, ray, depth > 0 ? depth - 1 : 0))
WRONG_BY(two_at_a_time, trace_ray, "T-two", "depth - 2 at each mirror",
         "each mirror subtracts 1. Do you subtract it twice?",
         "mirror images in mirrors half as deep")
WRONG_BY(half_of_it, trace_ray, "T-halved", "depth halved at each mirror",
         "each mirror subtracts 1 from it.", "mirror images in mirrors not deep enough")
WRONG_LINE(trace_ray, "T-one", "depth 1, whatever the argument is",
           "depth is the number of mirrors, one after the other.", "no mirrors in mirrors",
           return trace_ray(scene, ray, 1))
WRONG_LINE(trace_ray, "T-once-only", "depth 0 for the mirrored ray", "it has depth - 1 left.",
           "no mirrors in mirrors", return trace_ray(scene, ray, depth > 0 ? 1 : 0))
WRONG_LINE(trace_ray, "T-least", "a mirror at depth 0 as well, but no deeper",
           "at depth 0 there are no mirrors: return the colour of shade.",
           "mirrors where there should be none",
           return trace_ray(scene, ray, depth > 0 ? depth : 1))
WRONG_LINE(trace_ray, "T-0", "shade only",
           "if depth > 0 and the surface has specular, add what the mirrored ray sees.",
           "no mirrors", return trace_ray(scene, ray, 0))
WRONG_LINE(trace_ray, "T-5", "a depth of at most 5",
           "the caller may ask for a greater depth: depth alone says where it ends.",
           "the deepest mirrors missing", return trace_ray(scene, ray, depth < 5 ? depth : 5))
// Reversed: the deeper, the less is left.
WRONG_LINE(trace_ray, "T-until", "mirrors only at depth 0",
           "depth is the number of mirrors that are left: it must be more than 0.",
           "mirrors only where there should be none",
           return trace_ray(scene, ray, depth == 0 ? 1 : 0))
WRONG_BY(black_at_depth_0, trace_ray, "T-black0", "black at depth 0",
         "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
         "black; in mirrors black holes")
WRONG_BY(background_at_depth_0, trace_ray, "T-sky0", "the background at depth 0",
         "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
         "nothing but background; mirrors show only the sky")
WRONG_BY(background_behind_the_last, trace_ray, "T-sky-behind",
         "ks times the background at depth 0", "at depth 0 return the colour of shade.",
         "the deepest mirrors too bright")
WRONG_BY(flat_at_the_end, trace_ray, "T-flat-end", "flat colours in the last mirror",
         "objects in a mirror are lit like all others: call trace_ray with depth - 1.",
         "flat spheres in mirrors")
WRONG_BY(background_for_the_dull, trace_ray, "T-dull-sky", "the background if ks is 0",
         "a surface without a mirror is still there, and lit: shade.", "dull objects vanish")
WRONG_BY(black_for_the_dull, trace_ray, "T-dull-black", "black if ks is 0",
         "a surface without a mirror is still there, and lit: shade.", "dull objects are black")
WRONG_LINE(trace_ray, "T-ks-first", "the first mirror's ks for all", "each surface has its own ks.",
           "mirrors in mirrors too strong or too weak",
           return share_of_the_first(-1, scene, ray, depth))
WRONG_LINE(trace_ray, "T-ks-0", "the ks of sphere 0 for all",
           "each surface has its own ks: use that of the sphere that is hit.",
           "all mirrors are alike",
           return scene->sphere_count == 0
                      ? scene->background
                      : share_of_the_first(scene_surface(scene, 0)->specular, scene, ray, depth))
WRONG_BY(strong_mirrors_only, trace_ray, "T-strong", "mirrors only if ks is at least 0.5",
         "a weak mirror is also a mirror: its specular is not 0.", "weak mirrors do not mirror")
WRONG_BY(perfect_mirrors_only, trace_ray, "T-perfect", "mirrors only if ks is 1",
         "a weak mirror is also a mirror: its specular is not 0.", "hardly any mirrors")

// Wrong answers to exercise 07: limits that no scene and no light has, and fields of a surface that
// are swapped.

// ---- terms --------------------------------------------------------------------------------------

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

#define DIFFUSE_FROM(id, formula, why, picture, least)                                             \
    WRONG(diffuse_term, id, formula, why, picture)                                                 \
    {                                                                                              \
        return cosine_between(normal, to_light) < (least)                                          \
                   ? grey(0)                                                                       \
                   : diffuse_term(surface, kd, light, normal, to_light);                           \
    }

// The cosine on which a highlight depends, and all of it if that is nearly 1.
static Color phong_all_near_the_middle(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 mirrored = 2 * vec3_dot(n, l) * n - l;
    bool near = cosine_between(mirrored, e) > 0.999999 && vec3_dot(n, l) > 0;
    return near ? ks * light : phong_term(ks, shine, light, n, l, e);
}

static Color halfway_all_near_the_middle(double ks, double shine, Color light, vec3 n, vec3 l,
                                         vec3 e)
{
    vec3 between = l / vec3_length(l) + e / vec3_length(e);
    bool near = cosine_between(between, n) > 0.999999 && vec3_dot(n, l) > 0;
    return near ? ks * light : halfway_term(ks, shine, light, n, l, e);
}

// Both highlights: with another ks or shine, or nothing at all.
#define BOTH_HIGHLIGHTS(id, formula, why, picture, change)                                         \
    WRONG(phong_term, "PH-" id, formula, why, picture)                                             \
    {                                                                                              \
        double low = cosine_between(normal, to_light);                                             \
        (void)low;                                                                                 \
        change;                                                                                    \
        return phong_term(ks, shine, light, normal, to_light, to_eye);                             \
    }                                                                                              \
    WRONG(halfway_term, "HW-" id, formula, why, picture)                                           \
    {                                                                                              \
        double low = cosine_between(normal, to_light);                                             \
        (void)low;                                                                                 \
        change;                                                                                    \
        return halfway_term(ks, shine, light, normal, to_light, to_eye);                           \
    }

#define BOTH_BY(id, slip, formula, why, picture)                                                   \
    WRONG_BY(phong_##slip, phong_term, "PH-" id, formula, why, picture)                            \
    WRONG_BY(halfway_##slip, halfway_term, "HW-" id, formula, why, picture)

#define AT_MOST(number)                                                                            \
    BOTH_HIGHLIGHTS("most" #number, "a shine of at most " #number,                                 \
                    "a polished surface may have any shine.",                                      \
                    "highlights of polished surfaces too large", shine = fmin(number, shine))

// ---- one of three -------------------------------------------------------------------------------

// Right for some of the three numbers, and unchanged for the others.
static vec3 where(bool x, bool y, bool z, vec3 right, vec3 as_it_was)
{
    return vec3_of(x ? right[0] : as_it_was[0], y ? right[1] : as_it_was[1],
                   z ? right[2] : as_it_was[2]);
}

#define ONLY_ROW(id, what, x, y, z)                                                                \
    WRONG(clamp_color, "CL-" id, what " clamped", "all three must fit.",                           \
          "speckles of wrong colours in the brightest spots")                                      \
    {                                                                                              \
        return where(x, y, z, clamp_color(color), color);                                          \
    }                                                                                              \
    WRONG(gamma_encode, "GA-" id, what " encoded", "the display does the same to all three.",      \
          "a picture in false colours")                                                            \
    {                                                                                              \
        return where(x, y, z, gamma_encode(color, gamma), color);                                  \
    }

#define AXIS_ROW(axis, x, y, z)                                                                    \
    WRONG(surface_normal, "W-minus-" #axis, #axis " with the wrong sign",                          \
          "each coordinate is the point's minus the centre's.", "spheres lit from a wrong side")   \
    {                                                                                              \
        return vec3_of(x, y, z) * surface_normal(sphere, point);                                   \
    }                                                                                              \
    WRONG(mirror_direction, "MI-minus-" #axis, #axis " with the wrong sign",                       \
          "all three coordinates are v - 2 (v.n) n.", "mirrors that show the wrong side")          \
    {                                                                                              \
        return vec3_of(x, y, z) * mirror_direction(direction, normal);                             \
    }

// ---- visibility ---------------------------------------------------------------------------------

static double hidden_between(const Scene *scene, vec3 from, Light light, int most, double least,
                             double reach)
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count && i < most; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t > least && t < reach)
            return 0;
    }
    return 1;
}

#define LIMITED_SHADOW(id, formula, why, picture, most, least, reach)                              \
    WRONG(visibility, id, formula, why, picture)                                                   \
    {                                                                                              \
        return hidden_between(scene, from, light, most, least, reach);                             \
    }

#define SHADOW_ROOM(number)                                                                        \
    LIMITED_SHADOW("V-room" #number, "the first " #number " spheres",                              \
                   "the number of spheres in the scene is sphere_count.",                          \
                   "no visible difference, until a scene has more spheres", number, 0,             \
                   reach_of(light))

#define SHADOW_FROM(from_t, most, least, reach)                                                    \
    LIMITED_SHADOW(                                                                                \
        "V-" from_t, "hits with t > " from_t,                                                      \
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.", \
        "light under small objects on a surface", most, least, reach)

#define SHADOW_TO(to_t, most, least, reach)                                                        \
    LIMITED_SHADOW("V-to-" to_t, "of a distant light, hits with t < " to_t,                        \
                   "a distant light is beyond everything, and its direction has any length: t of " \
                   "a hit has no upper limit.",                                                    \
                   "in sunlight distant objects cast no shadow", most, least, reach)

// ---- shade --------------------------------------------------------------------------------------

static Color of_lights(const Scene *scene, int most, Ray ray, Hit hit)
{
    Scene some = *scene;
    some.light_count = scene->light_count < most ? scene->light_count : most;
    return shade(&some, ray, hit);
}

// As if another surface were hit; the ambient term unchanged.
typedef struct {
    double kd, ks, shine;
} Fields;

static Color with_fields(Fields fields, const Scene *scene, Ray ray, Hit hit)
{
    const Surface *s = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    Color sum = ambient_term(s->color, s->diffuse, scene->ambient);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        vec3 l = ray_to_light(point, light).direction;
        sum += diffuse_term(s->color, fields.kd, color, normal, l) +
               phong_term(fields.ks, fields.shine, color, normal, l, -ray.direction);
    }
    return sum;
}

#define FIELDS(id, formula, why, picture, kd, ks, shine)                                           \
    WRONG(shade, id, formula, why, picture)                                                        \
    {                                                                                              \
        const Surface *s = scene_surface(scene, hit.sphere);                                       \
        return with_fields((Fields){kd, ks, shine}, scene, ray, hit);                              \
    }

#define LIGHTS_ROW(number)                                                                         \
    WRONG_LINE(shade, "L-room" #number, "the first " #number " lights",                            \
               "the number of lights in the scene is light_count.",                                \
               "no visible difference, until a scene has more lights",                             \
               return of_lights(scene, number, ray, hit))

#define FIELDS_ROW(id, formula, why, kd, ks, shine)                                                \
    FIELDS(id, formula, why, "highlights or colours of another surface", kd, ks, shine)

// ---- trace_ray ----------------------------------------------------------------------------------

typedef struct {
    int deepest;
    double least_ks, least_share;
} Limits;

static Color trace_with_limits(Limits limits, const Scene *scene, Ray ray, int depth, double share)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (depth <= 0 || limits.deepest <= 0 || ks <= limits.least_ks ||
        share * ks < limits.least_share)
        return color;
    limits.deepest--;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * trace_with_limits(limits, scene, mirrored, depth - 1, share * ks);
}

#define LIMITED(id, formula, why, picture, deepest, ks, share)                                     \
    WRONG(trace_ray, id, formula, why, picture)                                                    \
    {                                                                                              \
        return trace_with_limits((Limits){deepest, ks, share}, scene, ray, depth, 1);              \
    }

#define DEEPEST_ROW(number)                                                                        \
    LIMITED("T-most" #number, "a depth of at most " #number, "the caller may ask for any depth.",  \
            "no visible difference, until mirrors face each other", number, 0, 0)

#define KS_ROW(more_than, deepest, ks, share)                                                      \
    LIMITED("T-ks-" more_than, "mirrors only if ks is more than " more_than,                       \
            "a weak mirror is also a mirror: its specular is not 0.",                              \
            "weak mirrors do not mirror", deepest, ks, share)

#define SHARE_ROW(more_than, deepest, ks, share)                                                   \
    LIMITED("T-share-" more_than,                                                                  \
            "mirrors only while more than " more_than " of them comes through",                    \
            "only depth and ks decide where it ends: the mirrored object may be bright.",          \
            "mirrors in mirrors missing", deepest, ks, share)

DIFFUSE_FROM("DI-1e-2", "nothing if n.l is below 0.01",
             "a low light gives little, but not nothing: only below 0 it gives nothing.",
             "a dark edge before the shadow starts", 1e-2)
DIFFUSE_FROM("DI-1e-3", "nothing if n.l is below 0.001",
             "a low light gives little, but not nothing: only below 0 it gives nothing.",
             "hardly anything", 1e-3)
DIFFUSE_FROM("DI-1e-6", "nothing if n.l is below 1e-6",
             "a low light gives little, but not nothing: only below 0 it gives nothing.",
             "hardly anything", 1e-6)
BOTH_BY("near1", all_near_the_middle, "all of ks if the cosine is above 0.999999",
        "with a high shine the highlight is already weaker there: raise every cosine to the power.",
        "a flat spot in the middle of small highlights")
BOTH_HIGHLIGHTS("shine0", "nothing if shine is 0",
                "any number to the power of 0 is 1: with a shine of 0 all of ks is seen.",
                "no highlight where it should be widest", if (shine == 0) return grey(0))
BOTH_HIGHLIGHTS("shine1", "a shine of at least 1",
                "a shine below 1 makes the highlight wider still: use it unchanged.",
                "highlights of dull surfaces too small", shine = fmax(1, shine))
AT_MOST(10)
AT_MOST(100)
AT_MOST(128)
AT_MOST(1000)
BOTH_HIGHLIGHTS("rounded", "shine rounded to an integer",
                "shine is a double, and need not be a whole number: pow accepts any.",
                "highlights a little too large or too small", shine = floor(shine + 0.5))
BOTH_HIGHLIGHTS("ks-shine", "ks and shine swapped",
                "shine is the power, ks multiplies the result. Look at the order of the arguments.",
                "wide highlights, and too bright", double kept = ks;
                ks = shine; shine = kept)
BOTH_HIGHLIGHTS("1e-3", "nothing if n.l is below 0.001",
                "a low light also makes a highlight: only below 0 there is none.",
                "highlights cut off at edges", if (low < 1e-3) return grey(0))
BOTH_HIGHLIGHTS("1e-6", "nothing if n.l is below 1e-6",
                "a low light also makes a highlight: only below 0 there is none.",
                "hardly anything", if (low < 1e-6) return grey(0))

ONLY_ROW("green", "only green", false, true, false)
ONLY_ROW("blue", "only blue", false, false, true)
ONLY_ROW("but-red", "only green and blue", false, true, true)
ONLY_ROW("but-green", "only red and blue", true, false, true)

WRONG(clamp_color, "CL-and", "clamped only if all three do not fit",
      "each number is clamped by itself, whether the others fit or not.",
      "speckles of wrong colours in the brightest spots")
{
    bool above = color[0] > 1 && color[1] > 1 && color[2] > 1,
         below = color[0] < 0 && color[1] < 0 && color[2] < 0;
    return above || below ? clamp_color(color) : color;
}

WRONG_LINE(clamp_color, "CL-black-below", "all black if one is below 0",
           "each number is clamped by itself, and the others do not change.",
           "black spots with hard edges",
           return color[0] < 0 || color[1] < 0 || color[2] < 0 ? grey(0) : clamp_color(color))
AXIS_ROW(x, -1, 1, 1)
AXIS_ROW(y, 1, -1, 1)
AXIS_ROW(z, 1, 1, -1)

SHADOW_ROOM(8)
SHADOW_ROOM(10)
SHADOW_ROOM(16)
SHADOW_ROOM(32)
SHADOW_ROOM(64)
SHADOW_ROOM(100)
SHADOW_ROOM(128)
SHADOW_ROOM(256)
SHADOW_FROM("1e-7", INT_MAX, 1e-7, reach_of(light))
SHADOW_FROM("1e-8", INT_MAX, 1e-8, reach_of(light))
SHADOW_FROM("1e-9", INT_MAX, 1e-9, reach_of(light))
SHADOW_TO("1000", INT_MAX, 0, fmin(1e3, reach_of(light)))
SHADOW_TO("1e6", INT_MAX, 0, fmin(1e6, reach_of(light)))
SHADOW_TO("1e9", INT_MAX, 0, fmin(1e9, reach_of(light)))
LIMITED_SHADOW("V-points", "1 for every distant light",
               "a sphere in between hides a distant light like any other.",
               "no shadows in sunlight", INT_MAX, 0, light.kind == LIGHT_POINT ? 1 : 0)
LIMITED_SHADOW("V-sun", "1 for every point light",
               "a sphere in between hides a point light like any other.", "no shadows by lamps",
               INT_MAX, 0, light.kind == LIGHT_POINT ? 0 : NO_HIT)

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

LIGHTS_ROW(4)
LIGHTS_ROW(8)
LIGHTS_ROW(10)
LIGHTS_ROW(16)
LIGHTS_ROW(32)
FIELDS_ROW("L-ks-shine", "ks instead of shine",
           "ks is the strength of the highlight; shine is the power.", s->diffuse, s->specular,
           s->specular)
FIELDS_ROW("L-shine-ks", "shine instead of ks",
           "shine is the power; ks is the strength of the highlight.", s->diffuse, s->shine,
           s->shine)
FIELDS_ROW("L-ks-and-shine", "ks and shine swapped", "phong_term takes ks first, then shine.",
           s->diffuse, s->shine, s->specular)
FIELDS_ROW("L-kd-ks", "kd instead of ks",
           "kd belongs to the diffuse term; the highlight has ks, the surface's specular.",
           s->diffuse, s->diffuse, s->shine)
FIELDS_ROW("L-ks-kd", "ks instead of kd",
           "ks belongs to the highlight; the diffuse term has kd, the surface's diffuse.",
           s->specular, s->specular, s->shine)
FIELDS_ROW("L-rest-ks", "1 - kd instead of ks",
           "kd + ks need not be 1: the surface has its own ks.", s->diffuse, 1 - s->diffuse,
           s->shine)
FIELDS_ROW("L-rest-kd", "1 - ks instead of kd",
           "kd + ks need not be 1: the surface has its own kd.", 1 - s->specular, s->specular,
           s->shine)

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
KS_ROW("0.1", INT_MAX, 0.1, 0)
KS_ROW("0.01", INT_MAX, 1e-2, 0)
KS_ROW("0.001", INT_MAX, 1e-3, 0)
KS_ROW("1e-6", INT_MAX, 1e-6, 0)
SHARE_ROW("0.01", INT_MAX, 0, 1e-2)
SHARE_ROW("0.001", INT_MAX, 0, 1e-3)
SHARE_ROW("1e-4", INT_MAX, 0, 1e-4)
SHARE_ROW("1e-6", INT_MAX, 0, 1e-6)

static const int styles = 2;

OF_STEM(styles)
