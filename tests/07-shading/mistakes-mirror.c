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
            "it makes the part along the normal three times as large, and leaves its sign.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-once", mirror_direction, once, "v - (v.n) n",
            "that takes away the part along the normal, so what is left runs along the surface. To "
            "turn it round, it must be taken off twice.",
            "mirrors that show the horizon all over"),
    MISTAKE("MI-plus-once", mirror_direction, plus_once, "v + (v.n) n",
            "it doubles the part along the normal instead of turning it round.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-back", mirror_direction, reversed, "2 (v.n) n - v",
            "that is for a vector that points away from the surface. This one comes in, so its "
            "mirrored way is the opposite.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-back-once", mirror_direction, reversed_once, "(v.n) n - v",
            "only the part along the surface is left, and it points back where it came from.",
            "mirrors that show the horizon all over, turned round"),
    MISTAKE("MI-scalar", mirror_direction, normal_left_out, "v - 2 (v.n)",
            "a vector less a number takes the number from each component. The normal is missing.",
            "mirrors that all look to the same corner"),
    MISTAKE("MI-opposite", mirror_direction, straight_back, "-v",
            "only what falls straight on comes straight back.", "mirrors that show just the eye"),
    MISTAKE("MI-on", mirror_direction, straight_on, "v",
            "that is the way through the surface, as if it were not there.",
            "glass instead of mirrors"),
    MISTAKE("MI-n", mirror_direction, twice_the_normal, "v - 2n",
            "how much of v goes along n decides how much has to be taken off: v.n is missing.",
            "mirrors that show the inside of their own sphere"),
    MISTAKE("MI-normal", mirror_direction, the_normal, "n",
            "the mirrored way depends on v, too. It is as far from n as v is, on the other side.",
            "mirrors that show the same from wherever one looks"),
    MISTAKE("MI-product", mirror_direction, product_of_components, "v - 2 v n n, by components",
            "v * n multiplies component by component. The dot product is vec3_dot.",
            "mirrors that are right only where they face along an axis"),
    MISTAKE("MI-unit", mirror_direction, made_unit, "(v - 2 (v.n) n) / |v|",
            "it goes the right way, but must be as long as v.",
            "nothing wrong at first; t counts in other lengths"),
    MISTAKE("MI-part", mirror_direction, dot_of_unit, "v - 2 (v.n / |v|) n",
            "what has to be taken off is as long as v makes it: v itself must go into the dot "
            "product.",
            "mirrors that are right only where v has length 1"),
    MISTAKE("MI-square", mirror_direction, dot_with_itself, "v - 2 (v.v) n",
            "how much of v goes along n is v.n; v.v is only its length, squared.",
            "mirrors that show what is straight above them"),
    MISTAKE("MI-side", mirror_direction, one_sided, "v unchanged where v.n is not negative",
            "a mirror has two sides, and the formula is the same for both.",
            "no mirror on the inside of a sphere"),
    MISTAKE("MI-abs", mirror_direction, always_to_the_normals_side, "v + 2 |v.n| n",
            "from the other side of the mirror v.n is positive, and there it is wrong.",
            "mirrors that are wrong on the inside of a sphere"),
    MISTAKE("MI-swapped", mirror_direction, along_the_direction, "n - 2 (v.n) v",
            "v and n have changed places: that is the normal, mirrored at v.",
            "mirrors full of other parts of the scene"),
    {0},
};
