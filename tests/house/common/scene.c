// scene.c - tests of common/scene.c and common/nff_*.c: what an NFF file means.
// Expected: the format as common/scene.h describes it.
#include "tests/house/common/scene.h"

#include <stdlib.h>
#include <unistd.h>

// ---- what a scene means ---------------------------------------------------------------------

START_TEST(the_viewpoint_is_read)
{
    Scene scene = scene_of("v\nfrom 1 2 3\nat -4 5.5 6\nup 0 0 1\nangle 45\nhither 0.1\n"
                           "resolution 64 48\n");
    expect_vec3(scene.view.from, vec3_of(1, 2, 3), 0);
    expect_vec3(scene.view.at, vec3_of(-4, 5.5, 6), 0);
    expect_vec3(scene.view.up, vec3_of(0, 0, 1), 0);
    expect_number(scene.view.angle, 45, 0);
    expect_pair(scene.view.resolution.width, scene.view.resolution.height, 64, 48, 0);
    scene_free(&scene);
}
END_TEST

START_TEST(the_lines_of_a_viewpoint_may_stand_in_any_order_without_hither)
{
    Scene scene = scene_of("v\nresolution 64 48\nangle 45\nup 0 1 0\n" SPHERE "at 4 5 6\n"
                           "from 1 2 3\n");
    expect_vec3(scene.view.from, vec3_of(1, 2, 3), 0);
    expect_vec3(scene.view.at, vec3_of(4, 5, 6), 0);
    expect_int(scene.sphere_count, 1);
    scene_free(&scene);
}
END_TEST

START_TEST(angles_and_resolutions_reach_to_their_limits)
{
    Scene scene = scene_of("v\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 179.999\n"
                           "resolution 16384 1\n");
    expect_number(scene.view.angle, 179.999, 0);
    expect_pair(scene.view.resolution.width, scene.view.resolution.height, 16384, 1, 0);
    scene_free(&scene);
    scene = scene_of("v\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 1e-9\nresolution 1e2 4.0\n");
    expect_number(scene.view.angle, 1e-9, 0);
    expect_pair(scene.view.resolution.width, scene.view.resolution.height, 100, 4, 0);
    scene_free(&scene);
}
END_TEST

START_TEST(background_is_black_and_fill_is_white_until_told)
{
    Scene scene = scene_of(VIEW SPHERE);
    expect_vec3(scene.background, vec3_of(0, 0, 0), 0);
    expect_int(scene.light_count, 0);
    expect_int(scene.surface_count, 1);
    expect_int(scene.sphere_count, 1);
    expect_vec3(scene_surface(&scene, 0)->color, vec3_of(1, 1, 1), 0);
    scene_free(&scene);
}
END_TEST

START_TEST(a_scene_without_spheres_is_a_scene)
{
    Scene scene = scene_of(VIEW);
    expect_int(scene.sphere_count, 0);
    scene_free(&scene);
}
END_TEST

START_TEST(the_background_is_read_and_the_last_one_counts)
{
    Scene scene = scene_of("b 1 1 1\n" VIEW "b 0.25 0 1\n");
    expect_vec3(scene.background, vec3_of(0.25, 0, 1), 0);
    scene_free(&scene);
}
END_TEST

START_TEST(spheres_are_read_in_order)
{
    Scene scene = scene_of(VIEW "s 1 -2 3.5 0.25\ns 1e3 0 -0 1e-9\n");
    expect_int(scene.sphere_count, 2);
    expect_vec3(scene.spheres[0].center, vec3_of(1, -2, 3.5), 0);
    expect_number(scene.spheres[0].radius, 0.25, 0);
    expect_vec3(scene.spheres[1].center, vec3_of(1000, 0, 0), 0);
    expect_number(scene.spheres[1].radius, 1e-9, 0);
    scene_free(&scene);
}
END_TEST

START_TEST(a_fill_applies_to_what_follows)
{
    Scene scene = scene_of(VIEW "s 0 0 0 1\nf 1 0 0 .5 .25 9 0.125 1.5\ns 1 0 0 1\ns 2 0 0 1\n"
                                "f 0 1 0 1 0 0 0 1\nf 0 0 1 1 0 0 0 1\ns 3 0 0 1\n");
    const vec3 colors[] = {vec3_of(1, 1, 1), vec3_of(1, 0, 0), vec3_of(1, 0, 0), vec3_of(0, 0, 1)};
    expect_int(scene.sphere_count, 4);
    for (int i = 0; i < 4; i++) {
        given("sphere", "number %d", i);
        expect_vec3(scene_surface(&scene, i)->color, colors[i], 0);
    }
    const Surface *red = scene_surface(&scene, 1);
    expect_number(red->diffuse, 0.5, 0);
    expect_number(red->specular, 0.25, 0);
    expect_number(red->shine, 9, 0);
    expect_number(red->transmittance, 0.125, 0);
    expect_number(red->refraction, 1.5, 0);
    scene_free(&scene);
}
END_TEST

