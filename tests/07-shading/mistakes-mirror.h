// mistakes-mirror.h - what wrong answers to trace_ray share: a mirror with slips.
#ifndef TESTS_07_SHADING_MISTAKES_MIRROR_H
#define TESTS_07_SHADING_MISTAKES_MIRROR_H

#include "tests/07-shading/mistakes-scene.h"

// A mirrored ray, and what is made of the colour that it sees. Members that are not set are right.
typedef struct {
    Start *start;
    vec3 (*direction)(vec3 direction, vec3 normal);
    double (*share)(const Surface *surface);
    Color (*sum)(Color own, double share, Color seen, const Surface *surface);
    Color (*own)(const Scene *scene, Ray ray, Hit hit);
    Color (*nothing)(const Scene *scene, bool mirrored);
    bool own_sphere_left_out;
} Slips;

static inline double specular_of(const Surface *surface)
{
    return surface->specular;
}

static inline vec3 right_start(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)ray, (void)t;
    return off_surface(sphere, point, normal);
}

static inline Color plus_share(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return own + share * seen;
}

static inline Color background_of(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->background;
}

static inline Hit hit_of(const Slips *slips, const Scene *scene, Ray ray, int own)
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best.t && !(slips->own_sphere_left_out && i == own))
            best = (Hit){t, i};
    }
    return best;
}

static inline Color trace_with(const Slips *slips, const Scene *scene, Ray ray, int depth, int own)
{
    Hit hit = hit_of(slips, scene, ray, own);
    if (hit.sphere < 0)
        return (slips->nothing != NULL ? slips->nothing : background_of)(scene, own >= 0);
    const Surface *surface = scene_surface(scene, hit.sphere);
    double share = (slips->share != NULL ? slips->share : specular_of)(surface);
    Color color = (slips->own != NULL ? slips->own : shade)(scene, ray, hit);
    if (depth <= 0 || share == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {
        (slips->start != NULL ? slips->start : right_start)(sphere, point, normal, ray, hit.t),
        (slips->direction != NULL ? slips->direction : mirror_direction)(ray.direction, normal)};
    Color seen = trace_with(slips, scene, mirrored, depth - 1, hit.sphere);
    return (slips->sum != NULL ? slips->sum : plus_share)(color, share, seen, surface);
}

#define MIRROR(name, ...)                                                                          \
    static inline Color name(const Scene *scene, Ray ray, int depth)                               \
    {                                                                                              \
        return trace_with(&(Slips){__VA_ARGS__}, scene, ray, depth, -1);                           \
    }

#endif
