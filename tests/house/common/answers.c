// answers.c - tests of common/answers.c: the return value of a blank, and the message about it.
// Expected: the contract in its header. A blank fails the test that calls one, so what concerns
// blanks runs in a child, whose exit status says which of its lines was not true.
#include "common/answers.h"

#include "common/text.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// Runs lines in a child; each returns the number of its first claim that is not true, or 0.
static void expect_all_true(const char *name, int (*claims)(void))
{
    fflush(NULL);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        _exit(claims());
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    given("which claim is not true", "%s", name);
    expect_int(WEXITSTATUS(status), 0);
}

#define CLAIM(number, holds)                                                                       \
    do {                                                                                           \
        if (!(holds))                                                                              \
            return number;                                                                         \
    } while (0)

static double blank_number(void)
{
    return NOT_ANSWERED(double);
}

static int blank_int(void)
{
    return NOT_ANSWERED(int);
}

static Camera blank_camera(void)
{
    return NOT_ANSWERED(Camera);
}

static void blank_void(void)
{
    NOT_ANSWERED_YET();
}

static int a_blank_returns_the_impossible(void)
{
    CLAIM(1, isnan(blank_number()));
    CLAIM(2, blank_int() == -1);
    Camera c = blank_camera();
    CLAIM(3, isnan(c.origin[0]) && isnan(c.right[1]) && isnan(c.forward[2]));
    CLAIM(4, isnan(c.distance) && isnan(c.width) && isnan(c.height));
    CLAIM(5, camera_check(c) == CAMERA_NOT_FINITE);
    return 0;
}

static int blanks_are_remembered_once_each_in_order(void)
{
    CLAIM(1, answers_missing() == 0);
    blank_void();
    CLAIM(2, answers_missing() == 1);
    blank_int();
    blank_int();
    blank_void();
    CLAIM(3, answers_missing() == 2);
    CLAIM(4, strcmp(answer_missing(0), "blank_void") == 0);
    CLAIM(5, strcmp(answer_missing(1), "blank_int") == 0);
    return 0;
}

static int more_blanks_than_anybody_has_do_no_harm(void)
{
    static char names[1000][8];
    for (int i = 0; i < 1000; i++) {
        snprintf(names[i], sizeof names[i], "f%d", i);
        CLAIM(1, not_answered(names[i], "file.c", NULL, 0) == NULL);
    }
    CLAIM(2, answers_missing() > 0 && answers_missing() <= 1000);
    CLAIM(3, strcmp(answer_missing(answers_missing() - 1), "") != 0);
    return 0;
}

static int a_blanks_number_is_shown_as_not_answered(void)
{
    CLAIM(1, strcmp(number_text(NAN).s, "nan") == 0);
    double blank = blank_number();
    vec3 blanks = vec3_of(blank, blank, blank);
    CLAIM(2, strcmp(number_text(blank).s, "not answered yet") == 0);
    CLAIM(3, strcmp(vec3_text(blanks).s, "not answered yet") == 0);
    CLAIM(4, strcmp(pair_text(blank, blank).s, "not answered yet") == 0);
    CLAIM(5, strcmp(number_text(2).s, "2") == 0);
    return 0;
}

// answers_report writes to stderr; a pipe holds what it wrote.
static int the_report_names_file_and_function(void)
{
    int ends[2];
    CLAIM(1, pipe(ends) == 0 && dup2(ends[1], STDERR_FILENO) >= 0);
    CLAIM(2, answers_report() == 0);
    not_answered("upper_left", "exercises/01-corners.c", NULL, 0);
    not_answered("upper_right", "exercises/01-corners.c", NULL, 0);
    CLAIM(3, answers_report() == 1);
    char words[400] = "";
    CLAIM(4, read(ends[0], words, sizeof words - 1) > 0);
    CLAIM(5, strstr(words, "exercises/01-corners.c: not answered yet: upper_left\n") == words);
    CLAIM(6, strstr(words, "\nexercises/01-corners.c: not answered yet: upper_right\n") != NULL);
    return 0;
}

static int an_answer_that_is_called_is_known(void)
{
    CLAIM(1, answers_called() == 0);
    answer_called("upper_left");
    answer_called("upper_right");
    CLAIM(2, answers_called() == 2 && strcmp(answer_that_was_called(1), "upper_right") == 0);
    for (int i = 0; i < 1000; i++)
        answer_called("upper_left");
    for (int i = 0; i < answers_called(); i++)
        CLAIM(3, answer_that_was_called(i) != NULL);
    return 0;
}

// The program ends there, so another process does it.
static int make_gets_one_line_and_goes_on(void)
{
    int ends[2], status;
    CLAIM(1, pipe(ends) == 0 && setenv("NOT_YET", "gallery/x.png", 1) == 0);
    CLAIM(2, answers_report() == 0);
    pid_t process = fork();
    if (process == 0) {
        dup2(ends[1], STDERR_FILENO);
        not_answered("upper_left", "exercises/01-corners.c", NULL, 0);
        not_answered("upper_right", "exercises/01-corners.c", NULL, 0);
        answers_report();
        _exit(7);
    }
    CLAIM(3, waitpid(process, &status, 0) == process && WIFEXITED(status));
    CLAIM(4, WEXITSTATUS(status) == 0);
    char words[400] = "";
    CLAIM(5, read(ends[0], words, sizeof words - 1) > 0);
    CLAIM(6, strcmp(words, "  not yet   gallery/x.png: needs upper_left (and 1 more)\n") == 0);
    return 0;
}

#define EXPECT_ALL_TRUE(claims) expect_all_true(#claims, claims)

TEST(not_answered, what_is_said_of_blanks_is_true)
{
    EXPECT_ALL_TRUE(a_blank_returns_the_impossible);
    EXPECT_ALL_TRUE(blanks_are_remembered_once_each_in_order);
    EXPECT_ALL_TRUE(more_blanks_than_anybody_has_do_no_harm);
    EXPECT_ALL_TRUE(a_blanks_number_is_shown_as_not_answered);
    EXPECT_ALL_TRUE(the_report_names_file_and_function);
    EXPECT_ALL_TRUE(an_answer_that_is_called_is_known);
    EXPECT_ALL_TRUE(make_gets_one_line_and_goes_on);
}
