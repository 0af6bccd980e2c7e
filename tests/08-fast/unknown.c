// unknown.c - wrong answers to exercise 08 that are not known mistakes by their values alone.
#include "tests/proof/unknown.h"

#include "exercises/08-fast.h"

static ScreenRectangle half_the_radius(Camera camera, Resolution screen, Sphere sphere)
{
    sphere.radius /= 3;
    return sphere_rectangle(camera, screen, sphere);
}

static ScreenRectangle a_corner(Camera camera, Resolution screen, Sphere sphere)
{
    (void)camera, (void)sphere;
    return (ScreenRectangle){0, screen.width / 7.0, 0, screen.height / 7.0};
}

static const Unknown unknowns[] = {
    UNKNOWN(sphere_rectangle, half_the_radius, NOBODY, "a third of the radius"),
    UNKNOWN(sphere_rectangle, a_corner, NOBODY, "a corner of the screen"),
    {0},
};
OF_STEM(unknowns)
