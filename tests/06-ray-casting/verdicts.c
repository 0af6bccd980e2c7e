// verdicts.c - wrong answers to exercise 06 that are not known mistakes, and the verdict on each.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"

UNNAMED(nearest_hit, NOBODY, "<= with NO_HIT as well")
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t <= best.t)
            best = (Hit){t, i};
    }
    return best;
}

UNNAMED(nearest_hit, NOBODY " your function gives another result", "static")
{
    static double best = NO_HIT;
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best) {
            best = t;
            hit = (Hit){t, i};
        }
    }
    return hit;
}

UNNAMED(cast_image_order, NOBODY " every pixel", "green")
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            image_set(image, (Pixel){column, row}, vec3_of(0, 1, 0.2));
}
