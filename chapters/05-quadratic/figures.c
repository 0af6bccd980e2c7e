// figures.c - what the figures of chapter 05 show, in numbers.
#include "chapters/05-quadratic/figures.h"

#include "chapters/05-quadratic/section.h"
#include "exercises/05-quadratic.h"

#include <stdio.h>

enum { DIGITS = 6, SAMPLES = 400, SITUATIONS = 5 };

// A wrong answer, or none yet, may say anything of how many there are.
static int count_of(Roots roots)
{
    return roots.count < 0 ? 0 : roots.count > 2 ? 2 : roots.count;
}

static double root_of(Roots roots, int i)
{
    return i < count_of(roots) ? roots.t[i] : NAN;
}

static Quadratic quadratic_of(const Meeting *m)
{
    return object_quadratic(to_object_coordinates(m->ray, m->sphere), m->sphere.radius);
}

static double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// f(t) = |p + tv|^2 - r^2, by its coefficients.
static double value(Quadratic q, double t)
{
    return q.a * t * t + q.b * t + q.c;
}

// ---- numbers and marks -------------------------------------------------------------------------

static const char *joined(const char *left, const char *right)
{
    static char name[40];
    snprintf(name, sizeof name, "%s%s", left, right);
    return name;
}

// PREFIXa, PREFIXb, PREFIXc and the discriminant, PREFIXD.
static void coefficients(Plot *plot, const char *prefix, Quadratic q)
{
    plot_number_to(plot, joined(prefix, "a"), q.a, DIGITS);
    plot_number_to(plot, joined(prefix, "b"), q.b, DIGITS);
    plot_number_to(plot, joined(prefix, "c"), q.c, DIGITS);
    plot_number_to(plot, joined(prefix, "D"), discriminant(q), DIGITS);
}

// So many digits that the two roots are told apart.
static int digits_of(Roots roots)
{
    double apart = root_of(roots, 1) - root_of(roots, 0), large = fabs(root_of(roots, 1));
    return apart > 0 && large / apart > 10 ? (int)fmin(4 + floor(log10(large / apart)), 12) : 4;
}

// PREFIXroots, how many; PREFIXt0 and PREFIXt1.
static void root_numbers(Plot *plot, const char *prefix, Roots roots)
{
    plot_number(plot, joined(prefix, "roots"), count_of(roots));
    plot_number_to(plot, joined(prefix, "t0"), root_of(roots, 0), digits_of(roots));
    plot_number_to(plot, joined(prefix, "t1"), root_of(roots, 1), digits_of(roots));
}

// A place on the line; not a number where t is none, so that nothing is drawn.
static void mark(Plot *plot, const char *name, Ray ray, double t)
{
    plot_point(plot, name, ray.origin + (isfinite(t) ? t : NAN) * ray.direction);
}

// ---- ray-sphere --------------------------------------------------------------------------------

static void ray_sphere(Plot *plot, void *given)
{
    const Meeting *m = given;
    Roots roots = sphere_roots(m->ray, m->sphere);
    double hit = hit_sphere(m->ray, m->sphere);
    Section section = section_upright(m->ray, m->sphere);
    for (int i = 0; i < count_of(roots); i++)
        section_include(&section, roots.t[i]);
    section_include(&section, hit);
    section_end(&section);
    section_data(plot, &section);

    plot_point(plot, "object_p", to_object_coordinates(m->ray, m->sphere).origin);
    plot_number(plot, "moved", vec3_dot(m->sphere.center, m->sphere.center) > 0);
    coefficients(plot, "", quadratic_of(m));
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit, digits_of(roots));
    mark(plot, "hit0", m->ray, root_of(roots, 0));
    mark(plot, "hit1", m->ray, root_of(roots, 1));
    mark(plot, "used", m->ray, hit);
}

// ---- parabola ----------------------------------------------------------------------------------

