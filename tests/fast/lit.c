// lit.c - shadows and mirrors through the hierarchy are chapter 07's, on scenes that are awkward,
// and on random ones.
//
// Usage: lit [SCENES [FIRST]]: so many random scenes, from number FIRST on (60, 1). Of each, what
// every pixel's ray sees is compared to the last digit; and a picture of few samples, with one
// thread and with three, to the byte. The last line counts.
#include "chapters/06-ray-casting/scene_camera.h"
#include "chapters/08-fast/engine.h"
#include "chapters/08-fast/few.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 120, LIGHTS = 3 };

static int passed, failed, depth;
static Sphere spheres[MOST];
static Surface surfaces[MOST];
static Light lights[LIGHTS];
static Scene scene = {.spheres = spheres, .surfaces = surfaces, .lights = lights};

// ---- scenes -----------------------------------------------------------------------------------

static unsigned long long state;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

static vec3 anywhere(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size);
    return vec3_of(x, y, uniform(-size, size));
}

// Every sphere has a colour of its own, so that one taken for another shows; two of three mirror.
static void add(vec3 center, double radius)
{
    int i = scene.sphere_count;
    if (i == MOST)
        return;
    Color color = vec3_of((i % 7 + 1) / 7.0, (i / 7 % 7 + 1) / 7.0, (i / 49 % 9 + 1) / 9.0);
    surfaces[i] = (Surface){.color = color, .diffuse = 0.5, .specular = i % 3 / 3.0, .shine = 7};
    spheres[i] = (Sphere){center, radius, i};
    scene.sphere_count = scene.surface_count = i + 1;
}

static void light_up(vec3 position, LightKind kind)
{
    int i = scene.light_count++;
    lights[i] = (Light){position, vec3_of(0.7 - 0.2 * i, 0.5, 0.3 + 0.2 * i), kind};
}

static void look_from(vec3 from, vec3 at, double angle)
{
    scene.sphere_count = scene.surface_count = scene.light_count = 0;
    scene.view = (Viewpoint){from, at, vec3_of(0, 1, 0), angle, {31, 23}};
    scene.background = vec3_of(0.1, 0.2, 0.3);
    scene.ambient = vec3_of(0.1, 0.1, 0.1);
    depth = 5;
}

static void heap(vec3 at, double size, int count, double radius)
{
    for (int i = 0; i < count; i++)
        add(at + anywhere(size), radius * uniform(0.3, 1));
}

static const vec3 front = {0, 0, 5}, middle = {0, 0, 0}, above = {3, 9, 6};

static void nothing(void)
{
    look_from(front, middle, 60);
    light_up(above, LIGHT_POINT);
}
static void no_light(void)
{
    look_from(front, middle, 60);
    heap(middle, 1.5, 30, 0.5);
}
static void inside(void)
{
    look_from(front, middle, 90);
    light_up(above, LIGHT_POINT);
    light_up(vec3_of(1, 1, 3), LIGHT_POINT);
    add(middle, 30);
    add(front, 1);
    add(front, 2);
    heap(middle, 4, 30, 1);
}
static void tangent(void)
{
    look_from(front, middle, 70);
    light_up(vec3_of(0, 1, 0), LIGHT_DISTANT);
    light_up(vec3_of(0, 4, 0), LIGHT_POINT);
    for (int i = 0; i < 64; i++)
        add(vec3_of(i % 4 - 1.5, i / 4 % 4 - 1.5, -(i / 16)), 0.5);
}
static void coincident(void)
{
    look_from(front, middle, 60);
    light_up(above, LIGHT_POINT);
    light_up(vec3_of(-2, 1, 1), LIGHT_DISTANT);
    for (int i = 0; i < 12; i++) {
        vec3 there = anywhere(1.5);
        for (int k = 0; k < 6; k++)
            add(there, 0.7);
    }
}
static void facing_mirrors(void)
{
    look_from(vec3_of(0, 0.3, 1), vec3_of(0, 0, -3), 80);
    light_up(vec3_of(0.3, 1.5, 0), LIGHT_POINT);
    for (int i = 0; i < 6; i++)
        add(vec3_of(0, 0, i % 2 == 0 ? -1003 : 1003), 1000);
    heap(middle, 2, 20, 0.4);
}
static void light_in_a_sphere(void)
{
    look_from(front, middle, 60);
    light_up(vec3_of(0.5, 0.5, 0), LIGHT_POINT);
    light_up(above, LIGHT_POINT);
    add(vec3_of(0.5, 0.5, 0), 0.4);
    add(above, 30);
    heap(middle, 2, 30, 0.6);
}

