// questions.h - how often each pixel is asked whether its ray hits a sphere, for a page that draws
// it (chapters/book/cast/cast.c). There hit_sphere counts as well.
#ifndef CHAPTERS_08_FAST_QUESTIONS_H
#define CHAPTERS_08_FAST_QUESTIONS_H

#include <stddef.h>

typedef struct {
    unsigned *counts; // of each pixel, row by row; NULL: nobody counts
    int width, height;
    int pixel; // whose ray is cast now
} Questions;
extern Questions questions;

static inline void ray_is_asked(void)
{
    if (questions.counts != NULL)
        questions.counts[questions.pixel]++;
}

// Columns left to right - 1, rows top to bottom - 1; those beyond the screen do not count.
static inline void pixels_are_asked(int left, int right, int top, int bottom)
{
    if (questions.counts == NULL)
        return;
    for (int row = top; row < bottom && row < questions.height; row++)
        for (int column = left; column < right && column < questions.width; column++)
            questions.counts[row * questions.width + column]++;
}

#endif
