// image-of-another-size: says that the picture is enormous, and lies elsewhere.
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