// Where the ray of a pixel leaves the surface again; not a number where it meets nothing.
static Ray leaves_at(Pixel pixel)
{
    Camera camera;
    scene_camera(&scene.view, scene.view.resolution, &camera);
    Ray ray = pixel_ray(camera, scene.view.resolution, pixel);
    Hit hit = nearest_hit(ray, &scene);
    if (hit.sphere < 0)
        return (Ray){vec3_of(NAN, NAN, NAN), ray.direction};
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(spheres[hit.sphere], point);
    return (Ray){off_surface(spheres[hit.sphere], point, normal),
                 mirror_direction(ray.direction, normal)};
}

static void light_on_a_surface(void)
{
    look_from(front, middle, 60);
    add(middle, 1);
    add(vec3_of(2, 0, 0), 1);
    add(vec3_of(0, 2.25, 0), 0.25);
    light_up(vec3_of(1, 0, 0), LIGHT_POINT);
    light_up(vec3_of(0, 2, 0), LIGHT_POINT);
    // A light at the very place from which it is looked for.
    light_up(leaves_at((Pixel){15, 11}).origin, LIGHT_POINT);
}
static void far_from_the_origin(void)
{
    vec3 there = vec3_of(1e7, -3e7, 2e7);
    look_from(there + front, there, 60);
    light_up(there + above, LIGHT_POINT);
    light_up(middle, LIGHT_POINT);
    light_up(above, LIGHT_DISTANT);
    heap(there, 2, 50, 0.6);
}
static void on_huge_ground(void)
{
    look_from(vec3_of(0, 1, 5), middle, 70);
    light_up(above, LIGHT_DISTANT);
    light_up(vec3_of(-1, 2, 1), LIGHT_POINT);
    light_up(vec3_of(1e9, 1e9, 1e9), LIGHT_POINT);
    add(vec3_of(0, -1e9, 0), 1e9 - 1);
    add(vec3_of(0, -1e6, 0), 1e6 - 1);
    heap(middle, 2, 40, 0.5);
    add(vec3_of(0, 1e12, 0), 1e11);
}

// A sphere that a ray touches: so nearly that rounding decides whether it is hit.
static void graze(Ray ray, double distance, double radius)
{
    vec3 along = vec3_unit(ray.direction),
         aside = uniform(0, 1) < 0.5 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0);
    aside = vec3_unit(aside - vec3_dot(aside, along) * along) * (uniform(0, 1) < 0.5 ? 1 : -1);
    double beside = radius + uniform(-4e-16, 4e-16) * distance;
    if (vec3_is_finite(ray.origin))
        add(ray.origin + distance * along + beside * aside, radius);
}
static Pixel some_pixel(void)
{
    return (Pixel){(int)uniform(0, 31), (int)uniform(0, 23)};
}
static void grazing_the_view(void)
{
    double far = pow(10, uniform(0, 7));
    look_from(vec3_of(0, 0, far), middle, 4 / far);
    light_up(vec3_of(1, 2, 3), LIGHT_DISTANT);
    Camera camera;
    scene_camera(&scene.view, scene.view.resolution, &camera);
    for (int i = 0; i < MOST; i++)
        graze(pixel_ray(camera, scene.view.resolution, some_pixel()), far * uniform(0.5, 1),
              pow(10, uniform(-6, -1)));
}
static void grazing_the_light(void)
{
    look_from(front, middle, 20);
    light_up(vec3_of(1e-8, -2e-8, 1), LIGHT_DISTANT);
    light_up(vec3_of(-0.1, 0.2, 1e7), LIGHT_POINT);
    depth = 1;
    add(vec3_of(0, 0, -50), 50);
    add(vec3_of(0, 0, -50), 50.01);
    while (scene.sphere_count < MOST) {
        Ray away = leaves_at(some_pixel());
        double distance = pow(10, uniform(1, 7)), radius = pow(10, uniform(-6, -1));
        int way = (int)uniform(0, 3);
        graze(way == 2 ? away : ray_to_light(away.origin, lights[way]), distance, radius);
    }
}

