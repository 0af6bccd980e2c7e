// 04-pixel-ray.c - right answers to exercise 04, written otherwise: directions of other lengths,
// and other ways to the same place.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/variants/variants.h"

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

// As in many a renderer: the step from one pixel to the next, from the upper left corner on.
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

// Twice the way to the centre is the sum of the ways to two opposite corners of the pixel.
static Ray between_corners_of_the_pixel(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint corner = {pixel.column, pixel.row}, opposite = {corner.x + 1, corner.y + 1};
    Normalized a = screen_to_normalized(corner, screen);
    Normalized b = screen_to_normalized(opposite, screen);
    return (Ray){camera.origin,
                 image_plane_vector(camera, a.s, a.t) + image_plane_vector(camera, b.s, b.t)};
}

const Variant variants[] = {
    VARIANT(pixel_ray, of_length_1, "a direction of length 1"),
    VARIANT(pixel_ray, much_longer, "a direction 4321 times as long"),
    VARIANT(pixel_ray, much_shorter, "a direction 98765 times as short"),
    VARIANT(pixel_ray, of_unit_distance, "by the camera of unit distance"),
    VARIANT(pixel_ray, through_the_point_of_the_world, "the point of the world minus the eye"),
    VARIANT(pixel_ray, by_hand, "without the earlier answers"),
    VARIANT(pixel_ray, in_steps_of_a_pixel, "from the upper left corner, pixel by pixel"),
    VARIANT(pixel_ray, between_corners_of_the_pixel, "between two corners of the pixel"),
    {0},
};
