// explain.h - the whole story of one pixel: from its column and row to its colour.
#ifndef CHAPTERS_06_RAY_CASTING_EXPLAIN_H
#define CHAPTERS_06_RAY_CASTING_EXPLAIN_H

#include "chapters/06-ray-casting/figures/shown.h"
#include "exercises/05-quadratic.h"

enum { MOST_TOLD = 8 };

// What a ray does with a scene's spheres, and of which of them it is worth telling.
typedef struct {
    int hit, behind, missed; // how many
    int told[MOST_TOLD];     // indices, ascending
    int told_count;
} Outcome;

// Tells of all spheres where they are few; else of the nearest hits and the narrowest misses, in
// all of no more than room.
Outcome outcome_of(Ray ray, const Scene *scene, int room);

// b^2 - 4ac
double discriminant(Quadratic q);

// Prints the story; returns what main returns. scene_path is what the scene goes by.
int explain(const Shot *shot, const char *scene_path);

// The same as a figure's data; given is a Shown.
void explain_figure_data(Plot *plot, void *given);

#endif
