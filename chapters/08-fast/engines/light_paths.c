// light_paths.c - the colour of a ray: what it hits, which lights arrive there, and what it sees in
// a mirror.
#include "chapters/08-fast/engines/light_paths.h"

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/shadow_lanes.h"
#include "common/large_pages.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { FEW = 4 };

// ---- the world --------------------------------------------------------------------------------

typedef struct {
    LightWorld *world;
    int threads;
    atomic_bool failed;
} Building;

// Part 0 is the hierarchy, the others are the grids of the lights.
static void build_part(void *given, int part)
{
    Building *building = given;
    LightWorld *world = building->world;
    const Scene *scene = world->scene;
    bool done = part == 0 ? hierarchy_build(&world->hierarchy, scene, LANES, building->threads) &&
                                ray_world_build(&world->rays, &world->hierarchy, building->threads)
                          : light_grid_build(&world->grids[part - 1], &world->crowd,
                                             scene->lights[part - 1]);
    if (!done)
        atomic_store(&building->failed, true);
}

bool light_world_build(LightWorld *world, const Scene *scene, int threads)
{
    *world = (LightWorld){.scene = scene,
                          .crowd = crowd_of(scene),
                          .grids = calloc((size_t)scene->light_count + 1, sizeof *world->grids),
                          .materials = materials_of(scene)};
    Building building = {.world = world, .threads = threads};
    if (world->grids != NULL && world->materials != NULL) {
        in_parallel(threads, 1 + scene->light_count, build_part, &building);
        if (!building.failed)
            return true;
    }
    light_world_free(world);
    return false;
}

void light_world_free(LightWorld *world)
{
    hierarchy_free(&world->hierarchy);
    for (int i = 0; world->grids != NULL && i < world->scene->light_count; i++)
        light_grid_free(&world->grids[i]);
    free(world->grids);
    free(world->materials);
    ray_world_free(&world->rays);
    *world = (LightWorld){0};
}

// ---- one thread's paths -----------------------------------------------------------------------

static const ShadowLanes *const shadow_lanes[LANES_KINDS] = LANES_TABLE(shadow_lanes);

// Cleared, so that lanes without a path compute with ordinary numbers.
static void *aligned_memory(size_t size)
{
    void *memory = large_memory(size);
    return memory == NULL ? NULL : memset(memory, 0, size);
}

bool light_paths_begin(LightPaths *paths, const LightWorld *world, int depth)
{
    static NearestOf *const nearest[LANES_KINDS] = LANES_TABLE(nearest_of);
    static NearestOfMany *const nearest_of_many[LANES_KINDS] = LANES_TABLE(nearest_of_many);
    size_t lights = (size_t)world->scene->light_count + 1, levels = (size_t)depth + 1;
    *paths = (LightPaths){.world = world,
                          .depth = depth,
                          .picture = {.scene = world->scene, .materials = world->materials},
                          .steps = &steps_by_chapters,
                          .paths = aligned_memory(2 * sizeof *paths->paths),
                          .directions = aligned_memory(2 * sizeof *paths->directions),
                          .lit = aligned_memory(lights * PATHS * sizeof *paths->lit),
                          .colors = aligned_memory((levels + 1) * sizeof *paths->colors),
                          .parts = aligned_memory(levels * PATHS * sizeof *paths->parts),
                          .nearest = nearest[lanes_best()],
                          .nearest_of_many = nearest_of_many[lanes_best()]};
    if (paths->paths != NULL && paths->directions != NULL && paths->lit != NULL &&
        paths->colors != NULL && paths->parts != NULL)
        return true;
    light_paths_end(paths);
    return false;
}

void light_paths_end(LightPaths *paths)
{
    free(paths->paths);
    free(paths->directions);
    free(paths->lit);
    free(paths->colors);
    free(paths->parts);
}

static Line line_of(vec3 start, vec3 unit)
{
    return (Line){{start[0], start[1], start[2]}, {unit[0], unit[1], unit[2]}};
}

// ---- what a ray hits --------------------------------------------------------------------------

static Hit hit_at(const LightWorld *world, Ray ray, int place)
{
    int sphere = world->hierarchy.order[place];
    return (Hit){hit_sphere(ray, world->scene->spheres[sphere]), sphere};
}

// The sphere of chapter 06's nearest_hit: one ray, alone. If only one sphere is possible, the ray
// may still miss it.
static int nearest_alone(const LightPaths *paths, Ray ray, Line line)
{
    const LightWorld *world = paths->world;
    PossibleHits candidates;
    paths->nearest(&world->rays, &line, &candidates);
    if (candidates.count > MOST_CANDIDATES)
        return hierarchy_nearest(&world->hierarchy, world->scene, ray).sphere;
    if (candidates.count == 1)
        return world->hierarchy.order[candidates.places[0]];
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < candidates.count; i++)
        nearest = nearer(nearest, hit_at(world, ray, candidates.places[i]));
    return nearest.sphere;
}

