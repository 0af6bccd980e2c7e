// 06-outlines.c - a picture as in a comic: flat colors with black outlines.
//
// Optional, after chapter 06. After each change: make optional TASK=outlines
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

// Whether a pixel is on an outline: another sphere, or none, is seen at one of the pixels that are
// at most two columns and at most two rows away from it. Pixels outside of the picture do not
// count. spheres has one number for each pixel, row by row from the top: the index of the sphere,
// or -1.
static bool is_on_outline(const int *spheres, Resolution size, Pixel pixel)
{
    // BEGIN SOLUTION
    //~ (void)spheres, (void)size, (void)pixel;
    //~ NOT_ANSWERED_YET();
    //~ return false;
    int here = spheres[pixel.row * size.width + pixel.column];
    for (int row = pixel.row - 2; row <= pixel.row + 2; row++)
        for (int column = pixel.column - 2; column <= pixel.column + 2; column++)
            if (row >= 0 && row < size.height && column >= 0 && column < size.width &&
                spheres[row * size.width + column] != here)
                return true;
    return false;
    // END SOLUTION
}

static void find_spheres(const Drawing *drawing, int *spheres)
{
    Resolution size = drawing->image.size;
    for (int i = 0; i < size.width * size.height; i++) {
        Ray ray = pixel_ray(drawing->camera, size, (Pixel){i % size.width, i / size.width});
        spheres[i] = nearest_hit(ray, &drawing->scene).sphere;
    }
}

static void draw(Drawing *drawing)
{
    const Scene *scene = &drawing->scene;
    Resolution size = drawing->image.size;
    int count = size.width * size.height;
    int *spheres = malloc(sizeof *spheres * (size_t)count);
    if (spheres == NULL)
        return;
    find_spheres(drawing, spheres);
    for (int i = 0; i < count; i++) {
        Pixel pixel = {i % size.width, i / size.width};
        Color color = spheres[i] < 0 || spheres[i] >= scene->sphere_count
                          ? scene->background
                          : scene_surface(scene, spheres[i])->color;
        if (is_on_outline(spheres, size, pixel))
            color = vec3_of(0.05, 0.05, 0.1);
        image_set(&drawing->image, pixel, color);
    }
    free(spheres);
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a scene with black outlines.",
                           .scene = "exercises/optional/marbles.nff",
                           .size = {256, 160},
                           .draw = draw});
}
