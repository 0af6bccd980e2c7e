// judging.c - judges the chapters whose record is about another answer than the one that is there.
//
// An answer is compiled, linked with the code that answers the judge's calls, and asked by the
// judge of its chapter. All of that is done by other programs: nothing of an answer is ever loaded
// here.
#include "tests/course/course.h"

#include "tests/explain/explain.h"
#include "tests/judge/exercise.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- the plan ----------------------------------------------------------------------------------

static bool complain(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    return false;
}

bool plan_read(const char *path, JudgingPlan *plan)
{
    *plan = (JudgingPlan){0};
    if (!entries_read(path, &plan->all))
        return complain(path, "cannot be read as a plan of judging");
    const Entry *entries = plan->all.entries;
    int head = 0;
    while (head < plan->all.count && strcmp(entries[head].key, "chapter") != 0)
        head++;
    const struct {
        const char *key, **value;
    } keys[] = {
        {"answers", &plan->answers}, {"built", &plan->built},
        {"draw", &plan->draw},       {"compile", &plan->compile},
        {"link", &plan->link},       {"hide", &plan->hide},
        {"lend", &plan->lend},       {"judge", &plan->judge},
        {"drawing", &plan->drawing}, {"reference", &plan->reference},
        {"spheres", &plan->spheres}, {"libraries", &plan->libraries},
    };
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        *keys[i].value = entry_value(entries, head, keys[i].key);
    plan->verdict = path_of(plan->built, "verdict", "");
    plan->figures = path_of(plan->built, "figures", "");
    plan->hash = HASH_BEGIN;
    for (int i = 0; i < plan->all.count; i++)
        plan->hash = hash_string(plan->hash, entries[i].value);
    for (int i = head; i < plan->all.count;) {
        int end = i + 1;
        while (end < plan->all.count && strcmp(entries[end].key, "chapter") != 0)
            end++;
        if (plan->count == MOST_CHAPTERS)
            return complain(path, "too many chapters");
        plan->chapters[plan->count++] =
            (PlannedChapter){entries[i].value, entry_value(entries + i, end - i, "objects"),
                             entry_value(entries + i, end - i, "stands on"),
                             entry_value(entries + i, end - i, "right"),
                             entry_value(entries + i, end - i, "program")};
        i = end;
    }
    return true;
}

void plan_free(JudgingPlan *plan)
{
    entries_free(&plan->all);
    *plan = (JudgingPlan){0};
}

int plan_chapter(const JudgingPlan *plan, const char *stem)
{
    for (int i = 0; i < plan->count; i++)
        if (strcmp(plan->chapters[i].stem, stem) == 0)
            return i;
    return -1;
}

bool plan_depends_on(const JudgingPlan *plan, int chapter, int other)
{
    return names_include(plan->chapters[chapter].stands_on, plan->chapters[other].stem);
}

PlanPath path_of(const char *folder, const char *name, const char *ending)
{
    PlanPath path;
    if (snprintf(path.s, sizeof path.s, "%s/%s%s", folder, name, ending) >= (int)sizeof path.s)
        path.s[0] = '\0'; // which cannot be opened
    return path;
}

PlanPath plan_answer(const JudgingPlan *plan, int chapter)
{
    PlanPath path = path_of(plan->answers, plan->chapters[chapter].stem, ".c");
    return access(path.s, F_OK) == 0 ? path : plan_blank(plan, chapter);
}

PlanPath plan_blank(const JudgingPlan *plan, int chapter)
{
    return path_of("build/blanks", plan->chapters[chapter].stem, ".c");
}

PlanPath plan_file(const JudgingPlan *plan, int chapter, const char *name)
{
    PlanPath folder = path_of(plan->verdict.s, plan->chapters[chapter].stem, "");
    return path_of(folder.s, name, "");
}

PlanPath plan_beside(const JudgingPlan *plan, int chapter, const char *ending)
{
    return path_of(plan->verdict.s, plan->chapters[chapter].stem, ending);
}

// ---- the commands ------------------------------------------------------------------------------

