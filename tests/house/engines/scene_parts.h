// scene_parts.h - what scenes are made of: numbers, places, spheres and a camera.
#ifndef TESTS_HOUSE_ENGINES_SCENE_PARTS_H
#define TESTS_HOUSE_ENGINES_SCENE_PARTS_H

#include "tests/house/engines/test_scenes.h"

enum { MOST = 12000 }; // spheres

// The scene that is being made.
extern Made *now;
extern Frame frame_now;

// An empty one, and where its random numbers begin.
void made_begin(Made *made, unsigned long long seed);

// The state of the random numbers; the same state gives the same numbers.
extern unsigned long long state;
double uniform(double low, double high);
double power_of_ten(double low, double high);
bool once_in(double times);
vec3 within(double most);
vec3 direction(void);

// The default eye, the point that it looks at, and roughly up.
extern const vec3 front, middle, above;

// Nothing but a camera; the angle is in degrees, across the width.
void look(vec3 from, vec3 at, vec3 roughly_up, double angle, int width, int height);
void look_from(vec3 from, double angle, int width, int height);

// One sphere more, of a colour of its own, so that one taken for another shows.
void add(vec3 center, double radius);
// One that the ray of a random pixel touches, so far away.
void add_tangent(double radius, double away);

// Two that the ray of a random pixel meets in the same place; the second is that many times larger.
void add_meeting(double radius, double times, double away);

// The colour of number i, and all of them.
Color color_number(int i);

#endif
