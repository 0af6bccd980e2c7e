// figures.c - the data of the figures of chapter 05.
#include "chapters/05-quadratic/figures/figures.h"

#include "chapters/shared/digits.h"
#include "chapters/shared/example.h"

#include <stdio.h>
#include <string.h>

enum { SAMPLES = 400 };

// ---- the plane through a ray and the center of a sphere -----------------------------------------

// Everything that matters happens in that plane, for any ray and sphere: a line and a circle, in
// true lengths. The data are points of the world; two directions in the plane are those of the
// paper.
typedef struct {
    Ray ray;
    Sphere sphere;
    vec3 line;    // unit, along the ray
    vec3 off;     // unit, at right angles to it, from the center to the line
    vec3 nearest; // the point of the line that is nearest to the center
    double t;     // its t
    double away;  // how far it is from the center
    double size;  // of the part that must be visible: the larger of radius and away
    vec3 right, up;

    // The part of the line that is shown.
    double low, high; // from which t to which
    bool near;        // is p shown, or is it too far away?
    double stride;    // from mark to mark: 1, unless that is too small or too large
    double first;     // the t at which the arrow of v starts: at p, if p is shown
    vec3 axis;        // from the line to the axis of t: 0, unless a figure has one of its own
    bool small_ball;  // is the sphere too small for an arrow in it?
} Section;

enum {
    CIRCLE = 180, // corners: within 0.0002 of the radius
    TICKS = 8,    // on the line, at most
    FAR_TICKS = 4
};

// The largest distance of p, in sizes, at which it is still shown: across the paper, and up.
static const double reach[2] = {20, 11};

// ---- where things are --------------------------------------------------------------------------

// Any direction at right angles to the line. It is in the plane of x and y if possible, because the
// deck's drawing is.
static vec3 any_off(vec3 line)
{
    return fabs(line[1]) < 0.9 ? vec3_of(0, 1, 0) : vec3_of(1, 0, 0);
}

static vec3 perpendicular(vec3 v, vec3 line)
{
    return vec3_unit(v - vec3_dot(v, line) * line);
}

static Section meeting(Ray ray, Sphere sphere)
{
    Section s = {.ray = ray, .sphere = sphere, .line = vec3_unit(ray.direction)};
    double along = vec3_dot(sphere.center - ray.origin, s.line);
    s.t = along / vec3_length(ray.direction);
    s.nearest = ray.origin + along * s.line;
    vec3 apart = s.nearest - sphere.center;
    s.away = vec3_length(apart);
    s.size = fmax(s.away, sphere.radius);
    s.off = perpendicular(s.away > 1e-6 * s.size ? apart : any_off(s.line), s.line);
    return s;
}

// p is shown unless it is far away; then the line begins or ends outside the picture.
static Section in_sight(Section s)
{
    double to_p = -s.t * vec3_length(s.ray.direction);
    s.near = fabs(to_p * vec3_dot(s.line, s.right)) <= reach[0] * s.size &&
             fabs(to_p * vec3_dot(s.line, s.up)) <= reach[1] * s.size;
    double low = -1.3 * s.size, high = 1.6 * s.size;
    if (s.near) {
        low = fmin(low, to_p);
        high = fmax(high, to_p + 1.5 * s.size);
    } else {
        low = to_p < 0 ? -3 * s.size : low;
        high = to_p < 0 ? high : 3 * s.size;
    }
    s.low = s.t + low / vec3_length(s.ray.direction);
    s.high = s.t + high / vec3_length(s.ray.direction);
    return s;
}

// The world's up is up on the paper, as far as possible, seen from the side of positive z.
static Section section_upright(Ray ray, Sphere sphere)
{
    Section s = meeting(ray, sphere);
    vec3 out = vec3_cross(s.line, s.off); // of the paper
    double side = fabs(out[2]) > 1e-9 ? out[2] : fabs(out[1]) > 1e-9 ? out[1] : out[0];
    if (side < 0)
        out = -out;
    s.up = perpendicular(fabs(out[1]) < 0.999999 ? vec3_of(0, 1, 0) : vec3_of(0, 0, -1), out);
    s.right = vec3_cross(s.up, out);
    return in_sight(s);
}

// Turned so that the ray goes to the right, above the center.
static Section section_level(Ray ray, Sphere sphere)
{
    Section s = meeting(ray, sphere);
    s.right = s.line;
    s.up = s.off;
    return in_sight(s);
}

// Makes room for a t, unless it is too far away or NaN.
static void section_include(Section *s, double t)
{
    double margin = 0.5 * s->size / vec3_length(s->ray.direction);
    if (fabs(t - s->t) * vec3_length(s->ray.direction) > reach[1] * s->size || !isfinite(t))
        return;
    s->low = fmin(s->low, t - margin);
    s->high = fmax(s->high, t + margin);
}

// 1, or if that is too small or too large, 1, 2 or 5 times a power of ten.
static double stride(const Section *s)
{
    double most = (s->high - s->low) / (s->near ? 1.5 : 2.5);
    double least = (s->high - s->low) / (s->near ? TICKS : FAR_TICKS);
    if (least <= 1 && 1 <= most)
        return 1;
    double ten = pow(10, floor(log10(least)));
    return (least <= 2 * ten ? 2 : least <= 5 * ten ? 5 : 10) * ten;
}

