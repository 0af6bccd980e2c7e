// 08-fast.c - exercise 08: where a sphere is on the screen.
//
// Write your answer between BEGIN SOLUTION and END SOLUTION. Helper functions may go anywhere.
// Questions and rules: exercises/08-fast.h. The lesson: chapters/08-fast/README.md.
// After each change:   make exercises EX=08
#include "exercises/08-fast.h"

#include "common/answers.h"
#include "exercises/03-screen.h"

ScreenRectangle sphere_rectangle(Camera camera, Resolution screen, Sphere sphere)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(ScreenRectangle);
    // END SOLUTION
}
