// unknown.c - wrong answers to exercise 04 that are not known mistakes by their values alone.
#include "tests/proof/unknown.h"

#include "exercises/04-pixel-ray.h"

// The length of a direction is free: the mistake is the same.
static Ray from_the_middle_of_the_world(Camera camera, Resolution screen, Pixel pixel)
{
    Ray ray = pixel_ray(camera, screen, pixel);
    return (Ray){vec3_of(0, 0, 0), vec3_unit(ray.direction)};
}

static Ray always_forward(Camera camera, Resolution screen, Pixel pixel)
{
    (void)screen, (void)pixel;
    return (Ray){camera.origin, 3 * camera.forward};
}

static const Unknown unknowns[] = {
    UNKNOWN(pixel_ray, from_the_middle_of_the_world, "P7", "no eye, and a unit direction"),
    UNKNOWN(pixel_ray, always_forward, NOBODY, "straight ahead"),
    {0},
};
OF_STEM(unknowns)
