// lend-without-end: asks for a mirror in a mirror, two thousand million times, once that is lent.
// stem: 07-shading
// expect: graded | crashed
// earns: nothing
#include "exercises/07-shading.h"

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}

vec3 clamp_color(vec3 color)
{
    Sphere spheres[2] = {{.center = vec3_of(0, 0, -2), .radius = 1},
                         {.center = vec3_of(0, 0, 2), .radius = 1}};
    Surface mirror = {.color = color, .specular = 1};
    Scene scene = {.spheres = spheres, .sphere_count = 2, .surfaces = &mirror, .surface_count = 1};
    return trace_ray(&scene, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, 1)}, 2147483647);
}
