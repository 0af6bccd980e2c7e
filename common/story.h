// story.h - how a program tells its story on the terminal: headings, and labelled values in line.
#ifndef COMMON_STORY_H
#define COMMON_STORY_H

#include "common/camera.h"

#include <stdbool.h>

// An empty line and a heading.
void story_heading(const char *format, ...) __attribute__((format(printf, 1, 2)));

// A label of up to 27 columns, and what belongs to it.
void story_line(const char *label, const char *format, ...) __attribute__((format(printf, 2, 3)));

// For a page: the parts of a line are separated by tabs, and there is more of them.
extern bool story_is_for_page;
// The exercise functions that compute the numbers of the next line, separated by blanks: its third
// part.
void story_by(const char *functions);
// What the story is about, in the scene: a line from a point to another. The page draws it. First
// comes a tab, and the numbers have all digits.
void story_segment(const char *name, vec3 from, vec3 to);

// The seven parts of a camera, a line each.
void story_camera(Camera camera);

// Names what is not answered yet. Returns what main returns: 0, or 1 where there was any, or where
// the story could not be printed.
int story_end(void);

// If these numbers are not a camera, prints the reason and the program's name on stderr and exits
// with 1.
void story_needs_camera(const char *program, Camera camera);

#endif
