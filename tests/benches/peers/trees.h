// trees.h - boxes and spheres that rays visit, in chapter 08's trees and in Embree's.
#ifndef TESTS_BENCHES_PEERS_TREES_H
#define TESTS_BENCHES_PEERS_TREES_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "common/scene.h"

#include <stdbool.h>

typedef struct {
    float origin[3], direction[3], reach; // as Embree takes them; direction of length 1
} Single;

// any: the first hit that is found ends a ray.
typedef struct {
    const char *name;
    const Single *rays;
    int count;
    bool any;
} RayKind;
enum { RAY_KINDS = 3 };

// What rays of each kind visit in chapter 08's tree, as parts of what they visit in Embree's.
typedef struct {
    double boxes[RAY_KINDS], spheres[RAY_KINDS];
} TreeRatios;

// Prints the visits. wide: the hierarchy that becomes the nodes of 16 boxes (wide_hierarchy.h).
// spheres: x, y, z and r of the scene's spheres.
TreeRatios compare_trees(const Scene *scene, const Hierarchy *wide, const float *spheres,
                         const RayKind kinds[RAY_KINDS]);

#endif
