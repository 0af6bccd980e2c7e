// probes.c - calls that distinguish the mistakes of exercise 07: colours and lights that are
// neither grey nor full, lights and eyes on either side of the surface, worlds of several spheres
// and lights.
#include "tests/07-shading/support-scene.h"
#include "tests/07-shading/support.h"

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
        ambient_term(surface, kd, random_color(0.1, i % 4 == 3 ? 9 : 0.9));
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
        Color light = random_color(0.1, i % 4 == 2 ? 20 : 1.5);
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

// Most eyes near the mirrored light, so that there is a highlight; some on its other side.
static void ask_for_highlights(Highlight *term)
{
    for (int i = 0; i < 3 * MANY; i++) {
        double ks = random_number(0.1, 0.9), shine = random_number(0.5, 9);
        Color light = random_color(0.1, i % 4 == 0 ? 30 : 1.5);
        if (i % 6 == 5)
            shine = i / 6 % 4;
        bool sharp = i % 6 == 1; // close to the middle of a small highlight
        if (sharp)
            shine = random_number(12, 60);
        vec3 normal = random_unit(), to_light = any_way(normal, i);
        vec3 mirrored = 2 * vec3_dot(normal, to_light) * normal - to_light;
        vec3 to_eye = mirrored + random_number(0, sharp        ? 0.1
                                                  : i % 4 == 2 ? 3
                                                               : 0.8) *
                                     vec3_length(mirrored) * random_unit();
        if (i % 6 == 5)
            to_eye = -to_eye;
        if (i % 8 == 3) // behind, as both are
            to_eye = -to_light + 0.4 * normal;
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
    for (int i = 0; i < 2 * MANY; i++) {
        Sphere sphere = random_sphere(2, 0.2, 4);
        // Far away along one axis: the step is visible in the others.
        if (i % 4 != 3)
            sphere.center[i % 3] = (i % 2 == 0 ? 1 : -1) * random_number(300, 3000);
        vec3 normal = random_unit();
        off_surface(sphere, sphere.center + sphere.radius * normal, i % 2 == 0 ? normal : -normal);
    }
}
END_TEST

// From 1e-7 to 1, small as often as large, so that every threshold is between two of them.
static double any_small(void)
{
    return pow(10, random_number(-7, 0));
}

// A sphere that the ray from one point to another enters after some part of the way; 0 to 1 is
// between the two.
static void put_on_the_way(World *world, vec3 from, vec3 to, double part)
{
    vec3 way = to - from, normal = random_unit();
    if (vec3_dot(normal, way) > 0)
        normal = -normal;
    double radius = random_number(0.2, 1.5);
    put_sphere(world, from + part * way - radius * normal, radius, random_surface());
}

START_TEST(what_arrives_anywhere)
{
    for (int i = 0; i < 8 * MANY; i++) {
        World world;
        random_world(&world, i % 3, 1 + i % 5, 1);
        Light light = world.lights[0];
        vec3 from = random_vec3(-7, 7);
        vec3 to = light.kind == LIGHT_POINT ? light.position : from + light.position;
        double part = i % 9 == 6   ? random_number(1.2, 2)
                      : i % 8 < 3  ? random_number(0.1, 0.9)
                      : i % 8 == 3 ? any_small()
                      : i % 8 == 4 ? 1 - any_small()
                      : i % 8 == 5 ? random_number(1.01, 3)
                      : i % 8 == 6 ? -random_number(0.05, 1)
                                   : -0.01;
        put_on_the_way(&world, from, to, part);
        if (i % 9 == 6) // the first beyond the light, the last in front of it
            put_on_the_way(&world, from, to, random_number(0.2, 0.8));
        if (i % 5 == 0)
            put_on_the_way(&world, from, to, random_number(-1, 2));
        for (int k = 0; k < world.scene.surface_count; k++)
            world.surfaces[k].transmittance = random_number(0.1, 0.9);
        visibility(&world.scene, from, light);
    }
}
END_TEST

// Most spheres are visible, and some of their lights are hidden from them; some eyes are inside.
static Ray any_view(World *world, int i)
{
    random_world(world, 2 + i % 6, i % 4, 1);
    Ray ray = random_view(world, 1);
    if (i % 5 == 4)
        ray.origin = world->spheres[0].center + 0.6 * world->spheres[0].radius * random_unit();
    if (i % 10 == 9)
        ray.direction = random_number(0.2, 0.9) * vec3_unit(ray.direction);
    if (i % 6 == 3) { // two that are equal
        world->spheres[1].center = world->spheres[0].center;
        world->spheres[1].radius = world->spheres[0].radius;
    }
    if (i % 20 == 7) // and lights that do not count
        world->scene.light_count = 0;
    Hit hit = nearest_hit(ray, &world->scene);
    vec3 point = ray.origin + hit.t * ray.direction;
    if (hit.sphere >= 0 && world->scene.light_count > 0 && i % 3 == 0 &&
        world->lights[0].kind == LIGHT_POINT)
        put_on_the_way(world, point, world->lights[0].position, random_number(0.2, 0.8));
    if (i % 7 == 6)
        for (int k = 0; k < world->scene.light_count; k++)
            world->lights[k].color *= 9;
    if (i % 9 == 8)
        for (int k = 1; k < world->scene.surface_count; k++)
            world->surfaces[k].specular = 0;
    return ray;
}

START_TEST(light_of_any_surface)
{
    for (int i = 0; i < 5 * MANY; i++) {
        World world;
        Ray ray = any_view(&world, i);
        Hit hit = nearest_hit(ray, &world.scene);
        if (hit.sphere >= 0)
            shade(&world.scene, ray, hit);
    }
}
END_TEST

// Inside one, with a lamp between the place and the centre.
// In worlds of any size.
static void scale(World *world, Ray *ray, double size)
{
    for (int i = 0; i < world->scene.sphere_count; i++) {
        world->spheres[i].center *= size;
        world->spheres[i].radius *= size;
    }
    for (int i = 0; i < world->scene.light_count; i++)
        world->lights[i].position *= size;
    ray->origin *= size;
    ray->direction *= size;
}

START_TEST(light_in_any_size)
{
    for (int i = 0; i < 2 * MANY; i++) {
        World world;
        Ray ray = any_view(&world, i);
        scale(&world, &ray, pow(10, random_number(-5, 4)));
        Hit hit = nearest_hit(ray, &world.scene);
        if (hit.sphere >= 0)
            shade(&world.scene, ray, hit);
    }
}
END_TEST

START_TEST(what_is_seen_in_any_size)
{
    for (int i = 0; i < 2 * MANY; i++) {
        World world;
        Ray ray = any_view(&world, i);
        scale(&world, &ray, pow(10, random_number(-5, 4)));
        trace_ray(&world.scene, ray, i % 3);
    }
}
END_TEST

START_TEST(light_of_near_lamps)
{
    for (int i = 0; i < MANY; i++) {
        World world;
        random_world(&world, 0, 0, 1);
        vec3 center = random_vec3(-5, 5), axis = random_unit();
        double radius = random_number(0.5, 3);
        put_sphere(&world, center, radius, random_surface());
        put_light(&world, LIGHT_POINT, center + random_number(0.3, 0.8) * radius * axis,
                  random_color(0.2, 1));
        Ray ray = {center + random_number(-0.5, 0.2) * radius * axis, axis + 0.1 * random_unit()};
        shade(&world.scene, ray, nearest_hit(ray, &world.scene));
    }
}
END_TEST

// From edge to edge: with eye and light opposite each other, close above the surface.
START_TEST(light_that_grazes)
{
    for (int i = 0; i < MANY; i++) {
        World world;
        random_world(&world, 0, 0, 1);
        vec3 center = random_vec3(-5, 5), normal = random_unit(), across = random_across(normal);
        double radius = random_number(0.5, 3);
        Surface surface = random_surface();
        surface.shine = random_number(1, 3);
        put_sphere(&world, center, radius, surface);
        vec3 to_light = -across + random_number(0.1, 0.4) * normal;
        put_light(&world, LIGHT_DISTANT, random_number(0.2, 0.7) * to_light, random_color(0.2, 1));
        vec3 to_eye = across + random_number(0.1, 0.4) * normal;
        Ray ray = {center + radius * normal + 3 * radius * to_eye, -to_eye};
        shade(&world.scene, ray, nearest_hit(ray, &world.scene));
    }
}
END_TEST

START_TEST(what_any_ray_sees)
{
    for (int i = 0; i < 6 * MANY; i++) {
        World world;
        Ray ray = any_view(&world, i);
        trace_ray(&world.scene, i % 8 == 7 ? random_ray(6, 2) : ray, i % 4 == 0 ? 0 : 1 + i % 3);
    }
}
END_TEST

// So deep that one level more is visible: mirrors that face each other.
START_TEST(what_is_seen_in_many_mirrors)
{
    for (int depth = 0; depth < 9; depth++) {
        World world;
        random_world(&world, 0, 2, 1);
        vec3 axis = random_unit();
        for (int side = -1; side <= 1; side += 2)
            put_sphere(&world, side * 3 * axis, 2, mirror(random_color(0.2, 0.9), 0.95));
        trace_ray(&world.scene, (Ray){vec3_of(0, 0, 0), axis}, depth);
    }
}
END_TEST

START_TEST(clamped_colors)
{
    for (int i = 0; i < 3 * MANY; i++) {
        Color color = random_color(-0.7, 1.7);
        if (i % 3 == 2)
            color[i / 3 % 3] = i / 9 % 2;
        clamp_color(color);
    }
    // Below, inside and above, in each combination.
    for (int i = 0; i < 27; i++)
        clamp_color(vec3_of(i % 3 - random_number(0.2, 0.8), i / 3 % 3 - random_number(0.2, 0.8),
                            i / 9 - random_number(0.2, 0.8)));
}
END_TEST

START_TEST(encoded_colors)
{
    for (int i = 0; i < MANY; i++) {
        Color color = random_color(0.02, 0.98);
        if (i % 4 == 3)
            color[i / 4 % 3] = random_number(0, 0.003);
        gamma_encode(color, random_number(0.4, 4));
    }
}
END_TEST

static void list_probes(void)
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
    test(light_in_any_size);
    test(light_of_near_lamps);
    test(light_that_grazes);
    tests_of("trace_ray");
    test(what_any_ray_sees);
    test(what_is_seen_in_any_size);
    test(what_is_seen_in_many_mirrors);
    tests_of("clamp_color");
    test(clamped_colors);
    tests_of("gamma_encode");
    test(encoded_colors);
}

OF_STEM(list_probes)
