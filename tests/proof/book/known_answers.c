// known_answers.c - the tables of a chapter, one after the other.
#include "tests/proof/book/known_answers.h"

#include "tests/judge/mistake.h"
#include "tests/proof/unknown.h"
#include "tests/proof/variants.h"

bool known_answer_at(const char *stem, int number, KnownAnswer *answer)
{
    const Stem *known = stem_named(stem);
    int i = 0;
    for (const Mistake *const *table = known->mistakes; table != NULL && *table != NULL; table++)
        for (const Mistake *it = *table; it->id != NULL; it++)
            if (i++ == number) {
                *answer = (KnownAnswer){it->exercise, it->id, it->answer};
                return true;
            }
    for (const Variant *it = known->variants; it != NULL && it->exercise != NULL; it++)
        if (i++ == number) {
            *answer = (KnownAnswer){it->exercise, it->what, it->answer};
            return true;
        }
    for (const Unknown *it = known->unknowns; it != NULL && it->exercise != NULL; it++)
        if (i++ == number) {
            *answer = (KnownAnswer){it->exercise, it->what, it->answer};
            return true;
        }
    return false;
}
