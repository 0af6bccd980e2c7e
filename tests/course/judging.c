// judging.c - judges the chapters whose record is about another answer than the one that is there.
//
// An answer is compiled, linked with the code that answers the judge's calls, and asked by the
// judge of its chapter. All of that is done by other programs: nothing of an answer is ever loaded
// here.
#include "tests/course/judging.h"

#include "tests/course/chapter_record.h"
#include "tests/explain/explain.h"
#include "tests/judge/exercise.h"

#include <errno.h>
#include <fcntl.h>
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
        bool needed;
    } keys[] = {
        {"answers", &plan->answers, true},
        {"built", &plan->built, true},
        {"draw", &plan->draw, true},
        {"compile", &plan->compile, true},
        {"link", &plan->link, true},
        {"hide", &plan->hide, false},
        {"lend", &plan->lend, false},
        {"judge", &plan->judge, true},
        {"drawing", &plan->drawing, true},
        {"spheres", &plan->spheres, true},
        {"reference", &plan->reference, false},
        {"libraries", &plan->libraries, false},
    };
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        *keys[i].value = entry_value(entries, head, keys[i].key);
        if (keys[i].needed && (*keys[i].value)[0] == '\0')
            return complain(path, keys[i].key);
    }
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

void command_add(Command *command, const char *word)
{
    if (command->count == MOST_WORDS) {
        fprintf(stderr, "a command of more than %d words\n", MOST_WORDS);
        exit(2);
    }
    command->words[command->count++] = word;
    command->words[command->count] = NULL;
}

void command_words(Command *command, const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL || command->part_count == MOST_WORDS)
        abort();
    command->parts[command->part_count++] = copy;
    for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest)) != NULL;)
        command_add(command, word);
}

void command_words_for(Command *command, const char *text, const char *name)
{
    char *words = NULL;
    size_t size;
    FILE *out = open_memstream(&words, &size);
    if (out == NULL)
        abort();
    for (const char *at; (at = strstr(text, "NAME")) != NULL; text = at + strlen("NAME"))
        fprintf(out, "%.*s%s", (int)(at - text), text, name);
    fputs(text, out);
    fclose(out);
    command_words(command, words);
    free(words);
}

void command_free(Command *command)
{
    for (int i = 0; i < command->part_count; i++)
        free(command->parts[i]);
    *command = (Command){.count = 0};
}

static int run_and_free(Command *command, const char *output)
{
    int status = program_run(command, output);
    command_free(command);
    return status;
}

// What the compiler says goes into a file.
static int compile_answer(const JudgingPlan *plan, int chapter, const char *source,
                          const char *said)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    Command command = {.count = 0};
    command_words(&command, plan->compile);
    command_add(&command, "-o");
    command_add(&command, object.s);
    command_add(&command, source);
    return run_and_free(&command, said);
}

int link_program(const JudgingPlan *plan, const char *program, Command *objects, const char *said)
{
    Command command = {.count = 0};
    command_words(&command, plan->link);
    command_add(&command, "-o");
    command_add(&command, program);
    for (int i = 0; i < objects->count; i++)
        command_add(&command, objects->words[i]);
    command_add(&command, "-lm");
    int status = run_and_free(&command, said);
    command_free(objects);
    return status;
}

void hide_helpers(const JudgingPlan *plan, int chapter)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    Command command = {.count = 0};
    if (plan->hide[0] == '\0' || access(object.s, F_OK) != 0)
        return;
    command_words(&command, plan->hide);
    command_add(&command, object.s);
    run_and_free(&command, NULL);
}

// ---- one at a time judges a folder of answers --------------------------------------------------

int folder_lock(const char *folder)
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

void folder_unlock(int lock)
{
    if (lock >= 0)
        close(lock);
}

// The result of a piece of work.
enum { DONE, NO_VERDICT, SAVED_MEANWHILE, TROUBLE };

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

static char *text_of(const JudgingPlan *plan, int chapter, const char *name)
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
    char *text = NULL, *words = text_of(plan, chapter, said);
    size_t size;
    FILE *out = words != NULL && words[0] != '\0' ? open_memstream(&text, &size) : NULL;
    if (out != NULL) {
        explainer(out, plan_answer(plan, chapter).s, words);
        fclose(out);
    }
    free(words);
    return text;
}

