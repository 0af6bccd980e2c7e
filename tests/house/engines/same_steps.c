// same_steps.c - the steps of light in lanes have the bits of the chapters' functions; and
// functions that are different draw their own picture.
//
// Usage: same_steps [BATCHES]: random batches of 256 paths (100), in each kind of lanes: rays from
// outside and inside of spheres, lights before and behind them, all sizes. Then each of the
// functions that the lanes replace is changed a little, by the linker's --wrap, and the program
// must not use the lanes. The last line counts.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/light_steps.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int passed, failed;

static void verdict(const char *name, const char *what, bool right)
{
    passed += right;
    failed += !right;
    if (!right)
        printf("not ok: %s: %s\n", name, what);
}

// ---- the same bits ----------------------------------------------------------------------------

enum { SURFACES = 6, LIGHTS = 3 };
static unsigned long long state = 2017;

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

// Sizes of one batch: 10 to a power up to this.
static double size_of(double power)
{
    return pow(10, uniform(-power, power));
}

// Ray i meets sphere i nearly always, from outside or inside, in the middle or at the edge.
static void random_paths(Paths *paths, double power)
{
    paths->count = PATHS - (int)uniform(0, 20);
    for (int i = 0; i < paths->count; i++) {
        double radius = size_of(power);
        vec3 center = radius * size_of(2) * anywhere(1), from = center + radius * anywhere(0.5);
        vec3 to = center + radius * (uniform(0, 1) < 0.3 ? vec3_unit(anywhere(1)) : anywhere(0.6));
        if (uniform(0, 1) < 0.7)
            from = center + radius * size_of(2) * (anywhere(1) + vec3_of(3, 0, 0));
        if (i % 16 == 0) { // sometimes a root is 0, or both are the same
            radius = 1 + i / 16 % 3;
            center = vec3_of(i / 32 % 3, 0, 0);
            from = vec3_of(radius, (double)(i / 64), 0);
            to = from - vec3_of(1 - i / 16 % 2, i / 16 % 2, 0);
        }
        set_vector(&paths->center, i, center);
        set_vector(&paths->origin, i, from);
        set_vector(&paths->direction, i, size_of(power / 4) * (to - from));
        paths->radius[i] = radius;
        paths->surface[i] = (int)uniform(0, SURFACES);
    }
}

static bool same_vectors(const Vectors *one, const Vectors *other, int count)
{
    size_t size = (size_t)count * sizeof(double);
    return memcmp(one->x, other->x, size) == 0 && memcmp(one->y, other->y, size) == 0 &&
           memcmp(one->z, other->z, size) == 0;
}

static Surface surfaces[SURFACES];
static Light lights[LIGHTS];
static Scene scene = {.surfaces = surfaces,
                      .surface_count = SURFACES,
                      .lights = lights,
                      .light_count = LIGHTS,
                      .ambient = {0.1, 0.2, 0.05}};

static void random_light(double power)
{
    for (int i = 0; i < SURFACES; i++)
        surfaces[i] = (Surface){.color = anywhere(0.5) + 0.5,
                                .diffuse = uniform(0, 1),
                                .specular = i % 2 == 0 ? 0 : uniform(0, 1),
                                .shine = i % 3 == 0 ? 0 : size_of(2)};
    for (int i = 0; i < LIGHTS; i++)
        lights[i] = (Light){size_of(power) * anywhere(2), anywhere(0.5) + 0.5,
                            i == 2 ? LIGHT_DISTANT : LIGHT_POINT};
}

// Only lights that the sphere does not hide from itself may be said to arrive.
static void random_lit(const Paths *paths, double *lit)
{
    for (int k = 0; k < LIGHTS; k++)
        for (int i = 0; i < paths->count; i++) {
            Sphere sphere = {vector_of(&paths->center, i), paths->radius[i], 0};
            Scene alone = {.spheres = &sphere, .sphere_count = 1};
            lit[k * PATHS + i] = uniform(0, 1) < 0.7 &&
                                 visibility(&alone, vector_of(&paths->start, i), lights[k]) > 0;
        }
}

static void remove_misses(Paths *paths)
{
    int count = 0;
    for (int i = 0; i < paths->count; i++)
        if (paths->t[i] < NO_HIT) {
            set_vector(&paths->center, count, vector_of(&paths->center, i));
            set_vector(&paths->origin, count, vector_of(&paths->origin, i));
            set_vector(&paths->direction, count, vector_of(&paths->direction, i));
            paths->radius[count] = paths->radius[i];
            paths->surface[count] = paths->surface[i];
            paths->t[count++] = paths->t[i];
        }
    paths->count = count;
}

