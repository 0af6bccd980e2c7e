// 05-quadratic.c - wrong answers to exercise 05.
#include "exercises/05-quadratic.h"

#include "tests/mistakes/mistakes.h"

// ---- to_object_coordinates ----------------------------------------------------------------------

static Ray centre_not_subtracted(Ray ray, Sphere s)
{
    (void)s;
    return ray;
}

static Ray centre_added(Ray ray, Sphere s)
{
    return (Ray){ray.origin + s.center, ray.direction};
}

static Ray seen_from_the_eye(Ray ray, Sphere s)
{
    return (Ray){s.center - ray.origin, ray.direction};
}

static Ray direction_moved_too(Ray ray, Sphere s)
{
    return (Ray){ray.origin - s.center, ray.direction - s.center};
}

static Ray direction_made_unit(Ray ray, Sphere s)
{
    return (Ray){ray.origin - s.center, vec3_unit(ray.direction)};
}

static Ray divided_by_the_radius(Ray ray, Sphere s)
{
    return (Ray){(ray.origin - s.center) / s.radius, ray.direction};
}

// ---- object_quadratic ---------------------------------------------------------------------------

static Quadratic half_b(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), vec3_dot(p, v), vec3_dot(p, p) - r * r};
}

static Quadratic b_of_the_wrong_sign(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), -2 * vec3_dot(p, v), vec3_dot(p, p) - r * r};
}

static Quadratic radius_not_squared(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) - r};
}

static Quadratic radius_added(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) + r * r};
}

static Quadratic a_is_1(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){1, 2 * vec3_dot(p, v), vec3_dot(p, p) - r * r};
}

static Quadratic a_is_a_length(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_length(v), 2 * vec3_dot(p, v), vec3_dot(p, p) - r * r};
}

static Quadratic radius_left_out(Ray ray, double r)
{
    (void)r;
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p)};
}

static Quadratic a_and_c_swapped(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(p, p) - r * r, 2 * vec3_dot(p, v), vec3_dot(v, v)};
}

// In place of the dot product: components multiplied, and the first one taken.
static Quadratic first_components_only(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){(v * v)[0], 2 * (p * v)[0], (p * p)[0] - r * r};
}

static Quadratic absolute_c(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), fabs(vec3_dot(p, p) - r * r)};
}

// ---- world_quadratic ----------------------------------------------------------------------------

// The slide's a, b, c for a ray seen from somewhere: q is what stands for p - c.
static Quadratic seen_from(vec3 q, Ray ray, double r)
{
    vec3 v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(q, v), vec3_dot(q, q) - r * r};
}

static Quadratic world_without_centre(Ray ray, Sphere s)
{
    return seen_from(ray.origin, ray, s.radius);
}

static Quadratic world_centre_added(Ray ray, Sphere s)
{
    return seen_from(ray.origin + s.center, ray, s.radius);
}

static Quadratic world_from_the_eye(Ray ray, Sphere s)
{
    return seen_from(s.center - ray.origin, ray, s.radius);
}

static Quadratic world_half_b(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b / 2, q.c};
}

static Quadratic world_radius_not_squared(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b, q.c + s.radius * s.radius - s.radius};
}

static Quadratic world_radius_added(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b, q.c + 2 * s.radius * s.radius};
}

static Quadratic world_a_is_1(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){1, q.b, q.c};
}

// |p - c|^2 = |p|^2 - |c|^2
static Quadratic squares_subtracted(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b,
                       vec3_dot(ray.origin, ray.origin) - vec3_dot(s.center, s.center) -
                           s.radius * s.radius};
}

static Quadratic mixed_product_once(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b, q.c + vec3_dot(ray.origin, s.center)};
}

static Quadratic centre_squared_left_out(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, q.b, q.c - vec3_dot(s.center, s.center)};
}

static Quadratic centre_only_in_c(Ray ray, Sphere s)
{
    Quadratic q = seen_from(ray.origin - s.center, ray, s.radius);
    return (Quadratic){q.a, 2 * vec3_dot(ray.origin, ray.direction), q.c};
}

