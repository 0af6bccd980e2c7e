// list_known.c - prints the known answers of a chapter: EXERCISE tab WHAT, a line each.
#include "tests/proof/book/known_answers.h"

#include <stdio.h>

int main(int argc, char **argv)
{
    const KnownAnswer *answer;
    for (int i = 0; argc == 2 && (answer = known_answer_at(argv[1], i)) != NULL; i++)
        printf("%s\t%s\n", answer->exercise, answer->id);
    return 0;
}
