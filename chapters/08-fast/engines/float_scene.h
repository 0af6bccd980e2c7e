// float_scene.h - steps 4 and 5: a scene and a camera become the input of the loops over floats.
#ifndef CHAPTERS_08_FAST_ENGINES_FLOAT_SCENE_H
#define CHAPTERS_08_FAST_ENGINES_FLOAT_SCENE_H

#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/float_bounds.h"
#include "chapters/08-fast/engines/sphere_colors.h"

#include <stdatomic.h>
#include <stdbool.h>

typedef struct {
    const Work *work;
    // For every camera: the hierarchy, and the arrays in its order.
    Hierarchy hierarchy;
    Paint *paints;
    Unseen *unseen;
    WideNode *wide; // if it is needed
    int *colors;
    // For this camera.
    See *see;
    Seen *seen;
    SeenNode *nodes; // if wide is not needed
    int *around;
    float *x, *y;
    atomic_int found; // SEEN_AROUND | SEEN_BADLY
    View view;
} SeenScene;

// Prepares the part for every camera. False if there is not enough memory. Free it in both cases.
bool seen_scene_build(SeenScene *scene, const Work *work, bool wide);
// Prepares the part for this camera. False if floats are not good enough: see SEEN_BADLY. That is
// also the case for rays nearly at right angles to the view.
bool seen_scene_look(SeenScene *scene);
void seen_scene_free(SeenScene *scene);

#endif
