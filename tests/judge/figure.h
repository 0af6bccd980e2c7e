// figure.h - a wrong answer beside the right one, as numbers for a layout (figure.c), or as
// pictures (picture_panels.c).
//
// For a function whose test failed, FOLDER/FUNCTION.gp is a script for gnuplot
// (common/figure/plot.h), or FOLDER/FUNCTION.png a picture; neither if there is nothing to draw: no
// answer, one that is not finite or far beyond what can be shown beside the right one, or hidden
// inputs.
#ifndef TESTS_JUDGE_FIGURE_H
#define TESTS_JUDGE_FIGURE_H

#include "common/image.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

// Removes the figure of an older answer.
void figure_forget(const char *folder, const char *function);

// yours: the answer at which the test stopped, or NULL.
void figure_write(const char *folder, const Record *record, const Numbers *yours,
                  Diagnosis diagnosis);

// ---- two pictures of one size, and where they differ -------------------------------------------

// The largest difference between two bytes of one pixel, which is given by its number.
int picture_bytes_apart(const Image *yours, const Image *right, size_t pixel);

// Writes a PNG with both pictures and their difference, side by side. Pixels whose bytes differ by
// at most 'alike' count as alike. False if it could not be written.
bool picture_panels_write(const Image *yours, const Image *right, int alike, const char *path);

#endif
