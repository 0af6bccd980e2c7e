// page.h - the page's part, for C programs that run in it: what judge.js does for them.
#ifndef CHAPTERS_BOOK_INSTEAD_PAGE_H
#define CHAPTERS_BOOK_INSTEAD_PAGE_H

#include <stdbool.h>
#include <stddef.h>

#define OF_PAGE(name) __attribute__((import_module("book"), import_name(#name)))

// How an answer's instance ended, if it did.
typedef enum {
    ANSWER_GOES_ON,
    ANSWER_EXITED,
    ANSWER_STEPS, // more of them than one call may take
    ANSWER_UNREACHABLE,
    ANSWER_DIVIDED, // an integer by zero
    ANSWER_STACK,   // overflowed
    ANSWER_MEMORY,  // beyond its end
    ANSWER_PRINTED, // too much
} AnswerEnd;

// For the judge: the instance of the answer's program, unless there is one; and its messages.
OF_PAGE(answer_start) void answer_start(const char *program, double most_steps);
OF_PAGE(answer_stop) int answer_stop(void); // its exit status
OF_PAGE(answer_put) void answer_put(const void *bytes, size_t size);
OF_PAGE(answer_get) AnswerEnd answer_get(void *bytes, size_t size);
OF_PAGE(answer_steps) double answer_steps(void); // of all instances so far

// For the answer: the other end.
OF_PAGE(call_get) bool call_get(void *bytes, size_t size);
OF_PAGE(call_put) void call_put(const void *bytes, size_t size);
void fill_stack_again(void); // with the same byte (steps.c)
OF_PAGE(out_of_steps) _Noreturn void out_of_steps(void);

// For the tests: runs the exported function 'guarded', which may leave. False if it has left.
OF_PAGE(guard) bool guard(void);
OF_PAGE(leave) _Noreturn void leave(void);

// For the program that judges answers: runs another program, its words one after the other, each
// ending with '\0'. What it prints goes into a file, if output is not NULL. Its exit status.
OF_PAGE(program_start)
int program_start(const char *words, size_t size, const char *output, int seconds);
OF_PAGE(program_exists) bool program_exists(const char *name);

#endif
