// scene.c - tests of common/scene.c and common/nff_*.c: what an NFF file means, and every way in
// which a file is none.
// Expected: the format as common/scene.h describes it. Each error is checked for its line too.
#include "common/scene.h"

#include "tests/judge/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// A viewpoint, 6 lines, and a sphere in line 7.
#define VIEW "v\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 45\nresolution 64 48\n"
#define SPHERE "s 1 2 3 4\n"

static Message message, warning;

// Reads size bytes as a scene of the name scene.nff.
static bool read_bytes(const char *bytes, size_t size, Scene *scene)
{
    FILE *file = tmpfile();
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    rewind(file);
    strcpy(message.text, "");
    strcpy(warning.text, "nothing was said");
    bool good = scene_read(file, "scene.nff", scene, &message, &warning);
    fclose(file);
    return good;
}

// To be freed.
static Scene scene_of(const char *text)
{
    Scene scene;
    given("scene", "%.300s", text);
    expect_law(read_bytes(text, strlen(text), &scene), "a scene", "%s", message.text);
    return scene;
}

static void expect_refused_bytes(const char *bytes, size_t size, int line, const char *words)
{
    Scene scene;
    char start[30];
    snprintf(start, sizeof start, "scene.nff:%d: ", line);
    given("scene", "%.300s", bytes);
    expect_law(!read_bytes(bytes, size, &scene), "refused", "a scene");
    given("scene", "%.300s", bytes);
    expect_law(strncmp(message.text, start, strlen(start)) == 0, start, "%s", message.text);
    given("scene", "%.300s", bytes);
    expect_law(strstr(message.text, words) != NULL, words, "%s", message.text);
    // It is empty, and freeing it is harmless.
    ck_assert(scene.spheres == NULL && scene.surfaces == NULL && scene.lights == NULL);
    expect_int(scene.sphere_count + scene.surface_count + scene.light_count, 0);
    scene_free(&scene);
}

// This line, and words that its message must have.
static void expect_refused(const char *text, int line, const char *words)
{
    expect_refused_bytes(text, strlen(text), line, words);
}

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

// ---- how it may be written ------------------------------------------------------------------

static void expect_one_sphere(const char *text)
{
    Scene scene = scene_of(text);
    given("scene", "%.300s", text);
    expect_int(scene.sphere_count, 1);
    expect_vec3(scene.spheres[0].center, vec3_of(1, 2, 3), 0);
    expect_number(scene.spheres[0].radius, 4, 0);
    expect_pair(scene.view.resolution.width, scene.view.resolution.height, 64, 48, 0);
    expect_text(warning.text, "");
    scene_free(&scene);
}

START_TEST(comments_reach_to_the_end_of_the_line)
{
    expect_one_sphere("# v\n#\n" VIEW "s 1 2 3 4 # 5 6 7\n  # s 0 0 0 0\n#s 1 1 1 1\n");
    expect_one_sphere("v#iewpoint\nfrom 1 2 3# 4\nat 4 5 6\nup 0 1 0\nangle 45\n"
                      "resolution 64 48\ns 1 2 3 4#");
}
END_TEST

START_TEST(blanks_tabs_and_empty_lines_do_not_matter)
{
    expect_one_sphere("\n\n  \t\n" VIEW "\t s\t1  2 \v3\f4  \t\n\n");
}
END_TEST

START_TEST(lines_may_end_as_on_windows_or_not_at_all)
{
    expect_one_sphere("v\r\nfrom 1 2 3\r\nat 4 5 6\r\nup 0 1 0\r\nangle 45\r\n"
                      "resolution 64 48\r\n\r\ns 1 2 3 4\r\n");
    expect_one_sphere(VIEW "s 1 2 3 4");
}
END_TEST

START_TEST(a_byte_order_mark_is_no_word)
{
    expect_one_sphere("\xEF\xBB\xBF" VIEW SPHERE);
    expect_one_sphere("\xEF\xBB\xBF# comment\n" VIEW SPHERE);
    expect_refused("\n\xEF\xBB\xBF" VIEW SPHERE, 2, "'???v'");
}
END_TEST

START_TEST(two_hundred_thousand_spheres_are_read)
{
    enum { COUNT = 200000 };
    size_t room = (size_t)COUNT * 40, used = 0;
    char *text = malloc(room);
    ck_assert_ptr_nonnull(text);
    used += (size_t)sprintf(text, "%s", VIEW);
    for (int i = 0; i < COUNT; i++)
        used += (size_t)sprintf(text + used, "s %d 0 -%d 0.5\n", i, i);
    Scene scene;
    ck_assert(read_bytes(text, used, &scene));
    expect_int(scene.sphere_count, COUNT);
    for (int i = 0; i < COUNT; i++)
        if (scene.spheres[i].center[0] != i || scene.spheres[i].center[2] != -i)
            ck_abort_msg("sphere number %d is not where it should be", i);
    scene_free(&scene);
    free(text);
}
END_TEST

