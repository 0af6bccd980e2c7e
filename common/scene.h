// scene.h - scenes, read from NFF, Eric Haines' Neutral File Format.
//
//   b R G B                       background color; black if there is no such line
//   v                             viewpoint, then on lines of their own: from X Y Z, at X Y Z,
//                                 up X Y Z, angle A, hither H, resolution W H
//   l X Y Z [R G B]               light; without a color: white times 1 / sqrt(lights)
//   f R G B Kd Ks Shine T IoR     fill of the spheres that follow; white before the first
//   s X Y Z R                     sphere
//   #                             comment, to the end of the line
//
// The world is right-handed. Source: SPD, the Standard Procedural Databases, file NFF.TXT.
#ifndef COMMON_SCENE_H
#define COMMON_SCENE_H

#include "common/image.h"
#include "common/screen.h"
#include "common/sphere.h"
#include "common/text.h"

#include <stdbool.h>
#include <stdio.h>

#define SCENE_AMBIENT 0.1

// The viewpoint of the picture. Turning it into a camera is exercise 02.
typedef struct {
    vec3 from, at, up;
    double angle;          // degrees, 0 to 180, across the width of the image, edge to edge
    Resolution resolution; // pixels are square
} Viewpoint;

// A point light is at its position; a distant one, like the sun, is in that direction from
// everywhere. NFF has point lights.
typedef enum { LIGHT_POINT, LIGHT_DISTANT } LightKind;

typedef struct {
    vec3 position; // or the direction to a distant one, any length but 0
    Color color;   // how bright it is
    LightKind kind;
} Light;

// A fill: the color, and the numbers that chapter 07 uses with it.
typedef struct {
    Color color;
    double diffuse, specular, shine;  // Kd, Ks, Shine
    double transmittance, refraction; // T, index of refraction
} Surface;

typedef struct {
    Viewpoint view;
    Color background;
    Color ambient; // light that is everywhere; NFF has none: SCENE_AMBIENT of white
    Sphere *spheres;
    int sphere_count;
    Surface *surfaces; // at least one: white, for spheres before the first f
    int surface_count;
    Light *lights;
    int light_count;
} Scene;

// The surface of sphere i, from 0. If there is no such sphere, for example if i is -1, the program
// ends with a message.
const Surface *scene_surface(const Scene *scene, int i);

// Reads a scene. If it fails, it returns false, message is FILE:LINE: the mistake and what was
// expected, and the scene is empty. warning is empty, or one line about the parts that the toolkit
// does not use.
bool scene_read(FILE *file, const char *name, Scene *scene, Message *message, Message *warning);

// The same from a file's path; the warning goes to stderr.
bool scene_load(const char *path, Scene *scene, Message *message);

void scene_free(Scene *scene);

// See image_set.
#pragma GCC system_header
#ifndef WITHOUT_LINES_OF_CALLS
#define scene_surface(...) (called_in(__FILE__, __LINE__), scene_surface(__VA_ARGS__))
#endif

#endif
