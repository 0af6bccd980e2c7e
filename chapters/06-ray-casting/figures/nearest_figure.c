// nearest_figure.c - one ray and the spheres that it meets, in a plane, as the data of a figure.
#include "chapters/06-ray-casting/figures/figures.h"

#include "common/vec3.h"
#include "exercises/05-quadratic.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CIRCLES = 8, MOST_MISSED = 2, IN_PART = 4 };

// The part of the plane that is shown: t and aside, from low to high.
typedef struct {
    double low[2], high[2];
} Window;

// A sphere, turned around the ray into the paper, and measured in the ray's t.
typedef struct {
    int sphere;
    double t, aside, radius; // aside: from the ray to the center
    double hit;
    bool part; // only its part in the window is drawn
} Circle;

static Circle circle_of(const Shown *shown, int sphere)
{
    Sphere s = shown->shot.scene->spheres[sphere];
    vec3 v = shown->ray.direction, p = s.center - shown->ray.origin;
    double length = vec3_length(v);
    double t = vec3_dot(p, v) / vec3_dot(v, v);
    vec3 off = p - t * v;
    double side = vec3_dot(off, shown->shot.camera.up) < 0 ? -1 : 1;
    return (Circle){
        sphere, t, side * vec3_length(off) / length, s.radius / length, hit_sphere(shown->ray, s),
        false};
}

#define PASSED 1e9 // more than any t

// The lower, the more important: first the nearest hit, then spheres that the ray meets soon, then
// those that it passes closely.
static double far_off(const Shown *shown, Circle circle)
{
    if (shown->hit_count > 0 && shown->hits[0].sphere == circle.sphere)
        return -1;
    if (circle.part)
        return hit_sphere(shown->ray, shown->shot.scene->spheres[circle.sphere]);
    double gap = fabs(circle.aside) - circle.radius;
    return gap > 0 ? PASSED + gap : fmin(fabs(circle.t), PASSED);
}

// How far the ray is drawn.
static double reach(const Shown *shown)
{
    double far = 1.2;
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++)
        far = fmax(far, shown->hits[i].t);
    return far;
}

// So far away or so large that everything else would be too small.
static bool out_of_reach(const Shown *shown, Circle circle)
{
    return fabs(circle.t) + fabs(circle.aside) + circle.radius > 12 * reach(shown);
}

static int choose_circles(const Shown *shown, Circle *circles)
{
    int count = 0;
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        Circle circle = circle_of(shown, i);
        // Of a ground that is hit (a sphere of radius 1000), only the part near the hit is drawn.
        circle.part = out_of_reach(shown, circle);
        if (circle.part && hit_sphere(shown->ray, shown->shot.scene->spheres[i]) > reach(shown))
            continue;
        int place = count < MOST_CIRCLES ? count : MOST_CIRCLES;
        for (; place > 0 && far_off(shown, circle) < far_off(shown, circles[place - 1]); place--)
            if (place < MOST_CIRCLES)
                circles[place] = circles[place - 1];
        if (place < MOST_CIRCLES)
            circles[place] = circle;
        if (count < MOST_CIRCLES)
            count++;
    }
    // If there are many spheres, only a few misses are shown.
    if (shown->shot.scene->sphere_count > MOST_CIRCLES)
        while (count > MOST_MISSED && far_off(shown, circles[count - MOST_MISSED - 1]) > PASSED)
            count--;
    return count;
}

// The fate of a sphere: 0 missed, 1 behind the eye, 2 hit but not nearest, 3 the nearest hit.
static int fate(const Shown *shown, Circle circle, Roots roots)
{
    if (roots.count == 0)
        return 0;
    if (shown->hit_count > 0 && shown->hits[0].sphere == circle.sphere)
        return 3;
    return hit_sphere(shown->ray, shown->shot.scene->spheres[circle.sphere]) < NO_HIT ? 2 : 1;
}

// The lowest lane beside the axis in which an interval meets no other, with room for the names at
// their ends.
static int lane_of(const Roots *intervals, const int *lanes, int count, Roots roots, double name)
{
    int lane = 0;
    for (int i = 0; i < count; i++)
        if (lanes[i] == lane && intervals[i].count > 0 && intervals[i].t[0] <= roots.t[1] + name &&
            roots.t[0] <= intervals[i].t[1] + name) {
            lane++;
            i = -1;
        }
    return lane;
}