// A file is read piece by piece. Where two meet, any part of a line may stand.
START_TEST(lines_are_whole_wherever_the_pieces_of_a_file_meet)
{
    enum { PIECE = 1 << 16 };
    static char text[PIECE + 1000];
    for (size_t start = PIECE - 70; start <= PIECE + 2; start++) {
        size_t used = (size_t)sprintf(text, "%s", VIEW);
        int line = 6;
        for (; used + 500 < start; line++)
            used += (size_t)sprintf(text + used, "#%*s\n", 99, "");
        used += (size_t)sprintf(text + used, "#%*s\n", (int)(start - used) - 2, "");
        sprintf(text + used, "s 1.25 -2.5 3.75e1 0.5\nf .5 .5 .5 1 0 0 0 1\ns  4 5 6 7 # 8\n");
        Scene scene = scene_of(text);
        given("first sphere", "at byte %d", (int)start);
        expect_int(scene.sphere_count, 2);
        expect_vec3(scene.spheres[0].center, vec3_of(1.25, -2.5, 37.5), 0);
        expect_vec3(scene.spheres[1].center, vec3_of(4, 5, 6), 0);
        expect_int(scene.surface_count, 2);
        scene_free(&scene);
        strcat(text, "x");
        expect_refused(text, line + 5, "'x'");
    }
}
END_TEST

// ---- what the toolkit has no use for --------------------------------------------------------

START_TEST(cones_and_polygons_are_left_out_with_one_warning)
{
    Scene scene = scene_of(VIEW "c\n0 0 0 1\n0 1 0 0.5\n"
                                "p 3\n0 0 0\n1 0 0 # comment\n\n# comment\n1 1 0\n"
                                "s 1 2 3 4\n"
                                "pp 4\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n"
                                "c\n0 0 0 1\n0 1 0 0.5\nc\n0 0 0 1\n0 1 0 0\ns 5 6 7 8\n");
    expect_int(scene.sphere_count, 2);
    expect_vec3(scene.spheres[0].center, vec3_of(1, 2, 3), 0);
    expect_vec3(scene.spheres[1].center, vec3_of(5, 6, 7), 0);
    expect_law(strstr(warning.text, "scene.nff: warning: ") == warning.text, "whose warning", "%s",
               warning.text);
    expect_law(strstr(warning.text, "3 cones") != NULL, "3 cones", "%s", warning.text);
    expect_law(strstr(warning.text, "2 polygons") != NULL, "2 polygons", "%s", warning.text);
    ck_assert_ptr_null(strchr(warning.text, '\n'));
    scene_free(&scene);
}
END_TEST

START_TEST(a_scene_of_spheres_only_has_no_warning)
{
    Scene scene = scene_of(VIEW SPHERE);
    expect_text(warning.text, "");
    scene_free(&scene);
}
END_TEST

START_TEST(polygons_and_cones_that_lack_lines_are_refused)
{
    expect_refused(VIEW "p 4\n0 0 0\n1 0 0\n", 9, "end of the file");
    expect_refused(VIEW "p 4\n0 0 0\n1 0 0\n", 9, "4 lines of numbers after line 7");
    expect_refused(VIEW "c\n0 0 0 1\n", 8, "2 lines of numbers after line 7");
    expect_refused(VIEW "c", 7, "end of the file");
    expect_refused(VIEW "pp 2000000000\n0 0 0 0 0 1\n", 8, "2000000000");
    // What follows is not swallowed in their place.
    expect_refused(VIEW "p 4\n0 0 0\n1 0 0\n1 1 0\n" SPHERE, 11, "'s'");
    expect_refused(VIEW "c\n0 0 0 1\nf 1 1 1 1 0 0 0 1\n" SPHERE, 9, "'f'");
}
END_TEST

