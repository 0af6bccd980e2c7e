// laws.h - the laws of exercise 06, and what they share.
#ifndef TESTS_06_RAY_CASTING_LAWS_H
#define TESTS_06_RAY_CASTING_LAWS_H

#include "exercises/06-ray-casting.h"

#include "common/text.h"

void law_nearest_hit(Hit yours, Ray ray, const Scene *scene);
void law_cast_image_order(const Scene *scene, Camera camera, Image *image);
void law_cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth);

// How far a hit may be off, in radii along the ray (exercises/05-quadratic.h), and therefore in t.
#define HIT_TOLERANCE 1e-6

static inline double hit_rounding(Ray ray, Sphere sphere)
{
    return HIT_TOLERANCE * sphere.radius / vec3_length(ray.direction);
}

static inline Text hit_t_text(double t)
{
    return t == NO_HIT ? (Text){"NO_HIT"} : number_text(t);
}

#endif