int run_line(const char *output, int seconds, const char *format, ...)
{
    enum { MOST_WORDS = 400 };
    char *line = NULL, *words[MOST_WORDS + 1];
    size_t size;
    int count = 0;
    FILE *out = open_memstream(&line, &size);
    if (out == NULL)
        abort();
    va_list given;
    va_start(given, format);
    vfprintf(out, format, given);
    va_end(given);
    fclose(out);
    for (char *rest = line, *word; (word = strtok_r(rest, " ", &rest)) != NULL;) {
        if (count == MOST_WORDS) {
            fprintf(stderr, "a command of more than %d words\n", MOST_WORDS);
            exit(2);
        }
        words[count++] = word;
    }
    words[count] = NULL;
    int status = program_run(words, output, seconds);
    free(line);
    return status;
}

char *options_for(const char *option, const char *names)
{
    char *options = NULL, *copy = strdup(names);
    size_t size;
    FILE *out = open_memstream(&options, &size);
    if (out == NULL)
        abort();
    for (char *rest = copy, *name; (name = strtok_r(rest, " ", &rest)) != NULL;) {
        const char *from = option;
        for (const char *at; (at = strstr(from, "NAME")) != NULL; from = at + strlen("NAME"))
            fprintf(out, "%.*s%s", (int)(at - from), from, name);
        fprintf(out, "%s ", from);
    }
    fclose(out);
    free(copy);
    return options;
}

static int compile_answer(const JudgingPlan *plan, int chapter, const char *source,
                          const char *messages)
{
    return run_line(messages, 0, "%s -o %s %s", plan->compile,
                    plan_file(plan, chapter, "answer.o").s, source);
}

// Helpers of two chapters may have one name: only the exercises of a judged answer stay visible to
// what it is linked with later, other chapters and pictures.
static void hide_helpers(const JudgingPlan *plan, int chapter)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    if (plan->hide[0] != '\0' && access(object.s, F_OK) == 0)
        run_line(NULL, 0, "%s %s", plan->hide, object.s);
}

// ---- one at a time judges a folder of answers --------------------------------------------------

// Waits until nobody else has the folder's lock, and prints a message on stderr if it has to wait.
// -1, and errno, if it cannot be locked. The lock of a program that is killed is free.
static int folder_lock(const char *folder)
{
    PlanPath path = path_of(folder, "lock", "");
    int lock = open(path.s, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0)
        return -1;
    if (flock(lock, LOCK_EX | LOCK_NB) == 0)
        return lock;
    if (errno == EWOULDBLOCK)
        fprintf(stderr, "These answers are already being judged; waiting until that is done ...\n");
    while (flock(lock, LOCK_EX) != 0)
        if (errno != EINTR) {
            close(lock);
            return -1;
        }
    return lock;
}

// The result of a piece of work.
enum { DONE, SAVED_MEANWHILE, TROUBLE };

// The hash of the answer, of the answers that it calls, and of everything that judges it.
static void hash_now(const JudgingPlan *plan, int chapter, char word[HASH_WORD])
{
    uint64_t hash = plan->hash;
    for (int i = 0; i <= chapter; i++)
        if (i == chapter || plan_depends_on(plan, chapter, i))
            hash = hash_file(hash, plan_answer(plan, i).s);
    hash_word(word, hash);
}

bool judging_record(const JudgingPlan *plan, int chapter, ChapterRecord *record)
{
    char word[HASH_WORD];
    hash_now(plan, chapter, word);
    return record_read(plan_beside(plan, chapter, ".record").s, record) &&
           strcmp(record_value(record, "hash"), word) == 0;
}

// Later chapters that call this one are linked with its object, which must be up to date.
static bool needs_judging(const JudgingPlan *plan, int chapter)
{
    ChapterRecord record;
    bool fresh = judging_record(plan, chapter, &record);
    if (fresh && plan->lend[0] == '\0') {
        char word[HASH_WORD];
        hash_word(word, hash_file(HASH_BEGIN, plan_file(plan, chapter, "answer.o").s));
        fresh = strcmp(record_value(&record, "object"), word) == 0;
    }
    chapter_record_free(&record);
    return !fresh;
}

