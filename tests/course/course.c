// course.c - what 'make exercises', watch, hint, debug and reset do: judges answers and says so.
//
//   course judge PLAN STEM...      judges what has changed since it was judged last
//   course show PLAN STEM...       shows the verdicts; draws pictures
//   course exercises PLAN STEM...  both. Exit status 1 if something is wrong; if QUIET_MAKE is
//                                  set, make stops without an error message of its own
//   course watch PLAN STEM...      both, again whenever an answer is saved
//   course hint PLAN STEM          one hint more
//   course debug PLAN STEM PROGRAM gdb at the call that failed
//   course reset PLAN STEM         replaces the answer by the blank; keeps a copy
//   course note PLAN NAME...       the note below a figure if one of these answers is wrong
//   course status PLAN STEM...     a line for each function: STEM NAME STATE, with a tab between
//                                  them; then how many of all chapters are right
//
// PLAN: how answers are judged, as make has written it down (judging_plan.h). It starts compilers,
// judges and drawing programs; it never loads an answer. In the environment: ALL=1 shows all that
// needs work; NO_COLOR, TERM, COLUMNS (page.h); POLL (watch.h); GDB_FLAGS.
#include "tests/course/answer_pictures.h"
#include "tests/course/figure_note.h"
#include "tests/course/hints.h"
#include "tests/course/judging.h"
#include "tests/course/programs.h"
#include "tests/course/reset_answer.h"
#include "tests/course/reward.h"
#include "tests/course/show_verdicts.h"
#include "tests/course/waiting_compiler.h"
#include "tests/course/watch.h"

#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

typedef struct {
    JudgingPlan plan;
    Judging judging;
    bool chosen[MOST_CHAPTERS];
    int count, last; // of the chosen ones
} Course;

static void draw_figures(const Page *page, const JudgingPlan *plan, const ShownFigures *shown)
{
    for (int i = 0; i < shown->count; i++) {
        Command command = {.count = 0};
        command_words(&command, plan->draw);
        command_add(&command, plan->figures);
        command_add(&command, shown->names[i]);
        if (program_run(&command, "/dev/null") != 0)
            fprintf(page->out, "That figure could not be drawn: gnuplot %s/%s.gp says why.\n",
                    plan->figures, shown->names[i]);
        command_free(&command);
    }
}

// A chapter that has become right is rewarded once, though another one needs work.
static void reward_what_is_new(const Page *page, const Course *course,
                               const bool chosen[MOST_CHAPTERS])
{
    for (int i = 0; i < course->plan.count; i++) {
        PlanPath mark = plan_beside(&course->plan, i, ".rewarded");
        ChapterRecord record;
        if (!chosen[i])
            continue;
        bool right = judging_record(&course->judging, i, &record) &&
                     strcmp(record_state(&record), "right") == 0;
        chapter_record_free(&record);
        if (!right) {
            unlink(mark.s);
            show_answer_pictures(page, &course->judging, i);
        } else if (access(mark.s, F_OK) != 0) {
            putc('\n', page->out);
            reward_chapter(page, &course->judging, i, false);
            FILE *file = fopen(mark.s, "w");
            if (file != NULL)
                fclose(file);
        }
    }
}

static Standing show(const Course *course, const bool chosen[MOST_CHAPTERS], int count, int last)
{
    static ShownFigures shown;
    Page page = page_on(stdout);
    const char *all = getenv("ALL");
    Standing standing =
        show_verdicts(&page, &course->judging, chosen, all != NULL && all[0] != '\0', &shown);
    // After the verdict, so that nobody waits for it because of them.
    fflush(stdout);
    draw_figures(&page, &course->plan, &shown);
    if (standing != ALL_RIGHT)
        reward_what_is_new(&page, course, chosen);
    else if (count > 1)
        reward_all(&page, &course->judging);
    else
        reward_chapter(&page, &course->judging, last, true);
    fflush(stdout);
    return standing;
}

static int show_chosen(const Course *course)
{
    return show(course, course->chosen, course->count, course->last) == SOMETHING_WRONG ? 1 : 0;
}

// Whether a signal is in one of a process's sets, if that can be known: ShdPnd has the pending
// signals; SigCgt those with a handler.
static bool is_in(pid_t process, const char *set, int number)
{
    char path[60], line[200], format[20];
    unsigned long long signals = 0;
    snprintf(path, sizeof path, "/proc/%d/status", (int)process);
    snprintf(format, sizeof format, "%s: %%llx", set);
    FILE *file = fopen(path, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, format, &signals) == 1)
            break;
    if (file != NULL)
        fclose(file);
    return (signals >> (number - 1) & 1) != 0;
}

