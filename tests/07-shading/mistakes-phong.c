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

// 2 (n.l) n - l, where only one of the two l is unit.
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
    MISTAKE(
        "PH-reversed", phong_term, reversed, "-(r.e)",
        "mirror_direction takes what comes in, which is -l, and e leads to the eye: one of them "
        "has the wrong sign.",
        "highlights missing, or on the opposite side"),
    MISTAKE("PH-light-reversed", phong_term, light_reversed, "-l in the place of l",
            "to_light already leads towards the light.", "highlights on the dark side"),
    MISTAKE("PH-eye-side", phong_term, light_hidden_by_the_eyes_side,
            "n.e > 0 in the place of n.l > 0",
            "it is the light that must be on the side of the normal, or it does not reach the "
            "surface.",
            "highlights on the dark side"),
    MISTAKE("PH-nl", phong_term, normal_and_light, "n.l in the place of r.e",
            "that is the diffuse term's. A highlight depends on where the eye is.",
            "highlights that stay where they are when the eye moves"),
    MISTAKE("PH-ne", phong_term, normal_and_eye, "n.e in the place of r.e",
            "a highlight depends on where the light is, too: mirror it, then compare with e.",
            "a highlight in the middle of every sphere"),
    MISTAKE("PH-le", phong_term, light_and_eye, "l.e in the place of r.e",
            "the surface mirrors the light before it can come to the eye: the normal is missing.",
            "whole spheres that glare when the light is behind the eye"),
    MISTAKE("PH-unit-light", phong_term, light_not_unit, "r.e with an l that is not unit",
            "then it is no cosine, but |l| times one.", "burnt-out spheres"),
    MISTAKE("PH-unit-eye", phong_term, eye_not_unit, "r.e with an e that is not unit",
            "then it is no cosine, but |e| times one.", "burnt-out spheres"),
    MISTAKE("PH-unit", phong_term, nothing_unit, "r.e with vectors that are not unit",
            "then it is no cosine, but both lengths times one.", "burnt-out spheres"),
    MISTAKE("PH-unit-half", phong_term, half_unit, "2 (n.l / |l|) n - l",
            "l must be unit in both places, or in none and r in the end.",
            "highlights missing, or in odd places"),
    MISTAKE("PH-unit-late", phong_term, half_unit_then_unit, "2 (n.l / |l|) n - l, made unit",
            "l must be unit in both places, or in none: this leads to another direction.",
            "highlights missing, or in odd places"),
    MISTAKE("PH-once", phong_term, mirrored_once, "r = (n.l) n - l",
            "that ends on the surface. To get to the other side of the normal it is 2 (n.l) n - l.",
            "highlights missing, or near the rim"),
    MISTAKE("PH-halfway", phong_term, halfway, "n.h, with the half-way vector h",
            "that is Blinn's highlight, which is larger. Phong's is r.e.",
            "highlights of twice the width"),
    {0},
};
