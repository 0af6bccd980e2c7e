// rays.h - random rays and spheres, by families: each is hard in a way of its own.
#ifndef TESTS_EXACT_RAYS_H
#define TESTS_EXACT_RAYS_H

#include "common/ray.h"
#include "common/sphere.h"

typedef struct {
    Ray ray;
    Sphere sphere;
} Case;

// Each call another one, the same ones in every run.
enum { FAMILIES = 8 };
extern Case (*const families[FAMILIES])(void);
extern const char *const family_names[FAMILIES];

#endif
