// probes.c - calls that distinguish the mistakes of exercise 06: spheres in front of and behind
// each other, behind the eye and around it, in any order; pictures of either shape, by any camera.
#include "tests/06-ray-casting/support.h"

#include "tests/judge/suspects.h"

#include <math.h>

enum { SPHERES = 6 };

// Along a ray, ahead of and behind its origin and around it, a little to the side, and in any
// order.
static void random_row(Sphere *spheres, Ray ray)
{
    vec3 along = vec3_unit(ray.direction);
    for (int i = 0; i < SPHERES; i++) {
        double radius = random_number(0.4, 2.5);
        vec3 aside = random_number(0.3, 2.2) * radius * random_unit();
        spheres[i] = (Sphere){.center = ray.origin + random_number(-4, 9) * along + aside,
                              .radius = radius,
                              .surface = RED + (i + 1) % 4};
    }
}

static Light lights[] = {{.position = {3, 4, 5}, .color = {0.5, 0.6, 0.7}},
                         {.position = {-3, 5, 1}, .color = {0.7, 0.4, 0.3}},
                         {.position = {1, 2, -4}, .color = {0.2, 0.8, 0.5}},
                         {.position = {-2, 3, 2}, .color = {0.6, 0.1, 0.9}}};

static Scene any_scene(Sphere *spheres, int count)
{
    Scene scene = scene_of(count, spheres);
    scene.background = random_vec3(0.1, 0.9);
    scene.ambient = random_vec3(0.1, 0.9);
    scene.lights = lights; // for answers that count them instead of spheres
    scene.light_count = (count + 3) % 5;
    return scene;
}

static void in_a_world_of(double size, Ray *ray, int count, Sphere *spheres)
{
    ray->origin *= size;
    for (int i = 0; i < count; i++) {
        spheres[i].center *= size;
        spheres[i].radius *= size;
    }
}

START_TEST(nearest_hits_of_any_ray)
{
    for (int i = 0; i < 64; i++) {
        Sphere spheres[SPHERES];
        Ray ray = random_ray(3, 2);
        random_row(spheres, ray);
        Scene scene = any_scene(spheres, i % 8 == 7 ? 0 : 1 + i % SPHERES);
        if (i % 8 == 3) // one that is close
            ray.origin =
                spheres[0].center - (1 + pow(10, random_number(-7, -1)) / spheres[0].radius) *
                                        spheres[0].radius * vec3_unit(ray.direction);
        if (i % 16 == 4) // two that are equal
            spheres[1].center = spheres[0].center, spheres[1].radius = spheres[0].radius;
        if (i % 8 == 5) // any size
            in_a_world_of(pow(10, random_number(-6, 6)), &ray, SPHERES, spheres);
        nearest_hit(ray, &scene);
    }
}
END_TEST

static void ask_for_pictures(Cast *cast)
{
    for (int i = 0; i < 10; i++) {
        Sphere spheres[SPHERES];
        Camera camera = random_camera();
        camera.distance = random_number(0.5, 1.5);
        random_row(spheres, (Ray){camera.origin + 2 * camera.forward, camera.forward});
        if (i % 4 == 1) // around the eye
            spheres[i % 3].center = camera.origin + 0.3 * spheres[i % 3].radius * random_unit();
        if (i % 4 == 2) // two that are equal
            spheres[1].center = spheres[0].center, spheres[1].radius = spheres[0].radius;
        Scene scene = any_scene(spheres, SPHERES);
        if (i % 5 == 3) // brighter than everything in it
            scene.background = vec3_of(1, 1, 0.4);
        Resolution size = i % 2 == 0 ? (Resolution){11, 7} : (Resolution){6, 9};
        Image image = odd_image(size);
        cast(&scene, camera, &image);
        image_free(&image);
    }
}

START_TEST(pictures_of_any_scene_in_image_order)
{
    ask_for_pictures(image_order);
}
END_TEST

START_TEST(pictures_of_any_scene_in_object_order)
{
    ask_for_pictures(object_order);
}
END_TEST

static void list_probes(void)
{
    tests_of("nearest_hit");
    test(nearest_hits_of_any_ray);
    tests_of("cast_image_order");
    test(pictures_of_any_scene_in_image_order);
    tests_of("cast_object_order");
    test(pictures_of_any_scene_in_object_order);
}

OF_STEM(list_probes)