// t and f(t), where f is between the bottom and the top of the picture.
static void parabola(Plot *plot, const char *name, Quadratic q, const double t[2],
                     const double f[2])
{
    bool any = false, inside = false;
    plot_block(plot, name, "t f");
    for (int i = 0; i <= SAMPLES; i++) {
        double x = t[0] + (t[1] - t[0]) * i / SAMPLES, y = value(q, x);
        bool was_inside = inside;
        inside = y >= f[0] && y <= f[1];
        if (was_inside && !inside)
            plot_gap(plot);
        if (inside)
            plot_row(plot, 2, (const double[]){x, y});
        any = any || inside;
    }
    if (!any)
        plot_row(plot, 2, (const double[]){NAN, NAN});
    plot_block_end(plot);
}

// The f that are shown: the axis, the lowest point, and above it a parabola as wide as the circle
// and half.
static void heights(const Section *s, double f[2])
{
    double r = s->sphere.radius, lowest = (s->away - r) * (s->away + r);
    f[0] = fmin(lowest, 0);
    f[1] = fmax(lowest + 1.5 * r * r, 2 * lowest);
}

static void parabola_data(Plot *plot, void *given)
{
    const Meeting *m = given;
    Quadratic q = quadratic_of(m);
    Roots roots = quadratic_roots(q);
    Section section = section_level(m->ray, m->sphere);
    for (int i = 0; i < count_of(roots); i++)
        section_include(&section, roots.t[i]);
    section_include(&section, -q.b / (2 * q.a)); // the lowest point, should it be elsewhere
    section_end(&section);
    section_data(plot, &section);

    double f[2];
    heights(&section, f);
    plot_number(plot, "f_low", f[0]);
    plot_number(plot, "f_high", f[1]);
    coefficients(plot, "", q);
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit_sphere(m->ray, m->sphere), digits_of(roots));
    plot_number_to(plot, "f_nearest", value(q, section.t), 4);
    mark(plot, "hit0", m->ray, root_of(roots, 0));
    mark(plot, "hit1", m->ray, root_of(roots, 1));
    parabola(plot, "parabola", q, (const double[]){section.low, section.high},
             (const double[]){f[0] - 0.1 * (f[1] - f[0]), f[1]});
}

// ---- discriminant ------------------------------------------------------------------------------

static const double half_panel = 1.75; // in radii, as in the layout

// Five rays along x against the same sphere, in object coordinates; the numbers of where they start
// are short in binary, so that the tangent is one, exactly.
static const struct {
    double x, y;   // of p, in radii
    double middle; // of the panel
} situations[SITUATIONS] = {
    {-2.25, 1.5, -0.6}, {-2.25, 1, -0.6}, {-2.25, 0.5, -0.6}, {-0.5, 0.5, 0.2}, {1.25, 0.5, 0.5}};

// The radius to 22 binary digits, so that its square, times small numbers, is exact.
static double rounded(double radius)
{
    int exponent;
    double fraction = frexp(radius, &exponent);
    return ldexp(round(ldexp(fraction, 22)), exponent - 22);
}

// v is as long as the radius or shorter, down to its half: a power of two.
static double speed_for(double radius)
{
    int exponent;
    frexp(radius, &exponent);
    return ldexp(1, exponent - 1);
}

static Meeting situation(int i, double radius)
{
    return (Meeting){{vec3_of(situations[i].x * radius, situations[i].y * radius, 0),
                      vec3_of(speed_for(radius), 0, 0)},
                     {.center = vec3_of(0, 0, 0), .radius = radius}};
}

typedef enum { USED, LATER, BEHIND } Kind;

