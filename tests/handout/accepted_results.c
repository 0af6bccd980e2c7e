// accepted_results.c - the results besides the reference's that a test accepts, found by asking it.
#include "tests/handout/accepted_results.h"

#include "tests/handout/test_recorder.h"

#include "common/camera.h"

#include <math.h>
#include <string.h>

// All numbers off by as much, every other one to the other side.
static bool accepts_off_by(const ToldTest *test, int call, double off)
{
    Numbers result = numbers_copy(&test->calls[call].results[0]);
    for (int i = 0; i < result.count; i++)
        result.at[i] += i % 2 == 0 ? off : -off;
    bool accepted = asked_again(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// From 1e-5 of the largest number down by halves. Never less than the difference between two ways
// to compute the same thing: a test may compare with this very answer (its own ray, for example),
// but the table compares with the reference's.
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
    Numbers result = numbers_copy(&test->calls[call].results[0]);
    int reasons = 0;
    for (int fault = 0; result.count > 0 && fault < CAMERA_FAULTS; fault++) {
        result.at[0] = fault;
        reasons |= asked_again(test, call, &result) ? 1 << fault : 0;
    }
    numbers_free(&result);
    return reasons | 1 << (int)test->calls[call].results[0].at[0];
}

static bool length_is_free(const ToldTest *test, int call)
{
    Numbers result = numbers_copy(&test->calls[call].results[0]);
    bool free = true;
    for (int i = 0; free && i < 2; i++) {
        for (int k = 3; k < result.count; k++)
            result.at[k] *= i == 0 ? 2 : 0.125;
        free = asked_again(test, call, &result);
    }
    numbers_free(&result);
    return free;
}

static bool accepts_step(const ToldTest *test, int call, double times)
{
    Numbers result = numbers_copy(&test->calls[call].results[0]);
    const double *from = test->calls[call].arguments.at + STEP_FROM;
    for (int i = 0; i < result.count; i++)
        result.at[i] = from[i] + times * (result.at[i] - from[i]);
    bool accepted = asked_again(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// By powers of 2, as in the contract.
static void steps_of(const ToldTest *test, int call, double *least, double *most)
{
    const double end = 256;
    *least = *most = 1;
    while (*least > 1 / end && accepts_step(test, call, *least / 2))
        *least /= 2;
    while (*most < end && accepts_step(test, call, *most * 2))
        *most *= 2;
}

void takes_for_right(ToldTest *test)
{
    const Exercise *exercise = &exercises[exercise_number(test->function)];
    const char *results = exercise->results;
    for (int i = 0; i < test->call_count; i++) {
        ToldCall *call = &test->calls[i];
        if (strcmp(results, "Ray") == 0)
            call->length_is_free = length_is_free(test, i);
        if (layout_is_step(exercise))
            steps_of(test, i, &call->least, &call->most);
        if (strncmp(results, "CameraFault", 11) == 0)
            call->reasons = reasons_of(test, i);
        if (strcmp(results, "Pixels") != 0 && strcmp(results, "CameraFault") != 0)
            call->tolerance = tolerance_of(test, i);
    }
}

void agree_on_lengths(Told *told)
{
    for (int i = 0; i < told->test_count; i++)
        for (int k = 0; k < told->tests[i].call_count; k++)
            for (int j = 0; !told->tests[i].calls[k].length_is_free && j < told->test_count; j++)
                for (int l = 0; l < told->tests[j].call_count; l++)
                    if (strcmp(told->tests[i].function, told->tests[j].function) == 0)
                        told->tests[j].calls[l].length_is_free = 0;
}
