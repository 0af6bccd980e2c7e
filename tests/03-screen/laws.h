// laws.h - the laws of exercise 03.
#ifndef TESTS_03_SCREEN_LAWS_H
#define TESTS_03_SCREEN_LAWS_H

#include "common/screen.h"

void law_screen_to_normalized(Normalized yours, ScreenPoint point, Resolution screen);
void law_normalized_to_screen(ScreenPoint yours, Normalized place, Resolution screen);
void law_pixel_center(ScreenPoint yours, Pixel pixel);

#endif
