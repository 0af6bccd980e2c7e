// switchboard.c - made from the table of exercises.
#include "tests/judge/switchboard.h"

#include "exercises/01-corners.h"
#include "exercises/02-cameras.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include <stddef.h>
#include <string.h>

// The reference, compiled under other names.
#define EXERCISE(stem, name, result, parameters, arguments, slide)                                 \
    result reference_##name parameters;
#define EXERCISE_VOID(stem, name, parameters, arguments, slide) void reference_##name parameters;
#include "tests/exercises.def"
#undef EXERCISE
#undef EXERCISE_VOID

enum {
#define EXERCISE(stem, name, result, parameters, arguments, slide) INDEX_##name,
#define EXERCISE_VOID(stem, name, parameters, arguments, slide) INDEX_##name,
#include "tests/exercises.def"
#undef EXERCISE
#undef EXERCISE_VOID
    EXERCISES
};

static const struct {
    const char *name;
    AnyFunction *reference;
} exercises[EXERCISES + 1] = {
#define EXERCISE(stem, name, result, parameters, arguments, slide)                                 \
    {#name, (AnyFunction *)reference_##name},
#define EXERCISE_VOID(stem, name, parameters, arguments, slide)                                    \
    {#name, (AnyFunction *)reference_##name},
#include "tests/exercises.def"
#undef EXERCISE
#undef EXERCISE_VOID
};

static AnyFunction *answers[EXERCISES];

#define EXERCISE(stem, name, result, parameters, arguments, slide)                                 \
    result name parameters                                                                         \
    {                                                                                              \
        return ((result(*) parameters)answers[INDEX_##name])arguments;                             \
    }
#define EXERCISE_VOID(stem, name, parameters, arguments, slide)                                    \
    void name parameters                                                                           \
    {                                                                                              \
        ((void(*) parameters)answers[INDEX_##name]) arguments;                                     \
    }
#include "tests/exercises.def"
#undef EXERCISE
#undef EXERCISE_VOID

void switch_to_reference(void)
{
    for (int i = 0; i < EXERCISES; i++)
        answers[i] = exercises[i].reference;
}

bool switch_one(const char *exercise, AnyFunction *answer)
{
    for (int i = 0; i < EXERCISES; i++)
        if (strcmp(exercises[i].name, exercise) == 0) {
            answers[i] = answer;
            return true;
        }
    return false;
}

const char *exercise_name(int i)
{
    return exercises[i].name;
}
