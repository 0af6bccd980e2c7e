// probes.c - calls that distinguish the mistakes of exercise 03: portrait and landscape, on the
// screen and beyond it.
#include "exercises/03-screen.h"

#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

enum { MANY = 16 };

static Resolution screen(int i)
{
    Resolution size = random_screen(2, 900);
    bool portrait = size.width < size.height;
    return portrait == (i % 2 == 0) ? size : (Resolution){size.height, size.width};
}

START_TEST(any_point_of_any_screen)
{
    for (int i = 0; i < MANY; i++) {
        Resolution size = screen(i);
        double x = random_number(-0.5, 1.5) * size.width;
        screen_to_normalized((ScreenPoint){x, random_number(-0.5, 1.5) * size.height}, size);
    }
}
END_TEST

START_TEST(any_place_of_any_screen)
{
    for (int i = 0; i < MANY; i++) {
        Resolution size = screen(i);
        double s = random_number(-0.5, 1.5);
        normalized_to_screen((Normalized){s, random_number(-0.5, 1.5)}, size);
    }
}
END_TEST

START_TEST(any_pixel)
{
    for (int i = 0; i < MANY; i++)
        pixel_center(random_pixel(screen(i)));
}
END_TEST

static void list_probes(void)
{
    tests_of("screen_to_normalized");
    test(any_point_of_any_screen);
    tests_of("normalized_to_screen");
    test(any_place_of_any_screen);
    tests_of("pixel_center");
    test(any_pixel);
}

OF_STEM(list_probes)
