// judge_mutants.c - the tests' verdicts on generated wrong answers.
//
//   try_generated SEED REVIEWED|-v STEM...
//
// Each generated answer (mutate.py) is tested and diagnosed like a student's. Then another judge,
// with its own questions (generated.h), decides whether it is wrong at all, and whether the name of
// its mistake is true. A name is true if the mistake explains 19 of 20 questions that are answered
// wrongly, and answers at most one in 20 of all questions differently. A hedged name is true if it
// explains at least a third of the wrong answers, or of the wrong numbers in a picture, or of the
// answers that are wrong by more than digits. If no question shows a known mistake, the tests know
// more than that judge: an answer that was made from this mistake, or has its name, may fail.
// REVIEWED is a file of reviewed cases, a line each: EXERCISE | WHAT | PART OF THE CHANGE | WHY.
// Any other false verdict is a failure, and so is a stem of which less than 90% is named or
// described. -v lists every answer with its verdict, and reviewed cases as well.
// With GENERATED_EVERY=N, only every Nth answer is tried, besides plain slips in a solution.
#include "tests/proof/generated/generated.h"

#include "tests/judge/runner.h"
#include "tests/judge/stem.h"
#include "tests/judge/suspects.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_SECONDS = 5 };

// The result of one, from the process that tried it.
typedef struct {
    bool done, passed, broke; // broke: it crashed or timed out
    bool noticed;             // by any test, an extra one also
    Truth truth;
    int question; // that it answered wrongly
    bool named, in_part, described, picture, unseen;
    Likeness likeness;
    char test[120], id[100], law[300], words[400];
} Trial;

typedef struct {
    int tried, right, edge, right_failed, wrong, failed, named, false_names, described;
    int survived, reviewed;
} Count;

static Trial *trial; // shared with the process that tries

// Shared with the process of each stem.
typedef struct {
    Count of_all;
    int passed, failed;
} Sum;
static Sum *sum;

static const Outcome *first_failed(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && !outcomes->tests[i].extra)
            return &outcomes->tests[i];
    return NULL;
}

// As the judge does it.
static void judge(const Generated *it)
{
    static Outcomes outcomes;
    guard_answer_by(it->answer);
    run_tests(it->exercise, NULL, ANSWERS_APART, &outcomes);
    const Outcome *failed = first_failed(&outcomes);
    trial->passed = failed == NULL;
    for (int i = 0; i < outcomes.count; i++)
        trial->noticed = trial->noticed || !outcomes.tests[i].passed;
    if (failed == NULL)
        return;
    snprintf(trial->test, sizeof trial->test, "%s", failed->name);
    trial->broke = failed->record->how[0] != '\0';
    if (trial->broke)
        return;
    Diagnosis said = diagnose(exercise_number(it->exercise), false);
    trial->named = said.mistake != NULL;
    trial->in_part = said.in_part;
    trial->picture = strncmp(it->exercise, "cast_", 5) == 0;
    trial->described = said.law != NULL;
    if (said.law != NULL)
        snprintf(trial->law, sizeof trial->law, "%s", said.law);
    if (said.mistake == NULL)
        return;
    int question;
    if (trial->truth != WRONG && truth_of(said.mistake->answer, &question) != WRONG)
        trial->unseen = true;
    snprintf(trial->id, sizeof trial->id, "%s%s%s%s", said.mistake->id, said.also ? " and " : "",
             said.also ? said.other->id : "", said.in_part ? " in part" : "");
    trial->likeness = said.also
                          ? likeness_to_both(it->answer, said.mistake->answer, said.other->answer)
                          : likeness(it->answer, said.mistake->answer);
    if (trial->likeness.apart > 0)
        truth_words(trial->words, sizeof trial->words, it->answer, trial->likeness.question_apart);
}

// Whether it was made from a known mistake that answers all questions right; or it calls one.
static bool is_of_unseen(const Generated *it)
{
    if (it->change[0] == '[')
        return true;
    const char *id = strrchr(it->from, ':');
    const Mistake *mistake = id != NULL ? known_answers(WRONG_ANSWERS) : NULL;
    for (; mistake != NULL; mistake = mistake->next) {
        int question;
        if (strcmp(mistake->exercise, it->exercise) == 0 && strcmp(mistake->id, id + 2) == 0)
            return truth_of(mistake->answer, &question) != WRONG;
    }
    return false;
}

static void try_one(const Generated *it)
{
    memset(trial, 0, sizeof *trial);
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        guard_begin();
        setrlimit(RLIMIT_CPU, &(struct rlimit){MOST_SECONDS, MOST_SECONDS});
        if (freopen("/dev/null", "w", stdout) == NULL || freopen("/dev/null", "w", stderr) == NULL)
            _exit(1);
        trial->truth = truth_of(it->answer, &trial->question);
        trial->unseen = trial->truth != WRONG && is_of_unseen(it);
        if (trial->truth == WRONG)
            truth_words(trial->words, sizeof trial->words, it->answer, trial->question);
        judge(it);
        trial->done = true;
        _exit(0);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        perror("no process to try an answer in");
        exit(1);
    }
    if (!trial->done)
        trial->broke = trial->noticed = true;
}

