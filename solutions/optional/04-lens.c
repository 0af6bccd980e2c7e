// 04-lens.c - a lens, which is sharp at one distance only (depth of field).
//
// Optional, after chapter 04. After each change: make optional TASK=lens
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"

static double focus = 10.5, radius = 0.15;

// A lens collects light in all of its disc, and everything at the distance 'focus' ahead of the eye
// (measured along forward) is sharp: all rays of one pixel meet there. Your pixel_ray goes through
// the middle of the lens. Return the ray of the same pixel that starts at another point of the
// lens: 'right' to the right of the eye and 'up' above it.
static Ray lens_ray(Camera camera, Ray middle, double right, double up)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Ray);
    double ahead = vec3_dot(middle.direction, camera.forward);
    vec3 sharp = middle.origin + focus / ahead * middle.direction;
    vec3 from = camera.origin + right * camera.right + up * camera.up;
    return (Ray){from, sharp - from};
    // END SOLUTION
}

// The average over the points of a spiral, which fill a disc evenly.
static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    enum { POINTS = 64 };
    Ray middle = pixel_ray(drawing->camera, drawing->image.size, pixel);
    Color sum = vec3_of(0, 0, 0);
    for (int i = 0; i < POINTS; i++) {
        double angle = 2.399963 * i, r = radius * sqrt((i + 0.5) / POINTS);
        sum += room_color(lens_ray(drawing->camera, middle, r * cos(angle), r * sin(angle)));
    }
    return sum / POINTS;
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"focus", 'f', "DISTANCE", option_number, &focus, "at which the picture is sharp (10.5)"},
        {"radius", 'r', "RADIUS", option_number, &radius, "of the lens (0.15)"},
        {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room through a lens.",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
