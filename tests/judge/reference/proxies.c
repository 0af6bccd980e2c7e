// proxies.c - each exercise under its contract name, for the tests: the chosen one answers
// (switchboard.h), and the results are compared with the known mistakes and the laws.
#include "tests/judge/message.h"
#include "tests/judge/parameters.h"
#include "tests/judge/reference/mistake_comparison.h"
#include "tests/judge/suspects.h"

#include "tests/exercises.def" // the contracts

static void ask(int exercise, void *yours, void *const *arguments)
{
    Wire *heard = hear_question(exercise);
    if (heard != NULL)
        put_arguments(heard, exercise, arguments);
    AnyFunction *local = local_answer(exercise);
    if (local != NULL)
        exercises[exercise].call(local, yours, arguments);
    else
        transport_call(exercise, yours, arguments);
    heard = hear_answer(exercise);
    if (heard != NULL) {
        put_results(heard, exercise, yours, arguments);
        hear(exercise);
    }
    law_check(exercise, yours, arguments);
}

#define PROXY_VALUE(result, name, parameters)                                                      \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        result yours;                                                                              \
        ask(NUMBER_##name, &yours, (void *[]){ADDRESSES(parameters)});                             \
        return yours;                                                                              \
    }
#define PROXY_VOID(result, name, parameters)                                                       \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        ask(NUMBER_##name, NULL, (void *[]){ADDRESSES(parameters)});                               \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, PROXY_VOID, PROXY_VALUE)(result, name, parameters)
#include "tests/exercises.def"