// ---- counting -----------------------------------------------------------------------------------

static bool is_false_name(void)
{
    const Likeness *like = &trial->likeness;
    if (!trial->named)
        return false;
    if (trial->in_part)
        return 3 * like->alike < like->wrong &&
               (like->clearly_wrong == 0 || 3 * like->clearly_alike < like->clearly_wrong) &&
               (!trial->picture || 3 * like->alike_numbers < like->wrong_numbers);
    return 20 * like->alike < 19 * like->wrong || 20 * like->apart > like->questions;
}

static void show(const char *what, const Generated *it)
{
    printf("%s: %s (%s): %s", what, it->exercise, it->from, it->change);
    if (trial->named)
        printf("; called %s, explains %d of %d, differs on %d", trial->id, trial->likeness.alike,
               trial->likeness.wrong, trial->likeness.apart);
    if (trial->test[0] != '\0')
        printf("; failed %s", trial->test);
    if (trial->truth == WRONG && trial->passed)
        printf("; wrong question %d", trial->question);
    if (trial->law[0] != '\0')
        printf("; said: %s", trial->law);
    printf("%s%s\n", trial->words[0] != '\0' ? "; " : "", trial->words);
}

// ---- reviewed cases --------------------------------------------------------------------------

enum { MOST_REVIEWS = 100 };

static struct {
    const char *exercise, *what, *part;
    bool used;
} reviews[MOST_REVIEWS];
static int review_count;

static void read_reviews(const char *path)
{
    char line[2000];
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    while (fgets(line, sizeof line, file) != NULL && review_count < MOST_REVIEWS) {
        char *fields[4] = {line, NULL, NULL, NULL};
        for (int i = 1; i < 4 && fields[i - 1] != NULL; i++)
            if ((fields[i] = strstr(fields[i - 1], " | ")) != NULL) {
                *fields[i] = '\0';
                fields[i] += strlen(" | ");
            }
        if (line[0] == '#' || fields[3] == NULL)
            continue;
        reviews[review_count].exercise = strdup(fields[0]);
        reviews[review_count].what = strdup(fields[1]);
        reviews[review_count++].part = strdup(fields[2]);
    }
    fclose(file);
}

static bool is_reviewed(const char *what, const Generated *it)
{
    for (int i = 0; i < review_count; i++)
        if (strcmp(reviews[i].exercise, it->exercise) == 0 && strcmp(reviews[i].what, what) == 0 &&
            strstr(it->change, reviews[i].part) != NULL)
            return reviews[i].used = true;
    return false;
}

static void amiss(Count *count, int *of_these, const char *what, const Generated *it)
{
    if (is_reviewed(what, it)) {
        count->reviewed++;
        return;
    }
    ++*of_these;
    char line[80];
    snprintf(line, sizeof line, "  %s", what);
    show(line, it);
}

static void count_one(Count *count, const Generated *it, bool verbose)
{
    static const char *const truths[] = {
        [RIGHT] = "a right one", [WRONG] = "a wrong one", [AT_THE_EDGE] = "one at an edge"};
    if (verbose)
        show(truths[trial->truth], it);
    count->tried++;
    count->right += trial->truth == RIGHT;
    count->edge += trial->truth == AT_THE_EDGE;
    if (trial->truth == RIGHT && !trial->passed && !trial->unseen)
        amiss(count, &count->right_failed, "right, but failed", it);
    bool wrong = trial->truth == WRONG;
    count->wrong += wrong;
    if (wrong && trial->passed)
        amiss(count, &count->survived, "wrong, but passed", it);
    if (trial->passed)
        return;
    count->failed += wrong;
    if (is_false_name())
        amiss(count, &count->false_names, "named falsely", it);
    count->named += wrong && trial->named;
    count->described += wrong && !trial->named && (trial->described || trial->broke);
}

static void print_count(const char *what, const Count *c)
{
    printf("%-22s %5d tried: %4d right (%d of them failed), %d at an edge, %d wrong, %d failed, %d "
           "named (%d falsely), %d described, %.1f%%, %d reviewed\n",
           what, c->tried, c->right, c->right_failed, c->edge, c->wrong, c->failed, c->named,
           c->false_names, c->described,
           c->failed > 0 ? 100.0 * (c->named + c->described) / c->failed : 100, c->reviewed);
}

static void add(Count *total, const Count *c)
{
    total->tried += c->tried;
    total->right += c->right;
    total->edge += c->edge;
    total->right_failed += c->right_failed;
    total->wrong += c->wrong;
    total->failed += c->failed;
    total->named += c->named;
    total->false_names += c->false_names;
    total->described += c->described;
    total->survived += c->survived;
    total->reviewed += c->reviewed;
}

// ---- plain slips in a solution ------------------------------------------------------------------

