// mistakes-phong.c - wrong highlights after Phong. In formulas r is the mirrored light.
#include "tests/07-shading/mistakes-highlights.h"

// For unit vectors: of the mirrored l with e.
static double mirrored_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(2 * vec3_dot(n, l) * n - l, e);
}

static double cosine_to_power(vec3 n, vec3 l, vec3 e)
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

static double halfway_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(n, vec3_unit(vec3_unit(l) + vec3_unit(e)));
}

SLIPS(SLIP_FUNCTION)
OTHER_COSINE(normal_and_light, vec3_dot(n, vec3_unit(l)))
OTHER_COSINE(normal_and_eye, vec3_dot(n, vec3_unit(e)))
OTHER_COSINE(light_and_eye, vec3_dot(vec3_unit(l), vec3_unit(e)))
OTHER_COSINE(light_not_unit, mirrored_cosine(n, l, vec3_unit(e)))
OTHER_COSINE(eye_not_unit, mirrored_cosine(n, vec3_unit(l), e))
OTHER_COSINE(nothing_unit, mirrored_cosine(n, l, e))
OTHER_COSINE(half_unit, first_is_unit(n, l, e))
OTHER_COSINE(half_unit_then_unit, first_is_unit_then_all(n, l, e))
OTHER_COSINE(mirrored_once, once(n, l, e))
OTHER_COSINE(halfway, halfway_cosine(n, l, e))

static Color light_reversed(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    return phong_term(ks, shine, light, n, -l, e);
}

static Color light_hidden_by_the_eyes_side(double ks, double shine, Color light, vec3 n, vec3 l,
                                           vec3 e)
{
    double cosine = cosine_to_power(n, l, e);
    return vec3_dot(n, e) > 0 && cosine > 0 ? ks * pow(cosine, shine) * light : grey(0);
}

const Mistake phong_mistakes[] = {
    ROWS_OF_SLIPS("PH", "phong_term", "r.e"),
    MISTAKE("PH-reversed", phong_term, reversed, "-(r.e)",
            "mirror_direction takes the incoming direction, which is -l, and e points to the eye: "
            "one of them has the wrong sign.",
            "highlights missing, or on the opposite side"),
    MISTAKE("PH-light-reversed", phong_term, light_reversed, "-l instead of l",
            "to_light already points towards the light.", "highlights on the dark side"),
    MISTAKE(
        "PH-eye-side", phong_term, light_hidden_by_the_eyes_side, "n.e > 0 instead of n.l > 0",
        "the light must be on the side of the normal: if it is not, it does not reach the surface.",
        "highlights on the dark side"),
    MISTAKE("PH-nl", phong_term, normal_and_light, "n.l instead of r.e",
            "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
            "highlights that stay where they are when the eye moves"),
    MISTAKE("PH-ne", phong_term, normal_and_eye, "n.e instead of r.e",
            "a highlight also depends on where the light is: mirror it, then compare with e.",
            "a highlight in the middle of every sphere"),
    MISTAKE("PH-le", phong_term, light_and_eye, "l.e instead of r.e",
            "the surface mirrors the light before it reaches the eye: the normal is missing.",
            "whole spheres too bright when the light is behind the eye"),
    MISTAKE("PH-unit-light", phong_term, light_not_unit, "r.e with an l that is not normalised",
            "then it is not the cosine, but |l| times the cosine.",
            "spheres with large white areas"),
    MISTAKE("PH-unit-eye", phong_term, eye_not_unit, "r.e with an e that is not normalised",
            "then it is not the cosine, but |e| times the cosine.",
            "spheres with large white areas"),
    MISTAKE("PH-unit", phong_term, nothing_unit, "r.e with vectors that are not normalised",
            "then it is not the cosine, but both lengths times the cosine.",
            "spheres with large white areas"),
    MISTAKE("PH-unit-half", phong_term, half_unit, "2 (n.l / |l|) n - l",
            "normalise l in both places, or in neither and then r.",
            "highlights missing, or in odd places"),
    MISTAKE("PH-unit-late", phong_term, half_unit_then_unit, "2 (n.l / |l|) n - l, normalised",
            "normalise l in both places, or in neither: this has another direction.",
            "highlights missing, or in odd places"),
    MISTAKE("PH-once", phong_term, mirrored_once, "r = (n.l) n - l",
            "this ends on the surface. The other side of the normal is 2 (n.l) n - l.",
            "highlights missing, or near the edge"),
    MISTAKE("PH-halfway", phong_term, halfway, "n.h, with the half-way vector h",
            "this is Blinn's highlight, which is larger. Phong's is r.e.",
            "highlights of twice the width"),
    {0},
};
