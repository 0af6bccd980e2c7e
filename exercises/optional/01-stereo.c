// 01-stereo.c - a picture for two eyes, to look at through red and cyan glasses.
//
// Optional, after chapter 01. After each change: make optional TASK=stereo
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/01-corners.h"

static double apart = 0.12;

// Both eyes look through the same image plane, like two people at one window. The ray of an eye
// starts beside the camera's origin: 'aside' to the right of it, or to the left if aside is
// negative. It goes through the place (s, t) of the image plane of the camera c, where your
// image_plane_vector finds it.
static Ray eye_ray(Camera c, double s, double t, double aside)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Ray);
    // END SOLUTION
}

static double brightness(Color color)
{
    return 0.3 * color[0] + 0.6 * color[1] + 0.1 * color[2];
}

// The red glass, on the left, lets only red through; the cyan one green and blue.
static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Resolution size = drawing->image.size;
    double s = (pixel.column + 0.5) / size.width, t = 1 - (pixel.row + 0.5) / size.height;
    double left = brightness(room_color(eye_ray(drawing->camera, s, t, -apart / 2)));
    double right = brightness(room_color(eye_ray(drawing->camera, s, t, apart / 2)));
    return vec3_of(left, right, right);
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"apart", 'a', "DISTANCE", option_number, &apart, "between the eyes (0.12)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room for red and cyan glasses.",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
