// law.h - laws: properties that hold for every right answer whatever the numbers, and the words for
// a broken one.
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
#ifndef TESTS_JUDGE_LAW_H
#define TESTS_JUDGE_LAW_H

#include "common/text.h"

#include <string.h>

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
