// 07-fog.c - fog, in which things fade with their distance.
//
// Optional, after chapter 07. After each change: make optional TASK=fog
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

static double half_distance = 14;

// Returns the color that the eye sees if light of this color goes this length through the fog.
// After each 'half_distance', half of the light that is left is lost, and fog replaces it.
static Color seen_through_fog(Color color, Color fog, double length)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Color);
    // END SOLUTION
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    const Scene *scene = &drawing->scene;
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    double length = hit.t * vec3_length(ray.direction);
    return clamp_color(seen_through_fog(trace_ray(scene, ray, 2), scene->background, length));
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"half", 'd', "LENGTH", option_number, &half_distance, "after which half is lost (14)"},
        {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a row of columns in fog.",
                           .scene = "exercises/optional/columns.nff",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
