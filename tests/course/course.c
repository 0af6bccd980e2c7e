// course.c - what 'make exercises', watch, hint, debug and reset do: judges answers and says so.
//
//   course judge PLAN STEM...      judges what has changed since it was judged last
//   course exercises PLAN STEM...  and shows the verdicts; draws pictures
//   course watch PLAN STEM...      again whenever an answer is saved
//   course hint PLAN STEM...       one hint more, of the chapter that needs work first
//   course debug PLAN STEM PROGRAM gdb at the call that failed
//   course reset PLAN STEM         replaces the answer by the blank; keeps a copy
//   course note PLAN NAME...       the note below a figure if one of these answers is wrong
//   course faults PLAN STEM...     judges, and says in a line for each chapter what is wrong
//   course status PLAN STEM...     a line for each function: STEM NAME STATE, with a tab between
//                                  them; then how many of all chapters are right. Exit status 1
//                                  if a function of these chapters is not
//
// PLAN: how answers are judged, as make has written it down (course.h). It starts compilers,
// judges and drawing programs; it never loads an answer. In the environment: V=1 shows these
// commands; ALL=1 shows all that needs work; WEB, NO_COLOR, TERM, COLUMNS (page.h); GDB_FLAGS.
#include "tests/course/course.h"

#include "common/toolkit_file.h"

#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

// ---- judges answers again whenever they are saved ----------------------------------------------

// A file counts as saved when its text is another than before: dates are unreliable, and editors
// write twice. The texts are read again and again, which costs next to nothing, and also works on
// network drives, which send no events.
enum { MILLISECONDS_BETWEEN_LOOKS = 25 };

static PlanPath path_to_watch(const JudgingPlan *plan, int chapter)
{
    return path_of(plan->answers, plan->chapters[chapter].stem, ".c");
}

// Waits until the answer of a chosen chapter has another text than the one that was seen. A file
// that is empty or not there is being written, or is not there yet. -1 if the process that has
// started this one is gone.
static int next_saved(const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS],
                      uint64_t seen[MOST_CHAPTERS], pid_t parent)
{
    struct stat about;
    while (getppid() == parent) {
        for (int i = 0; i < plan->count; i++) {
            PlanPath path = path_to_watch(plan, i);
            uint64_t now = chosen[i] ? hash_file(HASH_BEGIN, path.s) : seen[i];
            if (now == seen[i] || stat(path.s, &about) != 0 || about.st_size == 0)
                continue;
            seen[i] = now;
            return i;
        }
        poll(NULL, 0, MILLISECONDS_BETWEEN_LOOKS);
    }
    return -1;
}

// ---- hints -------------------------------------------------------------------------------------

// hints: a file (exercises/NN-stem.hints) with a section '# FUNCTION' for each exercise. A hint
// begins with '- ', lines that continue it with two blanks. Gets hint NUMBER of a function, as it
// is wrapped there; how many there are.
enum { LONGEST_HINT = 4000 };
static int get_hint(const char *hints, const char *function, int number, char hint[LONGEST_HINT])
{
    char line[400], name[100];
    size_t length = 0;
    bool inside = false;
    int count = 0;
    FILE *file = fopen(hints, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        bool begins = strncmp(line, "- ", 2) == 0;
        if (sscanf(line, "# %99s", name) == 1)
            inside = strcmp(name, function) == 0;
        else if (inside)
            count += begins;
        if (inside && count > 0 && count == number && strcmp(line, "\n") != 0 &&
            length < LONGEST_HINT)
            length += (size_t)snprintf(hint + length, LONGEST_HINT - length, "  %s", line + 2);
    }
    if (file != NULL)
        fclose(file);
    return count;
}

