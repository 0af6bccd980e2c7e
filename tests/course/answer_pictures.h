// answer_pictures.h - pictures that a student's answers draw: those so far, and a chapter's own.
#ifndef TESTS_COURSE_ANSWER_PICTURES_H
#define TESTS_COURSE_ANSWER_PICTURES_H

#include "tests/course/judging.h"
#include "tests/course/page.h"

// Who answers the functions that a picture is drawn by: names, with a blank between them.
enum { MOST_ANSWERS = 1000 };
typedef struct {
    char yours[MOST_ANSWERS], wrong[MOST_ANSWERS]; // by the student: right, and not right yet
    char reference[MOST_ANSWERS], missing[MOST_ANSWERS];
} Answerers;

// Links objects with the answers of a chapter and of those before: the student's, if they are
// judged; the reference's for the others, if there is one. needs: the functions that matter. False
// if one of them is missing, or the linker fails.
bool link_with_answers(const Judging *judging, int chapter, const char *objects, const char *needs,
                       const char *program, Answerers *answerers);

// Says where a picture is, what it shows, who answered, and what is nobody's answer.
void say_picture(const Page *page, const char *path, const char *shows, const Answerers *by,
                 const char *given);

// Draws what the answers of a chapter make possible so far (pictures/pictures.def), and says where
// it is: the function that is wrong, each time; what has become right, once.
void show_answer_pictures(const Page *page, const Judging *judging, int chapter);

// The same for a chapter that is right: the pictures of the first chapters. Again: also if they
// were shown before.
void show_right_pictures(const Page *page, const Judging *judging, int chapter, bool again);

#endif
