// 05-bite.c - a ball with a bite: one sphere cut out of another.
//
// Optional, after chapter 05. After each change: make optional TASK=bite
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "common/ray.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

static vec3 bite_at = {1.5, 0.9, 3.2, 0};

// The smallest t > 0 at which the ray meets what is left of the ball when all that is inside the
// sphere 'bite' is removed, or NO_HIT. The ray starts outside of both. Your sphere_roots says
// between which t a line is inside a sphere.
static double hit_bitten(Ray ray, Sphere ball, Sphere bite)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    Roots in_ball = sphere_roots(ray, ball), in_bite = sphere_roots(ray, bite);
    if (in_ball.count == 0 || in_ball.t[0] <= 0)
        return NO_HIT;
    double t = in_ball.t[0];
    if (in_bite.count > 0 && in_bite.t[0] <= t && t < in_bite.t[1])
        t = in_bite.t[1];
    return t < in_ball.t[1] ? t : NO_HIT;
    // END SOLUTION
}

// Red skin, and pale where it is bitten; lighter where it faces up and towards the eye.
static Color color_at(vec3 point, Sphere ball, Sphere bite)
{
    bool skin = vec3_length(point - ball.center) > 0.999 * ball.radius;
    vec3 normal = skin ? point - ball.center : bite.center - point;
    normal = vec3_unit(normal);
    Color color = skin ? vec3_of(0.85, 0.2, 0.15) : vec3_of(0.98, 0.93, 0.75);
    return fmax(0.55 + 0.25 * normal[1] + 0.2 * normal[2], 0) * color;
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    Sphere ball = drawing->scene.spheres[0], bite = {ball.center + bite_at, 0.75 * ball.radius, 0};
    double t = hit_bitten(ray, ball, bite);
    return t < NO_HIT ? color_at(ray.origin + t * ray.direction, ball, bite)
                      : drawing->scene.background;
}

int main(int argc, char **argv)
{
    const Option options[] = {
        {"bite", 'b', "X,Y,Z", option_vec3, &bite_at, "from the middle of the ball (1.5,0.9,3.2)"},
        {0}};
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a ball with a bite.",
                           .scene = "exercises/optional/ball.nff",
                           .size = {256, 160},
                           .options = options,
                           .color = color_of_pixel});
}
