// figure.h - a wrong answer beside the right one, as numbers for a layout.
//
// For a function whose test failed, FOLDER/FUNCTION.gp is a script for gnuplot
// (common/figure/plot.h), or FOLDER/FUNCTION.png a picture; neither if there is nothing to draw: no
// answer, one that is not finite or far beyond what can be shown beside the right one, or hidden
// inputs.
#ifndef TESTS_JUDGE_FIGURE_H
#define TESTS_JUDGE_FIGURE_H

#include "common/figure/plot.h"
#include "tests/judge/process_transport.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

// Removes the figure of an older answer.
void figure_forget(const char *folder, const char *function);

void figure_write(const char *folder, const Record *record, Kept *kept, Diagnosis diagnosis);

// ---- kinds of answers --------------------------------------------------------------------------

// One call. The numbers are read from their beginning.
typedef struct {
    const char *function;
    const Record *record;
    Kept *kept;
    Numbers *question, *right, *yours;
    const char *why; // the mistake's sentence; empty if there is none
} Wrong;

// Each reads the call; false if it cannot be drawn. Then its data are written.
typedef bool FigureReader(Wrong *wrong);
typedef void FigureWriter(Plot *plot, void *wrong);

FigureReader read_vector, read_ray, read_camera, read_place, read_section, read_equation,
    read_rectangle;
FigureWriter write_vector, write_ray, write_camera, write_place, write_section, write_equation,
    write_rectangle;

// ---- for those ---------------------------------------------------------------------------------

// From low to high. A number that would make it many times as wide is left out.
typedef struct {
    double low, high;
} Range;
void range_add(Range *range, double x);
bool range_try(Range *range, double x); // false: left out

// In the text, as often as there is room.
void replace_all(char *text, size_t size, const char *old, const char *new);

// ---- the right result for a call that was kept (questions.c) -----------------------------------

// NULL if it is not known.
const Numbers *right_answer(const Record *record);

// Of the camera in the arguments: from the eye to the upper left, upper right, lower right and
// lower left corner of the image plane.
bool right_corners(const Record *record, Camera camera, vec3 corners[4]);

#endif
