// override-earlier: a later chapter that defines an earlier one's function, strongly.
// stem: 04-pixel-ray
// expect: does not compile | graded
// earns: nothing
#include "exercises/04-pixel-ray.h"

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.up;
}
__asm__(".globl screen_to_normalized\nscreen_to_normalized:\n ret\n"
        ".globl pixel_center\npixel_center:\n ret\n");

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, image_plane_vector(camera, 0, 0)};
}
