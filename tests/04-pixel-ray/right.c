// right.c - right answers to exercise 04, written in other ways.
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

#include "tests/judge/known.h"

static vec3 towards(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return image_plane_vector(camera, place.s, place.t);
}

static vec3 step(vec3 from, vec3 by, int count)
{
    return count == 0 ? from : step(from + by * (count % 2), 2 * by, count / 2);
}

RIGHT_LINE(pixel_ray, "a direction of length 1",
           return (Ray){camera.origin, vec3_unit(towards(camera, screen, pixel))})
RIGHT_LINE(pixel_ray, "a direction 4321 times as long",
           return (Ray){camera.origin, 4321 * towards(camera, screen, pixel)})
RIGHT_LINE(pixel_ray, "a direction 98765 times as short",
           return (Ray){camera.origin, towards(camera, screen, pixel) / 98765})
RIGHT_LINE(pixel_ray, "by the camera of unit distance",
           return (Ray){camera.origin, towards(with_unit_distance(camera), screen, pixel)})

RIGHT(pixel_ray, "the point of the world minus the eye")
{
    vec3 point = camera.origin + towards(camera, screen, pixel);
    return (Ray){.origin = camera.origin, .direction = point - camera.origin};
}

RIGHT(pixel_ray, "without the earlier answers")
{
    double x = (pixel.column + 0.5) / screen.width - 0.5;
    double y = 0.5 - (pixel.row + 0.5) / screen.height;
    vec3 direction = y * camera.height * camera.up + x * camera.width * camera.right +
                     camera.distance * camera.forward;
    return (Ray){camera.origin, direction};
}

RIGHT(pixel_ray, "from the upper left corner, pixel by pixel")
{
    vec3 across = camera.width / screen.width * camera.right;
    vec3 down = -camera.height / screen.height * camera.up;
    vec3 direction = upper_left(camera) + across / 2 + down / 2;
    for (int column = 0; column < pixel.column; column++)
        direction += across;
    for (int row = 0; row < pixel.row; row++)
        direction += down;
    return (Ray){camera.origin, direction};
}

// Twice the vector to the center is the sum of the vectors to two opposite corners of the pixel.
RIGHT(pixel_ray, "between two corners of the pixel")
{
    ScreenPoint corner = {pixel.column, pixel.row}, opposite = {corner.x + 1, corner.y + 1};
    Normalized a = screen_to_normalized(corner, screen);
    Normalized b = screen_to_normalized(opposite, screen);
    return (Ray){camera.origin,
                 image_plane_vector(camera, a.s, a.t) + image_plane_vector(camera, b.s, b.t)};
}

// Between the corners of the plane, weighted by the number of pixels on each side.
RIGHT(pixel_ray, "from the upper left corner, in shares")
{
    double right = (pixel.column + 0.5) / screen.width, down = (pixel.row + 0.5) / screen.height;
    vec3 top_left = upper_left(camera), top_right = upper_right(camera);
    vec3 bottom_left = image_plane_vector(camera, 0, 0);
    vec3 direction = top_left;
    direction += right * (top_right - top_left);
    direction += down * (bottom_left - top_left);
    return (Ray){camera.origin, direction};
}

// As graphics hardware does it: from -1 to 1, with the tangents of half the angles; 1 ahead.
RIGHT(pixel_ray, "from -1 to 1, with tangents, of length 1")
{
    double x = (2 * pixel.column + 1.0) / screen.width - 1;
    double y = 1 - (2 * pixel.row + 1.0) / screen.height;
    double across = tan(atan(camera.width / 2 / camera.distance));
    double up = tan(atan(camera.height / 2 / camera.distance));
    vec3 direction = camera.forward + x * across * camera.right + y * up * camera.up;
    return (Ray){camera.origin, vec3_unit(direction)};
}

RIGHT(pixel_ray, "in long double")
{
    long double s = (pixel.column + 0.5L) / screen.width - 0.5L;
    long double t = 0.5L - (pixel.row + 0.5L) / screen.height;
    Ray ray = {.origin = camera.origin, .direction = {0, 0, 0, 0}};
    for (int i = 0; i < 3; i++)
        ray.direction[i] =
            (double)(camera.distance * (long double)camera.forward[i] +
                     s * camera.width * camera.right[i] + t * camera.height * camera.up[i]);
    return ray;
}

// The camera's matrix, with the frame for columns, times a direction of the camera's own axes.
RIGHT(pixel_ray, "by the camera's matrix")
{
    double pixel_width = camera.width / screen.width, pixel_height = camera.height / screen.height;
    double seen[3] = {(pixel.column + 0.5 - screen.width / 2.0) * pixel_width,
                      (screen.height / 2.0 - pixel.row - 0.5) * pixel_height, camera.distance};
    const vec3 columns[3] = {camera.right, camera.up, camera.forward};
    vec3 direction = {0, 0, 0, 0};
    for (int i = 0; i < 3; i++)
        direction += seen[i] * columns[i];
    return (Ray){camera.origin, direction};
}

RIGHT(pixel_ray, "half pixels by recursion")
{
    vec3 half_across = camera.width / screen.width / 2 * camera.right;
    vec3 half_down = -camera.height / screen.height / 2 * camera.up;
    vec3 direction = step(upper_left(camera), half_across, 2 * pixel.column + 1);
    return (Ray){camera.origin, step(direction, half_down, 2 * pixel.row + 1)};
}
