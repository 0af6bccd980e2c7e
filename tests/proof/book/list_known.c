// list_known.c - prints the known answers of a chapter: EXERCISE tab WHAT, a line each.
#include "tests/proof/book/known_answers.h"

#include <stdio.h>

int main(int argc, char **argv)
{
    KnownAnswer answer;
    for (int i = 0; argc == 2 && known_answer_at(argv[1], i, &answer); i++)
        printf("%s\t%s\n", answer.exercise, answer.what);
    return 0;
}
