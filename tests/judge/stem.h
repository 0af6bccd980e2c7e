// stem.h - what is known of each stem, and which stem this run of the program is about.
//
// A program holds the tests of all stems. Each file of a stem adds what it defines:
//
//     static void list_tests(void) { ... }
//     OF_STEM(list_tests)
//
// The stem is the file's: 05-quadratic of tests/05-quadratic.c and of
// tests/05-quadratic/mistakes.c.
#ifndef TESTS_JUDGE_STEM_H
#define TESTS_JUDGE_STEM_H

struct Mistake;
struct Variant;
struct Unknown;
struct Composed;
struct SameMistake;
struct Generated;

typedef struct {
    char name[64];
    void (*load)(void); // called when the stem is chosen; may be NULL
    void (*list_tests)(void);
    void (*list_probes)(void);
    const struct Mistake *const *mistakes;   // tests/judge/mistake.h
    const struct Variant *variants;          // tests/proof/variants.h
    const struct Unknown *unknowns;          // tests/proof/unknown.h
    const struct Composed *composed;         // tests/proof/composed.h
    const struct SameMistake *same_mistakes; // the same
    const struct Generated *generated;       // tests/proof/generated/generated.h
} Stem;

#ifndef OF_STEM // as nothing if only the functions of a file are wanted (MUTANTS in tests.mk)
#define OF_STEM(part)                                                                              \
    __attribute__((constructor)) static void add_##part(void)                                      \
    {                                                                                              \
        stem_of_file(__FILE__)->part = part;                                                       \
    }
#endif

// Each makes an entry for the stem if there is none.
Stem *stem_of_file(const char *file);
Stem *stem_named(const char *name);

// From now on the program is about this stem. Exits with 2 and says which there are if this is none
// of them. NULL: the program has one.
void choose_stem(const char *name);
const Stem *chosen_stem(void);
const struct Mistake *const *chosen_mistakes(void); // an empty list if it has none

#endif
