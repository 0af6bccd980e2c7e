// right.c - right answers to exercise 05, written in other ways.
#include "exercises/05-quadratic.h"

#include "tests/judge/known.h"

// ---- object_quadratic ---------------------------------------------------------------------------

static double squared_excess(Ray ray, double radius, double t)
{
    vec3 point = ray.origin + t * ray.direction;
    return vec3_dot(point, point) - radius * radius;
}

// |p + v|^2 = |p|^2 + 2 p.v + |v|^2.
RIGHT(object_quadratic, "b from |p + v|")
{
    vec3 p = object_ray.origin, v = object_ray.direction, diagonal = p + v;
    double pp = vec3_dot(p, p), vv = vec3_dot(v, v);
    return (Quadratic){
        .c = pp - radius * radius, .b = vec3_dot(diagonal, diagonal) - pp - vv, .a = vv};
}

RIGHT(object_quadratic, "lengths squared, and a unit direction")
{
    double length = vec3_length(object_ray.direction), distance = vec3_length(object_ray.origin);
    double along = vec3_dot(object_ray.origin, vec3_unit(object_ray.direction));
    return (Quadratic){length * length, 2 * length * along, pow(distance, 2) - pow(radius, 2)};
}

RIGHT(object_quadratic, "in long double")
{
    long double a = 0, half = 0, c = -(long double)radius * radius;
    for (int i = 0; i < 3; i++) {
        long double p = object_ray.origin[i], v = object_ray.direction[i];
        a += v * v;
        half += p * v;
        c += p * p;
    }
    return (Quadratic){(double)a, (double)(2 * half), (double)c};
}

RIGHT(object_quadratic, "with fma")
{
    Quadratic q = {0, 0, -radius * radius};
    for (int i = 0; i < 3; i++) {
        q.a = fma(object_ray.direction[i], object_ray.direction[i], q.a);
        q.b = fma(2 * object_ray.origin[i], object_ray.direction[i], q.b);
        q.c = fma(object_ray.origin[i], object_ray.origin[i], q.c);
    }
    return q;
}

RIGHT(object_quadratic, "c = (|p| - r)(|p| + r)")
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    double distance = vec3_length(p);
    return (Quadratic){vec3_dot(v, v), vec3_dot(p, v) + vec3_dot(v, p),
                       (distance - radius) * (distance + radius)};
}

RIGHT(object_quadratic, "the parabola through t = -1, 0 and 1")
{
    double before = squared_excess(object_ray, radius, -1),
           at = squared_excess(object_ray, radius, 0),
           after = squared_excess(object_ray, radius, 1);
    return (Quadratic){(before + after) / 2 - at, (after - before) / 2, at};
}

// ---- world_quadratic ----------------------------------------------------------------------------

// (p + tv)^2 = p^2 + 2pv t + v^2 t^2, of one axis.
static Quadratic squared(double p, double v)
{
    return (Quadratic){v * v, 2 * p * v, p * p};
}

static Quadratic sum(Quadratic a, Quadratic b)
{
    return (Quadratic){a.a + b.a, a.b + b.b, a.c + b.c};
}

RIGHT(world_quadratic, "a helper that squares one axis")
{
    Quadratic q = {.c = -sphere.radius * sphere.radius};
    for (int i = 0; i < 3; i++)
        q = sum(q, squared(ray.origin[i] - sphere.center[i], ray.direction[i]));
    return q;
}

RIGHT(world_quadratic, "multiplied out, axis by axis")
{
    vec3 p = ray.origin, v = ray.direction, m = sphere.center;
    double r = sphere.radius, a = 0, b = 0, c = 0;
    for (int i = 0; i < 3; i++) {
        a += v[i] * v[i];
        b += 2 * p[i] * v[i] - 2 * m[i] * v[i];
        c += p[i] * p[i] - 2 * p[i] * m[i] + m[i] * m[i];
    }
    return (Quadratic){a, b, c - r * r};
}

RIGHT(world_quadratic, "c = (|p - C| + r)(|p - C| - r)")
{
    vec3 from_center = ray.origin - sphere.center;
    double far = hypot(hypot(from_center[0], from_center[1]), from_center[2]);
    return (Quadratic){.a = vec3_dot(ray.direction, ray.direction),
                       .b = 2 * vec3_dot(ray.direction, from_center),
                       .c = (far + sphere.radius) * (far - sphere.radius)};
}

