// figures.h - the figures of chapter 01.
#ifndef CHAPTERS_01_CORNERS_FIGURES_FIGURES_H
#define CHAPTERS_01_CORNERS_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"

// What they show: a camera, a place on its image plane, and an answer to draw beside the right one
// (NaN: none).
typedef struct {
    Camera camera;
    double s, t;
    vec3 yours;
} View;

extern const Figure corner_figures[];

#endif
