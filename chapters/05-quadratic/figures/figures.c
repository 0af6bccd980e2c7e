// figures.c - the data of the figures of chapter 05.
#include "chapters/05-quadratic/figures/figures.h"

#include "chapters/05-quadratic/figures/discriminant.h"
#include "chapters/05-quadratic/figures/section.h"
#include "chapters/05-quadratic/numbers.h"
#include "common/example.h"
#include "common/text.h"

#include <stdio.h>
#include <string.h>

enum { DIGITS = 6, SAMPLES = 400 };

// ---- ray-sphere --------------------------------------------------------------------------------

// The hit in words.
static void verdict(Plot *plot, Roots roots, double hit, double away)
{
    char words[200];
    if (hit > 0 && hit < NO_HIT)
        snprintf(words, sizeof words, "t = %s is the hit",
                 number_text_to(hit, root_digits(roots)).s);
    else if (roots_shown(roots) > 0)
        snprintf(words, sizeof words, "no root > 0: no hit");
    else
        snprintf(words, sizeof words, "no root: C is %s away", number_text_to(away, 4).s);
    plot_label(plot, "verdict", words);
}

static bool is_moved(const Meeting *m)
{
    return vec3_length(m->sphere.center) > 0;
}

// The colour of a root: the result is blue, another one ahead of p is ink.
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
    const Label roots[] = {{touches ? "$t_0 = t_1$ = {t0}" : "$t_0$ = {t0}", root_color(plot, "t0"),
                            .step = 4, .block = "hit0"},
                           {"$t_1$ = {t1}", root_color(plot, "t1"), .step = 4, .block = "hit1"}};
    plot_names(plot, roots, touches ? 1 : 2);
    section_marks(plot, s, 1, 3, taken);
    const Label words[] = {
        {"$|p + t v|² = r²$", "ink", .step = 3},   {"$a = v·v =$ {a!}", "ink", .step = 3},
        {"$b = 2 p·v =$ {b!}", "ink", .step = 3},  {"$c = p·p − r² =$ {c!}", "ink", .step = 3},
        {"$b² − 4 a c =$ {D!}", "ink", .step = 3}, {"{verdict!}", "blue", .step = 5},
    };
    const Label moved[] = {{"Here $p$ is $p − C$ =", "grey", .step = 3},
                           {"{object_p!}", "grey", .step = 3}};
    plot_say(plot, 0, 1, words, 6);
    if (plot_shown(plot, "moved") != 0)
        plot_say(plot, 0, 0, moved, 2);
}

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
    plot_number(plot, "moved", is_moved(m));
    coefficient_numbers(plot, "", quadratic_of(m), DIGITS);
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit, root_digits(roots));
    root_mark(plot, "hit0", m->ray, root_shown(roots, 0));
    root_mark(plot, "hit1", m->ray, root_shown(roots, 1));
    root_mark(plot, "used", m->ray, hit);
    verdict(plot, roots, hit, section.away);
    ray_sphere_labels(plot, &section);
    section_handles(plot, &section, false);
}

// ---- parabola ----------------------------------------------------------------------------------

// Where the parabola is drawn: above the section, in its plane. f is at height 'axis' + scale f
// above the line through the centre, and f is shown from low to high: the axis, the lowest point,
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
            plot_row(plot, 2, (const double[]){x, y});
        any = any || inside;
    }
    if (!any)
        plot_row(plot, 2, (const double[]){NAN, NAN});
    plot_block_end(plot);
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

