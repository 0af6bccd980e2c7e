// laws.c - calls the law of an exercise (known.h), if this program has it.
#include "tests/judge/known.h"

#include "tests/judge/message.h"
#include "tests/judge/parameters.h"
#include "tests/judge/suspects.h"
#include "tests/judge/table.h"

#include "tests/exercises.def" // the contracts

// Of the question: obey_NAME has the type of the exercise, so that it is called as an answer is.
static const Question *asked;
static Numbers your_results;

const double *law_facts(void)
{
    return asked->facts.at;
}

const double *law_right(void)
{
    return asked->results[0].at;
}

static void get_your_results(int exercise, void *yours, void *const *arguments)
{
    get_results(&your_results, exercise, yours, arguments);
}

static void get_right(int exercise, void *right)
{
    Numbers numbers = numbers_again(&asked->results[0]);
    numbers_get(&numbers, exercises[exercise].result, right);
}

#define LAW_VALUE(result, name, parameters)                                                        \
    void law_##name(result yours, result right, DECLARED(parameters)) __attribute__((weak));       \
    static result obey_##name(DECLARED(parameters))                                                \
    {                                                                                              \
        result yours, right;                                                                       \
        get_right(NUMBER_##name, &right);                                                          \
        get_your_results(NUMBER_##name, &yours, (void *[]){ADDRESSES(parameters)});                \
        if (law_##name != NULL)                                                                    \
            law_##name(yours, right, NAMES(parameters));                                           \
        return yours;                                                                              \
    }
#define LAW_VOID(result, name, parameters)                                                         \
    void law_##name(DECLARED(parameters)) __attribute__((weak));                                   \
    static void obey_##name(DECLARED(parameters))                                                  \
    {                                                                                              \
        get_your_results(NUMBER_##name, NULL, (void *[]){ADDRESSES(parameters)});                  \
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

void law_check(int exercise, const Question *question, const Numbers *yours)
{
    static Numbers ignored;
    asked = question;
    if (yours->count != question->results[0].count || !law_begin())
        return;
    numbers_clear(&ignored);
    Numbers arguments = numbers_again(&question->arguments);
    your_results = numbers_again(yours);
    apply(exercise, laws[exercise], &arguments, &ignored);
}
