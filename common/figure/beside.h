// beside.h - data of a figure that shows a wrong answer beside the right one.
//
// Their layouts draw $answer and $yours. What is right is blue, yours is ink and dashed.
// answer_text, yours_text and off_text are also in the figure's description (beside_words in
// plot.gp).
#ifndef COMMON_FIGURE_BESIDE_H
#define COMMON_FIGURE_BESIDE_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/text.h"

// $answer (what is right), $yours, and $off from tip to tip; all of it has to be seen.
void beside_vectors(Plot *plot, vec3 right_from, vec3 right, vec3 yours_from, vec3 yours);

// What is right, what is yours, and by how much it is off ("" if nobody can say). drawn: how yours
// is, 'dashed' or 'as a ring'; "" if it is not.
typedef struct {
    const char *right, *yours, *off, *drawn;
} BesideWords;

// answer_text, yours_text, off_text and drawn.
void beside_words(Plot *plot, BesideWords words);

// A figure of the judge: which function it is about, those words, and why yours is wrong. They are
// below the canvas, because they may be long.
void beside_below(Plot *plot, const char *asked, const char *why, BesideWords words);

// 'expected' and 'yours' beside the two arrows.
void beside_names(Plot *plot);

// off by (1, 1, 0) = ½ w r + ½ h u: in the camera's own steps, where those are simple
// fractions.
Text beside_off(Camera camera, vec3 off);

#endif
