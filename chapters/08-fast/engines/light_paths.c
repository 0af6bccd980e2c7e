// light_paths.c - the colour of a ray: what it hits, which lights arrive there, and what it sees in
// a mirror.
#include "chapters/08-fast/engines/light_paths.h"

#include "chapters/08-fast/engines/large_memory.h"
#include "chapters/08-fast/engines/nearest_hit.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"

#include <stdlib.h>

// ---- the world --------------------------------------------------------------------------------

bool light_world_build(LightWorld *world, const Scene *scene, int threads)
{
    size_t count = (size_t)scene->sphere_count, room = count + ASKED;
    *world = (LightWorld){.scene = scene, .numbers = large_memory(4 * room * sizeof(double))};
    world->places = large_memory((count + 1) * sizeof *world->places);
    if (world->numbers == NULL || world->places == NULL ||
        !hierarchy_build(&world->hierarchy, scene, threads)) {
        light_world_free(world);
        return false;
    }
    double *x = world->numbers, *y = x + room, *z = y + room, *r = z + room;
    for (size_t i = 0; i < room; i++) {
        const Sphere *sphere =
            i < count ? &scene->spheres[world->hierarchy.order[i]] : &(const Sphere){0};
        x[i] = sphere->center[0];
        y[i] = sphere->center[1];
        z[i] = sphere->center[2];
        r[i] = sphere->radius;
        if (i < count)
            world->places[world->hierarchy.order[i]] = (int)i;
    }
    world->rays = (RayWorld){.x = x, .y = y, .z = z, .r = r};
    if (count == 0)
        return true;
    const Box *box = &world->hierarchy.nodes[0].box;
    double size = 0;
    for (int axis = 0; axis < 3; axis++)
        size = fmax(size, box->high[axis] - box->low[axis]);
    world->rays.scale = 1 / size;
    world->rays.nodes = world->wide = wide_build(&world->hierarchy, 1 / size);
    if (world->wide != NULL)
        return true;
    light_world_free(world);
    return false;
}

void light_world_free(LightWorld *world)
{
    hierarchy_free(&world->hierarchy);
    free(world->wide);
    free(world->places);
    free(world->numbers);
    *world = (LightWorld){0};
}

// ---- one thread's paths -----------------------------------------------------------------------

bool light_paths_begin(LightPaths *paths, const LightWorld *world, const int *seen, int columns)
{
    static NearestOf *const nearest_of[LANES_KINDS] = LANES_TABLE(nearest_of);
    static AnyBefore *const any_before[LANES_KINDS] = LANES_TABLE(any_before);
    size_t lights = (size_t)world->scene->light_count;
    *paths = (LightPaths){.world = world,
                          .seen = seen,
                          .columns = columns,
                          .alone = *world->scene,
                          .hiding = malloc((lights + 1) * sizeof *paths->hiding),
                          .nearest = nearest_of[lanes_best()],
                          .before = any_before[lanes_best()]};
    paths->alone.sphere_count = 1;
    paths->alone.lights = malloc((lights + 1) * sizeof *paths->alone.lights);
    for (size_t i = 0; i < lights && paths->hiding != NULL; i++)
        paths->hiding[i] = -1;
    if (paths->hiding != NULL && paths->alone.lights != NULL)
        return true;
    light_paths_end(paths);
    return false;
}

void light_paths_end(LightPaths *paths)
{
    free(paths->hiding);
    free(paths->alone.lights);
}

static Line line_of(Ray ray, double *length)
{
    *length = vec3_length(ray.direction);
    vec3 o = ray.origin, v = ray.direction / *length;
    return (Line){{o[0], o[1], o[2]}, {v[0], v[1], v[2]}};
}

// The same hit as chapter 06's nearest_hit, to the bit.
static Hit nearest(const LightPaths *paths, Ray ray)
{
    const LightWorld *world = paths->world;
    double length;
    Line line = line_of(ray, &length);
    Candidates candidates;
    paths->nearest(&world->rays, &line, &candidates);
    if (candidates.count > MOST_CANDIDATES)
        return hierarchy_nearest(&world->hierarchy, world->scene, ray);
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < candidates.count; i++) {
        int sphere = world->hierarchy.order[candidates.places[i]];
        nearest = nearer(nearest, (Hit){hit_sphere(ray, world->scene->spheres[sphere]), sphere});
    }
    return nearest;
}

// Whether a sphere hides a light, by chapter 07's function, in a world with only this sphere.
static bool hides(const Sphere *sphere, vec3 from, Light light)
{
    Sphere alone = *sphere;
    Scene world = {.spheres = &alone, .sphere_count = 1};
    return !(visibility(&world, from, light) > 0);
}

// Whether a light arrives at a place just off a sphere.
static bool arrives(const LightPaths *paths, vec3 from, int sphere, int number)
{
    const LightWorld *world = paths->world;
    Light light = world->scene->lights[number];
    int own = world->places[sphere];
    Candidates candidates = {1, {own}};
    if (paths->hiding[number] >= 0)
        candidates.places[candidates.count++] = paths->hiding[number];
    double length;
    Line line = line_of(ray_to_light(from, light), &length);
    double reach = light.kind == LIGHT_DISTANT ? INFINITY : length;
    if (paths->before(&world->rays, &line, reach, &candidates)) {
        if (candidates.places[0] != own)
            paths->hiding[number] = candidates.places[0];
        return false;
    }
    if (candidates.count > MOST_CANDIDATES)
        return visibility(world->scene, from, light) > 0;
    for (int i = 0; i < candidates.count; i++)
        if (hides(&world->scene->spheres[world->hierarchy.order[candidates.places[i]]], from,
                  light))
            return false;
    return true;
}

static Color color_of(LightPaths *paths, Ray ray, Hit hit, int depth)
{
    const Scene *scene = paths->world->scene;
    if (hit.sphere < 0)
        return scene->background;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(sphere, point);
    if (vec3_dot(normal, ray.direction) > 0)
        normal = -normal;
    vec3 start = off_surface(sphere, point, normal);

    Scene *alone = &paths->alone;
    alone->spheres = &sphere;
    alone->light_count = 0;
    for (int i = 0; i < scene->light_count; i++)
        if (arrives(paths, start, hit.sphere, i))
            alone->lights[alone->light_count++] = scene->lights[i];
    Color color = shade(alone, ray, (Hit){hit.t, 0});
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (depth > 0 && ks > 0) {
        Ray mirrored = {start, mirror_direction(ray.direction, normal)};
        color += ks * path_color(paths, mirrored, depth - 1);
    }
    return color;
}

Color path_color(LightPaths *paths, Ray ray, int depth)
{
    return color_of(paths, ray, nearest(paths, ray), depth);
}

Color trace_path(void *given, Pixel sample, Ray ray, int depth)
{
    LightPaths *paths = given;
    if (paths->seen == NULL)
        return path_color(paths, ray, depth);
    const Scene *scene = paths->world->scene;
    int sphere = paths->seen[(size_t)sample.row * (size_t)paths->columns + (size_t)sample.column];
    if (sphere < 0)
        return scene->background;
    return color_of(paths, ray, (Hit){hit_sphere(ray, scene->spheres[sphere]), sphere}, depth);
}
