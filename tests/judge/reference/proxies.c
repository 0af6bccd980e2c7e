// proxies.c - each exercise under its contract name, for the tests.
#include "tests/judge/reference/proxies.h"

#include "tests/judge/message.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#define EXERCISE(stem, result, name, ...) AnyFunction reference_##name __attribute__((weak));
#include "tests/exercises.def"
#define EXERCISE(stem, result, name, ...) reference_##name,
static AnyFunction *answers[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};

void answer_by(int exercise, AnyFunction *answer)
{
    answers[exercise] = answer;
}

static void ask(int exercise, void *yours, void *const *arguments)
{
    if (answers[exercise] != NULL)
        exercises[exercise].call(answers[exercise], yours, arguments);
    else
        transport_call(exercise, yours, arguments);
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
