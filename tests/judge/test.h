// test.h - how a test gives its arguments and its expected results.
//
// Tests are Check's; they call the exercises by their contract names, whoever answers. A test first
// says what is given, then what it expects; when that fails, both are shown to the student:
//
//     given_camera(c);
//     expect_vec3(upper_left(c), vec3_of(-1, 1, 4), 1e-9);
#ifndef TESTS_JUDGE_TEST_H
#define TESTS_JUDGE_TEST_H

#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/sphere.h"
#include "common/text.h"
#include "common/vec3.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/exercise.h"

#include <check.h>

// A test of an exercise adds itself to the tests of its stem, which run in the order of the file.
// An extra test costs no marks, a probe is none (suspects.h).
//
//     TEST(upper_left, the_upper_left_corner_of_the_example)
//     {
//     }
#define TEST(function, name) LISTED_TEST(#function, name, false, false)
#define EXTRA_TEST(function, name) LISTED_TEST(#function, name, true, false)
#define PROBE(function, name) LISTED_TEST(#function, name, false, true)
// If the body is one statement.
#define TEST_LINE(function, name, ...)                                                             \
    TEST(function, name)                                                                           \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
#define PROBE_LINE(function, name, ...)                                                            \
    PROBE(function, name)                                                                          \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }
#define LISTED_TEST(function, name, is_extra, is_probe)                                            \
    static const TTest *name;                                                                      \
    __attribute__((constructor)) static void add_##name(void)                                      \
    {                                                                                              \
        static ListedTest listed = {function, NULL, is_extra, __COUNTER__, NULL};                  \
        listed.test = name;                                                                        \
        add_test(__FILE__, is_probe, &listed);                                                     \
    }                                                                                              \
    START_TEST(name)
typedef struct ListedTest {
    const char *function;
    const TTest *test;
    bool extra;
    int place; // in its file
    struct ListedTest *next;
} ListedTest;
void add_test(const char *file, bool is_probe, ListedTest *test);

// The arguments. The first after an expectation begins a new case.
void given(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
void given_number(const char *name, double x);
void given_vec3(const char *name, vec3 v);
void given_camera(Camera camera);
void given_ray(Ray ray);
void given_sphere(Sphere sphere);

// The expected result, to within an absolute tolerance; NaN is never near anything.
void expect_number(double yours, double expected, double tolerance);
// In parentheses, if they are several, each below its counterpart.
void expect_numbers(const double *yours, const double *expected, int count, double tolerance);
void expect_vec3(vec3 yours, vec3 expected, double tolerance);
void expect_pair(double yours_x, double yours_y, double x, double y, double tolerance);
// A value without pointers, of any type: whole numbers are equal, and in a world of this size the
// lengths (types.def) may differ by tolerance times size.
void expect_value(const Type *type, const void *yours, const void *expected, double tolerance,
                  double size);
void expect_camera(Camera yours, Camera expected, double tolerance);
// The same in a world of that size: the lengths are multiplied by it, the directions are not.
void expect_camera_of_size(Camera yours, Camera expected, double tolerance, double size);
void expect_fault(CameraFault yours, CameraFault expected);
void expect_int(long yours, long expected);
void expect_text(const char *yours, const char *expected);
void expect_same_image(const Image *yours, const Image *expected);
// The same half line: the origin, and the direction up to its length.
void expect_same_ray(Ray yours, Ray expected, double tolerance);
// A law: it holds, or its words give the expected and the actual result.
void expect_law(bool holds, const char *expected, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// What was expected in a case: numbers that were compared (none if count is 0), and what else is
// right. All but tests say so by themselves; a program that writes it down listens
// (reference/record.c).
typedef struct {
    int count;
    const double *yours, *expected;
    double tolerance;
    int reasons;        // to refuse a camera, a bit each: any of them
    bool any_length;    // of a direction
    double least, most; // of a step off a surface, along the normal
} Expectation;
extern void (*expectation_listener)(const Expectation *expectation);
void expects(Expectation expectation);

// Numbers that look random, uniform from low to high: the same in every run and in each test, or,
// if the environment has SEED, others for each seed and test.
void random_take_seed(void); // from the environment; exits with 2 if it is not a seed
void random_begin(const char *test, bool is_probe); // a probe's are never hidden
double random_number(double low, double high);
// The i-th of count sizes from 1e-6 to 1e6: the first and the last are these two, the others lie
// between them in ascending order, so that small, ordinary and large ones are in every run.
double random_scale(int i, int count);
vec3 random_vec3(double low, double high);
vec3 random_unit(void);
// The deck's own camera, also if the lecture has another one (chapters/shared/example.h).
Camera camera_of_the_deck(void);
// A left-handed camera in which no two numbers are equal and none is 0 or 1.
Camera tilted_camera(void);
Camera random_camera(void); // far from special: every number counts
// Each number of origin, direction and center is between minus that and that.
Ray random_ray(double origin, double direction);
Sphere random_sphere(double center, double low, double high); // radius: low to high
Resolution random_screen(int low, int below);
// The i-th of a series: a single column, a single row, portrait, landscape; the shorter side is
// below middle, and the longer one from there on.
Resolution random_shape(int i, int middle, int most);
Pixel random_pixel(Resolution screen);

// Where gdb stops: the case of this number begins (the first is 1).
void case_begins(int number);

// ---- expected roots: their number, and each to within an absolute tolerance --------------------

// If there are fewer roots, the values of the unused t do not matter.
void expect_roots(Roots yours, Roots expected, double within);

#endif