// a t² + b t + c, and 1 is not written.
static void polynomial(Plot *plot, Quadratic q)
{
    char a[200] = "", b[200] = "", c[200] = "", words[600];
    if (q.a != 1)
        snprintf(a, sizeof a, "%s ", number_text_to(q.a, DIGITS).s);
    if (q.b != 0)
        snprintf(b, sizeof b, " %c %s t", q.b < 0 ? '-' : '+', number_text_to(fabs(q.b), DIGITS).s);
    if (q.c != 0)
        snprintf(c, sizeof c, " %c %s", q.c < 0 ? '-' : '+', number_text_to(fabs(q.c), DIGITS).s);
    snprintf(words, sizeof words, "%st²%s%s", a, b, c);
    plot_label(plot, "polynomial", words);
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
    const Label labels[] = {
        {"$t$", "grey", .step = 2, .block = "axis", .part = 1},
        {touches ? "$t_0 = t_1$ = {t0}" : "$t_0$ = {t0}", root_color(plot, "t0"), .step = 3,
         .place = graph_point(g, taken[0], 0)},
        {"$t_1$ = {t1}", root_color(plot, "t1"), .step = 3, .place = graph_point(g, taken[1], 0)}};
    plot_names(plot, labels, touches ? 2 : 3);
    section_marks(plot, s, 2, 3, taken);
    Label words[6] = {{"$f (t) = |p + t v|² − r²$", "ink", .step = 2},
                      {"$=$ {polynomial}", "ink", .step = 2},
                      {above     ? "$f (0) = c =$ {c}"
                       : s->near ? "$f (0) = c =$ {c} is off the top"
                                 : "$f (0) = c =$ {c}, $t$ = 0 is far away",
                       "grey", .step = 2}};
    int count = 3;
    if (plot_shown(plot, "roots") == 0)
        words[count++] = (Label){"no root: $f$ is never below {f_nearest}", "grey", .step = 3};
    if (plot_says_yours(plot, "polynomial"))
        words[count++] = (Label){"yours = {your_polynomial}", "ink", .step = 2};
    plot_say(plot, 0, 1, words, count);
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
    Graph graph = graph_of(&section);
    section.axis = (graph.axis - section.away) * section.off;
    section_data(plot, &section);

    plot_number(plot, "f_low", graph.low);
    plot_number(plot, "f_high", graph.high);
    plot_number(plot, "f_axis", vec3_dot(graph_point(&graph, 0, 0), section.off));
    plot_number(plot, "f_scale", graph.scale);
    plot_number(plot, "t_zero", vec3_dot(m->ray.origin, section.line));
    plot_number(plot, "speed", vec3_length(m->ray.direction));
    coefficient_numbers(plot, "", q, DIGITS);
    polynomial(plot, q);
    root_numbers(plot, "", roots);
    plot_number_to(plot, "hit", hit_sphere(m->ray, m->sphere), root_digits(roots));
    plot_number_to(plot, "f_nearest", quadratic_value(q, section.t), 4);
    root_mark(plot, "hit0", m->ray, root_shown(roots, 0));
    root_mark(plot, "hit1", m->ray, root_shown(roots, 1));
    parabola(plot, &graph, q);
    drawn_above(plot, &graph);
    parabola_labels(plot, &graph);
    section_handles(plot, &section, true);
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

// The axes on the paper with their names, except those that are seen from their end.
static void axes(Plot *plot, const char *name, const Section *s, double low, double high, int step)
{
    static const char *const names[] = {"$x$", "$y$", "$z$"};
    int count = 0;
    plot_block(plot, name, "x y z of an axis's low end, x y z from there to its high end, which");
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3_of(i == 0, i == 1, i == 2);
        if (hypot(vec3_dot(axis, s->right), vec3_dot(axis, s->up)) < 0.1)
            continue;
        plot_row_vector_with(plot, low * axis, (high - low) * axis, i + 1);
        plot_fit(plot, low * axis, 0);
        plot_fit(plot, high * axis, 0);
        plot_name(plot, (Label){names[i], "grey", .step = step, .block = name, .row = count++,
                                .part = 1});
    }
    plot_block_end(plot);
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
    plot_vector(plot, "c", c - shown, shown);
    plot_fit(plot, c - shown, 0);
    double across = vec3_dot(c, s->right), upward = vec3_dot(c, s->up),
           flat = hypot(across, upward);
    vec3 aside = flat > 0 ? (upward * s->right - across * s->up) / flat : s->right;
    plot_vector(plot, "minus_c", c + 0.12 * s->size * aside, -shown);
    const Label labels[] = {
        {s->near ? "$p$" : "to $p$", "blue", .block = "p"},
        {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .block = "v", .part = ANYWHERE},
        {"$C$", "ink", .block = "c", .part = ANYWHERE},
        {"$t_0$", root_color(plot, "t0"), .step = 4, .block = "world_hit0"},
        {"$t_1$", root_color(plot, "t1"), .step = 4, .block = "world_hit1"},
        {away > 0 ? "$−C$" : "", "blue", .step = 2, .block = "minus_c", .part = ANYWHERE},
        {"from (0, 0, 0)", "grey", .block = "c"}};
    bool touches = plot_shown(plot, "t0") == plot_shown(plot, "t1");
    for (int i = 0; i < 7 - near; i++)
        if (!(i == 4 && touches) && !(i == 5 && away == 0))
            plot_name(plot, labels[i]);
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
    const Label labels[] = {{s->near ? "$p − C$" : "to $p − C$", "blue", .step = 2,
                             .place = section_point(s, begin) - c},
                            {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .step = 2,
                             .block = "object_v", .part = ANYWHERE},
                            {"$t_0$", root_color(plot, "t0"), .step = 4, .block = "object_hit0"},
                            {"$t_1$", root_color(plot, "t1"), .step = 4, .block = "object_hit1"}};
    bool touches = plot_shown(plot, "t0") == plot_shown(plot, "t1");
    plot_names(plot, labels, touches ? 3 : 4);
}

