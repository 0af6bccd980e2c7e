// variants-scene.h - right answers to exercise 07 that need a scene, written in other ways.
//
// Static functions, for the one table of 07-shading.c.
#ifndef TESTS_07_SHADING_VARIANTS_SCENE_H
#define TESTS_07_SHADING_VARIANTS_SCENE_H

#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

// ---- off_surface --------------------------------------------------------------------------------

static double size_of(Sphere s)
{
    return s.radius + fmax(fabs(s.center[0]), fmax(fabs(s.center[1]), fabs(s.center[2])));
}

static vec3 a_billionth(Sphere sphere, vec3 point, vec3 normal)
{
    return point + 1e-9 * size_of(sphere) * normal;
}

static vec3 as_little_as_allowed(Sphere sphere, vec3 point, vec3 normal)
{
    return point + 0x1p-32 * size_of(sphere) * normal;
}

static vec3 as_far_as_allowed(Sphere sphere, vec3 point, vec3 normal)
{
    return point + 0x1p-28 * size_of(sphere) * normal;
}

// At most the square root of 3 times the size.
static vec3 by_the_length_of_the_centre(Sphere sphere, vec3 point, vec3 normal)
{
    return point + 1e-9 * (sphere.radius + vec3_length(sphere.center)) * normal;
}

static vec3 with_a_loop(Sphere sphere, vec3 point, vec3 normal)
{
    double size = 0;
    for (int i = 0; i < 3; i++)
        if (fabs(sphere.center[i]) > size)
            size = fabs(sphere.center[i]);
    size += sphere.radius;
    for (int i = 0; i < 3; i++)
        point[i] += ldexp(size, -29) * normal[i];
    return point;
}

// ---- visibility ---------------------------------------------------------------------------------

static double by_the_nearest_hit(const Scene *scene, vec3 from, Light light)
{
    Hit hit = nearest_hit(ray_to_light(from, light), scene);
    if (light.kind == LIGHT_DISTANT)
        return hit.sphere < 0;
    return hit.t >= 1;
}

static double in_lengths(const Scene *scene, vec3 from, Light light)
{
    vec3 way = light.kind == LIGHT_DISTANT ? light.position : light.position - from;
    Ray ray = {from, vec3_unit(way)};
    double most = light.kind == LIGHT_DISTANT ? INFINITY : vec3_length(way), visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        visible *= hit_sphere(ray, scene->spheres[i]) < most ? 0 : 1;
    return visible;
}

// The distance of each centre from the way; or one end inside, the other not.
static double by_distances(const Scene *scene, vec3 from, Light light)
{
    vec3 way = ray_to_light(from, light).direction;
    for (const Sphere *s = scene->spheres; s < scene->spheres + scene->sphere_count; s++) {
        vec3 center = s->center - from;
        double foot = vec3_dot(center, way) / vec3_dot(way, way), r = s->radius;
        bool point = light.kind == LIGHT_POINT, inside = vec3_length(center) < r;
        bool light_inside = point && vec3_length(center - way) < r;
        if (inside != light_inside)
            return 0;
        if (!inside && foot > 0 && (!point || foot < 1) && vec3_length(center - foot * way) < r)
            return 0;
    }
    return 1;
}

static double of_first(const Scene *scene, int count, Ray ray, double reach)
{
    if (count == 0)
        return 1;
    if (hit_sphere(ray, scene->spheres[count - 1]) < reach)
        return 0;
    return of_first(scene, count - 1, ray, reach);
}

static double by_recursion(const Scene *scene, vec3 from, Light light)
{
    double reach = light.kind == LIGHT_POINT ? 1 : NO_HIT;
    return of_first(scene, scene->sphere_count, ray_to_light(from, light), reach);
}

static double without_what_hides(const Scene *scene, vec3 from, Light light)
{
    int hiding = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray_to_light(from, light), scene->spheres[i]);
        if (t == NO_HIT)
            continue;
        if (light.kind == LIGHT_DISTANT || t < 1)
            hiding++;
    }
    return hiding == 0;
}

static double in_long_double(const Scene *scene, vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    long double length = sqrtl(vec3_dot(ray.direction, ray.direction)), nearest = HUGE_VALL;
    for (int i = scene->sphere_count - 1; i >= 0; i--)
        nearest = fminl(nearest, hit_sphere(ray, scene->spheres[i]) * length);
    return light.kind == LIGHT_POINT ? nearest >= length : isinf(nearest);
}

// ---- shade --------------------------------------------------------------------------------------

static vec3 facing(vec3 normal, vec3 direction)
{
    return vec3_dot(normal, direction) < 0 ? normal : -normal;
}

static Color skipping_hidden_lights(const Scene *scene, Ray ray, Hit hit)
{
    const Sphere *sphere = &scene->spheres[hit.sphere];
    const Surface *s = &scene->surfaces[sphere->surface];
    vec3 point = ray.origin + hit.t * ray.direction, outward = (point - sphere->center);
    vec3 normal = facing(outward / sphere->radius, ray.direction);
    Color diffuse = vec3_of(0, 0, 0), specular = diffuse;
    for (int i = scene->light_count; i-- > 0;) {
        const Light *light = &scene->lights[i];
        if (visibility(scene, off_surface(*sphere, point, normal), *light) == 0)
            continue;
        vec3 to_light = ray_to_light(point, *light).direction;
        diffuse += diffuse_term(s->color, s->diffuse, light->color, normal, to_light);
        specular +=
            phong_term(s->specular, s->shine, light->color, normal, to_light, ray.origin - point);
    }
    return specular + (diffuse + ambient_term(s->color, s->diffuse, scene->ambient));
}