START_TEST(polygons_have_a_whole_number_of_vertices_from_3)
{
    expect_refused(VIEW "p\n", 7, "0 numbers");
    expect_refused(VIEW "p 2\n0 0 0\n1 0 0\n", 7, "polygon of 2");
    expect_refused(VIEW "p -3\n", 7, "polygon of -3");
    expect_refused(VIEW "p 3.5\n", 7, "polygon of 3.5");
    expect_refused(VIEW "p 1e30\n", 7, "polygon of 1e+30");
    expect_refused(VIEW "pp three\n", 7, "'three'");
    expect_refused(VIEW "p 3 3\n", 7, "2 numbers");
    expect_refused(VIEW "c 1\n0 0 0 1\n0 0 1 1\n", 7, "1 numbers");
}
END_TEST

// ---- viewpoints that are none ---------------------------------------------------------------

START_TEST(a_scene_without_a_viewpoint_is_refused_at_its_end)
{
    expect_refused(SPHERE "b 0 0 0\n# comment\n", 3, "'v'");
    expect_refused("from 1 2 3\n" VIEW, 1, "'from' outside a viewpoint");
    expect_refused(SPHERE "\nresolution 64 48\n", 3, "'resolution' outside a viewpoint");
}
END_TEST

START_TEST(a_viewpoint_that_lacks_a_line_is_refused_where_it_begins)
{
    expect_refused("#\nv\nat 4 5 6\nup 0 1 0\nangle 45\nresolution 64 48\n", 2, "'from'");
    expect_refused("#\nv\nfrom 1 2 3\nup 0 1 0\nangle 45\nresolution 64 48\n", 2, "'at'");
    expect_refused("#\nv\nfrom 1 2 3\nat 4 5 6\nangle 45\nresolution 64 48\n", 2, "'up'");
    expect_refused("#\nv\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nresolution 6 4\n", 2, "'angle'");
    expect_refused("#\nv\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 45\n", 2, "'resolution'");
    expect_refused("v", 1, "'from'");
}
END_TEST

START_TEST(nothing_of_a_viewpoint_stands_twice)
{
    expect_refused(VIEW SPHERE VIEW, 8, "first is in line 1");
    expect_refused("v\nfrom 1 2 3\nfrom 1 2 3\n", 3, "second 'from'");
    expect_refused(VIEW "\nat 4 5 6\n", 8, "second 'at'");
    expect_refused(VIEW "up 0 1 0\n", 7, "second 'up'");
    expect_refused(VIEW "angle 45\n", 7, "second 'angle'");
    expect_refused(VIEW "resolution 64 48\n", 7, "second 'resolution'");
    expect_refused(VIEW "hither 1\nhither 1\n", 8, "second 'hither'");
}
END_TEST

START_TEST(angles_are_more_than_0_and_less_than_180)
{
    expect_refused("v\nangle 0\n", 2, "angle of 0");
    expect_refused("v\nangle -45\n", 2, "angle of -45");
    expect_refused("v\nangle 180\n", 2, "angle of 180");
    expect_refused("v\nangle 1e9\n", 2, "angle of 1e+09");
    expect_refused("v\nangle nan\n", 2, "'nan'");
    expect_refused("v\nangle inf\n", 2, "'inf'");
}
END_TEST

START_TEST(resolutions_are_whole_numbers_from_1_to_16384)
{
    expect_refused("v\nresolution 0 48\n", 2, "resolution of 0");
    expect_refused("v\nresolution 64 0\n", 2, "resolution of 0");
    expect_refused("v\nresolution -64 48\n", 2, "resolution of -64");
    expect_refused("v\nresolution 1000000000 1000000000\n", 2, "resolution of 1e+09");
    expect_refused("v\nresolution 64 16385\n", 2, "resolution of 16385");
    expect_refused("v\nresolution 64.5 48\n", 2, "resolution of 64.5");
    expect_refused("v\nresolution 64 1e300\n", 2, "resolution of 1e+300");
    expect_refused("v\nresolution nan 48\n", 2, "'nan'");
    expect_refused("v\nresolution 64x48\n", 2, "1 numbers");
}
END_TEST

// ---- lines that are wrong -------------------------------------------------------------------

START_TEST(a_radius_is_positive_and_finite)
{
    expect_refused(VIEW "s 1 2 3 0\n", 7, "radius of 0");
    expect_refused(VIEW "s 1 2 3 -0.0\n", 7, "radius of");
    expect_refused(VIEW SPHERE "s 1 2 3 -4\n", 8, "radius of -4");
    expect_refused(VIEW "s 1 2 3 inf\n", 7, "'inf'");
    expect_refused(VIEW "s 1 2 3 nan\n", 7, "'nan'");
    expect_refused(VIEW "s 1 2 3 1e999\n", 7, "'1e999'");
}
END_TEST

