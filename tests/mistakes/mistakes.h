// mistakes.h - wrong answers that people really give, as code, and what to say of each.
//
// Each stands in a file of its stem. make check proves that each fails a test of its function and
// is named from its values alone, and that each test is failed by one.
#ifndef TESTS_MISTAKES_H
#define TESTS_MISTAKES_H

#include "tests/judge/mistake.h"

#include <stddef.h>

#define MISTAKE(id, exercise, answer, formula, why, picture)                                       \
    {                                                                                              \
        id, #exercise, (AnyFunction *)(answer), formula, why, picture                              \
    }

#endif
