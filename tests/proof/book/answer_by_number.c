// answer_by_number.c - the answers of a chapter (ANSWERED): one of them is the known answer that
// was chosen, the others are the reference's.
//
// All are weak, as a student's are, so that the linker can lend them. In the reference's own code
// (reference_answers.c) the calls of an exercise come here too.
#include "tests/proof/book/known_answers.h"

#include "tests/exercises.def" // the contracts
#include "tests/judge/parameters.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const int known_answer;

#define CHAPTER(number) (ANSWERED == number)
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result name(DECLARED(parameters)) __attribute__((weak));                                       \
    result referred_##name(DECLARED(parameters));
#include "tests/exercises.def"

static void answer(int exercise, AnyFunction *reference, void *result, void *const *arguments)
{
    static KnownAnswer known;
    if (known.exercise == NULL &&
        !known_answer_at(exercises[exercise].stem, known_answer, &known)) {
        fprintf(stderr, "there is no known answer %d\n", known_answer);
        exit(2);
    }
    bool is_it = strcmp(exercises[exercise].name, known.exercise) == 0;
    exercises[exercise].call(is_it ? known.answer : reference, result, arguments);
}

#define ANSWER_VALUE(result, name, parameters)                                                     \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        result yours;                                                                              \
        answer(NUMBER_##name, (AnyFunction *)referred_##name, &yours,                              \
               (void *[]){ADDRESSES(parameters)});                                                 \
        return yours;                                                                              \
    }
#define ANSWER_VOID(result, name, parameters)                                                      \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        answer(NUMBER_##name, (AnyFunction *)referred_##name, NULL,                                \
               (void *[]){ADDRESSES(parameters)});                                                 \
    }
#define CHAPTER(number) (ANSWERED == number)
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    IF_VOID(result, ANSWER_VOID, ANSWER_VALUE)(result, name, parameters)
#include "tests/exercises.def"
