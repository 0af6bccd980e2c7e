// any_rays.c - rays from anywhere: chapter 08's hierarchy beside Embree 3's own spheres.
//
// Of each scene's picture it takes the rays to the lights (is anything in between?) and the rays
// that continue from mirrors (what is nearest?), in the order of the pixels. Both trace the same
// rays, in turns, one ray at a time, on one thread. The times are processor times, so other
// programs disturb them less. Then both build their hierarchies, also in turns, by one thread and
// by two. Usage: any_rays [-r ROUNDS] SCENE.nff...
#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/shared/scene_camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"

#include <embree3/rtcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_ROUNDS = 99 };

// ---- the rays ---------------------------------------------------------------------------------

typedef struct {
    float origin[3], direction[3], reach; // as Embree takes them; direction of length 1
} Single;

typedef struct {
    Line *lines;
    Single *singles;
    double *reaches;
    int count, room;
} RayList;

static void add(RayList *rays, Ray ray, bool to_infinity)
{
    if (rays->count == rays->room) {
        rays->room = 2 * rays->room + 1024;
        rays->lines = realloc(rays->lines, (size_t)rays->room * sizeof *rays->lines);
        rays->singles = realloc(rays->singles, (size_t)rays->room * sizeof *rays->singles);
        rays->reaches = realloc(rays->reaches, (size_t)rays->room * sizeof *rays->reaches);
        if (rays->lines == NULL || rays->singles == NULL || rays->reaches == NULL)
            exit(1);
    }
    int i = rays->count++;
    double length = vec3_length(ray.direction);
    rays->reaches[i] = to_infinity ? INFINITY : length;
    for (int axis = 0; axis < 3; axis++) {
        rays->lines[i].origin[axis] = ray.origin[axis];
        rays->lines[i].direction[axis] = ray.direction[axis] / length;
        rays->singles[i].origin[axis] = (float)ray.origin[axis];
        rays->singles[i].direction[axis] = (float)(ray.direction[axis] / length);
    }
    rays->singles[i].reach = (float)rays->reaches[i];
}

static void collect(const LightWorld *world, const int *seen, Camera camera, Resolution screen,
                    RayList *shadow, RayList *mirror)
{
    const Scene *scene = world->scene;
    for (int i = 0; i < screen.width * screen.height; i++) {
        if (seen[i] < 0)
            continue;
        Ray ray = pixel_ray(camera, screen, (Pixel){i % screen.width, i / screen.width});
        Sphere sphere = scene->spheres[seen[i]];
        vec3 point = ray.origin + hit_sphere(ray, sphere) * ray.direction;
        vec3 normal = surface_normal(sphere, point);
        if (vec3_dot(normal, ray.direction) > 0)
            normal = -normal;
        // Farther off the surface than off_surface: Embree's floats need it.
        vec3 start = point + 1e-4 * sphere.radius * normal;
        for (int k = 0; k < scene->light_count; k++)
            add(shadow, ray_to_light(start, scene->lights[k]),
                scene->lights[k].kind == LIGHT_DISTANT);
        add(mirror, (Ray){start, mirror_direction(ray.direction, normal)}, true);
    }
}

// ---- both tracers -----------------------------------------------------------------------------

typedef struct {
    const LightWorld *world;
    RTCScene peer;
    NearestOf *nearest;
    AnyBefore *before;
} Both;

static long ours_shadow(const Both *both, const RayList *rays)
{
    long hits = 0;
    for (int i = 0; i < rays->count; i++) {
        PossibleHits candidates = {0};
        hits += both->before(&both->world->rays, &rays->lines[i], rays->reaches[i], &candidates) ||
                candidates.count > 0;
    }
    return hits;
}

static long ours_mirror(const Both *both, const RayList *rays)
{
    long hits = 0;
    for (int i = 0; i < rays->count; i++) {
        PossibleHits candidates;
        both->nearest(&both->world->rays, &rays->lines[i], &candidates);
        hits += candidates.count > 0;
    }
    return hits;
}

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

static long peer_shadow(const Both *both, const RayList *rays)
{
    long hits = 0;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int i = 0; i < rays->count; i++) {
        struct RTCRay ray = ray_for_peer(&rays->singles[i]);
        rtcOccluded1(both->peer, &context, &ray);
        hits += ray.tfar < 0;
    }
    return hits;
}

static long peer_mirror(const Both *both, const RayList *rays)
{
    long hits = 0;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int i = 0; i < rays->count; i++) {
        struct RTCRayHit ray = {.ray = ray_for_peer(&rays->singles[i])};
        ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(both->peer, &context, &ray);
        hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
}

// ---- measuring --------------------------------------------------------------------------------

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef long Tracing(const Both *both, const RayList *rays);