static void find_distances(const LightPaths *all, Paths *paths)
{
    take_spheres(all->world->scene, paths);
    if (!all->steps->hits(paths))
        steps_by_chapters.hits(paths);
}

// Copies the chosen ones, which are in order, to the front.
static void choose(const Vectors *from, const int *chosen, int count, Vectors *to)
{
    if (count > 0 && chosen[count - 1] == count - 1) { // all
        memcpy(to, from, sizeof *to);
        return;
    }
    for (int i = 0; i < count; i++) {
        to->x[i] = from->x[chosen[i]];
        to->y[i] = from->y[chosen[i]];
        to->z[i] = from->z[chosen[i]];
    }
}

// If there are only FEW spheres: the rays that may hit several ask all. As in chapter 06, the lower
// index wins if two hits are equally near.
static void ask_few_spheres(LightPaths *all)
{
    const Scene *scene = all->world->scene;
    Paths *paths = all->paths, *asking = all->paths + 1;
    double numbers[4 * FEW], nearest[PATHS];
    int may[PATHS], several[PATHS] = {0}, count = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        for (int axis = 0; axis < 3; axis++)
            numbers[4 * i + axis] = scene->spheres[i].center[axis];
        numbers[4 * i + 3] = scene->spheres[i].radius;
    }
    all->steps->may_hit(paths, numbers, scene->sphere_count, may);
    for (int i = 0; i < paths->count; i++) {
        paths->sphere[i] = may[i] == 0 ? -1 : __builtin_ctz((unsigned)may[i]);
        nearest[i] = NO_HIT;
        several[count] = i;
        count += (may[i] & (may[i] - 1)) != 0;
    }
    asking->count = count;
    choose(&paths->origin, several, count, &asking->origin);
    choose(&paths->direction, several, count, &asking->direction);
    for (int sphere = 0; sphere < scene->sphere_count && count > 0; sphere++) {
        for (int i = 0; i < count; i++)
            asking->sphere[i] = sphere;
        find_distances(all, asking);
        for (int i = 0; i < count; i++)
            if (asking->t[i] < nearest[i]) {
                nearest[i] = asking->t[i];
                paths->sphere[several[i]] = sphere;
            }
    }
}

// The spheres that the rays hit, or -1. mirrored: the rays leave the spheres that they hit last.
static void find_spheres(LightPaths *all, bool mirrored)
{
    Paths *paths = all->paths;
    double lengths[PATHS];
    Line lines[PATHS];
    int left[PATHS], places[PATHS];
    if (all->world->scene->sphere_count <= FEW) {
        ask_few_spheres(all);
        return;
    }
    shadow_lanes[lanes_best()]->units(&paths->direction, paths->count, lengths, all->directions);
    for (int i = 0; i < paths->count; i++) {
        lines[i] = line_of(vector_of(&paths->origin, i), vector_of(all->directions, i));
        left[i] = mirrored ? all->world->rays.places[paths->sphere[i]] : NO_PLACE;
    }
    all->nearest_of_many(&all->world->rays, lines, left, paths->count, places);
    for (int i = 0; i < paths->count; i++)
        __builtin_prefetch(&all->world->hierarchy.order[places[i] < 0 ? 0 : places[i]]);
    for (int i = 0; i < paths->count; i++) {
        int sphere = places[i] == IN_DOUBT   ? nearest_alone(all, ray_of(paths, i), lines[i])
                     : places[i] == NO_PLACE ? -1
                                             : all->world->hierarchy.order[places[i]];
        paths->sphere[i] = sphere;
        __builtin_prefetch(&all->world->scene->spheres[sphere < 0 ? 0 : sphere]);
    }
}

// These paths go on.
static void keep(Paths *paths, const int *kept, int count)
{
    for (int i = 0; i < count; i++) {
        paths->number[i] = paths->number[kept[i]];
        paths->sphere[i] = paths->sphere[kept[i]];
    }
    paths->count = count;
}

// The rays that hit nothing see the background, and end. The others will get their colours later.
// The list is written without an 'if', because a processor cannot predict it.
static void end_at_background(LightPaths *all, int level)
{
    Paths *paths = all->paths;
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
    Paths *paths = all->paths;
    bool any_miss = false;
    find_distances(all, paths);
    for (int i = 0; i < paths->count; i++) {
        bool miss = !(paths->t[i] < NO_HIT);
        paths->sphere[i] = miss ? -1 : paths->sphere[i];
        any_miss |= miss;
    }
    return !any_miss;
}

// ---- which lights arrive ----------------------------------------------------------------------

