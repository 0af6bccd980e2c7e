// try_mutants.c - the judge's verdicts on generated wrong answers (mutate.py).
//
//   try_mutants REVIEWED|-v STEM FOLDER...
//
// Each answer is judged like a student's, once with the tables of each folder: those that are
// graded, and the same tests with other random numbers. What depends on the numbers is luck: a
// failure is false if an answer passes with all others, a pass if it fails with others, and the
// name of a mistake if it has another name with others.
// REVIEWED is a file of reviewed cases, a line each: EXERCISE | WHAT | PART OF THE CHANGE | WHY.
// Any other false verdict is a failure, and so is if less than 90% is named or described. -v lists
// every answer with its verdicts, and reviewed cases as well. With GENERATED_EVERY=N, only every
// Nth answer is tried, besides plain slips in a solution.
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_SECONDS = 4, MOST_FOLDERS = 8, MOST_GENERATED = 20000 };

// From the process that tried it.
typedef struct {
    bool tried;
    bool passed, noticed; // noticed: by any test, an extra one also
    bool in_part, described;
    char name[100]; // of the mistake; empty if none is named
    char test[120];
} Verdict;

// Shared with the processes of the answers.
static Verdict (*verdicts)[MOST_FOLDERS]; // of each answer
static int *trying;                       // the number of an answer

typedef struct {
    int tried, passed, failed, named, described; // by the graded tables
    int amiss, reviewed;
} Count;
static int settled[2]; // what failed, what passed

static const char *const *folders;
static int folder_count;

// ---- one answer ---------------------------------------------------------------------------------

static AnyFunction *answering;

static Numbers *ask(int exercise, Numbers *question)
{
    static Numbers answer;
    answer_here(exercise, answering, question, &answer);
    if (answer.overran)
        record_overran();
    return &answer;
}

static const Outcome *first_failed(const Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && !outcomes->tests[i].extra)
            return &outcomes->tests[i];
    return NULL;
}

static void judge(const Generated *it, Verdict *verdict)
{
    static Outcomes outcomes;
    transport_use(ask, NULL);
    answering = it->answer;
    run_tests(it->exercise, NULL, ANSWERS_APART, &outcomes);
    const Outcome *failed = first_failed(&outcomes);
    verdict->passed = failed == NULL;
    for (int i = 0; i < outcomes.count; i++)
        verdict->noticed = verdict->noticed || !outcomes.tests[i].passed;
    if (failed == NULL)
        return;
    snprintf(verdict->test, sizeof verdict->test, "%s", failed->name);
    if (failed->record->how[0] != '\0') {
        verdict->described = true;
        return;
    }
    Diagnosis said = diagnose(exercise_number(it->exercise), false);
    verdict->described = said.law != NULL;
    verdict->in_part = said.in_part;
    if (said.mistake != NULL)
        snprintf(verdict->name, sizeof verdict->name, "%s%s%s", said.mistake->id,
                 said.also ? " and " : "", said.also ? said.other->id : "");
}

static bool is_wanted(const Generated *it, int number)
{
    const char *some = getenv("GENERATED_EVERY");
    const int every = some != NULL && atoi(some) > 0 ? atoi(some) : 1;
    return it->is_plain || number % every == 0;
}

// Tries all from this one on, until one crashes or runs for too long, which ends the process.
static _Noreturn void try_from(const Generated *all, int i, int folder)
{
    const struct itimerval most = {.it_value = {.tv_sec = MOST_SECONDS}};
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    if (freopen("/dev/null", "w", stdout) == NULL || freopen("/dev/null", "w", stderr) == NULL)
        _exit(1);
    for (; all[i].exercise != NULL; i++) {
        if (!is_wanted(&all[i], i))
            continue;
        *trying = i;
        verdicts[i][folder].tried = true;
        setitimer(ITIMER_VIRTUAL, &most, NULL);
        judge(&all[i], &verdicts[i][folder]);
    }
    _exit(0);
}