// Chooses the marks, after everything that must be visible is included: at last, roots.
static void section_end(Section *s, Roots roots)
{
    section_include(s, root_shown(roots, 0));
    section_include(s, root_shown(roots, 1));
    s->stride = stride(s);
    if (s->near) // the tip of v must also be visible
        s->high = fmax(s->high, 1.1 * s->stride);
    s->first = s->near ? 0 : s->t > 0 ? s->low : s->high - s->stride;
    s->small_ball = s->sphere.radius < 0.05 * (s->high - s->low) * vec3_length(s->ray.direction);
}

// A point of the line.
static vec3 section_point(const Section *section, double t)
{
    return section->ray.origin + t * section->ray.direction;
}

// ---- what is drawn -----------------------------------------------------------------------------

static void circle(Plot *plot, const Section *s)
{
    plot_undrawn(plot); // for labels, a circle of fewer corners does
    plot_block(plot, "circle", "x y z, round the sphere in the plane of the ray and the center");
    for (int i = 0; i <= CIRCLE; i++) {
        double angle = 2 * PI * i / CIRCLE;
        plot_row_point(plot, s->sphere.center +
                                 s->sphere.radius * (cos(angle) * s->right + sin(angle) * s->up));
    }
    plot_circle(plot, s->sphere.center, s->sphere.radius);
}

static void stretch(Plot *plot, const Section *s, const char *name, double from, double to)
{
    plot_block(plot, name, "x y z of the two ends");
    plot_row_point(plot, section_point(s, from));
    plot_row_point(plot, section_point(s, to));
}

// The marks of t are multiples of the stride: so many, and each of them.
static double first_tick(const Section *s)
{
    return ceil((s->low - 0.002 * (s->high - s->low)) / s->stride);
}

static int ticks_shown(const Section *s)
{
    double last = (s->high - 0.02 * (s->high - s->low)) / s->stride;
    return (int)fmin(TICKS + 1, floor(last - first_tick(s)) + 1);
}

static double tick(const Section *s, int i)
{
    return (first_tick(s) + i) * s->stride;
}

static void ticks(Plot *plot, const Section *s)
{
    plot_block(plot, "ticks", "x y z t");
    // So far away that neighbouring whole numbers are the same double: the block must not be empty.
    int count = ticks_shown(s);
    for (int i = 0; i < (count > 0 ? count : 1); i++) {
        double t = count > 0 ? tick(s, i) : s->t;
        plot_row_dot(plot, section_point(s, t) + s->axis, t);
    }
}

static void see(Plot *plot, const Section *s)
{
    plot_look(plot, s->right, s->up, vec3_cross(s->right, s->up), 90, 0);
    plot_direction(plot, "right", s->right);
    plot_direction(plot, "up", s->up);
    plot_direction(plot, "forward", vec3_cross(s->right, s->up));
    plot_direction(plot, "off", s->off);
    plot_fit(plot, s->sphere.center, s->sphere.radius);
    plot_fit(plot, section_point(s, s->low), 0);
    plot_fit(plot, section_point(s, s->high), 0);
}

// Says from where the section is seen, and writes $center, $circle, $radius, $p (if p is too far
// away, the end of the line towards it), $v, $ahead and $behind (of p), $nearest, $apart (from the
// center to $nearest).
static void section_data(Plot *plot, const Section *s)
{
    see(plot, s);
    plot_number(plot, "r", s->sphere.radius);
    plot_number(plot, "near_p", s->near);
    plot_direction(plot, "velocity", s->ray.direction);
    plot_number(plot, "stride", s->stride);
    plot_number(plot, "t_nearest", s->t);
    plot_number(plot, "away", s->away);
    plot_point(plot, "center", s->sphere.center);
    circle(plot, s);
    plot_number(plot, "small_ball", s->small_ball);
    if (s->small_ball)
        plot_undrawn(plot);
    plot_vector(plot, "radius", s->sphere.center, s->sphere.radius * (s->line - s->off) / sqrt(2));
    double begin = s->near ? 0 : s->t > 0 ? s->low : s->high;
    plot_point(plot, "origin", s->ray.origin);
    plot_point(plot, "p", section_point(s, begin));
    plot_vector(plot, "v", section_point(s, s->first), s->stride * s->ray.direction);
    stretch(plot, s, "ahead", fmin(fmax(s->low, 0), s->high), s->high);
    stretch(plot, s, "tail", s->low + 0.78 * (s->high - s->low), s->high); // the place of its name
    stretch(plot, s, "behind", s->low, fmax(fmin(s->high, 0), s->low));
    plot_undrawn(plot); // if there are roots
    plot_point(plot, "nearest", s->nearest);
    plot_undrawn(plot);
    plot_vector(plot, "apart", s->sphere.center, s->nearest - s->sphere.center);
}

// ---- what it is called -------------------------------------------------------------------------

