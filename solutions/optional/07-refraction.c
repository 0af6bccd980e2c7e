// 07-refraction.c - a ball of glass, which bends light.
//
// Optional, after chapter 07. After each change: make optional TASK=refraction
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

static double glass = 1.5;

// The direction in which light goes on when it passes from one material to another (Snell's law):
// sin(angle before) = ratio sin(angle after), with both angles from the line of the normal. The
// result is a unit vector in the plane of the direction and the normal. If there is no such
// direction, all light is reflected: return what your mirror_direction says. direction and normal
// are unit. The normal points to the side from which the light comes.
static vec3 refracted_direction(vec3 direction, vec3 normal, double ratio)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    double before = -vec3_dot(direction, normal);
    double after_squared = 1 - (1 - before * before) / (ratio * ratio);
    if (after_squared < 0)
        return mirror_direction(direction, normal);
    return direction / ratio + (before / ratio - sqrt(after_squared)) * normal;
    // END SOLUTION
}

// A ray that has hit the ball, as it leaves the ball on the other side.
static Ray through_glass(Sphere ball, Ray ray, double t)
{
    vec3 in = ray.origin + t * ray.direction, normal = surface_normal(ball, in);
    Ray inside = {offset_from_surface(ball, in, -normal),
                  refracted_direction(vec3_unit(ray.direction), normal, glass)};
    vec3 out = inside.origin + hit_sphere(inside, ball) * inside.direction;
    normal = surface_normal(ball, out);
    return (Ray){offset_from_surface(ball, out, normal),
                 refracted_direction(inside.direction, -normal, 1 / glass)};
}

// The first sphere of the scene is of glass. Its shadow is that of any other sphere.
static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    const Scene *scene = &drawing->scene;
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere != 0)
        return clamp_color(trace_ray(scene, ray, 2));
    Color behind = trace_ray(scene, through_glass(scene->spheres[0], ray, hit.t), 2);
    return clamp_color(0.92 * behind + vec3_of(0.04, 0.05, 0.05));
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"glass", 'g', "N", option_number, &glass, "the index of refraction (1.5)"}, {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a ball of glass.",
                           .scene = "exercises/optional/glass.nff",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
