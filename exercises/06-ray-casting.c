// 06-ray-casting.c - exercise 06: the picture.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/06-ray-casting.h. The lesson: chapters/06-ray-casting/README.md.
// After each change:   make exercises EX=06
#include "exercises/06-ray-casting.h"

#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

Hit nearest_hit(Ray ray, const Scene *scene)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Hit);
    // END SOLUTION
}

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    // BEGIN SOLUTION
    NOT_ANSWERED_YET();
    // END SOLUTION
}

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    // BEGIN SOLUTION
    NOT_ANSWERED_YET();
    // END SOLUTION
}