// The names of p, v, the line and the sphere: those of the sphere from a step on.
static void section_names(Plot *plot, const Section *s, int sphere_step)
{
    bool ends = s->near || s->t > 0; // does the line go on beyond the right edge?
    plot_names(plot, {s->near ? "$p$" : "to $p$", "blue", .block = "p"},
               {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .block = "v", .part = ANYWHERE},
               {"$C$", "ink", .step = sphere_step, .block = "center"},
               {s->small_ball ? "$r$ = {r}" : "$r$", "ink", .step = sphere_step,
                .block = s->small_ball ? "center" : "radius", .part = s->small_ball ? 0 : ANYWHERE},
               {ends ? "$p + t v$" : "", "blue", .block = "tail", .row = 1, .part = ANYWHERE});
}

// Writes $ticks, the marks of t, and their numbers from a step on, except those that are too near
// to one of these.
static void section_marks(Plot *plot, const Section *s, int step, int count, const double *taken)
{
    ticks(plot, s);
    for (int i = 0; i < ticks_shown(s); i++) {
        bool is_clear = true;
        for (int k = 0; k < count; k++)
            is_clear = is_clear && !(fabs(tick(s, i) - taken[k]) < 0.2 * s->stride);
        if (is_clear)
            plot_name(plot,
                      (Label){tick(s, i) == 0 ? "$t$ = 0" : number_shown_to(tick(s, i), 10).s,
                              "grey", .step = step, .block = "ticks", .row = i, .aside = s->off});
    }
}

// Handles: p, v, the center and the radius. turns: the figure turns with the ray, so p can only be
// dragged along it.
static void section_handles(Plot *plot, const Section *s, bool turns)
{
    const vec3 none = {0}, v = s->ray.direction;
    if (s->near)
        plot_handle_point(plot, "p, the origin of the ray", "origin", s->ray.origin,
                          turns ? s->line : s->right, turns ? none : s->up);
    if (s->near && s->stride == 1 && !turns)
        plot_handle_vector(plot, "v, the direction of the ray", "direction", s->ray.origin, v,
                           s->right, s->up);
    plot_handle_point(plot, "C, the center of the sphere", "center", s->sphere.center, s->right,
                      s->up);
    vec3 rim = (s->line - s->off) / sqrt(2);
    plot_handle_length(plot, "r, the radius of the sphere", "radius", s->sphere.radius,
                       s->sphere.center + s->sphere.radius * rim, rim);
}

// The roots, their places $hit0 and $hit1, and the hit.
static void roots_data(Plot *plot, const Meeting *m, Roots roots)
{
    root_numbers(plot, "", roots);
    root_mark(plot, "hit0", m->ray, root_shown(roots, 0));
    root_mark(plot, "hit1", m->ray, root_shown(roots, 1));
    plot_number_to(plot, "hit", hit_sphere(m->ray, m->sphere), root_digits(roots));
}

// ---- ray-sphere --------------------------------------------------------------------------------

// The hit in words.
static void verdict(Plot *plot, Roots roots, double hit, double away)
{
    Text words = {"no root > 0: no hit"};
    if (hit > 0 && hit < NO_HIT)
        words = text_of("%s is the hit", number_shown_to(hit, root_digits(roots)).s);
    else if (roots_shown(roots) == 0)
        words = text_of("no root: C is %s away", number_shown(away).s);
    plot_label(plot, "verdict", words.s);
}

// The color of a root: the result is blue, another one ahead of p is ink.
static const char *root_color(const Plot *plot, const char *name)
{
    double t = plot_shown(plot, name);
    return t == plot_shown(plot, "hit") ? "blue" : t > 0 ? "ink" : "grey";
}

static void ray_sphere_labels(Plot *plot, const Section *s)
{
    double taken[] = {plot_shown(plot, "t0"), plot_shown(plot, "t1"), NAN};
    bool misses = plot_shown(plot, "roots") == 0, touches = taken[0] == taken[1];
    if (misses) {
        taken[2] = s->t;
        plot_line(plot, s->sphere.center, s->nearest, 0, 0);
        plot_line(plot, s->nearest, s->nearest, 0, 0);
        plot_name(plot, (Label){"$t$ = {t_nearest}", "grey", .step = 4, .place = s->nearest});
    }
    section_names(plot, s, 2);
    plot_names(plot,
               {touches ? "$t_0 = t_1$ = {t0}" : "$t_0$ = {t0}", root_color(plot, "t0"), .step = 4,
                .block = "hit0"},
               {touches ? "" : "$t_1$ = {t1}", root_color(plot, "t1"), .step = 4, .block = "hit1"});
    section_marks(plot, s, 1, 3, taken);
    plot_say(plot, 0, 1, {"$|p + t v|² = r²$", "ink", .step = 3},
             {"$a = v·v =$ {a!}", "ink", .step = 3}, {"$b = 2 p·v =$ {b!}", "ink", .step = 3},
             {"$c = p·p − r² =$ {c!}", "ink", .step = 3}, {"$b² − 4 a c =$ {D!}", "ink", .step = 3},
             {plot_shown(plot, "hit") > 0 ? "$t$ = {verdict!}" : "{verdict!}", "blue", .step = 5});
    if (plot_shown(plot, "moved") != 0)
        plot_say(plot, 0, 0, {"Here $p$ is $p − C$ =", "grey", .step = 3},
                 {"{object_p!}", "grey", .step = 3});
}

