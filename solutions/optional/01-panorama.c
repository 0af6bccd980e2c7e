// 01-panorama.c - a panorama, which shows everything around the camera.
//
// Optional, after chapter 01. After each change: make optional TASK=panorama
#include "chapters/shared/task.h"
#include "common/answers.h"

// The picture is a map of all directions, as a map of the world is one of all places on a globe.
// From the left edge to the right edge it is one whole turn to the right around the axis c.up. From
// the bottom to the top it is half a turn, from straight down to straight up. The middle is
// forward.
//
// across: from 0, the left edge, to 1, the right edge. above: from -1, the bottom, to 1, the top.
// Returns the direction, of any length.
static vec3 panorama_direction(Camera c, double across, double above)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    double turn = 2 * PI * (across - 0.5), rise = PI / 2 * above;
    vec3 level = cos(turn) * c.forward + sin(turn) * c.right;
    return cos(rise) * level + sin(rise) * c.up;
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Resolution size = drawing->image.size;
    double across = (pixel.column + 0.5) / size.width;
    double above = 1 - 2 * (pixel.row + 0.5) / size.height;
    Camera c = drawing->camera;
    c.origin = vec3_of(0, 1.6, 0);
    return room_color((Ray){c.origin, panorama_direction(c, across, above)});
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room as a panorama.",
                           .size = {320, 160},
                           .color = color_of_pixel});
}