// Returns how many lanes there are.
static int circle_data(Plot *plot, const Shown *shown, const Circle *circles, int count, Window w)
{
    double name = 0.06 * (w.high[0] - w.low[0]);
    Roots intervals[MOST_CIRCLES];
    int lanes[MOST_CIRCLES], most = 0;
    plot_block(plot, "circles", "number t aside radius rgb fate root root hit lane part");
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        const Scene *scene = shown->shot.scene;
        double hit = hit_sphere(shown->ray, scene->spheres[c.sphere]);
        intervals[i] = sphere_roots(shown->ray, scene->spheres[c.sphere]);
        bool met = intervals[i].count > 0;
        lanes[i] = met ? lane_of(intervals, lanes, i, intervals[i], name) : 0;
        most = lanes[i] > most ? lanes[i] : most;
        plot_row(plot, c.sphere, c.t, c.aside, c.radius,
                 rgb_number(scene_surface(scene, c.sphere)->color), fate(shown, c, intervals[i]),
                 met ? intervals[i].t[0] : NAN, met ? intervals[i].t[1] : NAN,
                 hit < NO_HIT ? hit : NAN, lanes[i], c.part);
    }
    // If all spheres are missed, each row has a NaN; such a block is not drawn (plot.c).
    double nowhere[11];
    for (int i = 0; i < 11; i++)
        nowhere[i] = 1e9;
    plot_row_of(plot, 11, nowhere);
    plot_block(plot, "roots", "t");
    for (int i = 0; i < count; i++)
        for (int k = 0; k < intervals[i].count; k++)
            plot_row(plot, intervals[i].t[k]);
    plot_row(plot, NAN);
    return most + 1;
}

// The names of the spheres with some fate, or of those drawn in part, as "A, C".
static void names(Plot *plot, const char *name, const Shown *shown, const Circle *circles,
                  int count, int low, int high)
{
    char text[200] = "";
    for (int i = 0; i < count; i++) {
        Roots roots = sphere_roots(shown->ray, shown->shot.scene->spheres[circles[i].sphere]);
        int its = fate(shown, circles[i], roots);
        size_t used = strlen(text);
        if (low == IN_PART ? circles[i].part : its >= low && its <= high)
            snprintf(text + used, sizeof text - used, "%s%s", used > 0 ? ", " : "",
                     sphere_name(circles[i].sphere).s);
    }
    plot_text(plot, name, text);
}

// The part that must be visible: the eye, v, all circles; for circles drawn in part, the hit with
// room around it.
static Window window_of(const Shown *shown, const Circle *circles, int count)
{
    Window w = {{-0.1, -0.1}, {1.2, 0.1}};
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        double middle[] = {c.t, c.aside}, room = c.radius;
        if (c.part) {
            middle[0] = hit_sphere(shown->ray, shown->shot.scene->spheres[c.sphere]);
            middle[1] = 0;
            room = 0.25 * fmax(1, middle[0]);
        }
        for (int k = 0; k < 2; k++) {
            w.low[k] = fmin(w.low[k], middle[k] - (c.part && k == 0 ? 0 : room));
            w.high[k] = fmax(w.high[k], middle[k] + room);
        }
    }
    return w;
}

static void window_data(Plot *plot, Window window)
{
    plot_number(plot, "low_x", window.low[0]);
    plot_number(plot, "high_x", window.high[0]);
    plot_number(plot, "low_y", window.low[1]);
    plot_number(plot, "high_y", window.high[1]);
}

// The part of a disc that is in the window: from one of its edges to the other, and back on the
// other side of the disc. 'along': the direction in which the disc's edge goes, mostly.
static void part_rows(Plot *plot, Circle c, Window w, double rgb)
{
    enum { STEPS = 512 };
    const double middle[] = {c.t, c.aside};
    double off[2], at[2];
    for (int k = 0; k < 2; k++)
        off[k] = fabs(middle[k] - (w.low[k] + w.high[k]) / 2);
    int along = off[0] > off[1], across = 1 - along;
    double low = fmax(w.low[along], middle[along] - c.radius);
    double high = fmin(w.high[along], middle[along] + c.radius);
    for (int i = 0; i < 2 * STEPS + 2; i++) {
        bool back = i > STEPS;
        at[along] = low + (high - low) * (back ? 2 * STEPS + 1 - i : i) / STEPS;
        double aside = at[along] - middle[along];
        double half = sqrt(fmax(0, (c.radius - aside) * (c.radius + aside)));
        double edge = middle[across] + (back ? -half : half);
        at[across] = fmax(w.low[across], fmin(w.high[across], edge));
        plot_row(plot, at[0], at[1], rgb, at[across] == edge);
    }
    plot_gap(plot);
}

static void part_data(Plot *plot, const Shown *shown, const Circle *circles, int count, Window w)
{
    plot_block(plot, "parts", "t aside rgb, 1 on the circle");
    for (int i = 0; i < count; i++)
        if (circles[i].part)
            part_rows(plot, circles[i], w,
                      rgb_number(scene_surface(shown->shot.scene, circles[i].sphere)->color));
    plot_row(plot, NAN, NAN, 0, 0);
}

static int larger_first(const void *a, const void *b)
{
    double first = ((const Circle *)a)->radius, second = ((const Circle *)b)->radius;
    return (first < second) - (first > second);
}

