// judging.h - judges the chapters whose record is about another answer than the one that is there,
// as make has planned it.
//
// A verdict is three commands: COMPILE -o STEM/answer.o ANSWER; LINK -o STEM/answering
// STEM/answer.o OBJECTS -lm; JUDGE STEM STEM/answering FOLDER FIGURES. V=1 in the environment shows
// them. They are in a file, so that a watch judges again without make, and a page (chapters/book/)
// by commands of its own.
//
// A file of lines KEY tab VALUE (chapter_record.h). Words are separated by blanks. First of all
// chapters:
//
//     answers     the folder of answers
//     built       the folder of everything built from them; its folder verdict/ has the records
//                 (chapter_record.h) and intermediate files: STEM/answer.o, STEM/answering, ...
//     compile, link, judge
//                 the three commands
//     tools       a checksum of all that judges: after a change every answer is judged again; or
//                 none
//     hide        a command that hides all but the exercises: HIDE STEM/answer.o; or none
//     lend        the linker's option for each exercise that the reference answers instead of the
//                 answer, NAME for its name: -Wl,--defsym=NAME=lent_NAME; none if the reference
//                 answers none
//     draw        the command that draws a figure: DRAW FIGURES NAME
//     reference   the linker's option for each exercise that the reference answers in a picture,
//                 NAME for its name; none without a reference
//     drawing     the objects that draw a picture of answers, besides these (pictures/draw.c)
//     spheres     the scene that these pictures show, and its recorded colours
//     libraries   the libraries that pictures are linked with
//
// Then each chapter:
//
//     chapter     01-corners
//     objects     the objects of the answering process besides the answer
//     stands on   the chapters whose answers are among the objects; none if the reference's are
//     right       the reference, as an object; none without a reference
//     program     the files of the chapter's program besides the answers
#ifndef TESTS_COURSE_JUDGING_H
#define TESTS_COURSE_JUDGING_H

#include "tests/course/chapter_record.h"
#include "tests/course/programs.h"

#include <stdint.h>

enum { MOST_CHAPTERS = 32 };

typedef struct {
    const char *stem, *objects, *stands_on, *right, *program;
} PlannedChapter;

enum { MOST_PLAN_PATH = 4096 };
typedef struct {
    char s[MOST_PLAN_PATH];
} PlanPath;

typedef struct {
    Entries all;
    uint64_t hash; // of all of it
    const char *answers, *built, *compile, *hide, *link, *lend, *judge;
    const char *draw, *reference, *drawing, *spheres, *libraries;
    PlanPath verdict, figures; // folders in built
    int count;
    PlannedChapter chapters[MOST_CHAPTERS];
} JudgingPlan;

// False, and a message on stderr, if there is no such plan. Free it in either case.
bool plan_read(const char *path, JudgingPlan *plan);
void plan_free(JudgingPlan *plan);

// The chapter's number, or -1.
int plan_chapter(const JudgingPlan *plan, const char *stem);
// Whether a chapter calls the answers of another.
bool plan_depends_on(const JudgingPlan *plan, int chapter, int other);

// The file that answers a chapter: the student's, or the blank. Also files in the verdict's folder.
PlanPath plan_answer(const JudgingPlan *plan, int chapter);
PlanPath plan_file(const JudgingPlan *plan, int chapter, const char *name);     // STEM/NAME
PlanPath plan_beside(const JudgingPlan *plan, int chapter, const char *ending); // STEM.ENDING
PlanPath path_of(const char *folder, const char *name, const char *ending);
PlanPath plan_blank(const JudgingPlan *plan, int chapter);

// Runs a command: a line of words, which blanks separate, and where its output goes (programs.h).
int run_line(const char *output, int seconds, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Writes a blank, then an option of the plan with a name in the place of each NAME in it.
void put_option(FILE *line, const char *option, const char *name);

// Links objects with answers. The linker's exit status; its messages go into a file.
int link_program(const JudgingPlan *plan, const char *program, const char *objects,
                 const char *messages);

// Helpers of two chapters may have one name: only the exercises of a judged answer stay visible.
void hide_helpers(const JudgingPlan *plan, int chapter);

// The record of a chapter. False if there is none, or it is about another text.
bool judging_record(const JudgingPlan *plan, int chapter, ChapterRecord *record);

// Judges those of the wanted chapters, and of those that they call, whose record is out of date.
// Waits for another run in the same folder. False, and a message on stderr, if a record cannot be
// written.
bool judging_judge(const JudgingPlan *plan, const bool wanted[MOST_CHAPTERS]);

// Waits until nobody else has the folder's lock, and prints a message on stderr if it has to wait.
// Returns the argument of folder_unlock; or -1, and errno, if it cannot be locked. The lock of a
// program that is killed is free.
int folder_lock(const char *folder);
void folder_unlock(int lock);

#endif