// The roots of one kind, as places of their panels.
static void roots_of_kind(Plot *plot, const char *name, double radius, Kind kind)
{
    bool any = false;
    plot_block(plot, name, "panel x y t");
    for (int i = 0; i < SITUATIONS; i++) {
        Meeting m = situation(i, radius);
        Roots roots = quadratic_roots(quadratic_of(&m));
        double hit = hit_sphere(m.ray, m.sphere);
        for (int k = 0; k < (kind == USED ? 1 : count_of(roots)); k++) {
            double t = kind == USED ? hit : roots.t[k];
            if (!isfinite(t) || (kind == LATER && !(t > 0 && fabs(t - hit) > 1e-9 * radius)) ||
                (kind == BEHIND && t > 0))
                continue;
            vec3 point = m.ray.origin + t * m.ray.direction;
            if (fabs(point[0] - situations[i].middle * radius) > half_panel * radius)
                continue;
            plot_row(plot, 4, (const double[]){i + 1, point[0], point[1], t});
            any = true;
        }
    }
    if (!any)
        plot_row(plot, 4, (const double[]){NAN, NAN, NAN, NAN});
    plot_block_end(plot);
}

static void curve(Plot *plot, const char *name, double radius, bool ahead)
{
    plot_block(plot, name, "panel x f");
    for (int i = 0; i < SITUATIONS; i++) {
        Meeting m = situation(i, radius);
        Quadratic q = quadratic_of(&m);
        for (int k = 0; k <= SAMPLES; k++) {
            double x = (situations[i].middle + half_panel * (2.0 * k / SAMPLES - 1)) * radius;
            double t = (x - m.ray.origin[0]) / m.ray.direction[0], f = value(q, t);
            bool shown = f <= 2.4 * radius * radius && f >= -1.2 * radius * radius;
            // Both have the place next to t = 0, so that no gap is seen.
            if (shown && (ahead ? t >= 0 : t < 0.02))
                plot_row(plot, 3, (const double[]){i + 1, x, f});
        }
        // Where all of it is on the other side, or out of the picture.
        plot_row(plot, 3, (const double[]){i + 1, NAN, NAN});
        plot_gap(plot);
    }
    plot_block_end(plot);
}

static void discriminant_data(Plot *plot, void *given)
{
    const Meeting *m = given;
    double radius = rounded(m->sphere.radius);
    plot_number(plot, "r", radius);
    plot_number(plot, "v", speed_for(radius));
    plot_block(plot, "rays", "panel x y of p, x y of v, middle of the panel");
    for (int i = 0; i < SITUATIONS; i++) {
        Ray ray = situation(i, radius).ray;
        plot_row(plot, 6,
                 (const double[]){i + 1, ray.origin[0], ray.origin[1], ray.direction[0],
                                  ray.direction[1], situations[i].middle * radius});
    }
    plot_block_end(plot);
    plot_block(plot, "circle", "x y");
    for (int i = 0; i <= 120; i++)
        plot_row(plot, 2,
                 (const double[]){radius * cos(2 * PI * i / 120), radius * sin(2 * PI * i / 120)});
    plot_block_end(plot);
    curve(plot, "ahead", radius, true);
    curve(plot, "behind", radius, false);
    roots_of_kind(plot, "used", radius, USED);
    roots_of_kind(plot, "later", radius, LATER);
    roots_of_kind(plot, "back", radius, BEHIND);
    for (int i = 0; i < SITUATIONS; i++) {
        Meeting one = situation(i, radius);
        char prefix[20];
        snprintf(prefix, sizeof prefix, "panel%d_", i + 1);
        coefficients(plot, prefix, quadratic_of(&one));
        root_numbers(plot, prefix, quadratic_roots(quadratic_of(&one)));
        plot_number(plot, joined(prefix, "hit"), hit_sphere(one.ray, one.sphere));
        plot_number(plot, joined(prefix, "x"), one.ray.origin[0]);
        plot_number(plot, joined(prefix, "y"), one.ray.origin[1]);
        plot_number(plot, joined(prefix, "middle"), situations[i].middle * radius);
    }
}

// ---- world-object ------------------------------------------------------------------------------

