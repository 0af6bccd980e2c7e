// matrix.c - are the tests strict, and do they know what they see?
//
//   matrix STEM
//   matrix STEM --missing     what an exercise of the stem still lacks
//   matrix STEM --verdicts    the verdict on every known answer, a line each (by_hand/record.py)
//   matrix STEM --formulas    the formulas of the mistakes, a line each: an archive must not have
//                             them
//   matrix STEM --by-heart F  answers that know the tables in the folder F, and nothing else
//
// Each mistake must fail a test of its function and be named from its values; each test must be
// failed by a mistake, or it cannot fail and is worth nothing; no exercise may lack what it needs;
// no right answer, however it is written, may fail or be accused. The verdict on a wrong answer
// that is not a known mistake must not be false (verdicts.c). An answer in float is told so. An
// answer that knows the public inputs by heart must fail with every SEED, and must not learn the
// hidden ones.
//
// JUDGE_TABLES is the folder of the tables that are asked (table.h).
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/numbers.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"
#include "tests/judge/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Outcomes all, some;
static bool failed_by_some[MOST_TESTS];
static int passed, failed, mistake_count, variant_count, unknown_count, pair_count, float_count,
    style_count;
static bool told; // whether a failed test of the last run may tell its numbers

static void settle(bool good, const char *what, const char *name, const char *why)
{
    if (!good)
        printf("not ok: %s %s: %s\n", what, name, why);
    *(good ? &passed : &failed) += 1;
}

// Of this number, to be shown: from its first that is not 0.
static int digits_of(const char *number, int length)
{
    int digits = 0;
    for (int i = 0; i < length && number[i] != 'e'; i++)
        digits += number[i] >= (digits == 0 ? '1' : '0') && number[i] <= '9';
    return digits;
}

// A difference shows in the digits that a tolerance allows, and rounding is not shown.
static void check_digits(const Outcome *test)
{
    enum { MOST = 13 };
    const char *both[] = {test->record->expected, test->record->yours};
    if (both[0][0] != '\0' && strcmp(both[0], both[1]) == 0)
        settle(false, "two sides that look the same:", test->name, both[0]);
    for (int side = 0; side < 2; side++)
        for (const char *at = both[side]; *at != '\0';) {
            int length = (int)strspn(at, "-0123456789.e");
            if (digits_of(at, length) > MOST)
                settle(false, "too many digits:", test->name, both[side]);
            at += length > 0 ? length : 1;
        }
}

// How many tests fail, of those that count (extra ones only on request).
static int run(const char *function, Outcomes *outcomes, bool extra)
{
    int count = 0;
    suspects_begin(function != NULL ? exercise_number(function) : -1);
    run_tests(function, NULL, ANSWERS_APART, outcomes);
    told = false;
    for (int i = 0; i < outcomes->count; i++) {
        const Outcome *test = &outcomes->tests[i];
        count += !test->passed && (extra || !test->extra);
        check_digits(test);
        told = told || (!test->passed && !test->record->hidden);
    }
    records_end();
    if (function != NULL) {
        static Outcomes probes;
        run_probes(function, NULL, &probes);
        records_end();
    }
    return count;
}

static void check_law(const char *what, const char *name, int exercise)
{
    const char *law = suspect_broke_law(exercise);
    settle(law == NULL, what, name, law == NULL ? "" : law);
}

// ---- who answers -------------------------------------------------------------------------------

// How the question in the message becomes the answer.
static void (*answer_message)(int exercise);
static Numbers message;

static Numbers *ask(int exercise, Numbers *question)
{
    numbers_clear(&message);
    numbers_add_all(&message, question);
    answer_message(exercise);
    message.read = 0;
    return &message;
}

static void refuse(int exercise)
{
    fprintf(stderr, "exercise %d: an answer that cannot be read\n", exercise);
    abort();
}

static void process_answers_by(void (*by)(int exercise))
{
    answer_message = by;
    transport_use(ask, refuse);
}

// The answer of a function replaces the question.
static void apply_to_message(int exercise, AnyFunction *answer)
{
    Numbers said = {0};
    message.read = 0;
    if (!apply(exercise, answer, &message, &said)) {
        fprintf(stderr, "a question that cannot be read\n");
        abort();
    }
    numbers_free(&message);
    message = said;
}

