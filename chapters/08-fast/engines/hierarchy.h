// hierarchy.h - a bounding volume hierarchy: boxes of boxes of spheres.
//
// If a ray misses a box, it misses everything in it. Built from the top by the surface area
// heuristic (MacDonald and Booth, 'Heuristics for Ray Tracing Using Space Subdivision', 1990; with
// bins: Wald, 'On Fast Construction of SAH-based Bounding Volume Hierarchies', 2007).
#ifndef CHAPTERS_08_FAST_HIERARCHY_H
#define CHAPTERS_08_FAST_HIERARCHY_H

#include "common/ray.h"
#include "common/scene.h"

#include <stdbool.h>

// The sides of a box, along x, y, z.
typedef struct {
    double low[3], high[3];
} Box;

// Half of the surface, which is enough for comparing; 0 for an empty box.
static inline double box_surface(const Box *box)
{
    double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1];
    double z = box->high[2] - box->low[2];
    return box->low[0] > box->high[0] ? 0 : x * y + y * z + z * x;
}

// A node holds count spheres, from first on in the order of the hierarchy. It has two children, or
// none: then it is a leaf. The first child is the next node, the second one is number other. Along
// axis, the centres in the first child are before those in the second.
typedef struct {
    Box box;
    int first, count;
    int other; // 0: none
    int axis;
} Node;

typedef struct {
    Node *nodes; // the root is the first
    int node_count;
    int *order;      // indices of the scene's spheres
    double *numbers; // x, y, z and r of each, in this order
} Hierarchy;

// The largest depth of the hierarchy; and the size of a leaf whose spheres are asked one by one.
enum { HIERARCHY_DEEPEST = 128, SMALL_LEAF = 4 };

// More than leaf spheres are split. False if there is not enough memory. Boxes are a little larger
// than their spheres, so that they contain every hit, in spite of rounding.
bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene, int leaf, int threads);
void hierarchy_free(Hierarchy *hierarchy);

// The nearer of two hits; as in chapter 06, the lower index wins if both are equally near.
static inline Hit nearer(Hit a, Hit b)
{
    bool b_wins = b.t < a.t || (b.t == a.t && b.t < NO_HIT && b.sphere < a.sphere);
    return b_wins ? b : a;
}

// The nearest hit of one ray (bvh.c): the same as chapter 06's nearest_hit, to the bit.
Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray);

#endif
