// matrix.c - are the tests strict, and do they know what they see?
//
//   matrix STEM
//   matrix STEM --missing     what an exercise of the stem still lacks
//   matrix STEM --composed    only mistakes that are seen through another function
//
// Each mistake must fail a test of its function and be named from its values; each test must be
// failed by a mistake, or it cannot fail and is worth nothing; no exercise may lack what it needs
// (missing.h); no right answer, however it is
// written, may fail or be accused. The verdict on a wrong answer that is not a known mistake must
// not be false (unknown.c), nor that on an answer whose mistake is in another function
// (composed.c). A table of the public inputs must fail with every SEED, and must not learn the
// hidden inputs.
#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"
#include "tests/proof/composed.h"
#include "tests/proof/memorised_answers.h"
#include "tests/proof/missing.h"
#include "tests/proof/unknown.h"
#include "tests/proof/variants.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Outcomes all, some;
static bool failed_by_some[MOST_TESTS];
static int passed, failed, mistake_count, variant_count, unknown_count, pair_count, part_count;
static bool told; // whether a failed test of the last run may tell its numbers

static void settle(bool good, const char *what, const char *name, const char *why)
{
    if (!good)
        printf("not ok: %s %s: %s\n", what, name, why);
    *(good ? &passed : &failed) += 1;
}

// How many tests fail, of those that count (extra ones only on request).
static int run(const char *function, Outcomes *outcomes, bool extra)
{
    int count = 0;
    suspects_begin();
    run_tests(function, NULL, ANSWERS_APART, outcomes);
    told = false;
    for (int i = 0; i < outcomes->count; i++) {
        const Outcome *test = &outcomes->tests[i];
        count += !test->passed && (extra || !test->extra);
        told = told || (!test->passed && !test->record->hidden);
    }
    records_end();
    if (function != NULL) {
        static Outcomes probes;
        run_probes(exercise_number(function), NULL, &probes);
        records_end();
    }
    return count;
}

static void check_law(const char *what, const char *name, int exercise)
{
    const char *law = suspect_broke_law(exercise, true);
    settle(law == NULL, what, name, law == NULL ? "" : law);
}

// With the reference everything must pass, or failing means nothing.
static void check_reference(void)
{
    switch_to_reference();
    settle(run(NULL, &all, true) == 0 && all.count > 0, "the reference", "",
           "does not pass all tests");
    for (int i = 0; exercises[i].name != NULL; i++)
        check_law("the reference breaks a law:", exercises[i].name, i);
}

static int count_of(const char *exercise)
{
    const Mistake *const *mistakes = chosen_mistakes();
    int count = 0;
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++)
            count += strcmp(mistakes[table][i].exercise, exercise) == 0;
    return count;
}