static void answer_right(int exercise)
{
    apply_to_message(exercise, exercises[exercise].reference);
}

// ---- what must hold ----------------------------------------------------------------------------

// With the reference everything must pass, or failing means nothing.
static void check_reference(void)
{
    process_answers_by(answer_right);
    settle(run(NULL, &all, true) == 0 && all.count > 0, "the reference", "",
           "does not pass all tests");
    for (int i = 0; exercises[i].name != NULL; i++)
        check_law("the reference breaks a law:", exercises[i].name, i);
}

static int count_of(const char *exercise)
{
    int count = 0;
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
        count += strcmp(it->exercise, exercise) == 0;
    return count;
}

// Of each pair of mistakes of a function, a test or a probe must tell the one from the other, or
// neither could be named.
static void check_mistake(const Mistake *mistake)
{
    bool extra = strncmp(mistake->id, "X-", 2) == 0;
    answer_here_by(mistake->answer);
    int caught = run(mistake->exercise, &some, extra);
    settle(caught > 0, "mistake fails no test:", mistake->id, mistake->formula);
    const Mistake *named = suspect(0, extra);
    const Mistake *other = suspect(1, extra);
    if (named == mistake)
        named = other; // nobody else, it should be
    else if (named == NULL)
        settle(false, "mistake is not recognised:", mistake->id, mistake->formula);
    pair_count += count_of(mistake->exercise) - 1; // each is seen from either side
    settle(named == NULL, "mistake looks like another:", mistake->id,
           named == NULL ? "" : named->id);
    for (int i = 0; i < some.count; i++)
        for (int j = 0; j < all.count && !some.tests[i].passed; j++)
            if (strcmp(all.tests[j].name, some.tests[i].name) == 0)
                failed_by_some[j] = true;
}

static bool is_declared(const Exercise *exercise)
{
    char path[1000], line[1000], call[200];
    snprintf(path, sizeof path, "exercises/%s.h", exercise->stem);
    snprintf(call, sizeof call, "%s(", exercise->name);
    FILE *file = fopen(path, "r");
    bool found = false;
    while (file != NULL && !found && fgets(line, sizeof line, file) != NULL)
        found = strncmp(line, "//", 2) != 0 && strstr(line, call) != NULL;
    if (file != NULL)
        fclose(file);
    return found;
}

// In words, the first thing that is missing, in the order of CONTRIBUTING's steps.
static bool missing_next(const Exercise *exercise, bool has_test, bool has_mistake, char *words,
                         size_t size)
{
    const char *stem = exercise->stem, *name = exercise->name;
    if (!is_declared(exercise))
        snprintf(words, size, "%s is not declared: the contract is exercises/%s.h", name, stem);
    else if (exercise->reference == NULL)
        snprintf(words, size, "%s has no solution: it belongs in solutions/%s.c", name, stem);
    else if (!has_test)
        snprintf(words, size, "%s has no graded test: TEST(%s, ...) in tests/%s.c", name, name,
                 stem);
    else if (!has_mistake)
        snprintf(words, size, "%s has no known mistake: they belong in tests/%s/wrong.c", name,
                 stem);
    else
        return false;
    return true;
}

// Does an exercise of the stem lack something, because it was just added?
static bool something_is_missing(const char *stem, char *words, size_t size)
{
    for (int i = 0; exercises[i].name != NULL; i++) {
        const char *name = exercises[i].name;
        bool has_test = false;
        for (int j = 0; j < all.count; j++)
            has_test =
                has_test || (!all.tests[j].extra && strcmp(all.tests[j].function, name) == 0);
        if (strcmp(exercises[i].stem, stem) == 0 &&
            missing_next(&exercises[i], has_test, count_of(name) > 0, words, size))
            return true;
    }
    return false;
}