START_TEST(numbers_are_finite_and_decimal)
{
    expect_refused(VIEW "s nan 2 3 4\n", 7, "'nan'");
    expect_refused(VIEW "s 1 -inf 3 4\n", 7, "'-inf'");
    expect_refused(VIEW "s 1 2 0x3 4\n", 7, "'0x3'");
    expect_refused(VIEW "s 1 2 3 4abc\n", 7, "'4abc'");
    expect_refused(VIEW "s 1,2,3 4 5 6\n", 7, "'1,2,3'");
    expect_refused(VIEW "f 1 1 1 1 0 nan 0 1\n", 7, "'nan'");
    expect_refused(VIEW "l 1 2 infinity\n", 7, "'infinity'");
    expect_refused("v\nfrom 1 2 nan\n", 2, "'nan'");
    expect_refused("v\nhither nan\n", 2, "'nan'");
}
END_TEST

START_TEST(too_few_and_too_many_numbers_are_counted)
{
    expect_refused(VIEW "s 1 2 3\n", 7, "3 numbers, expected s X Y Z RADIUS");
    expect_refused(VIEW "s 1 2 3 4 5\n", 7, "5 numbers, expected s");
    expect_refused(VIEW "s\n", 7, "0 numbers, expected s");
    expect_refused(VIEW "f 1 0 0\n", 7, "3 numbers, expected f");
    expect_refused(VIEW "f 1 0 0 1 0 0 0 1 1\n", 7, "9 numbers, expected f");
    expect_refused(VIEW "b 1 1\n", 7, "2 numbers, expected b");
    expect_refused(VIEW "b 1 1 1 1\n", 7, "4 numbers, expected b");
    expect_refused(VIEW "l 1 2\n", 7, "2 numbers, expected l");
    expect_refused(VIEW "l 1 2 3 1\n", 7, "4 numbers, expected l");
    expect_refused(VIEW "l 1 2 3 1 1\n", 7, "5 numbers, expected l");
    expect_refused(VIEW "l 1 2 3 1 1 1 1\n", 7, "7 numbers, expected l");
    expect_refused("v 1\n", 1, "1 numbers, expected v");
    expect_refused("v\nfrom 1 2\n", 2, "2 numbers, expected from X Y Z");
    expect_refused("v\nat 1 2 3 4\n", 2, "4 numbers, expected at X Y Z");
    expect_refused("v\nup\n", 2, "0 numbers, expected up X Y Z");
    expect_refused("v\nangle\n", 2, "0 numbers, expected angle DEGREES");
    expect_refused("v\nangle 45 45\n", 2, "2 numbers, expected angle DEGREES");
    expect_refused("v\nhither\n", 2, "0 numbers, expected hither");
    expect_refused("v\nresolution 64\n", 2, "1 numbers, expected resolution WIDTH HEIGHT");
}
END_TEST

START_TEST(colours_are_from_0_to_1)
{
    expect_refused("b 0 0 1.5\n", 1, "colour of 1.5");
    expect_refused("b -0.5 0 1\n", 1, "colour of -0.5");
    expect_refused("b 127 127 127\n", 1, "expected 0 to 1");
    expect_refused("f 0 2 0 1 0 0 0 1\n", 1, "colour of 2");
    expect_refused("f 0 0 -1 1 0 0 0 1\n", 1, "colour of -1");
    expect_refused("l 1 2 3 1 1 1.01\n", 1, "colour of 1.01");
    expect_refused("l 1 2 3 -1 1 1\n", 1, "colour of -1");
}
END_TEST

START_TEST(unknown_words_are_named)
{
    expect_refused(VIEW "sphere 1 2 3 4\n", 7, "'sphere', expected one of v b l f s");
    expect_refused(VIEW "S 1 2 3 4\n", 7, "'S'");
    expect_refused(VIEW "1 2 3 4\n", 7, "'1'");
    expect_refused("<html>\n", 1, "'<html>'");
    expect_refused("\n\n\x1b[2J\n", 3, "'?[2J'");
}
END_TEST

// ---- files that are no scenes ---------------------------------------------------------------

START_TEST(empty_files_are_refused)
{
    expect_refused("", 1, "'v'");
    expect_refused("\n", 1, "'v'");
    expect_refused("# comment\n\n# comment\n", 3, "'v'");
    expect_refused("# comment\n# comment", 2, "'v'");
}
END_TEST

START_TEST(a_file_with_a_zero_byte_is_no_text)
{
    const char binary[] = VIEW "s 1 2\0 3 4\n";
    expect_refused_bytes(binary, sizeof binary - 1, 7, "zero byte");
    expect_refused_bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16, 1, "'?PNG'");
    expect_refused_bytes("\0", 1, 1, "zero byte");
}
END_TEST

