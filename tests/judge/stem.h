// stem.h - what is known of each stem, and which stem this run of the program is about.
//
// A program holds the tests of all stems. Each file of a stem adds what it defines: tests (test.h),
// known answers (known.h), and by OF_STEM(part) a part of Stem that has this name in the file.
//
// The stem is the file's: 05-quadratic of tests/05-quadratic.c and of tests/05-quadratic/wrong.c.
#ifndef TESTS_JUDGE_STEM_H
#define TESTS_JUDGE_STEM_H

struct KnownAnswer;
struct ListedTest;
struct Generated;

typedef enum {
    WRONG_ANSWERS,
    RIGHT_ANSWERS,
    UNNAMED_ANSWERS,
    FREE_ANSWERS,
    KINDS_OF_ANSWERS
} KindOfAnswer;

typedef struct {
    char name[64];
    void (*load)(void);                          // called when the stem is chosen; may be NULL
    struct ListedTest *tests, *probes;           // tests/judge/test.h
    struct KnownAnswer *known[KINDS_OF_ANSWERS]; // tests/judge/known.h
    int styles;                                  // of the mistakes (known.h); 0 is one
    const struct Generated *generated;           // tests/judge/known.h
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

// Adds it to what is known of the file's stem.
void add_known(const char *file, KindOfAnswer kind, struct KnownAnswer *answer);
// Of the chosen stem: the first, which leads to the next; NULL if there is none.
const struct KnownAnswer *known_answers(KindOfAnswer kind);

#endif