static const struct {
    const char *name;
    void (*make)(void);
    int times;
} awkward[] = {{"nothing", nothing, 1},
               {"no light", no_light, 1},
               {"inside", inside, 1},
               {"tangent", tangent, 1},
               {"coincident", coincident, 5},
               {"mirrors that face each other", facing_mirrors, 1},
               {"a light in a sphere", light_in_a_sphere, 1},
               {"a light on a surface", light_on_a_surface, 1},
               {"far from the origin", far_from_the_origin, 1},
               {"on a huge ground", on_huge_ground, 1},
               {"grazing the view", grazing_the_view, 10},
               {"grazing the light", grazing_the_light, 10}};

static void at_random(unsigned number)
{
    state = number * 7919ULL + 1;
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
    look_from(anywhere(3), anywhere(1), uniform(20, 130));
    scene.view.up = vec3_of(0.1, 1, 0.2);
    for (int i = (int)uniform(1, LIGHTS + 1); i > 0; i--)
        light_up(anywhere(5), uniform(0, 1) < 0.5 ? LIGHT_POINT : LIGHT_DISTANT);
    heap(middle, 2, (int)pow(MOST, uniform(0, 1)), pow(10, uniform(-1.5, 0.3)));
    depth = (int)uniform(0, 6);
}

// ---- comparing --------------------------------------------------------------------------------

static void verdict(const char *name, const char *what, int different, int of)
{
    if (different == 0) {
        passed++;
        return;
    }
    failed++;
    printf("not ok: %s: %s: %d of %d differ\n", name, what, different, of);
}

static void compare_rays(const char *name, Camera camera)
{
    Resolution screen = scene.view.resolution;
    Hierarchy hierarchy;
    Few few;
    if (!hierarchy_build(&hierarchy, &scene) || !few_begin(&few, &hierarchy, &scene, depth))
        exit(1);
    int different = 0, count = screen.width * screen.height;
    for (int i = 0; i < count; i++) {
        Ray ray = pixel_ray(camera, screen, (Pixel){i % screen.width, i / screen.width});
        Color all = trace_ray(&scene, ray, depth), by_few = trace_few(&few, ray, depth);
        different += memcmp(&all, &by_few, 3 * sizeof(double)) != 0;
    }
    verdict(name, "rays", different, count);
    few_end(&few);
    hierarchy_free(&hierarchy);
}

static void compare_pictures(const char *name, Camera camera, Style style)
{
    Resolution small = {scene.view.resolution.width / 2, scene.view.resolution.height / 2};
    Message message;
    Image right, image;
    if (!image_create(&right, small, &message) || !image_create(&image, small, &message))
        exit(1);
    render(&scene, camera, style, &right);
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        for (int threads = 1; threads <= 3 && engine->light != NULL; threads += 2) {
            Work work = {&scene, camera, &image, threads, NULL};
            char what[60];
            snprintf(what, sizeof what, "%s, %d threads, bytes", engine->name, threads);
            int different = engine->light(&work, style, &message) ? 0 : 1;
            for (int i = 0; i < 3 * small.width * small.height; i++) {
                different += image.rgb[i] != right.rgb[i];
                image.rgb[i] = (uint8_t)~image.rgb[i];
            }
            verdict(name, what, different, 3 * small.width * small.height);
        }
    image_free(&right);
    image_free(&image);
}

static void try_scene(const char *name, bool pictures)
{
    Camera camera;
    if (scene_camera(&scene.view, scene.view.resolution, &camera) != CAMERA_OK)
        return; // a random view along up
    compare_rays(name, camera);
    if (pictures)
        compare_pictures(name, camera, (Style){.samples = 2, .depth = depth, .gamma = 2.2});
}

int main(int argc, char **argv)
{
    int random = argc > 1 ? atoi(argv[1]) : 60, first = argc > 2 ? atoi(argv[2]) : 1;
    for (size_t i = 0; i < sizeof awkward / sizeof awkward[0]; i++)
        for (int k = 0; k < awkward[i].times; k++) {
            awkward[i].make();
            try_scene(awkward[i].name, k == 0);
        }
    for (int i = first; i < first + random; i++) {
        char name[40];
        snprintf(name, sizeof name, "random scene %d", i);
        at_random((unsigned)i);
        try_scene(name, i % 4 == 0);
    }
    printf("shading engines: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
