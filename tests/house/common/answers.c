// answers.c - tests of common/answers.c: the return value of a blank, and its text. What is said of
// missing answers is in tests/house/judging.txt. Expected: the contract in its header. A blank
// fails the test that calls one, so what concerns blanks runs in a child, whose exit status says
// which of its lines was not true.
#include "common/answers.h"

#include "common/text.h"
#include "tests/judge/test.h"

#include <stdio.h>
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

#define EXPECT_ALL_TRUE(claims) expect_all_true(#claims, claims)

TEST(not_answered, what_is_said_of_blanks_is_true)
{
    EXPECT_ALL_TRUE(a_blank_returns_the_impossible);
    EXPECT_ALL_TRUE(more_blanks_than_anybody_has_do_no_harm);
    EXPECT_ALL_TRUE(a_blanks_number_is_shown_as_not_answered);
}