RIGHT_LINE(world_quadratic, "made of the other two answers",
           return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius))

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

// So that nothing overflows: the roots stay the same.
static Roots largest_made_1(Quadratic q)
{
    double largest = fmax(fabs(q.a), fmax(fabs(q.b), fabs(q.c)));
    return largest == 0 ? (Roots){.count = 0}
                        : plain((Quadratic){q.a / largest, q.b / largest, q.c / largest});
}

RIGHT_LINE(quadratic_roots, "divided by the largest coefficient", return largest_made_1(q))

RIGHT(quadratic_roots, "in long double; the second from the sum")
{
    if (q.a == 0)
        return line(q.b, q.c);
    long double a = q.a, b = q.b, c = q.c, d = b * b - 4 * a * c;
    if (d < 0)
        return (Roots){.count = 0};
    long double low = -b / (2 * a) - sqrtl(d) / fabsl(2 * a);
    return (Roots){2, {(double)low, (double)(-b / a - low)}};
}

RIGHT(quadratic_roots, "Kahan's discriminant, with fma")
{
    if (q.a == 0)
        return line(q.b, q.c);
    double h = -q.b / 2, ac = q.a * q.c, d = fma(h, h, -ac) + fma(-q.a, q.c, ac);
    if (d < 0)
        return (Roots){.count = 0};
    double w = h + copysign(sqrt(d), h);
    Roots roots = {2, {w / q.a, w != 0 ? q.c / w : 0}};
    return roots.t[0] <= roots.t[1] ? roots : (Roots){2, {roots.t[1], roots.t[0]}};
}

RIGHT(quadratic_roots, "the vertex, and the distance to each side")
{
    if (q.a == 0)
        return line(q.b, q.c);
    double middle = -q.b / (2 * q.a), lowest = q.c - q.b * q.b / (4 * q.a);
    double reach_squared = -lowest / q.a;
    if (reach_squared < 0)
        return (Roots){.count = 0};
    double reach = sqrt(reach_squared);
    return (Roots){2, {middle - reach, middle + reach}};
}

RIGHT(quadratic_roots, "the sign that comes first depends on the sign of a")
{
    double d = pow(q.b, 2) - 4 * q.a * q.c;
    if (q.a == 0)
        return line(q.b, q.c);
    if (!(d >= 0))
        return (Roots){.count = 0};
    double first = q.a > 0 ? -sqrt(d) : sqrt(d);
    return (Roots){2, {(-q.b + first) / (2 * q.a), (-q.b - first) / (2 * q.a)}};
}

RIGHT_LINE(quadratic_roots, "the slide's formula, and a swap", return plain(q))
RIGHT_LINE(quadratic_roots, "half of b", return half_b(q))

// t^2 + pt + q = 0, as taught in German schools.
RIGHT(quadratic_roots, "divided by a first")
{
    if (q.a == 0)
        return line(q.b, q.c);
    double middle = -(q.b / q.a) / 2, d = middle * middle - q.c / q.a;
    if (d < 0)
        return (Roots){.count = 0};
    return (Roots){2, {middle - sqrt(d), middle + sqrt(d)}};
}

// The sum that does not cancel; the other root from the product of both (Citardauq).
RIGHT(quadratic_roots, "the other root from the product")
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

// All lengths of the world in radii: then the sphere has radius 1 and its center at the origin.
RIGHT(sphere_roots, "the world divided by the radius")
{
    vec3 p = (ray.origin - sphere.center) / sphere.radius, v = ray.direction / sphere.radius;
    return plain((Quadratic){vec3_dot(v, v), 2 * vec3_dot(v, p), vec3_dot(p, p) - 1});
}

// |p x v| / |v| is the distance of the line from the center.
RIGHT(sphere_roots, "the distance with the cross product")
{
    vec3 to_center = sphere.center - ray.origin, v = ray.direction;
    double length = vec3_length(v), aside = vec3_length(vec3_cross(to_center, v)) / length;
    if (aside > sphere.radius)
        return (Roots){.count = 0};
    double middle = vec3_dot(to_center, v) / length;
    double half = sqrt(sphere.radius * sphere.radius - aside * aside);
    return (Roots){.count = 2, .t = {(middle - half) / length, (middle + half) / length}};
}

