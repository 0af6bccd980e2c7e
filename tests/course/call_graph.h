// call_graph.h - which answers fail perhaps only because another one that they call is not right.
#ifndef TESTS_COURSE_CALL_GRAPH_H
#define TESTS_COURSE_CALL_GRAPH_H

#include "tests/course/chapter_record.h"

// Whether a word is among others, which blanks separate.
bool names_include(const char *names, const char *name);

// For a wrong answer of this chapter: the others of the chapter that it entered and that are not
// right either, with a blank between them. Two that call each other do not excuse each other.
enum { MOST_NAMES = 4000 };
void names_that_may_excuse(const ChapterRecord *record, const FunctionRecord *wrong,
                           char names[MOST_NAMES]);

// For any answer: those of an earlier chapter that it entered and that are not right; all, if that
// chapter has no verdict. calls: what the answer entered.
void names_not_right(const ChapterRecord *earlier, const char *calls, const char *const *exercises,
                     char names[MOST_NAMES]);

#endif
