// lend-no-such-sphere: asks for the light on spheres that are not there, once that is lent.
// stem: 07-shading
// expect: graded | crashed
// earns: nothing
#include "exercises/07-shading.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    return scene->ambient + 0 * hit.t * ray.direction;
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    static const int odd[] = {1 << 30, -1, -(1 << 30), 1 << 20};
    return shade(scene, ray, (Hit){1, odd[depth & 3]});
}
