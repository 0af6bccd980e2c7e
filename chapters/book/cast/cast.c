// cast.c - a scene, cast tile by tile by the answers that are linked: a program that stays, and
// that a Worker calls (cast_worker.js).
//
// Its scene is the file scene.nff. Messages go to stderr, the story of a pixel to stdout.
#include "chapters/06-ray-casting/explain.h"
#include "chapters/07-shading/explain_light.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/light.h"
#include "chapters/08-fast/engines/questions.h"
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "common/story.h"
#include "common/text.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORTED(name) __attribute__((export_name(#name)))

// With fewer spheres chapter 07's trace_ray casts, ray by ray.
#define MANY 60

static Scene scene;
static Image image;         // the whole picture that was cast last
static LightPicture *light; // of this scene
static Work work;
static uint8_t *pixels; // red, green, blue, opacity: what a canvas takes

// ---- the scene ---------------------------------------------------------------------------------

static void forget(void)
{
    light_picture_free(light);
    light = NULL;
    scene_free(&scene);
}

// The viewpoint: from, at, up, angle. The page reads and writes it.
EXPORTED(view) double *view(void);
static double numbers[10];
double *view(void)
{
    return numbers;
}

// False: the message says what is wrong.
EXPORTED(open_scene) bool open_scene(void);
bool open_scene(void)
{
    Message message;
    forget();
    if (!scene_load("scene.nff", &scene, &message)) {
        fprintf(stderr, "%s\n", message.text);
        return false;
    }
    for (int i = 0; i < 3; i++) {
        numbers[i] = scene.view.from[i];
        numbers[3 + i] = scene.view.at[i];
        numbers[6 + i] = scene.view.up[i];
    }
    numbers[9] = scene.view.angle;
    return true;
}

static bool find_camera(Resolution screen, Camera *camera)
{
    scene.view.from = vec3_of(numbers[0], numbers[1], numbers[2]);
    scene.view.at = vec3_of(numbers[3], numbers[4], numbers[5]);
    scene.view.up = vec3_of(numbers[6], numbers[7], numbers[8]);
    scene.view.angle = numbers[9];
    CameraFault fault = scene_camera(&scene.view, screen, camera);
    if (fault != CAMERA_OK)
        fprintf(stderr, "this is not a camera: %s\n", camera_fault_text(fault));
    return fault == CAMERA_OK;
}

// ---- a tile ------------------------------------------------------------------------------------

typedef struct {
    Rendering rendering;
    int left, top, right, bottom; // its columns and rows
} Tile;

static void set_pixel(const Tile *tile, int column, int row, Color color)
{
    uint8_t *pixel =
        pixels + 4 * ((row - tile->top) * (tile->right - tile->left) + column - tile->left);
    for (int i = 0; i < 3; i++)
        pixel[i] = byte_from_color(color[i]);
    pixel[3] = 255;
}

static void by_trace_ray(const Tile *tile)
{
    for (int row = tile->top; row < tile->bottom; row++)
        for (int column = tile->left; column < tile->right; column++) {
            Pixel pixel = {column, row};
            set_pixel(tile, column, row, render_pixel(&tile->rendering, &scene, pixel));
        }
}

// Chapter 08's engine paints a tile into the image.
static bool by_hierarchy(const Tile *tile)
{
    Message message;
    Resolution screen = tile->rendering.screen;
    if (image.size.width != screen.width || image.size.height != screen.height) {
        image_free(&image);
        if (!image_create(&image, screen, &message))
            return false;
    }
    work = (Work){.scene = &scene, .camera = tile->rendering.camera, .image = &image, .threads = 1};
    if (light == NULL && (light = light_picture_build(&scene)) == NULL)
        return false;
    light_picture_look(light, &work, tile->rendering.style, false);
    return light_picture_paint(light, tile->left, tile->top, tile->right, tile->bottom);
}

static void copy(const Tile *tile)
{
    for (int row = tile->top; row < tile->bottom; row++)
        for (int column = tile->left; column < tile->right; column++) {
            const uint8_t *rgb = image_bytes(&image, (Pixel){column, row});
            set_pixel(tile, column, row, vec3_of(rgb[0], rgb[1], rgb[2]) / 255);
        }
}

static bool is_extreme(const Tile *tile)
{
    Image whole = {.size = tile->rendering.screen};
    Work asked = {.scene = &scene, .camera = tile->rendering.camera, .image = &whole};
    return extreme_light(&asked);
}

// ---- a whole picture in flat colors: the two orders of chapter 06, and chapter 08's engines ----

static bool by_order(const Tile *tile, const char *order)
{
    Message message;
    Resolution size = tile->rendering.screen;
    Camera camera = tile->rendering.camera;
    image_free(&image);
    double *depth = malloc(sizeof *depth * (size_t)size.width * (size_t)size.height);
    const Engine *engine = engine_named(order);
    work = (Work){.scene = &scene, .camera = camera, .image = &image, .threads = 1};
    bool ready = depth != NULL && image_create(&image, size, &message);
    if (ready && engine != NULL)
        ready = engine->cast(&work, &message);
    else if (ready && strcmp(order, "object order") == 0)
        cast_object_order(&scene, camera, &image, depth);
    else if (ready)
        cast_image_order(&scene, camera, &image);
    free(depth);
    return ready;
}

