// light_paths.c - the color of a ray: what it hits, which lights arrive there, and what it sees in
// a mirror.
#include "chapters/08-fast/engines/light.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"

#include <stdlib.h>

// ---- by the chapters' functions ---------------------------------------------------------------

static Ray ray_of(const Paths *paths, int i)
{
    return (Ray){vector_of(&paths->origin, i), vector_of(&paths->direction, i)};
}

static Sphere path_sphere(const Paths *paths, int i)
{
    return (Sphere){vector_of(&paths->center, i), paths->radius[i], paths->surface[i]};
}

static void rays(const LightWorld *world, const int *columns, const int *rows, Paths *paths)
{
    for (int i = 0; i < paths->count; i++) {
        Pixel sample = {columns[i], rows[i]};
        Ray ray = pixel_ray(world->camera, world->samples, sample);
        set_vector(&paths->origin, i, ray.origin);
        set_vector(&paths->direction, i, ray.direction);
    }
}

static bool hits(Paths *paths)
{
    for (int i = 0; i < paths->count; i++)
        paths->t[i] = hit_sphere(ray_of(paths, i), path_sphere(paths, i));
    return true;
}

static void leave(Paths *paths)
{
    for (int i = 0; i < paths->count; i++) {
        Ray ray = ray_of(paths, i);
        Sphere sphere = path_sphere(paths, i);
        vec3 point = ray.origin + paths->t[i] * ray.direction;
        vec3 normal = surface_normal(sphere, point);
        normal = vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
        set_vector(&paths->point, i, point);
        set_vector(&paths->normal, i, normal);
        set_vector(&paths->start, i, offset_from_surface(sphere, point, normal));
        set_vector(&paths->mirrored, i, mirror_direction(ray.direction, normal));
    }
}

static void to_light(const Paths *paths, const Light *light, Vectors *directions)
{
    for (int i = 0; i < paths->count; i++)
        set_vector(directions, i, ray_to_light(vector_of(&paths->start, i), *light).direction);
}

// Chapter 07's shade lights a scene of one sphere, with one light after the other that arrives. A
// hidden light would add 0.
static void shade_all(const Scene *scene, const Paths *paths, const double *lit, Vectors *colors)
{
    Scene alone = *scene;
    Light *lights = malloc(((size_t)alone.light_count + 1) * sizeof *lights);
    alone.sphere_count = 1;
    for (int i = 0; i < paths->count; i++) {
        Sphere sphere = path_sphere(paths, i);
        alone.spheres = &sphere;
        alone.lights = lights;
        alone.light_count = 0;
        for (int k = 0; k < scene->light_count && lights != NULL; k++)
            if (lit[k * PATHS + i] != 0)
                lights[alone.light_count++] = scene->lights[k];
        set_vector(colors, i, shade(&alone, ray_of(paths, i), (Hit){paths->t[i], 0}));
    }
    free(lights);
}

static void add_clamped(const Vectors *colors, const int *places, int count, Vectors *sums)
{
    for (int i = 0; i < count; i++)
        set_vector(sums, places[i], vector_of(sums, places[i]) + clamp_color(vector_of(colors, i)));
}

const LightSteps steps_by_chapters = {rays, hits, leave, to_light, shade_all, add_clamped};

// ---- the world --------------------------------------------------------------------------------

bool light_world_build(LightWorld *world)
{
    const Scene *scene = world->scene;
    world->grids = calloc((size_t)scene->light_count + 1, sizeof *world->grids);
    bool built = world->grids != NULL && hierarchy_build(&world->hierarchy, scene, BOXES) &&
                 wide_build(&world->wide, &world->hierarchy);
    for (int i = 0; built && i < scene->light_count; i++)
        built = light_grid_build(&world->grids[i], scene, &world->wide, scene->lights[i]);
    return built;
}

void light_world_free(LightWorld *world)
{
    hierarchy_free(&world->hierarchy);
    wide_free(&world->wide);
    for (int i = 0; world->grids != NULL && i < world->scene->light_count; i++)
        bins_free(&world->grids[i]);
    free(world->grids);
}

// ---- one thread's paths -----------------------------------------------------------------------

