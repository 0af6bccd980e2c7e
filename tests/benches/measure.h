// measure.h - what the bench of the engines and its peers share.
#ifndef TESTS_BENCHES_MEASURE_H
#define TESTS_BENCHES_MEASURE_H

#include "chapters/08-fast/engines/engine.h"

// Seconds, by a peer that measures itself: what another camera could use, and the casting. An
// engine says when its casting begins (Work.built).
typedef struct {
    double build, cast;
    const char *scene_path;
} Measured;

extern Measured measured;

// Other ray casters, with the same interface; none unless PEERS=1. The last one has no name.
extern const Engine peers[];

// Whether a peer is installed; if not, a message that says what is missing.
bool peer_is_here(const Engine *peer, Message *message);

bool embree_is_here(void);
bool cast_embree_8(const Work *work, Message *message);
bool cast_embree_16(const Work *work, Message *message);
bool cast_embree_user(const Work *work, Message *message);
bool cast_povray(const Work *work, Message *message);
bool cast_tachyon(const Work *work, Message *message);
// With shadows and mirrors.
bool light_embree(const Work *work, Style style, Message *message);
bool light_povray(const Work *work, Style style, Message *message);

#endif
