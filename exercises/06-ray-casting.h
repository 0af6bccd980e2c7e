// 06-ray-casting.h - exercise 06: the picture.
//
// Slides 'Ray casting process' and 'Two ways of rendering a picture'. Made of the answers of 04
// and 05. Colours are flat: what a sphere's surface says (scene_surface in scene.h).
// Tolerance: none. Both orders give the same bytes. Worlds are of any size and have any number of
// spheres; images are of any shape, also one pixel wide.
//
// From common/image.h, for both orders:
//   image_set(image, pixel, color);   colours one pixel of an Image *. The pixel is a Pixel, so
//                                     {column, row}, counted from 0 at the upper left. A pixel
//                                     outside the image ends the program with a message.
//   image_index(image, pixel)         the number of this pixel, from 0, counted row by row from the
//                                     top: depth[image_index(image, pixel)] is its depth. It does
//                                     not check: a pixel outside gives a wrong number.
#ifndef EXERCISES_06_RAY_CASTING_H
#define EXERCISES_06_RAY_CASTING_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"

// "Find the closest in front of the camera that intersects the ray." The smallest t > 0 and the
// index of its sphere; of equals, the lower index. None: NO_HIT and -1.
Hit nearest_hit(Ray ray, const Scene *scene);

// Image order: for each pixel on the screen, find the object that colours it. Sets every pixel
// of the image, to the scene's background where nothing is hit.
void cast_image_order(const Scene *scene, Camera camera, Image *image);

// Object order: for each object, find the pixels that it colours; the two loops exchanged. depth
// has room for one t per pixel, row by row from the top; what is in it does not matter before,
// afterwards it holds the t of the nearest hit, or NO_HIT.
void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth);

#endif
