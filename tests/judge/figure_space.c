// figure_space.c - vectors from the eye to the image plane, rays, and cameras.
#include "common/figure/beside.h"
#include "common/ray.h"
#include "tests/judge/figure.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

enum {
    GRID = 8,
    FAR = 20, // from the right one, as a multiple of its size: no farther is drawn
};

static bool is_near(vec3 yours, vec3 right, double size)
{
    return vec3_is_finite(yours) && vec3_length(yours - right) <= FAR * size;
}

// From whose right side the figure is seen.
static void write_frame(Plot *plot, vec3 right, vec3 up, vec3 forward)
{
    plot_direction(plot, "right", right);
    plot_direction(plot, "up", up);
    plot_direction(plot, "forward", forward);
}

// To 9 digits.
static bool is_same_place(vec3 a, vec3 b)
{
    return vec3_length(a - b) <= 1e-9 * (1 + vec3_length(b));
}

// ---- a vector or a ray from the eye ------------------------------------------------------------

static struct {
    Camera camera;
    vec3 corners[4]; // from the eye
    Ray right, yours;
    bool is_ray;
} view;

bool read_vector(Wrong *wrong)
{
    Camera c;
    NUMBERS_GET(wrong->question, Camera, c);
    view.camera = c;
    view.is_ray = strcmp(exercises[wrong->kept->exercise].results, "Ray") == 0;
    view.right.origin = view.yours.origin = c.origin;
    if (view.is_ray) {
        NUMBERS_GET(wrong->right, Ray, view.right);
        NUMBERS_GET(wrong->yours, Ray, view.yours);
    } else {
        NUMBERS_GET(wrong->right, vec3, view.right.direction);
        NUMBERS_GET(wrong->yours, vec3, view.yours.direction);
    }
    double size = vec3_length(view.right.direction), length = vec3_length(view.yours.direction);
    return right_corners(wrong->record, c, view.corners) && (!view.is_ray || length > 0) &&
           is_near(view.yours.origin, view.right.origin, size) &&
           (is_near(view.yours.direction, view.right.direction, size) ||
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
    write_frame(plot, c.right, c.up, c.forward);
    plot_point(plot, "eye", c.origin);
    plot_fit(plot, c.origin, 0);
    write_plane(plot);
    if (view.is_ray) {
        bool moved = !is_same_place(yours.origin, right.origin);
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){ray_words(right, moved).s, ray_words(yours, moved).s,
                                   ray_off(right, yours).s, "dashed"});
        yours = as_long_as(yours, right);
    } else {
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){vec3_text(right.direction).s, vec3_text(yours.direction).s,
                                   beside_off(c, yours.direction - right.direction).s, "dashed"});
    }
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_name(plot, (Label){"$p$", "blue", .block = "eye"});
    beside_names(plot);
}

// ---- a ray in object coordinates ---------------------------------------------------------------

static double radius;

bool read_ray(Wrong *wrong)
{
    Ray ray;
    Sphere sphere;
    NUMBERS_GET(wrong->question, Ray, ray);
    NUMBERS_GET(wrong->question, Sphere, sphere);
    NUMBERS_GET(wrong->right, Ray, view.right);
    NUMBERS_GET(wrong->yours, Ray, view.yours);
    radius = sphere.radius;
    double size = radius + vec3_length(view.right.origin) + vec3_length(view.right.direction);
    return is_near(view.yours.origin, view.right.origin, size) &&
           is_near(view.yours.direction, view.right.direction, size);
}

void write_ray(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    Ray right = view.right, yours = view.yours;
    bool moved = !is_same_place(yours.origin, right.origin);
    // Seen from the side, with the sphere's centre not in front of the ray.
    vec3 along = vec3_unit(right.direction);
    vec3 up = -right.origin - vec3_dot(-right.origin, along) * along;
    if (vec3_length(up) < 1e-6 * (1 + vec3_length(right.origin)))
        up = vec3_cross(along, fabs(along[0]) < 0.6 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0));
    up = vec3_unit(up);
    vec3 center = vec3_of(0, 0, 0), aside = vec3_cross(along, up);
    plot_number(plot, "radius", radius);
    write_frame(plot, aside, up, along);
    plot_look(plot, aside, up, along, 16, 12);
    plot_point(plot, "center", center);
    plot_circle(plot, center, radius);
    plot_fit(plot, center, radius);
    plot_name(plot, (Label){"$C$ = (0, 0, 0)", "ink", .block = "center"});
    beside_names(plot);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){ray_words(right, true).s, ray_words(yours, true).s,
                               moved ? ray_off(right, yours).s : "", "dashed"});
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
}

