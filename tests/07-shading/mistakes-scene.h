// mistakes-scene.h - what wrong answers about a whole scene share: wrong starts of a ray.
#ifndef TESTS_07_SHADING_MISTAKES_SCENE_H
#define TESTS_07_SHADING_MISTAKES_SCENE_H

#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"
#include "tests/judge/mistake.h"

extern const Mistake offset_mistakes[], fixed_offset_mistakes[], shadow_mistakes[],
    shadow_sphere_mistakes[], shade_mistakes[], shade_light_mistakes[], hidden_light_mistakes[],
    mirrored_mistakes[], seen_mistakes[], mirror_depth_mistakes[], shadow_limit_mistakes[],
    shade_limit_mistakes[], mirror_limit_mistakes[];

// ---- where a ray starts -------------------------------------------------------------------------

typedef vec3 Start(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t);

static inline vec3 start_there(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)sphere, (void)normal, (void)ray, (void)t;
    return point;
}

static inline vec3 start_inward(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)ray, (void)t;
    return off_surface(sphere, point, -normal);
}

static inline vec3 start_outward(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)normal, (void)ray, (void)t;
    return off_surface(sphere, point, surface_normal(sphere, point));
}

static inline vec3 start_back_along_the_ray(Sphere sphere, vec3 point, vec3 normal, Ray ray,
                                            double t)
{
    (void)sphere, (void)point, (void)normal;
    return ray.origin + t * (1 - 1e-9) * ray.direction;
}

#define STEP(name, epsilon)                                                                        \
    static inline vec3 name(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)             \
    {                                                                                              \
        (void)sphere, (void)ray, (void)t;                                                          \
        return point + (epsilon)*normal;                                                           \
    }

STEP(start_a_thousandth_off, 1e-3)
STEP(start_1e_4_off, 1e-4)
STEP(start_1e_5_off, 1e-5)
STEP(start_a_millionth_off, 1e-6)
STEP(start_a_billionth_off, 1e-9)

// Up to which t a hit is nearer than the light.
static inline double reach_of(Light light)
{
    return light.kind == LIGHT_DISTANT ? NO_HIT : 1;
}

// The normal at a hit, on the side from which the ray came.
static inline vec3 normal_turned(Sphere sphere, vec3 point, Ray ray)
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
}

#endif
