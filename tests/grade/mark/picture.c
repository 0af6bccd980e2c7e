// picture - a scene drawn by a student's answers, and by right ones for the chapters that lack;
// small.
//
//   PROGRAM ANSWERS SCENE FILE.png STEM...   the process ANSWERS has these chapters. Exit status 1
//                                            where there is no picture
//
// Right answers are in this process and call the student's through the pipe, so that the process
// that holds hostile code never holds them.
#include "chapters/shared/scene_camera.h"
#include "common/image.h"
#include "common/scene.h"
#include "exercises/06-ray-casting.h"
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/process.h"
#include "tests/judge/runner.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

static const Resolution size = {96, 72};
static Scene scene;
static const char *output;

// A call that gets no answer ends a test, so the picture is one.
TEST(cast_image_order, the_picture)
{
    Camera camera;
    Image image;
    Message message;
    ck_assert(image_create(&image, size, &message));
    ck_assert(scene_camera(&scene.view, size, &camera) == CAMERA_OK);
    cast_image_order(&scene, camera, &image);
    ck_assert(!record_is_missing());
    ck_assert(image_write_png(&image, output, &message));
    image_free(&image);
}
END_TEST

static bool is_among(const char *stem, char **stems)
{
    while (*stems != NULL && strcmp(*stems, stem) != 0)
        stems++;
    return *stems != NULL;
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fprintf(stderr, "Usage: %s ANSWERS SCENE FILE.png STEM...\n", argv[0]);
        return 2;
    }
    Message message;
    FILE *printed = process_printed_file();
    if (printed == NULL || !scene_load(argv[2], &scene, &message)) {
        fprintf(stderr, "%s\n", printed == NULL ? "no file for what is printed" : message.text);
        return 2;
    }
    output = argv[3];
    for (int i = 0; exercises[i].name != NULL; i++)
        answer_by(i, is_among(exercises[i].stem, argv + 4) ? NULL : direct_answers[i]);
    call_answers_from(argv[1], fileno(printed));
    static Outcomes outcomes;
    choose_stem("grade"); // of this file
    run_tests(NULL, NULL, ANSWERS_APART, &outcomes);
    call_stop();
    scene_free(&scene);
    return outcomes.tests[0].passed ? 0 : 1;
}
