// outline.h - the outline of a sphere on the image plane, and the lines from it to the eye: object
// order, as figures and animations show it.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_OUTLINE_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_OUTLINE_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/sphere.h"

// $NAME: the places where the lines cross the image plane, all around the sphere.
void outline_on_plane(Plot *plot, const char *name, Camera camera, Sphere sphere);

// $LINES: some of the lines as rows of places, because hidden parts are left out. $HEADS: their
// arrowheads, half way to the plane. If the sphere is not drawn, the lines end beyond the plane.
void lines_to_eye(Plot *plot, const char *lines, const char *heads, Camera camera, Sphere sphere,
                  bool drawn);

#endif