static void compare(const char *what, const Both *both, const RayList *rays, Tracing *ours,
                    Tracing *peer, int rounds)
{
    double ratios[MOST_ROUNDS], rates[MOST_ROUNDS];
    long our_hits = 0, peer_hits = 0;
    if (rays->count == 0)
        return;
    for (int i = 0; i < rounds; i++) {
        double a = processor_seconds();
        our_hits = ours(both, rays);
        double b = processor_seconds();
        peer_hits = peer(both, rays);
        double c = processor_seconds();
        ratios[i] = (c - b) / (b - a);
        rates[i] = 1e-6 * rays->count / (b - a);
    }
    qsort(ratios, (size_t)rounds, sizeof *ratios, by_size);
    qsort(rates, (size_t)rounds, sizeof *rates, by_size);
    printf("  %-7s %8d rays  %6.3g M/s  %5.2f times Embree (%.2f to %.2f)  hits %ld, %ld\n", what,
           rays->count, rates[rounds / 2], ratios[rounds / 2], ratios[0], ratios[rounds - 1],
           our_hits, peer_hits);
    fflush(stdout);
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

// Without lights: Embree builds no grids for them.
static void compare_building(const Scene *scene, const float *spheres, int threads, int rounds)
{
    Scene unlit = *scene;
    unlit.light_count = 0;
    double ratios[MOST_ROUNDS], ours[MOST_ROUNDS];
    char config[40];
    snprintf(config, sizeof config, "threads=%d,set_affinity=0", threads);
    RTCDevice device = rtcNewDevice(config);
    for (int i = 0; i < rounds; i++) {
        LightWorld world;
        double a = clock_seconds();
        if (!light_world_build(&world, &unlit, threads))
            exit(1);
        double b = clock_seconds();
        light_world_free(&world);
        double c = clock_seconds();
        RTCScene peer = peer_scene(device, spheres, scene->sphere_count);
        double d = clock_seconds();
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

static void measure(const char *path, int rounds)
{
    static Scene scene;
    Camera camera;
    LightWorld world;
    Message message;
    if (!scene_load(path, &scene, &message)) {
        fprintf(stderr, "%s\n", message.text);
        exit(1);
    }
    Resolution screen = {960, 540};
    Image image = {.size = screen};
    int *seen = malloc((size_t)screen.width * (size_t)screen.height * sizeof *seen);
    float *spheres = malloc(((size_t)scene.sphere_count + 1) * 4 * sizeof *spheres);
    if (seen == NULL || spheres == NULL ||
        scene_camera(&scene.view, screen, &camera) != CAMERA_OK ||
        !light_world_build(&world, &scene, 2))
        exit(1);
    for (int i = 0; i < scene.sphere_count; i++) {
        for (int k = 0; k < 3; k++)
            spheres[4 * i + k] = (float)scene.spheres[i].center[k];
        spheres[4 * i + 3] = (float)scene.spheres[i].radius;
    }
    Work work = {&scene, camera, &image, 2, NULL, NULL};
    if (!bins_spheres(&work, seen))
        exit(1);
    RayList shadow = {0}, mirror = {0};
    collect(&world, seen, camera, screen, &shadow, &mirror);
    LightPaths paths;
    if (!light_paths_begin(&paths, &world, 0))
        exit(1);
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    Both both = {&world, peer_scene(device, spheres, scene.sphere_count), paths.nearest,
                 paths.before};
    printf("%s, %d spheres\n", path, scene.sphere_count);
    compare("shadow", &both, &shadow, ours_shadow, peer_shadow, rounds);
    compare("mirror", &both, &mirror, ours_mirror, peer_mirror, rounds);
    for (int threads = 1; threads <= 2; threads++)
        compare_building(&scene, spheres, threads, rounds);
    rtcReleaseScene(both.peer);
    rtcReleaseDevice(device);
    light_paths_end(&paths);
    light_world_free(&world);
    free(shadow.lines), free(shadow.singles), free(shadow.reaches);
    free(mirror.lines), free(mirror.singles), free(mirror.reaches);
    free(seen);
    free(spheres);
    scene_free(&scene);
}

int main(int argc, char **argv)
{
    int first = 1, rounds = 7;
    if (argc > 3 && strcmp(argv[1], "-r") == 0) {
        rounds = atoi(argv[2]);
        first = 3;
    }
    if (first >= argc || rounds < 1 || rounds > MOST_ROUNDS) {
        fprintf(stderr, "Usage: any_rays [-r ROUNDS, 1 to %d] SCENE.nff...\n", MOST_ROUNDS);
        return 2;
    }
    for (int i = first; i < argc; i++)
        measure(argv[i], rounds);
    return 0;
}
