// questions.c - the tests of a table ask its questions, and compare the answers with what is right.
//
// Known mistakes are recognised by their values in the table, not by running them.
#include "tests/judge/table.h"

#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"
#include "tests/judge/test.h"

#include <string.h>

static Table table;
static const Question *now;

const Question *question_now(void)
{
    return now;
}

// ---- expect ------------------------------------------------------------------------------------

static vec3 vec3_at(const Numbers *numbers, int i)
{
    return vec3_of(numbers->at[i], numbers->at[i + 1], numbers->at[i + 2]);
}

static Ray ray_of(const Numbers *numbers)
{
    return (Ray){vec3_at(numbers, 0), vec3_at(numbers, 3)};
}

// A value of this type, whose numbers begin here.
static void get_value(const Type *type, const Numbers *numbers, int from, void *value)
{
    Numbers rest = {.count = numbers->count, .at = numbers->at, .read = from};
    numbers_get(&rest, type, value);
}

// Numbers that are near enough are taken for the expected ones, so that only the others differ.
static const Numbers *as_expected(const Question *question, const Numbers *yours)
{
    static Numbers numbers;
    numbers_free(&numbers);
    numbers = numbers_copy(yours);
    for (int i = 0; i < question->within.count; i++)
        if (number_near(yours->at[i], question->expected.at[i], question->within.at[i]))
            numbers.at[i] = question->expected.at[i];
    return &numbers;
}

static void expect_value_at(const Type *type, const Numbers *yours, const Question *question,
                            int from)
{
    _Alignas(vec3) unsigned char y[TYPE_MOST_BYTES], e[TYPE_MOST_BYTES];
    get_value(type, yours, from, y);
    get_value(type, &question->expected, from, e);
    expect_value(type, y, e, 0, 1);
}

static Roots roots_of(const Numbers *numbers)
{
    return (Roots){(int)numbers->at[0], {numbers->at[1], numbers->at[2]}};
}

// The last line of what is given, in the place of that of an earlier expectation.
static void seen_as(const char *label, const char *what)
{
    Record *record = record_now();
    snprintf(record->given, sizeof record->given, "%s", now->given);
    record->closed = false;
    given(label, "%s", what);
}

static void looking_at(const char *what)
{
    seen_as("looking at", what);
}

static vec3 along_axes(const Camera *c, vec3 v)
{
    return vec3_of(vec3_dot(v, c->forward), vec3_dot(v, c->right), vec3_dot(v, c->up));
}

static void expect_along_axes(vec3 yours, vec3 expected, const Question *question)
{
    Camera c;
    get_value(&type_Camera, &question->arguments, 0, &c);
    seen_as("seen along", "forward, right, up");
    expect_vec3(along_axes(&c, yours), along_axes(&c, expected), question->tolerance);
}

// The right step, which is along the normal, or a multiple of it within the accepted limits.
static void expect_step(vec3 yours, const Question *question)
{
    vec3 from = vec3_at(&question->arguments, STEP_FROM);
    vec3 normal = vec3_at(&question->arguments, STEP_FROM + 3), moved = yours - from;
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    double tolerance = question->tolerance;
    char words[200];
    snprintf(words, sizeof words, "moved by %.24s to %.24s along the normal, and not to the side",
             number_text_to(question->least, 3).s, number_text_to(question->most, 3).s);
    expect_law(along >= question->least - tolerance && along <= question->most + tolerance &&
                   aside <= tolerance,
               words, "moved by %.40s along the normal, by %.40s to the side",
               number_text_to(along, 3).s, number_text_to(aside, 3).s);
}

// Any reason that the test accepts; then the camera, which must be unchanged if it is refused.
static void expect_fault_and_camera(const Numbers *yours, const Question *question)
{
    const Numbers *expected = &question->expected;
    int fault = (int)yours->at[0];
    if (fault < 0 || fault >= CAMERA_FAULTS || (question->reasons >> fault & 1) == 0)
        expect_fault((CameraFault)fault, (CameraFault)expected->at[0]);
    if (fault != CAMERA_OK)
        looking_at("*camera, which stays as it was");
    expect_value_at(&type_Camera, yours, question, 1);
}

