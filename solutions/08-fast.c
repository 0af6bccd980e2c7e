// 08-fast.c - exercise 08: where a sphere is on the screen.
//
// Write your answer between BEGIN SOLUTION and END SOLUTION. Helper functions may go anywhere.
// Questions and rules: exercises/08-fast.h. The lesson: chapters/08-fast/README.md.
// After each change:   make exercises EX=08
#include "exercises/08-fast.h"

#include "common/answers.h"
#include "exercises/03-screen.h"

// BEGIN SOLUTION
// The two ends of an outline, on a plane at distance 1.
typedef struct {
    double low, high;
} Span;

// Seen along the other axis, two lines through the eye touch a circle around (ahead, aside). They
// are the roots m of g m^2 - 2 ahead aside m + aside^2 - r^2 = 0, with g = ahead^2 - r^2 > 0.
static Span outline(double ahead, double aside, double r)
{
    double g = (ahead - r) * (ahead + r);
    double middle = ahead * aside / g, half = r * sqrt(aside * aside + g) / g;
    return (Span){middle - half, middle + half};
}

static double between_0_and(double most, double x)
{
    return fmin(fmax(x, 0), most);
}
// END SOLUTION

ScreenRectangle sphere_rectangle(Camera camera, Resolution screen, Sphere sphere)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(ScreenRectangle);
    const ScreenRectangle nothing = {0, 0, 0, 0}, all = {0, screen.width, 0, screen.height};
    vec3 c = sphere.center - camera.origin;
    double ahead = vec3_dot(c, camera.forward), r = sphere.radius;
    if (ahead <= -r)
        return nothing;
    if (ahead <= r)
        return all;
    Span x = outline(ahead, vec3_dot(c, camera.right), r);
    Span y = outline(ahead, vec3_dot(c, camera.up), r);
    // From the plane at distance 1 to the image plane, to normalized places, to the screen.
    double across = camera.distance / camera.width, up = camera.distance / camera.height;
    Normalized upper_left = {0.5 + across * x.low, 0.5 + up * y.high};
    Normalized lower_right = {0.5 + across * x.high, 0.5 + up * y.low};
    ScreenPoint first = normalized_to_screen(upper_left, screen);
    ScreenPoint last = normalized_to_screen(lower_right, screen);
    if (last.x <= 0 || first.x >= screen.width || last.y <= 0 || first.y >= screen.height)
        return nothing;
    return (ScreenRectangle){
        between_0_and(screen.width, first.x), between_0_and(screen.width, last.x),
        between_0_and(screen.height, first.y), between_0_and(screen.height, last.y)};
    // END SOLUTION
}