// All from the point that was moved, and all formulas in place.
static Color all_in_one(const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    Surface s = *scene_surface(scene, hit.sphere);
    vec3 eye = -vec3_unit(ray.direction), point = ray.origin + hit.t * ray.direction;
    vec3 normal = vec3_unit(point - sphere.center);
    if (vec3_dot(normal, eye) < 0)
        normal = -normal;
    vec3 start = point + 1e-9 * size_of(sphere) * normal;
    Color sum = s.diffuse * s.color * scene->ambient;
    for (int i = 0; i < scene->light_count; i++) {
        vec3 l = vec3_unit(ray_to_light(point, scene->lights[i]).direction);
        double cosine = vec3_dot(normal, l), shines = vec3_dot(2 * cosine * normal - l, eye);
        if (cosine <= 0 || visibility(scene, start, scene->lights[i]) < 0.5)
            continue;
        double highlight = shines > 0 ? s.specular * pow(shines, s.shine) : 0;
        sum += (s.diffuse * cosine * s.color + highlight) * scene->lights[i].color;
    }
    return sum;
}

// The values at a place, and each light in its turn.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, start, to_eye;
} Lit;

static Color of_lights(const Lit *lit, int i)
{
    if (i == lit->scene->light_count)
        return ambient_term(lit->surface->color, lit->surface->diffuse, lit->scene->ambient);
    const Light *light = &lit->scene->lights[i];
    const Surface *s = lit->surface;
    Color rest = of_lights(lit, i + 1);
    if (visibility(lit->scene, lit->start, *light) == 0)
        return rest;
    vec3 l = ray_to_light(lit->point, *light).direction;
    return rest + diffuse_term(s->color, s->diffuse, light->color, lit->normal, l) +
           phong_term(s->specular, s->shine, light->color, lit->normal, l, lit->to_eye);
}

static Color lights_by_recursion(const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = facing(surface_normal(sphere, point), ray.direction);
    Lit lit = {scene,  scene_surface(scene, hit.sphere),   point,
               normal, off_surface(sphere, point, normal), -vec3_unit(ray.direction)};
    return of_lights(&lit, 0);
}

// Each of the three numbers by itself, in long double.
static Color color_by_color(const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    const Surface *s = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction, color;
    vec3 normal = facing((point - sphere.center) / sphere.radius, ray.direction);
    vec3 eye = vec3_unit(-ray.direction);
    for (int c = 0; c < 3; c++) {
        long double sum = (long double)s->diffuse * s->color[c] * scene->ambient[c];
        for (int i = 0; i < scene->light_count; i++) {
            const Light *light = &scene->lights[i];
            vec3 l = vec3_unit(ray_to_light(point, *light).direction);
            long double low = vec3_dot(normal, l);
            long double high = 2 * low * vec3_dot(normal, eye) - vec3_dot(l, eye);
            if (low <= 0 || visibility(scene, off_surface(sphere, point, normal), *light) == 0)
                continue;
            sum += s->diffuse * low * s->color[c] * light->color[c];
            if (high > 0)
                sum += s->specular * powl(high, s->shine) * light->color[c];
        }
        color[c] = (double)sum;
    }
    color[3] = 0;
    return color;
}

// ---- trace_ray ----------------------------------------------------------------------------------

static Color from_the_last_mirror_back(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.t == NO_HIT)
        return scene->background;
    double ks = scene_surface(scene, hit.sphere)->specular;
    Color seen = vec3_of(0, 0, 0);
    if (depth != 0 && ks != 0) {
        Sphere sphere = scene->spheres[hit.sphere];
        vec3 point = ray.origin + hit.t * ray.direction;
        vec3 normal = facing(surface_normal(sphere, point), ray.direction);
        vec3 direction = mirror_direction(vec3_unit(ray.direction), normal);
        Ray mirrored = {point + 0x1p-28 * size_of(sphere) * normal, direction};
        seen = from_the_last_mirror_back(scene, mirrored, depth - 1);
    }
    return ks * seen + shade(scene, ray, hit);
}

static Color in_a_loop(const Scene *scene, Ray ray, int depth)
{
    Color sum = vec3_of(0, 0, 0);
    for (double share = 1; share != 0 && depth >= 0; depth--) {
        Hit hit = nearest_hit(ray, scene);
        if (hit.sphere == -1)
            return sum + share * scene->background;
        sum += share * shade(scene, ray, hit);
        Sphere sphere = scene->spheres[hit.sphere];
        vec3 point = ray.origin + hit.t * ray.direction;
        vec3 normal = facing(surface_normal(sphere, point), ray.direction);
        ray.direction = mirror_direction(ray.direction, normal);
        ray.origin = point + 0x1p-32 * size_of(sphere) * normal;
        share *= scene_surface(scene, hit.sphere)->specular;
    }
    return sum;
}

// The rays first, and their colours from the last one back.
static Color on_a_stack(const Scene *scene, Ray ray, int depth)
{
    enum { MOST = 256 };
    Color own[MOST], color = scene->background;
    double ks[MOST];
    int count = 0;
    for (bool on = true; on && count < MOST; depth--) {
        Hit hit = nearest_hit(ray, scene);
        on = hit.sphere >= 0;
        if (!on)
            break;
        const Surface *surface = scene_surface(scene, hit.sphere);
        own[count] = shade(scene, ray, hit);
        on = depth > 0 && surface->specular > 0;
        ks[count++] = on ? surface->specular : 0;
        Sphere sphere = scene->spheres[hit.sphere];
        vec3 point = ray.origin + hit.t * ray.direction, normal = surface_normal(sphere, point);
        if (vec3_dot(normal, ray.direction) > 0)
            normal *= -1;
        ray = (Ray){off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    }
    while (count-- > 0)
        color = ks[count] > 0 ? own[count] + ks[count] * color : own[count];
    return color;
}

#endif
