// render.h - a shaded picture: each pixel by one sample or several, each sample by trace_ray.
#ifndef CHAPTERS_SHARED_RENDER_H
#define CHAPTERS_SHARED_RENDER_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"

#include <stdbool.h>

// How a scene becomes a picture.
typedef struct {
    int samples;  // in each direction of a pixel: 3 makes 9
    int depth;    // number of mirrors that a ray follows
    double gamma; // of the display; 1 does not change the numbers
} Style;

// The part of the light that is drawn. One term alone shows its contribution.
typedef enum { TERM_ALL, TERM_AMBIENT, TERM_DIFFUSE, TERM_SPECULAR, TERM_FLAT } Term;

// Removes all terms except one from a scene. Flat: surfaces shine by themselves, in their color.
void keep_term(Scene *scene, Term term);

// The color that the ray of a sample sees in a world, computed by trace_ray or in another way. A
// sample is a pixel of a finer screen.
typedef Color Tracer(void *world, Pixel sample, Ray ray, int depth);

// The rays of a picture.
typedef struct {
    Camera camera;
    Resolution screen;
    Style style;
    Tracer *trace;
} Rendering;

// The color of one pixel.
Color render_pixel(const Rendering *rendering, void *world, Pixel pixel);

// By trace_ray: the world is a scene.
Tracer trace_scene;

// Sets every pixel of the image.
void render(const Scene *scene, Camera camera, Style style, Image *image);

// Calls each answer that a picture in this style needs, once. If there is a blank: false, and each
// missing answer is named on stderr.
bool shading_needs_are_met(Style style);

#endif
