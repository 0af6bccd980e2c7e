// known.h - what is known of each stem, and which stem this run of the program is about.
//
// A program holds the tests of all stems. Each file of a stem adds what it defines: tests (test.h),
// known answers, laws, and by OF_STEM(part) a part of Stem that has this name in the file. The stem
// is the file's: 05-quadratic of tests/05-quadratic.c and of tests/05-quadratic/wrong.c.
//
// Known answers are wrong ones that people really give, with the sentences about each, and right
// ones in other forms:
//
//     WRONG(upper_left, "C2", "its formula", why it is wrong, what its author would see)
//     {
//         return ...;
//     }
//
// Each entry adds itself to what is known of its stem, in the order of the file: wrong.c, right.c
// and verdicts.c of tests/NN-stem/. Its parameters have the names of tests/exercises.def. make
// check proves that each mistake fails a test of its function and is named from its values alone,
// that each test is failed by one, and that no right answer fails or is accused of a mistake.
#ifndef TESTS_JUDGE_KNOWN_H
#define TESTS_JUDGE_KNOWN_H

#include "common/text.h"
#include "tests/judge/exercise.h"

#include <stddef.h>
#include <string.h>

typedef struct KnownAnswer {
    const char *id;       // C2, as in the field's list of mistakes, or a name of our own; of an
                          // answer that is no known mistake, how it differs, in a few words
    const char *exercise; // the function that it answers
    AnyFunction *answer;
    const char *formula; // a mistake's formula, as the slide would write it
    const char *why;     // why it is wrong, in terms of the picture; whole sentences
    const char *picture; // what its author would see: 'everything at half its size'
    const char *said;    // of a wrong answer without a name: ID, ID in part, ID and ID; or NOBODY
                         // and how the words begin
    int place;           // in its file
    struct KnownAnswer *next;
} KnownAnswer;

typedef KnownAnswer Mistake;

// Answers that tests/proof/generated/mutate.py makes of these. A stem has one table of them,
// OF_STEM(generated), which ends with one whose exercise is NULL.
typedef struct Generated {
    const char *exercise;
    const char *from;   // the answer that was changed
    const char *change; // FUNCTION:LINE: the statement, [[old text => new text]]
    bool is_plain;      // a slip in a solution that a test must notice
    AnyFunction *answer;
} Generated;

typedef enum {
    WRONG_ANSWERS,
    RIGHT_ANSWERS,
    UNNAMED_ANSWERS,
    FREE_ANSWERS,
    KINDS_OF_ANSWERS
} KindOfAnswer;

// Adds it to what is known of the file's stem.
void add_known(const char *file, KindOfAnswer kind, KnownAnswer *answer);
// Of the chosen stem: the first, which leads to the next; NULL if there is none.
const KnownAnswer *known_answers(KindOfAnswer kind);

// ---- a stem ------------------------------------------------------------------------------------

