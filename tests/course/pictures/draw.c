// draw.c - draws the pictures of pictures.def by the answers that are linked with it.
//
// It is linked with a student's answers and, for missing answers, with the reference, if this tree
// has it (tests/course/answer_pictures.c). No answer is written here a second time. The pictures of
// the first chapters need later ones: the color that the reference sees in each direction is
// recorded, as a picture. It does not reveal an answer.
//
// Usage: draw SPHERES.nff RECORDED.png NAME PICTURE.png
#include "common/options.h"
#include "common/picture.h"
#include "common/scene.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"
#include "exercises/08-fast.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 360 }; // of a picture, in pixels

// Where answers are as they were judged, a variable that was never set must be wrong here too
// (tests/judge/message.h).
void fill_stack_with(int byte) __attribute__((weak));

typedef struct {
    Resolution size;
    Camera camera; // the deck's, before the spheres
    Scene scene;
    Light light; // of the scene
    int recorded_side;
    unsigned char *recorded;
} View;

// ---- recorded colors -------------------------------------------------------------------------

// The width of the recorded picture, in widths of the camera's image plane; its middle is the same.
static const double recorded_width = 2;

static bool read_recorded(const char *path, View *view)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&png, path))
        return false;
    png.format = PNG_FORMAT_RGB;
    view->recorded_side = (int)png.width;
    view->recorded = malloc(PNG_IMAGE_SIZE(png));
    return view->recorded != NULL && png.width == png.height &&
           png_image_finish_read(&png, NULL, view->recorded, 0, NULL) != 0;
}

static Color seen_through(const View *view, Normalized place)
{
    double x = (place.s - 0.5) / recorded_width + 0.5, y = 0.5 - (place.t - 0.5) / recorded_width;
    if (!(x >= 0 && x < 1 && y >= 0 && y < 1))
        return view->scene.background;
    size_t column = (size_t)(x * view->recorded_side), row = (size_t)(y * view->recorded_side);
    const unsigned char *rgb = view->recorded + 3 * (row * (size_t)view->recorded_side + column);
    return vec3_of(rgb[0], rgb[1], rgb[2]) / 255;
}

static Color seen_along(const View *view, vec3 direction)
{
    const Camera *c = &view->camera;
    double ahead = vec3_dot(direction, c->forward), widths = c->distance / c->width / ahead;
    if (!(ahead > 0))
        return view->scene.background;
    return seen_through(view, (Normalized){0.5 + widths * vec3_dot(direction, c->right),
                                           0.5 + widths * vec3_dot(direction, c->up)});
}

// ---- what the colors of pictures.def are made of -----------------------------------------------

// The camera of the pictures again, by a look-at.
static Camera looking_at(const View *view, CameraFault from_look_at(LookAt, Handedness, Camera *))
{
    Camera camera = view->camera;
    LookAt look_at = {camera.origin, view->scene.view.at, vec3_of(0, 1, 0), 13, 1};
    from_look_at(look_at, RIGHT_HANDED, &camera);
    return camera;
}

// The hit that a pixel sees, and what is known there.
typedef struct {
    Ray ray;
    Hit hit;
    Sphere sphere;
    Surface surface;
    vec3 point;
} Seen;

static bool sees(const View *view, Ray ray, Hit nearest(Ray, const Scene *), Seen *seen)
{
    Hit hit = nearest(ray, &view->scene);
    if (hit.sphere < 0 || hit.sphere >= view->scene.sphere_count)
        return false;
    *seen = (Seen){ray, hit, view->scene.spheres[hit.sphere],
                   *scene_surface(&view->scene, hit.sphere), ray.origin + hit.t * ray.direction};
    return true;
}

static Color direction_color(vec3 direction)
{
    return (vec3_unit(direction) + vec3_of(1, 1, 1)) / 2;
}

static bool is_on_edge(const View *view, Pixel pixel,
                       ScreenRectangle rectangle(Camera, Resolution, Sphere))
{
    double x = pixel.column, y = pixel.row;
    for (int i = 0; i < view->scene.sphere_count; i++) {
        ScreenRectangle r = rectangle(view->camera, view->size, view->scene.spheres[i]);
        bool across = x >= floor(r.left) && x <= floor(r.right);
        bool down = y >= floor(r.top) && y <= floor(r.bottom);
        if ((across && (y == floor(r.top) || y == floor(r.bottom))) ||
            (down && (x == floor(r.left) || x == floor(r.right))))
            return true;
    }
    return false;
}

// ---- all of them ------------------------------------------------------------------------------

#define PICTURE(name, function, shows, given, ...)                                                 \
    static Color picture_of_##function(const View *view, Pixel pixel)                              \
    {                                                                                              \
        Seen seen; /* which AT_HIT sets */                                                         \
        (void)seen;                                                                                \
        return __VA_ARGS__;                                                                        \
    }
#include "tests/course/pictures/pictures.def"

typedef Color ColorOfPixel(const View *view, Pixel pixel);
static const struct {
    const char *name;
    ColorOfPixel *color;
} pictures[] = {
#define PICTURE(name, function, ...) {name, picture_of_##function},
#include "tests/course/pictures/pictures.def"
};

static ColorOfPixel *drawn;

static Color color_of_pixel(Pixel pixel, void *given)
{
    return drawn(given, pixel);
}

int main(int argc, char **argv)
{
    static View view = {.size = {SIDE, SIDE}};
    Message message;
    if (argc != 5) {
        fprintf(stderr, "Usage: %s SPHERES.nff RECORDED.png NAME PICTURE.png\n", argv[0]);
        return EXIT_WRONG_USAGE;
    }
#ifndef __wasm__ // in a page it would take too long
    if (fill_stack_with != NULL)
        fill_stack_with(0xfe);
#endif
    if (!scene_load(argv[1], &view.scene, &message)) {
        fprintf(stderr, "%s\n", message.text);
        return EXIT_COULD_NOT;
    }
    if (!read_recorded(argv[2], &view)) {
        fprintf(stderr, "%s: cannot be read as a square PNG\n", argv[2]);
        return EXIT_COULD_NOT;
    }
    // In the world of NFF, which is right-handed.
    view.camera = (Camera){.origin = view.scene.view.from,
                           .right = vec3_of(1, 0, 0),
                           .up = vec3_of(0, 1, 0),
                           .forward = vec3_of(0, 0, -1),
                           .distance = 4,
                           .width = 2,
                           .height = 2};
    view.light = view.scene.lights[0];
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++)
        if (strcmp(pictures[i].name, argv[3]) == 0) {
            drawn = pictures[i].color;
            return picture_write(argv[4], view.size, color_of_pixel, &view);
        }
    fprintf(stderr, "%s: no such picture\n", argv[3]);
    return EXIT_WRONG_USAGE;
}
