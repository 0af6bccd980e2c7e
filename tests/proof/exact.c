// exact.c - the reference's answers to the rays and spheres of exact.py, a line each: the numbers
// of the ray's origin and direction, and of the sphere.
#include "exercises/05-quadratic.h"

#include <stdio.h>

int main(void)
{
    double n[10];
    for (int i = 0; scanf("%la", &n[i]) == 1; i = (i + 1) % 10) {
        if (i < 9)
            continue;
        Ray ray = {vec3_of(n[0], n[1], n[2]), vec3_of(n[3], n[4], n[5])};
        Sphere sphere = {.center = vec3_of(n[6], n[7], n[8]), .radius = n[9]};
        Roots roots = sphere_roots(ray, sphere);
        printf("%d %a %a %a\n", roots.count, roots.t[0], roots.t[1], hit_sphere(ray, sphere));
    }
    return 0;
}
