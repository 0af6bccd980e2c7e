// wait-shade-by-trace: light by what a mirror shows, which is later and a placeholder.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    (void)hit;
    return trace_ray(scene, ray, 0);
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}
