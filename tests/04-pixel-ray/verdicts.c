// verdicts.c - wrong answers to exercise 04 that are not known mistakes, and the verdict on each.
#include "exercises/04-pixel-ray.h"

#include "tests/judge/known.h"

// The length of a direction is free: the mistake is the same.
UNNAMED(pixel_ray, "P7", "no eye, and a unit direction")
{
    Ray ray = pixel_ray(camera, screen, pixel);
    return (Ray){vec3_of(0, 0, 0), vec3_unit(ray.direction)};
}

UNNAMED_LINE(pixel_ray, NOBODY, "straight ahead", return (Ray){camera.origin, 3 * camera.forward})
