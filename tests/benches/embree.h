// embree.h - spheres that Embree can ask: what its two peers share.
#ifndef TESTS_BENCHES_EMBREE_H
#define TESTS_BENCHES_EMBREE_H

#include "tests/benches/measure.h"

#include <embree3/rtcore.h>

// User geometry, with a test of 16 lanes.
typedef struct {
    RTCDevice device;
    RTCScene scene;
    float *spheres;
} EmbreeSpheres;

// False if Embree reports an error. embree_free frees it in both cases.
bool embree_spheres(EmbreeSpheres *spheres, const Scene *scene, int threads);
void embree_free(EmbreeSpheres *spheres);

#endif
