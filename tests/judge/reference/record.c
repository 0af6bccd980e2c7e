// record.c - makes the table of a stem (table.h) from its tests, the reference and the mistakes.
//
//   record STEM FILE [--without-formulas]    for those who must not read how others are wrong
//
// Each test runs once. Its calls are written down, and what it expects of them, so that the table
// accepts what the test accepts. With a SEED in the environment the random numbers of the tests are
// others, and hidden (test.h).
#include "common/camera.h"
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"
#include "tests/judge/table.h"
#include "tests/judge/test.h"

#include <math.h>
#include <string.h>

// ---- the calls of a test -----------------------------------------------------------------------

static TableTest *writing; // the test whose calls are written down
static Numbers arguments, answer;

static void refuse(const char *why)
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
    Numbers result = {0}, other = {0};
    int reasons = 0;
    bool refused = true;
    for (answer_style = 0; answer_style == 0 || (refused && answer_style < chosen_stem()->styles);
         answer_style++) {
        Numbers *numbers = answer_style == 0 ? &result : &other;
        answer_here(exercise, function, &arguments, numbers);
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
    NUMBERS_GET(&arguments, Camera, camera);
    PlaneVector *vector = (PlaneVector *)exercises[exercise_number("image_plane_vector")].reference;
    for (int i = 0; i < 12; i++)
        numbers_add(&call->corners, vector(camera, places[i / 3][0], places[i / 3][1])[i % 3]);
}

// ---- what is expected of them ------------------------------------------------------------------

// Of two ways to compute the same thing, relative to the number; and what is expected of a number
// that a test does not look at.
static const double rounding = 1.2e-12, unseen = 1e-5;

static struct {
    int count;
    int *case_of;     // each question of the test
    double *fallback; // the tolerance for its numbers that were not compared as they are
} open;

static void open_question(Question *question)
{
    int count = open.count;
    open.case_of = table_grow(open.case_of, &count, sizeof *open.case_of);
    open.fallback = table_grow(open.fallback, &open.count, sizeof *open.fallback);
    open.case_of[count - 1] = record_now()->cases;
    open.fallback[count - 1] = NAN;
    question->expected = numbers_copy(&question->results[0]);
    for (int i = 0; i < question->expected.count; i++)
        numbers_add(&question->within, NAN);
    question->tolerance = NAN;
}

// Where the numbers that were compared are in the result, if possible where none was compared yet.
static int place_in(const Question *question, const Expectation *it)
{
    const Numbers *right = &question->results[0];
    int first = -1;
    bool has_depth =
        strcmp(exercises[exercise_number(writing->function)].results, "Pixels Doubles") == 0;
    int bytes = has_depth ? right->count / 4 * 3 : 0;
    for (int i = bytes; i + it->count <= right->count; i++) {
        if (memcmp(right->at + i, it->yours, (size_t)it->count * sizeof *right->at) != 0)
            continue;
        if (isnan(question->within.at[i]))
            return i;
        first = first < 0 ? i : first;
    }
    return first;
}

static double largest_of(const Numbers *numbers)
{
    double largest = 0;
    for (int i = 0; i < numbers->count; i++)
        if (isfinite(numbers->at[i]))
            largest = fmax(largest, fabs(numbers->at[i]));
    return largest;
}

static void expect_here(Question *question, int place, const Expectation *it)
{
    double largest = largest_of(&(Numbers){.count = it->count, .at = (double *)it->expected});
    for (int i = 0; i < it->count; i++) {
        double *within = &question->within.at[place + i];
        *within = fmin(*within, fmax(it->tolerance, rounding * largest));
        question->expected.at[place + i] = it->expected[i];
    }
}

static void expect_of_case(const Expectation *it)
{
    bool placed = it->count == 0;
    if (writing == NULL || open.count == 0)
        return;
    int last = open.case_of[open.count - 1];
    for (int i = open.count - 1; i >= 0 && open.case_of[i] == last; i--) {
        Question *question = &writing->questions[i];
        int place = placed ? -1 : place_in(question, it);
        if (place >= 0)
            expect_here(question, place, it);
        else if (it->count > 0 || it->tolerance > 0)
            open.fallback[i] = fmin(open.fallback[i], it->tolerance);
        placed = placed || place >= 0;
        question->reasons = it->reasons != 0 ? it->reasons : question->reasons;
        question->length_is_free = question->length_is_free || it->any_length;
        question->least = fmax(question->least, it->least);
        question->most = fmax(question->most, it->most);
        question->is_seen_along_axes = strstr(record_now()->given, "seen along\t") != NULL;
    }
}

// A picture's bytes are exact. A test that does not look at the depth takes any.
static void close_picture(Question *question)
{
    Numbers *within = &question->within;
    bool is_seen = false;
    for (int i = 0; i < within->count; i++) {
        is_seen = is_seen || !isnan(within->at[i]);
        if (isnan(within->at[i]))
            within->at[i] = i < within->count / 4 * 3 ? 0 : INFINITY;
    }
    if (!is_seen)
        numbers_free(within);
}

