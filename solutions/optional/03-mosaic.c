// 03-mosaic.c - a picture as a mosaic: every tile has one color.
//
// Optional, after chapter 03. After each change: make optional TASK=mosaic
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

static double side = 8;

// The middle of the tile that contains a point of the screen. Tiles are squares with this side, in
// rows from the top, like bricks in a wall: in the first row, and then in every second row, tiles
// begin at x = 0; in the rows between, they begin half a side further to the left.
static ScreenPoint tile_middle(ScreenPoint point)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(ScreenPoint);
    double row = floor(point.y / side);
    double shift = fmod(row, 2) == 0 ? 0 : side / 2;
    double column = floor((point.x + shift) / side);
    return (ScreenPoint){(column + 0.5) * side - shift, (row + 0.5) * side};
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Normalized place = screen_to_normalized(tile_middle(pixel_center(pixel)), drawing->image.size);
    vec3 v = image_plane_vector(drawing->camera, place.s, place.t);
    return room_color((Ray){drawing->camera.origin, v});
}

int main(int argc, char **argv)
{
    const Option options[] = {{"side", 'a', "PIXELS", option_number, &side, "of a tile (8)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room as a mosaic.",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