static bool same_point(vec3 a, vec3 b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// The deck's sphere is round the origin, where both coordinates are the same; moved, they are two.
static Meeting moved(const Meeting *m)
{
    Meeting deck = meeting_of_the_deck(), moved = *m;
    vec3 by = vec3_of(3, 2, 0);
    if (same_point(m->sphere.center, deck.sphere.center) &&
        same_point(m->ray.origin, deck.ray.origin)) {
        moved.ray.origin += by;
        moved.sphere.center += by;
    }
    return moved;
}

// The world's axes on the paper, as far as they are not seen from their end; center is where that
// is seen in the world.
static void axes(Plot *plot, const char *name, const Section *s, vec3 center, double low,
                 double high)
{
    plot_block(plot, name, "x y z of an axis's low end, x y z from there to its high end, which");
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3_of(i == 0, i == 1, i == 2);
        if (hypot(vec3_dot(axis, s->right), vec3_dot(axis, s->up)) < 1e-6)
            continue;
        vec3 from = low * axis, way = (high - low) * axis;
        plot_row(plot, 7,
                 (const double[]){from[0], from[1], from[2], way[0], way[1], way[2], i + 1});
        plot_fit(plot, center + from, 0);
        plot_fit(plot, center + from + way, 0);
    }
    plot_block_end(plot);
}

// The world's origin and c from there; where that is far away, only c's end, and no axes.
static void world_axes(Plot *plot, const Section *s)
{
    vec3 c = s->sphere.center, zero = vec3_of(0, 0, 0);
    double away = vec3_length(c);
    bool near = away <= 8 * s->size;
    plot_number(plot, "near_origin", near);
    vec3 shown = near ? c : 3 * s->size / away * c;
    plot_vector(plot, "c", c - shown, shown);
    double length = near ? fmax(0.5 * away, 1.4 * s->size) : 0;
    axes(plot, "world_axes", s, near ? zero : c, -0.5 * s->size * near, length);
}

static void world_object(Plot *plot, void *given)
{
    Meeting m = moved(given);
    Section section = section_upright(m.ray, m.sphere);
    Quadratic world = world_quadratic(m.ray, m.sphere), object = quadratic_of(&m);
    Roots world_roots = quadratic_roots(world), object_roots = quadratic_roots(object);
    for (int i = 0; i < 2; i++) {
        section_include(&section, root_of(world_roots, i));
        section_include(&section, root_of(object_roots, i));
    }
    section_end(&section);
    section_data(plot, &section);
    Ray object_ray = to_object_coordinates(m.ray, m.sphere);
    coefficients(plot, "world_", world);
    coefficients(plot, "object_", object);
    root_numbers(plot, "world_", world_roots);
    root_numbers(plot, "object_", object_roots);
    mark(plot, "world_hit0", m.ray, root_of(world_roots, 0));
    mark(plot, "world_hit1", m.ray, root_of(world_roots, 1));
    mark(plot, "object_hit0", object_ray, root_of(object_roots, 0));
    mark(plot, "object_hit1", object_ray, root_of(object_roots, 1));
    plot_number(plot, "hit", hit_sphere(m.ray, m.sphere));
    plot_number(plot, "t0", root_of(object_roots, 0));
    plot_number(plot, "t1", root_of(object_roots, 1));
    plot_point(plot, "object_p", object_ray.origin);
    plot_vector(plot, "object_v", object_ray.origin + section.first * object_ray.direction,
                section.stride * object_ray.direction);
    world_axes(plot, &section);
    double length = 1.6 * fmax(m.sphere.radius, 0.2 * section.size);
    axes(plot, "object_axes", &section, m.sphere.center, -length, length);
}

static const Figure figures[] = {{"ray-sphere", ray_sphere},
                                 {"parabola", parabola_data},
                                 {"discriminant", discriminant_data},
                                 {"world-object", world_object},
                                 {0}};

Meeting meeting_of_the_deck(void)
{
    return (Meeting){{vec3_of(-4, -1, 0), vec3_of(0.89, 0.45, 0)},
                     {.center = vec3_of(0, 0, 0), .radius = 1}};
}

int quadratic_figure(const char *program, FigureCommand command, const Meeting *meeting)
{
    Meeting copy = *meeting;
    return plot_figure(program, "chapters/05-quadratic", figures, command, &copy);
}