// ---- one chapter -------------------------------------------------------------------------------

static char *kept_text(const JudgingPlan *plan, int chapter, const char *name)
{
    size_t size;
    char *text = whole_text(plan_file(plan, chapter, name).s, &size);
    return text != NULL ? text : strdup("");
}

// The text that an explainer prints about a compiler's or linker's output, as a string to free;
// NULL if it prints nothing.
typedef void Explainer(FILE *out, const char *source, const char *words);
static char *explained(const JudgingPlan *plan, int chapter, Explainer *explainer, const char *said)
{
    char *text = NULL, *words = kept_text(plan, chapter, said);
    size_t size;
    FILE *out = words != NULL && words[0] != '\0' ? open_memstream(&text, &size) : NULL;
    if (out != NULL) {
        explainer(out, plan_answer(plan, chapter).s, words);
        fclose(out);
    }
    free(words);
    return text;
}

static void as_it_is(FILE *out, const char *source, const char *words)
{
    (void)source;
    fputs(words, out);
}

static FILE *begin_record(const JudgingPlan *plan, int chapter, const char *hash, const char *state,
                          const char *words)
{
    FILE *out = record_begin(plan_beside(plan, chapter, ".record").s);
    if (out == NULL)
        return NULL;
    char object[HASH_WORD];
    hash_word(object, hash_file(HASH_BEGIN, plan_file(plan, chapter, "answer.o").s));
    PlanPath answer = plan_answer(plan, chapter);
    entry_put(out, "record", "1");
    entry_put(out, "stem", plan->chapters[chapter].stem);
    entry_put(out, "answer", answer.s);
    entry_put(out, "hash", hash);
    entry_put(out, "object", plan->lend[0] == '\0' ? object : "");
    entry_put(out, "state", state);
    entry_put(out, "words", words);
    if (strcmp(state, "compiler") != 0) {
        char *warnings = explained(plan, chapter, explain, "compiler");
        entry_put(out, "warnings", warnings);
        free(warnings);
    }
    return out;
}

// A text that was saved while it was judged is judged again, because nobody knows which text this
// verdict is about.
static int end_record(const JudgingPlan *plan, int chapter, const char *hash, FILE *out)
{
    const char *stem = plan->chapters[chapter].stem;
    char now[HASH_WORD];
    hash_now(plan, chapter, now);
    if (out != NULL && strcmp(now, hash) != 0) {
        fclose(out);
        return SAVED_MEANWHILE;
    }
    if (out != NULL && record_finish(out, plan_beside(plan, chapter, ".record").s))
        return DONE;
    fprintf(stderr, "%s: its verdict cannot be written: %s\n", stem, strerror(errno));
    return TROUBLE;
}

// words: of the program that said why there is no verdict, explained.
static int give_up(const JudgingPlan *plan, int chapter, const char *hash, const char *state,
                   Explainer *explainer, const char *said)
{
    char *words = explained(plan, chapter, explainer, said);
    FILE *out = begin_record(plan, chapter, hash, state, words);
    free(words);
    return end_record(plan, chapter, hash, out);
}

static bool compiles(const JudgingPlan *plan, int chapter)
{
    PlanPath answer = plan_answer(plan, chapter), said = plan_file(plan, chapter, "compiler");
    mkdir(plan_beside(plan, chapter, "").s, 0777);
    unlink(plan_file(plan, chapter, "answer.o").s);
    if (compile_answer(plan, chapter, answer.s, said.s) == 0)
        return true;
    // The later chapters, which call this one, use its blank.
    if (plan->lend[0] == '\0') {
        compile_answer(plan, chapter, plan_blank(plan, chapter).s, "/dev/null");
        hide_helpers(plan, chapter);
    }
    return false;
}

// lent: exercises that the reference answers.
static bool links(const JudgingPlan *plan, int chapter, const char *program, const char *lent,
                  const char *messages)
{
    char *options = options_for(plan->lend, lent);
    int status = run_line(messages, 0, "%s -o %s %s %s %s -lm", plan->link,
                          plan_file(plan, chapter, program).s, options,
                          plan_file(plan, chapter, "answer.o").s, plan->chapters[chapter].objects);
    free(options);
    return status == 0;
}

