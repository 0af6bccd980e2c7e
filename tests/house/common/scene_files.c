// scene_files.c - tests of common/nff_line.c and nff_plain.c: how an NFF file may be written, and
// what is none. Expected: the format as common/scene.h describes it. Each error is checked for its
// line too.
#include "common/workers.h"
#include "tests/house/common/scene.h"

#include <pthread.h>
#include <stdlib.h>

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

enum { THREADS = 3 };

static int most_threads; // that read together

typedef struct {
    void (*part)(void *given, int i);
    void *given;
    int i;
} OnePart;

static void *do_part(void *of)
{
    const OnePart *one = of;
    one->part(one->given, one->i);
    return NULL;
}

static void at_the_same_time(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    pthread_t all[THREADS];
    OnePart each[THREADS];
    ck_assert(threads == THREADS && parts <= THREADS);
    for (int i = 0; i < parts; i++) {
        each[i] = (OnePart){part, given, i};
        ck_assert(pthread_create(&all[i], NULL, do_part, &each[i]) == 0);
    }
    for (int i = 0; i < parts; i++)
        pthread_join(all[i], NULL);
    most_threads = parts > most_threads ? parts : most_threads;
}

static void one_at_a_time(void (*step)(void *given), void *given)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&lock);
    step(given);
    pthread_mutex_unlock(&lock);
}

// All threads read a long scene. Some of its lines are not plain; the last one is wrong.
START_TEST(threads_read_the_same_scene_together)
{
    enum { COUNT = 60000, FILL = 777, ODD = 19999 };
    size_t room = (size_t)COUNT * 70, used = 0;
    char *text = malloc(room);
    ck_assert_ptr_nonnull(text);
    used += (size_t)sprintf(text, "%s", VIEW);
    int line = 6;
    for (int i = 0; i < COUNT; i++) {
        if (i % FILL == 0)
            line++, used += (size_t)sprintf(text + used, "f 0 %g 1 0 0 0 0 %d\n", i * 1e-5, i);
        if (i % ODD == 0)
            line++, used += (size_t)sprintf(text + used, "# comment\n");
        line++;
        used += (size_t)sprintf(text + used, i % ODD == 1 ? "s %d  0 %d 0.5\n" : "s %d 0 %d 0.5\n",
                                i, -i);
    }
    Scene scene;
    workers_are(at_the_same_time, one_at_a_time, THREADS);
    most_threads = 0;
    ck_assert(read_bytes(text, used, &scene));
    expect_int(scene.sphere_count, COUNT);
    expect_int(scene.surface_count, (COUNT - 1) / FILL + 2);
    for (int i = 0; i < COUNT; i++) {
        Sphere sphere = scene.spheres[i];
        if (sphere.center[0] != i || sphere.center[2] != -i || sphere.surface != i / FILL + 1 ||
            scene_surface(&scene, i)->refraction != i - i % FILL)
            ck_abort_msg("sphere number %d is not as it should be", i);
    }
    expect_law(most_threads == THREADS, "all threads", "%d", most_threads);
    scene_free(&scene);
    sprintf(text + used, "s 1 2 3 0\n%s", SPHERE SPHERE);
    expect_refused(text, line + 1, "radius of 0");
    sprintf(text + used, "f 1 2 1 0 0 0 0 1\n%s", SPHERE SPHERE);
    expect_refused(text, line + 1, "colour of 2");
    free(text);
}
END_TEST

// ---- files that are not scenes --------------------------------------------------------------

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
        given("after the radius", "byte %d", c);
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

static void list_tests(void)
{
    tests_of("scene_read writing");
    test(comments_reach_to_the_end_of_the_line);
    test(blanks_tabs_and_empty_lines_do_not_matter);
    test(lines_may_end_as_on_windows_or_not_at_all);
    test(a_byte_order_mark_is_no_word);
    test(two_hundred_thousand_spheres_are_read);
    test(lines_are_whole_wherever_the_pieces_of_a_file_meet);
    test(threads_read_the_same_scene_together);
    tests_of("scene_read files");
    test(empty_files_are_refused);
    test(a_file_with_a_zero_byte_is_no_text);
    test(every_byte_is_read_or_refused);
    test(lines_are_at_most_1000_characters_long);
    test(lines_have_at_most_16_words);
    test(a_message_is_one_line_of_plain_characters);
    test(an_error_that_follows_a_warning_still_has_its_line);
}

OF_STEM(list_tests)
