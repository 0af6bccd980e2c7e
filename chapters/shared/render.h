// render.h - a shaded picture: each pixel by one sample or several, each sample by trace_ray.
#ifndef CHAPTERS_SHARED_RENDER_H
#define CHAPTERS_SHARED_RENDER_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"

#include <stdbool.h>

// How a picture is made of a scene.
typedef struct {
    int samples;  // each way in a pixel: 3 makes 9
    int depth;    // how many mirrors a ray is followed through
    double gamma; // of the display; 1 leaves the numbers as they are
} Style;

// What is drawn of the light. One term alone shows what it adds.
typedef enum { TERM_ALL, TERM_AMBIENT, TERM_DIFFUSE, TERM_SPECULAR, TERM_FLAT } Term;

// Leaves all but a term out of a scene. Flat: surfaces shine by themselves, in their colour.
void keep_term(Scene *scene, Term term);

// The colour that a ray sees in a world, as trace_ray finds it or in another way.
typedef Color Tracer(void *world, Ray ray, int depth);

// How the rays of a picture are sent.
typedef struct {
    Camera camera;
    Resolution screen;
    Style style;
    Tracer *trace;
} Rendering;

// The colour of one pixel.
Color render_pixel(const Rendering *rendering, void *world, Pixel pixel);

// By trace_ray: the world is a scene.
Tracer trace_scene;

// Sets every pixel of the image.
void render(const Scene *scene, Camera camera, Style style, Image *image);

// Calls each answer that a picture in this style is made of, once. False, each one that is missing
// named on stderr, where there is a blank.
bool shading_needs_are_met(Style style);

#endif