static Quadratic direction_from_the_centre(Ray ray, Sphere s)
{
    ray.direction -= s.center;
    return seen_from(ray.origin - s.center, ray, s.radius);
}

// ---- quadratic_roots ----------------------------------------------------------------------------

static const Roots no_roots = {0};

static Roots line_root(Quadratic q)
{
    return q.b == 0 ? no_roots : (Roots){1, {-q.c / q.b}};
}

static Roots in_order(double t, double u)
{
    return t <= u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
}

// The formula of the slide; right, but for the digits that it loses.
static Roots slide(Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));
}

static Roots halved_then_times_a(Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / 2 * q.a, (-q.b + sqrt(d)) / 2 * q.a);
}

static Roots not_divided_by_2(Quadratic q)
{
    Roots roots = slide(q);
    for (int i = 0; q.a != 0 && i < roots.count; i++)
        roots.t[i] *= 2;
    return roots;
}

static Roots not_divided_by_a(Quadratic q)
{
    Roots roots = slide(q);
    return q.a == 0 || roots.count == 0 ? roots : in_order(q.a * roots.t[0], q.a * roots.t[1]);
}

static Roots b_squared_less_ac(Quadratic q)
{
    double d = q.b * q.b - q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));
}

static Roots b_squared_plus_4ac(Quadratic q)
{
    return slide((Quadratic){q.a, q.b, -q.c});
}

static Roots plus_b(Quadratic q)
{
    return slide((Quadratic){q.a, -q.b, q.c});
}

static Roots double_root_lost(Quadratic q)
{
    return q.a != 0 && q.b * q.b - 4 * q.a * q.c == 0 ? no_roots : slide(q);
}

static Roots double_root_once(Quadratic q)
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] == roots.t[1])
        roots.count = 1;
    return roots;
}

static Roots minus_before_plus(Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return (Roots){2, {(-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a)}};
}

static Roots descending(Quadratic q)
{
    Roots roots = slide(q);
    return roots.count < 2 ? roots : (Roots){2, {roots.t[1], roots.t[0]}};
}

static Roots real_parts(Quadratic q)
{
    double middle = -q.b / (2 * q.a);
    return q.a != 0 && q.b * q.b - 4 * q.a * q.c < 0 ? (Roots){2, {middle, middle}} : slide(q);
}

static Roots line_not_seen(Quadratic q)
{
    return q.a == 0 ? no_roots : slide(q);
}

static Roots line_with_two_roots(Quadratic q)
{
    return q.a == 0 && q.b != 0 ? (Roots){2, {-q.c / q.b, -q.c / q.b}} : slide(q);
}

static Roots line_of_the_wrong_sign(Quadratic q)
{
    return q.a == 0 && q.b != 0 ? (Roots){1, {q.c / q.b}} : slide(q);
}

static Roots constant_divided_by_0(Quadratic q)
{
    return q.a == 0 ? (Roots){1, {-q.c / q.b}} : slide(q);
}

static Roots zero_equals_zero(Quadratic q)
{
    return q.a == 0 && q.b == 0 && q.c == 0 ? (Roots){1, {0}} : slide(q);
}

static Roots positive_roots_only(Quadratic q)
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] <= 0)
        return roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : no_roots;
    return roots;
}

static Roots nothing_where_b_is_0(Quadratic q)
{
    return q.b == 0 ? no_roots : slide(q);
}

// q = -(b + sqrt(D)) / 2, without looking at the sign of b; then c / q divides by 0.
static Roots sum_without_sign(Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    double sum = -(q.b + sqrt(d)) / 2;
    return in_order(sum / q.a, q.c / sum);
}

// The stable sum, but neither the discriminant nor the range is looked after.
static Roots only_the_sum(Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c;
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    double sum = -(q.b + copysign(sqrt(d), q.b)) / 2;
    return sum == 0 ? (Roots){2, {0, 0}} : in_order(sum / q.a, q.c / sum);
}

// ---- sphere_roots -------------------------------------------------------------------------------

