// 01-corners.c - exercise 01: from the eye to the image plane.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/01-corners.h. The lesson: chapters/01-corners/README.md.
// After each change:   make exercises EX=01
#include "exercises/01-corners.h"

#include "common/answers.h"

// BEGIN SOLUTION
// From the eye forward to the middle of the plane, then sideways along right, then along up.
// END SOLUTION

vec3 upper_left(Camera c)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    // END SOLUTION
}

vec3 upper_right(Camera c)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
    // END SOLUTION
}

vec3 across_30_up_10(Camera c)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return image_plane_vector(c, 0.3, 0.1);
    // END SOLUTION
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
    // END SOLUTION
}

Camera with_unit_distance(Camera c)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Camera);
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance = 1;
    return c;
    // END SOLUTION
}