START_TEST(every_byte_is_read_or_refused)
{
    for (int c = 0; c < 256; c++) {
        char text[] = VIEW "s 1 2 3 4_\n";
        text[sizeof text - 3] = (char)c;
        Scene scene;
        bool good = read_bytes(text, sizeof text - 1, &scene);
        bool fits = c != 0 && strchr(" \t\r\n\f\v#.0123456789", c) != NULL;
        given("behind the radius", "byte %d", c);
        expect_law(good == fits, fits ? "read" : "refused", "%s", good ? "read" : message.text);
        scene_free(&scene);
    }
}
END_TEST

START_TEST(lines_are_at_most_1000_characters_long)
{
    static char text[2000000];
    for (int length = 1000; length <= 1001; length++) {
        size_t used = (size_t)sprintf(text, VIEW "#%*s\n" SPHERE, length - 1, "");
        Scene scene;
        given("longest line", "%d characters", length);
        expect_law(read_bytes(text, used, &scene) == (length == 1000),
                   length == 1000 ? "a scene" : "refused", "%s", message.text);
        scene_free(&scene);
    }
    expect_refused_bytes(text, strlen(text), 7, "more than 1000 characters");
    memset(text, 's', sizeof text);
    expect_refused_bytes(text, sizeof text, 1, "more than 1000 characters");
}
END_TEST

START_TEST(lines_have_at_most_16_words)
{
    Scene scene = scene_of(VIEW "p 3\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n0 0 0\n0 0 1\n");
    scene_free(&scene);
    expect_refused("v 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n", 1, "more than 16 words");
}
END_TEST

START_TEST(a_message_is_one_line_of_plain_characters)
{
    char text[900] = VIEW "s 1 2 3 ";
    size_t start = strlen(text);
    memset(text + start, '\x1b', sizeof text - 1 - start);
    Scene scene;
    ck_assert(!read_bytes(text, strlen(text), &scene));
    for (const char *c = message.text; *c != '\0'; c++)
        ck_assert_msg(*c >= ' ' && *c <= '~', "byte %d", (unsigned char)*c);
    ck_assert_uint_le(strlen(message.text), 200);
}
END_TEST

START_TEST(an_error_that_follows_a_warning_still_has_its_line)
{
    expect_refused(VIEW "c\n0 0 0 1\n0 1 0 1\np 3\n0 0 0\n1 0 0\n1 1 0\nx\n", 14, "'x'");
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

void list_tests(void)
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
    tests_of("scene_read writing");
    test(comments_reach_to_the_end_of_the_line);
    test(blanks_tabs_and_empty_lines_do_not_matter);
    test(lines_may_end_as_on_windows_or_not_at_all);
    test(a_byte_order_mark_is_no_word);
    test(two_hundred_thousand_spheres_are_read);
    test(lines_are_whole_wherever_the_pieces_of_a_file_meet);
    tests_of("scene_read leaving out");
    test(cones_and_polygons_are_left_out_with_one_warning);
    test(a_scene_of_spheres_only_has_no_warning);
    test(polygons_and_cones_that_lack_lines_are_refused);
    test(polygons_have_a_whole_number_of_vertices_from_3);
    tests_of("scene_read viewpoint");
    test(a_scene_without_a_viewpoint_is_refused_at_its_end);
    test(a_viewpoint_that_lacks_a_line_is_refused_where_it_begins);
    test(nothing_of_a_viewpoint_stands_twice);
    test(angles_are_more_than_0_and_less_than_180);
    test(resolutions_are_whole_numbers_from_1_to_16384);
    tests_of("scene_read lines");
    test(a_radius_is_positive_and_finite);
    test(numbers_are_finite_and_decimal);
    test(too_few_and_too_many_numbers_are_counted);
    test(colours_are_from_0_to_1);
    test(unknown_words_are_named);
    tests_of("scene_read files");
    test(empty_files_are_refused);
    test(a_file_with_a_zero_byte_is_no_text);
    test(every_byte_is_read_or_refused);
    test(lines_are_at_most_1000_characters_long);
    test(lines_have_at_most_16_words);
    test(a_message_is_one_line_of_plain_characters);
    test(an_error_that_follows_a_warning_still_has_its_line);
    tests_of("scene_load");
    test(a_missing_file_and_a_folder_are_named);
    test(the_reason_is_said_whatever_the_length_of_a_name);
    test(a_scene_is_loaded_from_a_path);
    test(a_scene_may_be_freed_twice);
}
