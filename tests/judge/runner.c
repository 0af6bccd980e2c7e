// runner.c - runs the tests with Check: which test is which, and how it ended.
#include "tests/judge/runner.h"

#include "common/answers.h"
#include "tests/course/page.h"
#include "tests/judge/known.h"
#include "tests/judge/test.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

// ---- the record of each test, kept where a crash of the test cannot destroy it -----------------

struct Records {
    size_t size; // bytes
    int count;
    int next; // the test that runs next
    Record records[];
};
static Records *shared;
static Record *record;
static int printed_file = -1;

static void records_begin(int tests)
{
    size_t size = sizeof *shared + (size_t)tests * sizeof(Record);
    shared = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        perror("no memory for the records of the tests");
        _exit(1);
    }
    shared->size = size;
    shared->count = tests;
}

void records_end(void)
{
    if (shared != NULL)
        munmap(shared, shared->size);
    shared = NULL;
}

Records *records_aside(void)
{
    Records *records = shared;
    shared = NULL;
    return records;
}

void records_back(Records *records)
{
    shared = records;
}

const Record *records_find(const Records *records, const char *name)
{
    for (int i = 0; records != NULL && i < records->count; i++)
        if (strcmp(records->records[i].name, name) == 0)
            return &records->records[i];
    return NULL;
}

void records_catch_printed(int file)
{
    printed_file = file;
}

const Record *record_of(int test)
{
    return &shared->records[test];
}

Record *record_now(void)
{
    return record;
}

int record_number(void)
{
    return (int)(record - shared->records);
}

static void record_setup(void)
{
    record = &shared->records[shared->next++];
    random_begin(record->name, record->probe);
    if (printed_file >= 0 && ftruncate(printed_file, 0) != 0)
        perror("what the answer prints");
}

void record_keep_printed(void)
{
    if (printed_file < 0 || record->printed[0] != '\0')
        return;
    ssize_t n = pread(printed_file, record->printed, sizeof record->printed - 1, 0);
    record->printed[n < 0 ? 0 : n] = '\0';
}

void record_missing(const char *name)
{
    if (record->missing[0] == '\0')
        snprintf(record->missing, sizeof record->missing, "%s", name);
}

bool record_is_missing(void)
{
    if (answers_missing() > 0)
        record_missing(answer_missing(0));
    return record->missing[0] != '\0';
}

void record_how(How ended, const char *why)
{
    record_keep_printed();
    record->ended = ended;
    snprintf(record->how, sizeof record->how, "%s", why);
    ck_abort_msg("%s", why);
}

void record_overran(void)
{
    if (record->overran > 0)
        return;
    record->overran = record->cases;
    snprintf(record->overran_given, sizeof record->overran_given, "%s", record->given);
}

static void record_fails_by_overrun(int test)
{
    Record *it = &shared->records[test];
    it->cases = it->overran;
    memcpy(it->given, it->overran_given, sizeof it->given);
    it->ended = HOW_CRASHED;
    snprintf(it->how, sizeof it->how, "wrote past the end of the image or of depth");
}

// A blank never passes, whatever it returned; nor does an answer that calls exit, which Check
// counts as a pass.
static void record_teardown(void)
{
    if (record_is_missing())
        ck_abort_msg("not answered yet");
    record->finished = true;
}

// ---- running them ------------------------------------------------------------------------------

// Compilers write the tests of a file in an order of their own.
void add_test(const char *file, bool is_probe, ListedTest *test)
{
    Stem *stem = stem_of_file(file);
    ListedTest **at = is_probe ? &stem->probes : &stem->tests;
    while (*at != NULL && (*at)->place < test->place)
        at = &(*at)->next;
    test->next = *at;
    *at = test;
}

// Of one function, of one name, or (NULL) all.
static void list_wanted(Suite *suite, const ListedTest *test, const char *function,
                        const char *name, Outcomes *outcomes)
{
    outcomes->count = 0;
    for (; test != NULL; test = test->next) {
        if ((function != NULL && strcmp(test->function, function) != 0) ||
            (name != NULL && strcmp(test->test->name, name) != 0))
            continue;
        if (outcomes->count == MOST_TESTS) {
            fprintf(stderr, "more than %d tests in one list\n", MOST_TESTS);
            exit(1);
        }
        outcomes->tests[outcomes->count++] =
            (Outcome){.name = test->test->name, .function = test->function, .extra = test->extra};
        TCase *tcase = tcase_create(test->function);
        tcase_add_checked_fixture(tcase, record_setup, record_teardown);
        tcase_add_test(tcase, test->test);
        suite_add_tcase(suite, tcase);
    }
}

