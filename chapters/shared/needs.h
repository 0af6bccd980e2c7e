// needs.h - which answers a picture is made of, and whether each is there.
#ifndef CHAPTERS_SHARED_NEEDS_H
#define CHAPTERS_SHARED_NEEDS_H

#include <stdbool.h>

// The two ways of rendering a picture.
typedef enum { IMAGE_ORDER, OBJECT_ORDER } Order;

// Casts a picture of one pixel. Where that calls a blank, false, and every blank among the answers
// that pictures are made of is named on stderr, not only the first, which stops the work.
bool picture_needs_are_met(Order order);

#endif
