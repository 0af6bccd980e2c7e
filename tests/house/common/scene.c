// scene.c - tests of common/scene.c: what an NFF file means, how it may be written, what is refused
// and in which line. Expected: the format as common/scene.h describes it.
#include "common/scene.h"

#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

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

static void expect_viewpoint(const char *text, double angle, int width, int height, int spheres)
{
    Scene scene = scene_of(text);
    expect_vec3(scene.view.from, vec3_of(1, 2, 3), 0);
    expect_vec3(scene.view.at, vec3_of(-4, 5.5, 6), 0);
    expect_vec3(scene.view.up, vec3_of(0, 0, 1), 0);
    expect_number(scene.view.angle, angle, 0);
    expect_pair(scene.view.resolution.width, scene.view.resolution.height, width, height, 0);
    expect_int(scene.sphere_count, spheres);
    expect_text(warning.text, "");
    scene_free(&scene);
}

TEST(scene_read, a_viewpoint_is_read_in_any_order_with_or_without_hither)
{
    const char at[] = "v\nfrom 1 2 3\nat -4 5.5 6\nup 0 0 1\n";
    char text[200];
    const struct {
        const char *rest;
        double angle;
        int width, height;
    } views[] = {{"angle 45\nhither 0.1\nresolution 64 48\n", 45, 64, 48},
                 {"angle 179.999\nresolution 16384 1\n", 179.999, 16384, 1},
                 {"angle 1e-9\nresolution 1e2 4.0\n", 1e-9, 100, 4}};
    for (int i = 0; i < 3; i++) {
        snprintf(text, sizeof text, "%s%s", at, views[i].rest);
        expect_viewpoint(text, views[i].angle, views[i].width, views[i].height, 0);
    }
    expect_viewpoint("v\nresolution 64 48\nangle 45\nup 0 0 1\n" SPHERE "at -4 5.5 6\nfrom 1 2 3\n",
                     45, 64, 48, 1);
}

TEST(scene_read, background_is_black_and_the_last_one_counts)
{
    Scene scene = scene_of(VIEW SPHERE);
    expect_vec3(scene.background, vec3_of(0, 0, 0), 0);
    expect_int(scene.light_count, 0);
    scene_free(&scene);
    scene = scene_of("b 1 1 1\n" VIEW "b 0.25 0 1\n");
    expect_vec3(scene.background, vec3_of(0.25, 0, 1), 0);
    scene_free(&scene);
}

TEST(scene_read, spheres_are_read_in_order)
{
    Scene scene = scene_of(VIEW "s 1 -2 3.5 0.25\ns 1e3 0 -0 1e-9\n");
    expect_int(scene.sphere_count, 2);
    expect_vec3(scene.spheres[0].center, vec3_of(1, -2, 3.5), 0);
    expect_number(scene.spheres[0].radius, 0.25, 0);
    expect_vec3(scene.spheres[1].center, vec3_of(1000, 0, 0), 0);
    expect_number(scene.spheres[1].radius, 1e-9, 0);
    scene_free(&scene);
}

TEST(scene_read, a_fill_applies_to_what_follows)
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

TEST(scene_read, a_light_is_white_or_has_a_color)
{
    Scene scene = scene_of("l 1 2 3\n" VIEW "l -4 5 6 0.5 0.25 1\n");
    expect_int(scene.light_count, 2);
    expect_vec3(scene.lights[0].position, vec3_of(1, 2, 3), 0);
    // Without a color white, of two lights the square root of a half.
    expect_vec3(scene.lights[0].color, vec3_of(sqrt(0.5), sqrt(0.5), sqrt(0.5)), 1e-15);
    expect_vec3(scene.lights[1].position, vec3_of(-4, 5, 6), 0);
    expect_vec3(scene.lights[1].color, vec3_of(0.5, 0.25, 1), 0);
    scene_free(&scene);
}

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

TEST(scene_read, comments_reach_to_the_end_of_the_line)
{
    expect_one_sphere("# v\n#\n" VIEW "s 1 2 3 4 # 5 6 7\n  # s 0 0 0 0\n#s 1 1 1 1\n");
    expect_one_sphere("v#iewpoint\nfrom 1 2 3# 4\nat 4 5 6\nup 0 1 0\nangle 45\n"
                      "resolution 64 48\ns 1 2 3 4#");
}

TEST(scene_read, blanks_tabs_and_empty_lines_do_not_matter)
{
    expect_one_sphere("\n\n  \t\n" VIEW "\t s\t1  2 \v3\f4  \t\n\n");
}

