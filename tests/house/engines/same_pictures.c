// same_pictures.c - every engine gives chapter 06's picture and chapter 07's.
//
//   same_pictures [SCENES [FIRST]]
//
// SCENES random scenes, from number FIRST on (100, 1), as many whose numbers are far apart, and
// with the first all scenes that are made to be difficult, on screens of all sizes. Each is drawn
// by plain and by every other engine, with several threads, and with every instruction set that the
// engine was compiled for; and with shadows and mirrors, where also the color that a pixel's ray
// sees is compared to the last digit, and the grids of lights are asked for shadows.
//
//   same_pictures WIDTHxHEIGHT MOST-TESTS SCENE.nff...
//
// Against plain, chapter 06's loop, if that takes at most the given number of tests of a ray and a
// sphere (a number like 1e10), beyond it against bvh. The last line counts.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/lanes.h"
#include "chapters/08-fast/engines/light.h"
#include "chapters/shared/scene_camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"
#include "tests/house/engines/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { MOST_LIT = 1300, MOST_RAYS = 1200, MOST_TOUCHED = 60, RAYS = 20 };

// Each number of threads with each instruction set; the sets and the numbers in turns: the first
// set has the first number, and so on; or only the best set, and numbers in turns.
typedef enum { EACH, IN_TURNS, BEST_SET } How;

static const int some[] = {1, 3, 0}, more[] = {1, 2, 3, 0}, all[] = {1, 2, 3, 77, 0};

static int passed, failed;

static void settle(bool good, const char *name, const char *why)
{
    *(good ? &passed : &failed) += 1;
    if (!good)
        printf("not ok: %s: %s\n", name, why);
}

static Image image_for(Resolution size)
{
    Image image;
    Message message;
    if (!image_create(&image, size, &message)) {
        fprintf(stderr, "%s\n", message.text);
        exit(1);
    }
    return image;
}

// ---- whole pictures --------------------------------------------------------------------------

// Casts the right picture's work with an engine, with light if it has a style.
static void compare(const char *name, const Engine *engine, const Work *right, int threads,
                    const Style *style)
{
    char who[200], why[120];
    snprintf(who, sizeof who, "%s, %s for %s, %d threads%s", name, engine->name,
             lanes_names[lanes_best()], threads, style != NULL ? ", lit" : "");
    Message message;
    Image image = image_for(right->image->size);
    Work work = *right;
    work.image = &image;
    work.threads = threads;
    // No engine may rely on what was in the image.
    size_t pixels = (size_t)image.size.width * (size_t)image.size.height;
    memset(image.rgb, 0xa5, 3 * pixels);
    bool cast =
        style != NULL ? engine->light(&work, *style, &message) : engine->cast(&work, &message);
    size_t different = 0, first = 0;
    for (size_t i = pixels; cast && i-- > 0;)
        if (memcmp(image.rgb + 3 * i, right->image->rgb + 3 * i, 3) != 0) {
            different++;
            first = i;
        }
    snprintf(why, sizeof why, "%zu of %zu pixels differ, first (%zu, %zu)", different, pixels,
             first % (size_t)image.size.width, first / (size_t)image.size.width);
    settle(cast && different == 0, who, cast ? why : message.text);
    image_free(&image);
}

static bool has_lanes(const Engine *engine)
{
    static const char *const with_lanes[] = {"packet", "tiles", "bins"};
    for (size_t i = 0; i < sizeof with_lanes / sizeof with_lanes[0]; i++)
        if (strcmp(engine->name, with_lanes[i]) == 0)
            return true;
    return false;
}

// Engines that are not compiled for several instruction sets are tried with one.
static void compare_all(const char *name, const Engine *first, const Work *right,
                        const int *threads, How how)
{
    lanes_at_most = LANES_AVX512;
    const int best = (int)lanes_best();
    const int *turn = threads;
    for (const Engine *engine = first; engine->name != NULL; engine++) {
        for (int kind = has_lanes(engine) && how != BEST_SET ? LANES_BASELINE : best; kind <= best;
             kind++) {
            lanes_at_most = (LanesKind)kind;
            for (const int *n = threads; how == EACH && *n > 0; n++)
                compare(name, engine, right, *n, NULL);
            if (how != EACH) {
                compare(name, engine, right, *turn, NULL);
                turn = turn[1] > 0 ? turn + 1 : threads;
            }
        }
    }
    lanes_at_most = LANES_AVX512;
}

// ---- with light ------------------------------------------------------------------------------

static int differ(LightPaths *paths, const Ray *rays, const Color *right, int count)
{
    int different = 0;
    paths->paths.count = count;
    for (int i = 0; i < count; i++) {
        set_vector(&paths->paths.origin, i, rays[i].origin);
        set_vector(&paths->paths.direction, i, rays[i].direction);
    }
    path_colors(paths, false);
    for (int i = 0; i < count; i++) {
        Color color = vector_of(paths->colors, i);
        different += memcmp(&right[i], &color, 3 * sizeof(double)) != 0;
    }
    return different;
}