static void ray_sphere(Plot *plot, void *given)
{
    const Meeting *m = given;
    Roots roots = sphere_roots(m->ray, m->sphere);
    double hit = hit_sphere(m->ray, m->sphere);
    Section section = section_upright(m->ray, m->sphere);
    section_include(&section, hit);
    section_end(&section, roots);
    section_data(plot, &section);

    plot_point(plot, "object_p", to_object_coordinates(m->ray, m->sphere).origin);
    plot_number(plot, "moved", vec3_length(m->sphere.center) > 0);
    coefficient_numbers(plot, "", quadratic_of(m));
    roots_data(plot, m, roots);
    root_mark(plot, "used", m->ray, hit);
    verdict(plot, roots, hit, section.away);
    ray_sphere_labels(plot, &section);
    section_handles(plot, &section, false);
}

// ---- parabola ----------------------------------------------------------------------------------

// Where the parabola is drawn: above the section, in its plane. f is at height 'axis' + scale f
// above the line through the center, and f is shown from low to high: the axis, the lowest point,
// and above it so much that the parabola is one and a half times as wide as the circle.
typedef struct {
    const Section *section;
    double low, high, axis, scale;
} Graph;

static Graph graph_of(const Section *s)
{
    double r = s->sphere.radius, lowest = (s->away - r) * (s->away + r);
    double low = fmin(lowest, 0), high = fmax(lowest + 1.5 * r * r, 2 * lowest);
    double wide = (s->high - s->low) * vec3_length(s->ray.direction), below = r + fmax(r, s->away);
    double all = fmax(2.1 * below, 0.42 * wide), gap = 0.2 * all;
    double scale = (all - below - gap) / (high - low);
    return (Graph){s, low, high, fmax(r, s->away) + gap - scale * low, scale};
}

static vec3 graph_point(const Graph *g, double t, double f)
{
    const Section *s = g->section;
    return section_point(s, t) + (g->axis + g->scale * f - s->away) * s->off;
}

// t and f(t), for each f that is shown.
static void parabola(Plot *plot, const Graph *g, Quadratic q)
{
    const Section *s = g->section;
    bool any = false, inside = false;
    plot_block(plot, "parabola", "t f");
    for (int i = 0; i <= SAMPLES; i++) {
        double x = s->low + (s->high - s->low) * i / SAMPLES, y = quadratic_value(q, x);
        bool was_inside = inside;
        inside = y >= g->low - 0.1 * (g->high - g->low) && y <= g->high;
        if (was_inside && !inside)
            plot_gap(plot);
        if (inside)
            plot_row(plot, x, y);
        any = any || inside;
    }
    if (!any)
        plot_row(plot, NAN, NAN);
}

// The same for labels, by the numbers that are shown, and what else is drawn above the section.
static void drawn_above(Plot *plot, const Graph *g)
{
    enum { PIECES = 48 };
    const Section *s = g->section;
    Quadratic q = {plot_shown(plot, "a"), plot_shown(plot, "b"), plot_shown(plot, "c")};
    double half = sqrt((g->high - plot_shown(plot, "f_nearest")) / q.a), middle = s->t;
    for (int i = 0; i < PIECES; i++) {
        double from = middle + half * (2.0 * i / PIECES - 1), to = from + 2 * half / PIECES;
        plot_line(plot, graph_point(g, from, quadratic_value(q, from)),
                  graph_point(g, to, quadratic_value(q, to)), 0, 0);
    }
    plot_fit(plot, graph_point(g, middle - half, g->high), 0);
    plot_fit(plot, graph_point(g, middle + half, g->high), 0);
    double wide = s->high - s->low, end = s->high + 0.04 * wide;
    plot_vector(plot, "axis", graph_point(g, s->low, 0),
                graph_point(g, end, 0) - graph_point(g, s->low, 0));
    plot_fit(plot, graph_point(g, end, 0), 0);
    const double ts[] = {plot_shown(plot, "t0"), plot_shown(plot, "t1")};
    for (int i = 0; i < 2; i++) {
        plot_line(plot, section_point(s, ts[i]), graph_point(g, ts[i], 0), 0, 0);
        plot_line(plot, graph_point(g, ts[i], 0), graph_point(g, ts[i], 0), 0, 0);
    }
    if (plot_shown(plot, "roots") == 0)
        plot_line(plot, s->nearest, graph_point(g, s->t, plot_shown(plot, "f_nearest")), 0, 0);
}

static Text signed_term(double x, int digits)
{
    Text number = number_shown_to(fabs(x), digits);
    return x == 0 ? (Text){""} : text_of(" %s %s", x < 0 ? "\u2212" : "+", number.s);
}

// a t² + b t + c; 1 and 0 are not written. mark: around what is mathematics in a label, "$" or "".
static Text polynomial(Quadratic q, const char *mark)
{
    int digits = coefficient_digits(q);
    Text first = q.a == 1 ? (Text){""} : text_of("%s ", number_shown_to(q.a, digits).s);
    Text second =
        q.b == 0 ? (Text){""} : text_of("%s %st%s", signed_term(q.b, digits).s, mark, mark);
    return text_of("%s%st²%s%s%s", first.s, mark, mark, second.s, signed_term(q.c, digits).s);
}

