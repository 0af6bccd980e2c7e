// judging.c - judges the chapters whose record is about another answer than the one that is there.
//
// An answer is compiled, linked with the code that answers the judge's calls, and asked by the
// judge of its chapter. All of that is done by other programs: nothing of an answer is ever loaded
// here.
#include "tests/course/judging.h"

#include "tests/course/call_graph.h"
#include "tests/course/compiling.h"
#include "tests/course/explain.h"
#include "tests/course/folder_lock.h"
#include "tests/course/linking.h"
#include "tests/course/programs.h"
#include "tests/course/shared_answer.h"
#include "tests/course/whole_text.h"
#include "tests/judge/exercise.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// The result of a piece of work.
enum { DONE, NO_VERDICT, SAVED_MEANWHILE, TROUBLE };

static uint64_t hash_of_files(uint64_t hash, const char *names)
{
    Command files = {.count = 0};
    command_words(&files, names);
    for (int i = 0; i < files.count; i++)
        hash = hash_file(hash, files.words[i]);
    command_free(&files);
    return hash;
}

// Most objects are those of several chapters: each is read once.
enum { MOST_OBJECTS = 1000 };
typedef struct {
    char *paths[MOST_OBJECTS];
    uint64_t hashes[MOST_OBJECTS];
    int count;
} HashedObjects;

static uint64_t hash_object(HashedObjects *objects, uint64_t hash, const char *path)
{
    int i = 0;
    while (i < objects->count && strcmp(objects->paths[i], path) != 0)
        i++;
    if (i == MOST_OBJECTS)
        return hash_file(hash, path);
    if (i == objects->count) {
        objects->hashes[i] = hash_file(HASH_BEGIN, path);
        if ((objects->paths[objects->count++] = strdup(path)) == NULL)
            abort();
    }
    return hash_bytes(hash, &objects->hashes[i], sizeof objects->hashes[i]);
}

Judging judging_begin(const JudgingPlan *plan)
{
    static HashedObjects hashed;
    Judging judging = {.plan = plan};
    uint64_t common = HASH_BEGIN;
    for (int i = 0; i < plan->all.count; i++)
        common = hash_string(common, plan->all.entries[i].value);
    common = hash_file(hash_of_files(common, plan->used), plan->judge);
    for (int i = 0; i < plan->count; i++) {
        const PlannedChapter *chapter = &plan->chapters[i];
        judging.tools[i] = common;
        // Objects of other chapters are made from those chapters' texts, which are hashed below.
        Command objects = {.count = 0};
        command_words(&objects, chapter->objects);
        for (int k = 0; k < objects.count; k++)
            if (strncmp(objects.words[k], plan->verdict, strlen(plan->verdict)) != 0)
                judging.tools[i] = hash_object(&hashed, judging.tools[i], objects.words[k]);
        command_free(&objects);
    }
    while (hashed.count > 0)
        free(hashed.paths[--hashed.count]);
    return judging;
}

// The hash of the answer, of the answers that it calls, and of everything that judges it.
static void hash_now(const Judging *judging, int chapter, char word[HASH_WORD])
{
    uint64_t hash = judging->tools[chapter];
    for (int i = 0; i <= chapter; i++)
        if (i == chapter || plan_depends_on(judging->plan, chapter, i))
            hash = hash_file(hash, plan_answer(judging->plan, i).s);
    hash_word(word, hash);
}

bool judging_record(const Judging *judging, int chapter, ChapterRecord *record)
{
    char word[HASH_WORD];
    hash_now(judging, chapter, word);
    return record_read(plan_beside(judging->plan, chapter, ".record").s, record) &&
           strcmp(record_value(record, "hash"), word) == 0;
}

// Later chapters that call this one are linked with its object, which must be up to date.
static bool needs_judging(const Judging *judging, int chapter)
{
    ChapterRecord record;
    bool fresh = judging_record(judging, chapter, &record);
    if (fresh && judging->plan->lend[0] == '\0') {
        char word[HASH_WORD];
        hash_word(word, hash_file(HASH_BEGIN, plan_file(judging->plan, chapter, "answer.o").s));
        fresh = strcmp(record_value(&record, "object"), word) == 0;
    }
    chapter_record_free(&record);
    return !fresh;
}

// ---- one chapter ------------------------------------------------------------------------------

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

