// measure.h - what the bench of the engines and its peers share.
#ifndef TESTS_BENCHES_MEASURE_H
#define TESTS_BENCHES_MEASURE_H

#include "chapters/08-fast/engine.h"

// What the engine that is being measured spends, in seconds. Who builds something that another
// camera could use adds it to build; who measures the casting himself (another program) sets cast.
typedef struct {
    double build, cast;
    const char *scene_path;
} Measured;

extern Measured measured;

double seconds_now(void);

// Other ray casters, behind the same interface; none unless PEERS=1. The last one has no name.
extern const Engine peers[];

bool cast_embree_8(const Work *work, Message *message);
bool cast_embree_16(const Work *work, Message *message);
bool cast_embree_user(const Work *work, Message *message);
bool cast_povray(const Work *work, Message *message);
bool cast_tachyon(const Work *work, Message *message);

#endif