// Below the picture is the axis, with a lane for each interval above it (nearest-hit.gp).
static void look(Plot *plot, const Shown *shown, const Circle *circles, int count, Window w,
                 int lanes)
{
    enum { FEW = 5 };
    double below = (116 + 24.0 * lanes) / 540;
    plot_look_flat(plot);
    plot_room(plot, (Room){0.05, 0.93, below + 0.05, 0.85}, (Room){0.06, 0.92, below + 0.05, 0.85});
    plot_fill_room(plot);
    plot_keep_clear(plot, (Room){0, 1, 0, below}, (Room){0, 1, 0, below});
    plot_fit(plot, vec3_of(w.low[0], w.low[1], 0), 0);
    plot_fit(plot, vec3_of(w.high[0], w.high[1], 0), 0);
    plot_line(plot, vec3_of(w.low[0], 0, 0), vec3_of(w.high[0], 0, 0), 0, 0);
    // From the eye and from the closest hit, lines go down to the axis.
    double down = w.low[1] - 2 * (w.high[0] - w.low[0]);
    plot_line(plot, vec3_of(0, 0, 0), vec3_of(0, down, 0), 0, 0);
    if (shown->hit_count > 0)
        plot_line(plot, vec3_of(shown->hits[0].t, 0, 0), vec3_of(shown->hits[0].t, down, 0), 0, 0);
    vec3 middles[MOST_CIRCLES];
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        middles[i] = vec3_of(c.t, c.aside, 0);
        plot_circle(plot, middles[i], c.radius);
        if (c.part)
            middles[i] = vec3_of((fmax(w.low[0], fmin(w.high[0], c.t)) + c.hit) / 2,
                                 fmax(w.low[1], fmin(w.high[1], c.aside)) / 2, 0);
        plot_name(plot,
                  (Label){.text = sphere_name(c.sphere).s, .color = "ink", .place = middles[i]});
    }
    plot_name(plot, (Label){.text = "eye", .color = "blue"});
    plot_name(plot, (Label){.text = "$v$", .color = "blue", .place = vec3_of(0.5, 0, 0)});
    // The first step asks which spheres are hit; the next ones answer.
    for (int i = 0; i < count && count <= FEW; i++) {
        static const char *const answers[] = {"missed", "behind"};
        Sphere sphere = shown->shot.scene->spheres[circles[i].sphere];
        int its = fate(shown, circles[i], sphere_roots(shown->ray, sphere));
        if (its < 2)
            plot_name(plot, (Label){answers[its], "grey", .step = 2 + its, .place = middles[i]});
    }
}

static void left_out(Plot *plot, int count, int all)
{
    plot_say(plot, 0, 1,
             {.text = text_of("Drawn: %d of %d spheres", count, all).s, .color = "grey"});
}

// The first sphere can be dragged along the ray, and away from it.
static void sphere_handle(Plot *plot, const Shown *shown)
{
    Circle circle = circle_of(shown, 0);
    vec3 v = shown->ray.direction, up = shown->shot.camera.up;
    vec3 aside = vec3_unit(up - vec3_dot(up, v) / vec3_dot(v, v) * v);
    Handle handle = shown_sphere(shown, v, vec3_length(v) * aside);
    handle.place = vec3_of(circle.t, circle.aside, 0);
    handle.way[0] = vec3_of(1, 0, 0);
    handle.way[1] = vec3_of(0, 1, 0);
    plot_handle(plot, handle);
}

void nearest_figure_data(Plot *plot, void *given)
{
    const Shown *shown = given;
    Circle circles[MOST_CIRCLES];
    int count = choose_circles(shown, circles);
    bool any = shown->hit_count > 0;
    plot_number(plot, "balls", count);
    plot_number(plot, "all_balls", shown->shot.scene->sphere_count);
    names(plot, "missed_names", shown, circles, count, 0, 0);
    names(plot, "behind_names", shown, circles, count, 1, 1);
    names(plot, "hit_names", shown, circles, count, 2, 3);
    names(plot, "part_names", shown, circles, count, IN_PART, IN_PART);
    // Large circles are drawn first, below small ones.
    qsort(circles, (size_t)count, sizeof *circles, larger_first);
    Window window = window_of(shown, circles, count);
    int lanes = circle_data(plot, shown, circles, count, window);
    part_data(plot, shown, circles, count, window);
    window_data(plot, window);
    plot_number(plot, "all_hits", shown->hit_count);
    plot_number(plot, "nearest", any ? shown->hits[0].t : 0);
    plot_text(plot, "nearest_name", any ? sphere_name(shown->hits[0].sphere).s : "");
    plot_block(plot, "closest", "t");
    plot_row(plot, any ? shown->hits[0].t : NAN);
    plot_block(plot, "along", "t of the eye");
    plot_row(plot, 0);
    plot_include(plot, "common/figure/spheres.gp");
    look(plot, shown, circles, count, window, lanes);
    for (int i = 0; i < count; i++)
        if (circles[i].sphere == 0)
            sphere_handle(plot, shown);
    if (count < shown->shot.scene->sphere_count)
        left_out(plot, count, shown->shot.scene->sphere_count);
}