// Check's words for the ways in which a test can end, in ours.
static void say_how(char *how, size_t size, const char *message)
{
    int number;
    const char *name = strchr(message, '(');
    if (sscanf(message, "Received signal %d", &number) == 1 && number == SIGXFSZ)
        snprintf(how, size, "printed more than a million characters");
    else if (strncmp(message, "Received signal", 15) == 0)
        snprintf(how, size, "crashed %s", name != NULL ? name : "");
    else if (strncmp(message, "Test timeout", 12) == 0)
        snprintf(how, size, "was still running after some seconds: an endless loop?");
    else if (strncmp(message, "Early exit", 10) == 0)
        snprintf(how, size, "ended the program by itself (exit)");
    else
        snprintf(how, size, "%s", message);
}

static bool has_failed(const Outcomes *outcomes, const char *function)
{
    for (int i = 0; i < outcomes->count; i++)
        if (!outcomes->tests[i].passed && strcmp(outcomes->tests[i].function, function) == 0)
            return true;
    return false;
}

// A function that writes past the end of an array is wrong, even if its results are right. If they
// are not, they say more: an array with rows of another length also has a wrong picture.
static void fail_by_overrun(Outcomes *outcomes)
{
    for (int i = 0; i < outcomes->count; i++) {
        Outcome *it = &outcomes->tests[i];
        if (it->record->overran == 0 || has_failed(outcomes, it->function))
            continue;
        record_fails_by_overrun(i);
        it->passed = false;
        say_how(it->how, sizeof it->how, it->record->how);
    }
}

// Check makes a file for each test; in memory that costs next to nothing.
static void keep_files_in_memory(void)
{
    if (access("/dev/shm", W_OK | X_OK) == 0)
        setenv("TEMP", "/dev/shm", 0);
}

static void run(bool probes, const char *function, const char *name, WhereAnswersAre where,
                Outcomes *outcomes)
{
    const Stem *stem = chosen_stem();
    random_take_seed();
    unsetenv("CK_RUN_CASE"); // of those that are listed all run
    unsetenv("CK_RUN_SUITE");
    if (where == ANSWERS_APART)
        keep_files_in_memory();
    Suite *suite = suite_create("tests");
    SRunner *runner = srunner_create(suite);
    list_wanted(suite, probes ? stem->probes : stem->tests, function, name, outcomes);
    if (probes && outcomes->count == 0) {
        srunner_free(runner);
        return;
    }
    records_begin(outcomes->count);
    for (int i = 0; i < outcomes->count; i++)
        shared->records[i] = (Record){.name = outcomes->tests[i].name,
                                      .function = outcomes->tests[i].function,
                                      .extra = outcomes->tests[i].extra,
                                      .probe = probes};
    if (where == ANSWERS_APART)
        srunner_set_fork_status(runner, CK_NOFORK);
    fflush(NULL); // forks must not print it again
    srunner_run_all(runner, CK_SILENT);

    TestResult **results = srunner_results(runner);
    int ran = srunner_ntests_run(runner);
    for (int i = 0; i < outcomes->count; i++) {
        Outcome *outcome = &outcomes->tests[i];
        outcome->record = record_of(i);
        bool passed = i < ran && tr_rtype(results[i]) == CK_PASS;
        outcome->passed = passed && outcome->record->finished;
        if (!outcome->passed)
            say_how(outcome->how, sizeof outcome->how,
                    outcome->record->how[0] != '\0' ? outcome->record->how
                    : passed                        ? "Early exit"
                    : i < ran                       ? tr_msg(results[i])
                                                    : "was not run");
    }
    free(results);
    srunner_free(runner);
    fail_by_overrun(outcomes);
}

void run_tests(const char *function, const char *name, WhereAnswersAre where, Outcomes *outcomes)
{
    run(false, function, name, where, outcomes);
}

void run_probes(const char *function, const char *name, Outcomes *outcomes)
{
    run(true, function, name, ANSWERS_APART, outcomes);
}

void show_outcome(const Outcome *outcome)
{
    enum { COLUMNS = 79 };
    const Record *it = outcome->record;
    show_call(&(Page){.out = stdout, .columns = COLUMNS},
              &(ShownCall){it->hidden, it->given, it->expected, it->yours, it->missing,
                           outcome->how, it->printed});
}