// state: a file that remembers what was shown: the function and the hash of the answer's text, then
// how many hints. Returns an exit status.
static int hint_next(const Page *page, const char *stem, const char *function, const char *answer,
                     const char *state)
{
    char hint[LONGEST_HINT] = "", hints[MOST_PLAN_PATH];
    if (!toolkit_file(hints, sizeof hints, NULL, path_of("exercises", stem, ".hints").s))
        return 1;
    int total = get_hint(hints, function, 0, hint), shown = 0;
    if (total == 0) {
        fprintf(stderr, "%s: %s has no hints for %s. The lesson: chapters/%s/README.md\n", stem,
                hints, function, stem);
        return 1;
    }
    // By its text, not its date: saving it again unchanged is not a new attempt.
    char hash[HASH_WORD], asked[200], last[200];
    hash_word(hash, hash_file(HASH_BEGIN, answer));
    snprintf(asked, sizeof asked, "%s %s", function, hash);
    FILE *file = fopen(state, "r");
    if (file != NULL) {
        if (fscanf(file, "%199[^\n] %4d", last, &shown) != 2 || strcmp(last, asked) != 0)
            shown = 0;
        fclose(file);
    }
    int number = shown < total ? shown + 1 : total;
    get_hint(hints, function, number, hint);
    char which[300];
    snprintf(which, sizeof which, "%s  hint %d of %d", function, number, total);
    page_part(page, "hint", which, hint);
    page_terminal(page, "%s  %s\n%s", stem, which, hint);
    if (number < total)
        page_terminal(page, "(next hint: make hint EX=%.2s)\n", stem);
    else
        page_terminal(page, "(that was the last one; the lesson is chapters/%s/README.md)\n", stem);
    file = fopen(state, "w");
    if (file != NULL) {
        fprintf(file, "%s\n%d\n", asked, number);
        fclose(file);
    }
    return 0;
}

// ---- puts the blank back in the place of an answer ---------------------------------------------

static bool keep(const char *answer)
{
    char kept[MOST_PLAN_PATH + 30];
    int n = 0;
    do
        snprintf(kept, sizeof kept, "%s.backup-%d", answer, ++n);
    while (access(kept, F_OK) == 0);
    if (rename(answer, kept) != 0) {
        perror(kept);
        return false;
    }
    printf("Your answer is kept as %s\n", kept);
    return true;
}

static bool put(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "w");
    bool good = file != NULL && fwrite(bytes, 1, size, file) == size;
    good = file != NULL && fclose(file) == 0 && good;
    if (!good)
        perror(path);
    return good;
}

// The answer is kept beside it, as ANSWER.backup-N, unless it is the blank. Returns an exit status.
static int reset_answer(const char *blank, const char *answer)
{
    size_t size, old_size;
    char *text = whole_text(blank, &size), *old = whole_text(answer, &old_size);
    bool good = text != NULL;
    if (!good)
        perror(blank);
    else if (old == NULL || old_size != size || memcmp(old, text, size) != 0)
        good = (old == NULL || keep(answer)) && put(answer, text, size);
    if (good)
        printf("%s is the blank again.\n", answer);
    free(text);
    free(old);
    return good ? 0 : 1;
}

// ---- what is shown -----------------------------------------------------------------------------

// What is shown at a time: these chapters, and the last of them.
typedef struct {
    bool chosen[MOST_CHAPTERS];
    int count, last;
} Shown;

typedef struct {
    JudgingPlan plan;
    Shown all; // that were chosen
} Course;

static void draw_figures(const Page *page, const JudgingPlan *plan, const ShownFigures *shown)
{
    for (int i = 0; i < shown->count; i++)
        if (run_line("/dev/null", 0, "%s %s %s", plan->draw, plan->figures.s, shown->names[i]) != 0)
            fprintf(page->out, "That figure could not be drawn: gnuplot %s/%s.gp says why.\n",
                    plan->figures.s, shown->names[i]);
}

static bool is_right(const Course *course, int chapter)
{
    ChapterRecord record;
    bool right = judging_record(&course->plan, chapter, &record) &&
                 strcmp(record_state(&record), "right") == 0;
    chapter_record_free(&record);
    return right;
}

// Those that have become right: each is rewarded once, though another one needs work.
static int find_rewards(const Course *course, const bool chosen[MOST_CHAPTERS],
                        bool news[MOST_CHAPTERS])
{
    bool all_right = true;
    int count = 0;
    for (int i = 0; i < course->plan.count; i++) {
        PlanPath mark = plan_beside(&course->plan, i, ".rewarded");
        bool right = chosen[i] && is_right(course, i);
        news[i] = right && access(mark.s, F_OK) != 0;
        count += news[i];
        all_right = all_right && (right || !chosen[i]);
        if (chosen[i] && !right)
            unlink(mark.s);
    }
    if (all_right) // rewarded in another way
        memset(news, 0, MOST_CHAPTERS * sizeof *news);
    return all_right ? 0 : count;
}

static void say_rewards(const Page *page, const Course *course, const bool news[MOST_CHAPTERS])
{
    for (int i = 0; i < course->plan.count; i++)
        if (news[i])
            reward_line(page, &course->plan, i);
}

