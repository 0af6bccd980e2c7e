// moments.h - what the animations of ray casting show at each of their moments.
//
// A moment is a step of the layout (common/figure/plot.gp): one script has the data of all of them.
// given is a Shown: the scene, the camera and one pixel.
#ifndef CHAPTERS_ANIMATIONS_MOMENTS_H
#define CHAPTERS_ANIMATIONS_MOMENTS_H

#include "common/figure/plot.h"

// The pixels of the picture, as the answer to cast_image_order sets them, each with its ray.
void image_order_moments(Plot *plot, void *given);

// The spheres as the answer to cast_object_order takes them, each with its outline and its pixels.
void object_order_moments(Plot *plot, void *given);

// One ray and one sphere after the other: the hit, and the closest hit so far.
void closest_hit_moments(Plot *plot, void *given);

#endif