// From behind spheres, rays to a light nearly touch them, so they go through the edges of their
// cells in the light's grid. Each answer must be that of visibility, which asks all spheres.
static int asked, decided;

// A ray to the light that nearly touches a sphere; sometimes one that starts in it.
static Ray touching(vec3 light, Sphere sphere)
{
    vec3 axis = sphere.center - light, aside = vec3_unit(vec3_cross(axis, within(1)));
    double distance = vec3_length(axis), sine = sphere.radius / distance;
    sine *= 1 + (uniform(0, 1) < 0.7 ? -1 : 1) * pow(10, uniform(-9, -2));
    vec3 away = sqrt(1 - sine * sine) / distance * axis + sine * aside;
    vec3 start = light + (distance + sphere.radius) * uniform(1.1, 2) * away;
    if (uniform(0, 1) < 0.1)
        start = sphere.center + 0.5 * sphere.radius * aside;
    return (Ray){start, light - start};
}

// The number of rays, out of those that nearly touch a sphere, for which the grid is wrong.
static int wrong_shadows(const LightWorld *world, int light, Sphere sphere)
{
    static Vectors starts, ways, none;
    Rays rays = {&starts, &ways, &world->grids[light], true, RAYS, {0}, &none, none.x};
    const Light to = world->scene->lights[light];
    int places[PATHS], different = 0;
    for (int i = 0; i < RAYS; i++) {
        Ray ray = touching(to.position, sphere);
        set_vector(&starts, i, ray.origin);
        set_vector(&ways, i, ray.direction);
        rays.left[i] = NO_PLACE;
    }
    LANES_BEST(nearest_of_many)(&world->wide, &rays, places);
    for (int i = 0; i < RAYS; i++) {
        bool arrives = visibility(world->scene, vector_of(&starts, i), to) > 0;
        different += places[i] != IN_DOUBT && arrives != (places[i] == NO_PLACE);
        decided += places[i] != IN_DOUBT;
    }
    asked += RAYS;
    return different;
}

static void compare_shadows(const char *name, const LightWorld *world)
{
    const Scene *scene = world->scene;
    for (int light = 0; light < scene->light_count; light++) {
        vec3 from = scene->lights[light].position;
        int wrong = 0;
        for (int i = 0; i < scene->sphere_count && world->grids[light].items != NULL;
             i += 1 + scene->sphere_count / MOST_TOUCHED)
            // If the light is inside, no ray touches the sphere.
            if (vec3_length(scene->spheres[i].center - from) >= 1.02 * scene->spheres[i].radius)
                wrong += wrong_shadows(world, light, scene->spheres[i]);
        settle(wrong == 0, name, "the grid of a light is wrong");
    }
}

// What rays of pixels see, by the lanes of each kind, and by the chapters' functions.
static void compare_rays(const Made *made)
{
    static Ray rays[MOST_RAYS];
    static Color right[MOST_RAYS];
    static int columns[MOST_RAYS], rows[MOST_RAYS];
    LightWorld world = {
        .scene = &made->scene, .camera = made->camera, .samples = made->size, .depth = made->depth};
    if (!light_world_build(&world))
        exit(1);
    const int pixels = made->size.width * made->size.height, count = least(pixels, MOST_RAYS);
    for (int i = 0; i < count; i++) {
        int pixel = (int)((long)i * pixels / count);
        columns[i] = pixel % made->size.width;
        rows[i] = pixel / made->size.width;
        rays[i] = pixel_ray(made->camera, made->size, (Pixel){columns[i], rows[i]});
        right[i] = trace_ray(&made->scene, rays[i], made->depth);
    }
    const int best = (int)lanes_best();
    for (int kind = 0; kind <= best + 1; kind++) {
        lanes_at_most = kind > best ? LANES_AVX512 : (LanesKind)kind;
        const LightSteps *steps =
            kind > best ? &steps_by_chapters : steps_for(&world, columns, rows, count);
        LightPaths *paths = light_paths_create(&world, steps);
        if (paths == NULL)
            exit(1);
        char why[100];
        int different = 0;
        for (int first = 0; first < count; first += PATHS)
            different += differ(paths, rays + first, right + first, least(count - first, PATHS));
        snprintf(why, sizeof why, "%d of %d rays of %s see another color", different, count,
                 kind > best ? "chapters" : lanes_names[kind]);
        settle(different == 0, made->name, why);
        settle(kind > best || steps != &steps_by_chapters, made->name, "no steps in lanes");
        free(paths);
    }
    lanes_at_most = LANES_AVX512;
    compare_shadows(made->name, &world);
    light_world_free(&world);
}