RIGHT_LINE(sphere_roots, "made of the other answers",
           return plain(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius)))
RIGHT_LINE(sphere_roots, "in world coordinates", return half_b(world_quadratic(ray, sphere)))

RIGHT(sphere_roots, "the center projected onto the ray")
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

RIGHT(sphere_roots, "half a chord from the closest point")
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

static double first_ahead(const double *t, int count)
{
    if (count == 0)
        return NO_HIT;
    return *t > 0 ? *t : first_ahead(t + 1, count - 1);
}

RIGHT(hit_sphere, "the foot of the perpendicular, and half a chord")
{
    double length = vec3_length(ray.direction), r = sphere.radius;
    vec3 way = ray.direction / length, to_center = sphere.center - ray.origin;
    double middle = vec3_dot(to_center, way);
    vec3 foot = ray.origin + middle * way;
    double aside = vec3_length(foot - sphere.center);
    if (aside > r)
        return NO_HIT;
    double half = sqrt(r * r - aside * aside);
    if (middle - half > 0)
        return (middle - half) / length;
    return middle + half > 0 ? (middle + half) / length : NO_HIT;
}

// As the lesson advises for distant spheres; if not distant, the slide's formula.
RIGHT(hit_sphere, "c = (|p| - r)(|p| + r) in place")
{
    vec3 p = ray.origin - sphere.center, v = ray.direction;
    double far = vec3_length(p), r = sphere.radius;
    Roots roots = plain((Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), (far - r) * (far + r)});
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}

RIGHT(hit_sphere, "the largest coefficient made 1")
{
    Roots roots = largest_made_1(world_quadratic(ray, sphere));
    return first_ahead(roots.t, roots.count);
}

RIGHT(hit_sphere, "all in one function, with half of b")
{
    vec3 oc = ray.origin - sphere.center;
    double a = vec3_dot(ray.direction, ray.direction), h = vec3_dot(oc, ray.direction);
    double c = vec3_dot(oc, oc) - sphere.radius * sphere.radius, discriminant = h * h - a * c;
    if (discriminant < 0)
        return NO_HIT;
    double root = (-h - sqrt(discriminant)) / a;
    if (root <= 0)
        root = (-h + sqrt(discriminant)) / a;
    return root > 0 ? root : NO_HIT;
}

RIGHT(hit_sphere, "in radii, and in long double")
{
    long double a = 0, h = 0, c = -1;
    for (int i = 0; i < 3; i++) {
        long double p = ((long double)ray.origin[i] - sphere.center[i]) / sphere.radius;
        long double v = (long double)ray.direction[i] / sphere.radius;
        a += v * v;
        h += p * v;
        c += p * p;
    }
    long double d = h * h - a * c;
    if (d < 0)
        return NO_HIT;
    long double near = (-h - sqrtl(d)) / a, far = (-h + sqrtl(d)) / a;
    return near > 0 ? (double)near : far > 0 ? (double)far : NO_HIT;
}

RIGHT(hit_sphere, "conditions instead of a loop")
{
    Roots roots = sphere_roots(ray, sphere);
    if (roots.count == 0 || roots.t[1] <= 0)
        return NO_HIT;
    return roots.t[0] > 0 ? roots.t[0] : roots.t[1];
}

RIGHT(hit_sphere, "from the last root down")
{
    Roots roots = quadratic_roots(world_quadratic(ray, sphere));
    for (int i = roots.count; i-- > 0;)
        if (roots.t[i] <= 0)
            return i + 1 < roots.count ? roots.t[i + 1] : NO_HIT;
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

RIGHT(hit_sphere, "a unit direction, then t / |v|")
{
    double length = vec3_length(ray.direction);
    vec3 way = ray.direction / length, p = ray.origin - sphere.center;
    double b = 2 * vec3_dot(p, way), c = vec3_dot(p, p) - sphere.radius * sphere.radius;
    Roots roots = plain((Quadratic){1, b, c});
    double t = roots.count > 0 && roots.t[0] <= 0 ? roots.t[1] : roots.t[0];
    return roots.count > 0 && t > 0 ? t / length : NO_HIT;
}
