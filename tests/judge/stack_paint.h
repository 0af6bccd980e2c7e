// stack_paint.h - the bytes that fill the stack of the answering process before a call, so that a
// result that was never set is recognised by them.
#ifndef TESTS_JUDGE_STACK_PAINT_H
#define TESTS_JUDGE_STACK_PAINT_H

#include <stdbool.h>

// Bytes; 0 for none. Two, so that no number is taken for paint by chance.
enum { NO_PAINT, PAINT = 0x6b, OTHER_PAINT = 0x4d };

// For the next calls; none to begin with.
void paint_calls(int paint);
int paint_of_calls(void);

// Whether a number consists only of paint: of a double, or of an int.
bool is_paint(double number, int paint);

#endif