static void parabola_labels(Plot *plot, const Graph *g)
{
    const Section *s = g->section;
    double c = plot_shown(plot, "c");
    const double taken[] = {plot_shown(plot, "t0"), plot_shown(plot, "t1"),
                            plot_shown(plot, "roots") == 0 ? s->t : NAN};
    bool above = s->near && c <= g->high, touches = taken[0] == taken[1];
    plot_number(plot, "above", above);
    if (above)
        plot_line(plot, graph_point(g, 0, c), graph_point(g, 0, c), 0, 0);
    section_names(plot, s, 1);
    plot_names(plot, {"$t$", "grey", .step = 2, .block = "axis", .part = 1},
               {touches ? "$t_0 = t_1$ = {t0}" : "$t_0$ = {t0}", root_color(plot, "t0"), .step = 3,
                .place = graph_point(g, taken[0], 0)},
               {touches ? "" : "$t_1$ = {t1}", root_color(plot, "t1"), .step = 3,
                .place = graph_point(g, taken[1], 0)});
    section_marks(plot, s, 2, 3, taken);
    Label words[6] = {{"$f (t) = |p + t v|² − r²$", "ink", .step = 2},
                      {"$=$ {formula}", "ink", .step = 2},
                      {above     ? "$f (0) = c =$ {c}"
                       : s->near ? "$f (0) = c =$ {c} is higher up"
                                 : "$f (0) = c =$ {c}, $t$ = 0 is far away",
                       "grey", .step = 2}};
    int count = 3;
    if (plot_shown(plot, "roots") == 0)
        words[count++] = (Label){"no root: $f$ is never below {f_nearest}", "grey", .step = 3};
    if (plot_says_yours(plot, "formula"))
        words[count++] = (Label){"yours = {your_formula}", "ink", .step = 2};
    plot_say_of(plot, 0, 1, count, words);
}

static void parabola_data(Plot *plot, void *given)
{
    const Meeting *m = given;
    Quadratic q = quadratic_of(m);
    Roots roots = quadratic_roots(q);
    Section section = section_level(m->ray, m->sphere);
    section_include(&section, -q.b / (2 * q.a)); // the lowest point, if it is elsewhere
    section_end(&section, roots);
    Graph graph = graph_of(&section);
    section.axis = (graph.axis - section.away) * section.off;
    section_data(plot, &section);

    plot_number(plot, "f_high", graph.high);
    plot_number(plot, "f_axis", vec3_dot(graph_point(&graph, 0, 0), section.off));
    plot_number(plot, "f_scale", graph.scale);
    plot_number(plot, "t_zero", vec3_dot(m->ray.origin, section.line));
    plot_number(plot, "speed", vec3_length(m->ray.direction));
    coefficient_numbers(plot, "", q);
    plot_label(plot, "formula", polynomial(q, "$").s);
    plot_label(plot, "polynomial", polynomial(q, "").s);
    roots_data(plot, m, roots);
    plot_number(plot, "f_nearest", quadratic_value(q, section.t));
    parabola(plot, &graph, q);
    drawn_above(plot, &graph);
    parabola_labels(plot, &graph);
    section_handles(plot, &section, true);
}

// ---- geometric-roots ---------------------------------------------------------------------------

// The sides of two right triangles: from p to the nearest point of the line, s; from there to the
// center, m; and half a chord, k, of which nothing is left if the line misses the sphere.
typedef struct {
    double s, m, k;
} Sides;

static Sides sides_of(const Section *section)
{
    double r = section->sphere.radius, m = section->away;
    return (Sides){section->t * vec3_length(section->ray.direction), m,
                   m <= r ? sqrt((r - m) * (r + m)) : NAN};
}

// The mark of the right angle at the nearest point, towards p and the center.
static void right_angle(Plot *plot, const Section *s, Sides sides)
{
    double size = fmin(0.12 * s->size, 0.5 * fmin(sides.m, fabs(sides.s)));
    vec3 back = sides.s < 0 ? size * s->line : -size * s->line, in = -size * s->off;
    plot_block(plot, "corner", "x y z of the mark of the right angle");
    plot_row_point(plot, s->nearest + back);
    plot_row_point(plot, s->nearest + back + in);
    plot_row_point(plot, s->nearest + in);
}

static void sides_data(Plot *plot, const Section *s, Sides sides, bool misses)
{
    plot_number(plot, "s", sides.s);
    plot_number(plot, "m", sides.m);
    plot_number(plot, "k", sides.k);
    if (!s->near)
        plot_undrawn(plot);
    plot_vector(plot, "l", s->ray.origin, s->sphere.center - s->ray.origin);
    if (!s->near)
        plot_undrawn(plot);
    plot_vector(plot, "closest", s->ray.origin, sides.s * s->line);
    plot_vector(plot, "height", s->nearest, -sides.m * s->off);
    plot_line(plot, s->nearest, s->nearest, 0, 0);
    right_angle(plot, s, sides);
    plot_vector(plot, "half_chord", s->nearest, sides.k * s->line);
    plot_vector(plot, "spoke", s->sphere.center,
                misses ? -s->sphere.radius * s->off : sides.m * s->off + sides.k * s->line);
}