static void draw_pictures(const Page *page, const Course *course, const bool chosen[MOST_CHAPTERS],
                          const bool news[MOST_CHAPTERS])
{
    for (int i = 0; i < course->plan.count; i++) {
        if (news[i]) {
            reward_draw(page, &course->plan, i);
            set_mark(plan_beside(&course->plan, i, ".rewarded").s);
        } else if (chosen[i] && !is_right(course, i)) {
            show_answer_pictures(page, &course->plan, i, false);
        }
    }
}

// What comes after the verdict, so that nobody waits for it because of it.
static void show_pictures(const Page *page, const Course *course, const Shown *shown,
                          Standing standing, const ShownFigures *figures,
                          const bool news[MOST_CHAPTERS])
{
    draw_figures(page, &course->plan, figures);
    if (standing != ALL_RIGHT)
        draw_pictures(page, course, shown->chosen, news);
    else if (shown->count > 1)
        reward_all(page, &course->plan);
    else
        reward_chapter(page, &course->plan, shown->last);
}

// brief: on a terminal that shows nothing else.
static void show(const Course *course, const Shown *shown, bool brief)
{
    static ShownFigures figures;
    const char *all = getenv("ALL");
    bool news[MOST_CHAPTERS], shows_all = !brief && all != NULL && all[0] != '\0';
    Page page = page_on(stdout);
    page.is_brief = brief;
    if (find_rewards(course, shown->chosen, news) > 0) {
        say_rewards(&page, course, news);
        fputs(brief ? "" : "\n", stdout);
    }
    Standing standing = show_verdicts(&page, &course->plan, shown->chosen, shows_all, &figures);
    fflush(stdout);
    page.is_brief = brief && standing != ALL_RIGHT;
    show_pictures(&page, course, shown, standing, &figures, news);
    fflush(stdout);
}

// ---- the commands ------------------------------------------------------------------------------

// Chapters that call an answer that was saved may have another verdict now. Blanks keep theirs.
static bool judge_dependents(const Course *course, int saved)
{
    bool wanted[MOST_CHAPTERS] = {false};
    for (int i = saved + 1; i < course->plan.count; i++) {
        ChapterRecord record;
        wanted[i] = course->all.chosen[i] && plan_depends_on(&course->plan, i, saved) &&
                    record_read(plan_beside(&course->plan, i, ".record").s, &record) &&
                    strcmp(record_state(&record), "blank") != 0;
        if (course->all.chosen[i] && plan_depends_on(&course->plan, i, saved))
            chapter_record_free(&record);
    }
    return judging_judge(&course->plan, wanted);
}

static int watch(const Course *course)
{
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    programs_end_as_usual_by_interrupt();
    pid_t parent = getppid();
    uint64_t seen[MOST_CHAPTERS]; // before the texts are judged first, so that no save is lost
    for (int i = 0; i < course->plan.count; i++)
        seen[i] = hash_file(HASH_BEGIN, path_to_watch(&course->plan, i).s);
    Shown shown = course->all;
    bool good = judging_judge(&course->plan, shown.chosen);
    for (int saved = -1; good;) {
        bool is_terminal = isatty(fileno(stdout)) == 1;
        if (is_terminal)
            printf("\033[2J\033[H"); // an empty screen
        show(course, &shown, is_terminal);
        if (!is_terminal)
            putchar('\n');
        puts("Watching: save a file and it is judged; Ctrl-C ends.");
        fflush(stdout);
        if (saved >= 0)
            judge_dependents(course, saved);
        saved = next_saved(&course->plan, course->all.chosen, seen, parent);
        if (saved < 0)
            break;
        shown = (Shown){.count = 1, .last = saved};
        shown.chosen[saved] = true;
        good = judging_judge(&course->plan, shown.chosen);
    }
    return good ? 0 : 1;
}

