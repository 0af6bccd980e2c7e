// figure_vector.c - vectors from the eye to the image plane, and rays.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "common/ray.h"
#include "tests/judge/numbers.h"
#include "tests/judge/right_answer.h"

#include <stdio.h>
#include <string.h>

enum { GRID = 8 };

// ---- a vector or a ray from the eye -------------------------------------------------------------

static struct {
    Camera camera;
    vec3 corners[4]; // from the eye
    Ray right, yours;
    bool is_ray;
} view;

bool read_vector(Wrong *wrong)
{
    Camera c;
    WIRE_GET(wrong->question, Camera, c);
    view.camera = c;
    view.is_ray = strcmp(exercises[wrong->kept->exercise].results, "Ray") == 0;
    view.right.origin = view.yours.origin = c.origin;
    if (view.is_ray) {
        WIRE_GET(wrong->right, Ray, view.right);
        WIRE_GET(wrong->yours, Ray, view.yours);
    } else {
        WIRE_GET(wrong->right, vec3, view.right.direction);
        WIRE_GET(wrong->yours, vec3, view.yours.direction);
    }
    double size = vec3_length(view.right.direction), length = vec3_length(view.yours.direction);
    return right_corners(wrong->record, c, view.corners) && (!view.is_ray || length > 0) &&
           figure_near(view.yours.origin, view.right.origin, size) &&
           (figure_near(view.yours.direction, view.right.direction, size) ||
            (view.is_ray && isfinite(length)));
}

// Between two corners, and two others: across from the left, up from the bottom.
static vec3 place(double across, double up)
{
    vec3 top = view.corners[0] + across * (view.corners[1] - view.corners[0]);
    vec3 bottom = view.corners[3] + across * (view.corners[2] - view.corners[3]);
    return view.camera.origin + bottom + up * (top - bottom);
}

static void write_plane(Plot *plot)
{
    plot_block(plot, "plane", "x y z of the corners, from the upper left on");
    for (int i = 0; i < 5; i++)
        plot_row_point(plot, view.camera.origin + view.corners[i % 4]);
    plot_block_end(plot);
    plot_block(plot, "grid", "x y z of the two ends of a line");
    for (int i = 1; i < GRID; i++) {
        double part = (double)i / GRID;
        plot_row_point(plot, place(part, 0));
        plot_row_point(plot, place(part, 1));
        plot_gap(plot);
        plot_row_point(plot, place(0, part));
        plot_row_point(plot, place(1, part));
        plot_gap(plot);
    }
    plot_block_end(plot);
    for (int i = 0; i < 4; i++)
        plot_fit(plot, view.camera.origin + view.corners[i], 0);
}

// The length of a ray is free: it is drawn as long as the right one.
static Ray as_long_as(Ray ray, Ray right)
{
    ray.direction *= vec3_length(right.direction) / vec3_length(ray.direction);
    return ray;
}

static Text ray_words(Ray ray, bool with_origin)
{
    Text text;
    if (with_origin)
        snprintf(text.s, sizeof text.s, "from %.60s along %.60s", vec3_text_to(ray.origin, 4).s,
                 vec3_text_to(ray.direction, 4).s);
    else
        snprintf(text.s, sizeof text.s, "%s", vec3_text(ray.direction).s);
    return text;
}

static Text ray_off(Ray right, Ray yours)
{
    Text text;
    vec3 off = yours.origin - right.origin;
    vec3 cross = vec3_cross(yours.direction, right.direction);
    double angle = atan2(vec3_length(cross), vec3_dot(yours.direction, right.direction)) * 180 / PI;
    if (vec3_length(off) > 1e-9 * (1 + vec3_length(right.origin)))
        snprintf(text.s, sizeof text.s,
                 angle < 1e-6 ? "starts off by %.60s"
                              : "starts off by %.60s, points off by %.40s\u00b0",
                 vec3_text_to(off, 4).s, number_text_to(angle, 3).s);
    else
        snprintf(text.s, sizeof text.s, "points off by %.40s\u00b0", number_text_to(angle, 3).s);
    return text;
}

void write_vector(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    Camera c = view.camera;
    Ray right = view.right, yours = view.yours;
    figure_frame(plot, c.right, c.up, c.forward);
    plot_point(plot, "eye", c.origin);
    plot_fit(plot, c.origin, 0);
    write_plane(plot);
    if (view.is_ray) {
        bool moved = !figure_same_place(yours.origin, right.origin);
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){ray_words(right, moved).s, ray_words(yours, moved).s,
                                   ray_off(right, yours).s});
        yours = as_long_as(yours, right);
    } else {
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){vec3_text(right.direction).s, vec3_text(yours.direction).s,
                                   beside_off(c, yours.direction - right.direction).s});
    }
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_name(plot, (Label){"$p$", "blue", .block = "eye"});
    beside_names(plot);
}

// ---- a ray in object coordinates ----------------------------------------------------------------

static double radius;

bool read_ray(Wrong *wrong)
{
    Ray ray;
    Sphere sphere;
    WIRE_GET(wrong->question, Ray, ray);
    WIRE_GET(wrong->question, Sphere, sphere);
    WIRE_GET(wrong->right, Ray, view.right);
    WIRE_GET(wrong->yours, Ray, view.yours);
    radius = sphere.radius;
    double size = radius + vec3_length(view.right.origin) + vec3_length(view.right.direction);
    return figure_near(view.yours.origin, view.right.origin, size) &&
           figure_near(view.yours.direction, view.right.direction, size);
}

void write_ray(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    Ray right = view.right, yours = view.yours;
    bool moved = !figure_same_place(yours.origin, right.origin);
    // Seen from the side, with the sphere's centre not in front of the ray.
    vec3 along = vec3_unit(right.direction);
    vec3 up = -right.origin - vec3_dot(-right.origin, along) * along;
    if (vec3_length(up) < 1e-6 * (1 + vec3_length(right.origin)))
        up = vec3_cross(along, fabs(along[0]) < 0.6 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0));
    up = vec3_unit(up);
    vec3 center = vec3_of(0, 0, 0), aside = vec3_cross(along, up);
    plot_number(plot, "radius", radius);
    figure_frame(plot, aside, up, along);
    plot_look(plot, aside, up, along, 16, 12);
    plot_point(plot, "center", center);
    plot_circle(plot, center, radius);
    plot_fit(plot, center, radius);
    plot_name(plot, (Label){"$C$ = (0, 0, 0)", "ink", .block = "center"});
    beside_names(plot);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){ray_words(right, true).s, ray_words(yours, true).s,
                               moved ? ray_off(right, yours).s : ""});
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
}
