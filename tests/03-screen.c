// 03-screen.c - tests of exercise 03. Expected values: the lecture's point, and fractions worked
// out by hand or chosen.
#include "exercises/03-screen.h"

#include "chapters/shared/example.h"
#include "tests/judge/test.h"

static const double tolerance = 1e-12;      // normalized
static const double pixel_tolerance = 1e-9; // of a pixel

static void given_screen(Resolution screen)
{
    given("screen", "%d x %d", screen.width, screen.height);
}

static void expect_normalized(ScreenPoint point, Resolution screen, double s, double t)
{
    given_screen(screen);
    given("point", "%s", pair_text(point.x, point.y).s);
    Normalized yours = screen_to_normalized(point, screen);
    expect_pair(yours.s, yours.t, s, t, tolerance);
}

static void expect_point(Normalized normalized, Resolution screen, double x, double y)
{
    given_screen(screen);
    given("(s, t)", "%s", pair_text(normalized.s, normalized.t).s);
    ScreenPoint yours = normalized_to_screen(normalized, screen);
    expect_pair(yours.x, yours.y, x, y, pixel_tolerance);
}

static void expect_center(int column, int row, double x, double y)
{
    given("pixel", "column %d, row %d", column, row);
    ScreenPoint yours = pixel_center((Pixel){column, row});
    expect_pair(yours.x, yours.y, x, y, pixel_tolerance);
}

// "What are the point's normalized screen coordinates?" The deck's are 0.46875 and 1/6.
TEST(screen_to_normalized, the_point_of_the_example_is_normalized)
{
    Resolution screen = example_screen();
    ScreenPoint point = example_point();
    expect_normalized(point, screen, point.x / screen.width,
                      (screen.height - point.y) / screen.height);
}

TEST(screen_to_normalized, a_point_may_lie_between_whole_pixels)
{
    expect_normalized((ScreenPoint){2.5, 0.75}, (Resolution){4, 3}, 0.625, 0.75);
    expect_normalized((ScreenPoint){0.125, 1.5}, (Resolution){2, 2}, 0.0625, 0.25);
}

TEST(screen_to_normalized, beyond_the_screen_is_beyond_0_to_1)
{
    expect_normalized((ScreenPoint){-320, 600}, (Resolution){640, 480}, -0.5, -0.25);
    expect_normalized((ScreenPoint){1280, -480}, (Resolution){640, 480}, 2, 2);
}

// The law of scale: on a screen of k times as many pixels the shares are the same.
TEST(screen_to_normalized, a_point_of_screens_of_any_shape_is_its_share_of_them)
{
    for (int i = 0; i < 20; i++) {
        Resolution screen = random_shape(i, 100, 1000000);
        double s = random_number(-1, 2), t = random_number(-1, 2);
        expect_normalized((ScreenPoint){s * screen.width, (1 - t) * screen.height}, screen, s, t);
    }
}

TEST(normalized_to_screen, normalized_and_back_is_the_point_of_the_example)
{
    Resolution screen = example_screen();
    ScreenPoint point = example_point();
    Normalized normalized = {point.x / screen.width, (screen.height - point.y) / screen.height};
    expect_point(normalized, screen, point.x, point.y);
}

TEST(normalized_to_screen, a_point_may_be_between_whole_pixels_on_the_screen)
{
    expect_point((Normalized){0.625, 0.75}, (Resolution){4, 3}, 2.5, 0.75);
    expect_point((Normalized){0.25, 0.625}, (Resolution){1, 1}, 0.25, 0.375);
}

TEST(normalized_to_screen, beyond_0_to_1_is_beyond_the_screen)
{
    expect_point((Normalized){-0.5, -0.25}, (Resolution){640, 480}, -320, 600);
    expect_point((Normalized){2, 2}, (Resolution){640, 480}, 1280, -480);
}

TEST(normalized_to_screen, a_share_of_a_screen_of_any_shape_is_that_share_of_its_pixels)
{
    for (int i = 0; i < 20; i++) {
        Resolution screen = random_shape(i, 100, 1000000);
        double x = random_number(0, 1) * screen.width;
        double below = random_number(0, 1) * screen.height; // the bottom edge is
        expect_point((Normalized){x / screen.width, below / screen.height}, screen, x,
                     screen.height - below);
    }
}

TEST_LINE(pixel_center, the_first_pixel_is_half_a_pixel_right_of_and_below_the_corner,
          expect_center(0, 0, 0.5, 0.5))

TEST(pixel_center, column_is_x_and_row_is_y)
{
    expect_center(300, 400, 300.5, 400.5);
    expect_center(7, 0, 7.5, 0.5);
}

// Beyond 16777216 a float cannot represent half a pixel.
TEST(pixel_center, the_center_of_a_pixel_far_out_is_half_a_pixel_on)
{
    expect_center(20000001, 3, 20000001.5, 3.5);
    expect_center(2, 30000000, 2.5, 30000000.5);
}

// The first point of a pixel is (column, row); its last points are just before the next pixel.
TEST(pixel_center, the_center_of_any_pixel_is_half_way_to_the_next_pixel)
{
    for (int i = 0; i < 20; i++) {
        Pixel pixel = random_pixel((Resolution){5000, 5000});
        Pixel next = {pixel.column + 1, pixel.row + 1};
        expect_center(pixel.column, pixel.row, (pixel.column + next.column) / 2.0,
                      (pixel.row + next.row) / 2.0);
    }
}

// ---- probes -------------------------------------------------------------------------------------

// Calls that distinguish the mistakes of exercise 03: portrait and landscape, on the screen and
// beyond it.

enum { MANY = 16 };

static Resolution screen(int i)
{
    Resolution size = random_screen(2, 900);
    bool portrait = size.width < size.height;
    return portrait == (i % 2 == 0) ? size : (Resolution){size.height, size.width};
}

PROBE(screen_to_normalized, any_point_of_any_screen)
{
    for (int i = 0; i < MANY; i++) {
        Resolution size = screen(i);
        double x = random_number(-0.5, 1.5) * size.width;
        screen_to_normalized((ScreenPoint){x, random_number(-0.5, 1.5) * size.height}, size);
    }
}

PROBE(normalized_to_screen, anywhere_on_any_screen)
{
    for (int i = 0; i < MANY; i++) {
        Resolution size = screen(i);
        double s = random_number(-0.5, 1.5);
        normalized_to_screen((Normalized){s, random_number(-0.5, 1.5)}, size);
    }
}

PROBE(pixel_center, any_pixel)
{
    for (int i = 0; i < MANY; i++)
        pixel_center(random_pixel(screen(i)));
}

// Beyond 2^24 a float does not hold the center.
PROBE(pixel_center, any_pixel_far_out)
{
    for (int i = 0; i < MANY; i++)
        pixel_center((Pixel){(int)random_number(17e6, 1e8), (int)random_number(17e6, 1e8)});
}