// A status that is not 0 makes make print an error of its own. After SIGQUIT it waits for the
// programs it started and exits with 1 and without a message, if the signal came before they ended.
// If make does not take the signal (started in the background by a script, it ignores it), the
// error is better than a status that says all is well.
static int fail_quietly(int status)
{
    const char *quiet = getenv("QUIET_MAKE");
    pid_t make = getppid();
    if (status != 1 || quiet == NULL || quiet[0] == '\0' || !is_in(make, "SigCgt", SIGQUIT))
        return status;
    fflush(stdout);
    enum { MOST_LOOKS = 2000 };
    kill(make, SIGQUIT);
    for (int looks = 0; looks < MOST_LOOKS && is_in(make, "ShdPnd", SIGQUIT); looks++)
        poll(NULL, 0, 1);
    return 0;
}

// Chapters that call an answer that was saved may have another verdict now. Blanks keep theirs.
static bool judge_dependents(const Course *course, int saved)
{
    bool wanted[MOST_CHAPTERS] = {false};
    for (int i = saved + 1; i < course->plan.count; i++) {
        ChapterRecord record;
        wanted[i] = course->chosen[i] && plan_depends_on(&course->plan, i, saved) &&
                    record_read(plan_beside(&course->plan, i, ".record").s, &record) &&
                    strcmp(record_state(&record), "blank") != 0;
        if (course->chosen[i] && plan_depends_on(&course->plan, i, saved))
            chapter_record_free(&record);
    }
    return judging_judge(&course->judging, wanted);
}

static int watch(const Course *course)
{
    static PlanPath paths[MOST_CHAPTERS];
    const char *files[MOST_CHAPTERS];
    int chapters[MOST_CHAPTERS], count = 0;
    const JudgingPlan *plan = &course->plan;
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    for (int i = 0; i < plan->count; i++)
        if (course->chosen[i]) {
            paths[count] = path_of(plan->answers, plan->chapters[i].stem, ".c");
            files[count] = paths[count].s;
            chapters[count++] = i;
        }
    Watch *watched = watch_begin(plan->answers, count, files);
    bool good = judging_judge(&course->judging, course->chosen);
    for (int saved = -1; good;) {
        bool only[MOST_CHAPTERS] = {false};
        if (isatty(STDOUT_FILENO) == 1)
            printf("\033[2J\033[H"); // an empty screen
        if (saved < 0) {
            show_chosen(course);
        } else {
            only[saved] = true;
            show(course, only, 1, saved);
        }
        printf("\nWatching %s/: save a file and it is judged; Ctrl-C ends.\n", plan->answers);
        fflush(stdout);
        if (saved >= 0)
            judge_dependents(course, saved);
        compilers_wait(plan, course->chosen);
        int file = watch_next(watched);
        if (file < 0)
            break;
        saved = chapters[file];
        memset(only, 0, sizeof only);
        only[saved] = true;
        good = judging_judge(&course->judging, only);
    }
    watch_end(watched);
    return good ? 0 : 1;
}

static int hint(const Course *course)
{
    const JudgingPlan *plan = &course->plan;
    const char *stem = plan->chapters[course->last].stem;
    Page page = page_on(stdout);
    ChapterRecord record;
    judging_record(&course->judging, course->last, &record);
    const FunctionRecord *function = function_for_hint(&record);
    int status = 0;
    if (function == NULL && record.function_count == 0)
        printf("%s has no verdict yet, so there is no hint: make exercises EX=%.2s\n", stem, stem);
    else if (function == NULL)
        printf("%s needs no hint: make exercises EX=%.2s\n", stem, stem);
    else
        status = hint_next(&page, stem, path_of("exercises", stem, ".hints").s, function->name,
                           plan_answer(plan, course->last).s,
                           plan_beside(plan, course->last, ".hint").s);
    chapter_record_free(&record);
    return status;
}

