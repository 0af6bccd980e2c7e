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
    *world = (LightWorld){.scene = scene,
                          .crowd = crowd_of(scene),
                          .grids = calloc((size_t)scene->light_count + 1, sizeof *world->grids)};
    bool done = world->grids != NULL && hierarchy_build(&world->hierarchy, scene, LANES, threads) &&
                ray_world_build(&world->rays, &world->hierarchy, scene);
    if (scene->sphere_count == 0 && done)
        return true;
    for (int i = 0; i < scene->light_count && done; i++)
        done = light_grid_build(&world->grids[i], &world->crowd, scene->lights[i], threads);
    if (done)
        return true;
    light_world_free(world);
    return false;
}

void light_world_free(LightWorld *world)
{
    hierarchy_free(&world->hierarchy);
    for (int i = 0; world->grids != NULL && i < world->scene->light_count; i++)
        light_grid_free(&world->grids[i]);
    free(world->grids);
    ray_world_free(&world->rays);
    *world = (LightWorld){0};
}

// ---- one thread's paths -----------------------------------------------------------------------

bool light_paths_begin(LightPaths *paths, const LightWorld *world, int depth)
{
    static NearestOf *const nearest[LANES_KINDS] = LANES_TABLE(nearest_of);
    static AnyBefore *const before[LANES_KINDS] = LANES_TABLE(any_before);
    static NearestOfMany *const nearest_of_many[LANES_KINDS] = LANES_TABLE(nearest_of_many);
    size_t lights = (size_t)world->scene->light_count, levels = (size_t)depth + 1;
    *paths = (LightPaths){.world = world,
                          .depth = depth,
                          .alone = *world->scene,
                          .paths = malloc(PATHS * sizeof *paths->paths),
                          .lit = malloc((lights + 1) * PATHS * sizeof *paths->lit),
                          .colors = malloc(levels * PATHS * sizeof *paths->colors),
                          .parts = malloc(levels * PATHS * sizeof *paths->parts),
                          .nearest = nearest[lanes_best()],
                          .before = before[lanes_best()],
                          .nearest_of_many = nearest_of_many[lanes_best()]};
    paths->alone.sphere_count = 1;
    paths->alone.lights = malloc((lights + 1) * sizeof *paths->alone.lights);
    if (paths->paths != NULL && paths->lit != NULL && paths->colors != NULL &&
        paths->parts != NULL && paths->alone.lights != NULL)
        return true;
    light_paths_end(paths);
    return false;
}

void light_paths_end(LightPaths *paths)
{
    free(paths->paths);
    free(paths->lit);
    free(paths->colors);
    free(paths->parts);
    free(paths->alone.lights);
}

static Line line_of(Ray ray, double *length)
{
    *length = vec3_length(ray.direction);
    vec3 o = ray.origin, v = ray.direction / *length;
    return (Line){{o[0], o[1], o[2]}, {v[0], v[1], v[2]}};
}

// ---- what a ray hits --------------------------------------------------------------------------

static Hit hit_at(const LightWorld *world, Ray ray, int place)
{
    int sphere = world->hierarchy.order[place];
    return (Hit){hit_sphere(ray, world->scene->spheres[sphere]), sphere};
}

// The same hit as chapter 06's nearest_hit, to the bit: one ray, alone.
static Hit nearest_alone(const LightPaths *paths, Ray ray)
{
    const LightWorld *world = paths->world;
    double length;
    Line line = line_of(ray, &length);
    PossibleHits candidates;
    paths->nearest(&world->rays, &line, &candidates);
    if (candidates.count > MOST_CANDIDATES)
        return hierarchy_nearest(&world->hierarchy, world->scene, ray);
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < candidates.count; i++)
        nearest = nearer(nearest, hit_at(world, ray, candidates.places[i]));
    return nearest;
}

// The same for the paths numbered in 'going'.
static void find_hits(LightPaths *paths, const int *going, int count)
{
    Line lines[PATHS] = {0};
    int places[PATHS];
    double length;
    for (int i = 0; i < count; i++)
        lines[i] = line_of(paths->paths[going[i]].ray, &length);
    paths->nearest_of_many(&paths->world->rays, lines, count, places);
    for (int i = 0; i < count; i++) {
        Path *path = &paths->paths[going[i]];
        if (places[i] == IN_DOUBT)
            path->hit = nearest_alone(paths, path->ray);
        else if (places[i] == NO_PLACE)
            path->hit = (Hit){NO_HIT, -1};
        else
            path->hit = hit_at(paths->world, path->ray, places[i]);
    }
}

// ---- which lights arrive ----------------------------------------------------------------------

// Whether a sphere hides a light, by chapter 07's function, in a world with only this sphere.
static bool hides(const Sphere *sphere, vec3 from, Light light)
{
    Sphere alone = *sphere;
    Scene world = {.spheres = &alone, .sphere_count = 1};
    return !(visibility(&world, from, light) > 0);
}

// Whether a light with a grid arrives at a place.
static bool arrives_by_grid(const LightGrid *grid, Ray to_light, Light light)
{
    PossibleHits candidates;
    const Scene *scene = grid->crowd->scene;
    if (light_grid_hides(grid, to_light, &candidates))
        return false;
    if (candidates.count > MOST_CANDIDATES)
        return visibility(scene, to_light.origin, light) > 0;
    for (int i = 0; i < candidates.count; i++)
        if (hides(&scene->spheres[candidates.places[i]], to_light.origin, light))
            return false;
    return true;
}