static void check_variant(const KnownAnswer *variant)
{
    answer_here_by(variant->answer);
    int exercise = exercise_number(variant->exercise);
    settle(run(variant->exercise, &some, false) == 0, "right answer fails:", variant->exercise,
           variant->id);
    settle(suspect(0, false) == NULL, "right answer is accused:", variant->exercise, variant->id);
    settle(suspect_differs() == NULL,
           "an input that decides names leaves the result free:", variant->id, suspect_differs());
    check_law("right answer breaks a law:", variant->id, exercise);
}

// Of those that count; NULL if none has failed.
static const char *first_failed(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && !outcomes->tests[i].extra)
            return outcomes->tests[i].name;
    return NULL;
}

// The judge's verdict on an answer, in short.
static void say(char *words, size_t size, Diagnosis it)
{
    if (it.mistake == NULL)
        snprintf(words, size, NOBODY " %s", it.law == NULL ? "" : it.law);
    else if (it.other != NULL)
        snprintf(words, size, "%s and %s", it.mistake->id, it.other->id);
    else
        snprintf(words, size, "%s%s", it.mistake->id, it.in_part ? " in part" : "");
}

static void check_unknown(const KnownAnswer *unknown)
{
    char words[500];
    answer_here_by(unknown->answer);
    run_tests(unknown->exercise, NULL, ANSWERS_APART, &some);
    settle(first_failed(&some) != NULL, "wrong answer fails no test:", unknown->exercise,
           unknown->id);
    say(words, sizeof words, diagnose(exercise_number(unknown->exercise), false));
    records_end();
    bool is_named = strncmp(unknown->said, NOBODY, strlen(NOBODY)) != 0;
    settle(is_named ? strcmp(words, unknown->said) == 0
                    : strncmp(words, unknown->said, strlen(unknown->said)) == 0,
           unknown->exercise, unknown->id, words);
}

// The reference, rounded to float: the arguments before, or the results after.
static bool rounds_arguments;

static void round_message(void)
{
    for (int i = 0; i < message.count; i++)
        message.at[i] = (float)message.at[i];
}

static void answer_rounded(int exercise)
{
    if (rounds_arguments)
        round_message();
    answer_right(exercise);
    if (!rounds_arguments)
        round_message();
}

// Directions and steps of other lengths that the contract allows: a direction three times as long,
// or a step off a surface twice as long, if that is not too long.
static AnyFunction *stretched;

static void answer_stretched(int exercise)
{
    enum { RADIUS = 3, DIRECTION = 3 };
    Numbers arguments = numbers_copy(&message);
    apply_to_message(exercise, stretched);
    if (!layout_is_step(&exercises[exercise])) {
        for (int i = DIRECTION; i < message.count; i++)
            message.at[i] *= 3;
    } else {
        const double *from = arguments.at + STEP_FROM;
        double length = 0, extent = 0;
        for (int i = 0; i < RADIUS; i++) {
            length = hypot(length, message.at[i] - from[i]);
            extent = fmax(extent, fabs(arguments.at[i]));
        }
        extent += arguments.at[RADIUS];
        for (int i = 0; i < 3 && length >= 0x1p-32 * extent && length < 0x1p-29 * extent; i++)
            message.at[i] += message.at[i] - from[i];
    }
    numbers_free(&arguments);
}

// ---- mistakes in other styles ------------------------------------------------------------------

static void check_free_answer(const KnownAnswer *free)
{
    answer_here_by(free->answer);
    for (answer_style = 0; answer_style < chosen_stem()->styles; answer_style++) {
        run(free->exercise, &some, false);
        const char *test = first_failed(&some);
        settle(test == NULL, "right answer fails in another style:", free->exercise,
               test == NULL ? "" : test);
    }
    answer_style = 0;
}

// The same mistake has the same name in every style, if it is a mistake there.
static void check_styles(const Mistake *mistake)
{
    answer_here_by(mistake->answer);
    for (answer_style = 1; answer_style < chosen_stem()->styles; answer_style++) {
        if (run(mistake->exercise, &some, false) == 0)
            continue;
        const Mistake *named = suspect(0, false), *other = suspect(1, false);
        settle(named == mistake && other == NULL,
               "mistake has another name in another style:", mistake->id,
               named == NULL   ? "none"
               : other != NULL ? other->id
                               : named->id);
        style_count++;
    }
    answer_style = 0;
}

