// 04-pixel-ray.c - wrong answers to exercise 04.
#include "exercises/04-pixel-ray.h"

#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "tests/mistakes/mistakes.h"

// The right way from a point of the screen on.
static vec3 towards(Camera camera, Resolution screen, ScreenPoint point)
{
    Normalized place = screen_to_normalized(point, screen);
    return image_plane_vector(camera, place.s, place.t);
}

static Ray corner_of_the_pixel(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint corner = {pixel.column, pixel.row};
    return (Ray){camera.origin, towards(camera, screen, corner)};
}

static Ray half_a_pixel_twice(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint center = pixel_center(pixel);
    return (Ray){camera.origin,
                 towards(camera, screen, (ScreenPoint){center.x + 0.5, center.y + 0.5})};
}

static Ray row_and_column_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    Pixel swapped = {pixel.row, pixel.column};
    return (Ray){camera.origin, towards(camera, screen, pixel_center(swapped))};
}

static Ray from_the_worlds_origin(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){vec3_of(0, 0, 0), towards(camera, screen, pixel_center(pixel))};
}

static Ray towards_the_point(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, camera.origin + towards(camera, screen, pixel_center(pixel))};
}

static Ray eye_subtracted_from_a_vector(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, towards(camera, screen, pixel_center(pixel)) - camera.origin};
}

static Ray from_the_plane(Camera camera, Resolution screen, Pixel pixel)
{
    vec3 direction = towards(camera, screen, pixel_center(pixel));
    return (Ray){camera.origin + direction, direction};
}

static Ray towards_the_eye(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin, -towards(camera, screen, pixel_center(pixel))};
}

static Ray not_turned_over(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint center = pixel_center(pixel);
    return (Ray){camera.origin,
                 image_plane_vector(camera, center.x / screen.width, center.y / screen.height)};
}

static Ray mirrored(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, image_plane_vector(camera, 1 - place.s, place.t)};
}

static Ray s_and_t_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, image_plane_vector(camera, place.t, place.s)};
}

static Ray width_and_height_swapped(Camera camera, Resolution screen, Pixel pixel)
{
    Resolution swapped = {screen.height, screen.width};
    return (Ray){camera.origin, towards(camera, swapped, pixel_center(pixel))};
}

static Ray one_pixel_less(Camera camera, Resolution screen, Pixel pixel)
{
    return (Ray){camera.origin,
                 image_plane_vector(camera, (double)pixel.column / (screen.width - 1),
                                    1 - (double)pixel.row / (screen.height - 1))};
}

static Ray not_normalized(Camera camera, Resolution screen, Pixel pixel)
{
    (void)screen;
    ScreenPoint center = pixel_center(pixel);
    return (Ray){camera.origin, image_plane_vector(camera, center.x, center.y)};
}

static Ray whole_numbers_divided(Camera camera, Resolution screen, Pixel pixel)
{
    int s = pixel.column / screen.width, t = 1 - pixel.row / screen.height;
    return (Ray){camera.origin, image_plane_vector(camera, s, t)};
}

static Ray center_of_the_pixel_above(Camera camera, Resolution screen, Pixel pixel)
{
    ScreenPoint center = {pixel.column + 0.5, pixel.row - 0.5};
    return (Ray){camera.origin, towards(camera, screen, center)};
}

static Ray from_minus_1_to_1(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, image_plane_vector(camera, 2 * place.s - 1, 2 * place.t - 1)};
}

static Ray counted_from_the_corner(Camera camera, Resolution screen, Pixel pixel)
{
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, image_plane_vector(camera, place.s + 0.5, place.t + 0.5)};
}

static Ray distance_taken_as_1(Camera camera, Resolution screen, Pixel pixel)
{
    camera.distance = 1;
    return (Ray){camera.origin, towards(camera, screen, pixel_center(pixel))};
}

static Ray plane_of_the_screens_shape(Camera camera, Resolution screen, Pixel pixel)
{
    camera.width = camera.height * screen.width / screen.height;
    return (Ray){camera.origin, towards(camera, screen, pixel_center(pixel))};
}

static Ray always_right_handed(Camera camera, Resolution screen, Pixel pixel)
{
    camera.right = vec3_cross(camera.forward, camera.up);
    return (Ray){camera.origin, towards(camera, screen, pixel_center(pixel))};
}

static Ray axes_of_the_world(Camera camera, Resolution screen, Pixel pixel)
{
    camera.right = vec3_of(1, 0, 0);
    camera.up = vec3_of(0, 1, 0);
    camera.forward = vec3_of(0, 0, 1);
    return (Ray){camera.origin, towards(camera, screen, pixel_center(pixel))};
}

const Mistake mistakes[] = {
    MISTAKE("P1", pixel_ray, corner_of_the_pixel, "the pixel's corner, not its centre"),
    MISTAKE("P2", pixel_ray, half_a_pixel_twice, "half a pixel added twice"),
    MISTAKE("P4", pixel_ray, row_and_column_swapped, "row and column swapped"),
    MISTAKE("P7", pixel_ray, from_the_worlds_origin, "from the world's origin"),
    MISTAKE("P8", pixel_ray, towards_the_point, "the point for the vector: eye not subtracted"),
    MISTAKE("P8-minus", pixel_ray, eye_subtracted_from_a_vector, "the eye taken off a vector"),
    MISTAKE("P-plane", pixel_ray, from_the_plane, "from the plane, not from the eye"),
    MISTAKE("P-behind", pixel_ray, towards_the_eye, "the other way: from the plane to the eye"),
    MISTAKE("P-down", pixel_ray, not_turned_over, "the row not turned over"),
    MISTAKE("P-mirror", pixel_ray, mirrored, "left and right swapped"),
    MISTAKE("P-swap", pixel_ray, s_and_t_swapped, "s and t swapped"),
    MISTAKE("P-sizes", pixel_ray, width_and_height_swapped, "W and H swapped"),
    MISTAKE("P-less", pixel_ray, one_pixel_less, "divided by W - 1, H - 1"),
    MISTAKE("P-pixels", pixel_ray, not_normalized, "pixels for s and t"),
    MISTAKE("P-whole", pixel_ray, whole_numbers_divided, "integer division"),
    MISTAKE("P-up", pixel_ray, center_of_the_pixel_above, "half a pixel up, not down"),
    MISTAKE("P-wide", pixel_ray, from_minus_1_to_1, "s and t from -1 to 1"),
    MISTAKE("P-corner", pixel_ray, counted_from_the_corner, "the half not taken off s and t"),
    MISTAKE("P-distance", pixel_ray, distance_taken_as_1, "the distance taken as 1"),
    MISTAKE("P-aspect", pixel_ray, plane_of_the_screens_shape, "w made of h and the screen"),
    MISTAKE("P-hand", pixel_ray, always_right_handed, "right worked out for one hand only"),
    MISTAKE("P-axes", pixel_ray, axes_of_the_world, "the world's axes for the camera's"),
    {0},
};
