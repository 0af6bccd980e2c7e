// variants.c - right answers to exercise 04, written in other ways: directions of other lengths,
// and other ways to the same place.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/proof/variants.h"

static vec3 towards(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return image_plane_vector(camera, place.s, place.t);
}

static Ray of_length_1(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, vec3_unit(towards(camera, screen, pixel))};
}

static Ray much_longer(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, 4321 * towards(camera, screen, pixel)};
}

static Ray much_shorter(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, towards(camera, screen, pixel) / 98765};
}

static Ray of_unit_distance(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, towards(with_unit_distance(camera), screen, pixel)};
}

static Ray through_the_point_of_the_world(Camera camera, Resolution screen, Pixel pixel)
{
    vec3 point = camera.origin + towards(camera, screen, pixel);
    return (Ray){.origin = camera.origin, .direction = point - camera.origin};
}

static Ray by_hand(Camera camera, Resolution screen, Pixel pixel)
{
    double x = (pixel.column + 0.5) / screen.width - 0.5;
    double y = 0.5 - (pixel.row + 0.5) / screen.height;
    vec3 direction = y * camera.height * camera.up + x * camera.width * camera.right +
                     camera.distance * camera.forward;
    return (Ray){camera.origin, direction};
}

// As in many renderers: the step from one pixel to the next, starting at the upper left corner.
static Ray in_steps_of_a_pixel(Camera camera, Resolution screen, Pixel pixel)
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

// Twice the vector to the centre is the sum of the vectors to two opposite corners of the pixel.
static Ray between_corners_of_the_pixel(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint corner = {pixel.column, pixel.row}, opposite = {corner.x + 1, corner.y + 1};
    Normalized a = screen_to_normalized(corner, screen);
    Normalized b = screen_to_normalized(opposite, screen);
    return (Ray){camera.origin,
                 image_plane_vector(camera, a.s, a.t) + image_plane_vector(camera, b.s, b.t)};
}

// Between the corners of the plane, weighted by the number of pixels on each side.
static Ray between_the_corners(Camera camera, Resolution screen, Pixel pixel)
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
static Ray by_tangents(Camera camera, Resolution screen, Pixel pixel)
{
    double x = (2 * pixel.column + 1.0) / screen.width - 1;
    double y = 1 - (2 * pixel.row + 1.0) / screen.height;
    double across = tan(atan(camera.width / 2 / camera.distance));
    double up = tan(atan(camera.height / 2 / camera.distance));
    vec3 direction = camera.forward + x * across * camera.right + y * up * camera.up;
    return (Ray){camera.origin, vec3_unit(direction)};
}

static Ray in_long_double(Camera camera, Resolution screen, Pixel pixel)
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
static Ray by_a_matrix(Camera camera, Resolution screen, Pixel pixel)
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

static vec3 step(vec3 from, vec3 by, int count)
{
    return count == 0 ? from : step(from + by * (count % 2), 2 * by, count / 2);
}

static Ray by_recursion(Camera camera, Resolution screen, Pixel pixel)
{
    vec3 half_across = camera.width / screen.width / 2 * camera.right;
    vec3 half_down = -camera.height / screen.height / 2 * camera.up;
    vec3 direction = step(upper_left(camera), half_across, 2 * pixel.column + 1);
    return (Ray){camera.origin, step(direction, half_down, 2 * pixel.row + 1)};
}

static const Variant variants[] = {
    VARIANT(pixel_ray, of_length_1, "a direction of length 1"),
    VARIANT(pixel_ray, much_longer, "a direction 4321 times as long"),
    VARIANT(pixel_ray, much_shorter, "a direction 98765 times as short"),
    VARIANT(pixel_ray, of_unit_distance, "by the camera of unit distance"),
    VARIANT(pixel_ray, through_the_point_of_the_world, "the point of the world minus the eye"),
    VARIANT(pixel_ray, by_hand, "without the earlier answers"),
    VARIANT(pixel_ray, in_steps_of_a_pixel, "from the upper left corner, pixel by pixel"),
    VARIANT(pixel_ray, between_corners_of_the_pixel, "between two corners of the pixel"),
    VARIANT(pixel_ray, between_the_corners, "from the upper left corner, in shares"),
    VARIANT(pixel_ray, by_tangents, "from -1 to 1, with tangents, of length 1"),
    VARIANT(pixel_ray, in_long_double, "in long double"),
    VARIANT(pixel_ray, by_a_matrix, "by the camera's matrix"),
    VARIANT(pixel_ray, by_recursion, "half pixels by recursion"),
    {0},
};
OF_STEM(variants)