static FILE *begin_record(const Judging *judging, int chapter, const char *hash, const char *state,
                          const char *words)
{
    const JudgingPlan *plan = judging->plan;
    FILE *out = record_begin(plan->verdict, plan->chapters[chapter].stem);
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
static int end_record(const Judging *judging, int chapter, const char *hash, FILE *out)
{
    const char *stem = judging->plan->chapters[chapter].stem;
    char now[HASH_WORD];
    hash_now(judging, chapter, now);
    if (out != NULL && strcmp(now, hash) != 0) {
        fclose(out);
        return SAVED_MEANWHILE;
    }
    if (out != NULL && record_finish(out, judging->plan->verdict, stem))
        return DONE;
    fprintf(stderr, "%s: its verdict cannot be written: %s\n", stem, strerror(errno));
    return TROUBLE;
}

static int give_up(const Judging *judging, int chapter, const char *hash, const char *state,
                   const char *words)
{
    FILE *out = begin_record(judging, chapter, hash, state, words);
    return end_record(judging, chapter, hash, out);
}

// Helpers of two chapters may have one name.
static void hide_helpers(const JudgingPlan *plan, int chapter)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    Command command = {.count = 0};
    if (plan->hide[0] == '\0')
        return;
    command_words(&command, plan->hide);
    command_add(&command, object.s);
    program_run(&command, NULL);
    command_free(&command);
}

static int compile_answer(const Judging *judging, int chapter, const char *hash)
{
    const JudgingPlan *plan = judging->plan;
    PlanPath answer = plan_answer(plan, chapter), said = plan_file(plan, chapter, "compiler");
    mkdir(plan_beside(plan, chapter, "").s, 0777);
    unlink(plan_file(plan, chapter, "answer.o").s);
    if (compile_object(plan, chapter, answer.s, said.s) == 0)
        return DONE;
    // The later chapters, which call this one, use its blank.
    if (plan->lend[0] == '\0') {
        PlanPath blank = path_of(plan->blanks, plan->chapters[chapter].stem, ".c");
        compile_object(plan, chapter, blank.s, "/dev/null");
        hide_helpers(plan, chapter);
    }
    char *words = explained(plan, chapter, explain, "compiler");
    int status = give_up(judging, chapter, hash, "compiler", words);
    free(words);
    return status == DONE ? NO_VERDICT : status;
}

// lent: exercises that the reference answers.
static int link_answering(const JudgingPlan *plan, int chapter, const char *program,
                          const char *lent, const char *said)
{
    PlanPath output = plan_file(plan, chapter, program),
             object = plan_file(plan, chapter, "answer.o");
    if (shared_answer_link(plan, chapter, output.s, lent))
        return 0;
    Linking linking = linking_begin(plan, output.s);
    Command names = {.count = 0};
    command_words(&names, lent);
    for (int i = 0; i < names.count; i++)
        linking_tell(&linking, plan->lend, names.words[i]);
    command_free(&names);
    linking_add(&linking, object.s);
    linking_add(&linking, plan->chapters[chapter].objects);
    return linking_end(&linking, said);
}

// ---- who waits --------------------------------------------------------------------------------

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
    bool passes = program_run(&command, "/dev/null") == 0;
    command_free(&command);
    return passes;
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

// ---- unsure ------------------------------------------------------------------------------------

// Without a reference: the answers that it calls and that are not right, in its chapter and in
// earlier ones. Adds those of earlier ones to stands, by chapter.
static void be_unsure(const Judging *judging, int chapter, const ChapterRecord *report,
                      const FunctionRecord *function, char names[MOST_NAMES],
                      char stands[][MOST_NAMES])
{
    const JudgingPlan *plan = judging->plan;
    const char *calls = function_value(function, "calls");
    names_that_may_excuse(report, function, names);
    for (int i = 0; i < chapter; i++) {
        const char *of_stem[MOST_FUNCTIONS + 1] = {NULL};
        int count = 0;
        for (int k = 0; exercises[k].name != NULL; k++)
            if (strcmp(exercises[k].stem, plan->chapters[i].stem) == 0 && count < MOST_FUNCTIONS)
                of_stem[count++] = exercises[k].name;
        ChapterRecord earlier;
        char others[MOST_NAMES];
        if (!plan_depends_on(plan, chapter, i))
            continue;
        record_read(plan_beside(plan, i, ".record").s, &earlier);
        names_not_right(&earlier, calls, of_stem, others);
        chapter_record_free(&earlier);
        Command words = {.count = 0};
        command_words(&words, others);
        for (int k = 0; k < words.count; k++)
            if (!names_include(stands[i], words.words[k])) {
                size_t length = strlen(stands[i]);
                snprintf(stands[i] + length, MOST_NAMES - length, " %s", words.words[k]);
            }
        command_free(&words);
        size_t length = strlen(names);
        if (others[0] != '\0')
            snprintf(names + length, MOST_NAMES - length, "%s%s", length > 0 ? " " : "", others);
    }
}

// ---- the record -------------------------------------------------------------------------------

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

