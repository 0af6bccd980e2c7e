// mistakes-halfway.c - wrong highlights after Blinn. In formulas h is the half-way vector,
// normalised.
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
            "l and e already point away from the surface, as n does.", "no highlights at all"),
    MISTAKE("HW-light-reversed", halfway_term, light_reversed, "-l instead of l",
            "to_light already points towards the light.", "highlights on the dark side"),
    MISTAKE("HW-sum", halfway_term, sum_not_unit, "n.(l + e), not normalised",
            "the sum of two unit vectors is up to 2 long. Normalise it: only then is the dot "
            "product a cosine.",
            "spheres with large white areas"),
    MISTAKE("HW-mean", halfway_term, mean_not_unit, "n.(l + e) / 2",
            "the mean of two unit vectors is shorter than 1, unless they are equal. Normalise it.",
            "no highlights, except where the light is behind the eye"),
    MISTAKE("HW-lengths", halfway_term, sum_of_lengths, "l + e with lengths that are not 1",
            "the longer one pulls the sum to its side. The sum is half-way only if both are "
            "normalised first.",
            "highlights in odd places, which move with the distance of the light"),
    MISTAKE("HW-unit", halfway_term, nothing_unit, "n.(l + e), nothing normalised",
            "l and e must be normalised before they are added, and the sum afterwards.",
            "spheres with large white areas"),
    MISTAKE("HW-unit-mean", halfway_term, mean_of_all, "n.(l + e) / 2, nothing normalised",
            "l and e must be normalised before they are added, and the sum afterwards.",
            "spheres with large white areas"),
    MISTAKE("HW-unit-light", halfway_term, light_not_unit, "l + e with an l that is not normalised",
            "the longer one pulls the sum to its side. The sum is half-way only if both are "
            "normalised first.",
            "highlights in odd places, which move with the distance of the light"),
    MISTAKE("HW-unit-eye", halfway_term, eye_not_unit, "l + e with an e that is not normalised",
            "the longer one pulls the sum to its side. The sum is half-way only if both are "
            "normalised first.",
            "highlights in the middle of every sphere"),
    MISTAKE("HW-minus", halfway_term, difference, "l - e",
            "this leads from one to the other. Between them is their sum, and to_eye already "
            "points from the surface to the eye.",
            "highlights near the edge, towards the light"),
    MISTAKE("HW-eye-minus", halfway_term, other_difference, "e - l",
            "this leads from one to the other. Between them is their sum.",
            "highlights near the edge, away from the light"),
    MISTAKE("HW-phong", halfway_term, phong, "r.e, with the mirrored light r",
            "this is Phong's highlight. This function mirrors nothing: it needs n.h.",
            "highlights of half the width"),
    MISTAKE("HW-nl", halfway_term, normal_and_light, "n.l instead of n.h",
            "this is the cosine of the diffuse term. A highlight depends on where the eye is.",
            "highlights that stay where they are when the eye moves"),
    MISTAKE("HW-ne", halfway_term, normal_and_eye, "n.e instead of n.h",
            "a highlight also depends on where the light is: h is half-way to it.",
            "a highlight in the middle of every sphere"),
    MISTAKE("HW-le", halfway_term, light_and_eye, "l.e instead of n.h",
            "this does not depend on the surface: the normal is missing.",
            "whole spheres too bright when the light is behind the eye"),
    MISTAKE("HW-he", halfway_term, halfway_and_eye, "h.e instead of n.h",
            "h is equally far from the eye and from the light, anywhere on the surface. The angle "
            "between h and the normal counts.",
            "whole spheres too bright"),
    MISTAKE("HW-nl-e", halfway_term, between_normal_and_light, "half-way between n and l, with e",
            "the vector is half-way between light and eye; compare it with the normal.",
            "highlights in odd places"),
    MISTAKE("HW-four", halfway_term, four_times_the_power, "(n.h)^(4 shine)",
            "this makes the highlight about as small as Phong's. Here the power is shine itself.",
            "small highlights"),
    {0},
};
