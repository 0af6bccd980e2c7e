// 05-quadratic.c - right answers to exercise 05, written otherwise.
#include "exercises/05-quadratic.h"

#include "tests/variants/variants.h"

// ---- to_object_coordinates ----------------------------------------------------------------------

static Ray only_the_origin_moves(Ray ray, Sphere sphere)
{
    ray.origin -= sphere.center;
    return ray;
}

// ---- object_quadratic ---------------------------------------------------------------------------

static Quadratic summed_by_components(Ray ray, double radius)
{
    Quadratic q = {0, 0, -(radius * radius)};
    for (int i = 0; i < 3; i++) {
        q.a += ray.direction[i] * ray.direction[i];
        q.b += ray.direction[i] * ray.origin[i] * 2;
        q.c += ray.origin[i] * ray.origin[i];
    }
    return q;
}

static Quadratic c_as_a_product(Ray ray, double radius)
{
    vec3 p = ray.origin, v = ray.direction;
    double distance = vec3_length(p);
    return (Quadratic){vec3_dot(v, v), vec3_dot(p, v) + vec3_dot(v, p),
                       (distance - radius) * (distance + radius)};
}

static double squared_excess(Ray ray, double radius, double t)
{
    vec3 point = ray.origin + t * ray.direction;
    return vec3_dot(point, point) - radius * radius;
}

static Quadratic through_three_points(Ray ray, double radius)
{
    double before = squared_excess(ray, radius, -1), at = squared_excess(ray, radius, 0),
           after = squared_excess(ray, radius, 1);
    return (Quadratic){(before + after) / 2 - at, (after - before) / 2, at};
}

// ---- world_quadratic ----------------------------------------------------------------------------

static Quadratic difference_first(Ray ray, Sphere sphere)
{
    vec3 from_center = ray.origin - sphere.center, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(from_center, v),
                       vec3_dot(from_center, from_center) - sphere.radius * sphere.radius};
}

static Quadratic towards_the_centre(Ray ray, Sphere sphere)
{
    vec3 to_center = sphere.center - ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), -2 * vec3_dot(to_center, v),
                       vec3_dot(to_center, to_center) - sphere.radius * sphere.radius};
}

