// 04-smooth.c - several rays for each pixel, so that edges have no steps (anti-aliasing).
//
// Optional, after chapter 04. After each change: make optional TASK=smooth
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"

static int cells = 4;

// A pixel is divided into cells x cells equal cells. The ray through the middle of one of them:
// column and row of the cell are counted in its pixel, from 0, from its upper left.
static Ray cell_ray(Camera camera, Resolution screen, Pixel pixel, int column, int row)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Ray);
    Resolution fine = {screen.width * cells, screen.height * cells};
    return pixel_ray(camera, fine, (Pixel){pixel.column * cells + column, pixel.row * cells + row});
    // END SOLUTION
}

// The average of all cells. The left half has one ray for each pixel, to compare with.
static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Resolution size = drawing->image.size;
    Camera c = drawing->camera;
    if (pixel.column < size.width / 2)
        return room_color(pixel_ray(c, size, pixel));
    Color sum = vec3_of(0, 0, 0);
    for (int i = 0; i < cells * cells; i++)
        sum += room_color(cell_ray(c, size, pixel, i % cells, i / cells));
    return sum / (cells * cells);
}

static bool option_cells(const char *text, void *into)
{
    return option_whole(text, 1, 64, into);
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"cells", 'n', "N", option_cells, &cells, "N x N rays for each pixel, 1 to 64 (4)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a room, its right half without steps.",
                           .size = {192, 120},
                           .options = options,
                           .color = color_of_pixel});
}
