// figure.c - a wrong answer beside the right one: the kind of figure, and its file.
#include "tests/judge/figure.h"

#include "tests/judge/numbers.h"
#include "tests/judge/right_answer.h"
#include "tests/judge/switchboard.h"

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

static void replace_all(char *text, size_t size, const char *old, const char *new)
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
    static Wire right;
    char path[4096], why[1000];
    const char *function = record->function;
    if (record->hidden || record->missing[0] != '\0' || kept == NULL ||
        exercise_number(function) != kept->exercise || !right_answer(record, kept, &right))
        return;
    why_of(why, sizeof why, diagnosis);
    Wrong wrong = {function, record, kept, &kept->question, &right, &kept->answer, why};
    bool is_picture = strncmp(exercises[kept->exercise].results, "Pixels", 6) == 0;
    if (!path_of(path, sizeof path, folder, function, is_picture ? ".png" : ".gp"))
        return;
    kept->question.read = kept->answer.read = right.read = 0;
    if (is_picture)
        write_pictures(&wrong, path);
    else
        write_figure(path, &wrong);
}

// ---- for the kinds ------------------------------------------------------------------------------

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

// Between round numbers of t: at most eight of them.
static double stride_of(const Axis *axis)
{
    static const double steps[] = {1, 2, 5};
    double step = 0, wide = axis->high - axis->low, power = pow(10, floor(log10(wide / 10)));
    for (int i = 0; wide / (step = power * steps[i % 3]) > 8; i++)
        power *= i % 3 == 2 ? 10 : 1;
    return step;
}

static bool is_taken(const double *t, int count, double tick, double stride)
{
    for (int i = 0; i < count; i++)
        if (fabs(t[i] - tick) < 0.3 * stride)
            return true;
    return false;
}

static void axis_row(Plot *plot, const Axis *axis, double t)
{
    plot_row_dot(plot, 4, (const double[]){t * axis->unit, axis->y, 0, t});
}

static void axis_ticks(Plot *plot, const Axis *axis)
{
    double step = stride_of(axis);
    int row = 0;
    plot_block(plot, "ticks", "x y z t");
    for (double n = ceil(axis->low / step); n * step <= axis->high; n++, row++) {
        axis_row(plot, axis, n * step);
        if (is_taken(axis->right, axis->right_count, n * step, step) ||
            is_taken(axis->yours, axis->your_count, n * step, step))
            continue;
        char words[200];
        snprintf(words, sizeof words, "%s", number_text_to(n * step, 10).s);
        replace_all(words, sizeof words, "-", "\u2212");
        plot_name(plot, (Label){words, "grey", .block = "ticks", .row = row});
    }
    plot_block_end(plot);
}

static void axis_marks(Plot *plot, const Axis *axis, const char *name, const double *t, int count,
                       Label label)
{
    plot_block(plot, name, "x y z t");
    for (int i = 0; i < count; i++) {
        axis_row(plot, axis, t[i]);
        label.block = name;
        label.row = i;
        plot_name(plot, label);
    }
    plot_block_end(plot);
}

void figure_axis(Plot *plot, const Axis *axis)
{
    vec3 begin = vec3_of(axis->low * axis->unit, axis->y, 0);
    vec3 end = vec3_of((axis->high + 0.04 * (axis->high - axis->low)) * axis->unit, axis->y, 0);
    plot_vector(plot, "axis", begin, end - begin);
    plot_fit(plot, begin, 0);
    plot_fit(plot, end, 0);
    plot_name(plot, (Label){"$t$", "grey", .block = "axis", .part = 1});
    axis_marks(plot, axis, "answer", axis->right, axis->right_count,
               (Label){"right", "blue", .step = 1});
    axis_marks(plot, axis, "yours", axis->yours, axis->your_count,
               (Label){"yours", "ink", .step = 2});
    axis_ticks(plot, axis);
}

Text figure_off(double right, double yours)
{
    Text text = {""};
    if (isfinite(right) && isfinite(yours))
        snprintf(text.s, sizeof text.s, "off by %.60s", number_text_to(yours - right, 4).s);
    return text;
}

bool figure_near(vec3 yours, vec3 right, double size)
{
    return vec3_is_finite(yours) && vec3_length(yours - right) <= FIGURE_FAR * size;
}

void figure_frame(Plot *plot, vec3 right, vec3 up, vec3 forward)
{
    plot_direction(plot, "right", right);
    plot_direction(plot, "up", up);
    plot_direction(plot, "forward", forward);
}

bool figure_same_place(vec3 a, vec3 b)
{
    return vec3_length(a - b) <= 1e-9 * (1 + vec3_length(b));
}
