// scenes.h - scenes that are made to be difficult, to cast and to light, and random ones.
#ifndef TESTS_HOUSE_ENGINES_SCENES_H
#define TESTS_HOUSE_ENGINES_SCENES_H

#include "common/camera.h"
#include "common/scene.h"

// A scene and who looks at it; the camera need not be one that NFF can say. One at a time: all use
// the same memory.
typedef struct {
    char name[80];
    Scene scene;
    Camera camera;
    Resolution size;
    int depth; // the number of mirrors to follow
} Made;

// Number 0, 1, ... of those that no random one is like; false where there is no more.
bool made_difficult(Made *made, int number);

// The same few spheres on a screen of any size.
void made_sized(Made *made, Resolution size);

// Enough spheres for threads to share; spheres that cover enough tiles that bins are filled for
// some of the spheres at a time.
void made_many(Made *made);
void made_wide(Made *made);
// Two large spheres with many small ones around them, in front of them and behind.
void made_hidden(Made *made);

// A random one: one to 400 spheres of all kinds. For a number always the same, by one compiler:
// in which order it takes the numbers of one call is its own affair.
void made_at_random(Made *made, unsigned number);
// Eyes and lights up to 1e15 away, radii from 1e-12 to 1e14, the eye in mirrors.
void made_far_apart(Made *made, unsigned number);

// Spheres that are about that many of their radii away from the eye.
void made_far(Made *made, unsigned number, double radii, double radius);
// The edge of a sphere of radius 1, that far away, in a picture of this width there.
void made_edge(Made *made, unsigned number, double radii, double width);

// Random numbers, as after the last scene.
double uniform(double low, double high);
vec3 within(double most);

#endif
