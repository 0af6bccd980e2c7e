// 07-shading.c - right answers to exercise 07, written otherwise.
#include "exercises/07-shading.h"

#include "tests/variants/07-shading-scene.h"
#include "tests/variants/variants.h"

static const Color black = {0, 0, 0};

// ---- the ways of light --------------------------------------------------------------------------

static vec3 divided_by_radius(Sphere sphere, vec3 point)
{
    return (point - sphere.center) / sphere.radius;
}

static vec3 inward_and_turned(Sphere sphere, vec3 point)
{
    vec3 inward = sphere.center - point;
    return -inward / sqrt(vec3_dot(inward, inward));
}

static Ray by_a_switch(vec3 from, Light light)
{
    switch (light.kind) {
    case LIGHT_POINT:
        return (Ray){.origin = from, .direction = light.position - from};
    case LIGHT_DISTANT:
    default:
        return (Ray){.origin = from, .direction = light.position};
    }
}

static Ray changed_where_it_is_near(vec3 from, Light light)
{
    Ray ray = {from, light.position};
    if (light.kind == LIGHT_POINT)
        ray.direction -= from;
    return ray;
}

static vec3 along_and_across(vec3 direction, vec3 normal)
{
    vec3 along = vec3_dot(direction, normal) * normal, across = direction - along;
    return across - along;
}

static vec3 back_from_the_other_side(vec3 direction, vec3 normal)
{
    vec3 outward = -direction;
    return 2 * vec3_dot(outward, normal) * normal - outward;
}

static vec3 by_a_unit_direction(vec3 direction, vec3 normal)
{
    double length = vec3_length(direction);
    vec3 unit = direction / length;
    return length * (unit - normal * 2 * vec3_dot(normal, unit));
}

// Householder's matrix, row by row.
static vec3 by_a_matrix(vec3 v, vec3 n)
{
    vec3 mirrored = v;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            mirrored[i] -= 2 * n[i] * n[k] * v[k];
    return mirrored;
}

// ---- terms --------------------------------------------------------------------------------------

static Color ambient_by_components(Color surface, double kd, Color ambient)
{
    Color color = {0};
    for (int i = 0; i < 3; i++)
        color[i] = surface[i] * ambient[i] * kd;
    return color;
}

static Color diffuse_by_components(Color surface, double kd, Color light, vec3 normal,
                                   vec3 to_light)
{
    double cosine = vec3_dot(normal, to_light) / vec3_length(to_light);
    if (cosine <= 0)
        return black;
    double share = kd * cosine;
    return vec3_of(share * surface[0] * light[0], share * surface[1] * light[1],
                   share * surface[2] * light[2]);
}

static Color all_made_unit(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    double cosine = vec3_dot(vec3_unit(to_light), vec3_unit(normal));
    return ambient_term(surface, kd, light) * (cosine > 0 ? cosine : 0);
}

// ---- highlights ---------------------------------------------------------------------------------

static Color phong_by_the_formula(double ks, double shine, Color light, vec3 n, vec3 to_light,
                                  vec3 to_eye)
{
    vec3 l = vec3_unit(to_light), e = vec3_unit(to_eye);
    vec3 r = 2 * vec3_dot(n, l) * n - l;
    if (vec3_dot(n, l) <= 0)
        return black;
    return light * (ks * pow(fmax(0, vec3_dot(r, e)), shine));
}

// The eye mirrored, and compared with the light.
static Color eye_mirrored(double ks, double shine, Color light, vec3 n, vec3 to_light, vec3 to_eye)
{
    vec3 mirrored = vec3_unit(mirror_direction(-to_eye, n));
    double cosine = vec3_dot(mirrored, vec3_unit(to_light));
    if (cosine < 0 || vec3_dot(to_light, n) < 0)
        return black;
    return ks * light * pow(cosine, shine);
}

static Color phong_by_cosines(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    double low = vec3_dot(n, l), far = vec3_length(l) * vec3_length(e);
    double cosine = (2 * low * vec3_dot(n, e) - vec3_dot(l, e)) / far;
    return low > 0 && cosine > 0 ? ks * exp(shine * log(cosine)) * light : black;
}

// Who is behind the surface does not see it.
static Color phong_not_seen_from_behind(double ks, double shine, Color light, vec3 n, vec3 l,
                                        vec3 e)
{
    return vec3_dot(n, e) <= 0 ? black : phong_by_the_formula(ks, shine, light, n, l, e);
}

static Color halfway_by_the_mean(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 halfway = (vec3_unit(l) + vec3_unit(e)) / 2;
    double cosine = vec3_dot(n, halfway) / vec3_length(halfway);
    if (vec3_dot(n, l) <= 0)
        return black;
    return light * (ks * pow(fmax(0, cosine), shine));
}

