// nearest_figure.c - one ray and what it meets, flat, as a figure's data.
#include "chapters/06-ray-casting/nearest_figure.h"

#include "exercises/05-quadratic.h"

#include <stdio.h>
#include <string.h>

enum { MOST_CIRCLES = 8, MOST_MISSED = 2 };

// A sphere as its ray meets it: turned round the ray into the paper, measured in the ray's t.
typedef struct {
    int sphere;
    double t, aside, radius; // aside: from the ray to the middle
} Circle;

static Circle circle_of(const Shown *shown, int sphere)
{
    Sphere s = shown->shot.scene->spheres[sphere];
    vec3 v = shown->ray.direction, p = s.center - shown->ray.origin;
    double length = vec3_length(v);
    double t = vec3_dot(p, v) / vec3_dot(v, v);
    vec3 off = p - t * v;
    double side = vec3_dot(off, shown->shot.camera.up) < 0 ? -1 : 1;
    return (Circle){sphere, t, side * vec3_length(off) / length, s.radius / length};
}

#define PASSED 1e9 // more than any t

// How little it matters: spheres that are met first, those that the ray passes by closely next.
static double far_off(Circle circle)
{
    double gap = fabs(circle.aside) - circle.radius;
    return gap > 0 ? PASSED + gap : fmin(fabs(circle.t), PASSED);
}

// So far off or so large that nothing else would be left to see.
static bool out_of_reach(const Shown *shown, Circle circle)
{
    double reach = 1.2;
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++)
        reach = fmax(reach, shown->hits[i].t);
    return fabs(circle.t) + fabs(circle.aside) + circle.radius > 12 * reach;
}

static int choose_circles(const Shown *shown, Circle *circles)
{
    int count = 0;
    for (int i = 0; i < shown->shot.scene->sphere_count; i++) {
        Circle circle = circle_of(shown, i);
        if (out_of_reach(shown, circle))
            continue;
        int place = count < MOST_CIRCLES ? count : MOST_CIRCLES;
        for (; place > 0 && far_off(circle) < far_off(circles[place - 1]); place--)
            if (place < MOST_CIRCLES)
                circles[place] = circles[place - 1];
        if (place < MOST_CIRCLES)
            circles[place] = circle;
        if (count < MOST_CIRCLES)
            count++;
    }
    // Of many spheres, no more misses than say so.
    if (shown->shot.scene->sphere_count > MOST_CIRCLES)
        while (count > MOST_MISSED && far_off(circles[count - MOST_MISSED - 1]) > PASSED)
            count--;
    return count;
}

// What becomes of a sphere: 0 missed, 1 behind the eye, 2 hit but farther, 3 the nearest hit.
static int fate(const Shown *shown, Circle circle, Roots roots)
{
    if (roots.count == 0)
        return 0;
    if (shown->hit_count > 0 && shown->hits[0].sphere == circle.sphere)
        return 3;
    return hit_sphere(shown->ray, shown->shot.scene->spheres[circle.sphere]) < NO_HIT ? 2 : 1;
}

// The lowest lane beside the axis in which an interval meets no other.
static int lane_of(const Roots *intervals, const int *lanes, int count, Roots roots)
{
    int lane = 0;
    for (int i = 0; i < count; i++)
        if (lanes[i] == lane && intervals[i].count > 0 && intervals[i].t[0] <= roots.t[1] &&
            roots.t[0] <= intervals[i].t[1]) {
            lane++;
            i = -1;
        }
    return lane;
}

static void circle_data(Plot *plot, const Shown *shown, const Circle *circles, int count)
{
    Roots intervals[MOST_CIRCLES];
    int lanes[MOST_CIRCLES];
    plot_block(plot, "circles", "number t aside radius rgb fate root root hit lane");
    for (int i = 0; i < count; i++) {
        Circle c = circles[i];
        const Scene *scene = shown->shot.scene;
        double hit = hit_sphere(shown->ray, scene->spheres[c.sphere]);
        intervals[i] = sphere_roots(shown->ray, scene->spheres[c.sphere]);
        bool met = intervals[i].count > 0;
        lanes[i] = met ? lane_of(intervals, lanes, i, intervals[i]) : 0;
        plot_row(plot, 10,
                 (const double[]){c.sphere, c.t, c.aside, c.radius,
                                  rgb_number(scene_surface(scene, c.sphere)->color),
                                  fate(shown, c, intervals[i]), met ? intervals[i].t[0] : NAN,
                                  met ? intervals[i].t[1] : NAN, hit < NO_HIT ? hit : NAN,
                                  lanes[i]});
    }
    if (count == 0)
        plot_row(plot, 10, (const double[]){0, 0, 0, 0, 0, 0, NAN, NAN, NAN, 0});
    plot_block_end(plot);
    plot_block(plot, "roots", "t");
    for (int i = 0; i < count; i++)
        for (int k = 0; k < intervals[i].count; k++)
            plot_row(plot, 1, &intervals[i].t[k]);
    plot_row(plot, 1, (const double[]){NAN});
    plot_block_end(plot);
}

// The names of the spheres of some fate, as "A, C".
static void names(Plot *plot, const char *name, const Shown *shown, const Circle *circles,
                  int count, int low, int high)
{
    char text[200] = "";
    for (int i = 0; i < count; i++) {
        Roots roots = sphere_roots(shown->ray, shown->shot.scene->spheres[circles[i].sphere]);
        int its = fate(shown, circles[i], roots);
        size_t used = strlen(text);
        if (its >= low && its <= high)
            snprintf(text + used, sizeof text - used, "%s%s", used > 0 ? ", " : "",
                     sphere_name(circles[i].sphere).s);
    }
    plot_text(plot, name, text);
}

// What has to be seen: the eye, v, and all circles.
static void bounds(Plot *plot, const Circle *circles, int count)
{
    double low_t = -0.1, high_t = 1.2, low_side = -0.1, high_side = 0.1;
    for (int i = 0; i < count; i++) {
        low_t = fmin(low_t, circles[i].t - circles[i].radius);
        high_t = fmax(high_t, circles[i].t + circles[i].radius);
        low_side = fmin(low_side, circles[i].aside - circles[i].radius);
        high_side = fmax(high_side, circles[i].aside + circles[i].radius);
    }
    plot_number(plot, "low_x", low_t);
    plot_number(plot, "high_x", high_t);
    plot_number(plot, "low_y", low_side);
    plot_number(plot, "high_y", high_side);
}

void nearest_figure_data(Plot *plot, void *given)
{
    const Shown *shown = given;
    Circle circles[MOST_CIRCLES];
    int count = choose_circles(shown, circles);
    bool any = shown->hit_count > 0;
    plot_number(plot, "balls", count);
    plot_number(plot, "all_balls", shown->shot.scene->sphere_count);
    circle_data(plot, shown, circles, count);
    bounds(plot, circles, count);
    names(plot, "missed_names", shown, circles, count, 0, 0);
    names(plot, "behind_names", shown, circles, count, 1, 1);
    names(plot, "hit_names", shown, circles, count, 2, 3);
    plot_number(plot, "all_hits", shown->hit_count);
    plot_number(plot, "nearest", any ? shown->hits[0].t : 0);
    plot_text(plot, "nearest_name", any ? sphere_name(shown->hits[0].sphere).s : "");
    plot_block(plot, "closest", "t");
    plot_row(plot, 1, (const double[]){any ? shown->hits[0].t : NAN});
    plot_block_end(plot);
    plot_block(plot, "along", "t of the eye");
    plot_row(plot, 1, (const double[]){0});
    plot_block_end(plot);
    plot_include(plot, "common/spheres.gp");
}
