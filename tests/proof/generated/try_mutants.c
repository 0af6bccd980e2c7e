// try_mutants.c - the judge's verdicts on generated wrong answers (mutate.py), a line each.
//
//   try_mutants STEM FIRST
//
// Each answer, from that number on, is judged like a student's, by the tables of JUDGE_TABLES. The
// line of an answer is begun before it is tried: one that crashes or runs for too long ends the
// program, and check_verdicts.py starts it again after that. The fields are those that
// check_verdicts.py names. With GENERATED_EVERY=N, only every Nth answer is tried, besides plain
// slips in a solution.
#include "tests/judge/known.h"
#include "tests/judge/message.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

enum { MOST_SECONDS = 4 };

static AnyFunction *answering;

static Numbers *ask(int exercise, Numbers *question)
{
    static Numbers answer;
    answer_here(exercise, answering, question, &answer);
    if (answer.overran)
        record_overran();
    return &answer;
}

// Whether it passed; whether any test noticed it, an extra one also; whether it is described;
// whether only a part of it is named; the name of the mistake; the test that failed.
static void judge(const Generated *it, FILE *out)
{
    static Outcomes outcomes;
    const Outcome *failed = NULL;
    bool noticed = false;
    Diagnosis said = {0};
    answering = it->answer;
    run_tests(it->exercise, NULL, ANSWERS_APART, &outcomes);
    for (int i = outcomes.count - 1; i >= 0; i--)
        if (!outcomes.tests[i].passed) {
            noticed = true;
            failed = outcomes.tests[i].extra ? failed : &outcomes.tests[i];
        }
    bool ended = failed != NULL && failed->record->how[0] != '\0';
    if (failed != NULL && !ended)
        said = diagnose(exercise_number(it->exercise), false);
    fprintf(out, "\t%s\t%s\t%s\t%s\t", failed == NULL ? "1" : "", noticed ? "1" : "",
            ended || said.law != NULL ? "1" : "", said.in_part ? "1" : "");
    if (said.mistake != NULL)
        fprintf(out, "%s%s%s", said.mistake->id, said.also ? " and " : "",
                said.also ? said.other->id : "");
    fprintf(out, "\t%s\n", failed != NULL ? failed->name : "");
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "Usage: %s STEM FIRST\n", argv[0]);
        return 2;
    }
    const char *some = getenv("GENERATED_EVERY");
    const int every = some != NULL && atoi(some) > 0 ? atoi(some) : 1;
    const struct itimerval most = {.it_value = {.tv_sec = MOST_SECONDS}};
    FILE *out = fdopen(dup(STDOUT_FILENO), "w");
    choose_stem(argv[1]);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    if (out == NULL || freopen("/dev/null", "w", stdout) == NULL ||
        freopen("/dev/null", "w", stderr) == NULL)
        return 1;
    transport_use(ask, NULL);
    const Generated *all = chosen_stem()->generated;
    for (int i = 0; all != NULL && all[i].exercise != NULL; i++) {
        if (i < atoi(argv[2]) || (!all[i].is_plain && i % every != 0))
            continue;
        fprintf(out, "%d\t%s\t%s\t%s\t%s", i, all[i].exercise, all[i].from, all[i].change,
                all[i].is_plain ? "1" : "");
        fflush(out);
        setitimer(ITIMER_VIRTUAL, &most, NULL);
        judge(&all[i], out);
    }
    return 0;
}
