#include "exercises/04-pixel-ray.h"

#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    // BEGIN SOLUTION
    ScreenPoint point = pixel_center(pixel);
    Normalized place = screen_to_normalized(point, screen);
    Ray ray = {camera.origin, image_plane_vector(camera, place.s, place.t)};
    return ray;
    // END SOLUTION
}