// ---- a camera: ahead to the plane, its width, its height ---------------------------------------

static struct {
    Camera right, yours;
} cameras;

static bool is_drawable(Camera c, double size)
{
    return vec3_is_finite(c.origin) && vec3_is_finite(c.right) && vec3_is_finite(c.up) &&
           vec3_is_finite(c.forward) && fabs(c.distance) * vec3_length(c.forward) <= FAR * size &&
           fabs(c.width) * vec3_length(c.right) <= FAR * size &&
           fabs(c.height) * vec3_length(c.up) <= FAR * size;
}

bool read_camera(Wrong *wrong)
{
    CameraFault right = CAMERA_OK, yours = CAMERA_OK;
    if (strcmp(exercises[wrong->kept->exercise].results, "Camera") != 0) {
        NUMBERS_GET(wrong->right, CameraFault, right);
        NUMBERS_GET(wrong->yours, CameraFault, yours);
    }
    NUMBERS_GET(wrong->right, Camera, cameras.right);
    NUMBERS_GET(wrong->yours, Camera, cameras.yours);
    Camera c = cameras.right;
    double size = c.distance + c.width + c.height;
    return right == CAMERA_OK && yours == CAMERA_OK && is_drawable(cameras.yours, size) &&
           is_near(cameras.yours.origin, c.origin, size);
}

static void write_arms(Plot *plot, const char *name, Camera c)
{
    const vec3 arms[] = {c.distance * c.forward, c.width * c.right, c.height * c.up};
    plot_block(plot, name, "x y z of its start, x y z of the vector: d f, w r, h u");
    for (int i = 0; i < 3; i++) {
        plot_row_vector(plot, c.origin, arms[i]);
        plot_fit(plot, c.origin + arms[i], 0);
    }
    plot_block_end(plot);
    plot_fit(plot, c.origin, 0);
}

static void add_part(Text *words, const char *name, const char *value)
{
    size_t used = strlen(words->s);
    snprintf(words->s + used, sizeof words->s - used, "%s%s %s", used > 0 ? ", " : "", name, value);
}

static void compare_vectors(Text *right, Text *yours, const char *name, vec3 a, vec3 b)
{
    if (is_same_place(b, a))
        return;
    add_part(right, name, vec3_text_to(a, 4).s);
    add_part(yours, name, vec3_text_to(b, 4).s);
}

static void compare_numbers(Text *right, Text *yours, const char *name, double a, double b)
{
    if (fabs(a - b) <= 1e-9 * (1 + fabs(a)))
        return;
    add_part(right, name, number_text_to(a, 4).s);
    add_part(yours, name, number_text_to(b, 4).s);
}

// Only what differs.
void write_camera(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    Camera a = cameras.right, b = cameras.yours;
    Text right = {""}, yours = {""};
    compare_numbers(&right, &yours, "d", a.distance, b.distance);
    compare_numbers(&right, &yours, "w", a.width, b.width);
    compare_numbers(&right, &yours, "h", a.height, b.height);
    compare_vectors(&right, &yours, "eye", a.origin, b.origin);
    compare_vectors(&right, &yours, "r", a.right, b.right);
    compare_vectors(&right, &yours, "u", a.up, b.up);
    compare_vectors(&right, &yours, "f", a.forward, b.forward);
    write_frame(plot, a.right, a.up, a.forward);
    plot_look(plot, a.right, a.up, a.forward, 28, 16);
    plot_point(plot, "eye", a.origin);
    write_arms(plot, "answer", a);
    write_arms(plot, "yours", b);
    static const Label names[] = {
        {"$p$", "blue", .block = "eye"},
        {"$d f$", "pink", .block = "answer", .row = 0, .part = 1},
        {"$w r$", "orange", .block = "answer", .row = 1, .part = 1},
        {"$h u$", "green", .block = "answer", .row = 2, .part = 1},
    };
    plot_names(plot, names, sizeof names / sizeof *names);
    beside_below(plot, wrong->function, wrong->why, (BesideWords){right.s, yours.s, "", "dashed"});
}
