// floor.h - a tiled floor, seen by the same look-at in a right-handed and in a left-handed world.
#ifndef CHAPTERS_02_CAMERAS_FLOOR_H
#define CHAPTERS_02_CAMERAS_FLOOR_H

// Draws both, right-handed on the left. Returns the exit status for main.
int floor_picture(const char *path);

#endif
