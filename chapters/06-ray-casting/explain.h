// explain.h - one pixel, explained from its column and row to its color.
#ifndef CHAPTERS_06_RAY_CASTING_EXPLAIN_H
#define CHAPTERS_06_RAY_CASTING_EXPLAIN_H

#include "chapters/06-ray-casting/figures/figures.h"
#include "exercises/05-quadratic.h"

enum { MOST_TOLD = 8 };

// How many spheres of a scene a ray hits and misses, and which of them are explained.
typedef struct {
    int hit, behind, missed; // number of spheres
    int told[MOST_TOLD];     // indices, ascending
    int told_count;
} Outcome;

// Chooses all spheres if they are few. If not, it chooses the nearest hits and the narrowest
// misses, in all at most room.
Outcome outcome_of(Ray ray, const Scene *scene, int room);

// b^2 - 4ac
double discriminant(Quadratic q);

// Prints the explanation; returns the result of main. scene_path is the name of the scene.
int explain(const Shot *shot, const char *scene_path);

// The same as a figure's data; given is a Shown.
void explain_figure_data(Plot *plot, void *given);

#endif
