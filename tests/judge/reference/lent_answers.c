// lent_answers.c - for the answering process: lent_NAME asks the judge for the reference's answer.
//
// If an exercise is lent, the linker puts lent_NAME in the place of its calls.
#include "tests/judge/exercise.h"
#include "tests/judge/message.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#define EXERCISE(stem, result, name, parameters, ...)                                              \
    result lent_##name(DECLARED(parameters));                                                      \
    result lent_##name(DECLARED(parameters))                                                       \
    {                                                                                              \
        IF_VOID(result, , result yours;)                                                           \
        transport_call(NUMBER_##name, IF_VOID(result, NULL, &yours),                               \
                       (void *[]){ADDRESSES(parameters)});                                         \
        IF_VOID(result, , return yours;)                                                           \
    }
#include "tests/exercises.def"
