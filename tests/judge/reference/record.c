// record.c - makes the table of a stem (table.h) from its tests, the reference and the mistakes.
//
//   record STEM FILE [--without-formulas]    for those who must not read how others are wrong
//
// First each test runs as it is, and its calls are written down. Then it runs again and again with
// one result changed a little, to find out which other results it accepts: the table is as strict
// as the test, and each tolerance is written in one place. With a SEED in the environment the
// random numbers of the tests are others, and hidden (test.h).
#include "common/camera.h"
#include "tests/judge/known.h"
#include "tests/judge/law.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"
#include "tests/judge/switchboard.h"
#include "tests/judge/table.h"

#include <math.h>
#include <string.h>

// ---- the calls of a test, and the test again with other results --------------------------------

static TableTest *writing; // the test whose calls are written down; NULL while one is changed
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

static int which_result(Question *call, Numbers *result)
{
    for (int i = 0; i < call->result_count; i++)
        if (are_equal(&call->results[i], result)) {
            numbers_free(result);
            return i;
        }
    call->results = table_grow(call->results, &call->result_count, sizeof *call->results);
    call->results[call->result_count - 1] = *result;
    return call->result_count - 1;
}

// A camera that is refused is so for all the reasons that the function has in one style or another
// (known.h).
static Numbers result_of(int exercise, AnyFunction *function)
{
    static Wire wire;
    Numbers result = {0}, other = {0};
    int reasons = 0;
    bool refused = true;
    for (answer_style = 0; answer_style == 0 || (refused && answer_style < chosen_stem()->styles);
         answer_style++) {
        Numbers *numbers = answer_style == 0 ? &result : &other;
        arguments.read = 0;
        wire_clear(&wire);
        numbers->count = 0;
        if (!apply(exercise, function, &arguments, &wire) ||
            !layout_read(exercises[exercise].results, &wire, &size, numbers))
            fail("a result that tests/judge/numbers.c cannot read");
        reasons |= reasons_in(numbers);
        refused = has_reasons(exercise) && result.at[0] != CAMERA_OK;
    }
    answer_style = 0;
    if (refused)
        set_reasons(&result, reasons & ~(1 << CAMERA_OK));
    numbers_free(&other);
    return result;
}

static int number_of_result(Question *call, int exercise, AnyFunction *function)
{
    Numbers result = result_of(exercise, function);
    return which_result(call, &result);
}

// That returns every right result, in one style or another.
static AnyFunction *right_function(int exercise)
{
    for (const KnownAnswer *it = known_answers(FREE_ANSWERS); it != NULL; it = it->next)
        if (strcmp(it->exercise, exercises[exercise].name) == 0)
            return it->answer;
    return exercises[exercise].reference;
}

static int right_reasons(int exercise)
{
    Numbers right = result_of(exercise, right_function(exercise));
    int reasons = reasons_in(&right);
    numbers_free(&right);
    return reasons;
}

// ---- what the laws need to know: tests/NN-stem/facts.c, in the place of the laws ---------------

static Question *telling;

void fact(double x)
{
    numbers_add(&telling->facts, x);
}

bool law_begin(void)
{
    return true;
}