// One piece of memory; cleared, so that lanes without a path compute with ordinary numbers.
LightPaths *light_paths_create(const LightWorld *world, const LightSteps *steps)
{
    size_t lights = (size_t)world->scene->light_count, levels = (size_t)world->depth + 1;
    size_t doubles = (lights + levels) * PATHS, size = sizeof(LightPaths);
    size += (levels + 1) * sizeof(Vectors) + doubles * sizeof(double);
    LightPaths *paths = lanes_memory(size);
    if (paths == NULL)
        return NULL;
    memset(paths, 0, size);
    paths->world = world;
    paths->steps = steps;
    paths->nearest_of_many = LANES_BEST(nearest_of_many);
    paths->colors = (Vectors *)(paths + 1);
    paths->parts = paths->colors[levels + 1].x;
    paths->lit = paths->parts + levels * PATHS;
    return paths;
}

// ---- what a ray hits --------------------------------------------------------------------------

// Copies the chosen ones, which are in order, to the front.
static void choose(const Vectors *from, const int *chosen, int count, Vectors *to)
{
    for (int i = 0; i < count; i++)
        put(to, i, get(from, chosen[i]));
}

// The spheres that the rays hit, or -1. mirrored: the rays leave the spheres that they hit last.
static void find_spheres(LightPaths *all, bool mirrored)
{
    Paths *paths = &all->paths;
    const LightWorld *world = all->world;
    Rays rays = {&paths->origin, &paths->direction, NULL, false, paths->count, {0},
                 &paths->center, paths->radius};
    int places[PATHS];
    for (int i = 0; i < paths->count; i++)
        rays.left[i] = mirrored ? world->wide.places[paths->sphere[i]] : NO_PLACE;
    all->nearest_of_many(&world->wide, &rays, places);
    for (int i = 0; i < paths->count; i++) {
        int sphere = places[i] < 0 ? -1 : world->hierarchy.order[places[i]];
        if (places[i] == IN_DOUBT)
            sphere = hierarchy_nearest(&world->hierarchy, world->scene, ray_of(paths, i)).sphere;
        paths->sphere[i] = sphere;
        __builtin_prefetch(&world->scene->spheres[sphere < 0 ? 0 : sphere]);
    }
}

// These paths go on.
static void keep(Paths *paths, const int *kept, int count)
{
    for (int i = 0; i < count; i++) {
        paths->number[i] = paths->number[kept[i]];
        paths->sphere[i] = paths->sphere[kept[i]];
        paths->radius[i] = paths->radius[kept[i]];
    }
    choose(&paths->center, kept, count, &paths->center);
    paths->count = count;
}

// The rays that hit nothing see the background, and end. The others will get their colors later.
// The list is written without an 'if', because a processor cannot predict it.
static void end_at_background(LightPaths *all, int level)
{
    Paths *paths = &all->paths;
    int hits[PATHS] = {0}, count = 0;
    for (int i = 0; i < paths->count; i++) {
        hits[count] = i;
        count += paths->sphere[i] >= 0;
    }
    if (count == paths->count)
        return;
    for (int i = 0; i < PATHS; i++)
        set_vector(&all->colors[level], i, all->world->scene->background);
    choose(&paths->origin, hits, count, &paths->origin);
    choose(&paths->direction, hits, count, &paths->direction);
    keep(paths, hits, count);
}

// Where the rays hit their spheres. False: some miss them.
static bool find_hits(LightPaths *all)
{
    Paths *paths = &all->paths;
    bool any_miss = false;
    for (int i = 0; i < paths->count; i++) {
        const Sphere *sphere = &all->world->scene->spheres[paths->sphere[i]];
        set_vector(&paths->center, i, sphere->center);
        paths->radius[i] = sphere->radius;
        paths->surface[i] = sphere->surface;
    }
    if (!all->steps->hits(paths))
        steps_by_chapters.hits(paths);
    for (int i = 0; i < paths->count; i++) {
        bool miss = !(paths->t[i] < NO_HIT);
        paths->sphere[i] = miss ? -1 : paths->sphere[i];
        any_miss |= miss;
    }
    return !any_miss;
}

// ---- which lights arrive ----------------------------------------------------------------------

// Whether a light arrives, by chapter 07's function in a world with only the nearest sphere: if
// that does not hide the light, none does.
static bool arrives(const LightWorld *world, vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    int sphere = hierarchy_nearest(&world->hierarchy, world->scene, ray).sphere;
    Scene only = {.spheres = world->scene->spheres + (sphere < 0 ? 0 : sphere), .sphere_count = 1};
    return sphere < 0 || visibility(&only, from, light) > 0;
}

