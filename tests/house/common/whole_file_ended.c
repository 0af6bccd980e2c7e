// whole_file_ended.c - tests of common/whole_file.c: a program that is ended while it writes.
// Expected: it ends by that signal, the older file is as it was, and no other file is left.
#include "common/whole_file.h"

#include "tests/house/common/image.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

static const int signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGXCPU};
enum { SIGNALS = sizeof signals / sizeof signals[0] };

// Half of the file is on its way when the signal comes.
static bool write_and_raise(FILE *file, const void *given, const char *path, Message *message)
{
    (void)path;
    (void)message;
    fputs("half of it", file);
    fflush(file);
    raise(*(const int *)given);
    fputs(", all of it", file);
    return true;
}

// How a child ends that writes a file meanwhile: its wait status. SIGXCPU must leave no core.
static int ending_by(int number, void (*handler)(int))
{
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
        for (int i = 0; i < SIGNALS; i++)
            signal(signals[i], handler);
        Message message;
        _exit(file_write_whole(in_folder("a.png").s, write_and_raise, &number, &message) ? 0 : 1);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    return status;
}

START_TEST(a_program_that_is_ended_leaves_the_older_file_and_nothing_else)
{
    folder_begin();
    put_file(in_folder("a.png").s, "older");
    for (int i = 0; i < SIGNALS; i++) {
        int status = ending_by(signals[i], SIG_DFL);
        given("signal", "%d", signals[i]);
        expect_law(WIFSIGNALED(status) && WTERMSIG(status) == signals[i], "ended by the signal",
                   "wait status %d", status);
        expect_file(in_folder("a.png").s, "older");
        expect_int(files_in_folder(), 1);
    }
    folder_end();
}
END_TEST

START_TEST(a_signal_that_is_ignored_ends_nothing)
{
    folder_begin();
    for (int i = 0; i < SIGNALS; i++) {
        put_file(in_folder("a.png").s, "older");
        int status = ending_by(signals[i], SIG_IGN);
        given("signal", "%d", signals[i]);
        expect_law(WIFEXITED(status) && WEXITSTATUS(status) == 0, "written", "wait status %d",
                   status);
        expect_file(in_folder("a.png").s, "half of it, all of it");
        expect_int(files_in_folder(), 1);
    }
    folder_end();
}
END_TEST

// Nobody asked for SIGXFSZ to be ignored here: the limit is an error all the same, and no end.
START_TEST(a_limit_on_the_size_of_files_is_an_error_with_words)
{
    Image image = image_of(200, 200);
    for (int i = 0; i < 3 * 200 * 200; i++)
        image.rgb[i] = (uint8_t)random_number(0, 256); // so that it is not compressed
    folder_begin();
    put_file(in_folder("a.png").s, "older");
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        Message message = {""};
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){5000, 5000});
        bool written = image_write_png(&image, in_folder("a.png").s, &message);
        _exit(!written && strstr(message.text, strerror(EFBIG)) != NULL ? 0 : 1);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    given("limit", "5000 bytes");
    expect_law(WIFEXITED(status) && WEXITSTATUS(status) == 0, "an error that says why",
               "wait status %d", status);
    expect_file(in_folder("a.png").s, "older");
    expect_int(files_in_folder(), 1);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(signals_are_as_before_when_it_is_written)
{
    Message message = {""};
    Image image = pattern_of(2, 2);
    struct sigaction was[SIGNALS], limit, action;
    for (int i = 0; i < SIGNALS; i++)
        ck_assert_int_eq(sigaction(signals[i], NULL, &was[i]), 0);
    ck_assert_int_eq(sigaction(SIGXFSZ, NULL, &limit), 0);
    folder_begin();
    ck_assert(image_write_png(&image, in_folder("a.png").s, &message));
    ck_assert(!image_write_png(&image, in_folder("no/a.png").s, &message));
    for (int i = 0; i < SIGNALS; i++) {
        ck_assert_int_eq(sigaction(signals[i], NULL, &action), 0);
        given("signal", "%d", signals[i]);
        expect_law(action.sa_handler == was[i].sa_handler, "as before", "something else");
    }
    ck_assert_int_eq(sigaction(SIGXFSZ, NULL, &action), 0);
    ck_assert(action.sa_handler == limit.sa_handler);
    image_free(&image);
    folder_end();
}
END_TEST

START_TEST(a_file_is_the_same_by_whatever_path)
{
    folder_begin();
    Path file = in_folder("a.nff"), hard = in_folder("b.nff"), soft = in_folder("c.nff");
    Path other = in_folder("other.nff"), around = in_folder("./a.nff");
    put_file(file.s, "");
    put_file(other.s, "");
    ck_assert_int_eq(link(file.s, hard.s), 0);
    ck_assert_int_eq(symlink(file.s, soft.s), 0);
    ck_assert(file_is_same(file.s, file.s));
    ck_assert(file_is_same(file.s, hard.s));
    ck_assert(file_is_same(soft.s, hard.s));
    ck_assert(file_is_same(around.s, file.s));
    ck_assert(!file_is_same(file.s, other.s));
    ck_assert(!file_is_same(file.s, in_folder("none.nff").s));
    ck_assert(!file_is_same(in_folder("none.nff").s, in_folder("none.nff").s));
    ck_assert(!file_is_same("/dev/null", "/dev/null"));
    folder_end();
}
END_TEST

static void list_tests(void)
{
    tests_of("file_write_whole");
    test(a_program_that_is_ended_leaves_the_older_file_and_nothing_else);
    test(a_signal_that_is_ignored_ends_nothing);
    test(a_limit_on_the_size_of_files_is_an_error_with_words);
    test(signals_are_as_before_when_it_is_written);
    tests_of("file_is_same");
    test(a_file_is_the_same_by_whatever_path);
}

OF_STEM(list_tests)