// The number of batches in which the lanes' test for extreme numbers was needed.
static int compare(const LightSteps *steps, const char *name, double power)
{
    static Paths one, other;
    static Vectors these, those;
    double lit[LIGHTS * PATHS];
    random_paths(&one, power);
    random_light(power);
    Picture picture = {.scene = &scene, .materials = materials_of(&scene)};
    other = one;
    steps_by_chapters.hits(&one);
    bool ordinary = steps->hits(&other);
    verdict(name, "hits",
            !ordinary || memcmp(one.t, other.t, (size_t)one.count * sizeof *one.t) == 0);
    remove_misses(&one);
    other = one;
    steps_by_chapters.leave(&one);
    steps->leave(&other);
    verdict(name, "leave",
            same_vectors(&one.point, &other.point, one.count) &&
                same_vectors(&one.normal, &other.normal, one.count) &&
                same_vectors(&one.start, &other.start, one.count));
    for (int i = 0; i < LIGHTS; i++) {
        steps_by_chapters.to_light(&one, &lights[i], &these);
        steps->to_light(&one, &lights[i], &those);
        verdict(name, "to_light", same_vectors(&these, &those, one.count));
    }
    steps_by_chapters.mirror(&one, &these);
    steps->mirror(&one, &those);
    verdict(name, "mirror", same_vectors(&these, &those, one.count));
    random_lit(&one, lit);
    steps_by_chapters.shade(&picture, &one, lit, &these);
    steps->shade(&picture, &one, lit, &those);
    verdict(name, "shade", same_vectors(&these, &those, one.count));
    steps_by_chapters.add_mirrors(&one.start, one.t, one.count, &these);
    steps->add_mirrors(&one.start, one.t, one.count, &those);
    verdict(name, "add_mirrors", same_vectors(&these, &those, one.count));
    free((void *)picture.materials);
    return !ordinary;
}

// Colours near the middle between two bytes, outside of 0 to 1, and not numbers.
static void compare_pixels(const LightSteps *steps, const char *name)
{
    enum { SAMPLES = 9 };
    static double color[SAMPLES * PATHS];
    static Vectors one, other;
    uint8_t these[3 * PATHS], those[3 * PATHS];
    double *const colors[3] = {color, color, color};
    for (int i = 0; i < SAMPLES * PATHS; i++)
        color[i] = i % 99 == 0 ? NAN : uniform(-0.3, 1.3);
    for (int samples = 1; samples <= SAMPLES; samples++) {
        steps_by_chapters.means(colors, samples, PATHS - samples, &one);
        steps->means(colors, samples, PATHS - samples, &other);
        verdict(name, "means", same_vectors(&one, &other, PATHS - samples));
    }
    for (int i = 0; i < PATHS; i++) {
        one.x[i] = (i + 0.5) / 255;
        one.y[i] = nextafter(one.x[i], i % 2);
        one.z[i] = color[i];
    }
    steps_by_chapters.bytes(&one, PATHS, these);
    steps->bytes(&one, PATHS, those);
    verdict(name, "bytes", memcmp(these, those, sizeof these) == 0);
}

// ---- other functions --------------------------------------------------------------------------

// The function that is changed; NULL: none.
static const char *changed;

static bool is_changed(const char *name)
{
    return changed != NULL && strcmp(changed, name) == 0;
}

