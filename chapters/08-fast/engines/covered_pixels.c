// covered_pixels.c - which pixels a sphere can cover: exercise 08, and rounding.
#include "chapters/08-fast/engines/covered_pixels.h"

#include "exercises/08-fast.h"

static int clamped(double x, int most)
{
    return x > 0 ? x < most ? (int)x : most : 0;
}

Rectangle view_rectangle(Camera camera, Resolution screen, Sphere sphere)
{
    const Rectangle none = {0};
    sphere.radius *= 1 + 1e-9; // rounding makes no sphere larger than that
    ScreenRectangle exact = sphere_rectangle(camera, screen, sphere);
    if (exact.right <= 0 || exact.left >= screen.width || exact.bottom <= 0 ||
        exact.top >= screen.height)
        return none;
    return (Rectangle){
        clamped(exact.left - 1, screen.width), clamped(exact.right + 2, screen.width),
        clamped(exact.top - 1, screen.height), clamped(exact.bottom + 2, screen.height)};
}
