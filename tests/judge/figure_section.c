// figure_section.c - where a ray meets spheres: the section through the ray, and its t axis.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "common/ray.h"
#include "common/scene.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

enum { MOST_SPHERES = 100, MOST_NAMES = 12 };

// The places of an answer: at most two; and which sphere, if the exercise asks for it.
typedef struct {
    int count, sphere;
    double t[2];
} Places;

static struct {
    Ray ray;
    int count;
    Sphere spheres[MOST_SPHERES];
    Places right, yours;
    bool are_roots, has_index;
} section;

static void read_spheres(Wire *question, bool whole_scene)
{
    Scene scene;
    section.count = 1;
    if (!whole_scene) {
        WIRE_GET(question, Sphere, section.spheres[0]);
        return;
    }
    wire_get_value(question, &type_Scene, &scene);
    section.count = scene.sphere_count < MOST_SPHERES ? scene.sphere_count : MOST_SPHERES;
    for (int i = 0; i < section.count; i++)
        section.spheres[i] = scene.spheres[i];
    wire_free_value(&type_Scene, &scene);
}

static Places read_places(Wire *wire, const char *results)
{
    Places places = {0, -1, {NO_HIT, NO_HIT}};
    Roots roots = {0};
    Hit hit = {0};
    if (strcmp(results, "Roots") == 0) {
        WIRE_GET(wire, Roots, roots);
        places = (Places){roots.count, -1, {roots.t[0], roots.t[1]}};
    } else if (strcmp(results, "Hit") == 0) {
        WIRE_GET(wire, Hit, hit);
        places = (Places){hit.t != NO_HIT, hit.sphere, {hit.t, NO_HIT}};
    } else {
        WIRE_GET(wire, double, places.t[0]);
        places.count = places.t[0] != NO_HIT;
    }
    return places;
}

static bool are_drawable(Places places)
{
    bool good = places.count >= 0 && places.count <= 2;
    for (int i = 0; good && i < places.count; i++)
        good = isfinite(places.t[i]);
    return good;
}

bool read_section(Wrong *wrong)
{
    const Exercise *types = &exercises[wrong->kept->exercise];
    section.has_index = strcmp(types->results, "Hit") == 0;
    section.are_roots = strcmp(types->results, "Roots") == 0;
    WIRE_GET(wrong->question, Ray, section.ray);
    read_spheres(wrong->question, section.has_index);
    section.right = read_places(wrong->right, types->results);
    section.yours = read_places(wrong->yours, types->results);
    return are_drawable(section.right) && are_drawable(section.yours) &&
           (section.right.count > 0 || section.yours.count > 0) &&
           vec3_length(section.ray.direction) > 0;
}

// Along the ray and to its side, each sphere rotated around the ray into the paper: the first
// below.
static void write_spheres(Plot *plot, Range *x, Range *y)
{
    vec3 along = vec3_unit(section.ray.direction), below = vec3_of(0, 0, 0);
    plot_block(plot, "spheres", "along the ray, aside, radius, which");
    for (int i = 0; i < section.count; i++) {
        vec3 center = section.spheres[i].center - section.ray.origin;
        double r = section.spheres[i].radius, ahead = vec3_dot(center, along);
        vec3 away = center - ahead * along;
        if (vec3_length(below) == 0)
            below = away;
        double aside = vec3_length(away) * (vec3_dot(away, below) < 0 ? 1 : -1);
        plot_row(plot, 4, (const double[]){ahead, aside, r, i});
        plot_circle(plot, vec3_of(ahead, aside, 0), r);
        plot_fit(plot, vec3_of(ahead, aside, 0), r);
        if (section.has_index && i < MOST_NAMES)
            plot_name(plot, (Label){number_text(i).s, "grey", .place = vec3_of(ahead, aside, 0),
                                    .ball = r});
        if (i == 0)
            *x = (Range){ahead - r, ahead + r};
        range_add(x, ahead - r);
        range_add(x, ahead + r);
        range_add(y, aside - r);
        range_add(y, aside + r);
    }
    plot_block_end(plot);
}

static Text words_of(Places places, bool all_shown)
{
    Text text;
    const char *beyond = all_shown ? "" : " (not in the figure)";
    if (places.count == 0)
        snprintf(text.s, sizeof text.s, section.are_roots ? "no root" : "no hit");
    else if (places.count == 2)
        snprintf(text.s, sizeof text.s, "t = %.40s and %.40s%s", number_text(places.t[0]).s,
                 number_text(places.t[1]).s, beyond);
    else if (section.has_index)
        snprintf(text.s, sizeof text.s, "sphere %d at t = %.40s%s", places.sphere,
                 number_text(places.t[0]).s, beyond);
    else
        snprintf(text.s, sizeof text.s, "t = %.40s%s", number_text(places.t[0]).s, beyond);
    return text;
}

// Those that are visible beside the others.
static Places shown(Places places, Range *x, double unit)
{
    Places some = {0, places.sphere, {0, 0}};
    for (int i = 0; i < places.count; i++)
        if (range_try(x, places.t[i] * unit))
            some.t[some.count++] = places.t[i];
    return some;
}

void write_section(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    double unit = vec3_length(section.ray.direction);
    Range x = {0, unit}, y = {0, 0};
    Places right = section.right, yours = section.yours;
    plot_look_flat(plot);
    plot_number(plot, "unit", unit);
    write_spheres(plot, &x, &y);
    for (int i = 0; i < right.count; i++)
        range_add(&x, right.t[i] * unit);
    bool has_eye = range_try(&x, 0), has_arrow = has_eye && range_try(&x, unit);
    Places seen = shown(yours, &x, unit);
    double wide = x.high - x.low, low = x.low - 0.04 * wide, high = x.high + 0.04 * wide;
    vec3 p = vec3_of(has_eye ? 0 : NAN, 0, 0), v = vec3_of(has_arrow ? unit : NAN, 0, 0);
    plot_vector(plot, "ray", vec3_of(low, 0, 0), vec3_of(high - low, 0, 0));
    plot_fit(plot, vec3_of(low, 0, 0), 0.015 * wide);
    plot_fit(plot, vec3_of(high, 0, 0), 0.015 * wide);
    plot_point(plot, "p", p);
    plot_vector(plot, "v", vec3_of(0, 0, 0), v);
    plot_name(plot, (Label){"$p$", "blue", .block = "p"});
    if (unit > 0.06 * wide)
        plot_name(plot, (Label){"$v$", "blue", .block = "v", .part = ANYWHERE});
    Axis axis = {low / unit, high / unit, unit,        y.low - 0.09 * wide,
                 right.t,    seen.t,      right.count, seen.count};
    figure_axis(plot, &axis);
    for (int i = 0; i < right.count; i++)
        plot_line(plot, vec3_of(right.t[i] * unit, axis.y, 0), vec3_of(right.t[i] * unit, 0, 0), 0,
                  0);
    for (int i = 0; i < seen.count; i++)
        plot_line(plot, vec3_of(seen.t[i] * unit, axis.y, 0), vec3_of(seen.t[i] * unit, 0, 0), 0,
                  0);
    Text off = {""};
    if (right.count == 1 && yours.count == 1)
        off = figure_off(right.t[0], yours.t[0]);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){words_of(right, true).s,
                               words_of(yours, seen.count == yours.count).s, off.s});
}