TEST(scene_read, lines_may_end_as_on_windows_or_not_at_all)
{
    expect_one_sphere("v\r\nfrom 1 2 3\r\nat 4 5 6\r\nup 0 1 0\r\nangle 45\r\n"
                      "resolution 64 48\r\n\r\ns 1 2 3 4\r\n");
    expect_one_sphere(VIEW "s 1 2 3 4");
}

TEST(scene_read, a_byte_order_mark_is_no_word)
{
    expect_one_sphere("\xEF\xBB\xBF" VIEW SPHERE);
    expect_one_sphere("\xEF\xBB\xBF# comment\n" VIEW SPHERE);
    expect_refused("\n\xEF\xBB\xBF" VIEW SPHERE, 2, "'???v'");
}

// ---- files that are not scenes --------------------------------------------------------------

TEST(scene_read, a_file_with_a_zero_byte_is_no_text)
{
    const char binary[] = VIEW "s 1 2\0 3 4\n";
    expect_refused_bytes(binary, sizeof binary - 1, 7, "zero byte");
    expect_refused_bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16, 1, "'?PNG'");
    expect_refused_bytes("\0", 1, 1, "zero byte");
}

TEST(scene_read, every_byte_is_read_or_refused)
{
    for (int c = 0; c < 256; c++) {
        char text[] = VIEW "s 1 2 3 4_\n";
        text[sizeof text - 3] = (char)c;
        Scene scene;
        bool good = read_bytes(text, sizeof text - 1, &scene);
        bool fits = c != 0 && strchr(" \t\r\n\f\v#.0123456789", c) != NULL;
        given("after the radius", "byte %d", c);
        expect_law(good == fits, fits ? "read" : "refused", "%s", good ? "read" : message.text);
        scene_free(&scene);
    }
}

TEST(scene_read, lines_are_at_most_1000_characters_long)
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

TEST(scene_read, lines_have_at_most_16_words)
{
    Scene scene = scene_of(VIEW "p 3\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n0 0 0\n0 0 1\n");
    scene_free(&scene);
    expect_refused("v 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n", 1, "more than 16 words");
}

TEST(scene_read, a_message_is_one_line_of_plain_characters)
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

// ---- what the toolkit has no use for --------------------------------------------------------

TEST(scene_read, cones_and_polygons_are_left_out_with_one_warning)
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

// ---- what is refused ------------------------------------------------------------------------

