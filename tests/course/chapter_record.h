// chapter_record.h - the verdict on one chapter: written once, read by every program that shows or
// uses it.
//
// A record is the file STEM.record, lines of KEY tab VALUE (entries.h), in this order:
//
// - record: 1, the number of this format
// - stem: 01-corners
// - answer: the judged file, the student's or the blank
// - hash: of the bytes of that file and of everything that judged it; a record with another hash is
//   about another answer
// - state: judged, or compiler, linker, stopped if there is no verdict, and words say why
// - words: the message of the compiler or the linker, explained, or of the judge when it stopped
// - warnings: the compiler's warnings about an answer that compiles, explained
// - stands: STEM NAME..., answers of an earlier chapter that this one calls and that are not right;
//   a line for each such chapter
// - function: the judge's report on each exercise (tests/judge/report.h), and after each
//   - waits: NAME..., the function passes if the reference answers these instead
//   - unsure: NAME..., the function calls these, which are not right; more is not known
//   - help: a line of help about a cause that only the code shows
//   - comma: yes, it has a decimal comma, so that no other mistake is named
// - end: the hash of all lines above
//
// It is written under another name and renamed, so that every reader sees the old record or the new
// one. A record that is cut short, or changed by hand, is invalid.
#ifndef TESTS_COURSE_CHAPTER_RECORD_H
#define TESTS_COURSE_CHAPTER_RECORD_H

#include "tests/course/entries.h"

enum { MOST_FUNCTIONS = 32 }; // of a chapter

typedef struct {
    const char *name;
    const Entry *entries;
    int count;
} FunctionRecord;

typedef struct {
    Entries all;
    int head; // how many entries are before the first function
    int function_count;
    FunctionRecord functions[MOST_FUNCTIONS];
} ChapterRecord;

// False if there is no such record, or it is damaged. Free it in either case.
bool record_read(const char *path, ChapterRecord *record);
// Only the lines of the functions: the judge's report.
bool report_read(const char *path, ChapterRecord *report);
void chapter_record_free(ChapterRecord *record);

const char *record_value(const ChapterRecord *record, const char *key);
const char *function_value(const FunctionRecord *function, const char *key);
const FunctionRecord *record_function(const ChapterRecord *record, const char *name); // or NULL

// How an answer of the chapter is, in one word: right, wrong (also if it crashed or timed out),
// unanswered, waiting, unsure.
const char *function_state(const FunctionRecord *function);
// The names that it waits for, or is unsure because of; "" if there are none.
const char *function_because(const FunctionRecord *function);

// The chapter: right, wrong, begun (some are right, none wrong), blank; compiler, linker, stopped.
const char *record_state(const ChapterRecord *record);

// Ends the lines that were written to file, which is FOLDER/STEM.record.new, and renames it to
// FOLDER/STEM.record. False, and errno, if that fails; the old record is then unchanged.
bool record_finish(FILE *file, const char *folder, const char *stem);
FILE *record_begin(const char *folder, const char *stem);

#endif
