// wait-image-by-object: one order by the other, which is later and blank.
// stem: 06-ray-casting
// expect: graded
// earns: nothing
#include "exercises/06-ray-casting.h"

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    static double depth[1 << 20];
    cast_object_order(scene, camera, image, depth);
}