static const struct {
    const char *text;
    int line; // in which its message says that something is wrong
    const char *words;
} refused[] = {
    // empty files are refused
    {"", 1, "'v'"},
    {"\n", 1, "'v'"},
    {"# comment\n\n# comment\n", 3, "'v'"},
    // an error that follows a warning still has its line
    {VIEW "c\n0 0 0 1\n0 1 0 1\np 3\n0 0 0\n1 0 0\n1 1 0\nx\n", 14, "'x'"},
    // polygons and cones that lack lines are refused
    {VIEW "p 4\n0 0 0\n1 0 0\n", 9, "4 lines of numbers after line 7"},
    {VIEW "c\n0 0 0 1\n", 8, "2 lines of numbers after line 7"},
    {VIEW "c", 7, "end of the file"},
    {VIEW "pp 2000000000\n0 0 0 0 0 1\n", 8, "2000000000"},
    // The next lines are not skipped in their place.
    {VIEW "p 4\n0 0 0\n1 0 0\n1 1 0\n" SPHERE, 11, "'s'"},
    {VIEW "c\n0 0 0 1\nf 1 1 1 1 0 0 0 1\n" SPHERE, 9, "'f'"},
    // polygons have a whole number of vertices from 3
    {VIEW "p\n", 7, "0 numbers"},
    {VIEW "p 2\n0 0 0\n1 0 0\n", 7, "polygon of 2"},
    {VIEW "p 3.5\n", 7, "polygon of 3.5"},
    {VIEW "p 3 3\n", 7, "2 numbers"},
    {VIEW "c 1\n0 0 0 1\n0 0 1 1\n", 7, "1 numbers"},
    // a scene without a viewpoint is refused at its end
    {SPHERE "b 0 0 0\n# comment\n", 3, "'v'"},
    {"from 1 2 3\n" VIEW, 1, "'from' outside a viewpoint"},
    {SPHERE "\nresolution 64 48\n", 3, "'resolution' outside a viewpoint"},
    // a viewpoint that lacks a line is refused where it begins
    {"#\nv\nat 4 5 6\nup 0 1 0\nangle 45\nresolution 64 48\n", 2, "'from'"},
    {"#\nv\nfrom 1 2 3\nup 0 1 0\nangle 45\nresolution 64 48\n", 2, "'at'"},
    {"#\nv\nfrom 1 2 3\nat 4 5 6\nangle 45\nresolution 64 48\n", 2, "'up'"},
    {"#\nv\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nresolution 6 4\n", 2, "'angle'"},
    {"#\nv\nfrom 1 2 3\nat 4 5 6\nup 0 1 0\nangle 45\n", 2, "'resolution'"},
    {"v", 1, "'from'"},
    // nothing of a viewpoint stands twice
    {VIEW SPHERE VIEW, 8, "first is in line 1"},
    {"v\nfrom 1 2 3\nfrom 1 2 3\n", 3, "second 'from'"},
    {VIEW "\nat 4 5 6\n", 8, "second 'at'"},
    {VIEW "resolution 64 48\n", 7, "second 'resolution'"},
    {VIEW "hither 1\nhither 1\n", 8, "second 'hither'"},
    // angles are more than 0 and less than 180
    {"v\nangle 0\n", 2, "angle of 0"},
    {"v\nangle 180\n", 2, "angle of 180"},
    // resolutions are whole numbers from 1 to 16384
    {"v\nresolution 0 48\n", 2, "resolution of 0"},
    {"v\nresolution 64 16385\n", 2, "resolution of 16385"},
    {"v\nresolution 64.5 48\n", 2, "resolution of 64.5"},
    // a radius is positive and finite
    {VIEW "s 1 2 3 0\n", 7, "radius of 0"},
    {VIEW "s 1 2 3 -0.0\n", 7, "radius of"},
    {VIEW SPHERE "s 1 2 3 -4\n", 8, "radius of -4"},
    // numbers are finite and decimal
    {VIEW "s nan 2 3 4\n", 7, "'nan'"},
    {VIEW "s 1 2 0x3 4\n", 7, "'0x3'"},
    {VIEW "s 1 2 3 4abc\n", 7, "'4abc'"},
    {VIEW "l 1 2 infinity\n", 7, "'infinity'"},
    // too few and too many numbers are counted
    {VIEW "s 1 2 3\n", 7, "3 numbers, expected s X Y Z RADIUS"},
    {VIEW "s 1 2 3 4 5\n", 7, "5 numbers, expected s"},
    {VIEW "s\n", 7, "0 numbers, expected s"},
    {VIEW "f 1 0 0\n", 7, "3 numbers, expected f"},
    {VIEW "f 1 0 0 1 0 0 0 1 1\n", 7, "9 numbers, expected f"},
    {VIEW "b 1 1\n", 7, "2 numbers, expected b"},
    {VIEW "l 1 2\n", 7, "2 numbers, expected l"},
    {VIEW "l 1 2 3 1\n", 7, "4 numbers, expected l"},
    {VIEW "l 1 2 3 1 1 1 1\n", 7, "7 numbers, expected l"},
    {"v 1\n", 1, "1 numbers, expected v"},
    {"v\nfrom 1 2\n", 2, "2 numbers, expected from X Y Z"},
    {"v\nup\n", 2, "0 numbers, expected up X Y Z"},
    {"v\nangle\n", 2, "0 numbers, expected angle DEGREES"},
    {"v\nhither\n", 2, "0 numbers, expected hither"},
    {"v\nresolution 64\n", 2, "1 numbers, expected resolution WIDTH HEIGHT"},
    // colors are from 0 to 1
    {"b 0 0 1.5\n", 1, "color of 1.5"},
    {"b -0.5 0 1\n", 1, "color of -0.5"},
    {"f 0 2 0 1 0 0 0 1\n", 1, "color of 2"},
    {"l 1 2 3 1 1 1.01\n", 1, "color of 1.01"},
    // unknown words are named
    {VIEW "sphere 1 2 3 4\n", 7, "'sphere', expected one of v b l f s"},
    {"<html>\n", 1, "'<html>'"},
    {"\n\n\x1b[2J\n", 3, "'?[2J'"},
};

TEST(scene_read, what_is_no_scene_is_refused_with_its_line)
{
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        expect_refused(refused[i].text, refused[i].line, refused[i].words);
}
