// scene-of-its-own: changes the scene that it was only lent to read, and frees what is not its own.
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
