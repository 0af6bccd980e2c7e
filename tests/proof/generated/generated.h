// generated.h - wrong answers, as mutate.py makes them, and a judge of them beside the tests.
//
// It has its own random questions, and its own way to compare two answers. The questions are those
// that the contracts allow, with a few of each special case: inside, behind, just touching,
// portrait, one pixel wide, saturated, any size of the world.
#ifndef TESTS_PROOF_GENERATED_GENERATED_H
#define TESTS_PROOF_GENERATED_GENERATED_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/screen.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/exercise.h"
#include "tests/judge/stem.h"

#include <stdint.h>

// A stem has one table of them, OF_STEM(generated), which ends with one whose exercise is NULL.
typedef struct Generated {
    const char *exercise;
    const char *from;   // the answer that was changed
    const char *change; // FUNCTION:LINE: the statement, [[old text => new text]]
    bool is_plain;      // a slip in a solution that a test must notice
    AnyFunction *answer;
} Generated;

// ---- questions.c --------------------------------------------------------------------------------

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

extern const Subject subjects[];

// Random numbers of a seed.
void draw_begin(uint64_t seed);

// Sets the scene's pointers to the arrays in the question itself, after their first element, so
// that an answer that starts one too early also finds something.
void point_into(Question *question);

// The same question, but for the last digits of its numbers.
void nudge(Question *question);

// ---- truth.c ------------------------------------------------------------------------------------

// Once, before the first call: crashes and endless loops end only a call.
void guard_begin(void);
// From now on this function answers the tests.
void guard_answer_by(AnyFunction *answer);

// Draws the questions of an exercise, and lets the reference answer them. False if the exercise is
// unknown.
bool truth_begin(const char *exercise, AnyFunction *reference, uint64_t seed);

// Right: it keeps the contract. At the edge: it differs only if the last digit decides, so it may
// pass or fail. Wrong: anything else.
typedef enum { RIGHT, AT_THE_EDGE, WRONG } Truth;
Truth truth_of(AnyFunction *answer, int *question); // the first that it gets wrong

// How similar a wrong answer is to a known mistake: how many of its wrong results the mistake, or
// one of two, also gives; and how many of all questions distinguish them. Two mistakes at once: if
// a question shows one of them, the answer gives the result of that one; if it shows both, the
// answer is wrong; if neither, it is right.
typedef struct {
    int questions, wrong, alike, apart;
    int wrong_numbers, alike_numbers; // of all answers: parts of pictures
    int clearly_wrong, clearly_alike; // by more than digits, and that like the mistake
    int question_apart;               // the last that tells them apart
} Likeness;
Likeness likeness(AnyFunction *answer, AnyFunction *mistake);
// The answer to that question, in words.
void truth_words(char *words, size_t size, AnyFunction *answer, int question);
Likeness likeness_to_both(AnyFunction *answer, AnyFunction *mistake, AnyFunction *other);

#endif
