// camera_drawing.h - the camera as a figure shows it: its eye, its image plane, its pixels.
#ifndef CHAPTERS_SHARED_CAMERA_DRAWING_H
#define CHAPTERS_SHARED_CAMERA_DRAWING_H

#include "common/camera.h"
#include "common/figure/plot.h"

// $eye, $plane (the outline), $grid (the lines between columns x rows pixels; none for 1 x 1),
// d, w, h, and the frame right, up, forward, from whose right side the figure is seen.
void plane_data(Plot *plot, Camera camera, int columns, int rows);

// $NAME, the outline of a camera's image plane. The figure makes room for it.
void plane_outline(Plot *plot, const char *name, Camera camera);

// The same as rows of a block that has begun.
void plane_rows(Plot *plot, Camera camera);

// Handles for the options of a camera (CAMERA_OPTIONS): the eye, and the image plane by its upper
// right corner and by its middle.
void camera_handles(Plot *plot, Camera camera);

#endif
