// tell.c - makes the table of a stem from its tests, the reference and the mistakes.
//
//   PROGRAM FILE
//   PROGRAM --formulas    says what the mistakes compute, a line each: what no handout may hold
//
// First each test runs as it is, and its calls are written down. Then it runs again and again with
// one result changed a little, to find out what else it takes for right: the table is as strict
// as the test, and no tolerance is said twice.
#include "tests/told/here.h"
#include "tests/told/told.h"

#include "tests/judge/call.h"
#include "tests/judge/record.h"
#include "tests/judge/runner.h"

#include <math.h>
#include <string.h>

static Told told;
static Outcomes all, one;
static ToldTest *writing; // the test whose calls are written down; NULL while one is changed
static Wire arguments, answer;
static Resolution size; // of the image of the call

static struct {
    int call; // this one is changed; the others are as they were
    const Numbers *result;
} change;
static int call_number;

static void fail(const char *why)
{
    fprintf(stderr, "%s: %s, %s\n", record_now()->function, record_now()->name, why);
    exit(1);
}

static int which_result(ToldCall *call, Numbers *result)
{
    for (int i = 0; i < call->result_count; i++)
        if (numbers_same(&call->results[i], result)) {
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
    if (!layout_read(layouts[exercise].results, &answer, &size, &result))
        fail("a result that tests/told/layout.c cannot read");
    return which_result(call, &result);
}

// What a student needs to know of what goes in. What the test looks at is not what the table does.
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

static void write_down(int exercise)
{
    writing->calls = told_grow(writing->calls, &writing->call_count, sizeof *writing->calls);
    ToldCall *call = &writing->calls[writing->call_count - 1];
    call->given = given_lines();
    if (!layout_read(layouts[exercise].arguments, &arguments, &size, &call->arguments))
        fail("arguments that tests/told/layout.c cannot read");
    result_of(call, exercise, exercises[exercise].reference);
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

// ---- the other end of the pipe ------------------------------------------------------------------

Wire *call_begin(int exercise)
{
    (void)exercise;
    wire_clear(&arguments);
    return &arguments;
}

Wire *call_finish(int exercise)
{
    if (writing != NULL)
        write_down(exercise);
    // The image's size is among the arguments.
    static Numbers ignored;
    arguments.read = 0;
    layout_read(layouts[exercise].arguments, &arguments, &size, &ignored);
    answer_here(exercise, exercises[exercise].reference, &arguments, &answer);
    if (writing == NULL && call_number++ == change.call) {
        wire_clear(&answer);
        layout_write(layouts[exercise].results, change.result, &size, &answer);
    }
    return &answer;
}

void call_end(int exercise)
{
    (void)exercise;
}

// ---- what else the test takes for right ---------------------------------------------------------

static bool accepts(const ToldTest *test, int call, const Numbers *result)
{
    call_number = 0;
    change.call = call;
    change.result = result;
    run_tests(test->function, test->name, ANSWERS_APART, &one);
    bool passed = one.count == 1 && one.tests[0].passed;
    records_end();
    return passed;
}

static Numbers copy_of(const Numbers *numbers)
{
    Numbers copy = {0};
    for (int i = 0; i < numbers->count; i++)
        numbers_add(&copy, numbers->at[i]);
    return copy;
}

// All numbers off by as much, every other one to the other side.
static bool accepts_off_by(const ToldTest *test, int call, double off)
{
    Numbers result = copy_of(&test->calls[call].results[0]);
    for (int i = 0; i < result.count; i++)
        result.at[i] += i % 2 == 0 ? off : -off;
    bool accepted = accepts(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// From 1e-5 of the largest number down by halves. Never less than what two ways to compute the same
// thing may differ by: what a test holds against this very answer (its own ray, say) is held
// against the reference's by the table.
static double tolerance_of(const ToldTest *test, int call)
{
    enum { HALVES = 23 };
    const Numbers *result = &test->calls[call].results[0];
    double largest = 0;
    for (int i = 0; i < result->count; i++)
        if (isfinite(result->at[i]))
            largest = fmax(largest, fabs(result->at[i]));
    double most = 1e-5 * (largest > 0 ? largest : 1);
    int low = 0, high = HALVES;
    while (low < high) {
        int half = (low + high) / 2;
        double off = ldexp(most, -half);
        if (accepts_off_by(test, call, off) && accepts_off_by(test, call, -off))
            high = half;
        else
            low = half + 1;
    }
    return ldexp(most, -low);
}

static int reasons_of(const ToldTest *test, int call)
{
    Numbers result = copy_of(&test->calls[call].results[0]);
    int reasons = 0;
    for (int fault = 0; result.count > 0 && fault < CAMERA_FAULTS; fault++) {
        result.at[0] = fault;
        reasons |= accepts(test, call, &result) ? 1 << fault : 0;
    }
    numbers_free(&result);
    return reasons | 1 << (int)test->calls[call].results[0].at[0];
}

static bool length_is_free(const ToldTest *test, int call)
{
    Numbers result = copy_of(&test->calls[call].results[0]);
    bool free = true;
    for (int i = 0; free && i < 2; i++) {
        for (int k = 3; k < result.count; k++)
            result.at[k] *= i == 0 ? 2 : 0.125;
        free = accepts(test, call, &result);
    }
    numbers_free(&result);
    return free;
}

static void find_out(ToldTest *test)
{
    const char *results = layouts[exercise_number(test->function)].results;
    for (int i = 0; i < test->call_count; i++) {
        ToldCall *call = &test->calls[i];
        if (strcmp(results, "Ray") == 0)
            call->length_is_free = length_is_free(test, i);
        if (strncmp(results, "CameraFault", 11) == 0)
            call->reasons = reasons_of(test, i);
        if (strcmp(results, "Pixels") != 0 && strcmp(results, "CameraFault") != 0)
            call->tolerance = tolerance_of(test, i);
    }
}

// Where one test of the function wants the very direction, the others may not say otherwise.
static void agree_on_lengths(void)
{
    for (int i = 0; i < told.test_count; i++)
        for (int k = 0; k < told.tests[i].call_count; k++)
            for (int j = 0; !told.tests[i].calls[k].length_is_free && j < told.test_count; j++)
                for (int l = 0; l < told.tests[j].call_count; l++)
                    if (strcmp(told.tests[i].function, told.tests[j].function) == 0)
                        told.tests[j].calls[l].length_is_free = 0;
}

// ---- the table ----------------------------------------------------------------------------------

static void add_test(const Outcome *outcome)
{
    ToldTest test = {.function = (char *)outcome->function,
                     .name = (char *)outcome->name,
                     .extra = outcome->extra};
    writing = &test;
    run_tests(test.function, test.name, ANSWERS_APART, &one);
    bool passed = one.count == 1 && one.tests[0].passed;
    records_end();
    writing = NULL;
    if (!passed || test.call_count == 0) {
        fprintf(stderr, "%s: %s\n", test.name,
                passed ? "asks nothing" : "the reference does not pass");
        exit(1);
    }
    find_out(&test);
    told.tests = told_grow(told.tests, &told.test_count, sizeof *told.tests);
    told.tests[told.test_count - 1] = test;
}

static void add_mistake(const Mistake *mistake)
{
    told.mistakes = told_grow(told.mistakes, &told.mistake_count, sizeof *told.mistakes);
    told.mistakes[told.mistake_count - 1] =
        (ToldMistake){.function = (char *)mistake->exercise,
                      .why = (char *)mistake->why,
                      .picture = (char *)mistake->picture,
                      .digits = strncmp(mistake->id, "X-", 2) == 0};
}

static int say_formulas(void)
{
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            puts(mistakes[table][i].formula);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--formulas") == 0)
        return say_formulas();
    const char *slash = strrchr(argv[0], '/');
    FILE *file = argc == 2 ? fopen(argv[1], "wb") : NULL;
    if (file == NULL) {
        fprintf(stderr, "Usage: %s FILE\n", argv[0]);
        return 2;
    }
    switch_to_process(slash != NULL ? slash + 1 : argv[0]);
    change.call = -1;
    run_tests(NULL, NULL, ANSWERS_APART, &all);
    records_end();
    for (int i = 0; i < all.count; i++)
        add_test(&all.tests[i]);
    agree_on_lengths();
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            add_mistake(&mistakes[table][i]);
    bool written = told_write(file, &told);
    if (fclose(file) != 0 || !written) {
        perror(argv[1]);
        return 1;
    }
    return 0;
}
