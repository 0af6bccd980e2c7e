// question.h - an exercise asked with random arguments, and its answer as plain numbers.
//
// A judge besides the tests: its own random numbers, its own way to compare two answers. The
// questions are those that the contracts allow, with a few of each special case: inside, behind,
// just touching, portrait, one pixel wide, saturated, any size of the world.
#ifndef TESTS_GENERATED_QUESTION_H
#define TESTS_GENERATED_QUESTION_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/screen.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/exercise.h"

#include <stdint.h>

enum { MOST_NUMBERS = 640, MOST_SPHERES = 8, MOST_LIGHTS = 5, MOST_PIXELS = 140 };

// The arguments of any exercise; each takes its own.
typedef struct {
    double size; // of the world: the unit of lengths
    bool edge;   // the last digit decides
    bool exact;  // a special case: its last digits must not be changed
    Camera camera;
    Corners corners;
    vec3 eye, lower_left, across, up;
    LookAt view;
    Handedness world;
    double degrees, distance;
    double s, t;
    ScreenPoint point;
    Normalized place;
    Resolution screen;
    Pixel pixel;
    Ray ray;
    Sphere sphere;
    double radius;
    Quadratic quadratic;
    Scene scene; // of these:
    Sphere spheres[MOST_SPHERES];
    Surface surfaces[MOST_SPHERES];
    Light lights[MOST_LIGHTS];
    Hit hit;
    int depth;
    vec3 from, normal, to_light, to_eye, direction;
    Light light;
    Color surface, brightness, ambient, color;
    double kd, ks, shine, gamma;
} Question;

typedef struct {
    int count; // 0: it crashed or timed out
    double number[MOST_NUMBERS];
    double tolerance[MOST_NUMBERS];
} Answer;

// Questions of one exercise.
typedef struct {
    const char *exercise;
    int questions; // how many are enough
    void (*draw)(Question *question);
    void (*ask)(AnyFunction *answer, Question *question, Answer *said);
    // If the contract leaves a choice: whether yours is also right. NULL: no choice.
    bool (*is_right)(const Question *question, const Answer *yours, const Answer *right);
} Subject;

extern const Subject screen_subjects[], camera_subjects[], sphere_subjects[], scene_subjects[],
    light_subjects[];

// Random numbers of a seed.
void draw_begin(uint64_t seed);
double draw(double low, double high);
int draw_below(int limit);
bool draw_one_in(int n);
double draw_scale(double low, double high); // each order of magnitude alike
double draw_any_size(void);                 // often 1
vec3 draw_vec3(double size);
vec3 draw_unit(void);
vec3 draw_color(void); // now and then black, white, one colour only
Camera draw_camera(double size);
Sphere draw_sphere(double size, vec3 near);

// Sets the scene's pointers to the arrays in the question itself, after their first element, so
// that an answer that starts one too early also finds something.
void point_into(Question *question);

// The same question, but for the last digits of its numbers.
void nudge(Question *question);

// Puts a number that must agree to within a tolerance.
void say(Answer *said, double number, double tolerance);
void say_vec3(Answer *said, vec3 v, double tolerance);
void say_camera(Answer *said, Camera camera, const Question *question);

#endif
