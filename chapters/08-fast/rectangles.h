// rectangles.h - where the spheres of a scene are on the screen, in numbers.
#ifndef CHAPTERS_08_FAST_RECTANGLES_H
#define CHAPTERS_08_FAST_RECTANGLES_H

#include "chapters/shared/scene_command.h"

// Prints the rectangle of each sphere, and how many questions the rectangles save. Returns the
// result of main.
int rectangles_tell(const char *program, const Command *command);

// The same as a program: reads the scene and the size from the command line.
int rectangles_command(int argc, char **argv);

#endif
