// 06-ray-casting.c - exercise 06: the picture.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/06-ray-casting.h. The lesson: chapters/06-ray-casting/README.md.
// After each change:   make exercises EX=06
#include "exercises/06-ray-casting.h"

#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

// BEGIN SOLUTION
// Image order: for each pixel its ray, for the ray its nearest hit, for the hit its color. If you
// exchange the loops and remember a depth for each pixel, it is object order.
// END SOLUTION

Hit nearest_hit(Ray ray, const Scene *scene)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Hit);
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
    // END SOLUTION
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    // BEGIN SOLUTION
    //~ NOT_ANSWERED_YET();
    for (int row = 0; row < image->size.height; row++) {
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            bool nothing = hit.sphere < 0;
            image_set(image, pixel,
                      nothing ? scene->background : scene_surface(scene, hit.sphere)->color);
        }
    }
    // END SOLUTION
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    // BEGIN SOLUTION
    //~ NOT_ANSWERED_YET();
    int width = image->size.width, height = image->size.height;
    for (int i = 0; i < width * height; i++) {
        depth[i] = NO_HIT;
        image_set(image, (Pixel){i % width, i / width}, scene->background);
    }
    for (int sphere = 0; sphere < scene->sphere_count; sphere++) {
        for (int i = 0; i < width * height; i++) {
            Pixel pixel = {i % width, i / width};
            double t = hit_sphere(pixel_ray(camera, image->size, pixel), scene->spheres[sphere]);
            if (t < depth[i]) {
                depth[i] = t;
                image_set(image, pixel, scene_surface(scene, sphere)->color);
            }
        }
    }
    // END SOLUTION
}
