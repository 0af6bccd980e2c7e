// mistaken.c - for the gallery of mistakes: cast.c calls the solutions, but for one, which is a
// known mistake.
#include "tests/judge/known.h"
#include "tests/judge/parameters.h"

#include "tests/exercises.def" // the contracts

#include <string.h>

// Each function of a solution is weak, and reference_NAME as well (tests/proof/switched.c).
#define EXERCISE(stem, result, name, parameters, ...)                                              \
    static __typeof__(name) *mistaken_##name;                                                      \
    __typeof__(name) reference_##name;                                                             \
    result name(DECLARED(parameters))                                                              \
    {                                                                                              \
        IF_VOID(result, , return )                                                                 \
        (mistaken_##name != NULL ? mistaken_##name : reference_##name)(NAMES(parameters));         \
    }
#include "tests/exercises.def"

// The number of a mistake in the list that tests/proof/mistaken_figures.c prints; NULL: there is
// none.
static const Mistake *numbered(int left)
{
    for (int i = 0; left >= 0 && exercises[i].name != NULL; i++) {
        if (i > 0 && strcmp(exercises[i].stem, exercises[i - 1].stem) == 0)
            continue;
        choose_stem(exercises[i].stem);
        for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
            if (left-- == 0)
                return it;
    }
    return NULL;
}

// From now on that one; -1: none.
__attribute__((export_name("choose_mistake"))) void choose_mistake(int number);
void choose_mistake(int number)
{
    const Mistake *mistake = numbered(number);
#define EXERCISE(stem, result, name, ...)                                                          \
    mistaken_##name = mistake != NULL && strcmp(mistake->exercise, #name) == 0                     \
                          ? (__typeof__(name) *)mistake->answer                                    \
                          : NULL;
#include "tests/exercises.def"
}