static Image image_of(const Numbers *numbers, Resolution size)
{
    Image image;
    Message message;
    if (!image_create(&image, size, &message))
        ck_abort_msg("%s", message.text);
    for (int i = 0; i < 3 * size.width * size.height; i++)
        image.rgb[i] = (uint8_t)numbers->at[i];
    return image;
}

// The picture; then its depth, if it has one and the test looks at it.
static void expect_picture(int exercise, const Numbers *yours, const Question *question)
{
    static Image theirs, right; // freed by the next: a test that fails leaves by a jump
    Resolution size = image_size(exercise, &question->arguments);
    image_free(&theirs);
    image_free(&right);
    theirs = image_of(yours, size);
    right = image_of(&question->expected, size);
    expect_same_image(&theirs, &right);
    int bytes = 3 * size.width * size.height;
    for (int i = bytes; i < question->within.count; i++) {
        double expected = question->expected.at[i];
        if (yours->at[i] == expected || isinf(question->within.at[i]))
            continue;
        char place[60];
        snprintf(place, sizeof place, "the depth of column %d, row %d", (i - bytes) % size.width,
                 (i - bytes) / size.width);
        looking_at(place);
        expect_number(yours->at[i], expected, 0);
    }
}

// Of results that are several numbers: those that are compared together, and how they are called.
static const struct {
    const char *results, *label, *what;
    int from, count;
} parts[] = {
    {"double", NULL, NULL, 0, 1},
    {"vec3", NULL, NULL, 0, 3},
    {"Normalized", NULL, NULL, 0, 2},
    {"ScreenPoint", NULL, NULL, 0, 2},
    {"ScreenRectangle", "looking at", "left and right", 0, 2},
    {"ScreenRectangle", "looking at", "top and bottom", 2, 2},
    {"Ray", "looking at", "the origin", 0, 3},
    {"Ray", "looking at", "the direction", 3, 3},
    {"Quadratic", "in order", "a, b, c", 0, 3},
    {"Hit", "looking at", "t", 0, 1},
    {"Hit", "looking at", "the index of the sphere", 1, 1},
};

static bool expect_parts(const char *results, const Numbers *yours, const Numbers *expected)
{
    bool has_parts = false;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (strcmp(results, parts[i].results) != 0)
            continue;
        if (parts[i].label != NULL)
            seen_as(parts[i].label, parts[i].what);
        expect_numbers(yours->at + parts[i].from, expected->at + parts[i].from, parts[i].count, 0);
        has_parts = true;
    }
    return has_parts;
}

// A result must agree with the table, within the tolerances of its test. If it does not, both
// values are kept as text and the test ends.
static void expect_result(int exercise, const Question *question, const Numbers *answered)
{
    const char *results = exercises[exercise].results;
    const Numbers *expected = &question->expected, *yours = as_expected(question, answered);
    if (question->most > 0) {
        expect_step(vec3_at(answered, 0), question);
    } else if (question->is_seen_along_axes) {
        expect_along_axes(vec3_at(answered, 0), vec3_at(expected, 0), question);
    } else if (strcmp(results, "CameraFault Camera") == 0) {
        expect_fault_and_camera(yours, question);
    } else if (strcmp(results, "Ray") == 0 && question->length_is_free) {
        expect_same_ray(ray_of(answered), ray_of(expected), question->tolerance);
    } else if (strcmp(results, "Roots") == 0) {
        expect_roots(roots_of(yours), roots_of(expected), 0);
    } else if (strncmp(results, "Pixels", 6) == 0) {
        expect_picture(exercise, yours, question);
    } else if (!expect_parts(results, yours, expected)) {
        if (type_named(results) == NULL || !type_is_flat(type_named(results))) {
            fprintf(stderr, "tests/judge/questions.c does not know the results '%s'\n", results);
            exit(2);
        }
        expect_value_at(type_named(results), yours, question, 0);
    }
}

// ---- the questions -----------------------------------------------------------------------------

void questions_of_mistakes(void)
{
    table_load_mistakes(&table);
}