// Each as long as the other.
static Color halfway_by_lengths(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 halfway = vec3_unit(vec3_length(e) * l + vec3_length(l) * e);
    double cosine = vec3_dot(halfway, n);
    bool seen = vec3_dot(l, n) > 0 && cosine > 0;
    return seen ? ks * exp(shine * log(cosine)) * light : black;
}

static Color halfway_not_seen_from_behind(double ks, double shine, Color light, vec3 n, vec3 l,
                                          vec3 e)
{
    return vec3_dot(n, e) <= 0 ? black : halfway_by_the_mean(ks, shine, light, n, l, e);
}

// ---- for a display ------------------------------------------------------------------------------

static Color clamped_by_conditions(Color color)
{
    for (int i = 0; i < 3; i++) {
        if (color[i] < 0)
            color[i] = 0;
        else if (color[i] > 1)
            color[i] = 1;
    }
    return color;
}

static double between_0_and_1(double x)
{
    return x > 1 ? 1 : x > 0 ? x : 0;
}

static Color clamped_by_a_helper(Color c)
{
    return vec3_of(between_0_and_1(c[0]), between_0_and_1(c[1]), between_0_and_1(c[2]));
}

static Color encoded_by_logarithms(Color color, double gamma)
{
    for (int i = 0; i < 3; i++)
        color[i] = color[i] > 0 ? exp(log(color[i]) / gamma) : 0;
    return color;
}

static Color encoded_after_clamping(Color color, double gamma)
{
    const double power = 1 / gamma;
    color = clamp_color(color);
    for (int i = 2; i >= 0; i--)
        color[i] = pow(color[i], power);
    return color;
}

const Variant variants[] = {
    VARIANT(surface_normal, divided_by_radius, "divided by the radius"),
    VARIANT(surface_normal, inward_and_turned, "inward, and turned round"),
    VARIANT(ray_to_light, by_a_switch, "a switch"),
    VARIANT(ray_to_light, changed_where_it_is_near, "changed for a point light"),
    VARIANT(mirror_direction, along_and_across, "the parts along and across the normal"),
    VARIANT(mirror_direction, back_from_the_other_side, "2 (n.-v) n + v"),
    VARIANT(mirror_direction, by_a_unit_direction, "a unit direction, made as long again"),
    VARIANT(mirror_direction, by_a_matrix, "Householder's matrix"),
    VARIANT(ambient_term, ambient_by_components, "component by component"),
    VARIANT(diffuse_term, diffuse_by_components, "n.l / |l|, component by component"),
    VARIANT(diffuse_term, all_made_unit, "the normal made unit, too"),
    VARIANT(phong_term, phong_by_the_formula, "2 (n.l) n - l"),
    VARIANT(phong_term, eye_mirrored, "the eye mirrored"),
    VARIANT(phong_term, phong_by_cosines, "of three dot products, by logarithms"),
    VARIANT(phong_term, phong_not_seen_from_behind, "nothing for an eye behind the surface"),
    VARIANT(halfway_term, halfway_by_the_mean, "the mean, divided by its length"),
    VARIANT(halfway_term, halfway_by_lengths, "both as long as each other first"),
    VARIANT(halfway_term, halfway_not_seen_from_behind, "nothing for an eye behind the surface"),
    VARIANT(clamp_color, clamped_by_conditions, "conditions"),
    VARIANT(clamp_color, clamped_by_a_helper, "a helper function"),
    VARIANT(gamma_encode, encoded_by_logarithms, "by logarithms"),
    VARIANT(gamma_encode, encoded_after_clamping, "clamped first"),
    VARIANT(off_surface, a_billionth, "1e-9 of the size"),
    VARIANT(off_surface, as_little_as_allowed, "as little as the contract allows"),
    VARIANT(off_surface, as_far_as_allowed, "as far as the contract allows"),
    VARIANT(off_surface, by_the_length_of_the_centre, "the length of the centre for its largest"),
    VARIANT(off_surface, with_a_loop, "coordinate by coordinate"),
    VARIANT(visibility, by_the_nearest_hit, "by nearest_hit"),
    VARIANT(visibility, in_lengths, "unit directions and lengths"),
    VARIANT(visibility, by_distances, "the distance of each centre from the way"),
    VARIANT(shade, skipping_hidden_lights, "sums of their own, lights backward"),
    VARIANT(shade, all_in_one, "all formulas in place"),
    VARIANT(trace_ray, from_the_last_mirror_back, "unit directions, as far off as allowed"),
    VARIANT(trace_ray, in_a_loop, "a loop, as little off as allowed"),
    {0},
};
