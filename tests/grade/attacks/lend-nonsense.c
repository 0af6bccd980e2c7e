// lend-nonsense: asks for what is lent with a scene that cannot be.
// stem: 06-ray-casting
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    Sphere sphere = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = NAN};
    Scene odd = *scene;
    odd.spheres = &sphere;
    odd.sphere_count = 1;
    sphere.surface = 1 << 28;
    static int times;
    if (times++ % 2 == 0)
        odd.surface_count = 0, sphere.surface = -1;
    Ray ray = {camera.origin, camera.forward};
    Hit hit = nearest_hit(ray, &odd);
    image_set(image, (Pixel){0, 0}, vec3_of(hit.t, hit.sphere, 0));
}
