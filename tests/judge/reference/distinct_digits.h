// distinct_digits.h - two numbers as words, with enough digits to distinguish them.
#ifndef TESTS_JUDGE_REFERENCE_DISTINCT_DIGITS_H
#define TESTS_JUDGE_REFERENCE_DISTINCT_DIGITS_H

#include "common/text.h"

#include <string.h>

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