static int hint(const Course *course)
{
    const JudgingPlan *plan = &course->plan;
    int next = chapter_that_is_next(&course->plan, course->all.chosen);
    int chapter = next >= 0 ? next : course->all.last;
    const char *stem = plan->chapters[chapter].stem;
    if (next < 0 && course->all.count > 1) {
        puts("All chapters are right: there is nothing to hint at.");
        return 0;
    }
    Page page = page_on(stdout);
    MissingAnswer missing = missing_answer(plan->answers, stem);
    if (missing.is_missing && missing.like[0] != '\0') {
        show_missing(&page, plan, stem, &missing);
        return 0;
    }
    ChapterRecord record;
    judging_record(&course->plan, chapter, &record);
    const FunctionRecord *function = function_for_hint(&record);
    int status = 0;
    const char *none =
        record.function_count == 0 ? "has no verdict yet, so there is no hint" : "needs no hint";
    if (function == NULL) {
        page_part(&page, "hint", stem, none);
        page_terminal(&page, "%s %s: make exercises EX=%.2s\n", stem, none, stem);
    } else
        status = hint_next(&page, stem, function->name, plan_answer(plan, chapter).s,
                           plan_beside(plan, chapter, ".hint").s);
    chapter_record_free(&record);
    return status;
}

static int debug(const Course *course, const char *program)
{
    const char *stem = course->plan.chapters[course->all.last].stem, *flags = getenv("GDB_FLAGS");
    ChapterRecord record;
    judging_record(&course->plan, course->all.last, &record);
    const FunctionRecord *function = first_that_is(&record, "wrong");
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
    printf("%s, in the test '%s', case %s.\n"
           "In gdb:  n       the next line           s       into a call\n"
           "         p x     the value of x          bt      which calls lead here\n"
           "         finish  out of this function    q       leave gdb\n",
           function->name, test_sentence(function).s, number);
    fflush(stdout);
    char first_break[200], second_break[200];
    // Of the way there nothing is printed.
    snprintf(first_break, sizeof first_break,
             "pipe break case_begins if number == %s | cat >/dev/null", number);
    snprintf(second_break, sizeof second_break, "pipe break %s | cat >/dev/null", function->name);
    const char *words[] = {"gdb",    flags != NULL ? flags : "-q",
                           "-ex",    "set confirm off",
                           "-ex",    first_break,
                           "-ex",    "pipe run | cat >/dev/null",
                           "-ex",    "delete",
                           "-ex",    second_break,
                           "-ex",    "pipe continue | cat >/dev/null",
                           "-ex",    "frame",
                           "--args", program,
                           stem,     "--test",
                           test,     NULL};
    execvp("gdb", (char *const *)words);
    perror("gdb");
    return 1;
}

static int status(const Course *course)
{
    bool all_right = true;
    for (int i = 0; i < course->plan.count; i++) {
        ChapterRecord record;
        const char *stem = course->plan.chapters[i].stem;
        if (!course->all.chosen[i])
            continue;
        all_right = all_right && is_right(course, i);
        if (!judging_record(&course->plan, i, &record))
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
    return all_right ? 0 : 1;
}

// Blanks are made from solutions/, so nothing could be put back there.
static int reset(const JudgingPlan *plan, int chapter)
{
    if (strcmp(plan->answers, "solutions") == 0) {
        fprintf(stderr, "make reset: solutions/ has no blanks; the blanks are made from it\n");
        return 1;
    }
    const char *stem = plan->chapters[chapter].stem;
    return reset_answer(plan_blank(plan, chapter).s, path_of(plan->answers, stem, ".c").s);
}

static int run(const char *what, const Course *course, const char *program)
{
    if (strcmp(what, "reset") == 0)
        return reset(&course->plan, course->all.last);
    if (strcmp(what, "watch") == 0)
        return watch(course);
    if (strcmp(what, "status") == 0)
        return status(course);
    if (!judging_judge(&course->plan, course->all.chosen))
        return 2;
    if (strcmp(what, "faults") == 0) {
        Page page = page_on(stdout);
        show_faults(&page, &course->plan);
        return 0;
    }
    if (strcmp(what, "exercises") == 0)
        show(course, &course->all, false);
    return strcmp(what, "hint") == 0    ? hint(course)
           : strcmp(what, "debug") == 0 ? debug(course, program)
                                        : 0; // judge
}

int main(int argc, char **argv)
{
    static Course course;
    const char *what = argc > 3 ? argv[1] : "";
    bool is_debug = strcmp(what, "debug") == 0;
    if (argc < 4 || (is_debug && argc != 5) ||
        strstr(" judge exercises watch hint debug reset status faults note ", what) == NULL) {
        fprintf(stderr,
                "Usage: %s judge|exercises|watch|hint|reset|status|faults PLAN STEM...\n"
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
        course.all.count += !course.all.chosen[chapter];
        course.all.chosen[chapter] = true;
        course.all.last = chapter;
    }
    int result = run(what, &course, argv[argc - 1]);
    plan_free(&course.plan);
    return result;
}
