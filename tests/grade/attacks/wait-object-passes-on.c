// wait-object-passes-on: passes its question on to an answer that is wrong in a known way, and
// only adds what that leaves out.
// stem: 06-ray-casting
// expect: graded
// earns: nearest_hit
#include "exercises/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    Hit nearest = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, image->size.height - 1 - row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            image_set(image, (Pixel){column, row},
                      hit.sphere < 0 ? scene->background : scene_surface(scene, hit.sphere)->color);
        }
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    cast_image_order(scene, camera, image);
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        depth[i] = nearest_hit(pixel_ray(camera, image->size, pixel), scene).t;
    }
}
