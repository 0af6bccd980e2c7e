// known_answers.c - what is known of a chapter's answers, one after the other.
#include "tests/proof/book/known_answers.h"

const KnownAnswer *known_answer_at(const char *stem, int number)
{
    for (KindOfAnswer kind = WRONG_ANSWERS; kind <= UNNAMED_ANSWERS; kind++)
        for (const KnownAnswer *it = stem_named(stem)->known[kind]; it != NULL; it = it->next)
            if (number-- == 0)
                return it;
    return NULL;
}
