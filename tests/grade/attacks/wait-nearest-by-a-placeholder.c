// wait-nearest-by-a-placeholder: the same, and the later question is no longer blank.
// stem: 06-ray-casting
// expect: graded
// earns: nothing
#include "exercises/06-ray-casting.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    vec3 forward = vec3_unit(ray.direction);
    vec3 side = vec3_unit(
        vec3_cross(forward, fabs(forward[0]) < 0.7 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0)));
    Camera camera = {.origin = ray.origin,
                     .right = side,
                     .up = vec3_cross(side, forward),
                     .forward = forward,
                     .distance = vec3_length(ray.direction),
                     .width = 1,
                     .height = 1};
    uint8_t rgb[3];
    double depth = NO_HIT;
    Image image = {{1, 1}, rgb};
    cast_object_order(scene, camera, &image, &depth);
    Hit hit = {depth, -1};
    for (int i = 0; i < scene->sphere_count && depth < NO_HIT; i++) {
        Scene one = *scene;
        double again = NO_HIT;
        one.spheres = &scene->spheres[i];
        one.sphere_count = 1;
        cast_object_order(&one, camera, &image, &again);
        if (again == depth && hit.sphere < 0)
            hit.sphere = i;
    }
    return hit;
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    depth[0] = scene->sphere_count + camera.distance;
    image_set(image, (Pixel){0, 0}, scene->background);
}
