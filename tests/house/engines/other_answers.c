// other_answers.c - shaded pictures by answers that are not the solutions.
//
// Each of the functions that the lanes replace (light_steps_lanes.c) is changed a little, by the
// linker's --wrap. The picture must be the one that the changed functions draw. The last line
// counts.
#include "chapters/08-fast/engines/engine.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SURFACES = 6, LIGHTS = 3 };
static Surface surfaces[SURFACES];
static Light lights[LIGHTS];
static Scene scene = {.surfaces = surfaces,
                      .surface_count = SURFACES,
                      .lights = lights,
                      .light_count = LIGHTS,
                      .ambient = {0.1, 0.2, 0.05}};

// The function that is changed; NULL: none.
static const char *changed;
static int failed;

static bool is_changed(const char *name)
{
    return changed != NULL && strcmp(changed, name) == 0;
}

// The linker calls the body instead of the function, which is __real_...
#define WRAP(result, name, ...)                                                                    \
    result __real_##name(__VA_ARGS__);                                                             \
    result __wrap_##name(__VA_ARGS__);                                                             \
    result __wrap_##name(__VA_ARGS__)

WRAP(Ray, pixel_ray, Camera camera, Resolution screen, Pixel pixel)
{
    Ray ray = __real_pixel_ray(camera, screen, pixel);
    return is_changed("pixel_ray") ? (Ray){ray.origin, 1.5 * ray.direction} : ray;
}

WRAP(double, hit_sphere, Ray ray, Sphere sphere)
{
    return __real_hit_sphere(ray, sphere) * (is_changed("hit_sphere") ? 1 + 1e-15 : 1);
}

WRAP(vec3, surface_normal, Sphere sphere, vec3 point)
{
    vec3 normal = __real_surface_normal(sphere, point);
    return is_changed("surface_normal") ? vec3_unit(normal + vec3_of(0, 0.1, 0)) : normal;
}

WRAP(vec3, offset_from_surface, Sphere sphere, vec3 point, vec3 normal)
{
    vec3 start = __real_offset_from_surface(sphere, point, normal);
    return is_changed("offset_from_surface") ? point + 2 * (start - point) : start;
}

WRAP(vec3, mirror_direction, vec3 direction, vec3 normal)
{
    vec3 mirrored = __real_mirror_direction(direction, normal);
    return is_changed("mirror_direction") ? 2 * mirrored : mirrored;
}

WRAP(Ray, ray_to_light, vec3 from, Light light)
{
    if (is_changed("ray_to_light"))
        light.position[0] += 0.1;
    return __real_ray_to_light(from, light);
}

// Blinn's highlights instead of Phong's; or a different constant.
WRAP(Color, shade, const Scene *world, Ray ray, Hit hit)
{
    if (!is_changed("shade"))
        return __real_shade(world, ray, hit) * (is_changed("shade's constant") ? 0.9 : 1);
    Sphere sphere = world->spheres[hit.sphere];
    const Surface *surface = scene_surface(world, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
    normal = vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
    vec3 start = offset_from_surface(sphere, point, normal);
    Color sum = ambient_term(surface->color, surface->diffuse, world->ambient);
    for (int i = 0; i < world->light_count; i++) {
        Color light = world->lights[i].color * visibility(world, start, world->lights[i]);
        vec3 to_light = ray_to_light(point, world->lights[i]).direction;
        sum += diffuse_term(surface->color, surface->diffuse, light, normal, to_light);
        sum += halfway_term(surface->specular, surface->shine, light, normal, to_light,
                            -ray.direction);
    }
    return sum;
}

WRAP(Color, clamp_color, Color color)
{
    return is_changed("clamp_color") ? color / (1 + color) : __real_clamp_color(color);
}

// trace_ray, with the functions as they are changed.
static Color trace(void *world, Pixel sample, Ray ray, int depth)
{
    (void)sample;
    const Scene *spheres = world;
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < spheres->sphere_count; i++) {
        double t = hit_sphere(ray, spheres->spheres[i]);
        if (t < hit.t)
            hit = (Hit){t, i};
    }
    if (hit.sphere < 0)
        return spheres->background;
    Sphere sphere = spheres->spheres[hit.sphere];
    double ks = scene_surface(spheres, hit.sphere)->specular;
    vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
    normal = vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
    Ray mirrored = {offset_from_surface(sphere, point, normal),
                    mirror_direction(ray.direction, normal)};
    Color color = shade(spheres, ray, hit);
    return depth > 0 && ks > 0 ? color + ks * trace(world, sample, mirrored, depth - 1) : color;
}

// A scene that shows every function's part: mirrors, highlights, shadows. whole: the linker changes
// all calls of the function, also those in solutions/07-shading.c, so the pictures can be compared.
static void compare_picture(const char *function, bool whole)
{
    static Sphere spheres[12];
    Message message;
    Image image, right;
    Camera camera = {
        vec3_of(0, 0, 9), vec3_of(1, 0, 0), vec3_of(0, 1, 0), vec3_of(0, 0, -1), 9, 8, 6};
    Style style = {.samples = 2, .depth = 2, .gamma = 1};
    for (int i = 0; i < 12; i++)
        spheres[i] = (Sphere){vec3_of(i % 4 * 2 - 3, i / 4 * 2 - 2, i % 3), 0.9, i % SURFACES};
    Scene world = scene;
    world.spheres = spheres;
    world.sphere_count = 12;
    lights[0] = (Light){vec3_of(5, 6, 9), vec3_of(1, 1, 1), LIGHT_POINT};
    lights[1] = (Light){vec3_of(-5, 6, 3), vec3_of(0.5, 0.5, 0.3), LIGHT_POINT};
    lights[2] = (Light){vec3_of(0, 1, 1), vec3_of(0.3, 0.3, 0.5), LIGHT_DISTANT};
    for (int i = 0; i < SURFACES; i++)
        surfaces[i] = (Surface){.color = vec3_of(0.9, 0.3 + 0.1 * i, 0.4),
                                .diffuse = 0.6,
                                .specular = 0.1 * i,
                                .shine = 20};
    if (!image_create(&image, (Resolution){48, 36}, &message) ||
        !image_create(&right, image.size, &message))
        exit(1);
    changed = function;
    Work work = {&world, camera, &image, 2, NULL, NULL};
    Rendering rendering = {camera, image.size, style, trace};
    for (int i = 0; i < image.size.width * image.size.height; i++) {
        Pixel pixel = {i % image.size.width, i / image.size.width};
        image_set(&right, pixel, render_pixel(&rendering, &world, pixel));
    }
    bool same = engine_named("bvh")->light(&work, style, &message) &&
                (!whole || memcmp(image.rgb, right.rgb, (size_t)(3 * 48 * 36)) == 0);
    if (!same)
        printf("not ok: %s changed: another picture\n", function == NULL ? "nothing" : function);
    failed += !same;
    changed = NULL;
    image_free(&image);
    image_free(&right);
}

int main(void)
{
    static const struct {
        const char *name;
        bool whole;
    } functions[] = {{"pixel_ray", true},
                     {"hit_sphere", true},
                     {"surface_normal", false},
                     {"offset_from_surface", true},
                     {"mirror_direction", true},
                     {"ray_to_light", false},
                     {"shade", true},
                     {"shade's constant", true},
                     {"clamp_color", true}};
    enum { COUNT = sizeof functions / sizeof *functions };
    compare_picture(NULL, true);
    for (int i = 0; i < COUNT; i++)
        compare_picture(functions[i].name, functions[i].whole);
    printf("other answers: %d passed, %d failed\n", COUNT + 1 - failed, failed);
    return failed > 0;
}
