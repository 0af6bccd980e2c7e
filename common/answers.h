// answers.h - how a blank says that it has not been answered yet.
//
// A blank returns NOT_ANSWERED(type): all ones, that is, NaN in every double and -1 in every
// int, so that no test passes by luck; and its name is kept, so that programs and tests say
// 'not answered yet' and not 'wrong'.
#ifndef COMMON_ANSWERS_H
#define COMMON_ANSWERS_H

#include <stddef.h>
#include <stdio.h> // an answer may print what it computes: the verdict shows it

#define NOT_ANSWERED(type) (*(type *)not_answered(__func__, __FILE__, &(type){0}, sizeof(type)))
#define NOT_ANSWERED_YET() ((void)not_answered(__func__, __FILE__, NULL, 0))

// Notes that this function of this file was called and is a blank. Fills value, and returns it.
void *not_answered(const char *function, const char *file, void *value, size_t size);

// How many blanks were called so far, and the name of each, in order of the first call.
int answers_missing(void);
const char *answer_missing(int i);

// Forgets them, so that the next call stands for itself.
void answers_forget(void);

// Notes that this answer was called, once for each name: the names are kept, not copied. Only in
// programs whose calls pass tests/judge/answers_called.c.
void answer_called(const char *function);
int answers_called(void);
const char *answer_that_was_called(int i);

// Names on stderr what was called and is not answered yet. Returns what main returns: 0, or 1 if
// there was any. With NOT_YET=PICTURE in the environment (make sets it), the picture lacks them:
// one line says so, and the program ends with 0.
int answers_report(void);

#endif