static void add_facts(int exercise, Question *question)
{
    telling = question;
    if (!writing->probe && !writing->extra)
        law_check(exercise, question, &question->results[0]);
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

typedef vec3 PlaneVector(Camera camera, double s, double t);

// A figure of a vector or a ray from the eye shows the image plane.
static void add_corners(Question *call, const Exercise *exercise)
{
    static const double places[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    Camera camera;
    if (strncmp(exercise->arguments, "Camera", 6) != 0 ||
        (strcmp(exercise->results, "vec3") != 0 && strcmp(exercise->results, "Ray") != 0))
        return;
    arguments.read = 0;
    wire_get_value(&arguments, &type_Camera, &camera);
    PlaneVector *vector = (PlaneVector *)exercises[exercise_number("image_plane_vector")].reference;
    for (int i = 0; i < 12; i++)
        numbers_add(&call->corners, vector(camera, places[i / 3][0], places[i / 3][1])[i % 3]);
}

static void write_down(int exercise)
{
    writing->questions =
        table_grow(writing->questions, &writing->question_count, sizeof *writing->questions);
    Question *call = &writing->questions[writing->question_count - 1];
    call->given = given_lines();
    call->hidden = record_now()->hidden;
    if (call->given == NULL || (call->given[0] == '\0' && !writing->probe))
        fail("it calls the function before it names the arguments: nobody would see them");
    if (!layout_read(exercises[exercise].arguments, &arguments, &size, &call->arguments))
        fail("arguments that tests/judge/numbers.c cannot read");
    add_corners(call, &exercises[exercise]);
    number_of_result(call, exercise, exercises[exercise].reference);
    add_facts(exercise, call);
    if (has_reasons(exercise))
        call->reasons = right_reasons(exercise);
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next) {
        if (exercise_number(it->exercise) != exercise)
            continue;
        int which = number_of_result(call, exercise, it->answer);
        call->of_mistake =
            table_grow(call->of_mistake, &call->mistake_count, sizeof *call->of_mistake);
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

// From now on the reference answers, and its calls are recorded.
static void asked_begin(void)
{
    static const Transport asked = {begin, write_down_and_answer, receive, NULL};
    transport_use(&asked);
}

static bool passes(const TableTest *test)
{
    static Outcomes one;
    if (test->probe)
        run_probes(test->function, test->name, &one);
    else
        run_tests(test->function, test->name, ANSWERS_APART, &one);
    bool passed = one.count == 1 && one.tests[0].passed;
    records_end();
    return passed;
}

// Runs the test, and records its calls: the arguments, and the results of the reference and of each
// mistake. False if the reference does not pass.
static bool asked_of(TableTest *test)
{
    writing = test;
    bool passed = passes(test);
    writing = NULL;
    return passed;
}

// Runs it again with another result of one of its calls. True if it passes.
static bool asked_again(const TableTest *test, int call, const Numbers *result)
{
    call_number = 0;
    change.call = call;
    change.result = result;
    return passes(test);
}

// ---- which other results a test accepts --------------------------------------------------------

// All numbers off by as much, every other one to the other side.
static bool accepts_off_by(const TableTest *test, int call, double off)
{
    Numbers result = numbers_copy(&test->questions[call].results[0]);
    for (int i = 0; i < result.count; i++)
        result.at[i] += i % 2 == 0 ? off : -off;
    bool accepted = asked_again(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// From 1e-5 of the largest number down by halves. Never less than the difference between two ways
// to compute the same thing: a test may compare with this very answer (its own ray, for example),
// but the table compares with the reference's.
static double tolerance_of(const TableTest *test, int call)
{
    enum { HALVES = 23 };
    const Numbers *result = &test->questions[call].results[0];
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

static int reasons_of(const TableTest *test, int call)
{
    Numbers result = numbers_copy(&test->questions[call].results[0]);
    int reasons = 0;
    for (int fault = 0; result.count > 0 && fault < CAMERA_FAULTS; fault++) {
        result.at[0] = fault;
        reasons |= asked_again(test, call, &result) ? 1 << fault : 0;
    }
    numbers_free(&result);
    return reasons | 1 << (int)test->questions[call].results[0].at[0];
}

static bool length_is_free(const TableTest *test, int call)
{
    Numbers result = numbers_copy(&test->questions[call].results[0]);
    bool free = true;
    for (int i = 0; free && i < 2; i++) {
        for (int k = 3; k < result.count; k++)
            result.at[k] *= i == 0 ? 2 : 0.125;
        free = asked_again(test, call, &result);
    }
    numbers_free(&result);
    return free;
}

static bool accepts_step(const TableTest *test, int call, double times)
{
    Numbers result = numbers_copy(&test->questions[call].results[0]);
    const double *from = test->questions[call].arguments.at + STEP_FROM;
    for (int i = 0; i < result.count; i++)
        result.at[i] = from[i] + times * (result.at[i] - from[i]);
    bool accepted = asked_again(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// A test of the picture alone does not look at the depth.
static bool accepts_any_depth(const TableTest *test, int call, const char *results)
{
    if (strcmp(results, "Pixels Doubles") != 0)
        return false;
    Numbers result = numbers_copy(&test->questions[call].results[0]);
    for (int i = 3 * result.count / 4; i < result.count; i++)
        result.at[i] = -1;
    bool accepted = asked_again(test, call, &result);
    numbers_free(&result);
    return accepted;
}

// By powers of 2, as in the contract.
static void steps_of(const TableTest *test, int call, double *least, double *most)
{
    const double end = 256;
    *least = *most = 1;
    while (*least > 1 / end && accepts_step(test, call, *least / 2))
        *least /= 2;
    while (*most < end && accepts_step(test, call, *most * 2))
        *most *= 2;
}

// Asks it again and again with one result changed a little: tolerance, reasons, free length.
static void takes_for_right(TableTest *test)
{
    const Exercise *exercise = &exercises[exercise_number(test->function)];
    const char *results = exercise->results;
    for (int i = 0; i < test->question_count; i++) {
        Question *call = &test->questions[i];
        if (strcmp(results, "Ray") == 0)
            call->length_is_free = length_is_free(test, i);
        if (layout_is_step(exercise))
            steps_of(test, i, &call->least, &call->most);
        if (strncmp(results, "CameraFault", 11) == 0)
            call->reasons = reasons_of(test, i);
        if (strcmp(results, "Pixels") != 0 && strcmp(results, "CameraFault") != 0)
            call->tolerance =
                accepts_any_depth(test, i, results) ? INFINITY : tolerance_of(test, i);
    }
}

// If one test of a function requires the exact length of a direction, the others must require it as
// well.
static void agree_on_lengths(Table *table)
{
    for (int i = 0; i < table->test_count; i++)
        for (int k = 0; k < table->tests[i].question_count; k++)
            for (int j = 0; !table->tests[i].questions[k].length_is_free && j < table->test_count;
                 j++)
                for (int l = 0; l < table->tests[j].question_count; l++)
                    if (strcmp(table->tests[i].function, table->tests[j].function) == 0)
                        table->tests[j].questions[l].length_is_free = 0;
}

static Table table;
static Outcomes all;

static void record_test(const Outcome *outcome, bool probe)
{
    TableTest test = {.function = (char *)outcome->function,
                      .name = (char *)outcome->name,
                      .extra = outcome->extra,
                      .probe = probe};
    bool passed = asked_of(&test);
    if (!passed || test.question_count == 0) {
        fprintf(stderr, "%s: %s\n", test.name,
                passed ? "asks nothing" : "the reference does not pass");
        exit(1);
    }
    if (!probe)
        takes_for_right(&test);
    table.tests = table_grow(table.tests, &table.test_count, sizeof *table.tests);
    table.tests[table.test_count - 1] = test;
}

static void add_probes(int exercise)
{
    static Outcomes probes;
    run_probes(exercises[exercise].name, NULL, &probes);
    records_end();
    for (int i = 0; i < probes.count; i++)
        record_test(&probes.tests[i], true);
}

static void add_mistake(const Mistake *mistake, bool with_formula)
{
    table.mistakes = table_grow(table.mistakes, &table.mistake_count, sizeof *table.mistakes);
    table.mistakes[table.mistake_count - 1] =
        (TableMistake){.function = (char *)mistake->exercise,
                       .id = (char *)mistake->id,
                       .formula = with_formula ? (char *)mistake->formula : "",
                       .why = (char *)mistake->why,
                       .picture = (char *)mistake->picture};
}

int main(int argc, char **argv)
{
    bool with_formulas = argc == 3;
    if (argc != 3 && (argc != 4 || strcmp(argv[3], "--without-formulas") != 0)) {
        fprintf(stderr, "Usage: %s STEM FILE [--without-formulas]\n", argv[0]);
        return 2;
    }
    choose_stem(argv[1]);
    switch_to_process(argv[1]);
    asked_begin();
    run_tests(NULL, NULL, ANSWERS_APART, &all);
    records_end();
    for (int i = 0; i < all.count; i++)
        record_test(&all.tests[i], false);
    agree_on_lengths(&table);
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, argv[1]) == 0)
            add_probes(i);
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
        add_mistake(it, with_formulas);
    return table_write(argv[2], &table) ? 0 : 1;
}
