// variants.c - right answers to exercise 07, written in other ways.
#include "exercises/07-shading.h"

#include "tests/07-shading/variants-scene.h"
#include "tests/proof/variants.h"

static const Color black = {0, 0, 0};

// ---- directions of light ------------------------------------------------------------------------

static vec3 divided_by_radius(Sphere sphere, vec3 point)
{
    return (point - sphere.center) / sphere.radius;
}

static vec3 inward_and_turned(Sphere sphere, vec3 point)
{
    vec3 inward = sphere.center - point;
    return -inward / sqrt(vec3_dot(inward, inward));
}

// The gradient of |p - c|^2, whose length is twice the radius.
static vec3 gradient(Sphere sphere, vec3 point)
{
    vec3 gradient = {0};
    for (int i = 0; i < 3; i++)
        gradient[i] = 2 * (point[i] - sphere.center[i]);
    return vec3_unit(gradient);
}

static vec3 in_long_doubles(Sphere sphere, vec3 point)
{
    long double x = point[0] - sphere.center[0], y = point[1] - sphere.center[1];
    long double z = point[2] - sphere.center[2], length = sqrtl(x * x + y * y + z * z);
    return vec3_of((double)(x / length), (double)(y / length), (double)(z / length));
}

static Ray field_by_field(vec3 from, Light light)
{
    Ray ray;
    bool near = light.kind == LIGHT_POINT;
    ray.origin = from;
    ray.direction = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        ray.direction[i] = near ? light.position[i] - from[i] : light.position[i];
    return ray;
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

// Rotated by half a turn around the normal, and reversed.
static vec3 by_half_a_turn(vec3 direction, vec3 normal)
{
    vec3 across = vec3_cross(vec3_cross(normal, direction), normal);
    vec3 turned = vec3_dot(direction, normal) * normal - across;
    return -turned;
}

// In a frame on the mirror.
static vec3 in_a_frame(vec3 direction, vec3 normal)
{
    int axis = fabs(normal[0]) < 0.6 ? 0 : fabs(normal[1]) < 0.6 ? 1 : 2;
    vec3 other = {0};
    other[axis] = 1;
    vec3 u = vec3_unit(vec3_cross(normal, other)), w = vec3_cross(normal, u);
    return vec3_dot(direction, u) * u + vec3_dot(direction, w) * w -
           vec3_dot(direction, normal) * normal;
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

static Color light_first(Color surface, double kd, Color ambient)
{
    Color arrives = ambient * kd;
    return arrives * surface;
}

static Color by_the_angle(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    double aside = vec3_length(vec3_cross(normal, to_light)), up = vec3_dot(normal, to_light);
    return up > 0 ? cos(atan2(aside, up)) * kd * surface * light : black;
}

static Color never_negative(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    double cosine = vec3_dot(normal, vec3_unit(to_light));
    return kd * (cosine + fabs(cosine)) / 2 * (light * surface);
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

static Color unit_before_mirroring(double ks, double shine, Color light, vec3 n, vec3 to_light,
                                   vec3 to_eye)
{
    vec3 mirrored = mirror_direction(-vec3_unit(to_light), n);
    double cosine = vec3_dot(mirrored, to_eye) / sqrt(vec3_dot(to_eye, to_eye));
    Color color = black;
    if (cosine > 0)
        if (vec3_dot(to_light, n) > 0)
            color += pow(cosine, shine) * (ks * light);
    return color;
}

// Half a turn around the normal takes the light to its mirrored direction.
static Color phong_by_half_a_turn(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 across = l - vec3_dot(l, n) * n, turned = l - 2 * across;
    long double cosine = vec3_dot(turned, e) / sqrtl(vec3_dot(l, l)) / vec3_length(e);
    double power = cosine > 0 && vec3_dot(l, n) > 0 ? (double)powl(cosine, shine) : 0;
    return vec3_of(ks * light[0] * power, ks * light[1] * power, ks * light[2] * power);
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

// An eye behind the surface does not see it.
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

// n.(l + e) / |l + e|, of three dot products of unit vectors.
static Color halfway_by_cosines(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    l = vec3_unit(l);
    e = vec3_unit(e);
    double length = sqrt(2 + 2 * vec3_dot(l, e));
    double cosine = (vec3_dot(n, l) + vec3_dot(n, e)) / length;
    return vec3_dot(n, l) > 0 && cosine > 0 ? ks * light * pow(cosine, shine) : black;
}

static Color halfway_in_long_double(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 h = vec3_unit(l) + vec3_unit(e);
    long double cosine = vec3_dot(n, h) / sqrtl(vec3_dot(h, h)), share = 0;
    if (vec3_dot(n, l) > 0 && cosine > 0)
        share = ks * expl(shine * logl(cosine));
    for (int i = 0; i < 3; i++)
        light[i] *= (double)share;
    return light;
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

static Color clamped_from_above(Color c)
{
    Color most = {1, 1, 1};
    for (int i = 0; i < 3; i++) {
        c[i] = most[i] < c[i] ? most[i] : c[i];
        c[i] = c[i] < black[i] ? black[i] : c[i];
    }
    return c;
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

static Color encoded_in_base_2(Color color, double gamma)
{
    for (int i = 0; i < 3; i++)
        color[i] = color[i] <= 0 ? 0 : exp2(log2(color[i]) / gamma);
    return color;
}

static Color encoded_by_roots(Color color, double gamma)
{
    for (int i = 0; i < 3; i++)
        color[i] = gamma == 1   ? color[i]
                   : gamma == 2 ? sqrt(color[i])
                   : gamma == 3 ? cbrt(color[i])
                                : (double)powl(color[i], 1 / (long double)gamma);
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

static const Variant variants[] = {
    VARIANT(surface_normal, divided_by_radius, "divided by the radius"),
    VARIANT(surface_normal, inward_and_turned, "inward, and reversed"),
    VARIANT(surface_normal, gradient, "the gradient, normalised"),
    VARIANT(surface_normal, in_long_doubles, "long double"),
    VARIANT(ray_to_light, field_by_field, "field by field"),
    VARIANT(ray_to_light, by_a_switch, "a switch"),
    VARIANT(ray_to_light, changed_where_it_is_near, "changed for a point light"),
    VARIANT(mirror_direction, along_and_across, "the parts along and across the normal"),
    VARIANT(mirror_direction, back_from_the_other_side, "2 (n.-v) n + v"),
    VARIANT(mirror_direction, by_a_unit_direction, "a unit direction, with its length restored"),
    VARIANT(mirror_direction, by_a_matrix, "Householder's matrix"),
    VARIANT(mirror_direction, by_half_a_turn, "half a turn around the normal, and reversed"),
    VARIANT(mirror_direction, in_a_frame, "a frame on the mirror"),
    VARIANT(ambient_term, light_first, "the light times kd first"),
    VARIANT(ambient_term, ambient_by_components, "component by component"),
    VARIANT(diffuse_term, diffuse_by_components, "n.l / |l|, component by component"),
    VARIANT(diffuse_term, by_the_angle, "the angle, with atan2"),
    VARIANT(diffuse_term, never_negative, "(c + |c|) / 2"),
    VARIANT(diffuse_term, all_made_unit, "the normal normalised as well"),
    VARIANT(phong_term, phong_by_the_formula, "2 (n.l) n - l"),
    VARIANT(phong_term, unit_before_mirroring, "normalised first, then mirrored"),
    VARIANT(phong_term, phong_by_half_a_turn, "half a turn around the normal"),
    VARIANT(phong_term, eye_mirrored, "the eye mirrored"),
    VARIANT(phong_term, phong_by_cosines, "of three dot products, with logarithms"),
    VARIANT(phong_term, phong_not_seen_from_behind, "nothing for an eye behind the surface"),
    VARIANT(halfway_term, halfway_by_the_mean, "the mean, divided by its length"),
    VARIANT(halfway_term, halfway_by_cosines, "of three dot products"),
    VARIANT(halfway_term, halfway_in_long_double, "long double, with logarithms"),
    VARIANT(halfway_term, halfway_by_lengths, "both as long as each other first"),
    VARIANT(halfway_term, halfway_not_seen_from_behind, "nothing for an eye behind the surface"),
    VARIANT(clamp_color, clamped_by_conditions, "conditions"),
    VARIANT(clamp_color, clamped_from_above, "conditions, from above first"),
    VARIANT(clamp_color, clamped_by_a_helper, "a helper function"),
    VARIANT(gamma_encode, encoded_by_logarithms, "with logarithms"),
    VARIANT(gamma_encode, encoded_in_base_2, "logarithms in base 2"),
    VARIANT(gamma_encode, encoded_by_roots, "sqrt and cbrt, else powl"),
    VARIANT(gamma_encode, encoded_after_clamping, "clamped first"),
    VARIANT(off_surface, a_billionth, "1e-9 of the size"),
    VARIANT(off_surface, as_little_as_allowed, "as little as the contract allows"),
    VARIANT(off_surface, as_far_as_allowed, "as far as the contract allows"),
    VARIANT(off_surface, by_the_length_of_the_centre,
            "the length of the centre instead of its largest coordinate"),
    VARIANT(off_surface, with_a_loop, "coordinate by coordinate"),
    VARIANT(visibility, by_the_nearest_hit, "with nearest_hit"),
    VARIANT(visibility, in_lengths, "unit directions and lengths"),
    VARIANT(visibility, by_distances, "the distance of each centre from the way"),
    VARIANT(visibility, by_recursion, "recursion"),
    VARIANT(visibility, without_what_hides, "the number of spheres that hide it"),
    VARIANT(visibility, in_long_double, "the nearest, in long double"),
    VARIANT(shade, lights_by_recursion, "recursion over the lights"),
    VARIANT(shade, color_by_color, "colour by colour, in long double"),
    VARIANT(shade, skipping_hidden_lights, "sums of their own, lights backward"),
    VARIANT(shade, all_in_one, "all formulas in place"),
    VARIANT(trace_ray, from_the_last_mirror_back, "unit directions, as far off as allowed"),
    VARIANT(trace_ray, on_a_stack, "a stack of colours"),
    VARIANT(trace_ray, in_a_loop, "a loop, as little off as allowed"),
    {0},
};
OF_STEM(variants)
