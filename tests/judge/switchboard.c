// switchboard.c - who answers an exercise.
#include "tests/judge/switchboard.h"

#include "tests/judge/runner.h"

#include <stddef.h>
#include <string.h>

#define EXERCISE(stem, result, name, ...) AnyFunction answer_##name __attribute__((weak));
#include "tests/exercises.def"
#define EXERCISE(stem, result, name, ...) answer_##name,
AnyFunction *const direct_answers[EXERCISE_COUNT] = {
#include "tests/exercises.def"
};

static AnyFunction *answers[EXERCISE_COUNT];
static bool all_by_process;

void switch_to_reference(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        answers[i] = exercises[i].reference;
}

bool switch_one(const char *exercise, AnyFunction *answer)
{
    int i = exercise_number(exercise);
    if (i >= 0)
        answers[i] = answer;
    return i >= 0;
}

void switch_to_process(const char *stem)
{
    switch_to_reference();
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, stem) == 0)
            answers[i] = NULL;
}

void switch_all_to_process(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        answers[i] = NULL;
    all_by_process = true;
}

// A test of one exercise may call others of the stem to find out more; the reference answers those,
// so that one mistake costs marks once.
AnyFunction *local_answer(int i)
{
    if (answers[i] == NULL && !all_by_process &&
        strcmp(record_now()->function, exercises[i].name) != 0)
        return exercises[i].reference;
    return answers[i];
}