// ---- a race: how often each pixel is asked, and when it is painted ------------------------------

// Only a program for races is linked so that these two are called (tools.js).
Ray __real_pixel_ray(Camera camera, Resolution screen, Pixel pixel);
Ray __wrap_pixel_ray(Camera camera, Resolution screen, Pixel pixel);
Ray __wrap_pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    bool is_inside = pixel.column >= 0 && pixel.column < questions.width && pixel.row >= 0 &&
                     pixel.row < questions.height;
    questions.pixel = is_inside ? pixel.row * questions.width + pixel.column : 0;
    return __real_pixel_ray(camera, screen, pixel);
}

double __real_hit_sphere(Ray ray, Sphere sphere);
double __wrap_hit_sphere(Ray ray, Sphere sphere);
double __wrap_hit_sphere(Ray ray, Sphere sphere)
{
    ray_is_asked();
    return __real_hit_sphere(ray, sphere);
}

static float *painted; // in milliseconds since casting began; 0: not by image_set
static double began;

static void note_time(const Image *of, Pixel pixel, void *watcher)
{
    (void)watcher;
    painted[image_index(of, pixel)] = (float)(1e3 * (clock_seconds() - began));
}

// Before a picture is cast. Returns where there will be, for each pixel, how often it was asked;
// and after these numbers, when it was painted last. NULL: there is not enough memory.
EXPORTED(begin_race) unsigned *begin_race(int width, int height);
unsigned *begin_race(int width, int height)
{
    size_t count = (size_t)width * (size_t)height;
    free(questions.counts);
    questions =
        (Questions){calloc(count, sizeof *questions.counts + sizeof *painted), width, height, 0};
    painted = (float *)(questions.counts + count);
    image_watch(questions.counts != NULL ? note_time : NULL, NULL);
    began = clock_seconds();
    return questions.counts;
}

// ---- what the page calls -----------------------------------------------------------------------

// Who casts: an engine, "image order" or "object order"; empty: chapter 07's light. The page writes
// it.
EXPORTED(caster) char *caster(void);
static char caster_name[40];
char *caster(void)
{
    return caster_name;
}

// Casts the columns left to right - 1 and the rows top to bottom - 1 of a picture. NULL: there is
// no such picture; a message says why, unless the reason is a lack of memory.
EXPORTED(cast)
const uint8_t *cast(int width, int height, int samples, int depth, int left, int top, int right,
                    int bottom);
const uint8_t *cast(int width, int height, int samples, int depth, int left, int top, int right,
                    int bottom)
{
    Tile tile = {{.screen = {width, height}, .style = {samples, depth, 1}, .trace = trace_scene},
                 left,
                 top,
                 right,
                 bottom};
    free(pixels);
    pixels = malloc(4 * (size_t)(right - left) * (size_t)(bottom - top));
    if (pixels == NULL || !find_camera(tile.rendering.screen, &tile.rendering.camera))
        return NULL;
    bool by_light = caster_name[0] == '\0';
    if (by_light && (scene.sphere_count < MANY || is_extreme(&tile)))
        by_trace_ray(&tile);
    else if (by_light ? by_hierarchy(&tile) : by_order(&tile, caster_name))
        copy(&tile);
    else
        return NULL;
    return pixels;
}

// The rays that mirrors send on, as trace_ray follows them.
static void tell_mirrors(const Scene *in, Ray ray, Hit hit, int depth)
{
    for (int i = 1; i <= depth && hit.sphere >= 0; i++) {
        Sphere sphere = in->spheres[hit.sphere];
        if (!(scene_surface(in, hit.sphere)->specular > 0))
            return;
        vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
        if (vec3_dot(normal, ray.direction) > 0) // from inside
            normal = -normal;
        ray = (Ray){offset_from_surface(sphere, point, normal),
                    mirror_direction(ray.direction, normal)};
        hit = nearest_hit(ray, in);
        bool meets = hit.sphere >= 0;
        story_segment("mirror", ray.origin, ray.origin + (meets ? hit.t : 1) * ray.direction);
        story_heading("Mirrored ray %d", i);
        story_by("mirror_direction");
        story_line("direction", "%s", vec3_text(ray.direction).s);
        story_by("nearest_hit");
        if (meets)
            story_line("meets sphere", "%c, t = %s", 'A' + hit.sphere % 26, number_text(hit.t).s);
        else
            story_line("meets nothing", "the background, %s", vec3_text(in->background).s);
    }
}

// Prints the story of a pixel, from its column and row to its color, by the functions that are
// linked.
EXPORTED(explain_pixel) bool explain_pixel(int width, int height, int depth, int column, int row);
bool explain_pixel(int width, int height, int depth, int column, int row)
{
    Shot shot = {.scene = &scene, .size = {width, height}, .pixel = {column, row}};
    if (!find_camera(shot.size, &shot.camera))
        return false;
    story_is_for_page = true;
    explain(&shot, "scene.nff");
    explain_light(&scene, shot.camera, shot.size, shot.pixel, depth, tell_mirrors);
    return fflush(stdout) == 0;
}