// ---- who waits ---------------------------------------------------------------------------------

// Whether it is right if the reference answers those instead.
static bool passes_with_lent(const JudgingPlan *plan, int chapter, const char *function,
                             const char *lent)
{
    return links(plan, chapter, "alone", lent, "/dev/null") &&
           run_line("/dev/null", 0, "%s %s %s --only %s %s", plan->judge,
                    plan->chapters[chapter].stem, plan_file(plan, chapter, "alone").s, function,
                    lent) == 0;
}

// The others that it waits for: one, if that one is enough; none, if it is wrong by itself.
static void wait_for(const JudgingPlan *plan, int chapter, const ChapterRecord *report,
                     const FunctionRecord *wrong, char names[MOST_NAMES])
{
    names_that_may_excuse(report, wrong, names);
    if (names[0] == '\0')
        return;
    if (!passes_with_lent(plan, chapter, wrong->name, names)) {
        names[0] = '\0';
        return;
    }
    char *each = strdup(names);
    bool several = strchr(names, ' ') != NULL;
    for (char *rest = each, *name; several && (name = strtok_r(rest, " ", &rest)) != NULL;)
        if (passes_with_lent(plan, chapter, wrong->name, name)) {
            snprintf(names, MOST_NAMES, "%s", name);
            break;
        }
    free(each);
}

// Without a reference nothing can be lent: it waits for the answers that it calls and that are not
// right, in its chapter and in earlier ones. Adds those of earlier ones to stands, by chapter.
static void wait_for_all(const JudgingPlan *plan, int chapter, const ChapterRecord *report,
                         const FunctionRecord *function, char names[MOST_NAMES],
                         char stands[][MOST_NAMES])
{
    const char *calls = function_value(function, "calls");
    names_that_may_excuse(report, function, names);
    for (int i = 0; i < chapter; i++) {
        ChapterRecord earlier;
        if (!plan_depends_on(plan, chapter, i))
            continue;
        record_read(plan_beside(plan, i, ".record").s, &earlier);
        for (const Exercise *e = exercises; e->name != NULL; e++) {
            const FunctionRecord *other = record_function(&earlier, e->name);
            if (strcmp(e->stem, plan->chapters[i].stem) != 0 || !names_include(calls, e->name) ||
                (other != NULL && function_is(other, "right")))
                continue;
            names_add(names, MOST_NAMES, e->name);
            names_add(stands[i], MOST_NAMES, e->name);
        }
        chapter_record_free(&earlier);
    }
}

// ---- the record --------------------------------------------------------------------------------

static void put_slips(const JudgingPlan *plan, int chapter, const ChapterRecord *report,
                      const FunctionRecord *function, FILE *out)
{
    const char *names[MOST_FUNCTIONS];
    for (int i = 0; i < report->function_count; i++)
        names[i] = report->functions[i].name;
    char *said = kept_text(plan, chapter, "compiler");
    ExplainedSlips slips = explain_slips(plan_answer(plan, chapter).s, said, function->name, names,
                                         (size_t)report->function_count);
    free(said);
    for (char *rest = slips.help, *line;
         rest != NULL && (line = strtok_r(rest, "\n", &rest)) != NULL;)
        entry_put(out, "help", line);
    free(slips.help);
    entry_put(out, "comma", slips.is_comma ? "yes" : "");
}

