// wait-trace-by-shade: a mirror by light, which is a placeholder.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

#include "exercises/06-ray-casting.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    return scene->ambient + hit.t * ray.direction;
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    return hit.sphere < 0 || depth > 100 ? scene->background : shade(scene, ray, hit);
}
