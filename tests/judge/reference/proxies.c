// proxies.c - each exercise under its contract name, for the tests.
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#include <string.h>

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

#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        IF_VOID(result, , result yours;)                                                           \
        ask(NUMBER_##name, IF_VOID(result, NULL, &yours), (void *[]){ADDRESSES(parameters)});      \
        IF_VOID(result, , return yours;)                                                           \
    }
#include "tests/exercises.def"

// ---- answers that are linked into this program -------------------------------------------------

#define EXERCISE(stem, result, name, ...) AnyFunction answer_##name __attribute__((weak));
#include "tests/exercises.def"
#define EXERCISE(stem, result, name, ...) answer_##name,
AnyFunction *const direct_answers[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};

static void call_directly(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, chosen_stem()->name) == 0)
            answer_by(i, direct_answers[i]);
}

// If they are, those of the stem that is chosen answer.
__attribute__((constructor)) static void add_to_stems(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        if (direct_answers[i] != NULL)
            stem_named(exercises[i].stem)->load = call_directly;
}
