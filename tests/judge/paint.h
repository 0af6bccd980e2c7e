// paint.h - what the stack of the answering process is filled with before a call, so that a result
// that was never set is known by it.
#ifndef TESTS_JUDGE_PAINT_H
#define TESTS_JUDGE_PAINT_H

#include <stdbool.h>

// Bytes; 0 for none. Two, so that no number is taken for paint by chance.
enum { NO_PAINT, PAINT = 0x6b, OTHER_PAINT = 0x4d };

// For the next calls; none to begin with.
void paint_calls(int paint);
int paint_of_calls(void);

// Whether a number is nothing but paint: of a double, or of an int.
bool is_paint(double number, int paint);

#endif
