// number_limits.c - whether the numbers of a scene are beyond the limits of the fast engines.
#include "chapters/08-fast/engines/number_limits.h"

#include "chapters/08-fast/engines/parallel.h"

bool extreme_camera(Camera camera)
{
    return extreme_place(camera.origin) || extreme_length(camera.distance) ||
           extreme_length(camera.width) || extreme_length(camera.height);
}

// All threads look at shares of the spheres.
enum { SHARES = 64, SMALLEST_SHARE = 8192 };
typedef struct {
    bool extreme;              // one of them is, seen from the eye
    double smallest, farthest; // radius; end of a sphere, from the eye
} Limits;
typedef struct {
    const Work *work;
    int count;
    Limits limits[SHARES];
} Shares;

static void look_at_share(void *given, int number)
{
    Shares *shares = given;
    const Scene *scene = shares->work->scene;
    const vec3 eye = shares->work->camera.origin;
    const long spheres = scene->sphere_count;
    const Sphere *sphere = scene->spheres + spheres * number / shares->count;
    const Sphere *end = scene->spheres + spheres * (number + 1) / shares->count;
    Limits limits = {.smallest = INFINITY};
    for (; sphere < end; sphere++) {
        double far = vec3_length(sphere->center - eye) + sphere->radius;
        limits.extreme |= extreme_sphere(eye, sphere);
        limits.smallest = sphere->radius < limits.smallest ? sphere->radius : limits.smallest;
        limits.farthest = far > limits.farthest ? far : limits.farthest;
    }
    shares->limits[number] = limits;
}

static Limits limits_of(const Work *work)
{
    int count = work->scene->sphere_count / SMALLEST_SHARE + 1;
    Shares shares = {.work = work, .count = count < SHARES ? count : SHARES};
    Limits all = {extreme_camera(work->camera), INFINITY, 0};
    in_parallel(work->threads, shares.count, look_at_share, &shares);
    for (int i = 0; i < shares.count; i++) {
        all.extreme |= shares.limits[i].extreme;
        all.smallest = fmin(all.smallest, shares.limits[i].smallest);
        all.farthest = fmax(all.farthest, shares.limits[i].farthest);
    }
    return all;
}

bool extreme_scene(const Work *work)
{
    return limits_of(work).extreme;
}

bool extreme_light(const Work *work)
{
    const Scene *scene = work->scene;
    Limits limits = limits_of(work);
    if (limits.extreme)
        return true;
    for (int i = 0; i < scene->light_count; i++) {
        const Light *light = &scene->lights[i];
        if (extreme_place(light->position) ||
            (light->kind == LIGHT_DISTANT && extreme_length(vec3_length(light->position))))
            return true;
    }
    return limits.farthest > EXTREME_RADII * limits.smallest;
}
