// chapter_record.h - the verdict on one chapter: written once, read by every program that shows or
// uses it.
//
// A record is the file STEM.record, lines of KEY tab VALUE, in this order:
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
// - function: the judge's report on each exercise (tests/judge/judge.c), and after each
//   - waits: NAME..., the function is wrong, but passes if the reference answers these instead; in
//     the students' archive, which has no reference: it calls these, which are not right
//   - help: a line of help about a cause that only the code shows
//   - comma: yes, it has a decimal comma, so that no other mistake is named
// - end
//
// It is written under another name and renamed, so that every reader sees the old record or the new
// one. A record that is cut short is invalid.
#ifndef TESTS_COURSE_CHAPTER_RECORD_H
#define TESTS_COURSE_CHAPTER_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

// ---- lines of KEY tab VALUE --------------------------------------------------------------------

// In a value \n, \t and \\ are a line's end, a tab and a backslash, and \xNN is a byte that is not
// printable: a value may be any text, and a line has one.

typedef struct {
    const char *key, *value;
} Entry;

typedef struct {
    char *text; // keys and values are in it
    Entry *entries;
    int count;
} Entries;

// Writes a line, unless the value is NULL or empty.
void entry_put(FILE *out, const char *key, const char *value);

// Reads a file's lines. False if it cannot be read or a line is invalid. Free them in either case.
bool entries_read(const char *path, Entries *entries);
void entries_free(Entries *entries);

// The value of the first of count entries that has this key; "" if there is none.
const char *entry_value(const Entry *entries, int count, const char *key);

// All of a file, with a '\0' after it; free it. NULL if it cannot be read.
char *whole_text(const char *path, size_t *size);

// Texts that differ have different hashes, but for a chance of 1 in 2^64: nobody is attacked by an
// equal one, only mistaken. Begin with HASH_BEGIN, and go on with what came before.
#define HASH_BEGIN 0xcbf29ce484222325u
uint64_t hash_string(uint64_t hash, const char *text);
// Of a file's name and its bytes; of one that is not there, that it is not.
uint64_t hash_file(uint64_t hash, const char *path);

enum { HASH_WORD = 17 };
void hash_word(char word[HASH_WORD], uint64_t hash);

// ---- the record --------------------------------------------------------------------------------

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

// False if there is no such record, or it is not whole. Free it in either case.
bool record_read(const char *path, ChapterRecord *record);
// Only the lines of the functions: the judge's report.
bool report_read(const char *path, ChapterRecord *report);
void chapter_record_free(ChapterRecord *record);

const char *record_value(const ChapterRecord *record, const char *key);
const char *function_value(const FunctionRecord *function, const char *key);
const FunctionRecord *record_function(const ChapterRecord *record, const char *name); // or NULL

// How an answer of the chapter is, in one word: right, wrong (also if it crashed or timed out),
// unanswered, waiting.
const char *function_state(const FunctionRecord *function);
bool function_is(const FunctionRecord *function, const char *state);
// Of a chapter: how many are in that state, and the first of them, or NULL.
int functions_that_are(const ChapterRecord *record, const char *state);
const FunctionRecord *first_that_is(const ChapterRecord *record, const char *state);
// The names that it waits for; "" if there are none.
const char *function_because(const FunctionRecord *function);

// The chapter: right, wrong, begun (some are right, none wrong), blank; compiler, linker, stopped.
const char *record_state(const ChapterRecord *record);

// Writes the lines of a record to PATH.new; ends them, and renames it to PATH. False, and errno, if
// that fails; the old record is then unchanged.
FILE *record_begin(const char *path);
bool record_finish(FILE *file, const char *path);

// Names, which blanks separate: adds those that are not among them and for which there is room, and
// returns whether there was one; whether a name is among them; and with commas, a b c -> a, b, c.
bool names_add(char *names, size_t size, const char *more);
bool names_include(const char *names, const char *name);
void put_names(char *list, size_t size, const char *names);

// For a wrong answer of this chapter: the others of the chapter that it entered and that are not
// right either, with a blank between them. Two that call each other do not excuse each other.
enum { MOST_NAMES = 4000 };
void names_that_may_excuse(const ChapterRecord *record, const FunctionRecord *wrong,
                           char names[MOST_NAMES]);

#endif
