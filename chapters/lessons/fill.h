// fill.h - the numbers of a lesson, by the names that its source has for them (fill.py).
#ifndef CHAPTERS_LESSONS_FILL_H
#define CHAPTERS_LESSONS_FILL_H

#include "common/camera.h"
#include "common/vec3.h"

// Give a name its text. Numbers are as people write them (common/shown.h); fill.py writes them in
// formulas as LaTeX does.
void fill_text(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
void fill_number(const char *name, double x);
void fill_number_to(const char *name, double x, int digits);
void fill_vector(const char *name, vec3 v);
// As a term of a sum: + 0.3 or − 0.2.
void fill_term(const char *name, double x);
// = or, if any of these numbers is shown rounded, \approx.
void fill_equals(const char *name, int count, const double *numbers);
// = 0.46875 or \approx 0.1667.
void fill_result(const char *name, double x, int digits);
// As an option's argument, or in code: 2,2,-4
void fill_option(const char *name, vec3 v);
// d, w, h, eye, right, up and forward of a camera.
void fill_camera(Camera camera);

// All that were given.
typedef struct {
    const char *name;
    char text[400];
} FilledNumber;
const FilledNumber *filled_numbers(int *count);

// Gives all numbers of a lesson: NN-stem.c.
void fill_numbers(void);

#endif