static void find_light(LightPaths *all, int number)
{
    const Paths *paths = &all->paths;
    const LightWorld *world = all->world;
    const Light light = world->scene->lights[number];
    const Bins *grid = light.kind == LIGHT_DISTANT ? NULL : &world->grids[number];
    double *lit = all->lit + number * PATHS;
    Rays rays = {&paths->start, &all->directions, grid,         true, paths->count,
                 {0},           &paths->center,   paths->radius};
    int places[PATHS];
    all->steps->to_light(paths, &light, &all->directions);
    for (int i = 0; i < paths->count; i++)
        rays.left[i] = world->wide.places[paths->sphere[i]];
    all->nearest_of_many(&world->wide, &rays, places);
    for (int i = 0; i < paths->count; i++)
        lit[i] = places[i] == NO_PLACE ||
                 (places[i] == IN_DOUBT && arrives(world, vector_of(&paths->start, i), light));
}

// ---- colors ----------------------------------------------------------------------------------

// The paths that have hit something are colored; those on mirrors go on. all_hit: no path of the
// level, or of those before, has ended.
static void light_up(LightPaths *all, int level, bool all_hit)
{
    Paths *paths = &all->paths;
    Vectors *colors = &all->colors[level],
            *found = all_hit ? colors : &all->colors[all->world->depth + 1];
    double *parts = all->parts + (size_t)level * PATHS;
    int mirrors[PATHS] = {0}, count = 0;
    all->steps->leave(paths);
    for (int i = 0; i < all->world->scene->light_count; i++)
        find_light(all, i);
    all->steps->shade(all->world->scene, paths, all->lit, found);
    for (int i = 0; i < paths->count && !all_hit; i++)
        put(colors, paths->number[i], get(found, i));
    if (level == all->world->depth) {
        paths->count = 0;
        return;
    }
    for (int i = 0; i < paths->count; i++) {
        double part = all->world->scene->surfaces[paths->surface[i]].specular;
        parts[paths->number[i]] = part;
        __builtin_prefetch(&all->world->wide.places[paths->sphere[i]]);
        mirrors[count] = i;
        count += part > 0;
    }
    choose(&paths->start, mirrors, count, &paths->origin);
    choose(&paths->mirrored, mirrors, count, &paths->direction);
    keep(paths, mirrors, count);
}

void path_colors(LightPaths *all, bool known)
{
    Paths *paths = &all->paths;
    int count = paths->count, level = 0;
    for (int i = 0; i < count; i++)
        paths->number[i] = i;
    for (; paths->count > 0; level++) {
        memset(all->parts + (size_t)level * PATHS, 0, PATHS * sizeof *all->parts);
        if (level > 0 || !known) {
            find_spheres(all, level > 0);
            end_at_background(all, level);
        }
        while (!find_hits(all))
            end_at_background(all, level);
        light_up(all, level, paths->count == count);
    }
    // trace_ray adds from the last mirror to the first.
    for (level -= 2; level >= 0; level--) {
        Vectors *colors = &all->colors[level];
        for (int k = 0; k < count; k++) {
            double part = all->parts[level * PATHS + k];
            if (part > 0)
                put(colors, k, plus(get(colors, k), times(part, get(&colors[1], k))));
        }
    }
}

// ---- whether the lanes agree with the chapters ------------------------------------------------

const LightSteps *steps_for(const LightWorld *world, const int *columns, const int *rows, int count)
{
    const LightSteps *const both[2] = {&steps_by_chapters, LANES_BEST(light_steps)};
    int places[PATHS];
    for (int i = 0; i < PATHS; i++)
        places[i] = i;
    for (int first = 0; first < count; first += PATHS) {
        const int some = least(count - first, PATHS);
        Vectors sums[2];
        memset(sums, 0, sizeof sums);
        for (int i = 0; i < 2; i++) {
            LightPaths *paths = light_paths_create(world, both[i]);
            if (paths == NULL)
                return both[0];
            paths->paths.count = some;
            both[i]->rays(world, columns + first, rows + first, &paths->paths);
            path_colors(paths, false);
            both[i]->add_clamped(paths->colors, places, some, &sums[i]);
            free(paths);
        }
        if (memcmp(&sums[0], &sums[1], sizeof sums[0]) != 0)
            return both[0];
    }
    return both[1];
}
