// example.c - the numbers of chapters/example.h as values. No other file includes it, so little is
// compiled when they change.
#include "chapters/shared/example.h"

#include "chapters/example.h"

static const double place[] = {EXAMPLE_PLACE};
static const int screen[] = {EXAMPLE_SCREEN}, point[] = {EXAMPLE_POINT};

_Static_assert(sizeof place == 2 * sizeof *place, "EXAMPLE_PLACE: expected two numbers");
_Static_assert(sizeof screen == 2 * sizeof *screen, "EXAMPLE_SCREEN: expected two whole numbers");
_Static_assert(sizeof point == 2 * sizeof *point, "EXAMPLE_POINT: expected two whole numbers");

Camera example_camera(void)
{
    return (Camera){.origin = vec3_of(EXAMPLE_EYE),
                    .right = vec3_of(EXAMPLE_RIGHT),
                    .up = vec3_of(EXAMPLE_UP),
                    .forward = vec3_of(EXAMPLE_FORWARD),
                    .distance = EXAMPLE_DISTANCE,
                    .width = EXAMPLE_WIDTH,
                    .height = EXAMPLE_HEIGHT};
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