const Numbers *known_result(int exercise, int nth)
{
    static Numbers right;
    if (nth >= 0)
        return question_result(now, now->of_mistake[nth]);
    if (!has_reasons(exercise) || now->results[0].at[0] == CAMERA_OK)
        return &now->results[0];
    numbers_free(&right);
    right = numbers_copy(&now->results[0]);
    set_reasons(&right, now->reasons);
    return &right;
}

static void ask(int exercise, Numbers *yours)
{
    Numbers question = numbers_again(&now->arguments);
    Numbers *answer = transport_ask(exercise, &question);
    numbers_check(answer, exercises[exercise].results, now->results[0].count);
    numbers_clear(yours);
    numbers_add_all(yours, answer);
    transport_check(exercise, answer);
}

const Numbers *ask_again(int exercise)
{
    static Numbers yours;
    ask(exercise, &yours);
    return &yours;
}

// The last answer in each test.
static bool keeps_answers;
static Numbers kept[MOST_TESTS];

void keep_answers(bool on)
{
    keeps_answers = on;
}

static void keep_answer(const Numbers *answer)
{
    int test = record_number();
    if (!keeps_answers || test >= MOST_TESTS)
        return;
    numbers_clear(&kept[test]);
    if (answer != NULL)
        numbers_add_all(&kept[test], answer);
}

const Numbers *answer_of(int test)
{
    return kept[test].count > 0 ? &kept[test] : NULL;
}

static void ask_and_judge(int exercise, const Question *question)
{
    static Numbers yours;
    now = question;
    keep_answer(NULL);
    ask(exercise, &yours);
    keep_answer(&yours);
    suspects_hear(exercise, &question->arguments, &yours);
    law_check(exercise, question, &yours);
    if (!record_now()->probe)
        expect_result(exercise, question, &yours);
}

static void ask_all(int unused)
{
    (void)unused;
    Record *record = record_now();
    for (int i = 0; i < table.test_count; i++) {
        const TableTest *test = &table.tests[i];
        if (strcmp(test->function, record->function) != 0 || strcmp(test->name, record->name) != 0)
            continue;
        for (int k = 0; k < test->question_count; k++) {
            case_begins(k + 1);
            record->hidden = test->questions[k].hidden;
            snprintf(record->given, sizeof record->given, "%s", test->questions[k].given);
            ask_and_judge(exercise_number(test->function), &test->questions[k]);
        }
        return;
    }
}

static void list_tests(Stem *stem)
{
    ListedTest **tests = &stem->tests, **probes = &stem->probes;
    ListedTest *listed = calloc((size_t)table.test_count, sizeof *listed);
    TTest *asking = calloc((size_t)table.test_count, sizeof *asking);
    for (int i = 0; listed != NULL && asking != NULL && i < table.test_count; i++) {
        const TableTest *it = &table.tests[i];
        ListedTest ***list = it->probe ? &probes : &tests;
        asking[i] = (TTest){it->name, ask_all, __FILE__, 1};
        listed[i] = (ListedTest){it->function, &asking[i], it->extra, i, NULL};
        **list = &listed[i];
        *list = &listed[i].next;
    }
}

// A program that has the mistakes themselves (wrong.c) has those of the table.
static void list_mistakes(Stem *stem)
{
    for (int i = 0; i + 1 < table.mistake_count; i++)
        table.mistakes[i].next = &table.mistakes[i + 1];
    if (stem->known[WRONG_ANSWERS] == NULL && table.mistake_count > 0)
        stem->known[WRONG_ANSWERS] = table.mistakes;
}

static void load(void)
{
    Stem *stem = stem_named(chosen_stem()->name);
    table_load(stem->name, &table);
    list_tests(stem);
    list_mistakes(stem);
}

__attribute__((constructor)) static void load_when_chosen(void)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        stem_named(exercises[i].stem)->load = load;
}

// ---- of a test that has failed -----------------------------------------------------------------

const Question *question_of(const Record *record)
{
    table_load_mistakes(&table);
    for (int i = 0; i < table.test_count; i++) {
        const TableTest *test = &table.tests[i];
        if (strcmp(test->function, record->function) == 0 &&
            strcmp(test->name, record->name) == 0 && record->cases >= 1 &&
            record->cases <= test->question_count)
            return &test->questions[record->cases - 1];
    }
    return NULL;
}
