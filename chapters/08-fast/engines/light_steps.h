// light_steps.h - the formulas of a shaded picture, for many paths at once.
//
// Every path takes the same steps: its ray, the place where that hits a sphere, the normal there,
// the light, the mirror. If each step is done for all paths before the next one, a processor
// computes 2, 4 or 8 of them with one instruction. IEEE 754 rounds +, -, *, / and the square root
// in the same way in a vector as alone, so the same operations in the same order give the same
// colours, to the last digit.
//
// There are two tables of steps. steps_by_chapters calls the functions of chapters 04, 05 and 07
// for one path after the other. light_steps_KIND has the formulas of the solutions, in lanes. But a
// student's functions may be different, and the picture is drawn with the functions that are
// linked. So before a picture, both tables compute rays of its scene. If one bit differs, the
// picture is drawn by the chapters' functions.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_STEPS_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_STEPS_H

#include "chapters/08-fast/engines/lanes.h"
#include "common/camera.h"
#include "common/ray.h"
#include "common/scene.h"

#include <stdalign.h>
#include <stdint.h>

// Paths that are traced together.
enum { PATHS = 256 };

typedef struct {
    alignas(64) double x[PATHS], y[PATHS], z[PATHS];
} Vectors;

// Where paths are: their rays, what these hit, and where the next rays start.
typedef struct {
    Vectors origin, direction, center, point, normal, start;
    alignas(64) double t[PATHS], radius[PATHS];
    int number[PATHS]; // of the path: those that end are removed from these arrays
    int sphere[PATHS], surface[PATHS];
    int count;
} Paths;

// A surface of the scene, without vectors.
typedef struct {
    double ambient[3], color[3], diffuse, specular, shine;
} Material;

typedef struct {
    const Scene *scene;
    const Material *materials; // of the scene's surfaces
    Camera camera;
    Resolution samples;
} Picture;

typedef struct {
    // The rays of samples of the picture.
    void (*rays)(const Picture *picture, const int *columns, const int *rows, Paths *paths);
    // The spheres that each ray may hit, as bits: only if it certainly misses one, the bit is 0. A
    // sphere is four numbers: its centre and its radius.
    void (*may_hit)(const Paths *paths, const double *spheres, int sphere_count, int *may);
    // Where the rays hit their spheres: t. False: only the chapter can compute these numbers.
    bool (*hits)(Paths *paths);
    // From there: point, normal, start.
    void (*leave)(Paths *paths);
    // The directions of the rays to a light, from start.
    void (*to_light)(const Paths *paths, const Light *light, Vectors *directions);
    // The colours there. Light number i arrives if lit[i * PATHS + path] is not 0.
    void (*shade)(const Picture *picture, const Paths *paths, const double *lit, Vectors *colors);
    // The directions in which mirrors continue.
    void (*mirror)(const Paths *paths, Vectors *directions);
    // Adds to the colours the parts of those in the mirrors; nothing if the part is not positive.
    void (*add_mirrors)(const Vectors *mirrored, const double *parts, int count, Vectors *colors);
    // Of each pixel, the mean of its samples' clamped colours. Sample i of pixel k is at
    // i * PATHS + k in each of three arrays: red, green, blue.
    void (*means)(double *const colors[3], int samples, int pixels, Vectors *means);
    // Colours as bytes.
    void (*bytes)(const Vectors *colors, int count, uint8_t *rgb);
} LightSteps;

extern const LightSteps steps_by_chapters;
extern const LightSteps light_steps_baseline, light_steps_avx2, light_steps_avx512;

// The materials of a scene; free them. NULL if there is not enough memory.
Material *materials_of(const Scene *scene);

// The steps of the best lanes if they give the numbers of the chapters' functions for rays of this
// picture; otherwise steps_by_chapters.
const LightSteps *steps_for(const Picture *picture);

static inline Ray ray_of(const Paths *paths, int i)
{
    return (Ray){vec3_of(paths->origin.x[i], paths->origin.y[i], paths->origin.z[i]),
                 vec3_of(paths->direction.x[i], paths->direction.y[i], paths->direction.z[i])};
}

static inline vec3 vector_of(const Vectors *vectors, int i)
{
    return vec3_of(vectors->x[i], vectors->y[i], vectors->z[i]);
}

static inline void set_vector(Vectors *vectors, int i, vec3 v)
{
    vectors->x[i] = v[0];
    vectors->y[i] = v[1];
    vectors->z[i] = v[2];
}

// Copies the spheres' numbers to the paths.
void take_spheres(const Scene *scene, Paths *paths);

#endif
