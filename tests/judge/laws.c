// laws.c - calls the law of an exercise (law.h), if this program has it.
#include "tests/judge/law.h"

#include "tests/judge/message.h"
#include "tests/judge/parameters.h"
#include "tests/judge/suspects.h"

#include "tests/exercises.def" // the contracts

// Of the call: obey_NAME has the type of the exercise, so that it is called as an answer is.
static const void *your_result, *right_result;

#define LAW_VALUE(result, name, parameters)                                                        \
    void law_##name(result yours, result right, DECLARED(parameters)) __attribute__((weak));       \
    static result obey_##name(DECLARED(parameters))                                                \
    {                                                                                              \
        const result *yours = your_result, *right = right_result;                                  \
        if (law_##name != NULL)                                                                    \
            law_##name(*yours, *right, NAMES(parameters));                                         \
        return *yours;                                                                             \
    }
#define LAW_VOID(result, name, parameters)                                                         \
    void law_##name(DECLARED(parameters)) __attribute__((weak));                                   \
    static void obey_##name(DECLARED(parameters))                                                  \
    {                                                                                              \
        if (law_##name != NULL)                                                                    \
            law_##name(NAMES(parameters));                                                         \
    }
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, LAW_VOID, LAW_VALUE)(result, name, parameters)
#include "tests/exercises.def"

#define EXERCISE(stem, result, name, ...) (AnyFunction *)obey_##name,
static AnyFunction *const laws[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};

typedef struct {
    _Alignas(vec3) unsigned char bytes[TYPE_MOST_BYTES];
} Result;

void law_check(int exercise, const void *yours, void *const *arguments)
{
    const Exercise *it = &exercises[exercise];
    Result right, ignored;
    bool only_returns = true;
    if (!law_begin(exercise))
        return;
    for (int i = 0; i < it->parameter_count; i++)
        only_returns = only_returns && it->parameters[i].passing < PASSED_POINTER;
    if (only_returns)
        it->call(it->reference, &right, arguments);
    your_result = yours;
    right_result = only_returns ? &right : yours;
    it->call(laws[exercise], &ignored, arguments);
}

static void get_result(int exercise, const Numbers *numbers, Resolution *size, Result *result)
{
    static Wire wire;
    wire_clear(&wire);
    layout_write(exercises[exercise].results, numbers, size, &wire);
    wire_get_value(&wire, exercises[exercise].result, result);
}

void law_check_recorded(int exercise, const Numbers *arguments, const Numbers *yours,
                        const Numbers *right)
{
    static Wire in, ignored;
    Resolution size = {0, 0};
    Result your_value, right_value;
    if (yours->count != right->count || !law_begin(exercise))
        return;
    wire_clear(&in);
    wire_clear(&ignored);
    layout_write(exercises[exercise].arguments, arguments, &size, &in);
    get_result(exercise, yours, &size, &your_value);
    get_result(exercise, right, &size, &right_value);
    your_result = &your_value;
    right_result = &right_value;
    apply(exercise, laws[exercise], &in, &ignored);
}
