// proxies.c - each exercise under its contract name, for the tests: the chosen one answers
// (switchboard.h), and the results are compared with the known mistakes and the laws.
#include "tests/judge/message.h"
#include "tests/judge/parameters.h"
#include "tests/judge/reference/mistake_comparison.h"
#include "tests/judge/suspects.h"

#include "tests/exercises.def" // the contracts

// The law of an exercise (law.h), if it has one.
typedef void LawCall(const void *yours, void *const *arguments);

#define LAW_VALUE(result, name, parameters)                                                        \
    void law_##name(result yours, DECLARED(parameters)) __attribute__((weak));                     \
    static void obey_##name(const void *yours, void *const *arguments)                             \
    {                                                                                              \
        law_##name(*(const result *)yours, ARGUMENTS(parameters));                                 \
    }
#define LAW_VOID(result, name, parameters)                                                         \
    void law_##name(DECLARED(parameters)) __attribute__((weak));                                   \
    static void obey_##name(const void *yours, void *const *arguments)                             \
    {                                                                                              \
        (void)yours;                                                                               \
        law_##name(ARGUMENTS(parameters));                                                         \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, LAW_VOID, LAW_VALUE)(result, name, parameters)
#include "tests/exercises.def"

static void ask(int exercise, void *yours, void *const *arguments, LawCall *law)
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
    if (law != NULL && law_begin(exercise))
        law(yours, arguments);
}

#define PROXY_VALUE(result, name, parameters)                                                      \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        result yours;                                                                              \
        ask(NUMBER_##name, &yours, (void *[]){ADDRESSES(parameters)},                              \
            law_##name == NULL ? NULL : obey_##name);                                              \
        return yours;                                                                              \
    }
#define PROXY_VOID(result, name, parameters)                                                       \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        ask(NUMBER_##name, NULL, (void *[]){ADDRESSES(parameters)},                                \
            law_##name == NULL ? NULL : obey_##name);                                              \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, PROXY_VOID, PROXY_VALUE)(result, name, parameters)
#include "tests/exercises.def"
