// picture - the picture of a scene, drawn by all of a student's answers together, small.
//
//   PROGRAM ANSWERS SCENE FILE.png    ANSWERS: the answering process that has all chapters; or
//                                     'reference'. Exit status 1 where there is no picture
#include "chapters/06-ray-casting/scene_camera.h"
#include "common/image.h"
#include "common/scene.h"
#include "exercises/06-ray-casting.h"
#include "tests/judge/call.h"
#include "tests/judge/runner.h"
#include "tests/judge/switchboard.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

static const Resolution size = {160, 120};
static Scene scene;
static const char *output;

// A call that gets no answer ends a test, so the picture is one.
START_TEST(the_picture)
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

void list_tests(void)
{
    tests_of("cast_image_order");
    test(the_picture);
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "Usage: %s ANSWERS|reference SCENE FILE.png\n", argv[0]);
        return 2;
    }
    Message message;
    FILE *printed = tmpfile();
    if (printed == NULL || !scene_load(argv[2], &scene, &message)) {
        fprintf(stderr, "%s\n", printed == NULL ? "no file for what is printed" : message.text);
        return 2;
    }
    output = argv[3];
    if (strcmp(argv[1], "reference") == 0)
        switch_to_reference();
    else
        switch_all_to_process();
    call_answers_from(argv[1], fileno(printed));
    static Outcomes outcomes;
    run_tests(NULL, NULL, ANSWERS_APART, &outcomes);
    call_stop();
    scene_free(&scene);
    return outcomes.tests[0].passed ? 0 : 1;
}