Ray __real_pixel_ray(Camera camera, Resolution screen, Pixel pixel);
Ray __wrap_pixel_ray(Camera camera, Resolution screen, Pixel pixel);
Ray __wrap_pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    Ray ray = __real_pixel_ray(camera, screen, pixel);
    return is_changed("pixel_ray") ? (Ray){ray.origin, 1.5 * ray.direction} : ray;
}
double __real_hit_sphere(Ray ray, Sphere sphere);
double __wrap_hit_sphere(Ray ray, Sphere sphere);
double __wrap_hit_sphere(Ray ray, Sphere sphere)
{
    return __real_hit_sphere(ray, sphere) * (is_changed("hit_sphere") ? 1 + 1e-15 : 1);
}
vec3 __real_surface_normal(Sphere sphere, vec3 point);
vec3 __wrap_surface_normal(Sphere sphere, vec3 point);
vec3 __wrap_surface_normal(Sphere sphere, vec3 point)
{
    vec3 normal = __real_surface_normal(sphere, point);
    return is_changed("surface_normal") ? vec3_unit(normal + vec3_of(0, 0.1, 0)) : normal;
}
vec3 __real_off_surface(Sphere sphere, vec3 point, vec3 normal);
vec3 __wrap_off_surface(Sphere sphere, vec3 point, vec3 normal);
vec3 __wrap_off_surface(Sphere sphere, vec3 point, vec3 normal)
{
    vec3 start = __real_off_surface(sphere, point, normal);
    return is_changed("off_surface") ? point + 2 * (start - point) : start;
}
vec3 __real_mirror_direction(vec3 direction, vec3 normal);
vec3 __wrap_mirror_direction(vec3 direction, vec3 normal);
vec3 __wrap_mirror_direction(vec3 direction, vec3 normal)
{
    vec3 mirrored = __real_mirror_direction(direction, normal);
    return is_changed("mirror_direction") ? 2 * mirrored : mirrored;
}
Ray __real_ray_to_light(vec3 from, Light light);
Ray __wrap_ray_to_light(vec3 from, Light light);
Ray __wrap_ray_to_light(vec3 from, Light light)
{
    if (is_changed("ray_to_light"))
        light.position[0] += 0.1;
    return __real_ray_to_light(from, light);
}
Color __real_shade(const Scene *world, Ray ray, Hit hit);
Color __wrap_shade(const Scene *world, Ray ray, Hit hit);
// Blinn's highlights instead of Phong's; or a different constant.
Color __wrap_shade(const Scene *world, Ray ray, Hit hit)
{
    if (!is_changed("shade"))
        return __real_shade(world, ray, hit) * (is_changed("shade's constant") ? 0.9 : 1);
    Sphere sphere = world->spheres[hit.sphere];
    const Surface *surface = scene_surface(world, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
    normal = vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
    vec3 start = off_surface(sphere, point, normal);
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
Color __real_clamp_color(Color color);
Color __wrap_clamp_color(Color color);
Color __wrap_clamp_color(Color color)
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
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    Color color = shade(spheres, ray, hit);
    return depth > 0 && ks > 0 ? color + ks * trace(world, sample, mirrored, depth - 1) : color;
}

// A scene that shows every function's part: mirrors, highlights, shadows. whole: the linker changes
// all calls of the function, also those in solutions/07-shading.c, so the pictures can be compared.
static void compare_picture(const char *function, bool lanes_are_used, bool whole)
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
    Picture picture = {&world, materials_of(&world), camera, {96, 72}};
    const char *name = function == NULL ? "none changed" : function;
    verdict(name, "lanes are used", (steps_for(&picture) != &steps_by_chapters) == lanes_are_used);
    Work work = {&world, camera, &image, 2, NULL, NULL, false};
    Rendering rendering = {camera, image.size, style, trace};
    for (int i = 0; i < image.size.width * image.size.height; i++) {
        Pixel pixel = {i % image.size.width, i / image.size.width};
        image_set(&right, pixel, render_pixel(&rendering, &world, pixel));
    }
    verdict(name, "picture",
            engine_named("bvh")->light(&work, style, &message) &&
                (!whole || memcmp(image.rgb, right.rgb, (size_t)(3 * 48 * 36)) == 0));
    changed = NULL;
    free((void *)picture.materials);
    image_free(&image);
    image_free(&right);
}

int main(int argc, char **argv)
{
    static const LightSteps *const lanes[LANES_KINDS] = LANES_TABLE(light_steps);
    static const struct {
        const char *name;
        bool whole;
    } functions[] = {{"pixel_ray", true},   {"hit_sphere", true},       {"surface_normal", false},
                     {"off_surface", true}, {"mirror_direction", true}, {"ray_to_light", false},
                     {"shade", true},       {"shade's constant", true}, {"clamp_color", true}};
    int batches = argc > 1 ? atoi(argv[1]) : 100, extreme = 0;
    for (int kind = 0; kind <= (int)lanes_best(); kind++) {
        for (int i = 0; i < batches; i++)
            extreme += compare(lanes[kind], lanes_names[kind], i % 10 == 9 ? 100 : i % 10);
        compare_pixels(lanes[kind], lanes_names[kind]);
    }
    verdict("lanes", "extreme numbers were tried", extreme > 0);
    compare_picture(NULL, true, true);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        compare_picture(functions[i].name, false, functions[i].whole);
    printf("steps of light: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
