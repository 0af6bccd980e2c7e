// facts.c - what the laws of exercise 06 need to know of a picture: for each pixel the length of
// its ray's direction, and where the ray hits each sphere.
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"

static void hits_of_pixels(const Scene *scene, Camera camera, Resolution size)
{
    for (int i = 0; i < size.width * size.height; i++) {
        Ray ray = pixel_ray(camera, size, (Pixel){i % size.width, i / size.width});
        fact(vec3_length(ray.direction));
        for (int k = 0; k < scene->sphere_count; k++)
            fact(hit_sphere(ray, scene->spheres[k]));
    }
}

FACTS(cast_image_order)
{
    hits_of_pixels(scene, camera, image->size);
}

FACTS(cast_object_order)
{
    hits_of_pixels(scene, camera, image->size);
}
