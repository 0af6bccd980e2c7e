// probes.c - calls that distinguish the mistakes of exercise 04: any camera, portrait and
// landscape.
#include "exercises/04-pixel-ray.h"

#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

START_TEST(any_pixel_of_any_camera)
{
    for (int i = 0; i < 30; i++) {
        Camera camera = random_camera();
        Resolution size = random_screen(2, 60);
        if ((size.width < size.height) != (i % 2 == 0))
            size = (Resolution){size.height, size.width};
        pixel_ray(camera, size, random_pixel(size));
    }
}
END_TEST

START_TEST(any_pixel_of_a_single_row_or_column)
{
    for (int i = 0; i < 12; i++) {
        Camera camera = random_camera();
        Resolution size = random_screen(2, 60);
        *(i % 2 == 0 ? &size.width : &size.height) = 1;
        pixel_ray(camera, size, random_pixel(size));
    }
}
END_TEST

static void list_probes(void)
{
    tests_of("pixel_ray");
    test(any_pixel_of_any_camera);
    test(any_pixel_of_a_single_row_or_column);
}

OF_STEM(list_probes)
