// engine.h - ways to cast one and the same picture.
//
// Each engine is a step: a small file of its own, and a section of the lesson. All give the pixels
// of chapter 06; they differ in which questions they leave out, and how many they ask at a time.
#ifndef CHAPTERS_08_FAST_ENGINE_H
#define CHAPTERS_08_FAST_ENGINE_H

#include "chapters/shared/render.h"
#include "common/camera.h"
#include "common/image.h"
#include "common/scene.h"
#include "common/text.h"

#include <stdbool.h>

// What is to be cast.
typedef struct {
    const Scene *scene;
    Camera camera;
    Image *image; // every pixel is set
    int threads;  // at least 1
    // Where not NULL: when casting began, on the clock of clock.h. What was built before, a
    // hierarchy, is good for every camera.
    double *built;
} Work;

typedef struct {
    const char *name;
    const char *idea; // in one line
    // False, and a message, where memory is short; the image may be half done then.
    bool (*cast)(const Work *work, Message *message);
    // The same with the light of chapter 07; NULL where the engine knows no rays but the eye's.
    bool (*light)(const Work *work, Style style, Message *message);
} Engine;

// In the order of the lesson; the last one has no name.
extern const Engine engines[];

// NULL where there is none of this name.
const Engine *engine_named(const char *name);

// 1. Chapter 06's loop: every pixel asks every sphere.
bool cast_plain(const Work *work, Message *message);
bool light_plain(const Work *work, Style style, Message *message);
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

#endif
