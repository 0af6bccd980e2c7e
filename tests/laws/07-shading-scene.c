// 07-shading-scene.c - the laws of what needs a scene: none yet.
#include "tests/laws/07-shading.h"

void law_off_surface(vec3 yours, Sphere sphere, vec3 point, vec3 normal)
{
    (void)yours, (void)sphere, (void)point, (void)normal;
}

void law_visibility(double yours, const Scene *scene, vec3 from, Light light)
{
    (void)yours, (void)scene, (void)from, (void)light;
}

void law_shade(Color yours, const Scene *scene, Ray ray, Hit hit)
{
    (void)yours, (void)scene, (void)ray, (void)hit;
}

void law_trace_ray(Color yours, const Scene *scene, Ray ray, int depth)
{
    (void)yours, (void)scene, (void)ray, (void)depth;
}