static void sides_labels(Plot *plot, const Section *s, Sides sides, bool misses)
{
    double small = 0.22 * s->size;
    bool touches = plot_shown(plot, "t0") == plot_shown(plot, "t1"), ends = s->near || s->t > 0;
    plot_names(
        plot, {s->near ? "$p$" : "to $p$", "blue", .block = "p"}, {"$C$", "ink", .block = "center"},
        {ends ? "$p + t v$" : "", "blue", .block = "tail", .row = 1, .part = ANYWHERE},
        {s->near && vec3_length(s->sphere.center - s->ray.origin) > small ? "$L$" : "", "ink",
         .step = 2, .block = "l", .part = ANYWHERE},
        {"$M$", "green", .step = 3, .place = s->nearest},
        {s->near && fabs(sides.s) > small ? "$s$" : "", "green", .step = 3, .block = "closest",
         .part = ANYWHERE},
        {sides.m > small ? "$m$" : "", "pink", .step = 4, .block = "height", .part = ANYWHERE},
        {sides.k > small ? "$k$" : "", "orange", .step = 5, .block = "half_chord",
         .part = ANYWHERE},
        {"$r$", "ink", .step = 5, .block = "spoke", .part = ANYWHERE},
        {touches ? "$t_0 = t_1$" : "$t_0$", root_color(plot, "t0"), .step = 5, .block = "hit0"},
        {touches ? "" : "$t_1$", root_color(plot, "t1"), .step = 5, .block = "hit1"});
    plot_say(plot, 0, 1, {"$L = C − p$ = {l}", "ink", .step = 2},
             {"$s = L·v / |v|$ = {s}", "green", .step = 3},
             {"$m = √(L·L − s²)$ = {m}", "pink", .step = 4},
             {misses ? "$m > r$ = {r}: no root" : "$k = √(r² − m²)$ = {k}", "orange", .step = 5},
             {misses ? "" : "$t_0 = (s − k) / |v|$ = {t0!}", "ink", .step = 5},
             {misses ? "" : "$t_1 = (s + k) / |v|$ = {t1!}", "ink", .step = 5});
}

static void geometric_roots(Plot *plot, void *given)
{
    const Meeting *m = given;
    Roots roots = sphere_roots(m->ray, m->sphere);
    Section section = section_level(m->ray, m->sphere);
    section_end(&section, roots);
    section_data(plot, &section);
    Sides sides = sides_of(&section);
    roots_data(plot, m, roots);
    bool misses = plot_shown(plot, "roots") == 0;
    sides_data(plot, &section, sides, misses);
    sides_labels(plot, &section, sides, misses);
    section_handles(plot, &section, true);
}

// ---- world-object ------------------------------------------------------------------------------

// If the lecture's sphere is around the origin, both coordinates are the same. Moved, they differ.
static Meeting moved(const Meeting *m)
{
    Meeting moved = *m;
    vec3 by = m->sphere.radius * vec3_of(3, 2, 0);
    if (vec3_length(m->sphere.center) == 0 && vec3_length(example_sphere().center) == 0 &&
        vec3_length(example_ray().origin - m->ray.origin) == 0) {
        moved.ray.origin += by;
        moved.sphere.center += by;
    }
    return moved;
}

// The axes on the paper with their names, except those that are seen from their end.
static void axes(Plot *plot, const char *name, const Section *s, double low, double high, int step)
{
    static const char *const names[] = {"$x$", "$y$", "$z$"};
    int count = 0;
    plot_block(plot, name, "x y z of an axis's low end, x y z from there to its high end");
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3_of(i == 0, i == 1, i == 2);
        if (hypot(vec3_dot(axis, s->right), vec3_dot(axis, s->up)) < 0.1)
            continue;
        plot_row_vector(plot, low * axis, (high - low) * axis);
        plot_fit(plot, low * axis, 0);
        plot_fit(plot, high * axis, 0);
        plot_name(plot, (Label){names[i], "grey", .step = step, .block = name, .row = count++,
                                .part = 1});
    }
}

// In the world: the axes, C from the origin, and beside it the way back. If the origin is far away:
// only the end of C, and no axes.
static void world_panel(Plot *plot, const Section *s)
{
    vec3 c = s->sphere.center;
    double away = vec3_length(c);
    bool near = away <= 8 * s->size;
    plot_number(plot, "near_origin", near);
    vec3 shown = near ? c : 3 * s->size / away * c;
    double length = near ? fmax(0.5 * away, 1.4 * s->size) : NAN;
    axes(plot, "world_axes", s, near ? -0.5 * s->size : NAN, length, 1);
    plot_seen_vector(plot, "c", c - shown, shown);
    double across = vec3_dot(c, s->right), upward = vec3_dot(c, s->up),
           flat = hypot(across, upward);
    vec3 aside = flat > 0 ? (upward * s->right - across * s->up) / flat : s->right;
    plot_vector(plot, "minus_c", c + 0.12 * s->size * aside, -shown);
    bool touches = plot_shown(plot, "t0") == plot_shown(plot, "t1");
    plot_names(plot, {s->near ? "$p$" : "to $p$", "blue", .block = "p"},
               {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .block = "v", .part = ANYWHERE},
               {"$C$", "ink", .block = "c", .part = ANYWHERE},
               {"$t_0$", root_color(plot, "t0"), .step = 4, .block = "world_hit0"},
               {touches ? "" : "$t_1$", root_color(plot, "t1"), .step = 4, .block = "world_hit1"},
               {away > 0 ? "$−C$" : "", "blue", .step = 2, .block = "minus_c", .part = ANYWHERE},
               {near ? "" : "from (0, 0, 0)", "grey", .block = "c"});
}

