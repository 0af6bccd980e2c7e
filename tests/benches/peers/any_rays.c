// any_rays.c - rays from anywhere: chapter 08 beside Embree 3's own spheres.
//
// Of each scene's picture at 1920 x 1080 it takes the rays to the lights (is anything in between?)
// and the rays that continue from mirrors (what is nearest?), in the order in which the picture
// makes them: squares of 4 x 4 pixels, 256 at a time. Lights behind the surface are not asked.
// Chapter 08 answers as in the picture: a light's grid, whose building counts, and mirrors 256 rays
// at a time. The lines "one by one" are the walk of single rays alone. What is in doubt, chapter
// 05's and 07's functions decide. Embree answers one ray at a time. All answer the same rays in
// turns, on one thread. The times are processor times, so other programs disturb them less. Then
// both build their hierarchies, also in turns, by one thread and by two. At last, without a clock,
// the boxes and spheres that the rays visit are counted in the trees of both (trees.c); with 0
// rounds only these.
// Usage: any_rays [-r ROUNDS] SCENE.nff...
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "common/large_pages.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"
#include "tests/benches/peers/trees.h"

#include <embree3/rtcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_ROUNDS = 99 };

// ---- the rays ---------------------------------------------------------------------------------

typedef struct {
    Ray *rays;
    Line *lines;
    Single *singles;
    uint8_t *lights; // the number of each ray's light
    int *spheres;    // the sphere that each ray leaves
    bool *hits[3];   // what each tracer says
    int count, room;
} RayList;

static void *array(size_t count, size_t size)
{
    void *memory = large_memory(count * size + 1);
    if (memory == NULL)
        exit(1);
    return memset(memory, 0, count * size);
}

static RayList ray_list(int room)
{
    size_t n = (size_t)room;
    RayList rays = {.room = room,
                    .rays = array(n, sizeof(Ray)),
                    .lines = array(n, sizeof(Line)),
                    .singles = array(n, sizeof(Single)),
                    .lights = array(n, 1),
                    .spheres = array(n, sizeof(int))};
    for (int i = 0; i < 3; i++)
        rays.hits[i] = array(n, sizeof(bool));
    return rays;
}

static void ray_list_free(RayList *rays)
{
    free(rays->rays), free(rays->lines), free(rays->singles);
    free(rays->lights), free(rays->spheres), free(rays->hits[0]), free(rays->hits[1]),
        free(rays->hits[2]);
}

static Single single_of(Ray ray, bool to_infinity)
{
    double length = vec3_length(ray.direction);
    Single single = {.reach = to_infinity ? INFINITY : (float)length};
    for (int axis = 0; axis < 3; axis++) {
        single.origin[axis] = (float)ray.origin[axis];
        single.direction[axis] = (float)(ray.direction[axis] / length);
    }
    return single;
}

static void add(RayList *rays, Ray ray, bool to_infinity, int light, int sphere)
{
    int i = rays->count++;
    double length = vec3_length(ray.direction);
    rays->rays[i] = ray;
    rays->singles[i] = single_of(ray, to_infinity);
    rays->lights[i] = (uint8_t)light;
    rays->spheres[i] = sphere;
    for (int axis = 0; axis < 3; axis++) {
        rays->lines[i].origin[axis] = ray.origin[axis];
        rays->lines[i].direction[axis] = ray.direction[axis] / length;
    }
}

enum { BLOCK = 16, SQUARE = 4 };

// Pixel number i in the order of the picture; its place, row by row, or -1 if it is outside.
static int pixel_place(Resolution screen, int i)
{
    int blocks = (screen.width + BLOCK - 1) / BLOCK, in_block = i % (BLOCK * BLOCK);
    int block = i / (BLOCK * BLOCK), square = in_block / (SQUARE * SQUARE);
    int in_square = in_block % (SQUARE * SQUARE), squares = BLOCK / SQUARE;
    int row = block / blocks * BLOCK + square / squares * SQUARE + in_square / SQUARE;
    int column = block % blocks * BLOCK + square % squares * SQUARE + in_square % SQUARE;
    return row < screen.height && column < screen.width ? row * screen.width + column : -1;
}

