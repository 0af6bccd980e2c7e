// example.h - the example that the whole lecture uses, with the numbers of chapters/example.h.
#ifndef CHAPTERS_SHARED_EXAMPLE_H
#define CHAPTERS_SHARED_EXAMPLE_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/screen.h"
#include "common/sphere.h"

// The file that has its numbers.
const char *example_file(void);

Camera example_camera(void);
Normalized example_place(void); // on its image plane

Resolution example_screen(void);
// That screen, or a coarser one of its shape, with at most 640 x 480 pixels: for pictures.
Resolution example_small_screen(void);
ScreenPoint example_point(void);
Pixel example_pixel(void); // with the numbers of that point

Ray example_ray(void);
Sphere example_sphere(void);

#endif
