// figure_camera.c - a camera by its three steps from the eye: ahead to the plane, its width, its
// height.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

// ---- a camera: ahead to the plane, its width, its height ----------------------------------------

static struct {
    Camera right, yours;
} cameras;

static bool is_drawable(Camera c, double size)
{
    return vec3_is_finite(c.origin) && vec3_is_finite(c.right) && vec3_is_finite(c.up) &&
           vec3_is_finite(c.forward) &&
           fabs(c.distance) * vec3_length(c.forward) <= FIGURE_FAR * size &&
           fabs(c.width) * vec3_length(c.right) <= FIGURE_FAR * size &&
           fabs(c.height) * vec3_length(c.up) <= FIGURE_FAR * size;
}

bool read_camera(Wrong *wrong)
{
    CameraFault right = CAMERA_OK, yours = CAMERA_OK;
    if (strcmp(exercises[wrong->kept->exercise].results, "Camera") != 0) {
        WIRE_GET(wrong->right, CameraFault, right);
        WIRE_GET(wrong->yours, CameraFault, yours);
    }
    WIRE_GET(wrong->right, Camera, cameras.right);
    WIRE_GET(wrong->yours, Camera, cameras.yours);
    Camera c = cameras.right;
    double size = c.distance + c.width + c.height;
    return right == CAMERA_OK && yours == CAMERA_OK && is_drawable(cameras.yours, size) &&
           figure_near(cameras.yours.origin, c.origin, size);
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
    if (figure_same_place(b, a))
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
    figure_frame(plot, a.right, a.up, a.forward);
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
    beside_below(plot, wrong->function, wrong->why, (BesideWords){right.s, yours.s, ""});
}
