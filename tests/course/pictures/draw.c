// draw.c - draws the pictures of pictures.def by the answers that are linked with it.
//
// It is linked with a student's answers and, for missing answers, with the reference, if this tree
// has it (tests/course/answer_pictures.c). No answer is written here a second time. The pictures of
// the first chapters need later ones: the colour that the reference sees in each direction is
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

typedef struct {
    Resolution size;
    Camera camera; // the deck's, before the spheres
    Scene scene;
    Light light; // of the scene
    int recorded_side;
    unsigned char *recorded;
} View;

// ---- recorded colours -------------------------------------------------------------------------

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

// Through a place on the image plane: across and up from its middle, in its widths.
static Color seen_through(const View *view, double across, double up)
{
    double x = across / recorded_width + 0.5, y = 0.5 - up / recorded_width;
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
    return seen_through(view, widths * vec3_dot(direction, c->right),
                        widths * vec3_dot(direction, c->up));
}

// ---- chapters 01 to 04 ------------------------------------------------------------------------

// s and t go from edge to edge, so that the corners are in the picture.
static Color through(const View *view, Camera camera, Pixel pixel)
{
    return seen_along(view, image_plane_vector(camera, pixel.column / (SIDE - 1.0),
                                               1 - pixel.row / (SIDE - 1.0)));
}

static Color by_vectors(const View *view, Pixel pixel)
{
    return through(view, view->camera, pixel);
}

static Color by_look_at(const View *view, Pixel pixel)
{
    Camera camera = view->camera;
    LookAt look_at = {camera.origin, view->scene.view.at, vec3_of(0, 1, 0), 13, 1};
    camera_from_look_at(look_at, RIGHT_HANDED, &camera);
    return through(view, camera, pixel);
}

static Color by_places(const View *view, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), view->size);
    return seen_through(view, place.s - 0.5, place.t - 0.5);
}

static Color by_rays(const View *view, Pixel pixel)
{
    return seen_along(view, pixel_ray(view->camera, view->size, pixel).direction);
}

// ---- chapter 07 -------------------------------------------------------------------------------

// The hit that a pixel sees, and what is known there.
typedef struct {
    Ray ray;
    Hit hit;
    Sphere sphere;
    Surface surface;
    vec3 point;
} Seen;

static bool see(const View *view, Pixel pixel, Seen *seen)
{
    seen->ray = pixel_ray(view->camera, view->size, pixel);
    seen->hit = nearest_hit(seen->ray, &view->scene);
    if (seen->hit.sphere < 0 || seen->hit.sphere >= view->scene.sphere_count)
        return false;
    seen->sphere = view->scene.spheres[seen->hit.sphere];
    seen->point = seen->ray.origin + seen->hit.t * seen->ray.direction;
    return true;
}

// Without a hit the colour is the background's.
typedef Color ColorOfHit(const View *view, const Seen *seen);

static Color color_of_hit(const View *view, Pixel pixel, ColorOfHit *color)
{
    Seen seen;
    if (!see(view, pixel, &seen))
        return view->scene.background;
    seen.surface = *scene_surface(&view->scene, seen.hit.sphere);
    return color(view, &seen);
}

static vec3 normal_at(const Seen *seen)
{
    return surface_normal(seen->sphere, seen->point);
}

static vec3 to_light(const View *view, const Seen *seen)
{
    return ray_to_light(seen->point, view->light).direction;
}

static Color direction_color(vec3 direction)
{
    return (vec3_unit(direction) + vec3_of(1, 1, 1)) / 2;
}

static Color normals(const View *view, const Seen *seen)
{
    (void)view;
    return direction_color(normal_at(seen));
}

static Color ways_to_light(const View *view, const Seen *seen)
{
    return direction_color(to_light(view, seen));
}

static Color ambient(const View *view, const Seen *seen)
{
    return ambient_term(seen->surface.color, seen->surface.diffuse, 5 * view->scene.ambient);
}

