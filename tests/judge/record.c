// record.c - the record of each test, kept where a crash of the test cannot destroy it.
#include "tests/judge/record.h"

#include "common/answers.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

struct Records {
    size_t size; // bytes
    int count;
    int next; // the test that runs next
    Record records[];
};
static Records *shared;
static Record *record;
static int printed_file = -1;

void records_begin(int tests)
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

void record_is_of(int test, const char *name, const char *function, bool extra, bool probe)
{
    Record *it = &shared->records[test];
    it->name = name;
    it->extra = extra;
    it->probe = probe;
    snprintf(it->function, sizeof it->function, "%s", function);
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

void record_setup(void)
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

void record_fails_by_overrun(int test)
{
    Record *it = &shared->records[test];
    it->cases = it->overran;
    memcpy(it->given, it->overran_given, sizeof it->given);
    it->ended = HOW_CRASHED;
    snprintf(it->how, sizeof it->how, "wrote past the end of the image or of depth");
}

// A blank never passes, whatever it returned; nor does an answer that calls exit, which Check
// counts as a pass.
void record_teardown(void)
{
    if (record_is_missing())
        ck_abort_msg("not answered yet");
    record->finished = true;
}
