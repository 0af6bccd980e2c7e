// 06-ray-casting.c - calls that tell mistakes of exercise 06 apart: spheres before and behind each
// other, behind the eye and round it, in any order; pictures of either shape, by any camera.
#include "tests/06-ray-casting.h"

#include "tests/judge/suspects.h"

#include <stdlib.h>

enum { SPHERES = 6 };

// Some near the eye, which may be inside one.
static void random_spheres(Sphere *spheres, vec3 eye)
{
    for (int i = 0; i < SPHERES; i++) {
        spheres[i] = random_sphere(4, 0.5, 2.5);
        spheres[i].center += eye;
        spheres[i].surface = RED + (i + 1) % 4;
    }
}

static Scene random_scene(Sphere *spheres, vec3 eye)
{
    random_spheres(spheres, eye);
    Scene scene = scene_of(SPHERES, spheres);
    scene.background = random_vec3(0.1, 0.9);
    scene.ambient = random_vec3(0.1, 0.9);
    return scene;
}

START_TEST(nearest_hits_of_any_ray)
{
    for (int i = 0; i < 40; i++) {
        Sphere spheres[SPHERES];
        Ray ray = random_ray(3, 2);
        Scene scene = random_scene(spheres, ray.origin);
        scene.sphere_count = i % 8 == 7 ? 0 : 1 + i % SPHERES;
        nearest_hit(ray, &scene);
    }
}
END_TEST

static void ask_for_pictures(Cast *cast)
{
    for (int i = 0; i < 8; i++) {
        Sphere spheres[SPHERES];
        Camera camera = random_camera();
        camera.distance = random_number(0.5, 1.5);
        Scene scene = random_scene(spheres, camera.origin);
        for (int k = 0; k < SPHERES; k++)
            spheres[k].center += 3 * camera.forward;
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

void list_probes(void)
{
    tests_of("nearest_hit");
    test(nearest_hits_of_any_ray);
    tests_of("cast_image_order");
    test(pictures_of_any_scene_in_image_order);
    tests_of("cast_object_order");
    test(pictures_of_any_scene_in_object_order);
}
