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

static Color by_vectors(Pixel pixel, void *given)
{
    const View *view = given;
    return through(view, view->camera, pixel);
}

static Color by_look_at(Pixel pixel, void *given)
{
    const View *view = given;
    Camera camera = view->camera;
    LookAt look_at = {camera.origin, view->scene.view.at, vec3_of(0, 1, 0), 13, 1};
    camera_from_look_at(look_at, RIGHT_HANDED, &camera);
    return through(view, camera, pixel);
}

static Color by_places(Pixel pixel, void *given)
{
    const View *view = given;
    Normalized place = screen_to_normalized(pixel_center(pixel), view->size);
    return seen_through(view, place.s - 0.5, place.t - 0.5);
}

static Color by_rays(Pixel pixel, void *given)
{
    const View *view = given;
    return seen_along(view, pixel_ray(view->camera, view->size, pixel).direction);
}

// ---- chapter 07 -------------------------------------------------------------------------------

// The hit that a pixel sees. False if there is none.
typedef struct {
    Ray ray;
    Hit hit;
    Sphere sphere;
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

static Surface surface_of(const View *view, const Seen *seen)
{
    return *scene_surface(&view->scene, seen->hit.sphere);
}

static Color direction_color(vec3 direction)
{
    return (vec3_unit(direction) + vec3_of(1, 1, 1)) / 2;
}

static Color normals(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    return see(view, pixel, &seen) ? direction_color(surface_normal(seen.sphere, seen.point))
                                   : view->scene.background;
}

static Color ways_to_light(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    return see(view, pixel, &seen)
               ? direction_color(ray_to_light(seen.point, view->light).direction)
               : view->scene.background;
}

static Color ambient(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    if (!see(view, pixel, &seen))
        return view->scene.background;
    Surface surface = surface_of(view, &seen);
    return ambient_term(surface.color, surface.diffuse, 5 * view->scene.ambient);
}

static Color diffuse_of(const View *view, const Seen *seen)
{
    Surface surface = surface_of(view, seen);
    return diffuse_term(surface.color, surface.diffuse, view->light.color,
                        surface_normal(seen->sphere, seen->point),
                        ray_to_light(seen->point, view->light).direction);
}

static Color diffuse(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    return see(view, pixel, &seen) ? diffuse_of(view, &seen) : view->scene.background;
}

static Color mirrored(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    return see(view, pixel, &seen)
               ? direction_color(
                     mirror_direction(seen.ray.direction, surface_normal(seen.sphere, seen.point)))
               : view->scene.background;
}

typedef Color Highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                        vec3 to_eye);

// As bright as the light, so that it is easily seen.
static Color highlight(const View *view, Pixel pixel, Highlight *term)
{
    Seen seen;
    if (!see(view, pixel, &seen))
        return view->scene.background;
    vec3 normal = surface_normal(seen.sphere, seen.point);
    vec3 to_light = ray_to_light(seen.point, view->light).direction;
    return diffuse_of(view, &seen) + term(1, surface_of(view, &seen).shine, view->light.color,
                                          normal, to_light, -seen.ray.direction);
}

static Color phong(Pixel pixel, void *given)
{
    return highlight(given, pixel, phong_term);
}

static Color halfway(Pixel pixel, void *given)
{
    return highlight(given, pixel, halfway_term);
}

static Color shadows(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    if (!see(view, pixel, &seen))
        return view->scene.background;
    vec3 normal = surface_normal(seen.sphere, seen.point);
    double light =
        visibility(&view->scene, off_surface(seen.sphere, seen.point, normal), view->light);
    return (0.2 + 0.8 * light) * surface_of(view, &seen).color;
}

static Color shaded(Pixel pixel, void *given)
{
    const View *view = given;
    Seen seen;
    return see(view, pixel, &seen) ? shade(&view->scene, seen.ray, seen.hit)
                                   : view->scene.background;
}

enum { MIRRORS = 5 };

static Color traced(Pixel pixel, void *given)
{
    const View *view = given;
    return trace_ray(&view->scene, pixel_ray(view->camera, view->size, pixel), MIRRORS);
}

static Color encoded(Pixel pixel, void *given)
{
    return gamma_encode(traced(pixel, given), 2.2);
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
static Color by_rectangles(Pixel pixel, void *given)
{
    const View *view = given;
    Color seen =
        seen_through(view, pixel.column / (SIDE - 1.0) - 0.5, 0.5 - pixel.row / (SIDE - 1.0));
    for (int i = 0; i < view->scene.sphere_count; i++)
        if (is_on_edge(sphere_rectangle(view->camera, view->size, view->scene.spheres[i]), pixel))
            seen = vec3_of(1, 1, 1);
    return seen;
}

// ---- all of them ------------------------------------------------------------------------------

static const struct {
    const char *name;
    Color (*color)(Pixel pixel, void *given);
} pictures[] = {
#define PICTURE(draws, name, ...) {name, draws},
#include "tests/course/pictures/pictures.def"
};

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
        if (strcmp(pictures[i].name, argv[3]) == 0)
            return picture_write(argv[4], view.size, pictures[i].color, &view);
    fprintf(stderr, "%s: no such picture\n", argv[3]);
    return EXIT_WRONG_USAGE;
}
