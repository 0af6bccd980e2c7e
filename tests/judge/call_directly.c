// call_directly.c - for a program of tests: the answers of the stem that was chosen are called in
// this process, and the reference answers for all other stems, so that one mistake costs once.
#include "tests/judge/stem.h"
#include "tests/judge/switchboard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void call_directly(void)
{
    switch_to_reference();
    for (int i = 0; exercises[i].name != NULL; i++) {
        if (strcmp(exercises[i].stem, chosen_stem()->name) != 0)
            continue;
        if (direct_answers[i] == NULL) {
            fprintf(stderr, "%s: no answer to %s is linked\n", exercises[i].stem,
                    exercises[i].name);
            exit(2);
        }
        switch_one(exercises[i].name, direct_answers[i]);
    }
}

__attribute__((constructor)) static void add_to_all_stems(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        stem_named(exercises[i].stem)->load = call_directly;
}
