// figure.c - a wrong answer beside the right one: the kind of figure, and its file.
#include "tests/judge/figure.h"

#include "common/image.h"
#include "tests/judge/numbers.h"
#include "tests/judge/picture_panels.h"

#include <stdio.h>
#include <string.h>

// By the arguments and the results, as words (exercise.h); the first that fits. Arguments: how they
// begin.
static const struct {
    const char *arguments, *results;
    const char *layout;
    FigureReader *read;
    FigureWriter *write;
} kinds[] = {
    {"Camera", "vec3", "chapters/01-corners/figures/yours-and-right.gp", read_vector, write_vector},
    {"Camera", "Ray", "chapters/01-corners/figures/yours-and-right.gp", read_vector, write_vector},
    {"", "Camera", "tests/judge/layouts/camera.gp", read_camera, write_camera},
    {"", "CameraFault Camera", "tests/judge/layouts/camera.gp", read_camera, write_camera},
    {"", "Normalized", "tests/judge/layouts/place.gp", read_place, write_place},
    {"", "ScreenPoint", "tests/judge/layouts/place.gp", read_place, write_place},
    {"Camera", "ScreenRectangle", "tests/judge/layouts/rectangle.gp", read_rectangle,
     write_rectangle},
    {"Ray Sphere", "Ray", "tests/judge/layouts/ray.gp", read_ray, write_ray},
    {"Ray", "Quadratic", "tests/judge/layouts/equation.gp", read_equation, write_equation},
    {"Quadratic", "Roots", "tests/judge/layouts/equation.gp", read_equation, write_equation},
    {"Ray Sphere", "Roots", "tests/judge/layouts/section.gp", read_section, write_section},
    {"Ray Sphere", "double", "tests/judge/layouts/section.gp", read_section, write_section},
    {"Ray Scene", "Hit", "tests/judge/layouts/section.gp", read_section, write_section},
};

static bool path_of(char *path, size_t size, const char *folder, const char *function,
                    const char *ending)
{
    return snprintf(path, size, "%s/%s%s", folder, function, ending) < (int)size;
}

void figure_forget(const char *folder, const char *function)
{
    static const char *const endings[] = {".gp", ".svg", ".txt", ".png"};
    char path[4096];
    for (int i = 0; i < 4; i++)
        if (path_of(path, sizeof path, folder, function, endings[i]))
            remove(path);
}

static void write_figure(const char *path, Wrong *wrong)
{
    const Exercise *types = &exercises[wrong->kept->exercise];
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(types->results, kinds[i].results) != 0 ||
            strncmp(types->arguments, kinds[i].arguments, strlen(kinds[i].arguments)) != 0)
            continue;
        bool good = kinds[i].read(wrong) && !wrong->question->bad && !wrong->right->bad &&
                    !wrong->yours->bad;
        FILE *file = good ? fopen(path, "w") : NULL;
        if (file == NULL)
            return;
        Figure figure = {wrong->function, kinds[i].write};
        good = plot_script(file, kinds[i].layout, &figure, NULL, NULL, wrong);
        if (fclose(file) != 0 || !good)
            remove(path);
        return;
    }
}

// Yours, expected, and where they differ, side by side: after the scene and the camera comes the
// image; the results are its pixels.
static bool write_pictures(Wrong *wrong, const char *path)
{
    Scene scene;
    Camera camera;
    Image yours, right = {0};
    Message message;
    numbers_get(wrong->question, &type_Scene, &scene);
    numbers_free_value(&type_Scene, &scene);
    NUMBERS_GET(wrong->question, Camera, camera);
    numbers_get(wrong->question, &type_Image, &yours);
    bool good = !wrong->question->bad && image_create(&right, yours.size, &message);
    if (good) {
        numbers_get_pixels(wrong->yours, &yours);
        numbers_get_pixels(wrong->right, &right);
        size_t bytes = 3 * (size_t)right.size.width * (size_t)right.size.height;
        good = !wrong->yours->bad && !wrong->right->bad &&
               memcmp(yours.rgb, right.rgb, bytes) != 0 &&
               picture_panels_write(&yours, &right, 0, path);
    }
    image_free(&right);
    image_free(&yours);
    return good;
}

void replace_all(char *text, size_t size, const char *old, const char *new)
{
    size_t from = strlen(old), to = strlen(new);
    for (char *at = strstr(text, old); at != NULL; at = strstr(at + to, old)) {
        if (strlen(text) + to - from >= size)
            return;
        memmove(at + to, at + from, strlen(at + from) + 1);
        memcpy(at, new, to);
    }
}

// In the terminal, 'looks like' may be followed by a formula with hyphens for minus; here real
// minus signs are drawn.
static void why_of(char *why, size_t size, Diagnosis diagnosis)
{
    const Mistake *mistake = diagnosis.mistake;
    why[0] = '\0';
    if (mistake != NULL)
        snprintf(why, size, "%s%s%s", mistake->formula != NULL ? mistake->formula : "",
                 mistake->formula != NULL ? ": " : "", mistake->why);
    replace_all(why, size, "+-", "\u00b1");
    replace_all(why, size, "- ", "\u2212 ");
}

void figure_write(const char *folder, const Record *record, Kept *kept, Diagnosis diagnosis)
{
    char path[4096], why[1000];
    const char *function = record->function;
    const Numbers *answer = right_answer(record);
    if (record->hidden || record->missing[0] != '\0' || kept == NULL ||
        exercise_number(function) != kept->exercise || answer == NULL)
        return;
    Numbers right = {.count = answer->count, .at = answer->at};
    why_of(why, sizeof why, diagnosis);
    Wrong wrong = {function, record, kept, &kept->question, &right, &kept->answer, why};
    bool is_picture = strncmp(exercises[kept->exercise].results, "Pixels", 6) == 0;
    if (!path_of(path, sizeof path, folder, function, is_picture ? ".png" : ".gp"))
        return;
    kept->question.read = kept->answer.read = 0;
    if (is_picture)
        write_pictures(&wrong, path);
    else
        write_figure(path, &wrong);
}

// ---- for the kinds -----------------------------------------------------------------------------

void range_add(Range *range, double x)
{
    range->low = fmin(range->low, x);
    range->high = fmax(range->high, x);
}

bool range_try(Range *range, double x)
{
    enum { TIMES = 8 };
    Range wider = *range;
    range_add(&wider, x);
    if (!(wider.high - wider.low <= TIMES * (range->high - range->low)))
        return false;
    *range = wider;
    return true;
}
