// same_shading.c - shadows and mirrors through the hierarchy are chapter 07's, on scenes that are
// awkward, and on random ones; and the grid of a light leaves out no sphere that hides the light.
//
// Usage: same_shading [SCENES [FIRST [FAR]]]: SCENES random scenes, from number FIRST on (100, 1),
// and FAR (100) whose numbers are far apart. Of each, the colour that every pixel's ray sees is
// compared to the last digit; and a picture of few samples, with one thread and with three, to the
// byte. Of the far ones also the flat picture of every engine. Shadows alone, of 60 scenes, if
// FIRST is 1. The last line counts.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/light.h"
#include "chapters/shared/scene_camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/07-shading.h"
#include "tests/house/engines/compare_engines.h"
#include "tests/house/engines/test_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void verdict(const char *name, const char *what, int different, int of)
{
    if (different == 0) {
        passed++;
        return;
    }
    failed++;
    printf("not ok: %s: %s: %d of %d differ\n", name, what, different, of);
}

static int differ(LightPaths *all, const Ray *rays, const Color *right, int count)
{
    int different = 0;
    all->paths.count = count;
    for (int i = 0; i < count; i++) {
        set_vector(&all->paths.origin, i, rays[i].origin);
        set_vector(&all->paths.direction, i, rays[i].direction);
    }
    path_colors(all, false);
    for (int i = 0; i < count; i++) {
        Color color = vector_of(all->colors, i);
        different += memcmp(&right[i], &color, 3 * sizeof(double)) != 0;
    }
    return different;
}

// By the lanes of each kind, and by the chapters' functions.
static void compare_rays(const char *name, Camera camera)
{
    enum { MOST = 1200 };
    static Ray rays[MOST];
    static Color right[MOST];
    static int columns[MOST], rows[MOST];
    Resolution screen = lit_scene.view.resolution;
    LightWorld world = {
        .scene = &lit_scene, .camera = camera, .samples = screen, .depth = lit_depth};
    if (!light_world_build(&world))
        exit(1);
    lanes_at_most = LANES_AVX512;
    const int count = screen.width * screen.height;
    for (int i = 0; i < count && count <= MOST; i++) {
        columns[i] = i % screen.width;
        rows[i] = i / screen.width;
        rays[i] = pixel_ray(camera, screen, (Pixel){columns[i], rows[i]});
        right[i] = trace_ray(&lit_scene, rays[i], lit_depth);
    }
    const int best = (int)lanes_best();
    for (int kind = 0; kind <= best + 1; kind++) {
        lanes_at_most = kind > best ? LANES_AVX512 : (LanesKind)kind;
        const LightSteps *steps = kind > best
                                      ? &steps_by_chapters
                                      : steps_for(&world, columns, rows, count <= MOST ? count : 0);
        LightPaths *paths = light_paths_create(&world, steps);
        if (paths == NULL)
            exit(1);
        char what[40];
        snprintf(what, sizeof what, "rays, %s", kind > best ? "chapters" : lanes_names[kind]);
        if (kind <= best)
            verdict(name, "steps in lanes", steps == &steps_by_chapters, 1);
        int different = count > MOST;
        for (int first = 0; first < count; first += PATHS)
            different += differ(paths, rays + first, right + first,
                                count - first < PATHS ? count - first : PATHS);
        verdict(name, what, different, count);
        free(paths);
    }
    light_world_free(&world);
}

static int different_bytes(const Image *right, const Image *image)
{
    int different = 0;
    for (int i = 0; i < 3 * right->size.width * right->size.height; i++) {
        different += image->rgb[i] != right->rgb[i];
        image->rgb[i] = (uint8_t)~image->rgb[i];
    }
    return different;
}

