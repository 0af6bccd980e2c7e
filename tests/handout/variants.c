// variants.c - the table fails no right answer and names no mistake in one, however it is written.
//
//   variants STEM
#include "tests/handout/replay/table.h"
#include "tests/judge/message.h"

#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"

#include <string.h>

static Outcomes outcomes;
static bool is_right(const KnownAnswer *variant)
{
    bool good = true;
    answer_here_by(variant->answer);
    suspects_begin();
    run_tests(variant->exercise, NULL, ANSWERS_APART, &outcomes);
    for (int i = 0; i < outcomes.count; i++) {
        if (outcomes.tests[i].passed || outcomes.tests[i].extra)
            continue;
        printf("not ok: right answer fails: %s: %s: %s\n", variant->exercise, variant->id,
               outcomes.tests[i].name);
        show_outcome(&outcomes.tests[i]);
        good = false;
    }
    const Mistake *accused = suspect(exercise_number(variant->exercise), 0, false);
    if (accused != NULL)
        printf("not ok: right answer is accused: %s: %s: %s\n", variant->exercise, variant->id,
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
    for (const KnownAnswer *it = known_answers(RIGHT_ANSWERS); it != NULL; it = it->next)
        *(is_right(it) ? &passed : &failed) += 1;
    printf("right answers by the table of %s: %d passed, %d failed\n", stem, passed, failed);
    return failed == 0 && passed > 0 ? 0 : 1;
}
