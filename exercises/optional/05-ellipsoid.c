// 05-ellipsoid.c - a ball that is squeezed: a new shape from an old one.
//
// Optional, after chapter 05. After each change: make optional TASK=ellipsoid
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "common/ray.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

static vec3 radii = {3.2, 1.5, 2, 0};

// The smallest t > 0 at which the ray meets the ellipsoid, or NO_HIT. It has this center and the
// radius radii[0] along x, radii[1] along y and radii[2] along z. Your hit_sphere can find it: in a
// world whose lengths along each axis are divided by that radius, it is a sphere of radius 1.
static double hit_ellipsoid(Ray ray, vec3 center)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

// Rings of color, lighter where the surface faces up. A normal is squeezed the other way.
static Color color_at(vec3 point, vec3 middle)
{
    vec3 out = point - middle;
    for (int i = 0; i < 3; i++)
        out[i] /= radii[i];
    vec3 normal = out;
    for (int i = 0; i < 3; i++)
        normal[i] /= radii[i];
    normal = vec3_unit(normal);
    bool light = fmod(floor((out[0] + 1) * 5), 2) == 0;
    Color color = light ? vec3_of(0.95, 0.75, 0.3) : vec3_of(0.8, 0.35, 0.2);
    return (0.6 + 0.3 * normal[1] + 0.1 * normal[2]) * color;
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    vec3 center = drawing->scene.spheres[0].center;
    double t = hit_ellipsoid(ray, center);
    return t < NO_HIT ? color_at(ray.origin + t * ray.direction, center)
                      : drawing->scene.background;
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"radii", 'r', "X,Y,Z", option_vec3, &radii, "along the axes (3.2,1.5,2)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws an ellipsoid.",
                           .scene = "exercises/optional/ball.nff",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
