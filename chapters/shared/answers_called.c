// answers_called.c - notes which answers a program calls, so that a figure can say whose mistake it
// shows.
//
// The linker has each call of an exercise go to __wrap_NAME, which is here, and calls the answer
// __real_NAME (-Wl,--wrap=NAME, in the Makefile). Without that option,
// nothing of this is linked.
#include "common/answers.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#include <stdatomic.h>

#define PASSED(parameters) EACH(BY_PASSING, COMMA, PASS, parameters)
#define PASS_VALUE(i, type, name) name
#define PASS_CONST_POINTER(i, type, name) name
#define PASS_POINTER(i, type, name) name
#define PASS_IMAGE(i, type, name) name
#define PASS_PIXELS(i, type, name) name

// Pictures call answers millions of times, some from several threads.
#define NOTE(name)                                                                                 \
    static atomic_bool noted;                                                                      \
    if (!atomic_load_explicit(&noted, memory_order_relaxed) && !atomic_exchange(&noted, true))     \
    answer_called(#name)
#define WRAP_VALUE(result, name, parameters)                                                       \
    result __real_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters))                                                     \
    {                                                                                              \
        NOTE(name);                                                                                \
        return __real_##name(PASSED(parameters));                                                  \
    }
#define WRAP_VOID(result, name, parameters)                                                        \
    result __real_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters))                                                     \
    {                                                                                              \
        NOTE(name);                                                                                \
        __real_##name(PASSED(parameters));                                                         \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, WRAP_VOID, WRAP_VALUE)(result, name, parameters)
#include "tests/exercises.def"
