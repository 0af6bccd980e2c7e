// 08-questions.c - how many spheres ask each pixel in object order.
//
// Optional, after chapter 08. After each change: make optional TASK=questions
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/08-fast.h"

#include <stdlib.h>

// Adds 1 to the count of every pixel whose middle is in the rectangle, which is a result of your
// sphere_rectangle. counts has one number for each pixel of the screen, row by row from the top.
static void ask_pixels(ScreenRectangle box, Resolution screen, int *counts)
{
    // BEGIN SOLUTION
    (void)box, (void)screen, (void)counts;
    NOT_ANSWERED_YET();
    // END SOLUTION
}

enum { SPHERES = 60 };

// A spiral of marbles around the ball of the scene, from near to far.
static Sphere marble(Sphere ball, int i)
{
    double angle = 0.55 * i, far = 0.12 * i;
    vec3 aside = vec3_of(cos(angle), 0.62 * sin(angle), 0);
    return (Sphere){ball.center + (0.9 + 0.02 * i) * ball.radius * aside + vec3_of(0, 0, 2 - far),
                    ball.radius * (0.16 + 0.002 * i), 0};
}

static Color color_of_count(int count)
{
    double x = count / 4.0;
    return vec3_of(fmin(0.08 + x, 1), fmin(0.09 + 0.55 * x, 1), fmin(0.14 + 0.25 * x * x, 1));
}

static void draw(Drawing *drawing)
{
    Resolution size = drawing->image.size;
    int pixels = size.width * size.height;
    int *counts = calloc((size_t)pixels, sizeof *counts);
    if (counts == NULL)
        return;
    for (int i = 0; i < SPHERES; i++) {
        Sphere sphere = marble(drawing->scene.spheres[0], i);
        ask_pixels(sphere_rectangle(drawing->camera, size, sphere), size, counts);
    }
    for (int i = 0; i < pixels; i++)
        image_set(&drawing->image, (Pixel){i % size.width, i / size.width},
                  color_of_count(counts[i]));
    free(counts);
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws how many of 60 spheres ask each pixel.",
                           .scene = "exercises/optional/ball.nff",
                           .size = {256, 160},
                           .draw = draw});
}
