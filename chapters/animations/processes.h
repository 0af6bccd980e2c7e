// processes.h - the processes that draw frames and make videos, and the files that they write.
#ifndef CHAPTERS_ANIMATIONS_PROCESSES_H
#define CHAPTERS_ANIMATIONS_PROCESSES_H

#include <stdbool.h>
#include <sys/types.h>

typedef struct {
    char s[1200];
} Path;

__attribute__((format(printf, 1, 2))) Path path_of(const char *format, ...);

// Prints a message on stderr, and ends the program.
__attribute__((format(printf, 1, 2), noreturn)) void fail(const char *format, ...);

// ---- files ------------------------------------------------------------------------------------

// Is it there, and was it written after the other?
bool is_newer(Path path, Path other);
bool is_same(Path one, Path other);
void copy(Path from, Path to);
void make_folder(Path path);

// Removes the numbered files from a number on, which an earlier run with more of them has left.
void remove_from(const char *folder, const char *format, int number);

// ---- processes --------------------------------------------------------------------------------

// From now on, a signal that ends this program ends its processes first.
void end_with_processes(void);

// Starts a program, in one of MOST_RUNNING places. Its output goes into a file.
enum { MOST_RUNNING = 64 };
void start(int place, char *const arguments[], Path said);
bool is_free(int place);

// Waits until one of them ends, and returns its place. *succeeded: its exit status was 0.
int wait_for_one(bool *succeeded);

// Both of it, for one program.
bool run(char *const arguments[], Path said);

// Ends all of them, and this program.
__attribute__((noreturn)) void end_all(void);

// Prints a file on stderr, and removes it.
void show(Path said);
bool has_program(const char *name);

#endif
