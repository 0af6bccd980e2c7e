// lend-a-long-task: has the judge itself draw, by the answer that it lends, a picture of a hundred
// thousand spheres and a million pixels.
// stem: 06-ray-casting
// expect: timed out | graded | crashed
// earns: nothing
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    enum { MANY = 100000 };
    Scene large = *scene;
    Image picture = {.size = {1000, 1000}, .rgb = calloc(1000000, 3)};
    large.spheres = malloc(MANY * sizeof *large.spheres);
    large.sphere_count = MANY;
    for (int i = 0; i < MANY; i++)
        large.spheres[i] = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = 1};
    cast_image_order(&large, camera, &picture);
}