static Roots slide_for_spheres(Ray ray, Sphere s)
{
    return slide(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

static Roots slide_in_world_coordinates(Ray ray, Sphere s)
{
    return slide(world_quadratic(ray, s));
}

static Roots stable_roots_of_the_slide(Ray ray, Sphere s)
{
    return quadratic_roots(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

static Roots in_single_precision(Ray ray, Sphere s)
{
    Quadratic q = object_quadratic(to_object_coordinates(ray, s), s.radius);
    return slide((Quadratic){(float)q.a, (float)q.b, (float)q.c});
}

// Measured from the foot of the perpendicular, but squares leave the range of a double.
static Roots foot_without_scale(Ray ray, Sphere s)
{
    vec3 p = ray.origin - s.center, v = ray.direction;
    double foot = -vec3_dot(p, v) / vec3_dot(v, v), l = vec3_length(p + foot * v);
    if (!(l <= s.radius))
        return no_roots;
    double half = sqrt((s.radius - l) * (s.radius + l)) / vec3_length(v);
    return (Roots){2, {foot - half, foot + half}};
}

static Roots sphere_at_the_origin(Ray ray, Sphere s)
{
    return quadratic_roots(object_quadratic(ray, s.radius));
}

static Roots direction_made_unit_first(Ray ray, Sphere s)
{
    ray.direction = vec3_unit(ray.direction);
    return slide_for_spheres(ray, s);
}

static Roots ahead_only(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[1] <= 0 ? no_roots : roots;
}

static Roots outside_only(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[0] < 0 && roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : roots;
}

static Roots tangent_is_a_miss(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[0] == roots.t[1] ? no_roots : roots;
}

static Roots tangent_is_met_once(Ray ray, Sphere s)
{
    return double_root_once(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

static Roots always_met(Ray ray, Sphere s)
{
    return real_parts(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

static Roots radius_doubled(Ray ray, Sphere s)
{
    s.radius *= 2;
    return slide_for_spheres(ray, s);
}

static Roots far_one_first(Ray ray, Sphere s)
{
    return descending(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

// ---- hit_sphere ---------------------------------------------------------------------------------

static double far_root(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}

static double first_root_even_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

static double missed_from_inside(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[0] > 0 ? roots.t[0] : NO_HIT;
}

static double first_root_above(Ray ray, Sphere s, double least)
{
    Roots roots = sphere_roots(ray, s);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least)
            return roots.t[i];
    return NO_HIT;
}

static double epsilon_of_a_tenth(Ray ray, Sphere s)
{
    return first_root_above(ray, s, 0.1);
}

static double epsilon_of_a_thousandth(Ray ray, Sphere s)
{
    return first_root_above(ray, s, 0.001);
}

static double from_the_image_plane(Ray ray, Sphere s)
{
    return first_root_above(ray, s, 1);
}

static double zero_is_a_hit(Ray ray, Sphere s)
{
    return first_root_above(ray, s, -1e-300);
}

static double tangent_missed(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count == 2 && roots.t[0] == roots.t[1] ? NO_HIT : first_root_above(ray, s, 0);
}

static double minus_1_for_no_hit(Ray ray, Sphere s)
{
    double t = first_root_above(ray, s, 0);
    return t < NO_HIT ? t : -1;
}

static double zero_for_no_hit(Ray ray, Sphere s)
{
    double t = first_root_above(ray, s, 0);
    return t < NO_HIT ? t : 0;
}

static double way_for_t(Ray ray, Sphere s)
{
    return first_root_above(ray, s, 0) * vec3_length(ray.direction);
}

static double both_ways(Ray ray, Sphere s)
{
    return fabs(first_root_even_behind(ray, s));
}

static double middle_of_the_chord(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    double middle = (roots.t[0] + roots.t[1]) / 2;
    return roots.count > 0 && middle > 0 ? middle : NO_HIT;
}

static double centre_forgotten(Ray ray, Sphere s)
{
    s.center = vec3_of(0, 0, 0);
    return first_root_above(ray, s, 0);
}

static double count_not_asked(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    if (roots.t[0] > 0)
        return roots.t[0];
    return roots.t[1] > 0 ? roots.t[1] : roots.t[0];
}

static double surface_is_left_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[0] == 0 ? NO_HIT : first_root_above(ray, s, 0);
}

const Mistake mistakes[] = {
    MISTAKE("Q7", to_object_coordinates, centre_not_subtracted, "c not subtracted from p"),
    MISTAKE("Q9", to_object_coordinates, centre_added, "p + c"),
    MISTAKE("O-eye", to_object_coordinates, seen_from_the_eye, "c - p"),
    MISTAKE("O-both", to_object_coordinates, direction_moved_too, "c subtracted from v too"),
    MISTAKE("O-unit", to_object_coordinates, direction_made_unit, "v made unit"),
    MISTAKE("O-radius", to_object_coordinates, divided_by_the_radius, "divided by r"),

    MISTAKE("Q1", object_quadratic, half_b, "b = p.v"),
    MISTAKE("Q2", object_quadratic, b_of_the_wrong_sign, "the sign of b"),
    MISTAKE("Q3", object_quadratic, radius_not_squared, "p.p - r"),
    MISTAKE("Q4", object_quadratic, radius_added, "p.p + r^2"),
    MISTAKE("Q5", object_quadratic, a_is_1, "a = 1"),
    MISTAKE("Q5-root", object_quadratic, a_is_a_length, "a = |v|"),
    MISTAKE("Q-point", object_quadratic, radius_left_out, "r left out"),
    MISTAKE("Q-swap", object_quadratic, a_and_c_swapped, "a and c swapped"),
    MISTAKE("Q-dot", object_quadratic, first_components_only, "v * v for v.v"),
    MISTAKE("Q-abs", object_quadratic, absolute_c, "c made positive"),

    MISTAKE("Q7-world", world_quadratic, world_without_centre, "c left out"),
    MISTAKE("Q9-world", world_quadratic, world_centre_added, "p + c"),
    MISTAKE("Q2-world", world_quadratic, world_from_the_eye, "2 v.(c - p)"),
    MISTAKE("Q1-world", world_quadratic, world_half_b, "the 2 of b left out"),
    MISTAKE("Q3-world", world_quadratic, world_radius_not_squared, "r for r^2"),
    MISTAKE("Q4-world", world_quadratic, world_radius_added, "+ r^2"),
    MISTAKE("Q5-world", world_quadratic, world_a_is_1, "a = 1"),
    MISTAKE("Q-squares", world_quadratic, squares_subtracted, "p.p - c.c for |p - c|^2"),
    MISTAKE("Q-once", world_quadratic, mixed_product_once, "p.c once, not twice"),
    MISTAKE("Q-cc", world_quadratic, centre_squared_left_out, "c.c left out"),
    MISTAKE("Q-b", world_quadratic, centre_only_in_c, "b = 2 p.v, without c"),
    MISTAKE("Q-v", world_quadratic, direction_from_the_centre, "c subtracted from v too"),

    MISTAKE("R1", quadratic_roots, halved_then_times_a, "/ 2 * a for / (2 * a)"),
    MISTAKE("R1-2", quadratic_roots, not_divided_by_2, "/ a"),
    MISTAKE("R1-a", quadratic_roots, not_divided_by_a, "/ 2"),
    MISTAKE("R2", quadratic_roots, b_squared_less_ac, "b^2 - ac"),
    MISTAKE("R2-plus", quadratic_roots, b_squared_plus_4ac, "b^2 + 4ac"),
    MISTAKE("R4", quadratic_roots, plus_b, "+b"),
    MISTAKE("R5", quadratic_roots, double_root_lost, "discriminant > 0"),
    MISTAKE("R5-once", quadratic_roots, double_root_once, "a double root counted once"),
    MISTAKE("R-order", quadratic_roots, minus_before_plus, "not put in order where a < 0"),
    MISTAKE("R-down", quadratic_roots, descending, "descending"),
    MISTAKE("R-real", quadratic_roots, real_parts, "a negative discriminant taken for 0"),
    MISTAKE("R-line", quadratic_roots, line_not_seen, "no root where a = 0"),
    MISTAKE("R-line2", quadratic_roots, line_with_two_roots, "a line with two roots"),
    MISTAKE("R-sign", quadratic_roots, line_of_the_wrong_sign, "c / b for a line"),
    MISTAKE("R-zero", quadratic_roots, constant_divided_by_0, "-c / b where b = 0 too"),
    MISTAKE("R-all", quadratic_roots, zero_equals_zero, "one root where all is 0"),
    MISTAKE("R-ahead", quadratic_roots, positive_roots_only, "negative roots left out"),
    MISTAKE("R-b0", quadratic_roots, nothing_where_b_is_0, "no roots where b = 0"),
    MISTAKE("R-q", quadratic_roots, sum_without_sign, "the stable sum without the sign of b"),
    MISTAKE("X-slide", quadratic_roots, slide, "the slide's formula loses digits (extra)"),
    MISTAKE("X-sum", quadratic_roots, only_the_sum, "only the stable sum (extra)"),

    MISTAKE("X-sphere", sphere_roots, slide_for_spheres, "the slide's formula (extra)"),
    MISTAKE("X-world", sphere_roots, slide_in_world_coordinates, "in world coordinates (extra)"),
    MISTAKE("X-stable", sphere_roots, stable_roots_of_the_slide, "only the sum is stable (extra)"),
    MISTAKE("X-scale", sphere_roots, foot_without_scale, "squares that overflow (extra)"),
    MISTAKE("S-float", sphere_roots, in_single_precision, "float"),
    MISTAKE("Q7-roots", sphere_roots, sphere_at_the_origin, "every sphere at the origin"),
    MISTAKE("S-unit", sphere_roots, direction_made_unit_first, "v made unit: t is a length"),
    MISTAKE("S-ahead", sphere_roots, ahead_only, "what is behind left out"),
    MISTAKE("S-inside", sphere_roots, outside_only, "from inside one root"),
    MISTAKE("R5-sphere", sphere_roots, tangent_is_a_miss, "tangent lost"),
    MISTAKE("S-once", sphere_roots, tangent_is_met_once, "tangent counted once"),
    MISTAKE("S-always", sphere_roots, always_met, "a miss taken for tangent"),
    MISTAKE("S-double", sphere_roots, radius_doubled, "the diameter for the radius"),
    MISTAKE("S-down", sphere_roots, far_one_first, "the far one first"),

    MISTAKE("R6", hit_sphere, far_root, "the far root"),
    MISTAKE("R7", hit_sphere, first_root_even_behind, "no test for t > 0"),
    MISTAKE("R8", hit_sphere, missed_from_inside, "a miss where the nearer root is negative"),
    MISTAKE("R10", hit_sphere, epsilon_of_a_tenth, "an epsilon of 0.1"),
    MISTAKE("R10-small", hit_sphere, epsilon_of_a_thousandth, "an epsilon of 0.001"),
    MISTAKE("D1", hit_sphere, from_the_image_plane, "nothing in front of the plane"),
    MISTAKE("T-zero", hit_sphere, zero_is_a_hit, "t >= 0"),
    MISTAKE("R5-hit", hit_sphere, tangent_missed, "tangent lost"),
    MISTAKE("T-minus1", hit_sphere, minus_1_for_no_hit, "-1 for NO_HIT"),
    MISTAKE("T-none0", hit_sphere, zero_for_no_hit, "0 for NO_HIT"),
    MISTAKE("T-way", hit_sphere, way_for_t, "the distance for t"),
    MISTAKE("T-abs", hit_sphere, both_ways, "|t|"),
    MISTAKE("T-middle", hit_sphere, middle_of_the_chord, "the middle of the chord"),
    MISTAKE("Q7-hit", hit_sphere, centre_forgotten, "every sphere at the origin"),
    MISTAKE("T-count", hit_sphere, count_not_asked, "count not looked at"),
    MISTAKE("T-surface", hit_sphere, surface_is_left_behind, "a miss where one root is 0"),
    {0},
};
