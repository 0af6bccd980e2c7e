// outline.c - the outline of a sphere on the image plane, and the lines from it to the eye.
#include "chapters/06-ray-casting/figures/outline.h"

enum { OUTLINE_PLACES = 72, LINES = 6, LINE_PLACES = 160, FEW_PLACES = 40 };

// A place of the circle that is the sphere's outline, seen from the eye. There the line of sight
// touches the sphere, at right angles to its radius.
static vec3 outline_place(Camera c, Sphere sphere, double angle)
{
    vec3 axis = sphere.center - c.origin;
    double away = vec3_length(axis);
    double flat = sphere.radius / away;
    vec3 aside =
        vec3_unit(vec3_cross(fabs(vec3_dot(axis, c.up)) < 0.9 * away ? c.up : c.right, axis));
    vec3 up = vec3_unit(vec3_cross(axis, aside));
    return c.origin + (1 - flat * flat) * axis +
           sphere.radius * sqrt(1 - flat * flat) * (cos(angle) * aside + sin(angle) * up);
}

// The place where a line of sight crosses the image plane. NaN if the line goes backwards, or
// crosses far beside the plane, as the outline of a ground does.
static vec3 on_plane(Camera c, vec3 v)
{
    vec3 place = c.distance / vec3_dot(v, c.forward) * v;
    bool near = vec3_dot(v, c.forward) > 0 && fabs(vec3_dot(place, c.right)) <= c.width &&
                fabs(vec3_dot(place, c.up)) <= c.height;
    return near ? c.origin + place : vec3_of(NAN, NAN, NAN);
}

static vec3 line_of_sight(Camera c, Sphere sphere, int i)
{
    return outline_place(c, sphere, 2 * PI * i / OUTLINE_PLACES) - c.origin;
}

void outline_on_plane(Plot *plot, const char *name, Camera c, Sphere sphere)
{
    plot_block(plot, name, "x y z of the outline on the image plane");
    for (int i = 0; i <= OUTLINE_PLACES; i++)
        plot_row_point(plot, on_plane(c, line_of_sight(c, sphere, i)));
    plot_block_end(plot);
}

// Half way along a line of sight to the plane. It must be a separate function: inside the loop that
// calls it, gcc 14 to 16 stop with an internal compiler error (-O2).
static void arrow_head(Plot *plot, Camera c, vec3 v)
{
    double ahead = vec3_dot(v, c.forward);
    vec3 w = (ahead > 0 ? fmin(1, c.distance / ahead) : 1) * v, p = c.origin + 0.8 * w;
    plot_row_vector(plot, p, -0.3 * w);
}

void lines_to_eye(Plot *plot, const char *lines_name, const char *heads, Camera c, Sphere sphere,
                  bool drawn)
{
    int near[OUTLINE_PLACES], count = 0, lines = 0;
    for (int i = 0; i < OUTLINE_PLACES; i++)
        if (!isnan(on_plane(c, line_of_sight(c, sphere, i))[0]))
            near[count++] = i;
    vec3 v[LINES];
    double part[LINES];
    for (int i = 0; i < LINES && count > 0; i++) {
        vec3 whole = line_of_sight(c, sphere, near[(4 * i + 1) * count / (4 * LINES)]);
        part[i] = drawn ? 1 : fmin(1, 1.6 * c.distance / vec3_dot(whole, c.forward));
        v[i] = part[i] * whole;
        lines++;
    }
    int places = plot_is_dragged(plot) ? FEW_PLACES : LINE_PLACES;
    plot_block(plot, lines_name, "x y z t, 1 where it is drawn bold");
    for (int i = 0; i < lines; i++) {
        for (int k = 0; k <= places; k++) {
            vec3 p = c.origin + (double)k / places * v[i];
            plot_row(plot, 5, (const double[]){p[0], p[1], p[2], part[i] * k / places, 1});
        }
        plot_gap(plot);
        plot_line(plot, c.origin, c.origin + v[i], 0, 0);
    }
    plot_block_end(plot);
    plot_block(plot, heads, "x y z of the start, x y z of the vector");
    for (int i = 0; i < lines; i++)
        arrow_head(plot, c, v[i]);
    plot_block_end(plot);
}
