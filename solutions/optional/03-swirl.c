// 03-swirl.c - a picture that is stirred like coffee.
//
// Optional, after chapter 03. After each change: make optional TASK=swirl
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

static double turns = 0.5;

// Which place of the picture is seen at this place, after stirring. Both are normalized. Let d be
// the distance of the place from the middle (0.5, 0.5). From 0.5 on nothing moves. Nearer to the
// middle the place is turned around the middle, counterclockwise (from the direction of s to the
// direction of t), by 'turns' times (1 - d / 0.5)^2 whole turns.
static Normalized stirred(Normalized place)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Normalized);
    double s = place.s - 0.5, t = place.t - 0.5, left = fmax(1 - hypot(s, t) / 0.5, 0);
    double angle = 2 * PI * turns * left * left;
    return (Normalized){0.5 + cos(angle) * s - sin(angle) * t,
                        0.5 + sin(angle) * s + cos(angle) * t};
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Normalized place = stirred(screen_to_normalized(pixel_center(pixel), drawing->image.size));
    vec3 v = image_plane_vector(drawing->camera, place.s, place.t);
    return room_color((Ray){drawing->camera.origin, v});
}

int main(int argc, char **argv)
{
    const Option options[] = {{"turns", 't', "N", option_number, &turns, "of the middle (0.5)"},
                              {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room, stirred.",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
