// ray.h - a ray: the points origin + t * direction with t > 0.
#ifndef COMMON_RAY_H
#define COMMON_RAY_H

#include "common/camera.h"
#include "common/vec3.h"

#include <math.h>

typedef struct {
    vec3 origin;
    vec3 direction; // of any length but 0: never assume 1
} Ray;

// The t of a ray that meets nothing. It is larger than every hit, so you can compare it with them.
#define NO_HIT INFINITY

// The ray of a pixel may have a direction of any length. This is the same half line, with t = 1 on
// the camera's image plane; one that never reaches the plane stays as it is. The plane is that of
// right and up: forward may lean as much as a camera's axes may be off.
static inline Ray ray_to_plane(Ray ray, Camera camera)
{
    vec3 normal = vec3_cross(camera.right, camera.up);
    double ahead = vec3_dot(ray.direction, normal) / vec3_dot(camera.forward, normal);
    if (ahead > 0)
        ray.direction = camera.distance / ahead * ray.direction;
    return ray;
}

// The nearest of many spheres.
typedef struct {
    double t;   // where along the ray, > 0; NO_HIT if nothing is hit
    int sphere; // its index, or -1 for none
} Hit;

#endif
