// 01-corners.c - exercise 01: from the eye to the image plane.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/01-corners.h. The lesson: chapters/01-corners/README.md.
// After each change:   make exercises EX=01
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

vec3 upper_right(Camera c)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

vec3 across_30_up_10(Camera c)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(vec3);
    // END SOLUTION
}

Camera with_unit_distance(Camera c)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Camera);
    // END SOLUTION
}
