// show.h - what a student reads and sees of the records: verdicts and pictures.
#ifndef TESTS_COURSE_SHOW_H
#define TESTS_COURSE_SHOW_H

#include "tests/course/judging.h"
#include "tests/course/page.h"

// ---- verdicts (show_verdicts.c) -----------------------------------------------------------------

// Like: the name of another file of the folder that looks like STEM.c: "03-screen (1).c",
// 03-screen.cpp, 03_Screen.c; the newest, or "".
typedef struct {
    bool is_missing;
    char like[256];
} MissingAnswer;
MissingAnswer missing_answer(const char *folder, const char *stem);

// The names of the figures that were shown and are still to be drawn.
enum { MOST_SHOWN = 200 };
typedef struct {
    int count;
    char names[MOST_SHOWN][64];
} ShownFigures;

typedef enum { ALL_RIGHT, SOMETHING_WRONG, BLANKS_LEFT } Standing;

// The first thing that needs work (all: everything), how far the chapters are, and what is next.
Standing show_verdicts(const Page *page, const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS],
                       bool all, ShownFigures *shown);

// A line for each chapter that does not compile or has a wrong function.
void show_faults(const Page *page, const JudgingPlan *plan);

// Says that there is no answer file of a chapter, and what to do.
void show_missing(const Page *page, const JudgingPlan *plan, const char *stem,
                  const MissingAnswer *missing);

// How many functions are right, of all chapters; how many there are; and how many chapters have an
// answer that has not been judged as it is now, so that nothing is known of them.
typedef struct {
    int right, of, unjudged;
} Progress;
Progress progress_so_far(const JudgingPlan *plan);

// The chapter that needs work first, of the chosen ones; -1 if all are right.
int chapter_that_is_next(const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS]);

// Which function a hint is for: the first wrong one, the first blank, or the last that waits; NULL
// if all are right. Which one gdb stops at: the first wrong one, or NULL.
const FunctionRecord *function_for_hint(const ChapterRecord *record);
const FunctionRecord *function_for_debug(const ChapterRecord *record);

// Writes a line about the answers that are wrong among those that the figure calls, and among those
// that these wait for. Nothing if none is.
void figure_note(FILE *out, const JudgingPlan *plan, int count, char *const *called);

// ---- pictures that a student's answers draw: those so far, and a chapter's own
// (answer_pictures.c)

// Draws what the answers of a chapter make possible so far (pictures/pictures.def), and says where
// it is: the function that is wrong, each time; what has become right, once. On a page of limited
// height a picture is a line, and not said again as long as it is the same one.
void show_answer_pictures(const Page *page, const JudgingPlan *plan, int chapter);

// A line, ahead of what needs work: the chapter is right, and which picture it has. It is drawn
// afterwards, so that nobody waits for it.
void reward_line(const Page *page, const JudgingPlan *plan, int chapter);
void reward_draw(const Page *page, const JudgingPlan *plan, int chapter);
// Only this one was chosen: its picture by the reader's own code, and what comes next.
void reward_chapter(const Page *page, const JudgingPlan *plan, int chapter);
// All of them: the last pictures.
void reward_all(const Page *page, const JudgingPlan *plan);

#endif
