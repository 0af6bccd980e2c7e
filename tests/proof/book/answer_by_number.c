// answer_by_number.c - the answers of a chapter (ANSWERED): one of them is the known answer that
// was chosen, the others are the reference's.
//
// Which one is said by a text, "known answer 000012", which is exchanged in the program itself. So
// one program has them all, and nothing is compiled or linked for the next.
//
// All are weak, as a student's are, so that the linker can lend them. In the reference's own code
// (reference_answers.c) the calls of an exercise come here too.
#include "tests/proof/book/known_answers.h"

#include "tests/exercises.def" // the contracts
#include "tests/judge/parameters.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const char known_answer[];

#define CHAPTER(number) (ANSWERED == number)
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result name(DECLARED(parameters)) __attribute__((weak));                                       \
    result referred_##name(DECLARED(parameters));
#include "tests/exercises.def"

static const KnownAnswer *choose(const char *stem)
{
    int number = -1;
    const KnownAnswer *known = NULL;
    if (sscanf(known_answer, "known answer %d", &number) == 1)
        known = known_answer_at(stem, number);
    if (known == NULL) {
        fprintf(stderr, "there is no %s\n", known_answer);
        exit(2);
    }
    return known;
}

static void answer(int exercise, AnyFunction *reference, void *result, void *const *arguments)
{
    static const KnownAnswer *known;
    static int chosen = -1; // an exercise
    if (known == NULL)
        known = choose(exercises[exercise].stem);
    if (chosen < 0 && strcmp(exercises[exercise].name, known->exercise) == 0)
        chosen = exercise;
    exercises[exercise].call(exercise == chosen ? known->answer : reference, result, arguments);
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
