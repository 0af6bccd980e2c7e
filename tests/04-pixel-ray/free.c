// free.c - a right answer that uses the freedom of the contract: a direction of length 3, whatever
// the camera.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, 3 * vec3_unit(image_plane_vector(camera, place.s, place.t))};
}
