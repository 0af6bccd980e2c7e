// beside.h - data of a figure that shows a wrong answer beside the right one.
//
// Their layouts draw $answer and $yours, and write answer_text, yours_text and off_text down
// ('@beside' in plot.gp).
#ifndef COMMON_FIGURE_BESIDE_H
#define COMMON_FIGURE_BESIDE_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/text.h"

// $answer (what is right), $yours, and $off from tip to tip; all of it has to be seen.
void beside_vectors(Plot *plot, vec3 right_from, vec3 right, vec3 yours_from, vec3 yours);

// answer_text, yours_text, off_text; minus signs for hyphens.
void beside_words(Plot *plot, const char *right, const char *yours, const char *off);

// off by (1, 1, 0) = 1/2 w r + 1/2 h u: in the camera's own steps, where those are simple
// fractions.
Text beside_off(Camera camera, vec3 off);

#endif
