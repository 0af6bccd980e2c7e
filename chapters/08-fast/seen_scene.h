// seen_scene.h - steps 4 and 5: a scene and a camera become what the loops over floats are told.
#ifndef CHAPTERS_08_FAST_SEEN_SCENE_H
#define CHAPTERS_08_FAST_SEEN_SCENE_H

#include "chapters/08-fast/engine.h"
#include "chapters/08-fast/paint.h"
#include "chapters/08-fast/seen.h"

#include <stdatomic.h>
#include <stdbool.h>

typedef struct {
    const Work *work;
    // For every camera: the hierarchy; what lies in its order.
    Hierarchy hierarchy;
    Paint *paints;
    Unseen *unseen;
    WideNode *wide; // where it was wanted
    int *colors;
    // For this one.
    See *see;
    Seen *seen;
    SeenNode *nodes; // where wide was not wanted
    int *around;
    float *x, *y;
    atomic_int found; // SEEN_AROUND | SEEN_BADLY
    View view;
} SeenScene;

// What is good for every camera. False where memory is short. Free it either way.
bool seen_scene_build(SeenScene *scene, const Work *work, bool wide);
// What the camera sees. False where floats will not do: see SEEN_BADLY; and for rays nearly at
// right angles to the view.
bool seen_scene_look(SeenScene *scene);
void seen_scene_free(SeenScene *scene);

#endif
