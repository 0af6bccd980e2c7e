// shading_scenes.h - scenes that are awkward to light.
#ifndef TESTS_HOUSE_ENGINES_SHADING_SCENES_H
#define TESTS_HOUSE_ENGINES_SHADING_SCENES_H

#include "common/scene.h"

// The scene that the functions below make, and the number of mirrors to follow.
extern Scene lit_scene;
extern int lit_depth;

typedef struct {
    const char *name;
    void (*make)(void);
    int times; // it is another one every time
} LitScene;

// The last one has no name.
extern const LitScene lit_awkward[];

void lit_at_random(unsigned number);

// Eyes and lights up to 1e15 away, radii from 1e-12 to 1e14, the eye in mirrors.
void lit_far_apart(unsigned number);

#endif