static void try_all(const Generated *all, int folder)
{
    for (int next = 0, status = 1; status != 0; next = *trying + 1) {
        fflush(NULL);
        *trying = -1;
        pid_t child = fork();
        if (child == 0)
            try_from(all, next, folder);
        if (child < 0 || waitpid(child, &status, 0) != child || (status != 0 && *trying < 0)) {
            perror("no process to try answers in");
            exit(1);
        }
        if (status != 0)
            verdicts[*trying][folder] =
                (Verdict){.tried = true, .noticed = true, .described = true};
    }
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

// ---- what is said of it -------------------------------------------------------------------------

static void show(const char *what, const Generated *it, const Verdict *verdict)
{
    printf("%s: %s (%s): %s", what, it->exercise, it->from, it->change);
    for (int i = 0; i < folder_count; i++)
        printf("; %s%s%s", verdict[i].passed ? "passed" : verdict[i].name,
               verdict[i].in_part ? " in part" : "",
               verdict[i].passed || verdict[i].name[0] != '\0' ? "" : "failed");
    printf("%s%s\n", verdict[0].test[0] != '\0' ? "; failed " : "", verdict[0].test);
}

// By the graded tables the first.
static const char *what_is_false(const Verdict *verdict)
{
    int passed = 0;
    bool alone = folder_count == 1;
    bool named = verdict[0].name[0] != '\0' && !verdict[0].in_part, otherwise = false;
    for (int i = 1; i < folder_count; i++) {
        passed += verdict[i].passed;
        otherwise = otherwise || (named && !verdict[i].passed && verdict[i].name[0] != '\0' &&
                                  strcmp(verdict[0].name, verdict[i].name) != 0);
    }
    return alone                                              ? NULL
           : verdict[0].passed && passed < folder_count - 1   ? "wrong, but passed"
           : !verdict[0].passed && passed == folder_count - 1 ? "right, but failed"
           : otherwise                                        ? "named falsely"
                                                              : NULL;
}

static void count_one(Count *count, const Generated *it, const Verdict *verdict, bool verbose)
{
    const char *what = what_is_false(verdict);
    count->tried++;
    count->passed += verdict[0].passed;
    count->failed += !verdict[0].passed;
    count->named += verdict[0].name[0] != '\0';
    count->described += verdict[0].name[0] == '\0' && verdict[0].described;
    if (verbose)
        show(verdict[0].passed ? "right" : "wrong", it, verdict);
    if (what == NULL)
        return;
    if (is_reviewed(what, it)) {
        count->reviewed++;
        return;
    }
    count->amiss++;
    char line[40];
    snprintf(line, sizeof line, "not ok: %s", what);
    show(line, it, verdict);
}

static void print_count(const char *what, const Count *c)
{
    printf("%-22s %5d tried: %4d passed, %4d failed, %d named, %d described, %.1f%%, %d reviewed\n"
           "+ %d generated answers\n",
           what, c->tried, c->passed, c->failed, c->named, c->described,
           c->failed > 0 ? 100.0 * (c->named + c->described) / c->failed : 100, c->reviewed,
           c->tried);
}

// ---- plain slips in a solution ------------------------------------------------------------------

// A helper's slip is tried for each exercise that calls it: one must notice it. Prints how many do.
static bool check_plain_slips(const Generated *all)
{
    static const char what[] = "no test fails";
    int plain = 0, missed = 0, reviewed = 0, stale = 0;
    for (int i = 0; all[i].exercise != NULL; i++) {
        bool is_missed = all[i].is_plain, first = all[i].is_plain;
        for (int k = 0; all[k].exercise != NULL && first; k++)
            if (all[k].is_plain && strcmp(all[k].change, all[i].change) == 0) {
                is_missed = is_missed && !verdicts[k][0].noticed;
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

// ---- all of a stem ------------------------------------------------------------------------------

static bool check_exercise(const char *exercise, const Generated *all, bool verbose, Count *total)
{
    const Count before = *total;
    for (int i = 0; all[i].exercise != NULL; i++)
        if (strcmp(all[i].exercise, exercise) == 0 && verdicts[i][0].tried)
            count_one(total, &all[i], verdicts[i], verbose);
    return total->tried > before.tried && total->amiss == before.amiss;
}

static const Generated *try_all_folders(const char *stem)
{
    static const Generated none[] = {{0}};
    const Generated *all = none;
    for (int f = 0; f < folder_count; f++) {
        int count = 0;
        setenv("JUDGE_TABLES", folders[f], 1);
        choose_stem(stem);
        all = chosen_stem()->generated != NULL ? chosen_stem()->generated : none;
        while (all[count].exercise != NULL)
            count++;
        if (count > MOST_GENERATED) {
            fprintf(stderr, "%s: more than %d generated answers\n", stem, MOST_GENERATED);
            exit(1);
        }
        try_all(all, f);
    }
    return all;
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
    if (argc < 4 || argc - 3 > MOST_FOLDERS) {
        fprintf(stderr, "Usage: %s REVIEWED|-v STEM FOLDER...\n", argv[0]);
        return 2;
    }
    const char *stem = argv[2];
    bool verbose = strcmp(argv[1], "-v") == 0;
    if (!verbose)
        read_reviews(argv[1]);
    folders = (const char *const *)argv + 3;
    folder_count = argc - 3;
    verdicts = shared(MOST_GENERATED * sizeof *verdicts);
    trying = shared(sizeof *trying);
    const Generated *all = try_all_folders(stem);
    Count total = {0};
    for (int e = 0; exercises[e].name != NULL; e++)
        if (strcmp(exercises[e].stem, stem) == 0)
            settled[check_exercise(exercises[e].name, all, verbose, &total)]++;
    settled[check_plain_slips(all)]++;
    print_count(stem, &total);
    if (10 * (total.named + total.described) < 9 * total.failed) {
        printf("not ok: %s: fewer than 90%% are named or described\n", stem);
        settled[false]++;
    }
    printf("generated: %d passed, %d failed\n", settled[true], settled[false]);
    return settled[false] == 0 ? 0 : 1;
}
