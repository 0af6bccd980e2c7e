// picture_panels.h - two pictures of one size, and where they differ.
#ifndef TESTS_JUDGE_PICTURE_PANELS_H
#define TESTS_JUDGE_PICTURE_PANELS_H

#include "common/image.h"

// The largest difference between two bytes of one pixel, which is given by its number.
int picture_bytes_apart(const Image *yours, const Image *right, size_t pixel);

// Writes a PNG with both pictures and their difference, side by side. Pixels whose bytes differ by
// at most 'alike' count as alike. False if it could not be written.
bool picture_panels_write(const Image *yours, const Image *right, int alike, const char *path);

#endif