// All of it moved by -C.
static void object_panel(Plot *plot, const Section *s, Ray ray)
{
    vec3 c = s->sphere.center;
    double length = 1.6 * fmax(s->sphere.radius, 0.2 * s->size), begin = s->near ? 0 : s->low;
    plot_fit(plot, vec3_of(0, 0, 0), s->sphere.radius);
    plot_fit(plot, section_point(s, s->low) - c, 0);
    plot_fit(plot, section_point(s, s->high) - c, 0);
    plot_circle(plot, vec3_of(0, 0, 0), s->sphere.radius);
    plot_line(plot, section_point(s, s->low) - c, section_point(s, s->high) - c, 0, 0);
    axes(plot, "object_axes", s, -length, length, 2);
    if (!s->near)
        plot_undrawn(plot);
    plot_point(plot, "object_p", ray.origin);
    plot_vector(plot, "object_v", ray.origin + s->first * ray.direction, s->stride * ray.direction);
    if (!s->near && s->t < 0)
        begin = s->high;
    bool touches = plot_shown(plot, "t0") == plot_shown(plot, "t1");
    plot_names(plot,
               {s->near ? "$p − C$" : "to $p − C$", "blue", .step = 2,
                .place = section_point(s, begin) - c},
               {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .step = 2, .block = "object_v",
                .part = ANYWHERE},
               {"$t_0$", root_color(plot, "t0"), .step = 4, .block = "object_hit0"},
               {touches ? "" : "$t_1$", root_color(plot, "t1"), .step = 4, .block = "object_hit1"});
}

// Are the words of the world's number and the object's the same?
static bool agree(const Plot *plot, const char *name)
{
    double world = plot_shown(plot, joined("world_", name));
    double object = plot_shown(plot, joined("object_", name));
    return strcmp(number_shown(world).s, number_shown(object).s) == 0;
}

// Lines of text below both panels.
enum { LINES = 16 };

typedef struct {
    Text lines[LINES];
    int steps[LINES], count;
} Lines;

static void say(Lines *lines, int step, Text line)
{
    if (lines->count == LINES)
        return;
    lines->steps[lines->count] = step;
    lines->lines[lines->count++] = line;
}

// In one line if there is room for it, on the narrow canvas also.
static void say_both(Plot *plot, Lines *lines, int step, const char *first, const char *second)
{
    enum { ROOM = 680 };
    Text both = text_of("%s, %s", first, second);
    bool fits = plot_width(plot, both.s) <= ROOM;
    say(lines, step, fits ? both : text_of("%s", first));
    if (!fits)
        say(lines, step, text_of("%s", second));
}

static void say_coefficients(Plot *plot, Lines *lines, const char *where, const char *at)
{
    Text first = text_of("%s: $a$ = {%sa}, $b$ = {%sb}", where, at, at);
    say_both(plot, lines, 3, first.s, text_of("$c$ = {%sc}", at).s);
}

static Text roots_said(const Plot *plot, const char *where, const char *at)
{
    double t0 = plot_shown(plot, joined(at, "t0")), t1 = plot_shown(plot, joined(at, "t1"));
    if (plot_shown(plot, joined(at, "roots")) == 0)
        return text_of("%s: no root", where);
    if (t0 == t1)
        return text_of("%s: $t_0 = t_1$ = {%st0}", where, at);
    return text_of("%s: $t_0$ = {%st0}, $t_1$ = {%st1}", where, at, at);
}

// Your numbers that are wrong, as many in a line as have room.
static void say_yours(const Plot *plot, Lines *lines, const char *where, const char *at)
{
    enum { NAMES = 5, ROOM = 680 };
    static const char *const names[NAMES] = {"a", "b", "c", "t0", "t1"};
    Text line = {""};
    for (int i = 0; i < NAMES; i++) {
        if (!plot_says_yours(plot, joined(at, names[i])))
            continue;
        Text one = text_of("%s = {your_%s%s}", names[i], at, names[i]);
        Text longer = text_of("%s, %s", line.s, one.s);
        if (line.s[0] != '\0' && plot_width(plot, longer.s) <= ROOM) {
            line = longer;
            continue;
        }
        if (line.s[0] != '\0')
            say(lines, 4, line);
        line = text_of("yours, %s: %s", where, one.s);
    }
    if (line.s[0] != '\0')
        say(lines, 4, line);
}

