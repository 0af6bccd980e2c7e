// figures.c - the data of the figures of chapter 05.
#include "chapters/05-quadratic/figures/figures.h"

#include "chapters/05-quadratic/figures/discriminant.h"
#include "chapters/05-quadratic/figures/section.h"
#include "chapters/05-quadratic/numbers.h"
#include "common/example.h"

enum { DIGITS = 6, SAMPLES = 400 };

// ---- ray-sphere --------------------------------------------------------------------------------

static void ray_sphere(Plot *plot, void *given)
{
    plot_include(plot, "common/figure/section.gp");
    const Meeting *m = given;
    Roots roots = sphere_roots(m->ray, m->sphere);
    double hit = hit_sphere(m->ray, m->sphere);
    Section section = section_upright(m->ray, m->sphere);
    for (int i = 0; i < roots_shown(roots); i++)
        section_include(&section, roots.t[i]);
    section_include(&section, hit);
    section_end(&section);
    section_data(plot, &section);

    plot_point(plot, "object_p", to_object_coordinates(m->ray, m->sphere).origin);
    plot_number(plot, "moved", vec3_dot(m->sphere.center, m->sphere.center) > 0);
    coefficient_numbers(plot, "", quadratic_of(m), DIGITS);
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit, root_digits(roots));
    root_mark(plot, "hit0", m->ray, root_shown(roots, 0));
    root_mark(plot, "hit1", m->ray, root_shown(roots, 1));
    root_mark(plot, "used", m->ray, hit);
}

// ---- parabola ----------------------------------------------------------------------------------

// t and f(t), for each f between the bottom and the top of the picture.
static void parabola(Plot *plot, const char *name, Quadratic q, const double t[2],
                     const double f[2])
{
    bool any = false, inside = false;
    plot_block(plot, name, "t f");
    for (int i = 0; i <= SAMPLES; i++) {
        double x = t[0] + (t[1] - t[0]) * i / SAMPLES, y = quadratic_value(q, x);
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

// The range of f that is shown: the axis, the lowest point, and above it so much that the parabola
// is one and a half times as wide as the circle.
static void heights(const Section *s, double f[2])
{
    double r = s->sphere.radius, lowest = (s->away - r) * (s->away + r);
    f[0] = fmin(lowest, 0);
    f[1] = fmax(lowest + 1.5 * r * r, 2 * lowest);
}

static void parabola_data(Plot *plot, void *given)
{
    plot_include(plot, "common/figure/section.gp");
    const Meeting *m = given;
    Quadratic q = quadratic_of(m);
    Roots roots = quadratic_roots(q);
    Section section = section_level(m->ray, m->sphere);
    for (int i = 0; i < roots_shown(roots); i++)
        section_include(&section, roots.t[i]);
    section_include(&section, -q.b / (2 * q.a)); // the lowest point, if it is elsewhere
    section_end(&section);
    section_data(plot, &section);

    double f[2];
    heights(&section, f);
    plot_number(plot, "f_low", f[0]);
    plot_number(plot, "f_high", f[1]);
    coefficient_numbers(plot, "", q, DIGITS);
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit_sphere(m->ray, m->sphere), root_digits(roots));
    plot_number_to(plot, "f_nearest", quadratic_value(q, section.t), 4);
    root_mark(plot, "hit0", m->ray, root_shown(roots, 0));
    root_mark(plot, "hit1", m->ray, root_shown(roots, 1));
    parabola(plot, "parabola", q, (const double[]){section.low, section.high},
             (const double[]){f[0] - 0.1 * (f[1] - f[0]), f[1]});
}

// ---- world-object ------------------------------------------------------------------------------

static bool same_point(vec3 a, vec3 b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// If the lecture's sphere is around the origin, both coordinates are the same. Moved, they differ.
static Meeting moved(const Meeting *m)
{
    Meeting moved = *m;
    vec3 by = m->sphere.radius * vec3_of(3, 2, 0);
    if (same_point(m->sphere.center, vec3_of(0, 0, 0)) &&
        same_point(example_sphere().center, m->sphere.center) &&
        same_point(example_ray().origin, m->ray.origin)) {
        moved.ray.origin += by;
        moved.sphere.center += by;
    }
    return moved;
}

// The world's axes on the paper, except those that are seen from their end. center is the place of
// their origin in the world.
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

// The world's origin and c from there. If the origin is far away: only the end of c, and no axes.
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
    plot_include(plot, "common/figure/section.gp");
    Meeting m = moved(given);
    Section section = section_upright(m.ray, m.sphere);
    Quadratic world = world_quadratic(m.ray, m.sphere), object = quadratic_of(&m);
    Roots world_roots = quadratic_roots(world), object_roots = quadratic_roots(object);
    for (int i = 0; i < 2; i++) {
        section_include(&section, root_shown(world_roots, i));
        section_include(&section, root_shown(object_roots, i));
    }
    section_end(&section);
    section_data(plot, &section);
    Ray object_ray = to_object_coordinates(m.ray, m.sphere);
    coefficient_numbers(plot, "world_", world, DIGITS);
    coefficient_numbers(plot, "object_", object, DIGITS);
    root_numbers(plot, "world_", world_roots);
    root_numbers(plot, "object_", object_roots);
    root_mark(plot, "world_hit0", m.ray, root_shown(world_roots, 0));
    root_mark(plot, "world_hit1", m.ray, root_shown(world_roots, 1));
    root_mark(plot, "object_hit0", object_ray, root_shown(object_roots, 0));
    root_mark(plot, "object_hit1", object_ray, root_shown(object_roots, 1));
    plot_number(plot, "hit", hit_sphere(m.ray, m.sphere));
    plot_number(plot, "t0", root_shown(object_roots, 0));
    plot_number(plot, "t1", root_shown(object_roots, 1));
    plot_point(plot, "object_p", object_ray.origin);
    plot_vector(plot, "object_v", object_ray.origin + section.first * object_ray.direction,
                section.stride * object_ray.direction);
    world_axes(plot, &section);
    double length = 1.6 * fmax(m.sphere.radius, 0.2 * section.size);
    axes(plot, "object_axes", &section, m.sphere.center, -length, length);
}

static const Figure figures[] = {{"ray-sphere", ray_sphere},
                                 {"parabola", parabola_data},
                                 {"discriminant", discriminant_figure},
                                 {"world-object", world_object},
                                 {0}};

int quadratic_figure(const char *program, FigureCommand command, const Meeting *meeting)
{
    Meeting copy = *meeting;
    return plot_figure(program, "chapters/05-quadratic", figures, command, &copy);
}