// A helper's slip is tried for each exercise that calls it: one must notice it. Prints how many do.
static bool check_plain_slips(const Generated *all, const bool *unnoticed)
{
    static const char what[] = "no test fails";
    int plain = 0, missed = 0, reviewed = 0, stale = 0;
    for (int i = 0; all[i].exercise != NULL; i++) {
        bool is_missed = all[i].is_plain, first = all[i].is_plain;
        for (int k = 0; all[k].exercise != NULL && first; k++)
            if (all[k].is_plain && strcmp(all[k].change, all[i].change) == 0) {
                is_missed = is_missed && unnoticed[k];
                first = k >= i;
            }
        plain += first;
        if (!first || !is_missed)
            continue;
        bool is_known = is_reviewed(what, &all[i]);
        *(is_known ? &reviewed : &missed) += 1;
        if (!is_known)
            printf("not ok: %s: %s: %s\n", what, all[i].exercise, all[i].change);
    }
    for (int i = 0; i < review_count; i++)
        if (strcmp(reviews[i].what, what) == 0 && !reviews[i].used &&
            exercise_number(reviews[i].exercise) >= 0 &&
            strcmp(exercises[exercise_number(reviews[i].exercise)].stem, chosen_stem()->name) ==
                0) {
            printf("not ok: stale: %s: %s\n", reviews[i].exercise, reviews[i].part);
            stale++;
        }
    printf("+ plain slips in %s: %d, of which no test notices %d, reviewed\n", chosen_stem()->name,
           plain, reviewed);
    return missed + stale == 0;
}

// False if a verdict is false and nobody has reviewed it.
static bool try_exercise(const Exercise *exercise, uint64_t seed, bool verbose, Count *total,
                         bool *unnoticed)
{
    Count count = {0};
    if (!truth_begin(exercise->name, exercise->reference, seed)) {
        printf("not ok: %s: no questions\n", exercise->name);
        return false;
    }
    const Generated *generated = chosen_stem()->generated;
    const char *some = getenv("GENERATED_EVERY");
    const int every = some != NULL && atoi(some) > 0 ? atoi(some) : 1;
    for (int i = 0; generated != NULL && generated[i].exercise != NULL; i++) {
        if (strcmp(generated[i].exercise, exercise->name) != 0 ||
            (!generated[i].is_plain && i % every != 0))
            continue;
        try_one(&generated[i]);
        unnoticed[i] = !trial->noticed;
        count_one(&count, &generated[i], verbose);
    }
    print_count(exercise->name, &count);
    add(total, &count);
    bool good =
        count.tried > 0 && count.right_failed == 0 && count.false_names == 0 && count.survived == 0;
    if (!good)
        printf("not ok: %s: %d wrong ones passed, %d right ones failed, %d named falsely\n",
               exercise->name, count.survived, count.right_failed, count.false_names);
    return good;
}

static void try_stem(const char *stem, uint64_t seed, bool verbose)
{
    Count total = {0};
    const char *only = getenv("ONLY");
    choose_stem(stem);
    const Generated *all = chosen_stem()->generated;
    int count = 0;
    while (all != NULL && all[count].exercise != NULL)
        count++;
    bool *unnoticed = calloc((size_t)count + 1, sizeof *unnoticed);
    guard_begin();
    for (int e = 0; exercises[e].name != NULL; e++)
        if (strcmp(exercises[e].stem, stem) == 0 &&
            (only == NULL || strcmp(only, exercises[e].name) == 0))
            *(try_exercise(&exercises[e], seed, verbose, &total, unnoticed) ? &sum->passed
                                                                            : &sum->failed) += 1;
    if (only == NULL && count > 0)
        *(check_plain_slips(all, unnoticed) ? &sum->passed : &sum->failed) += 1;
    free(unnoticed);
    print_count(stem, &total);
    add(&sum->of_all, &total);
    if (10 * (total.named + total.described) < 9 * total.failed) {
        printf("not ok: %s: fewer than 90%% are named or described\n", stem);
        sum->failed++;
    }
}

static void *shared(size_t size)
{
    void *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        abort();
    return memory;
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fprintf(stderr, "Usage: %s SEED REVIEWED|-v STEM...\n", argv[0]);
        return 2;
    }
    uint64_t seed = strtoull(argv[1], NULL, 10);
    bool verbose = strcmp(argv[2], "-v") == 0;
    if (!verbose)
        read_reviews(argv[2]);
    trial = shared(sizeof *trial);
    sum = shared(sizeof *sum);
    for (int i = 3; i < argc; i++) {
        fflush(NULL);
        pid_t pid = fork();
        if (pid == 0) {
            try_stem(argv[i], seed, verbose);
            exit(0);
        }
        int status = 1;
        if (pid < 0 || waitpid(pid, &status, 0) != pid || status != 0) {
            printf("not ok: %s: its trials did not end\n", argv[i]);
            sum->failed++;
        }
    }
    char what[40];
    snprintf(what, sizeof what, "+ seed %llu", (unsigned long long)seed);
    print_count(what, &sum->of_all);
    printf("generated: %d passed, %d failed\n", sum->passed, sum->failed);
    return sum->failed == 0 ? 0 : 1;
}
