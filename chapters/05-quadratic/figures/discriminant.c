// discriminant.c - five rays and a sphere: the discriminant and the signs of the roots. Also as one
// ray that moves from each of the five places to the next.
#include "chapters/05-quadratic/figures/figures.h"

#include "common/text.h"

#include <stdio.h>

enum {
    SITUATIONS = 5,
    STAY = 12,
    MOVE = 20,
    MOMENTS = SITUATIONS * STAY + (SITUATIONS - 1) * MOVE
};

typedef struct {
    double x, y;   // of p, in radii
    double middle; // of the panel
} Situation;

// What a figure shows: a panel for each situation.
typedef struct {
    const Situation *situations;
    int count;
    double radius;
    double half;  // of a panel's width, in radii, as in the layout
    double above; // how much of f, in squares of the radius
    int samples;  // of f
} Panels;

// Five rays along x against the same sphere, in object coordinates. The coordinates of their
// origins are short in binary, and so is the distance of the tangent's origin from the center,
// 17/8. So every usual formula finds exactly a tangent.
static const Situation five[SITUATIONS] = {{-1.875, 1.5, -0.6},
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

static Meeting situation(const Panels *panels, int i)
{
    double radius = panels->radius;
    const Situation *s = &panels->situations[i];
    return (Meeting){{vec3_of(s->x * radius, s->y * radius, 0), vec3_of(speed_for(radius), 0, 0)},
                     {.center = vec3_of(0, 0, 0), .radius = radius}};
}

typedef enum { USED, LATER, BEHIND } Kind;

// The roots of one kind, as places of their panels.
static void roots_of_kind(Plot *plot, const char *name, const Panels *panels, Kind kind)
{
    double radius = panels->radius;
    bool any = false;
    plot_block(plot, name, "panel x y t");
    for (int i = 0; i < panels->count; i++) {
        Meeting m = situation(panels, i);
        Roots roots = quadratic_roots(quadratic_of(&m));
        double hit = hit_sphere(m.ray, m.sphere);
        for (int k = 0; k < (kind == USED ? 1 : roots_shown(roots)); k++) {
            double t = kind == USED ? hit : roots.t[k];
            if (!isfinite(t) || (kind == LATER && !(t > 0 && fabs(t - hit) > 1e-9 * radius)) ||
                (kind == BEHIND && t > 0))
                continue;
            vec3 point = m.ray.origin + t * m.ray.direction;
            if (fabs(point[0] - panels->situations[i].middle * radius) > panels->half * radius)
                continue;
            plot_row(plot, i + 1, point[0], point[1], t);
            any = true;
        }
    }
    if (!any)
        plot_row(plot, 1, NAN, NAN, NAN);
}

static void curve(Plot *plot, const char *name, const Panels *panels, bool ahead)
{
    double radius = panels->radius, joined_at = plot_is_dragged(plot) ? 0.08 : 0.02;
    plot_block(plot, name, "panel x f");
    for (int i = 0; i < panels->count; i++) {
        Meeting m = situation(panels, i);
        Quadratic q = quadratic_of(&m);
        for (int k = 0; k <= panels->samples; k++) {
            double across = panels->half * (2.0 * k / panels->samples - 1);
            double x = (panels->situations[i].middle + across) * radius;
            double t = (x - m.ray.origin[0]) / m.ray.direction[0], f = quadratic_value(q, t);
            bool shown = f <= panels->above * radius * radius && f >= -1.2 * radius * radius;
            // Both curves contain the place next to t = 0, so that there is no gap.
            if (shown && (ahead ? t >= 0 : t < joined_at))
                plot_row(plot, i + 1, x, f);
        }
        // For a curve that is completely on the other side, or outside the picture.
        plot_row(plot, i + 1, NAN, NAN);
        plot_gap(plot);
    }
}

static void data(Plot *plot, const Panels *panels)
{
    double radius = panels->radius;
    plot_number(plot, "r", radius);
    plot_number(plot, "v", speed_for(radius));
    plot_block(plot, "rays", "panel x y of p, x y of v, middle of the panel");
    for (int i = 0; i < panels->count; i++) {
        Ray ray = situation(panels, i).ray;
        plot_row(plot, i + 1, ray.origin[0], ray.origin[1], ray.direction[0], ray.direction[1],
                 panels->situations[i].middle * radius);
    }
    int places = plot_is_dragged(plot) ? 40 : 120;
    plot_block(plot, "circle", "x y");
    for (int i = 0; i <= places; i++) {
        double angle = 2 * PI * i / places;
        plot_row(plot, radius * cos(angle), radius * sin(angle));
    }
    curve(plot, "ahead", panels, true);
    curve(plot, "behind", panels, false);
    roots_of_kind(plot, "used", panels, USED);
    roots_of_kind(plot, "later", panels, LATER);
    roots_of_kind(plot, "back", panels, BEHIND);
    for (int i = 0; i < panels->count; i++) {
        Meeting one = situation(panels, i);
        Text panel = text_of("panel%d_", i + 1);
        const char *prefix = panel.s;
        coefficient_numbers(plot, prefix, quadratic_of(&one));
        root_numbers(plot, prefix, quadratic_roots(quadratic_of(&one)));
        plot_number(plot, joined(prefix, "hit"), hit_sphere(one.ray, one.sphere));
        plot_number(plot, joined(prefix, "x"), one.ray.origin[0]);
        plot_number(plot, joined(prefix, "y"), one.ray.origin[1]);
        plot_number(plot, joined(prefix, "middle"), panels->situations[i].middle * radius);
    }
}

// Five columns, to the right of the names of their rows.
static void columns(Plot *plot, const Panels *panels)
{
    const double bottom = 0.2, top = 0.44, margin = 0.01;
    plot_look_flat(plot);
    plot_fill_room(plot);
    for (int i = 0; i < panels->count; i++) {
        const double wide = 0.14 + 0.17 * i, narrow = 0.17 + 0.165 * i;
        const double middle = panels->situations[i].middle;
        plot_panel(plot, i + 1);
        plot_room(plot, (Room){wide + margin, wide + 0.17 - margin, bottom, top},
                  (Room){narrow + margin, narrow + 0.165 - margin, bottom, top});
        plot_fit(plot, panels->radius * vec3_of(middle - panels->half, -1.1, 0), 0);
        plot_fit(plot, panels->radius * vec3_of(middle + panels->half, 1.6, 0), 0);
    }
}

// On the sphere of the middle panel, where no ray is.
static void radius_handle(Plot *plot, const Panels *panels, double radius)
{
    const vec3 rim = vec3_of(sqrt(0.5), -sqrt(0.5), 0);
    plot_panel(plot, 3);
    plot_handle_length(plot, "r, the radius of the sphere", "radius", radius, panels->radius * rim,
                       rim);
}

void discriminant_figure(Plot *plot, void *given)
{
    enum { SAMPLES = 400, FEW_SAMPLES = 100 };
    const Meeting *m = given;
    int samples = plot_is_dragged(plot) ? FEW_SAMPLES : SAMPLES;
    Panels panels = {five, SITUATIONS, rounded(m->sphere.radius), 1.75, 2.4, samples};
    columns(plot, &panels);
    data(plot, &panels);
    radius_handle(plot, &panels, m->sphere.radius);
}

// ---- as one ray that moves --------------------------------------------------------------------

// From 0 to 1, slowly at both ends.
static double eased(double part)
{
    return part * part * (3 - 2 * part);
}

void discriminant_moments(Plot *plot, void *given)
{
    const Meeting *m = given;
    Situation moments[MOMENTS];
    int count = 0;
    plot_block(plot, "stays", "the first and the last step of each of the five");
    for (int i = 0; i < SITUATIONS; i++) {
        plot_row(plot, count + 1, count + STAY);
        for (int k = 0; k < STAY; k++)
            moments[count++] = (Situation){five[i].x, five[i].y, 0};
        for (int k = 1; i + 1 < SITUATIONS && k <= MOVE; k++) {
            double part = eased(k / (MOVE + 1.0));
            moments[count++] = (Situation){five[i].x + part * (five[i + 1].x - five[i].x),
                                           five[i].y + part * (five[i + 1].y - five[i].y), 0};
        }
    }
    plot_number(plot, "moments", MOMENTS);
    data(plot, &(Panels){moments, MOMENTS, rounded(m->sphere.radius), 2.4, 2.1, 160});
}
