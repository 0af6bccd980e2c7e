// report.h - what the bench of the engines says: lines for people, and a CSV for plots.
#ifndef TESTS_BENCHES_REPORT_H
#define TESTS_BENCHES_REPORT_H

#include "chapters/08-fast/engines/engine.h"
#include "tests/benches/quantile.h"

#include <stdbool.h>
#include <stdio.h>

enum { MOST_ROWS = 64 };

// One engine with one number of threads on one scene. Seconds.
typedef struct {
    const Engine *engine;
    int threads;
    bool peer;
    Resolution size;
    int different; // pixels, from the hierarchy's
    int rounds;
    double build[MOST_ROUNDS], cast[MOST_ROUNDS], spent;
} Row;

typedef struct {
    FILE *csv;    // NULL: none
    FILE *ratios; // each engine beside each peer; NULL: none
    struct {
        const Engine *engine;
        int threads, scenes;
        double log_sum, least, frame_log_sum;
    } sums[MOST_ROWS];
    int sum_count;
} Report;

// Which machine this is.
void report_begin(Report *report);
void report_scene(Report *report, const char *path, int spheres, const Row *rows, int count);
// Over all scenes: the geometric mean of the ratios, and the least. Closes both files.
void report_end(Report *report);

#endif
