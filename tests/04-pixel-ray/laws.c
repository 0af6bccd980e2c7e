// laws.c - the laws of exercise 04: a ray starts at the eye and goes through its pixel.
#include "exercises/04-pixel-ray.h"

#include "common/text.h"
#include "tests/judge/law.h"

// The point where the ray meets the plane, counted in pixels from an edge; its pixel must be there,
// as far on one side as on the other. A pixel has this size in the world.
static bool beside_its_pixel(double place, int number, double size, double tolerance,
                             const char *edge, const char *kind)
{
    double pixels = without_noise(place / size, 1e-9), center = number + 0.5;
    if (fabs(place - center * size) <= tolerance)
        return false;
    Apart a = apart(pixels, center);
    law_broken("your ray meets the plane %s pixels from its %s edge; the middle of %s %d is %s "
               "from there",
               a.yours.s, edge, kind, number, a.right.s);
    return true;
}

LAW(pixel_ray)
{
    // Much wider than the contract's 1e-9; a ray that is nearly parallel to the plane meets it less
    // exactly.
    double size = camera.distance + camera.width + camera.height;
    double tolerance = 1e-8 * size * size / camera.distance;
    vec3 v = yours.direction;
    if (!vec3_is_finite(yours.origin) || !vec3_is_finite(v)) {
        law_broken("a part of it is not a finite number");
        return;
    }
    if (!(vec3_length(yours.origin - camera.origin) <= 1e-8 * size)) {
        Apart a = apart_vec3(yours.origin, camera.origin);
        law_broken("your ray starts at %s; the eye is at %s", a.yours.s, a.right.s);
        return;
    }
    double ahead = without_noise(vec3_dot(v, camera.forward), 1e-12 * vec3_length(v));
    if (!(ahead > 0)) {
        law_broken("along forward your direction goes %s, so it never reaches the plane, %s ahead",
                   number_text(ahead).s, number_text(camera.distance).s);
        return;
    }
    v = camera.distance / ahead * v;
    double from_left = camera.width / 2 + vec3_dot(v, camera.right);
    double from_top = camera.height / 2 - vec3_dot(v, camera.up);
    if (beside_its_pixel(from_left, pixel.column, camera.width / screen.width, tolerance, "left",
                         "column"))
        return;
    beside_its_pixel(from_top, pixel.row, camera.height / screen.height, tolerance, "top", "row");
}
