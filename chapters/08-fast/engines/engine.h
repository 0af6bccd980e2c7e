// engine.h - six ways to cast the same picture.
//
// Each engine is a step, and a section of the lesson. All give the pixels of chapter 06. They
// differ in the questions that they leave out, and in how many they ask at a time.
#ifndef CHAPTERS_08_FAST_ENGINE_H
#define CHAPTERS_08_FAST_ENGINE_H

#include "chapters/shared/render.h"
#include "common/camera.h"
#include "common/image.h"
#include "common/scene.h"
#include "common/text.h"

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
    bool may_be_flat; // bins may make a flat image of it (common/image_flat.h)
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

// 1. Chapter 06's loop: every pixel asks every sphere.
bool cast_plain(const Work *work, Message *message);
bool light_plain(const Work *work, Style style, Message *message);
// The same, instead of another engine, for a scene with extreme numbers (number_limits.h).
bool cast_extreme(const Work *work, Message *message);
// 2. Object order: every sphere asks the pixels of its rectangle.
bool cast_object(const Work *work, Message *message);
// 3. A bounding volume hierarchy: every ray asks the spheres on its way.
bool cast_bvh(const Work *work, Message *message);
bool light_bvh(const Work *work, Style style, Message *message);
// 4. The same with 16 rays at a time.
bool cast_packet(const Work *work, Message *message);
// 5. A tile's whole frustum asks.
bool cast_tiles(const Work *work, Message *message);
// 6. Object order with bins: every tile asks the spheres in it, near ones first.
bool cast_bins(const Work *work, Message *message);
// The sphere that each pixel sees, row by row, -1 for none; of the image only the size matters.
// False if there is not enough memory, or if the scene is extreme (number_limits.h).
bool bins_spheres(const Work *work, int *spheres);

// Does what the command line of chapter 08 says: which engine draws which scene (cast.c). Returns
// the result of main.
int cast_command(int argc, char **argv);

#endif
