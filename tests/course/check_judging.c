// check_judging.c - tests of what judging is made of: the lock, the hashes, the call graph.
// Expected: the contracts in their headers.
#include "tests/course/folder_lock.h"

#include "tests/course/call_graph.h"
#include "tests/course/whole_text.h"
#include "tests/judge/test.h"

#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// Another process that takes the lock, says so through a pipe, and keeps it until it is killed.
static pid_t holder(const char *folder, int *said)
{
    int ends[2];
    if (pipe(ends) != 0)
        abort();
    pid_t pid = fork();
    if (pid == 0) {
        if (freopen("/dev/null", "w", stderr) == NULL || folder_lock(folder) < 0 ||
            write(ends[1], "x", 1) != 1)
            _exit(1);
        for (;;)
            pause();
    }
    close(ends[1]);
    *said = ends[0];
    return pid;
}

static bool has_said(int said, int milliseconds)
{
    char byte;
    struct pollfd end = {said, POLLIN, 0};
    return poll(&end, 1, milliseconds) == 1 && read(said, &byte, 1) == 1;
}

static void kill_holder(pid_t pid)
{
    kill(pid, SIGKILL);
    waitpid(pid, NULL, 0);
}

START_TEST(one_waits_until_the_other_is_done)
{
    char folder[] = "/tmp/lock-XXXXXX", path[100];
    enum { LONG = 60000, MOMENT = 100 };
    if (mkdtemp(folder) == NULL)
        abort();
    int first_said, second_said;
    pid_t first = holder(folder, &first_said);
    given("lock", "held by one");
    expect_law(has_said(first_said, LONG), "held", "not held");
    pid_t second = holder(folder, &second_said);
    expect_law(!has_said(second_said, MOMENT), "the second waits", "it does not");
    kill_holder(first); // whose lock is free then
    expect_law(has_said(second_said, LONG), "the second has it", "it has not");
    kill_holder(second);
    int lock = folder_lock(folder);
    expect_law(lock >= 0, "free", "not free");
    folder_unlock(lock);
    snprintf(path, sizeof path, "%s/lock", folder);
    unlink(path);
    rmdir(folder);
}
END_TEST

START_TEST(texts_that_differ_have_different_hashes)
{
    const char *texts[] = {"",         "a",         "b",          "ab",      "ba",
                           "12345678", "123456789", "1234567890", "01234567"};
    enum { COUNT = sizeof texts / sizeof texts[0] };
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < COUNT; k++) {
            given("texts", "'%s' and '%s'", texts[i], texts[k]);
            expect_int(hash_string(HASH_BEGIN, texts[i]) == hash_string(HASH_BEGIN, texts[k]),
                       i == k);
        }
    given("texts", "in two parts");
    expect_int(hash_string(hash_string(HASH_BEGIN, "a"), "bc") ==
                   hash_string(hash_string(HASH_BEGIN, "ab"), "c"),
               false);
    expect_int(hash_file(HASH_BEGIN, "/nowhere/a") == hash_file(HASH_BEGIN, "/nowhere/b"), false);
}
END_TEST

static void expect_excuses(const Entry *calls, const char *expected)
{
    char names[MOST_NAMES];
    ChapterRecord record = {.function_count = 3};
    const char *function_names[] = {"f", "g", "h"};
    for (int i = 0; i < 3; i++)
        record.functions[i] = (FunctionRecord){function_names[i], calls + 2 * i, 2};
    names_that_may_excuse(&record, &record.functions[0], names);
    given("calls", "f: %s; g: %s; h: %s", calls[1].value, calls[3].value, calls[5].value);
    expect_text(names, expected);
}

START_TEST(only_what_it_calls_and_is_not_right_excuses)
{
    expect_excuses((Entry[]){{"state", "wrong"},
                             {"calls", "g h"},
                             {"state", "wrong"},
                             {"calls", ""},
                             {"state", "right"},
                             {"calls", ""}},
                   "g");
    expect_excuses((Entry[]){{"state", "wrong"},
                             {"calls", "g h"},
                             {"state", "wrong"},
                             {"calls", "h"},
                             {"state", "unanswered"},
                             {"calls", ""}},
                   "g h");
    expect_excuses((Entry[]){{"state", "wrong"},
                             {"calls", ""},
                             {"state", "wrong"},
                             {"calls", ""},
                             {"state", "wrong"},
                             {"calls", ""}},
                   "");
    expect_excuses((Entry[]){{"state", "wrong"},
                             {"calls", "g"},
                             {"state", "wrong"},
                             {"calls", "f"},
                             {"state", "wrong"},
                             {"calls", ""}},
                   "");
}
END_TEST

START_TEST(a_chapter_without_a_verdict_has_nothing_right)
{
    char names[MOST_NAMES];
    ChapterRecord none = {.function_count = 0};
    given("calls", "g h");
    names_not_right(&none, "g h", (const char *[]){"f", "g", "h", NULL}, names);
    expect_text(names, "g h");
}
END_TEST

static void list_tests(void)
{
    tests_of("judging");
    test(one_waits_until_the_other_is_done);
    test(texts_that_differ_have_different_hashes);
    test(only_what_it_calls_and_is_not_right_excuses);
    test(a_chapter_without_a_verdict_has_nothing_right);
}

OF_STEM(list_tests)