static void collect(const Scene *scene, const int *seen, Camera camera, Resolution screen,
                    RayList *shadow, RayList *mirror)
{
    int blocks = (screen.width + BLOCK - 1) / BLOCK * ((screen.height + BLOCK - 1) / BLOCK);
    for (int i = 0; i < blocks * BLOCK * BLOCK; i++) {
        int place = pixel_place(screen, i);
        if (place < 0 || seen[place] < 0)
            continue;
        Ray ray = pixel_ray(camera, screen, (Pixel){place % screen.width, place / screen.width});
        Sphere sphere = scene->spheres[seen[place]];
        vec3 point = ray.origin + hit_sphere(ray, sphere) * ray.direction;
        vec3 normal = surface_normal(sphere, point);
        if (vec3_dot(normal, ray.direction) > 0)
            continue; // from inside: in no scene of the bench
        // Farther off the surface than off_surface: Embree's floats need it.
        vec3 start = point + 1e-4 * sphere.radius * normal;
        for (int k = 0; k < scene->light_count; k++) {
            Ray to_light = ray_to_light(start, scene->lights[k]);
            if (vec3_dot(normal, to_light.direction) > 0)
                add(shadow, to_light, scene->lights[k].kind == LIGHT_DISTANT, k, seen[place]);
        }
        add(mirror, (Ray){start, mirror_direction(ray.direction, normal)}, true, 0, seen[place]);
    }
}

// Rays from the eye, row by row.
static Single *eye_rays(Camera camera, Resolution screen)
{
    Single *rays = array((size_t)screen.width * (size_t)screen.height, sizeof *rays), *next = rays;
    for (int row = 0; row < screen.height; row++)
        for (int column = 0; column < screen.width; column++)
            *next++ = single_of(pixel_ray(camera, screen, (Pixel){column, row}), true);
    return rays;
}

// ---- chapter 08 -------------------------------------------------------------------------------

typedef struct {
    LightWorld *world;
    RTCScene peer;
    NearestOf *nearest;
    NearestOfMany *nearest_of_many;
    double grid_seconds; // the last building of the grids
} Both;

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// Whether one of the spheres, by places in the hierarchy, hides a light.
static bool any_hides(const Scene *scene, const int *order, const PossibleHits *candidates,
                      vec3 from, Light light)
{
    if (candidates->count > MOST_CANDIDATES)
        return !(visibility(scene, from, light) > 0);
    for (int i = 0; i < candidates->count; i++) {
        Sphere alone = scene->spheres[order[candidates->places[i]]];
        if (!(visibility(&(Scene){.spheres = &alone, .sphere_count = 1}, from, light) > 0))
            return true;
    }
    return false;
}

static bool hidden_alone(const Both *both, const RayList *rays, int i)
{
    const LightWorld *world = both->world;
    PossibleHits candidates;
    Light light = world->scene->lights[rays->lights[i]];
    both->nearest(&world->rays, &rays->lines[i], &candidates);
    return any_hides(world->scene, world->hierarchy.order, &candidates, rays->rays[i].origin,
                     light);
}

static void shadow_one_by_one(Both *both, const RayList *rays, bool *hits)
{
    for (int i = 0; i < rays->count; i++)
        hits[i] = hidden_alone(both, rays, i);
}

static void build_grids(Both *both)
{
    double begin = processor_seconds();
    LightWorld *world = both->world;
    for (int i = 0; i < world->scene->light_count; i++) {
        light_grid_free(&world->grids[i]);
        if (!light_grid_build(&world->grids[i], &world->crowd, world->scene->lights[i]))
            exit(1);
    }
    both->grid_seconds = processor_seconds() - begin;
}

// Rays to one light that wait until there are PATHS.
typedef struct {
    ShadowRays rays;
    Vectors start, way;
    int numbers[PATHS];
} Waiting;

static void ask_grid(const Both *both, const RayList *rays, Waiting *waiting, int light, bool *hits)
{
    int verdicts[PATHS];
    waiting->rays.start = &waiting->start;
    waiting->rays.way = &waiting->way;
    waiting->rays.endless = both->world->scene->lights[light].kind == LIGHT_DISTANT;
    light_grid_ask(&both->world->grids[light], &waiting->rays, verdicts);
    for (int i = 0; i < waiting->rays.count; i++)
        hits[waiting->numbers[i]] = verdicts[i] == DOUBTFUL
                                        ? hidden_alone(both, rays, waiting->numbers[i])
                                        : verdicts[i] == HIDDEN;
    waiting->rays.count = 0;
}

static void shadow_by_grids(Both *both, const RayList *rays, bool *hits)
{
    const LightWorld *world = both->world;
    int lights = world->scene->light_count;
    Waiting *waiting = array((size_t)lights, sizeof *waiting);
    build_grids(both);
    for (int i = 0; i < rays->count; i++) {
        Waiting *here = &waiting[rays->lights[i]];
        int at = here->rays.count++;
        set_vector(&here->start, at, rays->rays[i].origin);
        set_vector(&here->way, at, rays->rays[i].direction);
        here->rays.passes[at] = rays->spheres[i];
        here->numbers[at] = i;
        if (here->rays.count == PATHS)
            ask_grid(both, rays, here, rays->lights[i], hits);
    }
    for (int i = 0; i < lights; i++)
        ask_grid(both, rays, &waiting[i], i, hits);
    free(waiting);
}

