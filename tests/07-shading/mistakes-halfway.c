// mistakes-halfway.c - wrong highlights after Blinn. In formulas h is the half-way vector, unit.
#include "tests/07-shading/mistakes-highlights.h"

static double cosine_to_power(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(n, vec3_unit(vec3_unit(l) + vec3_unit(e)));
}

static vec3 sum(vec3 l, vec3 e)
{
    return vec3_unit(l) + vec3_unit(e);
}

static double mirrored_cosine(vec3 n, vec3 l, vec3 e)
{
    return vec3_dot(vec3_unit(2 * vec3_dot(n, l) * n - l), vec3_unit(e));
}

SLIPS(SLIP_FUNCTION)
OTHER_COSINE(sum_not_unit, vec3_dot(n, sum(l, e)))
OTHER_COSINE(mean_not_unit, vec3_dot(n, sum(l, e) / 2))
OTHER_COSINE(sum_of_lengths, vec3_dot(n, vec3_unit(l + e)))
OTHER_COSINE(nothing_unit, vec3_dot(n, l + e))
OTHER_COSINE(mean_of_all, vec3_dot(n, (l + e) / 2))
OTHER_COSINE(light_not_unit, vec3_dot(n, vec3_unit(l + vec3_unit(e))))
OTHER_COSINE(eye_not_unit, vec3_dot(n, vec3_unit(vec3_unit(l) + e)))
OTHER_COSINE(difference, vec3_dot(n, vec3_unit(vec3_unit(l) - vec3_unit(e))))
OTHER_COSINE(other_difference, vec3_dot(n, vec3_unit(vec3_unit(e) - vec3_unit(l))))
OTHER_COSINE(phong, mirrored_cosine(n, l, e))
OTHER_COSINE(normal_and_light, vec3_dot(n, vec3_unit(l)))
OTHER_COSINE(normal_and_eye, vec3_dot(n, vec3_unit(e)))
OTHER_COSINE(light_and_eye, vec3_dot(vec3_unit(l), vec3_unit(e)))
OTHER_COSINE(halfway_and_eye, vec3_dot(vec3_unit(sum(l, e)), vec3_unit(e)))
OTHER_COSINE(between_normal_and_light, vec3_dot(vec3_unit(n + vec3_unit(l)), vec3_unit(e)))

static Color light_reversed(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    return halfway_term(ks, shine, light, n, -l, e);
}

static Color four_times_the_power(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    return halfway_term(ks, 4 * shine, light, n, l, e);
}

const Mistake halfway_mistakes[] = {
    ROWS_OF_SLIPS("HW", "halfway_term", "n.h"),
    MISTAKE("HW-reversed", halfway_term, reversed, "-(n.h)",
            "both l and e already lead away from the surface, and n does, too.",
            "no highlights at all"),
    MISTAKE("HW-light-reversed", halfway_term, light_reversed, "-l in the place of l",
            "to_light already leads towards the light.", "highlights on the dark side"),
    MISTAKE("HW-sum", halfway_term, sum_not_unit, "n.(l + e), not unit",
            "the sum of two unit vectors is up to 2 long. Make it unit, or it is no cosine.",
            "burnt-out spheres"),
    MISTAKE("HW-mean", halfway_term, mean_not_unit, "n.(l + e) / 2",
            "the mean of two unit vectors is shorter than 1, unless they are the same. Make it "
            "unit.",
            "highlights missing but where the light is behind the eye"),
    MISTAKE("HW-lengths", halfway_term, sum_of_lengths, "l + e with lengths that are not 1",
            "the longer one pulls the sum to its side. Half-way it is only when both are unit "
            "first.",
            "highlights in odd places, which move with the distance of the light"),
    MISTAKE("HW-unit", halfway_term, nothing_unit, "n.(l + e), nothing unit",
            "l and e must be unit before they are added, and the sum after that.",
            "burnt-out spheres"),
    MISTAKE("HW-unit-mean", halfway_term, mean_of_all, "n.(l + e) / 2, nothing unit",
            "l and e must be unit before they are added, and the sum after that.",
            "burnt-out spheres"),
    MISTAKE("HW-unit-light", halfway_term, light_not_unit, "l + e with an l that is not unit",
            "the longer one pulls the sum to its side. Half-way it is only when both are unit "
            "first.",
            "highlights in odd places, which move with the distance of the light"),
    MISTAKE("HW-unit-eye", halfway_term, eye_not_unit, "l + e with an e that is not unit",
            "the longer one pulls the sum to its side. Half-way it is only when both are unit "
            "first.",
            "highlights in the middle of every sphere"),
    MISTAKE("HW-minus", halfway_term, difference, "l - e",
            "that leads from the one to the other. Between them is their sum, and to_eye already "
            "leads from the surface to the eye.",
            "highlights near the rim, towards the light"),
    MISTAKE("HW-eye-minus", halfway_term, other_difference, "e - l",
            "that leads from the one to the other. Between them is their sum.",
            "highlights near the rim, away from the light"),
    MISTAKE("HW-phong", halfway_term, phong, "r.e, with the mirrored light r",
            "that is Phong's highlight. Here nothing is mirrored: it is n.h.",
            "highlights of half the width"),
    MISTAKE("HW-nl", halfway_term, normal_and_light, "n.l in the place of n.h",
            "that is the diffuse term's. A highlight depends on where the eye is.",
            "highlights that stay where they are when the eye moves"),
    MISTAKE("HW-ne", halfway_term, normal_and_eye, "n.e in the place of n.h",
            "a highlight depends on where the light is, too: go half the way to it.",
            "a highlight in the middle of every sphere"),
    MISTAKE("HW-le", halfway_term, light_and_eye, "l.e in the place of n.h",
            "that does not ask how the surface lies: the normal is missing.",
            "whole spheres that glare when the light is behind the eye"),
    MISTAKE("HW-he", halfway_term, halfway_and_eye, "h.e in the place of n.h",
            "h is as far from the eye as from the light anywhere on the surface. What counts is "
            "how far it is from the normal.",
            "whole spheres that glare"),
    MISTAKE("HW-nl-e", halfway_term, between_normal_and_light, "half-way between n and l, with e",
            "the vector is half-way between light and eye; then the normal is compared with it.",
            "highlights in odd places"),
    MISTAKE("HW-four", halfway_term, four_times_the_power, "(n.h)^(4 shine)",
            "that makes the highlight about as small as Phong's. Here the power is shine itself.",
            "small highlights"),
    {0},
};