static FILE *begin_record(const JudgingPlan *plan, int chapter, const char *hash, const char *state,
                          const char *words)
{
    FILE *out = record_begin(plan->verdict.s, plan->chapters[chapter].stem);
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
    if (out != NULL && record_finish(out, plan->verdict.s, stem))
        return DONE;
    fprintf(stderr, "%s: its verdict cannot be written: %s\n", stem, strerror(errno));
    return TROUBLE;
}

static int give_up(const JudgingPlan *plan, int chapter, const char *hash, const char *state,
                   const char *words)
{
    FILE *out = begin_record(plan, chapter, hash, state, words);
    return end_record(plan, chapter, hash, out);
}

static int compile_chapter(const JudgingPlan *plan, int chapter, const char *hash)
{
    PlanPath answer = plan_answer(plan, chapter), said = plan_file(plan, chapter, "compiler");
    mkdir(plan_beside(plan, chapter, "").s, 0777);
    unlink(plan_file(plan, chapter, "answer.o").s);
    if (compile_answer(plan, chapter, answer.s, said.s) == 0)
        return DONE;
    // The later chapters, which call this one, use its blank.
    if (plan->lend[0] == '\0') {
        PlanPath blank = plan_blank(plan, chapter);
        compile_answer(plan, chapter, blank.s, "/dev/null");
        hide_helpers(plan, chapter);
    }
    char *words = explained(plan, chapter, explain, "compiler");
    int status = give_up(plan, chapter, hash, "compiler", words);
    free(words);
    return status == DONE ? NO_VERDICT : status;
}

// lent: exercises that the reference answers.
static int link_answering(const JudgingPlan *plan, int chapter, const char *program,
                          const char *lent, const char *said)
{
    Command objects = {.count = 0}, names = {.count = 0};
    command_words(&names, lent);
    for (int i = 0; i < names.count; i++)
        command_words_for(&objects, plan->lend, names.words[i]);
    command_free(&names);
    command_words(&objects, plan_file(plan, chapter, "answer.o").s);
    command_words(&objects, plan->chapters[chapter].objects);
    return link_program(plan, plan_file(plan, chapter, program).s, &objects, said);
}

// ---- who waits ---------------------------------------------------------------------------------

