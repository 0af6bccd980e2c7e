// 07-shading.c - calls that tell mistakes of exercise 07 apart: colours and lights that are neither
// grey nor full, lights and eyes on either side of the surface, worlds of several spheres and
// lights.
#include "tests/07-shading.h"
#include "tests/07-shading-scene.h"

#include "exercises/06-ray-casting.h"
#include "tests/judge/suspects.h"

enum { MANY = 16 };

START_TEST(normals_of_any_sphere)
{
    for (int i = 0; i < MANY; i++) {
        Sphere sphere = random_sphere(5, 0.2, 4);
        surface_normal(sphere, sphere.center + sphere.radius * random_unit());
    }
}
END_TEST

START_TEST(ways_to_any_light)
{
    for (int i = 0; i < MANY; i++) {
        Light light = {.position = random_vec3(-5, 5), .color = random_color(0.1, 1.5)};
        light.kind = i % 2 == 0 ? LIGHT_POINT : LIGHT_DISTANT;
        ray_to_light(random_vec3(-5, 5), light);
    }
}
END_TEST

START_TEST(ambient_of_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Color surface = random_color(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        ambient_term(surface, kd, random_color(0.1, 0.9));
    }
}
END_TEST

// From either side, of any length.
static vec3 any_way(vec3 normal, int i)
{
    vec3 way = random_unit();
    if ((vec3_dot(way, normal) < 0) != (i % 4 == 3))
        way = -way;
    return random_number(0.3, 4) * way;
}

START_TEST(diffuse_of_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Color surface = random_color(0.1, 0.9);
        double kd = random_number(0.1, 0.9);
        Color light = random_color(0.1, 1.5);
        vec3 normal = random_unit();
        diffuse_term(surface, kd, light, normal, any_way(normal, i));
    }
}
END_TEST

START_TEST(mirrored_directions)
{
    for (int i = 0; i < MANY; i++) {
        vec3 normal = random_unit();
        mirror_direction(random_number(0.3, 4) * random_unit(), normal);
    }
}
END_TEST

typedef Color Highlight(double ks, double shine, Color light, vec3 normal, vec3 to_light,
                        vec3 to_eye);

// Most eyes near the mirrored light, so that there is a highlight.
static void ask_for_highlights(Highlight *term)
{
    for (int i = 0; i < 2 * MANY; i++) {
        double ks = random_number(0.1, 0.9), shine = random_number(0.5, 9);
        Color light = random_color(0.1, 1.5);
        vec3 normal = random_unit(), to_light = any_way(normal, i);
        vec3 mirrored = 2 * vec3_dot(normal, to_light) * normal - to_light;
        vec3 to_eye = mirrored + random_number(0, i % 4 == 2 ? 3 : 0.8) * vec3_length(mirrored) *
                                     random_unit();
        term(ks, shine, light, normal, to_light, random_number(0.3, 4) * to_eye);
    }
}

START_TEST(highlights_of_phong)
{
    ask_for_highlights(phong_term);
}
END_TEST

START_TEST(highlights_half_way)
{
    ask_for_highlights(halfway_term);
}
END_TEST

START_TEST(steps_off_any_surface)
{
    for (int i = 0; i < MANY; i++) {
        Sphere sphere = random_sphere(50, 0.2, 40);
        vec3 normal = random_unit();
        off_surface(sphere, sphere.center + sphere.radius * normal, i % 2 == 0 ? normal : -normal);
    }
}
END_TEST

START_TEST(what_arrives_anywhere)
{
    for (int i = 0; i < 4 * MANY; i++) {
        World world;
        random_world(&world, 1 + i % 5, 1, 1);
        visibility(&world.scene, random_vec3(-7, 7), world.lights[0]);
    }
}
END_TEST

START_TEST(light_of_any_surface)
{
    for (int i = 0; i < 3 * MANY; i++) {
        World world;
        random_world(&world, 2 + i % 4, i % 4, 1);
        Ray ray = random_view(&world, 1);
        Hit hit = nearest_hit(ray, &world.scene);
        if (hit.sphere >= 0)
            shade(&world.scene, ray, hit);
    }
}
END_TEST

START_TEST(what_any_ray_sees)
{
    for (int i = 0; i < 3 * MANY; i++) {
        World world;
        random_world(&world, 2 + i % 4, 1 + i % 3, 1);
        Ray ray = random_view(&world, 1);
        trace_ray(&world.scene, i % 8 == 7 ? random_ray(6, 2) : ray, i % 4);
    }
}
END_TEST

START_TEST(clamped_colors)
{
    for (int i = 0; i < 2 * MANY; i++)
        clamp_color(random_color(-0.7, 1.7));
}
END_TEST

START_TEST(encoded_colors)
{
    for (int i = 0; i < MANY; i++) {
        Color color = random_color(0.02, 0.98);
        gamma_encode(color, random_number(0.4, 4));
    }
}
END_TEST

void list_probes(void)
{
    tests_of("surface_normal");
    test(normals_of_any_sphere);
    tests_of("ray_to_light");
    test(ways_to_any_light);
    tests_of("ambient_term");
    test(ambient_of_any_surface);
    tests_of("diffuse_term");
    test(diffuse_of_any_surface);
    tests_of("mirror_direction");
    test(mirrored_directions);
    tests_of("phong_term");
    test(highlights_of_phong);
    tests_of("halfway_term");
    test(highlights_half_way);
    tests_of("off_surface");
    test(steps_off_any_surface);
    tests_of("visibility");
    test(what_arrives_anywhere);
    tests_of("shade");
    test(light_of_any_surface);
    tests_of("trace_ray");
    test(what_any_ray_sees);
    tests_of("clamp_color");
    test(clamped_colors);
    tests_of("gamma_encode");
    test(encoded_colors);
}
