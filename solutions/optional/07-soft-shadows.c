// 07-soft-shadows.c - a light with a size, whose shadows have soft edges.
//
// Optional, after chapter 07. After each change: make optional TASK=soft-shadows
#include "chapters/shared/render.h"
#include "chapters/shared/task.h"
#include "common/answers.h"

#include <stdlib.h>

static double width = 5;
static int cells = 6;

// Divides a square light into cells x cells point lights, which together are as bright as the
// light. The square has the width 'width' and its middle at light.position, and its edges are along
// x and z. Divide it into equal square cells: each part is in the middle of one cell. Any order of
// the parts is right.
static void divide_light(Light light, Light *parts)
{
    // BEGIN SOLUTION
    //~ (void)light, (void)parts;
    //~ NOT_ANSWERED_YET();
    for (int i = 0; i < cells * cells; i++) {
        int column = i % cells, row = i / cells;
        double x = ((column + 0.5) / cells - 0.5) * width;
        double z = ((row + 0.5) / cells - 0.5) * width;
        parts[i] = light;
        parts[i].position += vec3_of(x, 0, z);
        parts[i].color /= cells * cells;
    }
    // END SOLUTION
}

// Your chapter 07 draws the scene with all these lights.
static void draw(Drawing *drawing)
{
    Scene *scene = &drawing->scene;
    int count = cells * cells;
    Light *parts = calloc((size_t)(count * scene->light_count) + 1, sizeof *parts);
    if (parts == NULL)
        return;
    for (int i = 0; i < scene->light_count; i++)
        divide_light(scene->lights[i], parts + i * count);
    free(scene->lights);
    scene->lights = parts;
    scene->light_count *= count;
    if (answers_missing() == 0)
        render(scene, drawing->camera, (Style){.samples = 1, .depth = 0, .gamma = 1},
               &drawing->image);
}

static bool option_cells(const char *text, void *into)
{
    return option_whole(text, 1, 16, into);
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"width", 'w', "WIDTH", option_number, &width, "how wide the light is (5)"},
        {"cells", 'n', "N", option_cells, &cells, "N x N point lights, 1 to 16 (6)"},
        {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws spheres with soft shadows.",
                           .scene = "exercises/optional/table.nff",
                           .size = {256, 160},
                           .options = options,
                           .draw = draw});
}
