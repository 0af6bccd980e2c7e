// 02-orbit.c - a camera that moves once around a place: twelve pictures of a film.
//
// Optional, after chapter 02. After each change: make optional TASK=orbit
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"

static const vec3 middle_of_the_room = {0, 1.3, 0, 0};

// The look-at of a camera on a circle around the place 'at'. The circle is horizontal, by 'above'
// higher than that place, and has this radius. The eye starts behind the place, in the direction of
// -z from the middle of the circle. After a quarter of a turn it is in the direction of +x, and
// after half a turn in the direction of +z. It always looks at the place, and up is +y. The image
// plane has the aspect ratio 4 to 3 and is seen under 75 degrees: your width_from_angle says how
// wide it is.
static LookAt look_from_orbit(vec3 at, double radius, double above, double turns)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(LookAt);
    // END SOLUTION
}

enum { ACROSS = 4, DOWN = 3 };

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    int width = drawing->image.size.width / ACROSS, height = drawing->image.size.height / DOWN;
    int column = pixel.column / width, row = pixel.row / height;
    int x = pixel.column % width, y = pixel.row % height;
    if (column >= ACROSS || row >= DOWN || x == 0 || y == 0)
        return vec3_of(0.1, 0.1, 0.1);
    double turns = (column + ACROSS * row) / (double)(ACROSS * DOWN);
    LookAt view = look_from_orbit(middle_of_the_room, 3.4, 0.6, turns);
    Camera camera;
    if (camera_from_look_at(view, LEFT_HANDED, &camera) != CAMERA_OK)
        return vec3_of(0, 0, 0);
    vec3 v = image_plane_vector(camera, (x + 0.5) / width, 1 - (y + 0.5) / height);
    return room_color((Ray){camera.origin, v});
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws twelve views of a room, from a circle.",
                           .size = {320, 180},
                           .color = color_of_pixel});
}
