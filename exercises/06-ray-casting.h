// 06-ray-casting.h - exercise 06: the picture.
//
// Slides 'Ray casting process' and 'Two ways of rendering a picture'. These functions call your
// answers of 04 and 05. Colors are flat: a sphere has the color of its surface (scene_surface in
// scene.h).
// Tolerance: none. Both orders give the same bytes. Worlds have any size and any number of spheres.
// Images have any shape, for example one pixel wide.
//
// From common/image.h, for both orders:
//   image_set(image, pixel, color);   colors one pixel of an Image *. The pixel is a Pixel, so
//                                     {column, row}, counted from 0 at the upper left. If the pixel
//                                     is outside the image, the program ends with a message.
//   image_index(image, pixel)         returns the number of this pixel, counted from 0, row by row
//                                     from the top: depth[image_index(image, pixel)] is its depth.
//                                     It does not check: for a pixel outside, the number is wrong.
#ifndef EXERCISES_06_RAY_CASTING_H
#define EXERCISES_06_RAY_CASTING_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"

// "Find the closest in front of the camera that intersects the ray." Returns the smallest t > 0 and
// the index of its sphere. If two t are equal, the lower index wins. If no sphere is hit, it
// returns NO_HIT and -1.
Hit nearest_hit(Ray ray, const Scene *scene);

// Image order: for each pixel on the screen, find the object that colors it. Sets every pixel of
// the image. If the ray of a pixel hits nothing, the pixel has the color of the scene's
// background.
void cast_image_order(const Scene *scene, Camera camera, Image *image);

// Object order: for each object, find the pixels that it colors. The two loops are swapped.
// depth has room for one t per pixel, row by row from the top. Before the call it may contain
// anything; after the call it contains the t of the nearest hit, or NO_HIT.
void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth);

#endif
