// unknown.c - wrong answers to exercise 06 that are not known mistakes.
#include "tests/proof/unknown.h"

#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

static Hit equal_is_nearer(Ray ray, const Scene *scene)
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t <= best.t)
            best = (Hit){t, i};
    }
    return best;
}

static Hit best_is_kept(Ray ray, const Scene *scene)
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

static void all_green(const Scene *scene, Camera camera, Image *image)
{
    (void)scene, (void)camera;
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            image_set(image, (Pixel){column, row}, vec3_of(0, 1, 0.2));
}

static const Unknown unknowns[] = {
    UNKNOWN(nearest_hit, equal_is_nearer, NOBODY, "<= with NO_HIT as well"),
    UNKNOWN(nearest_hit, best_is_kept, NOBODY " your function gives another result", "static"),
    UNKNOWN(cast_image_order, all_green, NOBODY " every pixel", "green"),
    {0},
};
OF_STEM(unknowns)
