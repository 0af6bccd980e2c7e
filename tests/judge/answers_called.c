// answers_called.c - notes which answers a program calls, so that a figure can say whose mistake it
// shows.
//
// The linker has each call of an exercise go to __wrap_NAME, which is here, and calls the answer
// __real_NAME (-Wl,--wrap=NAME, in the Makefile). Programs of the solutions are linked without it.
#include "common/answers.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#include <stdatomic.h>

// Pictures call answers millions of times, some from several threads.
static void note_once(atomic_bool *noted, const char *name)
{
    if (!atomic_load_explicit(noted, memory_order_relaxed) && !atomic_exchange(noted, true))
        answer_called(name);
}

#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result __real_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters));                                                    \
    result __wrap_##name(DECLARED(parameters))                                                     \
    {                                                                                              \
        static atomic_bool noted;                                                                  \
        note_once(&noted, #name);                                                                  \
        IF_VOID(result, , return ) __real_##name(NAMES(parameters));                               \
    }
#include "tests/exercises.def"