// Whether the ray hits one of these spheres, which are possible, not certain.
static bool hits_any(const Both *both, Ray ray, const PossibleHits *candidates)
{
    const LightWorld *world = both->world;
    if (candidates->count > MOST_CANDIDATES)
        return hierarchy_nearest(&world->hierarchy, world->scene, ray).t < NO_HIT;
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < candidates->count; i++) {
        int sphere = world->hierarchy.order[candidates->places[i]];
        nearest = nearer(nearest, (Hit){hit_sphere(ray, world->scene->spheres[sphere]), sphere});
    }
    return nearest.t < NO_HIT;
}

static void mirror_one_by_one(Both *both, const RayList *rays, bool *hits)
{
    for (int i = 0; i < rays->count; i++) {
        PossibleHits candidates;
        both->nearest(&both->world->rays, &rays->lines[i], &candidates);
        hits[i] = hits_any(both, rays->rays[i], &candidates);
    }
}

static void mirror_together(Both *both, const RayList *rays, bool *hits)
{
    int left[PATHS], places[PATHS];
    for (int first = 0; first < rays->count; first += PATHS) {
        int count = rays->count - first < PATHS ? rays->count - first : PATHS;
        for (int i = 0; i < count; i++)
            left[i] = both->world->rays.places[rays->spheres[first + i]];
        both->nearest_of_many(&both->world->rays, rays->lines + first, left, count, places);
        for (int i = 0; i < count; i++) {
            PossibleHits candidates;
            hits[first + i] = places[i] != NO_PLACE;
            if (places[i] != IN_DOUBT)
                continue;
            both->nearest(&both->world->rays, &rays->lines[first + i], &candidates);
            hits[first + i] = hits_any(both, rays->rays[first + i], &candidates);
        }
    }
}

// ---- Embree -----------------------------------------------------------------------------------

static struct RTCRay ray_for_peer(const Single *single)
{
    return (struct RTCRay){.org_x = single->origin[0],
                           .org_y = single->origin[1],
                           .org_z = single->origin[2],
                           .dir_x = single->direction[0],
                           .dir_y = single->direction[1],
                           .dir_z = single->direction[2],
                           .tfar = single->reach,
                           .mask = ~0U};
}

static void peer_shadow(Both *both, const RayList *rays, bool *hits)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int i = 0; i < rays->count; i++) {
        struct RTCRay ray = ray_for_peer(&rays->singles[i]);
        rtcOccluded1(both->peer, &context, &ray);
        hits[i] = ray.tfar < 0;
    }
}

static void peer_mirror(Both *both, const RayList *rays, bool *hits)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int i = 0; i < rays->count; i++) {
        struct RTCRayHit ray = {.ray = ray_for_peer(&rays->singles[i])};
        ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(both->peer, &context, &ray);
        hits[i] = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
}

// ---- measuring --------------------------------------------------------------------------------

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef void Tracing(Both *both, const RayList *rays, bool *hits);

// Returns the median of the ratios.
static double say_seconds(const char *what, const RayList *rays, double *seconds,
                          const double *peer_seconds, int rounds)
{
    double ratios[MOST_ROUNDS];
    for (int i = 0; i < rounds; i++)
        ratios[i] = peer_seconds[i] / seconds[i];
    qsort(ratios, (size_t)rounds, sizeof *ratios, by_size);
    qsort(seconds, (size_t)rounds, sizeof *seconds, by_size);
    printf("  %-19s %6.3g M/s  %5.2f times Embree (%.2f to %.2f)", what,
           1e-6 * rays->count / seconds[rounds / 2], ratios[rounds / 2], ratios[0],
           ratios[rounds - 1]);
    return ratios[rounds / 2];
}

static int different(const RayList *rays, int a, int b)
{
    int count = 0;
    for (int i = 0; i < rays->count; i++)
        count += rays->hits[a][i] != rays->hits[b][i];
    return count;
}