// By 1 and by 3 threads, and with all kinds of lanes; by plain once.
static void compare_pictures(const char *name, Camera camera, Style style, bool all_kinds)
{
    const int n = style.samples, best = (int)lanes_best(), first = all_kinds ? 0 : best;
    Resolution small = {lit_scene.view.resolution.width / n, lit_scene.view.resolution.height / n};
    Message message;
    Image right, image;
    if (!image_create(&right, small, &message) || !image_create(&image, small, &message))
        exit(1);
    render(&lit_scene, camera, style, &right);
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        for (int kind = engine == &engines[0] ? best : first; kind <= best; kind++)
            for (int threads = 1; threads <= 3 && engine->light != NULL; threads += 2) {
                if (engine == &engines[0] && threads == 1)
                    continue; // as chapter 07
                lanes_at_most = (LanesKind)kind;
                Work work = {&lit_scene, camera, &image, threads, NULL, NULL};
                char what[60];
                snprintf(what, sizeof what, "%s, %s, %d threads, bytes", engine->name,
                         lanes_names[kind], threads);
                bool done = engine->light(&work, style, &message);
                verdict(name, what, done ? different_bytes(&right, &image) : 1,
                        3 * small.width * small.height);
            }
    lanes_at_most = LANES_AVX512;
    image_free(&right);
    image_free(&image);
}

// The flat pictures of all engines.
static void compare_flat(const char *name, Camera camera)
{
    static const int threads[] = {1, 3, 0};
    Message message;
    Image right;
    if (!image_create(&right, lit_scene.view.resolution, &message))
        exit(1);
    Work flat = {&lit_scene, camera, &right, 1, NULL, NULL};
    engines[0].cast(&flat, &message);
    against_all(name, &engines[1], &flat, threads, IN_TURNS);
    image_free(&right);
}

static bool looks(Camera *camera)
{
    return scene_camera(&lit_scene.view, lit_scene.view.resolution, camera) == CAMERA_OK;
}

static void try_scene(const char *name, bool pictures)
{
    Camera camera;
    if (!looks(&camera))
        return; // a random view along up
    compare_rays(name, camera);
    if (pictures)
        compare_pictures(name, camera, (Style){.samples = 2, .depth = lit_depth, .gamma = 2.2},
                         false);
}

static void try_far_scene(unsigned number)
{
    Camera camera;
    char name[40];
    snprintf(name, sizeof name, "far scene %u", number);
    lit_far_apart(number);
    if (!looks(&camera))
        return;
    Image size = {.size = lit_scene.view.resolution};
    Work work = {.scene = &lit_scene, .camera = camera, .image = &size, .threads = 1};
    if (!extreme_light(&work))
        compare_rays(name, camera);
    Style style = {.samples = 1 + (int)(number % 2), .depth = lit_depth, .gamma = 2.2};
    compare_pictures(name, camera, style, true);
    compare_flat(name, camera);
}

// ---- shadows ---------------------------------------------------------------------------------

// From behind each sphere, rays to the light nearly touch it, so they go through the edges of the
// sphere's cells. Each answer must be that of visibility, which asks all spheres.
enum { MOST_IN_SHADOW = 400, RAYS = 40 };

static Sphere spheres[MOST_IN_SHADOW];
static int asked, decided, grids;

// Small spheres near each other, eight of them at the corners of their box; sometimes with a ground
// and a sky.
static Scene random_scene(int number)
{
    Scene scene = {.spheres = spheres, .sphere_count = (int)uniform(1, MOST_IN_SHADOW - 2)};
    for (int i = 0; i < scene.sphere_count; i++)
        spheres[i] = (Sphere){within(2), pow(10, uniform(-4, 0)), 0};
    for (int i = 0; i < 8 && i < scene.sphere_count; i++)
        spheres[i].center = vec3_of(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 2 : -2);
    if (number % 3 == 0) {
        spheres[scene.sphere_count++] = (Sphere){vec3_of(0, -1002, 0), 1000, 0};
        spheres[scene.sphere_count++] = (Sphere){vec3_of(0, 0, 0), 5000, 0};
    }
    return scene;
}

