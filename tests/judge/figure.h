// figure.h - a wrong answer beside the right one, as numbers for a layout.
//
// For a function whose test failed, FOLDER/FUNCTION.gp is a script for gnuplot
// (common/figure/plot.h), or FOLDER/FUNCTION.png a picture; neither if there is nothing to draw: no
// answer, one that is not finite or far beyond what can be shown beside the right one, or hidden
// inputs.
#ifndef TESTS_JUDGE_FIGURE_H
#define TESTS_JUDGE_FIGURE_H

#include "common/figure/plot.h"
#include "tests/judge/record.h"
#include "tests/judge/recorded_calls.h"
#include "tests/judge/suspects.h"

// Removes the figure of an older answer.
void figure_forget(const char *folder, const char *function);

void figure_write(const char *folder, const Record *record, Kept *kept, Diagnosis diagnosis);

// ---- kinds of answers ---------------------------------------------------------------------------

// One call. The wires are read from their beginning.
typedef struct {
    const char *function;
    const Record *record;
    Kept *kept;
    Wire *question, *right, *yours;
    const char *why; // the mistake's sentence; empty if there is none
} Wrong;

// Each reads the call; false if it cannot be drawn. Then its data are written.
typedef bool FigureReader(Wrong *wrong);
typedef void FigureWriter(Plot *plot, void *wrong);

FigureReader read_vector, read_ray, read_camera, read_place, read_section, read_equation,
    read_rectangle;
FigureWriter write_vector, write_ray, write_camera, write_place, write_section, write_equation,
    write_rectangle;

// Yours, expected, and where they differ, side by side.
bool write_pictures(Wrong *wrong, const char *path);

// ---- for those --------------------------------------------------------------------------------

// The next value of the message.
#define WIRE_GET(wire, type, value) wire_get_value(wire, &type_##type, &(value))

// From low to high. A number that would make it many times as wide is left out.
typedef struct {
    double low, high;
} Range;
void range_add(Range *range, double x);
bool range_try(Range *range, double x); // false: left out

// Results on a t axis: a flat figure, in which t = 1 is 'unit' to the right.
typedef struct {
    double low, high; // of t
    double unit, y;
    const double *right, *yours; // the results
    int right_count, your_count;
} Axis;

// $axis and $ticks, with round numbers, except where the results are; $answer and $yours, x y z t,
// on the axis.
void figure_axis(Plot *plot, const Axis *axis);

// Whether it is finite, and no farther from the right one than this multiple of its size.
enum { FIGURE_FAR = 20 };
bool figure_near(vec3 yours, vec3 right, double size);
bool figure_same_place(vec3 a, vec3 b); // to 9 digits

// From whose right side the figure is seen.
void figure_frame(Plot *plot, vec3 right, vec3 up, vec3 forward);

// The difference of 3.2 and 3.6: "off by 0.4"; empty if one of them is missing.
Text figure_off(double right, double yours);

#endif
