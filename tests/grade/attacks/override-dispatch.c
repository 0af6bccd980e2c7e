// override-dispatch: defines the answering program's own functions.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdbool.h>

bool dispatch(int exercise, void *in, void *out)
{
    return true;
}

void wire_put(void *wire, const void *value, size_t size)
{
}

bool wire_is_read(const void *wire)
{
    return true;
}
