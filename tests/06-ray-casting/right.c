// right.c - right answers to exercise 06, written in other ways.
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"

#include <stdlib.h>

static Color color_along(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere == -1)
        return scene->background;
    return scene->surfaces[scene->spheres[hit.sphere].surface].color;
}

RIGHT(nearest_hit, "backward, with <=")
{
    Hit hit = {NO_HIT, -1};
    for (int i = scene->sphere_count; i-- > 0;) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT && t <= hit.t)
            hit = (Hit){t, i};
    }
    return hit;
}

// t differs a little from the reference's, by rounding.
RIGHT(nearest_hit, "hits with its own geometry")
{
    double length = vec3_length(ray.direction);
    vec3 unit = vec3_unit(ray.direction);
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        vec3 center = scene->spheres[i].center - ray.origin;
        double foot = vec3_dot(center, unit), radius = scene->spheres[i].radius;
        vec3 aside = center - foot * unit;
        double half_chord_squared = radius * radius - vec3_dot(aside, aside);
        if (half_chord_squared < 0)
            continue;
        double half_chord = sqrt(half_chord_squared);
        double t = (foot - half_chord > 0 ? foot - half_chord : foot + half_chord) / length;
        if (t > 0 && t < hit.t)
            hit = (Hit){t, i};
    }
    return hit;
}

RIGHT(cast_image_order, "rays with unit directions")
{
    for (Pixel p = {0, 0}; p.row < image->size.height; p.row++)
        for (p.column = 0; p.column < image->size.width; p.column++) {
            Ray ray = pixel_ray(camera, image->size, p);
            ray.direction = vec3_unit(ray.direction);
            image_set(image, p, color_along(ray, scene));
        }
}

// The image plane spanned by hand: its upper left corner, and a step to the right and one down.
RIGHT(cast_image_order, "steps on the image plane")
{
    vec3 right = camera.width / image->size.width * camera.right;
    vec3 down = -camera.height / image->size.height * camera.up;
    vec3 corner = camera.distance * camera.forward - camera.width / 2 * camera.right +
                  camera.height / 2 * camera.up;
    for (int y = 0; y < image->size.height; y++)
        for (int x = 0; x < image->size.width; x++) {
            Ray ray = {camera.origin, corner + (x + 0.5) * right + (y + 0.5) * down};
            image_set(image, (Pixel){x, y}, color_along(ray, scene));
        }
}

RIGHT(cast_image_order, "by object order")
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    cast_object_order(scene, camera, image, depth);
    free(depth);
}

RIGHT(cast_object_order, "by image order and nearest_hit")
{
    cast_image_order(scene, camera, image);
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            *depth++ = nearest_hit(pixel_ray(camera, image->size, (Pixel){column, row}), scene).t;
}
