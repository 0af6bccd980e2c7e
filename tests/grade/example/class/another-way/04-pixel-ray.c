#include "exercises/04-pixel-ray.h"

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    double x = (pixel.column + 0.5) / screen.width - 0.5;
    double y = 0.5 - (pixel.row + 0.5) / screen.height;
    Ray ray;
    ray.origin = camera.origin;
    ray.direction = camera.distance * camera.forward + x * camera.width * camera.right +
                    y * camera.height * camera.up;
    return ray;
}