// A ray to the light that nearly touches a sphere; sometimes one that starts in it.
static Ray touching(Light to, const Sphere *sphere)
{
    vec3 light = to.position, axis = sphere->center - light,
         aside = vec3_unit(vec3_cross(axis, within(1)));
    double distance = vec3_length(axis), sine = sphere->radius / distance;
    sine *= 1 + (uniform(0, 1) < 0.7 ? -1 : 1) * pow(10, uniform(-9, -2));
    vec3 away = sqrt(1 - sine * sine) / distance * axis + sine * aside;
    vec3 start = light + (distance + sphere->radius) * uniform(1.1, 2) * away;
    if (uniform(0, 1) < 0.1)
        start = sphere->center + 0.5 * sphere->radius * aside;
    return (Ray){start, light - start};
}

// The number of rays, out of those that nearly touch a sphere, for which the grid is wrong.
static int wrong(const LightWorld *world, Light light, const Sphere *sphere)
{
    static Vectors starts, ways, none;
    Rays rays = {&starts, &ways, &world->grids[0], true, RAYS, {0}, &none, none.x};
    int places[PATHS], different = 0;
    for (int i = 0; i < RAYS; i++) {
        Ray ray = touching(light, sphere);
        set_vector(&starts, i, ray.origin);
        set_vector(&ways, i, ray.direction);
        rays.left[i] = NO_PLACE;
    }
    LANES_BEST(nearest_of_many)(&world->wide, &rays, places);
    for (int i = 0; i < RAYS; i++) {
        bool arrives = visibility(world->scene, vector_of(&starts, i), light) > 0;
        different += places[i] != IN_DOUBT && arrives != (places[i] == NO_PLACE);
        decided += places[i] != IN_DOUBT;
    }
    return different;
}

static void try_shadows(int number)
{
    Scene scene = random_scene(number);
    vec3 away = 4 * vec3_unit(within(1)) + within(0.2) + vec3_of(0, 5, 0);
    Light light = {.position = number % 4 == 0 ? within(2) : away};
    scene.lights = &light;
    scene.light_count = 1;
    LightWorld world = {.scene = &scene};
    if (!light_world_build(&world))
        exit(1);
    grids += world.grids[0].bins.items != NULL;
    int before = asked, wrongly = 0;
    for (int i = 0; i < scene.sphere_count; i++)
        // If the light is inside, no ray touches the sphere.
        if (vec3_length(spheres[i].center - light.position) >= 1.02 * spheres[i].radius) {
            asked += RAYS;
            wrongly += wrong(&world, light, &spheres[i]);
        }
    light_world_free(&world);
    char name[40];
    snprintf(name, sizeof name, "shadows, scene %d", number);
    verdict(name, "rays to the light", wrongly, asked - before);
}

static void try_all_shadows(void)
{
    enum { SCENES = 60 };
    random_begin(2016);
    for (int number = 0; number < SCENES; number++)
        try_shadows(number);
    verdict("shadows", "rays that the grids decide", 2 * decided <= asked, 1);
    verdict("shadows", "lights that have a grid", 2 * grids <= SCENES, 1);
}

int main(int argc, char **argv)
{
    int random = argc > 1 ? atoi(argv[1]) : 100, first = argc > 2 ? atoi(argv[2]) : 1;
    int far = argc > 3 ? atoi(argv[3]) : 100;
    if (first == 1)
        try_all_shadows();
    for (size_t i = 0; lit_awkward[i].name != NULL; i++)
        for (int k = 0; k < lit_awkward[i].times; k++) {
            lit_awkward[i].make();
            try_scene(lit_awkward[i].name, k == 0);
        }
    for (int i = first; i < first + random; i++) {
        char name[40];
        snprintf(name, sizeof name, "random scene %d", i);
        lit_at_random((unsigned)i);
        try_scene(name, i % 4 == 0);
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (int i = first; i < first + far; i++)
        try_far_scene((unsigned)i);
    return against_end("shading engines");
}
