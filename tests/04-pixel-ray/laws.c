// laws.c - the laws of exercise 04: a ray starts at the eye and goes through its pixel.
#include "exercises/04-pixel-ray.h"

#include "common/text.h"
#include "tests/judge/known.h"

// The point where a ray meets the plane, as far from the eye along a direction of the camera.
static double place_along(Ray ray, vec3 direction, Camera camera)
{
    vec3 v = camera.distance / vec3_dot(ray.direction, camera.forward) * ray.direction;
    return vec3_dot(v, direction);
}

// The same from an edge, counted in pixels of this size in the world; the middle of the pixel is
// where the right ray meets the plane.
static bool beside_its_pixel(double place, double right, int number, double size, double tolerance,
                             const char *edge, const char *kind)
{
    if (fabs(place - right) <= tolerance)
        return false;
    Apart a = apart(without_noise(place / size, 1e-9), right / size);
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
    if (!(vec3_length(yours.origin - right.origin) <= 1e-8 * size)) {
        Apart a = apart_vec3(yours.origin, right.origin);
        law_broken("your ray starts at %s; the eye is at %s", a.yours.s, a.right.s);
        return;
    }
    double ahead = without_noise(vec3_dot(v, camera.forward), 1e-12 * vec3_length(v));
    if (!(ahead > 0)) {
        law_broken("along forward your direction goes %s, so it never reaches the plane, %s ahead",
                   number_text(ahead).s, number_text(camera.distance).s);
        return;
    }
    double left = -camera.width / 2, top = camera.height / 2; // from the middle
    if (!beside_its_pixel(place_along(yours, camera.right, camera) - left,
                          place_along(right, camera.right, camera) - left, pixel.column,
                          camera.width / screen.width, tolerance, "left", "column"))
        beside_its_pixel(top - place_along(yours, camera.up, camera),
                         top - place_along(right, camera.up, camera), pixel.row,
                         camera.height / screen.height, tolerance, "top", "row");
}
