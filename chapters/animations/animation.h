// animation.h - an animation that is drawn: its frames and its videos, as files of one folder.
#ifndef CHAPTERS_ANIMATIONS_ANIMATION_H
#define CHAPTERS_ANIMATIONS_ANIMATION_H

#include "chapters/animations/processes.h"

#include <stdbool.h>

enum { MOST_WORDS = 40 };

// An animation in one theme.
typedef struct {
    const char *folder; // of all animations
    const char *name, *theme;
    const char *suffix; // "" or "-dark"
    Path source;        // the script, or the turntable's scene
    char *
        *cast; // the program that casts a frame of the turntable, and its arguments; NULL: gnuplot
    int frames, rate;
    char stops[4000]; // the frames at which a lecturer stops
    bool drawn_now;
} Animation;

// FOLDER/NAME, and in it the frames, from 1 on.
Path home_of(const Animation *a);
Path frames_of(const Animation *a);
Path frame_path(const Animation *a, int frame);

// ---- videos (videos.c) ------------------------------------------------------------------------

typedef struct {
    int count;
    char *words[MOST_WORDS];
} List;

// Ends the program if a format is unknown (2), or if ffmpeg or its encoder is missing (3).
void check_formats(const List *formats, const char *folder);

// Makes the videos of frames that are drawn, unless they are newer. Ends the program if ffmpeg
// fails.
void make_videos(const Animation *a, const List *formats);

#endif