// Whether it is right if the reference answers those instead.
static bool passes_with_lent(const JudgingPlan *plan, int chapter, const char *function,
                             const char *lent)
{
    PlanPath program = plan_file(plan, chapter, "alone");
    if (link_answering(plan, chapter, "alone", lent, "/dev/null") != 0)
        return false;
    Command command = {.count = 0};
    command_add(&command, plan->judge);
    command_add(&command, plan->chapters[chapter].stem);
    command_add(&command, program.s);
    command_add(&command, "--only");
    command_add(&command, function);
    command_words(&command, lent);
    return run_and_free(&command, "/dev/null") == 0;
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
    Command each = {.count = 0};
    command_words(&each, names);
    for (int i = 0; each.count > 1 && i < each.count; i++)
        if (passes_with_lent(plan, chapter, wrong->name, each.words[i])) {
            snprintf(names, MOST_NAMES, "%s", each.words[i]);
            break;
        }
    command_free(&each);
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
            if (!names_include(stands[i], e->name))
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
    char *said = text_of(plan, chapter, "compiler");
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
        char *said = text_of(plan, chapter, "said");
        int status = give_up(plan, chapter, hash, "stopped", said);
        free(said);
        chapter_record_free(&report);
        return status;
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

static int link_chapter(const JudgingPlan *plan, int chapter, const char *hash)
{
    PlanPath linker = plan_file(plan, chapter, "linker");
    unlink(plan_file(plan, chapter, "report").s);
    int linked = link_answering(plan, chapter, "answering", "", linker.s);
    if (plan->lend[0] == '\0') // later chapters are linked with it
        hide_helpers(plan, chapter);
    if (linked == 0)
        return DONE;
    char *words = explained(plan, chapter, explain_linker, "linker");
    int status = give_up(plan, chapter, hash, "linker", words);
    free(words);
    return status == DONE ? NO_VERDICT : status;
}

static void ask(const JudgingPlan *plan, int chapter)
{
    PlanPath program = plan_file(plan, chapter, "answering"),
             folder = plan_beside(plan, chapter, ""), said = plan_file(plan, chapter, "said");
    mkdir(plan->figures.s, 0777);
    Command command = {.count = 0};
    command_add(&command, plan->judge);
    command_add(&command, plan->chapters[chapter].stem);
    command_add(&command, program.s);
    command_add(&command, folder.s);
    command_add(&command, plan->figures.s);
    if (run_and_free(&command, said.s) > 1)
        unlink(plan_file(plan, chapter, "report").s);
}

// ---- all of them -------------------------------------------------------------------------------

typedef struct {
    const JudgingPlan *plan;
    int count, chapters[MOST_CHAPTERS];
    char hashes[MOST_CHAPTERS][HASH_WORD];
} Work;

static int compile_one(int number, void *given)
{
    const Work *work = given;
    return compile_chapter(work->plan, work->chapters[number], work->hashes[number]);
}

static int link_one(int number, void *given)
{
    const Work *work = given;
    return link_chapter(work->plan, work->chapters[number], work->hashes[number]);
}

static int judge_one(int number, void *given)
{
    const Work *work = given;
    int chapter = work->chapters[number];
    ask(work->plan, chapter);
    // A record that needs other chapters of this run is written after all of them have been asked.
    return work->plan->lend[0] == '\0' ? DONE
                                       : write_record(work->plan, chapter, work->hashes[number]);
}

// Those that have been done go on. The gravest of the statuses.
static int keep_done(Work *work, const int *statuses)
{
    int kept = 0, gravest = DONE;
    for (int i = 0; i < work->count; i++) {
        int status = statuses[i] < 0 ? TROUBLE : statuses[i];
        gravest = status > gravest ? status : gravest;
        if (status != DONE)
            continue;
        work->chapters[kept] = work->chapters[i];
        memmove(work->hashes[kept++], work->hashes[i], HASH_WORD);
    }
    work->count = kept;
    return gravest;
}

static int judge(Work *work)
{
    int statuses[MOST_CHAPTERS];
    work_side_by_side(work->count, compile_one, work, statuses);
    int gravest = keep_done(work, statuses);
    // If chapters are linked with earlier ones, the helpers of those must be hidden by then.
    if (work->plan->lend[0] != '\0')
        work_side_by_side(work->count, link_one, work, statuses);
    for (int i = 0; i < work->count && work->plan->lend[0] == '\0'; i++)
        statuses[i] = link_one(i, work);
    int linked = keep_done(work, statuses);
    work_side_by_side(work->count, judge_one, work, statuses);
    int asked = keep_done(work, statuses);
    gravest = linked > gravest ? linked : gravest;
    gravest = asked > gravest ? asked : gravest;
    for (int i = 0; i < work->count && work->plan->lend[0] == '\0'; i++) {
        int written = write_record(work->plan, work->chapters[i], work->hashes[i]);
        gravest = written > gravest ? written : gravest;
    }
    return gravest;
}

static void collect(Work *work, const bool wanted[MOST_CHAPTERS])
{
    const JudgingPlan *plan = work->plan;
    work->count = 0;
    for (int i = 0; i < plan->count; i++) {
        bool needed = wanted[i];
        for (int k = i + 1; k < plan->count; k++)
            needed = needed || (wanted[k] && plan_depends_on(plan, k, i));
        if (!needed || !needs_judging(work->plan, i))
            continue;
        hash_now(work->plan, i, work->hashes[work->count]);
        work->chapters[work->count++] = i;
    }
}

bool judging_judge(const JudgingPlan *plan, const bool wanted[MOST_CHAPTERS])
{
    Work work = {.plan = plan};
    mkdir(plan->verdict.s, 0777);
    int lock = folder_lock(plan->verdict.s);
    if (lock < 0) {
        fprintf(stderr, "%s: no lock: %s\n", plan->verdict.s, strerror(errno));
        return false;
    }
    int status;
    do {
        collect(&work, wanted);
        status = judge(&work);
    } while (status == SAVED_MEANWHILE);
    folder_unlock(lock);
    return status < SAVED_MEANWHILE;
}