static Color diffuse(const View *view, const Seen *seen)
{
    return diffuse_term(seen->surface.color, seen->surface.diffuse, view->light.color,
                        normal_at(seen), to_light(view, seen));
}

static Color mirrored(const View *view, const Seen *seen)
{
    (void)view;
    return direction_color(mirror_direction(seen->ray.direction, normal_at(seen)));
}

// Highlights are as bright as the light, so that they are easily seen.
static Color phong(const View *view, const Seen *seen)
{
    return diffuse(view, seen) + phong_term(1, seen->surface.shine, view->light.color,
                                            normal_at(seen), to_light(view, seen),
                                            -seen->ray.direction);
}

static Color halfway(const View *view, const Seen *seen)
{
    return diffuse(view, seen) + halfway_term(1, seen->surface.shine, view->light.color,
                                              normal_at(seen), to_light(view, seen),
                                              -seen->ray.direction);
}

static Color shadows(const View *view, const Seen *seen)
{
    vec3 start = off_surface(seen->sphere, seen->point, normal_at(seen));
    return (0.2 + 0.8 * visibility(&view->scene, start, view->light)) * seen->surface.color;
}

static Color shaded(const View *view, const Seen *seen)
{
    return shade(&view->scene, seen->ray, seen->hit);
}

enum { MIRRORS = 5 };

static Color traced(const View *view, Pixel pixel)
{
    return trace_ray(&view->scene, pixel_ray(view->camera, view->size, pixel), MIRRORS);
}

static Color encoded(const View *view, Pixel pixel)
{
    return gamma_encode(traced(view, pixel), 2.2);
}

// ---- chapter 08 -------------------------------------------------------------------------------

static bool is_on_edge(ScreenRectangle r, Pixel pixel)
{
    double x = pixel.column, y = pixel.row;
    bool across = x >= floor(r.left) && x <= floor(r.right);
    bool down = y >= floor(r.top) && y <= floor(r.bottom);
    return (across && (y == floor(r.top) || y == floor(r.bottom))) ||
           (down && (x == floor(r.left) || x == floor(r.right)));
}

// The colours are recorded, from edge to edge as in chapter 01.
static Color by_rectangles(const View *view, Pixel pixel)
{
    Color seen =
        seen_through(view, pixel.column / (SIDE - 1.0) - 0.5, 0.5 - pixel.row / (SIDE - 1.0));
    for (int i = 0; i < view->scene.sphere_count; i++)
        if (is_on_edge(sphere_rectangle(view->camera, view->size, view->scene.spheres[i]), pixel))
            seen = vec3_of(1, 1, 1);
    return seen;
}

// ---- all of them ------------------------------------------------------------------------------

static const struct Picture {
    const char *name;
    Color (*of_pixel)(const View *view, Pixel pixel);
    ColorOfHit *of_hit; // one of the two
} pictures[] = {
#define PICTURE(draws, name, ...) {name, draws, NULL},
#define PICTURE_OF_HIT(draws, name, ...) {name, NULL, draws},
#include "tests/course/pictures/pictures.def"
};

static const struct Picture *drawn;

static Color color_of_pixel(Pixel pixel, void *given)
{
    return drawn->of_pixel != NULL ? drawn->of_pixel(given, pixel)
                                   : color_of_hit(given, pixel, drawn->of_hit);
}

int main(int argc, char **argv)
{
    static View view = {.size = {SIDE, SIDE}};
    Message message;
    if (argc != 5) {
        fprintf(stderr, "Usage: %s SPHERES.nff RECORDED.png NAME PICTURE.png\n", argv[0]);
        return EXIT_WRONG_USAGE;
    }
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
            drawn = &pictures[i];
            return picture_write(argv[4], view.size, color_of_pixel, &view);
        }
    fprintf(stderr, "%s: no such picture\n", argv[3]);
    return EXIT_WRONG_USAGE;
}
