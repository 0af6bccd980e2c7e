// needed_answers.h - the answers that a picture needs, and whether each of them is there.
#ifndef CHAPTERS_SHARED_NEEDED_ANSWERS_H
#define CHAPTERS_SHARED_NEEDED_ANSWERS_H

#include <stdbool.h>

// The two ways of rendering a picture.
typedef enum { IMAGE_ORDER, OBJECT_ORDER } Order;

// Casts a picture of one pixel. If that calls a blank: false, and every blank among the answers
// that pictures need is named on stderr, not only the first one.
bool picture_needs_are_met(Order order);

#endif