// Nor does the name depend on a length that is free.
static void check_lengths(const Mistake *mistake)
{
    int exercise = exercise_number(mistake->exercise);
    if (strcmp(mistake->exercise, "pixel_ray") != 0 && !layout_is_step(&exercises[exercise]))
        return;
    stretched = mistake->answer;
    process_answers_by(answer_stretched);
    if (run(mistake->exercise, &some, false) == 0)
        return;
    settle(suspect(0, false) == mistake && suspect(1, false) == NULL,
           "mistake has another name with another length:", mistake->id, mistake->formula);
    style_count++;
}

// ---- hard-coded answers ------------------------------------------------------------------------

static Table by_heart;
static int garbage; // each number of the answer to any other question

static const Question *known_by_heart(const char *function, const Numbers *arguments)
{
    for (int i = 0; i < by_heart.test_count; i++)
        for (int k = 0; k < by_heart.tests[i].question_count; k++)
            if (strcmp(by_heart.tests[i].function, function) == 0 &&
                numbers_same(&by_heart.tests[i].questions[k].arguments, arguments))
                return &by_heart.tests[i].questions[k];
    return NULL;
}

static void answer_by_heart(int exercise)
{
    const Question *question = known_by_heart(exercises[exercise].name, &question_now()->arguments);
    answer_right(exercise);
    for (int i = 0; question == NULL && i < message.count; i++)
        message.at[i] = garbage;
}

static int check_by_heart(const char *stem, const char *folder)
{
    setenv("JUDGE_TABLES", folder, 1);
    table_load(stem, &by_heart);
    process_answers_by(answer_by_heart);
    for (int i = 0; exercises[i].name != NULL; i++)
        for (garbage = 0; garbage <= 0xff && strcmp(exercises[i].stem, stem) == 0;
             garbage += 0xff) {
            settle(run(exercises[i].name, &some, false) > 0,
                   "a table of the public inputs is enough for", exercises[i].name, "");
            settle(!told, "hidden inputs may be shown:", exercises[i].name, "");
        }
    printf("by heart, %s: %d passed, %d failed\n", stem, passed, failed);
    return failed == 0 ? 0 : 1;
}

// ---- float -------------------------------------------------------------------------------------

// Of more than five digits, with a point; or three numbers in parentheses.
static bool has_a_number_twice(const char *words)
{
    char number[100];
    for (; *words != '\0'; words++) {
        size_t vector = *words == '(' ? strcspn(words, ")") : 0;
        int length = (int)(vector > 0 ? vector : strspn(words, "-0123456789.e"));
        if (length == 0 || length >= (int)sizeof number)
            continue;
        snprintf(number, sizeof number, "%.*s", length, words);
        words += length - 1;
        const char *same = strstr(words + 1, number);
        if (digits_of(number, length) > 5 && strchr(number, '.') != NULL && same != NULL &&
            (same[length] < '0' || same[length] > '9'))
            return true;
    }
    return false;
}

static bool has_probes(const char *function)
{
    static Outcomes probes;
    run_probes(function, NULL, &probes);
    return probes.count > 0;
}

// An answer that fails because it is rounded to float is told so, by a known mistake or otherwise,
// if the function has probes: a test ends with its first wrong result, so tests alone are few.
// False if it passes: then its results have no digits that a float loses.
static bool check_float(const char *function, bool arguments)
{
    rounds_arguments = arguments;
    process_answers_by(answer_rounded);
    suspects_begin(exercise_number(function));
    run_tests(function, NULL, ANSWERS_APART, &some);
    bool passes = first_failed(&some) == NULL;
    if (!passes && has_probes(function)) {
        const char *law = suspect_broke_law(exercise_number(function));
        settle(law == NULL || !has_a_number_twice(law), "nothing differs in", function, law);
        Diagnosis it = diagnose(exercise_number(function), false);
        const char *words = it.mistake != NULL ? it.mistake->why : it.law != NULL ? it.law : "";
        settle(strstr(words, "float") != NULL, "nothing is said of the float in", function, words);
        float_count++;
    }
    records_end();
    return passes;
}

