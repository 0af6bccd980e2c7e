// 06-depth.c - a picture of depth: the nearer, the brighter.
//
// Optional, after chapter 06. After each change: make optional TASK=depth
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

static double from = 9, to = 20;

// How bright a hit is: 1 if it is 'from' ahead of the eye or less, 0 if it is 'to' ahead or more,
// and evenly in between. Ahead is measured along forward, in the units of the world. A direction
// has any length. Without a hit it is 0.
static double nearness(Camera camera, Ray ray, Hit hit)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    double near = nearness(drawing->camera, ray, nearest_hit(ray, &drawing->scene));
    return vec3_of(near, near, 0.12 + 0.88 * near);
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"from", 'f', "DISTANCE", option_number, &from, "where it is white (9)"},
        {"to", 't', "DISTANCE", option_number, &to, "where it is dark (20)"},
        {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws the depth of a scene.",
                           .scene = "exercises/optional/table.nff",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