// Are the words of the world's number and the object's the same?
static bool agree(const Plot *plot, const char *name)
{
    double world = plot_shown(plot, joined("world_", name));
    double object = plot_shown(plot, joined("object_", name));
    return strcmp(number_text(world).s, number_text(object).s) == 0;
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
    Text one, two;
    snprintf(one.s, sizeof one.s, "%s, %s", first, second);
    if (plot_width(plot, one.s) <= ROOM) {
        say(lines, step, one);
        return;
    }
    snprintf(one.s, sizeof one.s, "%s", first);
    snprintf(two.s, sizeof two.s, "%s", second);
    say(lines, step, one);
    say(lines, step, two);
}

static void say_coefficients(Plot *plot, Lines *lines, const char *where, const char *at)
{
    char first[80], second[40];
    snprintf(first, sizeof first, "%s: $a$ = {%sa}, $b$ = {%sb}", where, at, at);
    snprintf(second, sizeof second, "$c$ = {%sc}", at);
    say_both(plot, lines, 3, first, second);
}

static Text roots_said(const Plot *plot, const char *where, const char *at)
{
    double t0 = plot_shown(plot, joined(at, "t0")), t1 = plot_shown(plot, joined(at, "t1"));
    Text line;
    if (plot_shown(plot, joined(at, "roots")) == 0)
        snprintf(line.s, sizeof line.s, "%s: no root", where);
    else if (t0 == t1)
        snprintf(line.s, sizeof line.s, "%s: $t_0 = t_1$ = {%st0}", where, at);
    else
        snprintf(line.s, sizeof line.s, "%s: $t_0$ = {%st0}, $t_1$ = {%st1}", where, at, at);
    return line;
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
        Text one, longer;
        snprintf(one.s, sizeof one.s, "%s = {your_%s%s}", names[i], at, names[i]);
        snprintf(longer.s, sizeof longer.s, "%.100s, %.50s", line.s, one.s);
        if (line.s[0] != '\0' && plot_width(plot, longer.s) <= ROOM) {
            line = longer;
            continue;
        }
        if (line.s[0] != '\0')
            say(lines, 4, line);
        snprintf(line.s, sizeof line.s, "yours, %s: %.50s", where, one.s);
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
    plot_pin(plot, 0.5, 0.03 + 0.035 * lines.count, words, lines.count);
    const Label headings[] = {{"world: $|(p + t v) − C|² = r²$", "ink", .step = 1},
                              {"object: $|p + t v|² = r²$", "ink", .step = 2}};
    double bottom = 0.04 + 0.061 * lines.count;
    for (int i = 0; i < 2; i++) {
        plot_pin(plot, 0.26 + 0.5 * i, 0.95, &headings[i], 1);
        Room room = {i == 0 ? 0.02 : 0.52, i == 0 ? 0.48 : 0.98, bottom, 0.79};
        plot_panel(plot, i + 1);
        plot_room(plot, room, room);
    }
    plot_panel(plot, 1);
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
    plot_apart(plot);
    section_data(plot, &section);
    Ray object_ray = to_object_coordinates(m.ray, m.sphere);
    coefficient_numbers(plot, "world_", world, DIGITS);
    coefficient_numbers(plot, "object_", object, DIGITS);
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