static void check_floats(const char *stem)
{
    for (int i = 0; exercises[i].name != NULL; i++)
        if (strcmp(exercises[i].stem, stem) == 0 && !check_float(exercises[i].name, false))
            check_float(exercises[i].name, true);
}

// ---- the verdicts in words ---------------------------------------------------------------------

// In one line.
static void print_flat(const char *what, const char *words)
{
    printf("; %s ", what);
    for (; *words != '\0'; words++)
        putchar(*words == '\n' || *words == '\t' ? ' ' : *words);
}

static void print_verdict(const char *kind, const KnownAnswer *answer)
{
    const Outcome *first = NULL;
    char words[500];
    answer_here_by(answer->answer);
    run_tests(answer->exercise, NULL, ANSWERS_APART, &some);
    for (int i = some.count - 1; i >= 0; i--)
        if (!some.tests[i].passed && (first == NULL || !some.tests[i].extra))
            first = &some.tests[i];
    printf("%s %s, %s: %s", kind, answer->exercise, answer->id,
           first == NULL ? "passes" : first->name);
    if (first != NULL) {
        const Record *record = first->record;
        Diagnosis it = diagnose(exercise_number(answer->exercise), record->hidden);
        say(words, sizeof words, it);
        print_flat("given", record->given);
        print_flat("expected", record->expected);
        print_flat("yours", record->yours);
        print_flat("how", first->how);
        print_flat("is", words);
        if (it.mistake != NULL) {
            print_flat("formula", it.mistake->formula);
            print_flat("why", it.mistake->why);
            print_flat("picture", it.mistake->picture);
        }
    }
    putchar('\n');
    records_end();
}

static int print_verdicts(void)
{
    const char *const kinds[] = {"mistake", "variant", "unknown"};
    for (KindOfAnswer kind = WRONG_ANSWERS; kind <= UNNAMED_ANSWERS; kind++)
        for (const KnownAnswer *it = known_answers(kind); it != NULL; it = it->next)
            print_verdict(kinds[kind], it);
    return 0;
}

int main(int argc, char **argv)
{
    const char *stem = argc > 1 ? argv[1] : NULL, *option = argc >= 3 ? argv[2] : "";
    choose_stem(stem);
    if (strcmp(option, "--verdicts") == 0)
        return print_verdicts();
    if (strcmp(option, "--by-heart") == 0 && argc == 4)
        return check_by_heart(stem, argv[3]);
    if (strcmp(option, "--formulas") == 0) {
        for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next)
            puts(it->formula);
        return 0;
    }
    check_reference();
    char words[500];
    bool lacks = something_is_missing(stem, words, sizeof words);
    if (strcmp(option, "--missing") == 0) {
        if (lacks)
            printf("Next: %s\n", words);
        else
            printf("%s: no exercise lacks anything\n", stem);
        return lacks;
    }
    settle(!lacks, "next:", stem, words);
    if (lacks) {
        printf("matrix of %s: %d passed, %d failed\n", stem, passed, failed);
        return 1;
    }
    for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next) {
        check_mistake(it);
        check_styles(it);
        check_lengths(it);
        mistake_count++;
    }
    for (const KnownAnswer *it = known_answers(FREE_ANSWERS); it != NULL; it = it->next)
        check_free_answer(it);
    for (int i = 0; i < all.count; i++)
        settle(failed_by_some[i], "test", all.tests[i].name, "no mistake fails it");
    for (const KnownAnswer *it = known_answers(RIGHT_ANSWERS); it != NULL; it = it->next) {
        check_variant(it);
        variant_count++;
    }
    for (const KnownAnswer *it = known_answers(UNNAMED_ANSWERS); it != NULL; it = it->next) {
        check_unknown(it);
        unknown_count++;
    }
    check_floats(stem);
    printf("+ %d known mistakes\n+ %d pairs of them told apart\n+ %d tests\n+ %d right "
           "answers\n+ %d unknown mistakes\n+ %d answers in float\n+ %d mistakes in another "
           "style\n",
           mistake_count, pair_count / 2, all.count, variant_count, unknown_count, float_count,
           style_count);
    printf("matrix of %s: %d passed, %d failed\n", stem, passed, failed);
    return failed == 0 ? 0 : 1;
}
