// probes.c - calls that distinguish the mistakes of exercise 08: any camera, any sphere.
#include "exercises/08-fast.h"

#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

START_TEST(any_sphere_anywhere)
{
    for (int i = 0; i < 60; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(2, 900);
        Sphere sphere = {camera.origin + random_vec3(-8, 8), random_number(0.1, 5), 0};
        sphere_rectangle(camera, screen, sphere);
    }
}
END_TEST

// All of it on the screen, large and small.
START_TEST(spheres_near_the_middle)
{
    for (int i = 0; i < 40; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(20, 900);
        double radius = random_number(0.1, 3), ahead = radius * random_number(3, 20);
        vec3 aside = random_number(-0.2, 0.2) * camera.width / camera.distance * camera.right +
                     random_number(-0.2, 0.2) * camera.height / camera.distance * camera.up;
        Sphere sphere = {camera.origin + ahead * (camera.forward + aside), radius, 0};
        sphere_rectangle(camera, screen, sphere);
    }
}
END_TEST

// Within three pixels of the left, the right, the upper or the lower edge of the screen.
START_TEST(spheres_that_only_just_reach_the_screen)
{
    for (int i = 0; i < 80; i++) {
        Camera camera = random_camera();
        Resolution screen = random_screen(20, 900);
        bool across = i % 4 < 2;
        double half = (across ? camera.width : camera.height) / 2 / camera.distance;
        double pixels = across ? screen.width : screen.height;
        double around = random_number(0.05, 0.2), away = random_number(2, 9);
        double middle = atan(half * (random_number(0, 3) / pixels - 1)) - around;
        double aside = (i % 2 == 0 ? 1 : -1) * away * sin(middle), ahead = away * cos(middle);
        vec3 to = ahead * camera.forward + aside * (across ? camera.right : camera.up);
        if (ahead > 0.3 * away)
            sphere_rectangle(camera, screen, (Sphere){camera.origin + to, away * sin(around), 0});
    }
}
END_TEST

static void list_probes(void)
{
    tests_of("sphere_rectangle");
    test(any_sphere_anywhere);
    test(spheres_near_the_middle);
    test(spheres_that_only_just_reach_the_screen);
}

OF_STEM(list_probes)
