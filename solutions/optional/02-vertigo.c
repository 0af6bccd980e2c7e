// 02-vertigo.c - a camera that moves away while its lens zooms in, as in Hitchcock's film
// 'Vertigo'.
//
// Optional, after chapter 02. After each change: make optional TASK=vertigo
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

// The angle, in degrees, under which a thing of this width is seen from this distance in front of
// its middle. It undoes your width_from_angle: the width from this angle and distance is 'width'
// again.
static double angle_from_width(double width, double distance)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    return 2 * atan(width / 2 / distance) * 180 / PI;
    // END SOLUTION
}

enum { PICTURES = 4 };

// From left to right the camera is farther away. The painting at the end of the room always fills
// the same part of the picture.
static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    int width = drawing->image.size.width / PICTURES, height = drawing->image.size.height;
    int x = pixel.column % width, number = pixel.column / width;
    if (number >= PICTURES || x == 0)
        return vec3_of(0.1, 0.1, 0.1);
    static const double distances[PICTURES] = {2.2, 3.5, 6, 11.5};
    vec3 painting = vec3_of(0, 1.9, 6);
    double distance = distances[number], degrees = angle_from_width(5, distance);
    LookAt view = {painting - vec3_of(0, 0, distance), painting, vec3_of(0, 1, 0),
                   width_from_angle(degrees, distance), (double)width / height};
    Camera camera;
    if (camera_from_look_at(view, LEFT_HANDED, &camera) != CAMERA_OK)
        return vec3_of(0, 0, 0);
    vec3 v = image_plane_vector(camera, (x + 0.5) / width, 1 - (pixel.row + 0.5) / height);
    return room_color((Ray){camera.origin, v});
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a painting from four distances, always as wide.",
                           .size = {400, 120},
                           .color = color_of_pixel});
}
