// numbers.h - the numbers of an example, by the names that lessons and slides have for them:
// [[upper_left]] in chapters/lessons/lines.txt and in chapters/slides.txt.
#ifndef CHAPTERS_LESSONS_NUMBERS_H
#define CHAPTERS_LESSONS_NUMBERS_H

#include "common/camera.h"
#include "common/ray.h"
#include "common/screen.h"
#include "common/sphere.h"

typedef struct {
    Camera camera;
    Normalized place;
    ScreenPoint point;
    Pixel pixel;
    Ray ray;
    Sphere sphere;
} Example;

typedef struct {
    const char *name;
    char text[400];
} NamedNumber;

// All of them, on the lecture's screen. Numbers are as people write them (common/shown.h); in
// formulas fill.py makes them LaTeX.
const NamedNumber *named_numbers(const Example *example, int *count);

#endif