static int debug(const Course *course, const char *program)
{
    const char *stem = course->plan.chapters[course->last].stem, *flags = getenv("GDB_FLAGS");
    ChapterRecord record;
    judging_record(&course->judging, course->last, &record);
    const FunctionRecord *function = function_for_debug(&record);
    if (function == NULL) {
        printf("%s: there is no wrong answer to debug (make exercises EX=%.2s).\n", stem, stem);
        chapter_record_free(&record);
        return 0;
    }
    if (!program_is_there("gdb")) {
        fprintf(stderr, "gdb is missing: 'make setup FOR=contributor' installs it.\n");
        chapter_record_free(&record);
        return 1;
    }
    const char *test = function_value(function, "test"), *number = function_value(function, "case");
    printf("%s, in the test '", function->name);
    for (const char *c = test; *c != '\0'; c++)
        putchar(*c == '_' ? ' ' : *c);
    printf("', case %s.\n"
           "In gdb:  n       the next line           s       into a call\n"
           "         p x     the value of x          bt      which calls lead here\n"
           "         finish  out of this function    q       leave gdb\n",
           number);
    fflush(stdout);
    char first_break[200], second_break[200];
    snprintf(first_break, sizeof first_break, "break case_begins if number == %s", number);
    snprintf(second_break, sizeof second_break, "break %s", function->name);
    Command command = {.count = 0};
    command_words(&command, "gdb -q");
    command_words(&command, flags != NULL ? flags : "");
    const char *commands[] = {"set confirm off", first_break,  "run",
                              "delete",          second_break, "continue"};
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        command_add(&command, "-ex");
        command_add(&command, commands[i]);
    }
    const char *words[] = {"--args", program, stem, "--test", test};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        command_add(&command, words[i]);
    setenv("CK_FORK", "no", 1);
    execvp("gdb", (char *const *)command.words);
    perror("gdb");
    return 1;
}

static int status(const Course *course)
{
    for (int i = 0; i < course->plan.count; i++) {
        ChapterRecord record;
        const char *stem = course->plan.chapters[i].stem;
        if (!course->chosen[i])
            continue;
        if (!judging_record(&course->judging, i, &record))
            printf("%s\t\tnot judged\n", stem);
        else if (record.function_count == 0)
            printf("%s\t\t%s\n", stem, record_state(&record));
        for (int k = 0; k < record.function_count; k++)
            printf("%s\t%s\t%s\n", stem, record.functions[k].name,
                   function_state(&record.functions[k]));
        chapter_record_free(&record);
    }
    Progress progress = progress_so_far(&course->plan);
    printf("all chapters\t\t%d of %d functions are right\n", progress.right, progress.of);
    return 0;
}

// Blanks are made from solutions/, so nothing could be put back there.
static int reset(const JudgingPlan *plan, int chapter)
{
    if (strcmp(plan->answers, "solutions") == 0) {
        fprintf(stderr, "make reset: solutions/ has no blanks; the blanks are made from it\n");
        return 1;
    }
    const char *stem = plan->chapters[chapter].stem;
    return reset_answer(path_of(plan->blanks, stem, ".c").s, path_of(plan->answers, stem, ".c").s);
}

static int run(const char *what, const Course *course, const char *program)
{
    if (strcmp(what, "reset") == 0)
        return reset(&course->plan, course->last);
    if (strcmp(what, "watch") == 0)
        return watch(course);
    if (strcmp(what, "show") == 0)
        return show_chosen(course);
    if (strcmp(what, "status") == 0)
        return status(course);
    if (!judging_judge(&course->judging, course->chosen))
        return 2;
    return strcmp(what, "exercises") == 0 ? fail_quietly(show_chosen(course))
           : strcmp(what, "hint") == 0    ? hint(course)
           : strcmp(what, "debug") == 0   ? debug(course, program)
                                          : 0; // judge
}

int main(int argc, char **argv)
{
    static Course course;
    const char *what = argc > 3 ? argv[1] : "";
    bool is_debug = strcmp(what, "debug") == 0;
    if (argc < 4 || (is_debug && argc != 5) ||
        strstr(" judge show exercises watch hint debug reset status note ", what) == NULL) {
        fprintf(stderr,
                "Usage: %s judge|show|exercises|watch|hint|reset|status PLAN STEM...\n"
                "       %s debug PLAN STEM PROGRAM\n"
                "       %s note PLAN NAME...\n",
                argv[0], argv[0], argv[0]);
        return 2;
    }
    for (const char *const *name = (const char *[]){"MAKEFLAGS", "MFLAGS", "MAKELEVEL", NULL};
         *name != NULL; name++)
        unsetenv(*name);
    setenv("LC_ALL", "C", 1);
    programs_end_with_us();
    if (!plan_read(argv[2], &course.plan))
        return 2;
    if (strcmp(what, "note") == 0) {
        figure_note(stdout, &course.plan, argc - 3, argv + 3);
        plan_free(&course.plan);
        return 0;
    }
    for (int i = 3; i < (is_debug ? 4 : argc); i++) {
        int chapter = plan_chapter(&course.plan, argv[i]);
        if (chapter < 0) {
            fprintf(stderr, "%s: no chapter of %s\n", argv[i], argv[2]);
            return 2;
        }
        course.count += !course.chosen[chapter];
        course.chosen[chapter] = true;
        course.last = chapter;
    }
    course.judging = judging_begin(&course.plan);
    int result = run(what, &course, argv[argc - 1]);
    plan_free(&course.plan);
    return result;
}
