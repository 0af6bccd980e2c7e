// list_exercises.c - prints tests/exercises.def for programs in other languages: a line an
// exercise. Its stem, name, prototype, slide and question have tabs between them.
#include "tests/judge/exercise.h"

#include <stdio.h>

int main(void)
{
    for (const Exercise *it = exercises; it->name != NULL; it++)
        printf("%s\t%s\t%s\t%s\t%s\n", it->stem, it->name, it->prototype, it->slide, it->prompt);
    return 0;
}
