// example.c - the numbers of chapters/example.h as values. No other file includes it, so little is
// compiled when they change.
#include "chapters/shared/example.h"

#include "chapters/example.h"

// chapters/examples/NAME.txt comes before this file (read_example.py).
#ifndef EXAMPLE_FILE
#define EXAMPLE_FILE "chapters/example.h"
#endif

static const double place[] = {EXAMPLE_PLACE};
static const int screen[] = {EXAMPLE_SCREEN}, point[] = {EXAMPLE_POINT};

_Static_assert(sizeof place == 2 * sizeof *place, "EXAMPLE_PLACE: expected two numbers");
_Static_assert(sizeof screen == 2 * sizeof *screen, "EXAMPLE_SCREEN: expected two whole numbers");
_Static_assert(sizeof point == 2 * sizeof *point, "EXAMPLE_POINT: expected two whole numbers");

const char *example_file(void)
{
    return EXAMPLE_FILE;
}

// How far lengths are from 1, and angles from right ones.
static double frame_error(const Camera *c)
{
    const double errors[] = {vec3_length(c->right) - 1,   vec3_length(c->up) - 1,
                             vec3_length(c->forward) - 1, vec3_dot(c->right, c->up),
                             vec3_dot(c->up, c->forward), vec3_dot(c->forward, c->right)};
    double most = 0;
    for (int i = 0; i < 6; i++)
        most = fmax(most, fabs(errors[i]));
    return most;
}

// Nearly a frame, as 0.707107 is nearly the root of 1/2: then exactly one. A frame but for rounding
// stays, and so does anything else, which is refused (check_example.c).
static void straighten(Camera *c)
{
    double error = frame_error(c);
    if (error <= CAMERA_TOLERANCE || error > 1e-5)
        return;
    vec3 forward = vec3_unit(c->forward);
    vec3 right = vec3_unit(c->right - vec3_dot(c->right, forward) * forward);
    c->up = vec3_unit(c->up - vec3_dot(c->up, forward) * forward - vec3_dot(c->up, right) * right);
    c->right = right;
    c->forward = forward;
}

Camera example_camera(void)
{
    Camera camera = {.origin = vec3_of(EXAMPLE_EYE),
                     .right = vec3_of(EXAMPLE_RIGHT),
                     .up = vec3_of(EXAMPLE_UP),
                     .forward = vec3_of(EXAMPLE_FORWARD),
                     .distance = EXAMPLE_DISTANCE,
                     .width = EXAMPLE_WIDTH,
                     .height = EXAMPLE_HEIGHT};
    straighten(&camera);
    return camera;
}

Normalized example_place(void)
{
    return (Normalized){place[0], place[1]};
}

Resolution example_screen(void)
{
    return (Resolution){screen[0], screen[1]};
}

Resolution example_small_screen(void)
{
    int coarser = 1;
    while (screen[0] / coarser > 640 || screen[1] / coarser > 480)
        coarser++;
    return (Resolution){screen[0] / coarser, screen[1] / coarser};
}

ScreenPoint example_point(void)
{
    return (ScreenPoint){point[0], point[1]};
}

Pixel example_pixel(void)
{
    return (Pixel){point[0], point[1]};
}

Ray example_ray(void)
{
    return (Ray){vec3_of(EXAMPLE_RAY_ORIGIN), vec3_of(EXAMPLE_RAY_DIRECTION)};
}

Sphere example_sphere(void)
{
    return (Sphere){.center = vec3_of(EXAMPLE_CENTER), .radius = EXAMPLE_RADIUS};
}
