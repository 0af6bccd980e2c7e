// laws-terms.c - laws of the terms: the share of each light that comes back, colour by colour.
#include "tests/07-shading/laws.h"

#include "tests/judge/reference/distinct_digits.h"

// Ten times what the contract allows.
static const double enough = 1e-8;

static const char *const names[] = {"red", "green", "blue"};

static bool not_finite(Color color)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(color[i])) {
            law_broken("your %s is not a finite number", names[i]);
            return true;
        }
    return false;
}

// The share, in each colour; 'of' names the whole.
static void is_share(Color yours, double share, const char *why, Color of, const char *of_what)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(yours[i] - share * of[i]) <= enough * (1 + fabs(share * of[i])))
            continue;
        Apart a = apart(yours[i] / of[i], share);
        if (of[i] == 0)
            law_broken("your %s is %s, but %s has no %s", names[i], number_text(yours[i]).s,
                       of_what, names[i]);
        else
            law_broken("your %s is %s times %s; %s is %s", names[i], a.yours.s, of_what, why,
                       a.right.s);
        return;
    }
}

static bool is_black(Color yours, const char *why)
{
    for (int i = 0; i < 3; i++)
        if (!(fabs(yours[i]) <= enough)) {
            law_broken("%s, so nothing comes back; your %s is %s", why, names[i],
                       number_text(yours[i]).s);
            return false;
        }
    return true;
}

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

void law_ambient_term(Color yours, Color surface, double kd, Color ambient)
{
    if (!not_finite(yours))
        is_share(yours, kd, "kd", surface * ambient, "the surface's times the light's");
}

void law_diffuse_term(Color yours, Color surface, double kd, Color light, vec3 normal,
                      vec3 to_light)
{
    double cosine = cosine_between(normal, to_light);
    if (not_finite(yours))
        return;
    if (cosine < 0) {
        is_black(yours, "the light is behind the surface");
        return;
    }
    char what[240];
    snprintf(what, sizeof what, "kd times the cosine of %s degrees",
             number_text_to(acos(fmin(1, cosine)) * 180 / PI, 4).s);
    is_share(yours, kd * cosine, what, surface * light, "the surface's times the light's");
}

// The part that both highlights share; name is that of the cosine. An eye behind the surface does
// not see a highlight, and an answer that says so is also right.
static void law_of_highlight(Color yours, double ks, double shine, Color light, double low,
                             double high, double cosine, const char *name)
{
    char what[480];
    if (not_finite(yours) || fabs(low) < enough || fabs(cosine) < enough || high < enough)
        return;
    if (low < 0) {
        is_black(yours, "the light is behind the surface");
    } else if (cosine < 0) {
        snprintf(what, sizeof what, "the cosine of %s is negative, %s", name,
                 number_text_to(cosine, 4).s);
        is_black(yours, what);
    } else {
        snprintf(what, sizeof what, "ks times %s, the cosine of %s, to the power of %s",
                 number_text_to(cosine, 6).s, name, number_text_to(shine, 6).s);
        is_share(yours, ks * pow(cosine, shine), what, light, "the light's");
    }
}

void law_phong_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                    vec3 to_eye)
{
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    double cosine = 2 * low * high - cosine_between(to_light, to_eye);
    law_of_highlight(yours, ks, shine, light, low, high, cosine, "mirrored light and eye");
}

void law_halfway_term(Color yours, double ks, double shine, Color light, vec3 normal, vec3 to_light,
                      vec3 to_eye)
{
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    double length = sqrt(2 + 2 * cosine_between(to_light, to_eye)); // of the sum of both
    if (length > 1e-3)
        law_of_highlight(yours, ks, shine, light, low, high, (low + high) / length,
                         "normal and half-way vector");
}