// Returns how many times Embree's speed the first tracing has.
static double compare(const char *names[2], Both *both, const RayList *rays, Tracing *const ours[2],
                      Tracing *peer, int rounds)
{
    double seconds[3][MOST_ROUNDS];
    if (rays->count == 0)
        return 1;
    for (int i = 0; i < rounds; i++) {
        for (int k = 0; k < 3; k++) {
            double begin = processor_seconds();
            (k < 2 ? ours[k] : peer)(both, rays, rays->hits[k]);
            seconds[k][i] = processor_seconds() - begin;
        }
    }
    long hits = 0;
    for (int i = 0; i < rays->count; i++)
        hits += rays->hits[0][i];
    double ratios[2];
    for (int k = 0; k < 2; k++) {
        ratios[k] = say_seconds(names[k], rays, seconds[k], seconds[2], rounds);
        printf("  %d rays, %ld hit, Embree differs in %d\n", rays->count, hits,
               different(rays, k, 2));
    }
    fflush(stdout);
    return ratios[0];
}

static RTCScene peer_scene(RTCDevice device, const float *spheres, int count)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    RTCScene scene = rtcNewScene(device);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, spheres, 0,
                               4 * sizeof(float), (size_t)count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

// Of all threads together.
static double process_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// Without lights: Embree builds no grids for them. With one thread the time is the processor's.
static void compare_building(const Scene *scene, const float *spheres, int threads, int rounds)
{
    double (*now)(void) = threads == 1 ? process_seconds : clock_seconds;
    Scene unlit = *scene;
    unlit.light_count = 0;
    double ratios[MOST_ROUNDS], ours[MOST_ROUNDS];
    char config[40];
    snprintf(config, sizeof config, "threads=%d,set_affinity=0", threads);
    RTCDevice device = rtcNewDevice(config);
    for (int i = 0; i < rounds; i++) {
        LightWorld world;
        double a = now();
        if (!light_world_build(&world, &unlit, threads))
            exit(1);
        double b = now();
        light_world_free(&world);
        double c = now();
        RTCScene peer = peer_scene(device, spheres, scene->sphere_count);
        double d = now();
        rtcReleaseScene(peer);
        ratios[i] = (d - c) / (b - a);
        ours[i] = 1e3 * (b - a);
    }
    qsort(ratios, (size_t)rounds, sizeof *ratios, by_size);
    qsort(ours, (size_t)rounds, sizeof *ours, by_size);
    printf("  build, %d threads  %8.4g ms  Embree takes %.2f times as long (%.2f to %.2f)\n",
           threads, ours[rounds / 2], ratios[rounds / 2], ratios[0], ratios[rounds - 1]);
    rtcReleaseDevice(device);
}

// Over all scenes: sums of logarithms, and the least.
typedef struct {
    double log_sum[2], least[2];
    int scenes;
} Sums;

static void sum(Sums *sums, int kind, double ratio)
{
    sums->log_sum[kind] += log(ratio);
    sums->least[kind] = sums->scenes == 0 ? ratio : fmin(sums->least[kind], ratio);
}

static void compare_rays(Both *both, const RayList *shadow, const RayList *mirror, int rounds,
                         Sums *sums)
{
    const char *shadow_names[2] = {"shadow, grids", "shadow, one by one"};
    const char *mirror_names[2] = {"mirror, 256", "mirror, one by one"};
    Tracing *shadows[2] = {shadow_by_grids, shadow_one_by_one};
    Tracing *mirrors[2] = {mirror_together, mirror_one_by_one};
    sum(sums, 0, compare(shadow_names, both, shadow, shadows, peer_shadow, rounds));
    printf("  of this, building the grids  %.3g ms\n", 1e3 * both->grid_seconds);
    sum(sums, 1, compare(mirror_names, both, mirror, mirrors, peer_mirror, rounds));
    sums->scenes++;
}

// A scene, and the rays of its picture.
typedef struct {
    Scene scene;
    Camera camera;
    Resolution screen;
    LightWorld world;
    RayList shadow, mirror;
    float *spheres; // x, y, z and r, for Embree
} PictureRays;

static void collect_rays(PictureRays *picture)
{
    Image image = {.size = picture->screen};
    const int pixels = picture->screen.width * picture->screen.height;
    int *seen = array((size_t)pixels, sizeof *seen), hits = 0;
    Work work = {&picture->scene, picture->camera, &image, 2, NULL, NULL, false};
    if (!bins_spheres(&work, seen))
        exit(1);
    for (int i = 0; i < pixels; i++)
        hits += seen[i] >= 0;
    picture->shadow = ray_list(hits * picture->scene.light_count);
    picture->mirror = ray_list(hits);
    collect(&picture->scene, seen, picture->camera, picture->screen, &picture->shadow,
            &picture->mirror);
    free(seen);
}

