// mistakes.c - wrong answers to exercise 06: the list of their tables. Pictures from a wrong
// nearest_hit are drawn by the right loops.
#include "tests/06-ray-casting/mistakes.h"

static const Mistake *const mistakes[] = {
    nearest_mistakes, nearest_limit_mistakes, image_order_mistakes,   object_order_mistakes,
    color_mistakes,   depth_mistakes,         picture_limit_mistakes, NULL};
OF_STEM(mistakes)
