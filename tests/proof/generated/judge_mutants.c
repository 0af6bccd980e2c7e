// judge_mutants.c - the tests' verdicts on generated wrong answers.
//
//   try_generated SEED REVIEWED|-v STEM...
//
// Each generated answer (mutate.c) is tested and diagnosed like a student's. Then another judge,
// with its own questions (truth.h), decides whether it is wrong at all, and whether the name of its
// mistake is true. A name is true if the mistake explains 19 of 20 questions that are answered
// wrongly, and answers at most one in 20 of all questions differently. A hedged name is true if it
// explains at least a third of the wrong answers, or of the wrong numbers in a picture, or of the
// answers that are wrong by more than digits. If no question shows a known mistake, the tests know
// more than that judge: an answer that was made from this mistake, or has its name, may fail.
// REVIEWED is a file of reviewed cases, a line each: EXERCISE | WHAT | PART OF THE CHANGE | WHY.
// Any other false verdict is a failure, and so is a stem of which less than 90% is named or
// described. -v lists the answers without a name or description.
#include "tests/proof/generated/generated.h"
#include "tests/proof/generated/guard.h"
#include "tests/proof/generated/truth.h"

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

// Whether it was made from a known mistake that answers all questions right.
static bool is_of_unseen(const Generated *it)
{
    const Mistake *const *mistakes = chosen_mistakes();
    const char *id = strrchr(it->from, ':');
    for (int table = 0; id != NULL && mistakes[table] != NULL; table++)
        for (int i = 0; mistakes[table][i].id != NULL; i++) {
            const Mistake *mistake = &mistakes[table][i];
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
        trial->broke = true;
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
    printf("%s%s\n", trial->words[0] != '\0' ? "; " : "", trial->words);
}

// ---- reviewed cases --------------------------------------------------------------------------

enum { MOST_REVIEWS = 100 };

static struct {
    char exercise[64], what[64], part[300];
} reviews[MOST_REVIEWS];
static int review_count;

static void read_reviews(const char *path)
{
    char line[800];
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    while (fgets(line, sizeof line, file) != NULL && review_count < MOST_REVIEWS)
        if (sscanf(line, "%63s | %63[^|] | %299[^|]", reviews[review_count].exercise,
                   reviews[review_count].what, reviews[review_count].part) == 3 &&
            line[0] != '#') {
            char *const ends[] = {reviews[review_count].what, reviews[review_count].part};
            for (int i = 0; i < 2; i++)
                while (ends[i][0] != '\0' && ends[i][strlen(ends[i]) - 1] == ' ')
                    ends[i][strlen(ends[i]) - 1] = '\0';
            review_count++;
        }
    fclose(file);
}

static bool is_reviewed(const char *what, const Generated *it)
{
    for (int i = 0; i < review_count; i++)
        if (strcmp(reviews[i].exercise, it->exercise) == 0 && strcmp(reviews[i].what, what) == 0 &&
            strstr(it->change, reviews[i].part) != NULL)
            return true;
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
    if (verbose && wrong && !trial->named && !trial->described && !trial->broke)
        show("  not described", it);
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

// False if a verdict is false and nobody has reviewed it.
static bool try_exercise(const Exercise *exercise, uint64_t seed, bool verbose, Count *total)
{
    Count count = {0};
    if (!truth_begin(exercise->name, exercise->reference, seed)) {
        printf("not ok: %s: no questions\n", exercise->name);
        return false;
    }
    const Generated *generated = chosen_stem()->generated;
    for (int i = 0; generated != NULL && generated[i].exercise != NULL; i++) {
        if (strcmp(generated[i].exercise, exercise->name) != 0)
            continue;
        try_one(&generated[i]);
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
    guard_begin();
    switch_to_process(stem);
    for (int e = 0; exercises[e].name != NULL; e++)
        if (strcmp(exercises[e].stem, stem) == 0 &&
            (only == NULL || strcmp(only, exercises[e].name) == 0))
            *(try_exercise(&exercises[e], seed, verbose, &total) ? &sum->passed : &sum->failed) +=
                1;
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