static int write_record(const Judging *judging, int chapter, const char *hash)
{
    static char stands[MOST_CHAPTERS][MOST_NAMES];
    static char because[MOST_FUNCTIONS][MOST_NAMES];
    const JudgingPlan *plan = judging->plan;
    bool lends = plan->lend[0] != '\0';
    ChapterRecord report;
    if (!report_read(plan_file(plan, chapter, "report").s, &report)) {
        char *said = text_of(plan, chapter, "said");
        int status = give_up(judging, chapter, hash, "stopped", said);
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
            be_unsure(judging, chapter, &report, &report.functions[i], because[i], stands);
    }
    FILE *out = begin_record(judging, chapter, hash, "judged", "");
    for (int i = 0; out != NULL && i < chapter; i++) {
        char line[MOST_NAMES + 100];
        snprintf(line, sizeof line, "%.90s%.*s", plan->chapters[i].stem, MOST_NAMES - 1, stands[i]);
        entry_put(out, "stands", stands[i][0] != '\0' ? line : "");
    }
    for (int i = 0; out != NULL && i < report.function_count; i++) {
        const FunctionRecord *function = &report.functions[i];
        bool is_wrong = strcmp(function_state(function), "wrong") == 0;
        entry_put(out, "function", function->name);
        for (int k = 0; k < function->count; k++)
            entry_put(out, function->entries[k].key, function->entries[k].value);
        if (is_wrong)
            entry_put(out, lends ? "waits" : "unsure", because[i]);
        if (is_wrong)
            put_slips(plan, chapter, &report, function, out);
    }
    chapter_record_free(&report);
    return end_record(judging, chapter, hash, out);
}

// Links and asks. DONE also if there is no verdict: the record tells why.
static int ask(const Judging *judging, int chapter, const char *hash)
{
    const JudgingPlan *plan = judging->plan;
    PlanPath program = plan_file(plan, chapter, "answering"),
             folder = plan_beside(plan, chapter, "");
    PlanPath linker = plan_file(plan, chapter, "linker"), said = plan_file(plan, chapter, "said");
    unlink(plan_file(plan, chapter, "report").s);
    int linked = link_answering(plan, chapter, "answering", "", linker.s);
    hide_helpers(plan, chapter);
    if (linked != 0) {
        char *words = explained(plan, chapter, explain_linker, "linker");
        int status = give_up(judging, chapter, hash, "linker", words);
        free(words);
        return status == DONE ? NO_VERDICT : status;
    }
    mkdir(plan->figures, 0777);
    Command command = {.count = 0};
    command_add(&command, plan->judge);
    command_add(&command, plan->chapters[chapter].stem);
    command_add(&command, program.s);
    command_add(&command, folder.s);
    command_add(&command, plan->figures);
    if (program_run(&command, said.s) > 1)
        unlink(plan_file(plan, chapter, "report").s);
    command_free(&command);
    return DONE;
}

// ---- all of them ------------------------------------------------------------------------------

typedef struct {
    const Judging *judging;
    int count, chapters[MOST_CHAPTERS];
    char hashes[MOST_CHAPTERS][HASH_WORD];
} Work;

static int compile_one(int number, void *given)
{
    const Work *work = given;
    return compile_answer(work->judging, work->chapters[number], work->hashes[number]);
}

static int judge_one(int number, void *given)
{
    const Work *work = given;
    int chapter = work->chapters[number];
    int status = ask(work->judging, chapter, work->hashes[number]);
    // A record that needs other chapters of this run is written after all of them have been asked.
    if (status == DONE && work->judging->plan->lend[0] != '\0')
        status = write_record(work->judging, chapter, work->hashes[number]);
    return status;
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
    work_side_by_side(work->count, judge_one, work, statuses);
    int asked = keep_done(work, statuses);
    gravest = asked > gravest ? asked : gravest;
    for (int i = 0; i < work->count && work->judging->plan->lend[0] == '\0'; i++) {
        int written = write_record(work->judging, work->chapters[i], work->hashes[i]);
        gravest = written > gravest ? written : gravest;
    }
    return gravest;
}

static void collect(Work *work, const bool wanted[MOST_CHAPTERS])
{
    const JudgingPlan *plan = work->judging->plan;
    work->count = 0;
    for (int i = 0; i < plan->count; i++) {
        bool needed = wanted[i];
        for (int k = i + 1; k < plan->count; k++)
            needed = needed || (wanted[k] && plan_depends_on(plan, k, i));
        if (!needed || !needs_judging(work->judging, i))
            continue;
        hash_now(work->judging, i, work->hashes[work->count]);
        work->chapters[work->count++] = i;
    }
}

bool judging_judge(const Judging *judging, const bool wanted[MOST_CHAPTERS])
{
    const JudgingPlan *plan = judging->plan;
    Work work = {.judging = judging};
    mkdir(plan->verdict, 0777);
    int lock = folder_lock(plan->verdict);
    if (lock < 0) {
        fprintf(stderr, "%s: no lock: %s\n", plan->verdict, strerror(errno));
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
