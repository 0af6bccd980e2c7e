// 04-pixel-ray.c - tests of exercise 04. Expected values: rays worked out by hand. A direction may
// have any positive length.
#include "exercises/04-pixel-ray.h"

#include "chapters/shared/example.h"
#include "tests/judge/test.h"

static const double tolerance = 1e-9;

static void given_pixel(Camera camera, Resolution screen, Pixel pixel)
{
    given_camera(camera);
    given("screen", "%d x %d", screen.width, screen.height);
    given("pixel", "column %d, row %d", pixel.column, pixel.row);
}

static void expect_direction(Camera camera, Resolution screen, Pixel pixel, vec3 direction)
{
    given_pixel(camera, screen, pixel);
    expect_same_ray(pixel_ray(camera, screen, pixel), (Ray){camera.origin, direction}, tolerance);
}

// By hand: the plane is 2 by 2, so a pixel is 1/320 wide and 1/240 high.
TEST(pixel_ray, the_outermost_pixels_of_the_deck_are_half_a_pixel_inside_its_corners)
{
    Camera c = camera_of_the_deck();
    Resolution screen = {640, 480};
    double x = 1 - 1.0 / 640, y = 1 - 1.0 / 480;
    expect_direction(c, screen, (Pixel){0, 0}, vec3_of(-x, y, 4));
    expect_direction(c, screen, (Pixel){639, 0}, vec3_of(x, y, 4));
    expect_direction(c, screen, (Pixel){0, 479}, vec3_of(-x, -y, 4));
    expect_direction(c, screen, (Pixel){639, 479}, vec3_of(x, -y, 4));
}

// From the middle of the plane, in pixels, then in the world's units. For the deck's numbers:
// 300.5 / 320 - 1 across; 1 - 400.5 / 240 up.
TEST(pixel_ray, the_pixel_of_the_example)
{
    Camera c = example_camera();
    Resolution screen = example_screen();
    Pixel pixel = example_pixel();
    double across = (2 * pixel.column + 1 - screen.width) * c.width / (2 * screen.width);
    double up = (screen.height - 2 * pixel.row - 1) * c.height / (2 * screen.height);
    vec3 v = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        v[i] = across * c.right[i] + up * c.up[i] + c.distance * c.forward[i];
    expect_direction(c, screen, pixel, v);
}

// By hand: as above with columns and rows swapped; for the other handedness, x is reversed.
TEST(pixel_ray, a_screen_of_2_by_4_seen_by_a_right_handed_camera)
{
    Camera c = camera_of_the_deck();
    c.right = -c.right;
    expect_direction(c, (Resolution){2, 4}, (Pixel){0, 0}, vec3_of(0.5, 0.75, 4));
    expect_direction(c, (Resolution){2, 4}, (Pixel){1, 2}, vec3_of(-0.5, -0.25, 4));
}

// By hand: a column of the deck's plane is all of it, 2 wide; 4 rows are 1/2 high, 5 columns 2/5.
TEST(pixel_ray, a_screen_of_a_single_column_or_row)
{
    Camera c = camera_of_the_deck();
    for (int row = 0; row < 4; row++)
        expect_direction(c, (Resolution){1, 4}, (Pixel){0, row}, vec3_of(0, 0.75 - 0.5 * row, 4));
    for (int column = 0; column < 5; column++)
        expect_direction(c, (Resolution){5, 1}, (Pixel){column, 0},
                         vec3_of(-0.8 + 0.4 * column, 0, 4));
}

// The law of scale: in a world that is k times as large the ray starts k times as far out, and its
// direction is the same; its length is free anyway.
TEST(pixel_ray, screens_of_any_shape_in_worlds_of_any_size)
{
    enum { COUNT = 26 };
    for (int i = 0; i < COUNT; i++) {
        Camera c = random_camera();
        double world = random_scale(i, COUNT);
        c.origin *= world;
        c.distance *= world;
        c.width *= world;
        c.height *= world;
        Resolution screen = random_shape(i, 40, 4000);
        Pixel pixel = random_pixel(screen);
        double right = ((2 * pixel.column + 1) / (2.0 * screen.width) - 0.5) * c.width;
        double up = (0.5 - (2 * pixel.row + 1) / (2.0 * screen.height)) * c.height;
        given_pixel(c, screen, pixel);
        expect_same_ray(pixel_ray(c, screen, pixel),
                        (Ray){c.origin, c.distance * c.forward + right * c.right + up * c.up},
                        tolerance * (c.distance + c.width + c.height));
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 04: any camera, portrait and landscape.

PROBE(pixel_ray, any_pixel_of_any_camera)
{
    for (int i = 0; i < 30; i++) {
        Camera camera = random_camera();
        Resolution size = random_screen(2, 60);
        if ((size.width < size.height) != (i % 2 == 0))
            size = (Resolution){size.height, size.width};
        pixel_ray(camera, size, random_pixel(size));
    }
}

PROBE(pixel_ray, any_pixel_of_a_single_row_or_column)
{
    for (int i = 0; i < 12; i++) {
        Camera camera = random_camera();
        Resolution size = random_screen(2, 60);
        *(i % 2 == 0 ? &size.width : &size.height) = 1;
        pixel_ray(camera, size, random_pixel(size));
    }
}
