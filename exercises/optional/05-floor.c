// 05-floor.c - a plane with a checkered floor, below a ball.
//
// Optional, after chapter 05. After each change: make optional TASK=floor
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "common/ray.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

// The points p with normal . p = offset.
typedef struct {
    vec3 normal; // of any length but 0
    double offset;
} Plane;

static const Plane ground = {{0, 1, 0, 0}, -3};

// The t > 0 at which the ray meets the plane, or NO_HIT.
static double hit_plane(Ray ray, Plane plane)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

// The color of the floor at a point of it: squares of 2 x 2 in the axes x and z, with a corner at
// (0, -3, 0). The square from there towards positive x and z is light, and its neighbours are dark.
static Color checkered(vec3 point, Color light, Color dark)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

// Far away the squares are smaller than pixels, so the floor fades into the sky.
static Color floor_color(Ray ray, double t, Color sky)
{
    vec3 way = t * ray.direction;
    double clear = exp(-0.02 * vec3_length(way));
    Color color = checkered(ray.origin + way, vec3_of(0.95, 0.93, 0.88), vec3_of(0.2, 0.28, 0.36));
    return clear * color + (1 - clear) * sky;
}

// A beach ball: six stripes from pole to pole, lighter where they face up.
static Color ball_color(Sphere ball, vec3 point)
{
    vec3 out = (point - ball.center) / ball.radius;
    double along = out[0] * 0.8 + out[1] * 0.6, across = out[1] * 0.8 - out[0] * 0.6;
    static const Color stripes[] = {{0.9, 0.25, 0.2}, {0.97, 0.95, 0.9}, {0.2, 0.45, 0.8}};
    int stripe = (int)((atan2(across, out[2]) + PI) / (PI / 3)) % 3;
    Color color = fabs(along) > 0.95 ? stripes[1] : stripes[stripe];
    return (0.65 + 0.35 * out[1]) * color;
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    Ray ray = pixel_ray(drawing->camera, drawing->image.size, pixel);
    Sphere ball = drawing->scene.spheres[0];
    double ball_t = hit_sphere(ray, ball), ground_t = hit_plane(ray, ground);
    Color sky = drawing->scene.background;
    if (ball_t < ground_t)
        return ball_color(ball, ray.origin + ball_t * ray.direction);
    return ground_t < NO_HIT ? floor_color(ray, ground_t, sky) : sky;
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws a ball above a checkered floor.",
                           .scene = "exercises/optional/ball.nff",
                           .size = {256, 160},
                           .color = color_of_pixel});
}