// Whether a light arrives at a place: one ray, alone.
static bool arrives_alone(const LightPaths *paths, vec3 from, Light light)
{
    const LightWorld *world = paths->world;
    PossibleHits candidates = {0};
    double length;
    Line line = line_of(ray_to_light(from, light), &length);
    double reach = light.kind == LIGHT_DISTANT ? INFINITY : length;
    if (paths->before(&world->rays, &line, reach, &candidates))
        return false;
    if (candidates.count > MOST_CANDIDATES)
        return visibility(world->scene, from, light) > 0;
    for (int i = 0; i < candidates.count; i++)
        if (hides(&world->scene->spheres[world->hierarchy.order[candidates.places[i]]], from,
                  light))
            return false;
    return true;
}

// Whether a surface certainly hides a light from itself, because the light is behind it.
static bool is_behind(const Path *path, const Sphere *sphere, Ray to_light, bool has_end)
{
    double along = vec3_dot(path->normal, to_light.direction);
    double squared = vec3_dot(to_light.direction, to_light.direction);
    vec3 c = sphere->center;
    double size = sphere->radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
    return along < 0 && along * along > 1e-4 * squared &&
           (!has_end || squared > 1e-6 * size * size);
}

static void find_light(LightPaths *paths, const int *going, int count, int number)
{
    const LightWorld *world = paths->world;
    const Scene *scene = world->scene;
    Light light = scene->lights[number];
    bool has_end = light.kind != LIGHT_DISTANT;
    const LightGrid *grid = &world->grids[number];
    for (int k = 0; k < count; k++) {
        Path *path = &paths->paths[going[k]];
        Ray ray = ray_to_light(path->start, light);
        bool *lit = &paths->lit[going[k] * scene->light_count + number];
        *lit = false;
        bool behind = is_behind(path, &scene->spheres[path->hit.sphere], ray, has_end);
        if (!behind)
            *lit = grid->count > 0 ? arrives_by_grid(grid, ray, light)
                                   : arrives_alone(paths, path->start, light);
    }
}

// ---- colours ----------------------------------------------------------------------------------

// The colour of a path's surface, by chapter 07's function.
static Color lit_surface(LightPaths *paths, int number)
{
    const Scene *scene = paths->world->scene;
    const Path *path = &paths->paths[number];
    Sphere sphere = scene->spheres[path->hit.sphere];
    paths->alone.spheres = &sphere;
    paths->alone.light_count = 0;
    for (int i = 0; i < scene->light_count; i++)
        if (paths->lit[number * scene->light_count + i])
            paths->alone.lights[paths->alone.light_count++] = scene->lights[i];
    return shade(&paths->alone, path->ray, (Hit){path->hit.t, 0});
}

static void leave_surface(Path *path, const Sphere *sphere)
{
    vec3 point = path->ray.origin + path->hit.t * path->ray.direction;
    vec3 normal = surface_normal(*sphere, point);
    path->normal = vec3_dot(normal, path->ray.direction) > 0 ? -normal : normal;
    path->start = off_surface(*sphere, point, path->normal);
}

// One step of all paths that go on: from what their rays hit to the rays that continue from
// mirrors. Returns the number of those.
static int step(LightPaths *paths, int *going, int count, int level)
{
    const Scene *scene = paths->world->scene;
    Color *colors = paths->colors + (size_t)level * PATHS;
    double *parts = paths->parts + (size_t)level * PATHS;
    int on_surface = 0;
    for (int k = 0; k < count; k++) {
        Path *path = &paths->paths[going[k]];
        path->last = level;
        colors[going[k]] = scene->background;
        if (path->hit.sphere < 0)
            continue;
        leave_surface(path, &scene->spheres[path->hit.sphere]);
        going[on_surface++] = going[k];
    }
    for (int i = 0; i < scene->light_count; i++)
        find_light(paths, going, on_surface, i);
    int mirrored = 0;
    for (int k = 0; k < on_surface; k++) {
        Path *path = &paths->paths[going[k]];
        colors[going[k]] = lit_surface(paths, going[k]);
        parts[going[k]] = scene_surface(scene, path->hit.sphere)->specular;
        if (level == paths->depth || !(parts[going[k]] > 0))
            continue;
        path->ray = (Ray){path->start, mirror_direction(path->ray.direction, path->normal)};
        going[mirrored++] = going[k];
    }
    return mirrored;
}

void path_colors(LightPaths *paths, const Ray *rays, const int *spheres, int count, Color *colors)
{
    int going[PATHS];
    for (int i = 0; i < count; i++) {
        Path *path = &paths->paths[i];
        path->ray = rays[i];
        going[i] = i;
        if (spheres != NULL && spheres[i] < 0)
            path->hit = (Hit){NO_HIT, -1};
        else if (spheres != NULL)
            path->hit =
                (Hit){hit_sphere(rays[i], paths->world->scene->spheres[spheres[i]]), spheres[i]};
    }
    for (int level = 0, left = count; left > 0; level++) {
        if (level > 0 || spheres == NULL)
            find_hits(paths, going, left);
        left = step(paths, going, left, level);
    }
    // trace_ray adds from the last mirror to the first.
    for (int i = 0; i < count; i++) {
        int level = paths->paths[i].last;
        Color color = paths->colors[level * PATHS + i];
        while (level-- > 0)
            color = paths->colors[level * PATHS + i] + paths->parts[level * PATHS + i] * color;
        colors[i] = color;
    }
}
