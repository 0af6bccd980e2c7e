// engine.h - six ways to cast the same picture.
//
// Each engine is a step, and a section of the lesson. All give the pixels of chapter 06. They
// differ in the questions that they leave out, and in how many they ask at a time.
#ifndef CHAPTERS_08_FAST_ENGINE_H
#define CHAPTERS_08_FAST_ENGINE_H

#include "chapters/shared/render.h"
#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/text.h"

#include <math.h>
#include <stdbool.h>

// The picture to cast.
typedef struct {
    const Scene *scene;
    Camera camera;
    Image *image; // every pixel is set
    int threads;  // at least 1
    // If not NULL: gets the time when casting began, by clock_seconds. A hierarchy that was built
    // before that can be used with every camera.
    double *built;
    // If not NULL: called before plain casts the scene instead, because its numbers are extreme.
    void (*extreme)(void);
} Work;

typedef struct {
    const char *name;
    const char *idea; // in one line
    // If there is not enough memory: false, and a message. Then the image may be incomplete.
    bool (*cast)(const Work *work, Message *message);
    // The same with the light of chapter 07; NULL if the engine can only cast rays from the eye.
    bool (*light)(const Work *work, Style style, Message *message);
} Engine;

// In the order of the lesson; the last one has no name.
extern const Engine engines[];

// NULL if there is no engine of this name.
const Engine *engine_named(const char *name);

bool cast_plain(const Work *work, Message *message);
bool light_plain(const Work *work, Style style, Message *message);
// The same, instead of another engine, for a scene with extreme numbers.
bool cast_extreme(const Work *work, Message *message);
bool cast_object(const Work *work, Message *message);
bool cast_bvh(const Work *work, Message *message);
bool light_bvh(const Work *work, Style style, Message *message);
bool cast_packet(const Work *work, Message *message);
bool cast_tiles(const Work *work, Message *message);
bool cast_bins(const Work *work, Message *message);
// The sphere that each pixel sees, row by row, -1 for none; of the image only the size matters.
// False if bins cannot find them.
bool bins_spheres(const Work *work, int *spheres);

// ---- threads ----------------------------------------------------------------------------------

// Calls part(given, i) once for each i from 0 to parts - 1, in any order, by this number of threads
// (POSIX threads: every Unix has them, and only a queue is needed). With 1, it uses the caller's
// thread. If a thread cannot be created, the others do its work.
void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given);

static inline int least(int a, int b)
{
    return a < b ? a : b;
}

static inline int most(int a, int b)
{
    return a > b ? a : b;
}

// ---- colors and vectors ----------------------------------------------------------------------

// A color is red + 256 green + 65536 blue. One for each surface, and after the last one the
// background. Free it with free; NULL if there is not enough memory.
int *colors_of(const Scene *scene);

static inline int sphere_color(const Scene *scene, const int *colors, int sphere)
{
    return colors[sphere < 0 ? scene->surface_count : scene->spheres[sphere].surface];
}

// Colors a pixel by the sphere that it sees, -1 for none. Unlike image_set this may be called by
// several threads, for different pixels.
static inline void paint_pixel(Image *image, size_t pixel, const Scene *scene, const int *colors,
                               int sphere)
{
    for (int i = 0; i < 3; i++)
        image->rgb[3 * pixel + (size_t)i] = (uint8_t)(sphere_color(scene, colors, sphere) >> 8 * i);
}

// The nearest hit of a ray in a scene; of is what it needs besides.
typedef Hit Nearest(const void *of, const Scene *scene, Ray ray);
// Casts the ray of every pixel. False if there is not enough memory.
bool cast_rays(const Work *work, Nearest *nearest, const void *of, Message *message);
// Threads that finish rows say so.
void rows_are_done(Image *image, int rows);

// A vec3 as plain numbers, for files of lanes (lanes.h).
static inline void view_store(double numbers[3], vec3 v)
{
    for (int i = 0; i < 3; i++)
        numbers[i] = v[i];
}

// ---- numbers for which only chapter 06's loop is right ----------------------------------------

// If the numbers of a scene are beyond these limits, 'plain' casts it, whichever engine was chosen:
// the picture stays the same. Within them, no fast engine leaves out a sphere that chapter 05 hits:
//
// Let D be the distance from the start of a ray to the center c of a sphere of radius r, and e =
// 2^-52. Chapter 05 rounds c - start, and the point of the line that is closest to c. Along each
// axis both have an error of at most e D. So the distance of the line from c has an error of at
// most 2 e D. (An error along the line only makes it larger, by its square.)
//
// - Tests in double of one ray and one sphere have a margin of 1e-12 (D^2 + r^2) for squares whose
//   error is a few e (D^2 + r^2): enough at any distance, and for the textbook's b^2 - 4ac. What
//   they cannot decide, the linked functions do.
// - Tests in float have margins of at least 2^-20 D.
// - Boxes: a sphere touches its box in six places. At an angle s from such a place, a line that
//   touches the sphere has s D of its length along that axis, so an error of at most 2 s e D; the
//   box is s r / 2 larger there. That is enough up to 1e15 radii.
// - Places on the screen have a margin of a sixteenth of a pixel or more for 2 e, as an angle:
//   FINEST_PIXEL.
// - Places in the grid of a light have a margin of half a pixel, at least 3e-5 r for 2 e D. D is at
//   most twice the largest distance from the eye: EXTREME_RADII_OF_LIGHT.

#define EXTREME_RADII 1e12
#define EXTREME_RADII_OF_LIGHT 1e10
#define FINEST_PIXEL 1e-13  // at the distance 1
#define EXTREME_LENGTH 1e60 // and its reciprocal

bool extreme_camera(Camera camera, Resolution screen);

// Whether 'plain' must cast a picture.
bool extreme_scene(const Work *work);

// The same for light: then rays start anywhere, near a sphere (offset_from_surface), so the largest
// distance is compared with the radius of the smallest sphere.
bool extreme_light(const Work *work);

#endif