// With an odd number of spheres a pixel has four samples.
static void compare_light(const Made *made)
{
    const int samples = 1 + made->scene.sphere_count % 2, best = (int)lanes_best();
    const Style style = {.samples = samples, .depth = made->depth, .gamma = 2.2};
    Image image = image_for(
        (Resolution){most(made->size.width / samples, 1), most(made->size.height / samples, 1)});
    Work right = {&made->scene, made->camera, &image, 1, NULL, NULL};
    if (!extreme_light(&right))
        compare_rays(made);
    render(&made->scene, made->camera, style, &image);
    compare(made->name, &engines[0], &right, 3, &style);
    for (int kind = 0; kind <= best; kind++) {
        lanes_at_most = (LanesKind)kind;
        compare(made->name, engine_named("bvh"), &right, kind % 2 == 0 ? 3 : 1, &style);
    }
    lanes_at_most = LANES_AVX512;
    image_free(&image);
}

// ---- scenes that are made ---------------------------------------------------------------------

// With light, if it has few spheres: chapter 07's loop is slow.
static void try_made(const Made *made, const int *threads, How how)
{
    Message message;
    Image image = image_for(made->size);
    // Of small scenes plain is compared with itself, by several threads.
    const Engine *next = &engines[made->scene.sphere_count > 1000];
    Work right = {&made->scene, made->camera, &image, 1, NULL, NULL};
    engines[0].cast(&right, &message);
    compare_all(made->name, next, &right, threads, how);
    image_free(&image);
    if (made->scene.sphere_count <= MOST_LIT)
        compare_light(made);
}

static void try_all_made(void)
{
    static Made made;
    for (int i = 0; made_difficult(&made, i); i++)
        try_made(&made, some, EACH);
    const Resolution sizes[] = {{1, 1},   {1, 97},  {97, 1},  {2, 3},   {17, 16},  {16, 17},
                                {33, 31}, {31, 33}, {64, 48}, {65, 49}, {1, 4096}, {4096, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        made_sized(&made, sizes[i]);
        try_made(&made, all, EACH);
    }
    // Across the limit beyond which all is left to plain, and where lengths are extreme.
    for (unsigned i = 0; i < 60; i++) {
        made_far(&made, i, pow(10, 10 + i / 6.0), 1);
        try_made(&made, some, IN_TURNS);
    }
    for (unsigned i = 0; i < 60; i++) {
        made_edge(&made, i, pow(10, 6 + i % 6), pow(10, -0.7 * (i / 6)));
        try_made(&made, some, IN_TURNS);
    }
    static const double radii[] = {1e-250, 1e-100, 1e-59, 1e-30, 1e30, 1e50, 1e100, 1e150, 1e290};
    for (unsigned i = 0; i < 4 * sizeof radii / sizeof radii[0]; i++) {
        made_far(&made, i, pow(10, i % 4 * 3), radii[i / 4]);
        try_made(&made, some, IN_TURNS);
    }
    made_many(&made);
    try_made(&made, all, IN_TURNS);
    made_wide(&made);
    try_made(&made, all, IN_TURNS);
    made_hidden(&made);
    try_made(&made, some, EACH);
}

static void try_random(int count, int first)
{
#ifdef __GLIBC__
    mallopt(M_PERTURB, 0xa5); // no engine finds what another has left in memory
#endif
    if (first == 1)
        try_all_made();
    static Made made;
    for (int i = first; i < first + count; i++) {
        made_at_random(&made, (unsigned)i);
        try_made(&made, some, IN_TURNS);
        made_far_apart(&made, (unsigned)i);
        try_made(&made, some, IN_TURNS);
    }
}

// ---- files -----------------------------------------------------------------------------------

static void try_scene(const char *name, const Scene *scene, Resolution size, double most)
{
    Message message;
    Camera camera;
    if (scene_camera(&scene->view, size, &camera) != CAMERA_OK) {
        settle(false, name, "no camera");
        return;
    }
    Image image = image_for(size);
    Work right = {scene, camera, &image, (int)sysconf(_SC_NPROCESSORS_ONLN), NULL, NULL};
    bool few = (double)size.width * size.height * scene->sphere_count <= most;
    const Engine *engine = few ? &engines[0] : engine_named("bvh");
    // Hierarchies of many spheres take long to build.
    if (engine->cast(&right, &message))
        compare_all(name, &engines[1], &right, more,
                    scene->sphere_count > 200000 ? BEST_SET : IN_TURNS);
    else
        settle(false, name, message.text);
    image_free(&image);
}

static void try_file(const char *path, Resolution size, double most)
{
    Scene scene;
    Message message;
    if (scene_load(path, &scene, &message))
        try_scene(path, &scene, size, most);
    else
        settle(false, path, message.text);
    scene_free(&scene);
}

int main(int argc, char **argv)
{
    Resolution size;
    if (argc > 2 && sscanf(argv[1], "%dx%d", &size.width, &size.height) == 2)
        for (int i = 3; i < argc; i++)
            try_file(argv[i], size, strtod(argv[2], NULL));
    else
        try_random(argc > 1 ? atoi(argv[1]) : 100, argc > 2 ? atoi(argv[2]) : 1);
    if (asked > 0)
        settle(4 * decided > asked, "shadows", "the grids of lights decide only a few rays");
    printf("engines: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
