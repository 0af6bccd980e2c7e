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

// What becomes of a sphere; not NEAREST: it is hit later.
typedef enum { MISSED, BEHIND, HIT, NEAREST } Fate;

// A sphere, turned around the ray into the paper, and measured in the ray's t.
typedef struct {
    int sphere;
    double t, aside, radius; // aside: from the ray to the center
    Roots roots;
    double hit, rgb;
    Fate fate;
    bool part; // only its part in the window is drawn
} Circle;

// How far the ray is drawn.
static double reach(const Shown *shown)
{
    double far = 1.2;
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++)
        far = fmax(far, shown->hits[i].t);
    return far;
}

static Circle circle_of(const Shown *shown, int sphere)
{
    const Scene *scene = shown->shot.scene;
    Sphere s = scene->spheres[sphere];
    vec3 v = shown->ray.direction, p = s.center - shown->ray.origin;
    double length = vec3_length(v);
    double t = vec3_dot(p, v) / vec3_dot(v, v);
    vec3 off = p - t * v;
    double side = vec3_dot(off, shown->shot.camera.up) < 0 ? -1 : 1;
    Circle c = {sphere,
                t,
                side * vec3_length(off) / length,
                s.radius / length,
                .roots = sphere_roots(shown->ray, s),
                .hit = hit_sphere(shown->ray, s),
                .rgb = rgb_number(scene_surface(scene, sphere)->color)};
    bool is_nearest = shown->hit_count > 0 && shown->hits[0].sphere == sphere;
    c.fate = c.roots.count == 0 ? MISSED : is_nearest ? NEAREST : c.hit < NO_HIT ? HIT : BEHIND;
    // So far away or so large that everything else would be too small. Of a ground that is hit (a
    // sphere of radius 1000), only the part near the hit is drawn.
    c.part = fabs(c.t) + fabs(c.aside) + c.radius > 12 * reach(shown);
    return c;
}

#define PASSED 1e9 // more than any t

// The lower, the more important: first the nearest hit, then spheres that the ray meets soon, then
// those that it passes closely.
static double far_off(const Shown *shown, Circle circle)
{
    if (shown->hit_count > 0 && shown->hits[0].sphere == circle.sphere)
        return -1;
    if (circle.part)
        return circle.hit;
    double gap = fabs(circle.aside) - circle.radius;
    return gap > 0 ? PASSED + gap : fmin(fabs(circle.t), PASSED);
}

static int choose_circles(const Shown *shown, Circle *circles)
{
    int count = 0;
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        Circle circle = circle_of(shown, i);
        if (circle.part && circle.hit > reach(shown))
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

// The lowest lane beside the axis in which the interval of a circle meets that of none before it,
// with room for the names at their ends.
static int lane_of(const Circle *circles, const int *lanes, int number, double name)
{
    Roots roots = circles[number].roots;
    int lane = 0;
    for (int i = 0; i < number && roots.count > 0; i++) {
        Roots other = circles[i].roots;
        if (lanes[i] == lane && other.count > 0 && other.t[0] <= roots.t[1] + name &&
            roots.t[0] <= other.t[1] + name) {
            lane++;
            i = -1;
        }
    }
    return lane;
}

// Returns how many lanes there are.
static int circle_data(Plot *plot, const Circle *circles, int count, Window w)
{
    double name = 0.06 * (w.high[0] - w.low[0]);
    int lanes[MOST_CIRCLES], most = 0;
    plot_block(plot, "circles", "number t aside radius rgb fate root root hit lane part");
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        bool met = c.roots.count > 0;
        lanes[i] = lane_of(circles, lanes, i, name);
        most = lanes[i] > most ? lanes[i] : most;
        plot_row(plot, c.sphere, c.t, c.aside, c.radius, c.rgb, c.fate, met ? c.roots.t[0] : NAN,
                 met ? c.roots.t[1] : NAN, c.hit < NO_HIT ? c.hit : NAN, lanes[i], c.part);
    }
    // If all spheres are missed, each row has a NaN; such a block is not drawn (plot.c).
    plot_row(plot, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9);
    plot_block(plot, "roots", "t");
    for (int i = 0; i < count; i++)
        for (int k = 0; k < circles[i].roots.count; k++)
            plot_row(plot, circles[i].roots.t[k]);
    plot_row(plot, NAN);
    return most + 1;
}

// The names of the spheres with some fate, or of those drawn in part, as "A, C".
static void names(Plot *plot, const char *name, const Circle *circles, int count, int low, int high)
{
    char text[200] = "";
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        size_t used = strlen(text);
        if (low == IN_PART ? c.part : (int)c.fate >= low && (int)c.fate <= high)
            snprintf(text + used, sizeof text - used, "%s%s", used > 0 ? ", " : "",
                     sphere_name(c.sphere).s);
    }
    plot_text(plot, name, text);
}

// The part that must be visible: the eye, v, all circles; for circles drawn in part, the hit with
// room around it.
static Window window_of(const Circle *circles, int count)
{
    Window w = {{-0.1, -0.1}, {1.2, 0.1}};
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        double middle[] = {c.t, c.aside}, room = c.radius;
        if (c.part) {
            middle[0] = c.hit;
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
static void part_rows(Plot *plot, Circle c, Window w)
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
        plot_row(plot, at[0], at[1], c.rgb, at[across] == edge);
    }
    plot_gap(plot);
}

static void part_data(Plot *plot, const Circle *circles, int count, Window w)
{
    plot_block(plot, "parts", "t aside rgb, 1 on the circle");
    for (int i = 0; i < count; i++)
        if (circles[i].part)
            part_rows(plot, circles[i], w);
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
        Fate its = circles[i].fate;
        if (its <= BEHIND)
            plot_name(plot,
                      (Label){answers[its], "grey", .step = 2 + (int)its, .place = middles[i]});
    }
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
    names(plot, "missed_names", circles, count, MISSED, MISSED);
    names(plot, "behind_names", circles, count, BEHIND, BEHIND);
    names(plot, "hit_names", circles, count, HIT, NEAREST);
    names(plot, "part_names", circles, count, IN_PART, IN_PART);
    // Large circles are drawn first, below small ones.
    qsort(circles, (size_t)count, sizeof *circles, larger_first);
    Window window = window_of(circles, count);
    int lanes = circle_data(plot, circles, count, window);
    part_data(plot, circles, count, window);
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
        plot_say(
            plot, 0, 1,
            {.text = text_of("Drawn: %d of %d spheres", count, shown->shot.scene->sphere_count).s,
             "grey"});
}
