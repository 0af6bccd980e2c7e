// support-scene.h - what the tests of exercise 07 share that need a scene.
#ifndef TESTS_07_SHADING_SUPPORT_SCENE_H
#define TESTS_07_SHADING_SUPPORT_SCENE_H

#include "exercises/07-shading.h"

#include "tests/judge/test.h"

#define COLOR_TOLERANCE 1e-9

// ---- worlds -------------------------------------------------------------------------------------

enum { MOST_SPHERES = 300, MOST_LIGHTS = 40 };

// A scene, and the arrays it points to. Sphere i has surface i + 1, so that an answer that confuses
// the two numbers is noticed; no sphere has surface 0, which is unlike all others.
typedef struct {
    Scene scene;
    Sphere spheres[MOST_SPHERES];
    Surface surfaces[MOST_SPHERES + 1];
    Light lights[MOST_LIGHTS];
} World;

// Only a background and an ambient light, neither black, white nor grey.
void empty_world(World *world);
// Returns its index.
int put_sphere(World *world, vec3 center, double radius, Surface surface);
void put_light(World *world, LightKind kind, vec3 position, Color color);

// The colours of a surface: kd, ks, shine.
Surface surface_of(Color color, double diffuse, double specular, double shine);
Surface dull(void);
Light point_light(double x, double y, double z);
Light distant_light(double x, double y, double z);

// Spheres that may overlap, lights of both kinds, all within a cube of about 16 sizes.
void random_world(World *world, int spheres, int lights, double size);
Surface random_surface(void);
Color random_scene_color(void);
// From 1 / most to most, small as often as large.
double random_size(double most);
// Towards one of the spheres, from anywhere, even from inside spheres.
Ray random_view(const World *world, double size);

// ---- mirrors ------------------------------------------------------------------------------------

Surface mirror(Color color, double specular);
Color ambient_of(const World *world, int sphere);
// A sphere as seen from the light, straight ahead.
Color lit_from_the_eye(const World *world, int sphere, Color light);
// Two mirrors that face each other: the first, the second in it, the first in that ...
Color to_and_fro(Color first, double ks, Color second, double other_ks, int depth);

// ---- descriptions ------------------------------------------------------------------------------

void given_world(const World *world);
void given_scene_light(const Light *light);
void expect_visible(const World *world, vec3 from, Light light, double expected);
void expect_shade(const World *world, Ray ray, Hit hit, Color expected);
void expect_trace(const World *world, Ray ray, int depth, Color expected);

// ---- the same, computed in another way (support-exact.c) -------------------------------

// In long double, and without an offset: on which side of its own sphere a ray starts is known
// there. False if something is so close to an edge that rounding may decide.
bool exact_visibility(const World *world, vec3 from, Light light, double *visibility);
// The first hit of the ray.
bool exact_hit(const World *world, Ray ray, Hit *hit);
bool exact_shade(const World *world, Ray ray, Color *color);
bool exact_trace(const World *world, Ray ray, int depth, Color *color);

void list_tests_with_scenes(void); // tests/07-shading-scenes.c

#endif