typedef struct {
    char name[64];
    void (*load)(void);                // called when the stem is chosen; may be NULL
    struct ListedTest *tests, *probes; // tests/judge/test.h
    KnownAnswer *known[KINDS_OF_ANSWERS];
    int styles; // of the mistakes (answer_style); 0 is one
    const Generated *generated;
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

// ---- entries -----------------------------------------------------------------------------------

#define WRONG(exercise, id, formula, why, picture)                                                 \
    KNOWN(WRONG_ANSWERS, __COUNTER__, FORM_##exercise, id, #exercise, formula, why, picture, NULL)
// An answer in another form than the reference.
#define RIGHT(exercise, what)                                                                      \
    KNOWN(RIGHT_ANSWERS, __COUNTER__, FORM_##exercise, what, #exercise, NULL, NULL, NULL, NULL)
// Two mistakes at once, or one on some inputs only, or an answer of another kind, and the verdict
// that it must get. It is better to name nobody than somebody else.
#define UNNAMED(exercise, said, what)                                                              \
    KNOWN(UNNAMED_ANSWERS, __COUNTER__, FORM_##exercise, what, #exercise, NULL, NULL, NULL, said)
#define NOBODY "but"

// The same in one line, if the body is one statement, the last argument. An exercise has another
// name here (build/reference.h), so it must not be passed on to another macro.
#define WRONG_LINE(exercise, id, formula, why, picture, ...)                                       \
    KNOWN(WRONG_ANSWERS, __COUNTER__, FORM_##exercise, id, #exercise, formula, why, picture, NULL) \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
#define RIGHT_LINE(exercise, what, ...)                                                            \
    KNOWN(RIGHT_ANSWERS, __COUNTER__, FORM_##exercise, what, #exercise, NULL, NULL, NULL, NULL)    \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
#define UNNAMED_LINE(exercise, said, what, ...)                                                    \
    KNOWN(UNNAMED_ANSWERS, __COUNTER__, FORM_##exercise, what, #exercise, NULL, NULL, NULL, said)  \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
// In a macro of a chapter, a name that its entries may use: LETTER(double, x) = point.x;
#define LETTER(type, name) __attribute__((unused)) const type name
// A mistake whose answer is a function by itself.
#define WRONG_BY(function, exercise, id, formula, why, picture)                                    \
    KNOWN_BY(WRONG_ANSWERS, __COUNTER__, function, id, #exercise, formula, why, picture, NULL)

// What a contract leaves free, answers do in several styles: of several reasons to refuse a camera
// they test one or another first, and a cosine is cut off by if or by fmax. A mistake is the same
// in each: some are written for all of them, and answer in this one. The judge knows what 0 is;
// what others are is in wrong.c. FREE is a right answer that has all styles.
extern int answer_style;
#define FREE(exercise)                                                                             \
    KNOWN(FREE_ANSWERS, __COUNTER__, FORM_##exercise, "", #exercise, NULL, NULL, NULL, NULL)

// build/reference.h defines FORM_upper_left(function) as vec3 function(Camera c).
#define KNOWN(kind, number, form, ...) KNOWN_(kind, number, form, __VA_ARGS__)
#define KNOWN_(kind, number, form, ...)                                                            \
    static form(known_##number);                                                                   \
    KNOWN_BY_(kind, number, known_##number, __VA_ARGS__)                                           \
    static form(known_##number)
#define KNOWN_BY(kind, number, ...) KNOWN_BY_(kind, number, __VA_ARGS__)
#define KNOWN_BY_(kind, number, function, id, exercise, ...)                                       \
    static KnownAnswer entry_##number = {id,          exercise, (AnyFunction *)(function),         \
                                         __VA_ARGS__, number,   NULL};                             \
    ADD_KNOWN(kind, number)
#ifndef ADD_KNOWN // as nothing if only the functions of a file are wanted (MUTANTS in tests.mk)
#define ADD_KNOWN(kind, number)                                                                    \
    __attribute__((constructor)) static void add_##number(void)                                    \
    {                                                                                              \
        add_known(__FILE__, kind, &entry_##number);                                                \
    }
#endif

// ---- laws ---------------------------------------------------------------------------------------

// Properties that hold for every right answer whatever the numbers, and the words for a broken one.
//
// If no known mistake explains a wrong answer, a law that it breaks still helps: 'your vector goes
// 2 along forward; the plane is 4 ahead'. In tests/NN-stem/laws.c,
//
//     LAW(image_plane_vector) { ... }
//
// is called after each call of this exercise, with its result, yours, the right one, if the
// function only returns it, and its parameters, which have the names of tests/exercises.def (and
// the results behind pointers). It must never complain about a right answer, within the contract's
// tolerance.
//
// laws.c is in the students' archive, so it is no second solution: it measures both results, and
// computes neither. What only the reference can say, the recorder asks it in tests/NN-stem/facts.c:
// FACTS(image_plane_vector) { fact(...); } is called once for each question, with the right result,
// and the law finds these numbers in law_facts().

// build/reference.h defines LAW_upper_left(law) as void law(vec3 yours, vec3 right, Camera c).
#define LAW(exercise)                                                                              \
    LAW_##exercise(law_##exercise);                                                                \
    LAW_##exercise(law_##exercise)

// In a program with facts.c there are no laws.
#define FACTS LAW
void fact(double x);
const double *law_facts(void);

// All numbers of the right result (numbers.h), for one that is not returned.
const double *law_right(void);

// In a sentence with the numbers. Only the first of an exercise is kept.
void law_broken(const char *format, ...) __attribute__((format(printf, 1, 2)));

// ---- two numbers as words, with enough digits to distinguish them ------------------------------

// Rounding leaves 1e-16 instead of 0.
static inline double without_noise(double x, double noise)
{
    return fabs(x) <= noise ? 0 : x;
}

typedef struct {
    Text yours, right;
} Apart;

static inline Apart apart(double yours, double right)
{
    Apart texts;
    int digits = TEXT_DIGITS;
    do {
        texts.yours = number_text_to(yours, digits);
        texts.right = number_text_to(right, digits);
    } while (strcmp(texts.yours.s, texts.right.s) == 0 && ++digits <= 17);
    return texts;
}

static inline Apart apart_vec3(vec3 yours, vec3 right)
{
    Apart texts;
    int digits = TEXT_DIGITS;
    do {
        texts.yours = vec3_text_to(yours, digits);
        texts.right = vec3_text_to(right, digits);
    } while (strcmp(texts.yours.s, texts.right.s) == 0 && ++digits <= 17);
    return texts;
}

#endif
