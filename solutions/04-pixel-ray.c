// 04-pixel-ray.c - exercise 04: the ray of a pixel.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/04-pixel-ray.h. The lesson: chapters/04-pixel-ray/README.md.
// After each change:   make exercises EX=04
#include "exercises/04-pixel-ray.h"

#include "common/answers.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"

// BEGIN SOLUTION
// From the pixel to its center, to (s, t), to the vector from the eye: chapter 03, then chapter 01.
// END SOLUTION

Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Ray);
    Normalized place = screen_to_normalized(pixel_center(pixel), screen);
    return (Ray){camera.origin, image_plane_vector(camera, place.s, place.t)};
    // END SOLUTION
}
