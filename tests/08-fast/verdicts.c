// verdicts.c - wrong answers to exercise 08 that are not known mistakes, and the verdict on each.
#include "exercises/08-fast.h"

#include "tests/judge/known.h"

UNNAMED(sphere_rectangle, NOBODY, "a third of the radius")
{
    sphere.radius /= 3;
    return sphere_rectangle(camera, screen, sphere);
}

UNNAMED_LINE(sphere_rectangle, NOBODY, "a corner of the screen",
             return (ScreenRectangle){0, screen.width / 7.0, 0, screen.height / 7.0})