static int write_record(const JudgingPlan *plan, int chapter, const char *hash)
{
    static char stands[MOST_CHAPTERS][MOST_NAMES];
    static char because[MOST_FUNCTIONS][MOST_NAMES];
    bool lends = plan->lend[0] != '\0';
    ChapterRecord report;
    if (!report_read(plan_file(plan, chapter, "report").s, &report)) {
        chapter_record_free(&report);
        return give_up(plan, chapter, hash, "stopped", as_it_is, "said");
    }
    memset(stands, 0, sizeof stands);
    for (int i = 0; i < report.function_count; i++) {
        const char *state = function_state(&report.functions[i]);
        because[i][0] = '\0';
        if (lends && strcmp(state, "wrong") == 0)
            wait_for(plan, chapter, &report, &report.functions[i], because[i]);
        else if (!lends && strcmp(state, "right") != 0 && strcmp(state, "unanswered") != 0)
            wait_for_all(plan, chapter, &report, &report.functions[i], because[i], stands);
    }
    FILE *out = begin_record(plan, chapter, hash, "judged", "");
    for (int i = 0; out != NULL && i < chapter; i++) {
        char line[MOST_NAMES + 100];
        snprintf(line, sizeof line, "%.90s %.*s", plan->chapters[i].stem, MOST_NAMES - 1,
                 stands[i]);
        entry_put(out, "stands", stands[i][0] != '\0' ? line : "");
    }
    for (int i = 0; out != NULL && i < report.function_count; i++) {
        const FunctionRecord *function = &report.functions[i];
        bool is_wrong = function_is(function, "wrong");
        entry_put(out, "function", function->name);
        for (int k = 0; k < function->count; k++)
            entry_put(out, function->entries[k].key, function->entries[k].value);
        if (is_wrong)
            entry_put(out, "waits", because[i]);
        if (is_wrong)
            put_slips(plan, chapter, &report, function, out);
    }
    chapter_record_free(&report);
    return end_record(plan, chapter, hash, out);
}

static void ask(const JudgingPlan *plan, int chapter)
{
    PlanPath report = plan_file(plan, chapter, "report"), said = plan_file(plan, chapter, "said");
    unlink(report.s);
    mkdir(plan->figures.s, 0777);
    if (run_line(said.s, 0, "%s %s %s %s %s", plan->judge, plan->chapters[chapter].stem,
                 plan_file(plan, chapter, "answering").s, plan_beside(plan, chapter, "").s,
                 plan->figures.s) > 1)
        unlink(report.s);
}

static int judge_chapter(const JudgingPlan *plan, int chapter, const char *hash)
{
    if (!compiles(plan, chapter))
        return give_up(plan, chapter, hash, "compiler", explain, "compiler");
    bool linked = links(plan, chapter, "answering", "", plan_file(plan, chapter, "linker").s);
    hide_helpers(plan, chapter);
    if (!linked)
        return give_up(plan, chapter, hash, "linker", explain_linker, "linker");
    ask(plan, chapter);
    return write_record(plan, chapter, hash);
}

// ---- all of them -------------------------------------------------------------------------------

static bool is_needed(const JudgingPlan *plan, int chapter, const bool wanted[MOST_CHAPTERS])
{
    bool needed = wanted[chapter];
    for (int later = chapter + 1; later < plan->count; later++)
        needed = needed || (wanted[later] && plan_depends_on(plan, later, chapter));
    return needed;
}

bool judging_judge(const JudgingPlan *plan, const bool wanted[MOST_CHAPTERS])
{
    char hashes[MOST_CHAPTERS][HASH_WORD]; // "": not judged now
    bool good = true, saved_meanwhile;
    mkdir(plan->verdict.s, 0777);
    int lock = folder_lock(plan->verdict.s);
    if (lock < 0) {
        fprintf(stderr, "%s: no lock: %s\n", plan->verdict.s, strerror(errno));
        return false;
    }
    do {
        saved_meanwhile = false;
        for (int i = 0; i < plan->count; i++) {
            hashes[i][0] = '\0';
            if (is_needed(plan, i, wanted) && needs_judging(plan, i))
                hash_now(plan, i, hashes[i]);
        }
        // Chapters that this one calls come first: it is linked with them, and reads their records.
        for (int i = 0; i < plan->count; i++) {
            int status = hashes[i][0] != '\0' ? judge_chapter(plan, i, hashes[i]) : DONE;
            saved_meanwhile = saved_meanwhile || status == SAVED_MEANWHILE;
            good = good && status != TROUBLE;
        }
    } while (saved_meanwhile && good);
    close(lock);
    return good;
}
