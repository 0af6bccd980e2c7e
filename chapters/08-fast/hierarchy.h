// hierarchy.h - a bounding volume hierarchy: boxes of boxes of spheres.
//
// A box that a ray misses holds nothing that it hits. Built from the top by the surface area
// heuristic (MacDonald and Booth, 'Heuristics for Ray Tracing Using Space Subdivision', 1990; with
// bins: Wald, 'On Fast Construction of SAH-based Bounding Volume Hierarchies', 2007).
#ifndef CHAPTERS_08_FAST_HIERARCHY_H
#define CHAPTERS_08_FAST_HIERARCHY_H

#include "common/scene.h"

#include <stdbool.h>

// The sides of a box, along x, y, z.
typedef struct {
    double low[3], high[3];
} Box;

// Half of it, which will do for comparing; 0 of a box that holds nothing.
static inline double box_surface(const Box *box)
{
    double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1];
    double z = box->high[2] - box->low[2];
    return box->low[0] > box->high[0] ? 0 : x * y + y * z + z * x;
}

// A node holds count spheres, from first on in the order of the hierarchy. It has two children, or
// none: a leaf. The one is the next of the nodes, the other is number other; along axis the centres
// in the one are before those in the other.
typedef struct {
    Box box;
    int first, count;
    int other; // 0: none
    int axis;
} Node;

typedef struct {
    Node *nodes; // the root is the first
    int node_count;
    int *order; // indices of the scene's spheres
} Hierarchy;

// How many boxes in one another there are at most.
enum { HIERARCHY_DEEPEST = 128 };

// False where memory is short. Boxes are a little larger than their spheres: what rounding lets a
// ray hit lies in them, too.
bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene);
void hierarchy_free(Hierarchy *hierarchy);

#endif