// Whether a sphere hides a light, by chapter 07's function, in a world with only this sphere.
static bool hides_light(const LightWorld *world, int place, vec3 from, Light light)
{
    Sphere alone = world->scene->spheres[world->hierarchy.order[place]];
    Scene only = {.spheres = &alone, .sphere_count = 1};
    return !(visibility(&only, from, light) > 0);
}

// Whether a light is hidden from the start of a shadow ray: one ray, alone.
static bool hidden_alone(const LightPaths *all, vec3 from, Line line, Light light)
{
    const LightWorld *world = all->world;
    PossibleHits candidates;
    all->nearest(&world->rays, &line, &candidates);
    if (candidates.count > MOST_CANDIDATES)
        return !(visibility(world->scene, from, light) > 0);
    for (int i = 0; i < candidates.count; i++)
        if (hides_light(world, candidates.places[i], from, light))
            return true;
    return false;
}

// The doubtful rays ask the hierarchy. If the nearest sphere that a ray hits does not hide the
// light, none does.
static void ask_hierarchy(LightPaths *all, const ShadowRays *rays, Light light, int *verdicts)
{
    const LightWorld *world = all->world;
    Line lines[PATHS];
    int left[PATHS], places[PATHS], numbers[PATHS], count = 0;
    for (int i = 0; i < rays->count; i++) {
        if (verdicts[i] != DOUBTFUL)
            continue;
        vec3 from = vector_of(rays->start, i), way = vector_of(rays->way, i);
        double length = vec3_length(way);
        if (!(length > 0)) { // the light is there
            verdicts[i] = visibility(world->scene, from, light) > 0 ? ARRIVES : HIDDEN;
            continue;
        }
        lines[count] = line_of(from, way / length);
        left[count] = rays->passes[i] == NO_SPHERE ? NO_PLACE : world->rays.places[rays->passes[i]];
        numbers[count++] = i;
    }
    if (count == 0)
        return;
    all->nearest_of_many(&world->rays, lines, left, count, places);
    for (int k = 0; k < count; k++) {
        vec3 from = vector_of(rays->start, numbers[k]);
        bool hidden = places[k] == IN_DOUBT   ? hidden_alone(all, from, lines[k], light)
                      : places[k] == NO_PLACE ? false
                                              : hides_light(world, places[k], from, light);
        verdicts[numbers[k]] = hidden ? HIDDEN : ARRIVES;
    }
}

static void find_light(LightPaths *all, int number)
{
    const Paths *paths = all->paths;
    Light light = all->world->scene->lights[number];
    const LightGrid *grid = &all->world->grids[number];
    double *lit = all->lit + number * PATHS;
    ShadowRays rays = {.start = &paths->start,
                       .way = all->directions,
                       .endless = light.kind == LIGHT_DISTANT,
                       .count = paths->count};
    int verdicts[PATHS];
    all->steps->to_light(paths, &light, all->directions);
    shadow_lanes[lanes_best()]->passes(paths, &rays);
    light_grid_ask(grid, &rays, verdicts);
    ask_hierarchy(all, &rays, light, verdicts);
    for (int i = 0; i < paths->count; i++)
        lit[i] = verdicts[i] == ARRIVES;
}

// ---- colours ----------------------------------------------------------------------------------

// The paths that have hit something are coloured; those on mirrors go on. all_hit: no path of the
// level, or of those before, has ended.
static void light_up(LightPaths *all, int level, bool all_hit)
{
    Paths *paths = all->paths;
    Vectors *colors = &all->colors[level], *found = all_hit ? colors : &all->colors[all->depth + 1];
    double *parts = all->parts + (size_t)level * PATHS;
    int mirrors[PATHS] = {0}, count = 0;
    all->steps->leave(paths);
    for (int i = 0; i < all->world->scene->light_count; i++)
        find_light(all, i);
    all->steps->shade(&all->picture, paths, all->lit, found);
    for (int i = 0; i < paths->count && !all_hit; i++)
        set_vector(colors, paths->number[i], vector_of(found, i));
    if (level == all->depth) {
        paths->count = 0;
        return;
    }
    for (int i = 0; i < paths->count; i++) {
        double part = all->world->materials[paths->surface[i]].specular;
        parts[paths->number[i]] = part;
        __builtin_prefetch(&all->world->rays.places[paths->sphere[i]]);
        mirrors[count] = i;
        count += part > 0;
    }
    all->steps->mirror(paths, all->directions);
    choose(&paths->start, mirrors, count, &paths->origin);
    choose(all->directions, mirrors, count, &paths->direction);
    keep(paths, mirrors, count);
}

void path_colors(LightPaths *all, bool known)
{
    Paths *paths = all->paths;
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
    for (level -= 2; level >= 0; level--)
        all->steps->add_mirrors(&all->colors[level + 1], all->parts + (size_t)level * PATHS, count,
                                &all->colors[level]);
}
