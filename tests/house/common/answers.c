// answers.c - tests of common/answers.c: the return value of a blank, and its text. What is said of
// missing answers is in tests/house/judging.txt. Expected: the contract in its header. A test that
// has called a blank fails, so each forgets it.
#include "common/answers.h"

#include "common/text.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <string.h>

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

TEST(not_answered, a_blank_returns_the_impossible)
{
    int i = blank_int();
    double number = blank_number();
    Camera c = blank_camera();
    answers_forget();
    expect_int(i, -1);
    ck_assert(isnan(number));
    ck_assert(isnan(c.origin[0]) && isnan(c.right[1]) && isnan(c.forward[2]));
    ck_assert(isnan(c.distance) && isnan(c.width) && isnan(c.height));
    ck_assert_int_eq(camera_check(c), CAMERA_NOT_FINITE);
}

TEST(not_answered, more_blanks_than_anybody_has_do_no_harm)
{
    static char names[1000][8];
    for (int i = 0; i < 1000; i++) {
        snprintf(names[i], sizeof names[i], "f%d", i);
        ck_assert_ptr_null(not_answered(names[i], "file.c", NULL, 0));
    }
    ck_assert(answers_missing() > 0 && answers_missing() <= 1000);
    ck_assert_str_ne(answer_missing(answers_missing() - 1), "");
    answers_forget();
}

TEST(not_answered, a_blanks_number_is_shown_as_not_answered)
{
    expect_text(number_text(NAN).s, "nan");
    double blank = blank_number();
    const Text texts[] = {number_text(blank), vec3_text(vec3_of(blank, blank, blank)),
                          pair_text(blank, blank)};
    Text two = number_text(2);
    answers_forget();
    for (int i = 0; i < 3; i++)
        expect_text(texts[i].s, "not answered yet");
    expect_text(two.s, "2");
}
