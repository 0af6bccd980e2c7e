// scene_refused.c - tests of common/nff_entity.c and common/nff_view.c: what a line must not say.
// Expected: the format as common/scene.h describes it. Each error is checked for its line too.
#include "tests/house/common/scene.h"

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
    // The next lines are not skipped in their place.
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

static void list_tests(void)
{
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
}

OF_STEM(list_tests)
