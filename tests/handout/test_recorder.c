// test_recorder.c - records the calls of a test at the other end of the pipe, where the reference
// answers.
#include "tests/handout/test_recorder.h"

#include "tests/handout/direct_transport.h"
#include "tests/judge/record.h"
#include "tests/judge/reference/corners.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

#include <string.h>

static ToldTest *writing; // the test whose calls are written down; NULL while one is changed
static Wire arguments, answer;
static Resolution size; // of the image of the call

static struct {
    int call; // this one is changed; the others are as they were
    const Numbers *result;
} change = {.call = -1};
static int call_number;

static void fail(const char *why)
{
    fprintf(stderr, "%s: %s, %s\n", record_now()->function, record_now()->name, why);
    exit(1);
}

// To the last bit, because some results distinguish mistakes by small differences.
static bool are_equal(const Numbers *a, const Numbers *b)
{
    return a->count == b->count &&
           (a->count == 0 || memcmp(a->at, b->at, (size_t)a->count * sizeof *a->at) == 0);
}

static int which_result(ToldCall *call, Numbers *result)
{
    for (int i = 0; i < call->result_count; i++)
        if (are_equal(&call->results[i], result)) {
            numbers_free(result);
            return i;
        }
    call->results = told_grow(call->results, &call->result_count, sizeof *call->results);
    call->results[call->result_count - 1] = *result;
    return call->result_count - 1;
}

static int result_of(ToldCall *call, int exercise, AnyFunction *function)
{
    Numbers result = {0};
    answer_here(exercise, function, &arguments, &answer);
    if (!layout_read(exercises[exercise].results, &answer, &size, &result))
        fail("a result that tests/judge/numbers.c cannot read");
    return which_result(call, &result);
}

// The arguments that a student needs to know. Lines about the results that the test looks at are
// left out, because the table may look at others.
static char *given_lines(void)
{
    static const char *const looks[] = {"looking at\t", "seen\t", "seen along\t", "compared\t",
                                        "in order\t"};
    const char *line = record_now()->closed ? "" : record_now()->given;
    char *lines = calloc(1, strlen(line) + 1);
    while (lines != NULL && *line != '\0') {
        size_t length = strcspn(line, "\n") + 1;
        bool looked = false;
        for (size_t i = 0; i < sizeof looks / sizeof looks[0]; i++)
            looked = looked || strncmp(line, looks[i], strlen(looks[i])) == 0;
        if (!looked)
            strncat(lines, line, length);
        line += length;
    }
    return lines;
}

// A figure of a vector or a ray from the eye shows the image plane.
static void add_corners(ToldCall *call, const Exercise *exercise)
{
    Camera camera;
    vec3 corners[4];
    if (strncmp(exercise->arguments, "Camera", 6) != 0 ||
        (strcmp(exercise->results, "vec3") != 0 && strcmp(exercise->results, "Ray") != 0))
        return;
    arguments.read = 0;
    wire_get_value(&arguments, &type_Camera, &camera);
    reference_corners(camera, corners);
    for (int i = 0; i < 12; i++)
        numbers_add(&call->corners, corners[i / 3][i % 3]);
}

static void write_down(int exercise)
{
    writing->calls = told_grow(writing->calls, &writing->call_count, sizeof *writing->calls);
    ToldCall *call = &writing->calls[writing->call_count - 1];
    call->given = given_lines();
    if (!layout_read(exercises[exercise].arguments, &arguments, &size, &call->arguments))
        fail("arguments that tests/judge/numbers.c cannot read");
    add_corners(call, &exercises[exercise]);
    result_of(call, exercise, exercises[exercise].reference);
    const Mistake *const *mistakes = chosen_mistakes();
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++) {
            const Mistake *mistake = &mistakes[table][i];
            if (exercise_number(mistake->exercise) != exercise)
                continue;
            int which = result_of(call, exercise, mistake->answer);
            call->of_mistake =
                told_grow(call->of_mistake, &call->mistake_count, sizeof *call->of_mistake);
            call->of_mistake[call->mistake_count - 1] = which;
        }
}

static Wire *begin(int exercise)
{
    (void)exercise;
    wire_clear(&arguments);
    return &arguments;
}

static void write_down_and_answer(int exercise)
{
    if (writing != NULL)
        write_down(exercise);
    // The image's size is among the arguments.
    static Numbers ignored;
    arguments.read = 0;
    layout_read(exercises[exercise].arguments, &arguments, &size, &ignored);
    answer_here(exercise, exercises[exercise].reference, &arguments, &answer);
    if (writing == NULL && call_number++ == change.call) {
        wire_clear(&answer);
        layout_write(exercises[exercise].results, change.result, &size, &answer);
    }
}

static Wire *receive(int exercise)
{
    (void)exercise;
    return &answer;
}

void asked_begin(void)
{
    static const Transport asked = {begin, write_down_and_answer, receive, NULL};
    transport_use(&asked);
}

static bool passes(const ToldTest *test)
{
    static Outcomes one;
    if (test->probe)
        run_probes(exercise_number(test->function), test->name, &one);
    else
        run_tests(test->function, test->name, ANSWERS_APART, &one);
    bool passed = one.count == 1 && one.tests[0].passed;
    records_end();
    return passed;
}

bool asked_of(ToldTest *test)
{
    writing = test;
    bool passed = passes(test);
    writing = NULL;
    return passed;
}

bool asked_again(const ToldTest *test, int call, const Numbers *result)
{
    call_number = 0;
    change.call = call;
    change.result = result;
    return passes(test);
}
