// story.h - the light at one point, in numbers.
#ifndef CHAPTERS_07_SHADING_STORY_H
#define CHAPTERS_07_SHADING_STORY_H

#include "chapters/shared/scene_command.h"

// Prints the light that the ray of a pixel sees, term by term, with depth mirrors.
void tell_shading(const Drawing *drawing, Pixel pixel, int depth);

#endif
