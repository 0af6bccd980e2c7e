// programs.h - starts programs, and ends them when it is ended itself.
#ifndef TESTS_COURSE_PROGRAMS_H
#define TESTS_COURSE_PROGRAMS_H

#include <stdbool.h>
#include <stddef.h>

// The words of a command, one after the other.
enum { MOST_WORDS = 400 };
typedef struct {
    const char *words[MOST_WORDS + 1];
    int count;
    char *parts[MOST_WORDS]; // to free
    int part_count;
} Command;

void command_add(Command *command, const char *word);   // one word, which must stay there
void command_words(Command *command, const char *text); // words that blanks separate
// The same, with each NAME in the text replaced by a name.
void command_words_for(Command *command, const char *text, const char *name);
void command_free(Command *command);

// From now on Ctrl-C, a closed terminal or kill ends what was started, then this program.
void programs_end_with_us(void);
// From now on Ctrl-C is the end that is expected: exit status 0, so that make has no error to
// print.
void programs_end_as_usual_by_interrupt(void);

// Whether there is a program of this name in PATH.
bool program_is_there(const char *name);

// Runs it, its input from /dev/null, and its output into a file (NULL: to our own output). Its exit
// status; 128 and more after a signal; 127 if it cannot be started. V=1 in the environment shows
// the command.
int program_run(const Command *command, const char *output);
// The same; the system ends it after this many seconds of processor time.
int program_run_for(const Command *command, const char *output, int seconds);

// Does a piece of work for each number from 0 to count - 1, each in a process of its own, as many
// at a time as there are processors; its status is what the work returns, or -1.
void work_side_by_side(int count, int (*work)(int number, void *given), void *given, int *statuses);

#endif