static void world_object_words(Plot *plot)
{
    static const char *const names[] = {"world", "object"}, *const at[] = {"world_", "object_"};
    Lines lines = {.count = 0};
    say_both(plot, &lines, 3, "$p$ = {origin}", "$C$ = {center}");
    say(&lines, 3, (Text){"$p − C$ = {object_p!}"});
    bool same = agree(plot, "a") && agree(plot, "b") && agree(plot, "c");
    for (int i = same; i < 2; i++)
        say_coefficients(plot, &lines, same ? "both" : names[i], at[i]);
    same = agree(plot, "roots") && agree(plot, "t0") && agree(plot, "t1");
    for (int i = same; i < 2; i++)
        say(&lines, 4, roots_said(plot, same ? "both" : names[i], at[i]));
    for (int i = 0; i < 2; i++)
        say_yours(plot, &lines, names[i], at[i]);

    Label words[LINES];
    for (int i = 0; i < lines.count; i++)
        words[i] = (Label){lines.lines[i].s, "ink", .step = lines.steps[i]};
    plot_pin_of(plot, 0.5, 0.03 + 0.035 * lines.count, lines.count, words);
    const Label headings[] = {{"world: $|(p + t v) − C|² = r²$", "ink", .step = 1},
                              {"object: $|p + t v|² = r²$", "ink", .step = 2}};
    double bottom = 0.04 + 0.061 * lines.count;
    for (int i = 0; i < 2; i++) {
        plot_pin_of(plot, 0.26 + 0.5 * i, 0.95, 1, &headings[i]);
        Room room = {i == 0 ? 0.02 : 0.52, i == 0 ? 0.48 : 0.98, bottom, 0.79};
        plot_panel(plot, i + 1);
        plot_room(plot, room, room);
    }
    plot_panel(plot, 1);
}

static void world_object(Plot *plot, void *given)
{
    Meeting m = moved(given);
    Section section = section_upright(m.ray, m.sphere);
    Quadratic world = world_quadratic(m.ray, m.sphere), object = quadratic_of(&m);
    Roots world_roots = quadratic_roots(world), object_roots = quadratic_roots(object);
    section_include(&section, root_shown(world_roots, 0));
    section_include(&section, root_shown(world_roots, 1));
    section_end(&section, object_roots);
    plot_apart(plot);
    section_data(plot, &section);
    Ray object_ray = to_object_coordinates(m.ray, m.sphere);
    coefficient_numbers(plot, "world_", world);
    coefficient_numbers(plot, "object_", object);
    root_numbers(plot, "world_", world_roots);
    root_numbers(plot, "object_", object_roots);
    root_mark(plot, "world_hit0", m.ray, root_shown(world_roots, 0));
    root_mark(plot, "world_hit1", m.ray, root_shown(world_roots, 1));
    plot_number(plot, "hit", hit_sphere(m.ray, m.sphere));
    plot_number(plot, "t0", root_shown(object_roots, 0));
    plot_number(plot, "t1", root_shown(object_roots, 1));
    plot_direction(plot, "moved", m.sphere.center);
    world_panel(plot, &section);
    section_handles(plot, &section, false);
    plot_panel(plot, 2);
    root_mark(plot, "object_hit0", object_ray, root_shown(object_roots, 0));
    root_mark(plot, "object_hit1", object_ray, root_shown(object_roots, 1));
    object_panel(plot, &section, object_ray);
    world_object_words(plot);
}

const Figure quadratic_figures[] = {{"ray-sphere", ray_sphere},
                                    {"parabola", parabola_data},
                                    {"discriminant", discriminant_figure},
                                    {"geometric-roots", geometric_roots},
                                    {"world-object", world_object},
                                    {0}};

// ---- a quadratic, its roots and their places, as data of figures --------------------------------

// The count of a wrong answer, or of a blank, may be any number.
int roots_shown(Roots roots)
{
    return roots.count < 0 ? 0 : roots.count > 2 ? 2 : roots.count;
}

double root_shown(Roots roots, int i)
{
    return i < roots_shown(roots) ? roots.t[i] : NAN;
}

Quadratic quadratic_of(const Meeting *m)
{
    return object_quadratic(to_object_coordinates(m->ray, m->sphere), m->sphere.radius);
}

static double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// f(t) = |p + tv|^2 - r^2, by its coefficients.
double quadratic_value(Quadratic q, double t)
{
    return q.a * t * t + q.b * t + q.c;
}

const char *joined(const char *left, const char *right)
{
    static char name[40];
    snprintf(name, sizeof name, "%s%s", left, right);
    return name;
}

// PREFIXa, PREFIXb, PREFIXc and the discriminant, PREFIXD.
void coefficient_numbers(Plot *plot, const char *prefix, Quadratic q)
{
    int digits = coefficient_digits(q);
    plot_number_to(plot, joined(prefix, "a"), q.a, digits);
    plot_number_to(plot, joined(prefix, "b"), q.b, digits);
    plot_number_to(plot, joined(prefix, "c"), q.c, digits);
    plot_number(plot, joined(prefix, "D"), discriminant(q));
}

// PREFIXroots, how many; PREFIXt0 and PREFIXt1.
void root_numbers(Plot *plot, const char *prefix, Roots roots)
{
    plot_number(plot, joined(prefix, "roots"), roots_shown(roots));
    plot_number_to(plot, joined(prefix, "t0"), root_shown(roots, 0), root_digits(roots));
    plot_number_to(plot, joined(prefix, "t1"), root_shown(roots, 1), root_digits(roots));
}

// A place on the line. NaN if t is infinite or NaN, so that nothing is drawn.
void root_mark(Plot *plot, const char *name, Ray ray, double t)
{
    plot_point(plot, name, ray.origin + (isfinite(t) ? t : NAN) * ray.direction);
}