static void close_question(Question *question, double fallback)
{
    const Numbers *expected = &question->expected;
    double largest = largest_of(expected);
    bool is_seen = !isnan(fallback);
    for (int i = 0; i < expected->count; i++) {
        double *within = &question->within.at[i];
        question->tolerance = fmin(question->tolerance, *within);
        if (isnan(*within))
            *within = fmax(is_seen ? fallback : unseen * fabs(expected->at[i]), rounding * largest);
    }
    if (isnan(question->tolerance))
        question->tolerance = is_seen ? fmax(fallback, rounding * largest) : unseen * largest;
}

static void close_questions(TableTest *test)
{
    const char *results = exercises[exercise_number(test->function)].results;
    for (int i = 0; i < open.count; i++)
        if (strncmp(results, "Pixels", 6) == 0)
            close_picture(&test->questions[i]);
        else
            close_question(&test->questions[i], open.fallback[i]);
    open.count = 0;
}

// A freedom of the contract, which a test need not use.
static void agree_on_lengths(Table *it)
{
    for (int i = 0; i < it->test_count; i++)
        for (int k = 0; k < it->tests[i].question_count; k++)
            for (int j = 0; it->tests[i].questions[k].length_is_free && j < it->test_count; j++)
                for (int l = 0; l < it->tests[j].question_count; l++)
                    if (strcmp(it->tests[i].function, it->tests[j].function) == 0)
                        it->tests[j].questions[l].length_is_free = 1;
}

// ---- running the tests -------------------------------------------------------------------------

static void write_down(int exercise)
{
    writing->questions =
        table_grow(writing->questions, &writing->question_count, sizeof *writing->questions);
    Question *call = &writing->questions[writing->question_count - 1];
    call->given = given_lines();
    call->hidden = record_now()->hidden;
    if (call->given == NULL || (call->given[0] == '\0' && !writing->probe))
        refuse("it calls the function before it names the arguments: nobody would see them");
    call->arguments = numbers_copy(&arguments);
    add_corners(call, &exercises[exercise]);
    number_of_result(call, exercise, exercises[exercise].reference);
    add_facts(exercise, call);
    open_question(call);
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

// A test may call other functions to find out more.
static Numbers *write_down_and_answer(int exercise, Numbers *question)
{
    numbers_clear(&arguments);
    numbers_add_all(&arguments, question);
    if (writing != NULL && strcmp(writing->function, exercises[exercise].name) == 0)
        write_down(exercise);
    answer_here(exercise, exercises[exercise].reference, &arguments, &answer);
    return &answer;
}

// From now on the reference answers, and its calls are recorded.
static void begin_to_listen(const char *stem)
{
    transport_use(write_down_and_answer, NULL);
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, stem) == 0)
            answer_by(i, NULL);
    expectation_listener = expect_of_case;
}

// Runs the test, and records its calls: the arguments, and the results of the reference and of each
// mistake. False if the reference does not pass.
static bool passes(TableTest *test)
{
    static Outcomes one;
    writing = test;
    if (test->probe)
        run_probes(test->function, test->name, &one);
    else
        run_tests(test->function, test->name, ANSWERS_APART, &one);
    close_questions(test);
    writing = NULL;
    bool passed = one.count == 1 && one.tests[0].passed;
    records_end();
    return passed;
}

static Table table;
static Outcomes all;

static void record_test(const Outcome *outcome, bool probe)
{
    TableTest test = {.function = outcome->function,
                      .name = outcome->name,
                      .extra = outcome->extra,
                      .probe = probe};
    bool passed = passes(&test);
    if (!passed || test.question_count == 0) {
        fprintf(stderr, "%s: %s\n", test.name,
                passed ? "asks nothing" : "the reference does not pass");
        exit(1);
    }
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
    table.mistakes[table.mistake_count - 1] = *mistake;
    if (!with_formula)
        table.mistakes[table.mistake_count - 1].formula = "";
}

int main(int argc, char **argv)
{
    bool with_formulas = argc == 3;
    if (argc != 3 && (argc != 4 || strcmp(argv[3], "--without-formulas") != 0)) {
        fprintf(stderr, "Usage: %s STEM FILE [--without-formulas]\n", argv[0]);
        return 2;
    }
    choose_stem(argv[1]);
    begin_to_listen(argv[1]);
    run_tests(NULL, NULL, ANSWERS_APART, &all);
    records_end();
    for (int i = 0; i < all.count; i++)
        record_test(&all.tests[i], false);
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, argv[1]) == 0)
            add_probes(i);
    agree_on_lengths(&table);
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
        add_mistake(it, with_formulas);
    return table_write(argv[2], &table) ? 0 : 1;
}