static Quadratic by_object_coordinates(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

// ---- quadratic_roots ----------------------------------------------------------------------------

static Roots line(double b, double c)
{
    return b == 0 ? (Roots){.count = 0} : (Roots){1, {-c / b}};
}

static Roots plain(Quadratic q)
{
    if (q.a == 0)
        return line(q.b, q.c);
    double d = q.b * q.b - 4 * q.a * q.c;
    if (d < 0)
        return (Roots){.count = 0};
    double root = sqrt(d);
    Roots roots = {2, {(-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a)}};
    if (roots.t[0] > roots.t[1]) {
        double swapped = roots.t[0];
        roots.t[0] = roots.t[1];
        roots.t[1] = swapped;
    }
    return roots;
}

static Roots made_positive_first(Quadratic q)
{
    if (q.a == 0)
        return line(q.b, q.c);
    if (q.a < 0)
        q = (Quadratic){-q.a, -q.b, -q.c};
    double root = sqrt(q.b * q.b - 4 * q.a * q.c);
    if (isnan(root))
        return (Roots){.count = 0};
    return (Roots){2, {(-q.b - root) / 2 / q.a, (-q.b + root) / 2 / q.a}};
}

static Roots half_b(Quadratic q)
{
    double h = q.b / 2, d = h * h - q.a * q.c;
    if (q.a == 0)
        return line(q.b, q.c);
    if (d < 0)
        return (Roots){.count = 0};
    double t = (-h - sqrt(d)) / q.a, u = (-h + sqrt(d)) / q.a;
    return (Roots){2, {fmin(t, u), fmax(t, u)}};
}

// t^2 + pt + q = 0, as German schools have it.
static Roots divided_by_a(Quadratic q)
{
    if (q.a == 0)
        return line(q.b, q.c);
    double middle = -(q.b / q.a) / 2, d = middle * middle - q.c / q.a;
    if (d < 0)
        return (Roots){.count = 0};
    return (Roots){2, {middle - sqrt(d), middle + sqrt(d)}};
}

// The sum that does not cancel; the other root from the product of both (Citardauq).
static Roots without_cancelling(Quadratic q)
{
    if (q.a == 0)
        return line(q.b, q.c);
    double d = q.b * q.b - 4 * q.a * q.c;
    if (d < 0)
        return (Roots){.count = 0};
    double sum = q.b < 0 ? -q.b + sqrt(d) : -q.b - sqrt(d);
    double t = sum / (2 * q.a), u = sum == 0 ? 0 : 2 * q.c / sum;
    return t < u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
}

// ---- sphere_roots -------------------------------------------------------------------------------

static Roots as_it_is_given(Ray ray, Sphere sphere)
{
    return plain(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
}

static Roots in_the_world(Ray ray, Sphere sphere)
{
    return half_b(world_quadratic(ray, sphere));
}

static Roots projected(Ray ray, Sphere sphere)
{
    double length = vec3_length(ray.direction);
    vec3 way = ray.direction / length, to_center = sphere.center - ray.origin;
    double along = vec3_dot(to_center, way);
    double aside_squared = vec3_dot(to_center, to_center) - along * along;
    double half_squared = sphere.radius * sphere.radius - aside_squared;
    if (half_squared < 0)
        return (Roots){.count = 0};
    double half = sqrt(half_squared);
    return (Roots){2, {(along - half) / length, (along + half) / length}};
}

static Roots by_the_closest_point(Ray ray, Sphere sphere)
{
    vec3 p = ray.origin - sphere.center, v = ray.direction;
    double a = vec3_dot(v, v), foot = -vec3_dot(p, v) / a;
    double l = vec3_length(p + foot * v), r = sphere.radius;
    if (l > r)
        return (Roots){.count = 0};
    double half = sqrt((r - l) * (r + l) / a);
    return (Roots){2, {foot - half, foot + half}};
}

// ---- hit_sphere ---------------------------------------------------------------------------------

static double nested_conditions(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    if (roots.count == 0 || roots.t[1] <= 0)
        return NO_HIT;
    return roots.t[0] > 0 ? roots.t[0] : roots.t[1];
}

static double smallest_of_all(Ray ray, Sphere sphere)
{
    Roots roots = by_the_closest_point(ray, sphere);
    double nearest = NO_HIT;
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0 && roots.t[i] < nearest)
            nearest = roots.t[i];
    return nearest;
}

static double from_the_world(Ray ray, Sphere sphere)
{
    Roots roots = quadratic_roots(world_quadratic(ray, sphere));
    for (int i = roots.count; i-- > 0;)
        if (roots.t[i] <= 0)
            return i + 1 < roots.count ? roots.t[i + 1] : NO_HIT;
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

// From outside, what points away cannot hit.
static double rejected_early(Ray ray, Sphere sphere)
{
    vec3 p = ray.origin - sphere.center, v = ray.direction;
    double a = vec3_dot(v, v), h = vec3_dot(p, v);
    double c = vec3_dot(p, p) - sphere.radius * sphere.radius, d = h * h - a * c;
    if ((c >= 0 && h >= 0) || d < 0)
        return NO_HIT;
    double near = (-h - sqrt(d)) / a, far = (-h + sqrt(d)) / a;
    return near > 0 ? near : far > 0 ? far : NO_HIT;
}

static double with_a_unit_direction(Ray ray, Sphere sphere)
{
    double length = vec3_length(ray.direction);
    vec3 way = ray.direction / length, p = ray.origin - sphere.center;
    double b = 2 * vec3_dot(p, way), c = vec3_dot(p, p) - sphere.radius * sphere.radius;
    Roots roots = plain((Quadratic){1, b, c});
    double t = roots.count > 0 && roots.t[0] <= 0 ? roots.t[1] : roots.t[0];
    return roots.count > 0 && t > 0 ? t / length : NO_HIT;
}

const Variant variants[] = {
    VARIANT(to_object_coordinates, only_the_origin_moves, "the origin of a copy moves"),
    VARIANT(object_quadratic, summed_by_components, "component by component"),
    VARIANT(object_quadratic, c_as_a_product, "c = (|p| - r)(|p| + r)"),
    VARIANT(object_quadratic, through_three_points, "the parabola through t = -1, 0 and 1"),
    VARIANT(world_quadratic, difference_first, "p - C comes first"),
    VARIANT(world_quadratic, towards_the_centre, "C - p, and the sign of b changed"),
    VARIANT(world_quadratic, by_object_coordinates, "made of the other two answers"),
    VARIANT(quadratic_roots, plain, "the slide's formula, and a swap"),
    VARIANT(quadratic_roots, made_positive_first, "a made positive, a NaN asked for"),
    VARIANT(quadratic_roots, half_b, "half of b"),
    VARIANT(quadratic_roots, divided_by_a, "divided by a first"),
    VARIANT(quadratic_roots, without_cancelling, "the other root from the product"),
    VARIANT(sphere_roots, as_it_is_given, "made of the other answers"),
    VARIANT(sphere_roots, in_the_world, "in world coordinates"),
    VARIANT(sphere_roots, projected, "the centre projected onto the ray"),
    VARIANT(sphere_roots, by_the_closest_point, "half a chord from the closest point"),
    VARIANT(hit_sphere, nested_conditions, "conditions in place of a loop"),
    VARIANT(hit_sphere, smallest_of_all, "the smallest of those above 0"),
    VARIANT(hit_sphere, from_the_world, "from the last root down"),
    VARIANT(hit_sphere, rejected_early, "what points away rejected early"),
    VARIANT(hit_sphere, with_a_unit_direction, "a unit direction, then t / |v|"),
    {0},
};
