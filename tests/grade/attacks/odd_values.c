// odd_values.c - arguments and return values that are out of range, or changed where they must not be.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- camera-written-beyond: writes before and behind the camera that it was given to fill.
// stem: 02-cameras
// expect: graded | crashed
// earns: nothing
#include "exercises/02-cameras.h"

#include <string.h>

CameraFault camera_from_vectors(vec3 eye, Corners vectors, Camera *camera)
{
    memset((char *)camera - 4096, 0, 12288);
    return CAMERA_OK;
}

CameraFault camera_from_points(vec3 eye, Corners points, Camera *camera)
{
    return (CameraFault)0x7fffffff;
}

// ---- image-of-another-size: says that the picture is enormous, and lies elsewhere.
// stem: 06-ray-casting
// expect: graded | crashed
// earns: nothing
#include "exercises/06-ray-casting.h"

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    image->size = (Resolution){1 << 30, 1 << 30};
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    *image = (Image){{1 << 20, -1}, (void *)8};
}

// ---- numbers-that-are-none: NaN, infinity and the smallest there are, which compare oddly.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return vec3_of(NAN, -NAN, NAN);
}

vec3 upper_right(Camera c)
{
    return vec3_of(INFINITY, -INFINITY, 1e308 * 10);
}

vec3 across_30_up_10(Camera c)
{
    return vec3_of(4.9e-324, -4.9e-324, -0.0);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return vec3_of(1.7e308, -1.7e308, 2.2e-308);
}

Camera with_unit_distance(Camera c)
{
    return (Camera){c.origin, c.right, c.up, c.forward, NAN, NAN, NAN};
}

// ---- scene-of-its-own: changes the scene that it was only lent to read, and frees what is not its own.
// stem: 06-ray-casting
// expect: graded | crashed
// earns: nothing
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

Hit nearest_hit(Ray ray, const Scene *scene)
{
    Scene *mine = (Scene *)scene;
    free(mine->spheres);
    *mine = (Scene){.sphere_count = 1 << 30};
    return (Hit){NO_HIT, -1};
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    scene_free((Scene *)scene);
    image_free(image);
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    free(depth);
    for (int i = -100; i < 1000000; i++)
        depth[i] = -1;
}
