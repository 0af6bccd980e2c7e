// far_scenes.c - scenes that are extremely far from the eye, huge or tiny.
#include "tests/house/engines/scene_parts.h"

#include <stdio.h>

// Spheres in a heap, that many of their radii away, which fills the screen; the eye is anywhere.
void made_far(Made *made, unsigned number, double radii, double radius)
{
    made_begin(made, number * 104729ULL + 1);
    snprintf(made->name, sizeof made->name, "scene %u, %g radii of %g away", number, radii, radius);
    const double heap = once_in(2) ? 1.5 : 8;
    vec3 there = once_in(3) ? radii * radius * direction() : middle;
    vec3 eye = there + radii * radius * direction();
    // Not by an angle: in degrees it would lose its digits.
    look(eye, there, above, 1, (int)uniform(20, 50), (int)uniform(20, 50));
    made->camera.width = 4 * heap * radius;
    made->camera.height = made->camera.width * made->size.height / made->size.width;
    if (once_in(2)) { // the plane is near, as another angle would have it
        double nearer = 1 / radii;
        made->camera.distance *= nearer;
        made->camera.width *= nearer;
        made->camera.height *= nearer;
    }
    for (int i = (int)uniform(2, 40); i > 0; i--)
        add(there + heap * radius * within(1), radius * uniform(1, 1.5));
}
