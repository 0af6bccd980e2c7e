// right_answer.c - the right result of a recorded call, from the table.
#include "tests/judge/right_answer.h"

#include "tests/handout/replay/replay.h"

#include <string.h>

// The call at which the test stopped.
static const ToldCall *call_of(const Record *record)
{
    const Told *told = told_table();
    for (int i = 0; i < told->test_count; i++) {
        const ToldTest *test = &told->tests[i];
        if (strcmp(test->function, record->function) == 0 &&
            strcmp(test->name, record->name) == 0 && record->cases >= 1 &&
            record->cases <= test->call_count)
            return &test->calls[record->cases - 1];
    }
    return NULL;
}

bool right_answer(const Record *record, Kept *kept, Wire *right)
{
    const ToldCall *call = call_of(record);
    Resolution size = {0, 0};
    Numbers arguments = {0};
    if (call == NULL)
        return false;
    // The image's size is among the arguments.
    kept->question.read = 0;
    layout_read(exercises[kept->exercise].arguments, &kept->question, &size, &arguments);
    numbers_free(&arguments);
    wire_clear(right);
    return layout_write(exercises[kept->exercise].results, &call->results[0], &size, right);
}

bool right_corners(const Record *record, Camera camera, vec3 corners[4])
{
    const ToldCall *call = call_of(record);
    (void)camera;
    if (call == NULL || call->corners.count != 12)
        return false;
    const double *at = call->corners.at;
    for (int i = 0; i < 4; i++)
        corners[i] = vec3_of(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
    return true;
}
