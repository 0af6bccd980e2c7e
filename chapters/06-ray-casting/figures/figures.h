// figures.h - the figures of chapter 06.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/sphere.h"

// ---- what a figure shows of a scene: which pixels, which spheres, which hits of one ray ---------

// A picture of a scene, and one of its pixels.
typedef struct {
    const Scene *scene;
    Camera camera;
    Resolution size;
    Pixel pixel; // column -1: the one whose ray meets most
} Shot;

enum { MOST_SPHERES = 50, MOST_HITS = 4, MOST_CELLS = 24 };

typedef struct {
    Shot shot;
    Camera camera;   // of the same rays, its image plane before the spheres
    Resolution grid; // what is drawn of the pixels: all, or a coarser picture
    Ray ray;         // of the pixel, with t = 1 on the image plane, however long its direction is
    Hit hits[MOST_HITS];
    int hit_count;             // of all spheres, not just of those in hits
    int spheres[MOST_SPHERES]; // their indices
    int sphere_count;
} Shown;

// A sphere's letters: 0 is A, 25 is Z, 26 is AA.
Text sphere_name(int sphere);

// Is it the index of one of the scene's spheres? Whoever answers may have returned anything.
bool is_sphere(const Scene *scene, int sphere);

// All hits of a ray: first what nearest_hit says, then those of the other spheres, the near before
// the far. Keeps as many as there is room for, returns how many there are.
int hits_of(Ray ray, const Scene *scene, Hit *hits, int room);

// Chooses. Shown are the spheres that rays of the drawn pixels hit first, and those in hits; not
// one that the eye is in or at, as it has no outline to draw. If there are none of these, one
// sphere ahead of the eye.
void shown_choose(Shown *shown, Shot shot);

// Leaves one sphere of those that are shown, or that are not.
void shown_only(Shown *shown, int sphere);

// The camera and its pixels (camera_drawing.h), the spheres (common/figure/spheres.gp), and of the
// one pixel: its $pixel, its $ray, its $hits.
void shown_data(Plot *plot, const Shown *shown);

// The handle of sphere A, the scene's first: how it is moved by a drag across the figure, and up.
Handle shown_sphere(const Shown *shown, vec3 across, vec3 up);

// Of the spheres that the ray hits and that are not shown, as of a ground, what is round the hit.
void shown_patches(Plot *plot, const Shown *shown);

// A cell of the drawn pixels: $pixels is made of these.
void shown_cells_begin(Plot *plot, const char *name);
void shown_cell(Plot *plot, const Shown *shown, Pixel cell, Color color);
void shown_cells_end(Plot *plot, const Shown *shown, int cells);

// From where the figure is seen, the eye's name, and a note at its edge on what is not drawn.
void shown_look(Plot *plot, const Shown *shown);

// $NAME: the places of a ray from the eye up to t = end; bold up to t = solid.
void shown_ray(Plot *plot, const char *name, Ray ray, double end, double solid);

// How far to draw the pixel's ray.
double shown_end(const Shown *shown);

// 65536 r + 256 g + b, of the bytes of a color.
double rgb_number(Color color);

// ---- the figures --------------------------------------------------------------------------------

// The scene that a figure shows by default, as a path from the top of the project; for "", the
// chapter's own.
const char *figure_scene(const char *name);

// The pixel of that scene; column -1 means any pixel.
Pixel figure_pixel(const char *name);

// Prints a figure's script; returns the result of main.
int casting_figure(const char *program, FigureCommand command, Shot shot);

// ---- one ray and the spheres that it meets, in a plane ------------------------------------------

// Each sphere is turned around the ray into the paper; lengths are measured in the ray's t. given
// is a Shown.
void nearest_figure_data(Plot *plot, void *given);

// ---- the outline of a sphere on the image plane, and the lines from it to the eye ---------------

// $NAME: the places where the lines cross the image plane, all around the sphere.
void outline_on_plane(Plot *plot, const char *name, Camera camera, Sphere sphere);

// $LINES: some of the lines as rows of places, because hidden parts are left out. $HEADS: their
// arrowheads, half way to the plane. If the sphere is not drawn, the lines end beyond the plane.
void lines_to_eye(Plot *plot, const char *lines, const char *heads, Camera camera, Sphere sphere,
                  bool drawn);

#endif
