// 01-fisheye.c - a fisheye lens, which sees half of the world around it.
//
// Optional, after chapter 01. After each change: make optional TASK=fisheye
#include "chapters/shared/task.h"
#include "common/answers.h"

static double degrees = 180;

// The picture of a fisheye lens is a disc. The middle of the disc shows what is straight ahead. The
// distance of a place from the middle is proportional to the angle between its direction and
// forward: at the rim, which is at distance 1, the angle is half of 'degrees'. A place to
// the right of the middle shows what is to the right of forward; one above it, what is above.
//
// right, up: the place in the disc, from its middle, -1 to 1. Returns the direction, of any length.
static vec3 fisheye_direction(Camera c, double right, double up)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Resolution size = drawing->image.size;
    double radius = fmin(size.width, size.height) / 2.0;
    double right = (pixel.column + 0.5 - size.width / 2.0) / radius;
    double up = (size.height / 2.0 - pixel.row - 0.5) / radius;
    if (hypot(right, up) > 1)
        return vec3_of(0.05, 0.05, 0.06);
    return room_color((Ray){drawing->camera.origin, fisheye_direction(drawing->camera, right, up)});
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"degrees", 'd', "D", option_number, &degrees, "the angle from rim to rim (180)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room through a fisheye lens.",
                           .size = {240, 240},
                           .options = options,
                           .color = color_of_pixel});
}