// Of each pair of mistakes of a function, a test or a probe must tell the one from the other, or
// neither could be named.
static void check_mistake(const Mistake *mistake)
{
    bool extra = strncmp(mistake->id, "X-", 2) == 0;
    switch_to_reference();
    switch_one(mistake->exercise, mistake->answer);
    int exercise = exercise_number(mistake->exercise);
    int caught = run(mistake->exercise, &some, extra);
    settle(caught > 0, "mistake fails no test:", mistake->id, mistake->formula);
    const Mistake *named = suspect(exercise, 0, extra);
    const Mistake *other = suspect(exercise, 1, extra);
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

static void check_variant(const Variant *variant)
{
    switch_to_reference();
    switch_one(variant->exercise, variant->answer);
    int exercise = exercise_number(variant->exercise);
    settle(run(variant->exercise, &some, false) == 0, "right answer fails:", variant->exercise,
           variant->what);
    settle(suspect(exercise, 0, false) == NULL, "right answer is accused:", variant->exercise,
           variant->what);
    check_law("right answer breaks a law:", variant->what, exercise);
}

static bool passes_all(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && !outcomes->tests[i].extra)
            return false;
    return true;
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

static void check_unknown(const Unknown *unknown)
{
    char words[500];
    switch_to_reference();
    switch_one(unknown->exercise, unknown->answer);
    run_tests(unknown->exercise, NULL, ANSWERS_APART, &some);
    settle(!passes_all(&some), "wrong answer fails no test:", unknown->exercise, unknown->what);
    say(words, sizeof words, diagnose(exercise_number(unknown->exercise), false));
    records_end();
    bool is_named = strncmp(unknown->said, NOBODY, strlen(NOBODY)) != 0;
    settle(is_named ? strcmp(words, unknown->said) == 0
                    : strncmp(words, unknown->said, strlen(unknown->said)) == 0,
           unknown->exercise, unknown->what, words);
}

// ---- mistakes of other functions of the chapter -------------------------------------------------

// How a mistake of a part is named in the whole; NOBODY where it is not.
static const char *same_mistake(const char *exercise, const char *part)
{
    for (const SameMistake *same = chosen_stem()->same_mistakes; same->exercise != NULL; same++)
        if (strcmp(same->exercise, exercise) == 0 && strcmp(same->part, part) == 0)
            return same->said;
    return NOBODY;
}

// Everything is right but one function, which this one asks: that is an answer to this one.
static void check_part(const Composed *whole, const Mistake *part)
{
    char words[500];
    switch_to_reference();
    for (const Composed *other = chosen_stem()->composed; other->exercise != NULL; other++)
        switch_one(other->exercise, other->answer);
    switch_one(whole->exercise, whole->answer);
    switch_one(part->exercise, part->answer);
    run_tests(whole->exercise, NULL, ANSWERS_APART, &some);
    bool passes = passes_all(&some);
    if (!passes) {
        const char *said = same_mistake(whole->exercise, part->id);
        say(words, sizeof words, diagnose(exercise_number(whole->exercise), false));
        bool nobody = strncmp(words, NOBODY, strlen(NOBODY)) == 0;
        settle(nobody || strcmp(words, said) == 0, whole->exercise, part->id, words);
        part_count++;
    }
    records_end();
}

static void check_parts(void)
{
    const Mistake *const *mistakes = chosen_mistakes();
    for (const Composed *whole = chosen_stem()->composed; whole != NULL && whole->exercise != NULL;
         whole++)
        for (int table = 0; mistakes[table] != NULL; table++)
            for (int i = 0; mistakes[table][i].id != NULL; i++)
                if (strcmp(mistakes[table][i].exercise, whole->exercise) != 0)
                    check_part(whole, &mistakes[table][i]);
}

// ---- hard-coded answers -------------------------------------------------------------------------

static void check_by_heart(const char *function, const char *seed)
{
    setenv("SEED", seed, 1);
    for (int garbage = 0; garbage < 2; garbage++) {
        table_recite(garbage == 0 ? 0x00 : 0xff);
        settle(run(function, &some, false) > 0, "a table of the public inputs is enough for",
               function, seed);
        settle(!told, "hidden inputs may be shown:", function, seed);
    }
}

static void check_table(const char *stem)
{
    char *seed = getenv("SEED");
    seed = seed == NULL ? NULL : strdup(seed);
    switch_to_process(stem);
    for (int i = 0; exercises[i].name != NULL; i++) {
        const char *function = exercises[i].name;
        if (strcmp(exercises[i].stem, stem) != 0)
            continue;
        unsetenv("SEED");
        table_learn();
        run(function, &some, true);
        table_recite(0xff);
        settle(run(function, &some, true) == 0,
               "a table fails, although no input is new:", function, "");
        for (int k = 0; seed == NULL && k < 3; k++)
            check_by_heart(function, (const char *[]){"1", "20150921", "9223372036854775807"}[k]);
        if (seed != NULL)
            check_by_heart(function, seed);
    }
    free(seed);
}

// The calls that the parts of a function ask are many: apart from the rest.
static int only_parts(const char *stem)
{
    check_parts();
    printf("composed mistakes of %s (%d): %d passed, %d failed\n", stem, part_count, passed,
           failed);
    return failed == 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    const char *stem = argc > 1 ? argv[1] : NULL, *option = argc == 3 ? argv[2] : "";
    choose_stem(stem);
    const Mistake *const *mistakes = chosen_mistakes();
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
    if (strcmp(option, "--composed") == 0)
        return only_parts(stem);
    for (int table = 0; mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++, mistake_count++)
            check_mistake(&mistakes[table][i]);
    for (int i = 0; i < all.count; i++)
        settle(failed_by_some[i], "test", all.tests[i].name, "no mistake fails it");
    for (const Variant *it = chosen_stem()->variants; it != NULL && it->exercise != NULL;
         it++, variant_count++)
        check_variant(it);
    for (const Unknown *it = chosen_stem()->unknowns; it != NULL && it->exercise != NULL;
         it++, unknown_count++)
        check_unknown(it);
    check_table(stem);
    printf("+ %d known mistakes\n+ %d pairs of them told apart\n+ %d tests\n+ %d right "
           "answers\n+ %d unknown mistakes\n",
           mistake_count, pair_count / 2, all.count, variant_count, unknown_count);
    printf("matrix of %s: %d passed, %d failed\n", stem, passed, failed);
    return failed == 0 ? 0 : 1;
}
