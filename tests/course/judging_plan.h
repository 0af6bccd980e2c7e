// judging_plan.h - how answers are judged: the commands and files, as make wrote them down.
//
// A file of lines KEY tab VALUE (entries.h), so that a watch can judge again without make, and so
// that everyone else who builds an answering process uses the same commands. Words are separated by
// blanks. First of all chapters:
//
//     answers     the folder of answers
//     built       the folder of everything built from them
//     verdict     the folder of the records (chapter_record.h) and of intermediate files:
//                 STEM/answer.o, STEM/answering, and so on
//     figures     the folder of the figures that the judge draws
//     draw        the command that draws one: DRAW FIGURES NAME
//     blanks      the folder of the blanks, for answers that are not there
//     compile     the command that compiles an answer: COMPILE -o STEM/answer.o ANSWER
//     compile early
//                 the same with precompiled contracts, OBJECT and SOURCE for the names, and a '|'
//                 if two programs are started; or none
//     precompiled the folder of precompiled contracts, exercises/STEM.h.gch, and of sources that
//                 include a contract and then standard input, STEM.c; or none
//     headers     the headers that contracts include
//     hide        a command that hides all but the exercises: HIDE STEM/answer.o; or none
//     link        the command that links an answering process:
//                 LINK [QUICK] -o STEM/answering STEM/answer.o OBJECTS -lm
//     quick       the options by which a quicker linker is chosen; or none
//     directly    the same link without cc, NAME for the program and OBJECTS for the objects: the
//                 command that cc would start; or none
//     lend        the linker's option for each exercise that the reference answers instead of the
//                 answer, NAME for its name: -Wl,--defsym=NAME=lent_NAME; none if the reference
//                 answers none
//     shared      the command that links STEM/answer.so: SHARED STEM/answer.so OBJECTS; or none
//     loading     the folder of the answering processes that load it, and of their names
//     lend shared the same option as lend, for that command
//     lent        the object that it then needs, besides
//     judge       the program that judges: JUDGE STEM STEM/answering FOLDER FIGURES
//     used        files that the commands use, besides
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
//     right       the reference, as an option of the linker; none without a reference
//     program     the files of the chapter's program besides the answers
#ifndef TESTS_COURSE_JUDGING_PLAN_H
#define TESTS_COURSE_JUDGING_PLAN_H

#include "tests/course/entries.h"

enum { MOST_CHAPTERS = 32 };

typedef struct {
    const char *stem, *objects, *stands_on, *right, *program;
} PlannedChapter;

typedef struct {
    Entries all;
    const char *answers, *built, *verdict, *figures, *draw, *blanks;
    const char *compile, *hide, *link, *quick, *lend, *judge, *used;
    const char *reference, *drawing, *spheres, *libraries, *directly;
    const char *compile_early, *precompiled, *headers, *shared, *loading, *lend_shared, *lent;
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
enum { MOST_PLAN_PATH = 4096 };
typedef struct {
    char s[MOST_PLAN_PATH];
} PlanPath;
PlanPath plan_answer(const JudgingPlan *plan, int chapter);
PlanPath plan_file(const JudgingPlan *plan, int chapter, const char *name);     // STEM/NAME
PlanPath plan_beside(const JudgingPlan *plan, int chapter, const char *ending); // STEM.ENDING
PlanPath path_of(const char *folder, const char *name, const char *ending);

#endif
