// stack_paint.c - the bytes that fill the stack of the answering process before a call.
#include "tests/judge/stack_paint.h"

#include <string.h>

static int paint_now;

void paint_calls(int paint)
{
    paint_now = paint;
}

int paint_of_calls(void)
{
    return paint_now;
}

bool is_paint(double number, int paint)
{
    double painted;
    int painted_int;
    memset(&painted, paint, sizeof painted);
    memset(&painted_int, paint, sizeof painted_int);
    return number == painted || number == painted_int;
}
