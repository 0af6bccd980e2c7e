// figures.h - the figures of chapter 07.
#ifndef CHAPTERS_07_SHADING_FIGURES_FIGURES_H
#define CHAPTERS_07_SHADING_FIGURES_FIGURES_H

#include "chapters/shared/render.h"
#include "chapters/shared/scene_command.h"
#include "common/figure/plot.h"

// Of the closing slide, as a figure and as a picture: smooth edges, and no mirrors, as in the deck.
extern const Style closing_style;

// Of the flat figures (light_in_a_plane.c): where the light and the eye are, x to the right, y up.
// NaN: the figure's own.
typedef struct {
    vec3 light, eye;
} Plane;

// What the command line gives to a figure's data.
typedef struct {
    Drawing drawing;
    Plane plane;
} Given;

#define PLANE_OPTIONS(plane)                                                                       \
    {"light", 0, "X,Y,0", option_vec3, &(plane).light, NULL},                                      \
    {                                                                                              \
        "eye", 0, "X,Y,0", option_vec3, &(plane).eye, NULL                                         \
    }

void surface_vectors(Plot *plot, void *given);
void beam_and_lobe(Plot *plot, void *given);
void self_hit(Plot *plot, void *given);
void shadow_and_mirror(Plot *plot, void *given);

extern const Figure shading_figures[]; // of what is Given

#endif
