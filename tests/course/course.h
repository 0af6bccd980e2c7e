// course.h - the parts of the program that judges answers (course.c), and the plan that make has
// written for it.
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
//     spheres     the scene that these pictures show, and its recorded colors
//     libraries   the libraries that pictures are linked with
//
// Then each chapter:
//
//     chapter     01-corners
//     objects     the objects of the answering process besides the answer
//     stands on   the chapters whose answers are among the objects; none if the reference's are
//     right       the reference, as an object; none without a reference
//     program     the files of the chapter's program besides the answers
#ifndef TESTS_COURSE_COURSE_H
#define TESTS_COURSE_COURSE_H

#include "tests/course/chapter_record.h"
#include "tests/course/page.h"

#include <stdint.h>

// ---- programs (programs.c; on the page, chapters/book/instead/programs.c) -----------------------

// From now on Ctrl-C, a closed terminal or kill ends what was started, then this program.
void programs_end_with_us(void);
// From now on Ctrl-C is the end that is expected: exit status 0, so that make has no error to
// print.
void programs_end_as_usual_by_interrupt(void);

// Whether there is a program of this name in PATH.
bool program_is_there(const char *name);

// Runs a program: its name and its arguments, then NULL. Its input comes from /dev/null, its output
// goes into a file (NULL: to our own output). The system ends it after this many seconds of
// processor time (0: never). Its exit status; 128 and more after a signal; 127 if it cannot be
// started. V=1 in the environment shows the command.
int program_run(char *const *words, const char *output, int seconds);

// ---- the plan (judging.c) -----------------------------------------------------------------------

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

// ---- judging (judging.c) ------------------------------------------------------------------------

// Runs a command: a line of words, which blanks separate, and where its output goes.
int run_line(const char *output, int seconds, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// An option of the plan for each of these names, which is in the place of NAME in it; to free.
char *options_for(const char *option, const char *names);

// The record of a chapter. False if there is none, or it is about another text.
bool judging_record(const JudgingPlan *plan, int chapter, ChapterRecord *record);

// Judges those of the wanted chapters, and of those that they call, whose record is out of date.
// Waits for another run in the same folder. False, and a message on stderr, if a record cannot be
// written.
bool judging_judge(const JudgingPlan *plan, const bool wanted[MOST_CHAPTERS]);

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
// if all are right.
const FunctionRecord *function_for_hint(const ChapterRecord *record);

// The test that failed: its name, as a sentence.
typedef struct {
    char s[400];
} TestSentence;
TestSentence test_sentence(const FunctionRecord *function);

// Writes a line about the answers that are wrong among those that the figure calls, and among those
// that these wait for. Nothing if none is.
void figure_note(FILE *out, const JudgingPlan *plan, int count, char *const *called);

// ---- pictures that a student's answers draw (answer_pictures.c) --------------------------------

// Draws what the answers of a chapter make possible so far (pictures/pictures.def), and says where
// it is: the function that is wrong, each time; what has become right, once, or again. On a brief
// page a picture is a line, and not said again as long as it is the same one.
void show_answer_pictures(const Page *page, const JudgingPlan *plan, int chapter, bool again);

// A line, ahead of what needs work: the chapter is right, and which picture it has. It is drawn
// afterwards, so that nobody waits for it.
void reward_line(const Page *page, const JudgingPlan *plan, int chapter);
void reward_draw(const Page *page, const JudgingPlan *plan, int chapter);
// Only this one was chosen: its picture by the reader's own code, and what comes next.
void reward_chapter(const Page *page, const JudgingPlan *plan, int chapter);
// All of them: the last pictures.
void reward_all(const Page *page, const JudgingPlan *plan);
// A file that remembers that a picture was shown.
void set_mark(const char *path);

#endif
