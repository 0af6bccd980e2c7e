// variants.c - the table fails no right answer and names no mistake in one, however it is written.
//
//   variants STEM
#include "tests/handout/direct_transport.h"
#include "tests/handout/replay/replay.h"

#include "tests/judge/runner.h"
#include "tests/judge/show.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"
#include "tests/proof/variants.h"

#include <string.h>

static Outcomes outcomes;
static bool is_right(const Variant *variant)
{
    bool good = true;
    answer_here_by(variant->answer);
    suspects_begin();
    run_tests(variant->exercise, NULL, ANSWERS_APART, &outcomes);
    for (int i = 0; i < outcomes.count; i++) {
        if (outcomes.tests[i].passed || outcomes.tests[i].extra)
            continue;
        printf("not ok: right answer fails: %s: %s: %s\n", variant->exercise, variant->what,
               outcomes.tests[i].name);
        show_outcome(stdout, &outcomes.tests[i]);
        good = false;
    }
    const Mistake *accused = suspect(exercise_number(variant->exercise), 0, false);
    if (accused != NULL)
        printf("not ok: right answer is accused: %s: %s: %s\n", variant->exercise, variant->what,
               accused->why);
    records_end();
    return good && accused == NULL;
}

int main(int argc, char **argv)
{
    const char *stem = argc > 1 ? argv[1] : NULL;
    int passed = 0, failed = 0;
    choose_stem(stem);
    switch_to_process(stem);
    const Variant *variants = chosen_stem()->variants;
    for (int i = 0; variants != NULL && variants[i].exercise != NULL; i++)
        *(is_right(&variants[i]) ? &passed : &failed) += 1;
    printf("right answers by the table of %s: %d passed, %d failed\n", stem, passed, failed);
    return failed == 0 && passed > 0 ? 0 : 1;
}
