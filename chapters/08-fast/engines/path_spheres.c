// path_spheres.c - the spheres that the path of a ray meets: those it hits, by way of mirrors, and
// those that hide a light from there.
#include "chapters/08-fast/engines/path_spheres.h"

#include "chapters/08-fast/engines/nearest_hit.h"
#include "chapters/08-fast/engines/slab_test.h"
#include "exercises/07-shading.h"

#include <stdlib.h>
#include <string.h>

bool few_begin(Few *few, const Hierarchy *hierarchy, const Scene *scene, int depth)
{
    *few = (Few){.hierarchy = hierarchy, .scene = scene, .few = *scene};
    // A ray hits one sphere, and for each light one sphere that hides it is enough.
    double most = (depth + 1.0) * (scene->light_count + 1.0);
    size_t room = 1 + (size_t)fmin(most, scene->sphere_count);
    few->few.spheres = malloc(room * sizeof *few->few.spheres);
    few->indices = malloc(room * sizeof *few->indices);
    if (few->few.spheres != NULL && few->indices != NULL)
        return true;
    few_end(few);
    return false;
}

void few_end(Few *few)
{
    free(few->few.spheres);
    free(few->indices);
}

// Adds a sphere to the few, once, and in order.
static void keep(Few *few, int sphere)
{
    int count = few->few.sphere_count, i = count;
    while (i > 0 && few->indices[i - 1] > sphere)
        i--;
    if (i > 0 && few->indices[i - 1] == sphere)
        return;
    memmove(few->indices + i + 1, few->indices + i, (size_t)(count - i) * sizeof *few->indices);
    few->indices[i] = sphere;
    few->few.sphere_count++;
}

// Whether a sphere hides a light, by chapter 07's function, in a world with only this sphere.
static bool hides(const Sphere *sphere, vec3 from, Light light)
{
    Sphere alone = *sphere;
    Scene world = {.spheres = &alone, .sphere_count = 1};
    return !(visibility(&world, from, light) > 0);
}

// A sphere that hides a light; -1 if there is none. It need not be the nearest one.
static int hider(const Few *few, vec3 from, Light light)
{
    const Hierarchy *hierarchy = few->hierarchy;
    Ray ray = ray_to_light(from, light);
    Way way = way_of(ray);
    // A box that begins beyond the light, and its spheres, hide nothing; with a margin for
    // rounding.
    double reach = light.kind == LIGHT_DISTANT ? NO_HIT : 1 + 1e-9;
    int waiting[HIERARCHY_DEEPEST + 1], count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        int number = waiting[--count];
        const Node *node = &hierarchy->nodes[number];
        double enters = entry(&node->box, &way);
        if (enters == NO_HIT || enters > reach)
            continue;
        if (node->other != 0) {
            waiting[count++] = node->other;
            waiting[count++] = number + 1;
            continue;
        }
        for (int i = node->first; i < node->first + node->count; i++) {
            const Sphere *sphere = &few->scene->spheres[hierarchy->order[i]];
            if (!surely_misses(&way, ray, sphere) && hides(sphere, from, light))
                return hierarchy->order[i];
        }
    }
    return -1;
}

// Keeps the spheres that a ray and its mirrored rays meet, as far as trace_ray follows them.
static void follow(Few *few, Ray ray, int depth)
{
    const Scene *scene = few->scene;
    few->few.sphere_count = 0;
    for (;; depth--) {
        Hit hit = hierarchy_nearest(few->hierarchy, scene, ray);
        if (hit.sphere < 0)
            return;
        keep(few, hit.sphere);
        Sphere sphere = scene->spheres[hit.sphere];
        vec3 point = ray.origin + hit.t * ray.direction;
        vec3 normal = surface_normal(sphere, point);
        if (vec3_dot(normal, ray.direction) > 0)
            normal = -normal;
        vec3 start = off_surface(sphere, point, normal);
        for (int i = 0; i < scene->light_count; i++) {
            int hiding = hider(few, start, scene->lights[i]);
            if (hiding >= 0)
                keep(few, hiding);
        }
        if (depth == 0 || scene_surface(scene, hit.sphere)->specular == 0)
            return;
        ray = (Ray){start, mirror_direction(ray.direction, normal)};
    }
}

Color trace_few(void *world, Ray ray, int depth)
{
    Few *few = world;
    follow(few, ray, depth);
    for (int i = 0; i < few->few.sphere_count; i++)
        few->few.spheres[i] = few->scene->spheres[few->indices[i]];
    return trace_ray(&few->few, ray, depth);
}
