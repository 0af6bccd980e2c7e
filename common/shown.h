// shown.h - numbers as people write them, in figures, slides and lessons: 10,000; 12,345.6; −0.4;
// 1.2 · 10⁻⁶. What people may copy into a program has numbers as C reads them (text.h).
//
// A number that has at most 6 digits is shown with all of them. Any other one has 4, and all that
// are before its point; one beside a power of ten has 4. So the same number looks the same
// everywhere.
#ifndef COMMON_SHOWN_H
#define COMMON_SHOWN_H

#include "common/text.h"

enum { SHOWN_DIGITS = 4 };
Text number_shown(double x);
// With at least so many digits, if it has so many.
Text number_shown_to(double x, int digits);

// (2, 2, −4). A component that is only what rounding has left of the others is 0.
Text vec3_shown(vec3 v);
Text vec3_shown_to(vec3 v, int digits);
Text pair_shown(double x, double y);
Text pair_shown_to(double x, double y, int digits);

#endif
