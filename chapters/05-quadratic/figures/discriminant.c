// discriminant.c - five rays and a sphere: the discriminant and the signs of the roots.
#include "chapters/05-quadratic/figures/discriminant.h"

#include "chapters/05-quadratic/numbers.h"

#include <stdio.h>

enum { SAMPLES = 400, SITUATIONS = 5 };

static const double half_panel = 1.75; // in radii, as in the layout

// Five rays along x against the same sphere, in object coordinates. The coordinates of their
// origins are short in binary, and so is the distance of the tangent's origin from the centre,
// 17/8. So every usual formula finds exactly a tangent.
static const struct {
    double x, y;   // of p, in radii
    double middle; // of the panel
} situations[SITUATIONS] = {{-1.875, 1.5, -0.6},
                            {-1.875, 1, -0.6},
                            {-1.875, 0.5, -0.6},
                            {-0.5, 0.5, 0.2},
                            {1.25, 0.5, 0.5}};

// The radius, rounded to 22 binary digits, so that its square times small numbers is exact.
static double rounded(double radius)
{
    int exponent;
    double fraction = frexp(radius, &exponent);
    return ldexp(round(ldexp(fraction, 22)), exponent - 22);
}

// The length of v is a power of two, from half the radius up to the radius.
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
        for (int k = 0; k < (kind == USED ? 1 : roots_shown(roots)); k++) {
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
        plot_row(plot, 4, (const double[]){1, NAN, NAN, NAN});
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
            double t = (x - m.ray.origin[0]) / m.ray.direction[0], f = quadratic_value(q, t);
            bool shown = f <= 2.4 * radius * radius && f >= -1.2 * radius * radius;
            // Both curves contain the place next to t = 0, so that there is no gap.
            if (shown && (ahead ? t >= 0 : t < 0.02))
                plot_row(plot, 3, (const double[]){i + 1, x, f});
        }
        // For a curve that is completely on the other side, or outside the picture.
        plot_row(plot, 3, (const double[]){i + 1, NAN, NAN});
        plot_gap(plot);
    }
    plot_block_end(plot);
}

void discriminant_figure(Plot *plot, void *given)
{
    plot_include(plot, "common/figure/section.gp");
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
        coefficient_numbers(plot, prefix, quadratic_of(&one), 4);
        root_numbers(plot, prefix, quadratic_roots(quadratic_of(&one)));
        plot_number(plot, joined(prefix, "hit"), hit_sphere(one.ray, one.sphere));
        plot_number(plot, joined(prefix, "x"), one.ray.origin[0]);
        plot_number(plot, joined(prefix, "y"), one.ray.origin[1]);
        plot_number(plot, joined(prefix, "middle"), situations[i].middle * radius);
    }
}