static void picture_begin(PictureRays *picture, const char *path)
{
    Scene *scene = &picture->scene;
    Message message;
    if (!scene_load(path, scene, &message)) {
        fprintf(stderr, "%s\n", message.text);
        exit(1);
    }
    picture->screen = (Resolution){1920, 1080};
    picture->spheres = array((size_t)scene->sphere_count + 1, 4 * sizeof *picture->spheres);
    if (scene_camera(&scene->view, picture->screen, &picture->camera) != CAMERA_OK ||
        !light_world_build(&picture->world, scene, 2))
        exit(1);
    for (int i = 0; i < scene->sphere_count; i++) {
        for (int k = 0; k < 3; k++)
            picture->spheres[4 * i + k] = (float)scene->spheres[i].center[k];
        picture->spheres[4 * i + 3] = (float)scene->spheres[i].radius;
    }
    collect_rays(picture);
    printf("%s, %d spheres\n", path, scene->sphere_count);
}

static void picture_end(PictureRays *picture)
{
    light_world_free(&picture->world);
    ray_list_free(&picture->shadow);
    ray_list_free(&picture->mirror);
    free(picture->spheres);
    scene_free(&picture->scene);
}

static void measure(PictureRays *picture, int rounds, Sums *sums)
{
    const Scene *scene = &picture->scene;
    LightPaths paths;
    if (!light_paths_begin(&paths, &picture->world, 0))
        exit(1);
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    Both both = {&picture->world, peer_scene(device, picture->spheres, scene->sphere_count),
                 paths.nearest, paths.nearest_of_many, 0};
    compare_rays(&both, &picture->shadow, &picture->mirror, rounds, sums);
    for (int threads = 1; threads <= 2; threads++)
        compare_building(scene, picture->spheres, threads, rounds);
    rtcReleaseScene(both.peer);
    rtcReleaseDevice(device);
    light_paths_end(&paths);
}

static void say_sums(const Sums *sums)
{
    for (int kind = 0; kind < 2; kind++)
        printf("%s: %.2f times Embree in the geometric mean of %d scenes, at least %.2f\n",
               kind == 0 ? "shadow" : "mirror", exp(sums->log_sum[kind] / sums->scenes),
               sums->scenes, sums->least[kind]);
}

// ---- trees ------------------------------------------------------------------------------------

// Over all scenes and kinds of rays: sums of logarithms, and the most.
typedef struct {
    double boxes, spheres, most_boxes, most_spheres;
    int count;
} TreeSums;

static void count_visits(const PictureRays *picture, TreeSums *sums)
{
    Single *eye = eye_rays(picture->camera, picture->screen);
    RayKind kinds[RAY_KINDS] = {{"eye", eye, picture->screen.width * picture->screen.height, false},
                                {"shadow", picture->shadow.singles, picture->shadow.count, true},
                                {"mirror", picture->mirror.singles, picture->mirror.count, false}};
    TreeRatios ratios =
        compare_trees(&picture->scene, &picture->world.hierarchy, picture->spheres, kinds);
    for (int i = 0; i < RAY_KINDS; i++) {
        sums->boxes += log(ratios.boxes[i]);
        sums->spheres += log(ratios.spheres[i]);
        sums->most_boxes = fmax(sums->most_boxes, ratios.boxes[i]);
        sums->most_spheres = fmax(sums->most_spheres, ratios.spheres[i]);
        sums->count++;
    }
    free(eye);
}

static void say_tree_sums(const TreeSums *sums)
{
    printf("boxes visited: %.3f times those in Embree's tree in the geometric mean, at most %.3f\n",
           exp(sums->boxes / sums->count), sums->most_boxes);
    printf("spheres visited: %.3f times, at most %.3f\n", exp(sums->spheres / sums->count),
           sums->most_spheres);
}

int main(int argc, char **argv)
{
    static PictureRays picture;
    int first = 1, rounds = 5;
    if (argc > 3 && strcmp(argv[1], "-r") == 0) {
        rounds = atoi(argv[2]);
        first = 3;
    }
    if (first >= argc || rounds < 0 || rounds > MOST_ROUNDS) {
        fprintf(stderr, "Usage: any_rays [-r ROUNDS, 0 (only trees) to %d] SCENE.nff...\n",
                MOST_ROUNDS);
        return 2;
    }
    Sums sums = {0};
    for (int i = first; i < argc && rounds > 0; i++) {
        picture_begin(&picture, argv[i]);
        measure(&picture, rounds, &sums);
        picture_end(&picture);
    }
    if (rounds > 0)
        say_sums(&sums);
    // After all that is measured, so that it disturbs nothing.
    TreeSums tree_sums = {0};
    for (int i = first; i < argc; i++) {
        picture_begin(&picture, argv[i]);
        count_visits(&picture, &tree_sums);
        picture_end(&picture);
    }
    say_tree_sums(&tree_sums);
    return 0;
}
