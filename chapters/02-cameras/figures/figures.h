// figures.h - the figures of chapter 02.
#ifndef CHAPTERS_02_CAMERAS_FIGURES_FIGURES_H
#define CHAPTERS_02_CAMERAS_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"

// What they show: a camera; the up vector of a look-at, or the camera's own; and the up that the
// figure look-at begins with, or NaN.
typedef struct {
    Camera camera;
    vec3 up, lean;
} Given;

extern const Figure camera_figures[];

#endif
