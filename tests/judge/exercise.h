// exercise.h - the exercises, as tests/exercises.table has them.
#ifndef TESTS_JUDGE_EXERCISE_H
#define TESTS_JUDGE_EXERCISE_H

typedef void AnyFunction(void);

typedef struct {
    const char *name, *stem;
    const char *slide;  // its title
    const char *prompt; // what it asks
    AnyFunction *reference;
} Exercise;

// In the table's order; ends with one whose name is NULL. A number of an exercise is its index.
extern const Exercise exercises[];

// -1 where there is no exercise of this name.
int exercise_number(const char *name);

#endif