START_TEST(a_light_is_white_or_has_a_colour)
{
    Scene scene = scene_of("l 1 2 3\n" VIEW "l -4 5 6 0.5 0.25 1\n");
    expect_int(scene.light_count, 2);
    expect_vec3(scene.lights[0].position, vec3_of(1, 2, 3), 0);
    // Without a colour white, of two lights the square root of a half.
    expect_vec3(scene.lights[0].color, vec3_of(sqrt(0.5), sqrt(0.5), sqrt(0.5)), 1e-15);
    expect_vec3(scene.lights[1].position, vec3_of(-4, 5, 6), 0);
    expect_vec3(scene.lights[1].color, vec3_of(0.5, 0.25, 1), 0);
    scene_free(&scene);
}
END_TEST

// ---- from a path ----------------------------------------------------------------------------

START_TEST(a_missing_file_and_a_folder_are_named)
{
    Scene scene;
    Message said = {""};
    ck_assert(!scene_load("/no/such/scene.nff", &scene, &said));
    expect_text(said.text, "/no/such/scene.nff: cannot be read: No such file or directory");
    expect_int(scene.sphere_count, 0);
    scene_free(&scene);
    ck_assert(!scene_load("/tmp", &scene, &said));
    expect_text(said.text, "/tmp:1: cannot be read: Is a directory");
    scene_free(&scene);
}
END_TEST

START_TEST(the_reason_is_said_whatever_the_length_of_a_name)
{
    Scene scene;
    Message said = {""};
    char path[3000] = "/no/such/";
    memset(path + strlen(path), '/', sizeof path - 1 - strlen(path));
    ck_assert(!scene_load(path, &scene, &said));
    ck_assert_ptr_nonnull(strstr(said.text, ": cannot be read: No such file"));
    scene_free(&scene);
}
END_TEST

START_TEST(a_scene_is_loaded_from_a_path)
{
    char path[] = "/tmp/scene-XXXXXX";
    int descriptor = mkstemp(path);
    ck_assert_int_ge(descriptor, 0);
    const char text[] = VIEW SPHERE "x\n";
    ck_assert_int_eq(write(descriptor, text, strlen(text) - 2), (long)strlen(text) - 2);
    Scene scene;
    Message said = {""};
    bool good = scene_load(path, &scene, &said);
    ck_assert_int_eq(write(descriptor, "x\n", 2), 2);
    close(descriptor);
    Scene none;
    bool bad = !scene_load(path, &none, &said);
    unlink(path);
    ck_assert(good && bad);
    expect_int(scene.sphere_count, 1);
    char expected[100];
    snprintf(expected, sizeof expected, "%s:8: 'x'", path);
    expect_law(strncmp(said.text, expected, strlen(expected)) == 0, expected, "%s", said.text);
    scene_free(&scene);
}
END_TEST

START_TEST(a_scene_may_be_freed_twice)
{
    Scene scene = scene_of(VIEW SPHERE "l 1 2 3\n");
    scene_free(&scene);
    ck_assert(scene.spheres == NULL && scene.surfaces == NULL && scene.lights == NULL);
    scene_free(&scene);
}
END_TEST

static void list_tests(void)
{
    tests_of("scene_read meaning");
    test(the_viewpoint_is_read);
    test(the_lines_of_a_viewpoint_may_stand_in_any_order_without_hither);
    test(angles_and_resolutions_reach_to_their_limits);
    test(background_is_black_and_fill_is_white_until_told);
    test(a_scene_without_spheres_is_a_scene);
    test(the_background_is_read_and_the_last_one_counts);
    test(spheres_are_read_in_order);
    test(a_fill_applies_to_what_follows);
    test(a_light_is_white_or_has_a_colour);
    tests_of("scene_load");
    test(a_missing_file_and_a_folder_are_named);
    test(the_reason_is_said_whatever_the_length_of_a_name);
    test(a_scene_is_loaded_from_a_path);
    test(a_scene_may_be_freed_twice);
}

OF_STEM(list_tests)
