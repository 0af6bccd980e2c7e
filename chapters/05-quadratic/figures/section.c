// section.c - the plane through a ray and the centre of a sphere, as a figure shows it.
#include "chapters/05-quadratic/figures/section.h"

#include "common/text.h"

#include <stdio.h>

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

Section section_upright(Ray ray, Sphere sphere)
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

Section section_level(Ray ray, Sphere sphere)
{
    Section s = meeting(ray, sphere);
    s.right = s.line;
    s.up = s.off;
    return in_sight(s);
}

void section_include(Section *s, double t)
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
    for (int i = 0; i < 2; i++)
        if (least <= (i == 0 ? 2 : 5) * ten)
            return (i == 0 ? 2 : 5) * ten;
    return 10 * ten;
}

void section_end(Section *s)
{
    s->stride = stride(s);
    if (s->near) // the tip of v must also be visible
        s->high = fmax(s->high, 1.1 * s->stride);
    s->first = s->near ? 0 : s->t > 0 ? s->low : s->high - s->stride;
    s->small_ball = s->sphere.radius < 0.05 * (s->high - s->low) * vec3_length(s->ray.direction);
}

vec3 section_point(const Section *section, double t)
{
    return section->ray.origin + t * section->ray.direction;
}

// ---- what is drawn -----------------------------------------------------------------------------

static void circle(Plot *plot, const Section *s)
{
    plot_undrawn(plot); // for labels, a circle of fewer corners does
    plot_block(plot, "circle", "x y z, round the sphere in the plane of the ray and the centre");
    for (int i = 0; i <= CIRCLE; i++) {
        double angle = 2 * PI * i / CIRCLE;
        plot_row_point(plot, s->sphere.center +
                                 s->sphere.radius * (cos(angle) * s->right + sin(angle) * s->up));
    }
    plot_block_end(plot);
    plot_circle(plot, s->sphere.center, s->sphere.radius);
}

static void stretch(Plot *plot, const Section *s, const char *name, double from, double to)
{
    plot_block(plot, name, "x y z of the two ends");
    plot_row_point(plot, section_point(s, from));
    plot_row_point(plot, section_point(s, to));
    plot_block_end(plot);
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

static void one_tick(Plot *plot, const Section *s, double t)
{
    vec3 p = section_point(s, t) + s->axis;
    plot_row_dot(plot, 4, (const double[]){p[0], p[1], p[2], t});
}

static void ticks(Plot *plot, const Section *s)
{
    plot_block(plot, "ticks", "x y z t");
    for (int i = 0; i < ticks_shown(s); i++)
        one_tick(plot, s, tick(s, i));
    // So far away that neighbouring whole numbers are the same double: the block must not be empty.
    if (ticks_shown(s) <= 0)
        one_tick(plot, s, s->t);
    plot_block_end(plot);
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

void section_data(Plot *plot, const Section *s)
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

void section_names(Plot *plot, const Section *s, int sphere_step)
{
    bool ends = s->near || s->t > 0; // does the line go on beyond the right edge?
    const Label labels[] = {
        {s->near ? "$p$" : "to $p$", "blue", .block = "p"},
        {s->stride == 1 ? "$v$" : "{stride} $v$", "blue", .block = "v", .part = ANYWHERE},
        {"$C$", "ink", .step = sphere_step, .block = "center"},
        {s->small_ball ? "$r$ = {r}" : "$r$", "ink", .step = sphere_step,
         .block = s->small_ball ? "center" : "radius", .part = s->small_ball ? 0 : ANYWHERE},
        {"$p + t v$", "blue", .block = "tail", .row = 1, .part = ANYWHERE},
    };
    plot_names(plot, labels, sizeof labels / sizeof *labels - !ends);
}

// With minus signs for hyphens.
static Text tick_text(double t)
{
    Text number = number_text_to(t, 10), text;
    size_t size = 0;
    for (const char *c = number.s; *c != '\0'; c++)
        size +=
            (size_t)snprintf(text.s + size, sizeof text.s - size, *c == '-' ? "\u2212" : "%c", *c);
    return text;
}

void section_marks(Plot *plot, const Section *s, int step, int count, const double *taken)
{
    ticks(plot, s);
    for (int i = 0; i < ticks_shown(s); i++) {
        bool is_clear = true;
        for (int k = 0; k < count; k++)
            is_clear = is_clear && !(fabs(tick(s, i) - taken[k]) < 0.2 * s->stride);
        if (is_clear)
            plot_name(plot, (Label){tick(s, i) == 0 ? "$t$ = 0" : tick_text(tick(s, i)).s, "grey",
                                    .step = step, .block = "ticks", .row = i});
    }
}

void section_handles(Plot *plot, const Section *s, bool turns)
{
    enum { LARGEST = 1000 };
    const vec3 none = {0}, v = s->ray.direction;
    if (s->near)
        plot_handle(plot, (Handle){.words = "p, the origin of the ray",
                                   .place = s->ray.origin,
                                   .option = {"origin"},
                                   .count = 3,
                                   .value = s->ray.origin,
                                   .along = {turns ? s->line : s->right, turns ? none : s->up}});
    if (s->near && s->stride == 1 && !turns)
        plot_handle(plot, (Handle){.words = "v, the direction of the ray",
                                   .place = s->ray.origin + v,
                                   .option = {"direction"},
                                   .count = 3,
                                   .value = v,
                                   .along = {s->right, s->up}});
    plot_handle(plot, (Handle){.words = "C, the centre of the sphere",
                               .place = s->sphere.center,
                               .option = {"center"},
                               .count = 3,
                               .value = s->sphere.center,
                               .along = {s->right, s->up}});
    vec3 rim = (s->line - s->off) / sqrt(2);
    plot_handle(plot, (Handle){.words = "r, the radius of the sphere",
                               .place = s->sphere.center + s->sphere.radius * rim,
                               .option = {"radius"},
                               .count = 1,
                               .value = vec3_of(s->sphere.radius, 0, 0),
                               .along = {rim},
                               .least = {0.01},
                               .most = {LARGEST}});
}
