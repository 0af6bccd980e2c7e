// compare_engines.h - the engines of chapter 08, each against one and the same picture.
//
// Who compares makes a Work for the right picture; what the others make of the same scene and
// camera must be the same pixels, by any number of threads and with every instruction set that
// they were compiled for.
#ifndef TESTS_HOUSE_ENGINES_COMPARE_ENGINES_H
#define TESTS_HOUSE_ENGINES_COMPARE_ENGINES_H

#include "chapters/08-fast/engines/engine.h"

// The results of all comparisons of this program.
extern int passed, failed;

// Says why, as one that failed.
void against_fail(const char *name, const char *why);

// Each number of threads with each instruction set; the sets and the numbers in turns: the first
// set has the first number, and so on; or only the best set, and numbers in turns.
typedef enum { EACH, IN_TURNS, BEST_SET } How;

// All engines from this one on against the picture in right, which was cast before, by these
// numbers of threads (the list ends with 0).
void against_all(const char *name, const Engine *first, const Work *right, const int *threads,
                 How how);

// Rows of a picture against chapter 06's loop, scattered: at most this number of rows, and of ray
// and sphere tests. Only spheres that the plane of a row's rays comes near are asked.
void against_rows(const char *name, const Work *right, int rows, double tests);

// The last line; what main returns.
int against_end(const char *name);

#endif
