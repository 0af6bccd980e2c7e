// mistakes-mirror.c - wrong mirrors.
#include "tests/07-shading/mistakes.h"

static vec3 plus(vec3 v, vec3 n)
{
    return v + 2 * vec3_dot(v, n) * n;
}

static vec3 once(vec3 v, vec3 n)
{
    return v - vec3_dot(v, n) * n;
}

static vec3 plus_once(vec3 v, vec3 n)
{
    return v + vec3_dot(v, n) * n;
}

static vec3 reversed(vec3 v, vec3 n)
{
    return 2 * vec3_dot(v, n) * n - v;
}

static vec3 reversed_once(vec3 v, vec3 n)
{
    return vec3_dot(v, n) * n - v;
}

static vec3 normal_left_out(vec3 v, vec3 n)
{
    return v - 2 * vec3_dot(v, n);
}

static vec3 straight_back(vec3 v, vec3 n)
{
    (void)n;
    return -v;
}

static vec3 straight_on(vec3 v, vec3 n)
{
    (void)n;
    return v;
}

static vec3 twice_the_normal(vec3 v, vec3 n)
{
    return v - 2 * n;
}

static vec3 the_normal(vec3 v, vec3 n)
{
    (void)v;
    return n;
}

static vec3 product_of_components(vec3 v, vec3 n)
{
    return v - 2 * v * n * n;
}

static vec3 made_unit(vec3 v, vec3 n)
{
    return vec3_unit(v - 2 * vec3_dot(v, n) * n);
}

static vec3 dot_of_unit(vec3 v, vec3 n)
{
    return v - 2 * vec3_dot(vec3_unit(v), n) * n;
}

static vec3 dot_with_itself(vec3 v, vec3 n)
{
    return v - 2 * vec3_dot(v, v) * n;
}

static vec3 one_sided(vec3 v, vec3 n)
{
    return vec3_dot(v, n) < 0 ? v - 2 * vec3_dot(v, n) * n : v;
}

static vec3 always_to_the_normals_side(vec3 v, vec3 n)
{
    return v + 2 * fabs(vec3_dot(v, n)) * n;
}

static vec3 along_the_direction(vec3 v, vec3 n)
{
    return n - 2 * vec3_dot(v, n) * v;
}

const Mistake mirror_mistakes[] = {
    MISTAKE("MI-plus", mirror_direction, plus, "v + 2 (v.n) n",
            "this makes the part along the normal three times as large, and keeps its sign.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-once", mirror_direction, once, "v - (v.n) n",
            "this removes the part along the normal, so the rest runs along the surface. To "
            "reverse that part, subtract it twice.",
            "mirrors that show the horizon all over"),
    MISTAKE("MI-plus-once", mirror_direction, plus_once, "v + (v.n) n",
            "this doubles the part along the normal instead of reversing it.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-back", mirror_direction, reversed, "2 (v.n) n - v",
            "this is for a vector that points away from the surface. This one comes in, so its "
            "mirrored direction is the opposite.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-back-once", mirror_direction, reversed_once, "(v.n) n - v",
            "only the part along the surface is left, and it is reversed.",
            "mirrors that show the horizon all over, reversed"),
    MISTAKE("MI-scalar", mirror_direction, normal_left_out, "v - 2 (v.n)",
            "subtracting a number from a vector subtracts it from each component. The normal is "
            "missing.",
            "mirrors that all look towards the same corner"),
    MISTAKE("MI-opposite", mirror_direction, straight_back, "-v",
            "only a ray along the normal comes straight back.", "mirrors that show only the eye"),
    MISTAKE("MI-on", mirror_direction, straight_on, "v",
            "this goes through the surface, as if it were not there.", "glass instead of mirrors"),
    MISTAKE("MI-n", mirror_direction, twice_the_normal, "v - 2n",
            "the part of v along n decides how much to subtract: v.n is missing.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE(
        "MI-normal", mirror_direction, the_normal, "n",
        "the mirrored direction also depends on v. It is as far from n as v is, on the other side.",
        "mirrors that show the same from everywhere"),
    MISTAKE("MI-product", mirror_direction, product_of_components, "v - 2 v n n, by components",
            "v * n multiplies component by component. The dot product is vec3_dot.",
            "mirrors that are right only if they face along an axis"),
    MISTAKE("MI-unit", mirror_direction, made_unit, "(v - 2 (v.n) n) / |v|",
            "the direction is right, but it must be as long as v.",
            "no visible difference at first; t counts in other lengths"),
    MISTAKE("MI-part", mirror_direction, dot_of_unit, "v - 2 (v.n / |v|) n",
            "the vector to subtract grows with the length of v: put v itself into the dot product.",
            "mirrors that are right only if v has length 1"),
    MISTAKE("MI-square", mirror_direction, dot_with_itself, "v - 2 (v.v) n",
            "the part of v along n is v.n; v.v is only its squared length.",
            "mirrors that show what is straight above them"),
    MISTAKE("MI-side", mirror_direction, one_sided, "v unchanged if v.n is not negative",
            "a mirror has two sides, and the formula is the same for both.",
            "no mirror on the inside of a sphere"),
    MISTAKE("MI-abs", mirror_direction, always_to_the_normals_side, "v + 2 |v.n| n",
            "from the other side of the mirror v.n is positive, and then this is wrong.",
            "mirrors that are wrong on the inside of a sphere"),
    MISTAKE("MI-swapped", mirror_direction, along_the_direction, "n - 2 (v.n) v",
            "v and n are swapped: this is the normal, mirrored at v.",
            "mirrors full of other parts of the scene"),
    {0},
};
