// hierarchy.h - a bounding volume hierarchy: boxes of boxes of spheres.
//
// If a ray misses a box, it misses everything in it. Built from the top by the surface area
// heuristic (MacDonald and Booth, 'Heuristics for Ray Tracing Using Space Subdivision', 1990; with
// bins: Wald, 'On Fast Construction of SAH-based Bounding Volume Hierarchies', 2007).
#ifndef CHAPTERS_08_FAST_HIERARCHY_H
#define CHAPTERS_08_FAST_HIERARCHY_H

#include "chapters/08-fast/engines/lanes.h"
#include "common/ray.h"
#include "common/scene.h"

#include <stdalign.h>
#include <stdbool.h>

// The sides of a box, along x, y, z.
typedef struct {
    double low[3], high[3];
} Box;

// A node holds count spheres, from first on in the order of the hierarchy. It has two children, or
// none: then it is a leaf. The first child is the next node, the second one is number other. Along
// axis, the centers in the first child are before those in the second.
typedef struct {
    Box box;
    int first, count;
    int other; // 0: none
    int axis;
} Node;

// A few giants, such as a ground or a sky, would make every box around them as large as the scene.
// So they are the root's second child, the last in the order. A giant's radius is at least half the
// diagonal of the box around the centers of the others.
enum { MOST_GIANTS = 4 };
typedef struct {
    Node *nodes; // the root is the first
    int node_count;
    int *order;      // indices of the scene's spheres
    double *numbers; // x, y, z and r of each, in this order
    int giant_count;
} Hierarchy;

// The largest depth of the hierarchy; and the size of a leaf whose spheres are asked one by one.
enum { HIERARCHY_DEEPEST = 128, SMALL_LEAF = 4 };

// More than leaf spheres are split. False if there is not enough memory. Boxes are a little larger
// than their spheres, so that they contain every hit, in spite of rounding.
bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene, int leaf);
void hierarchy_free(Hierarchy *hierarchy);

// The nearer of two hits; as in chapter 06, the lower index wins if both are equally near.
static inline Hit nearer(Hit a, Hit b)
{
    bool b_wins = b.t < a.t || (b.t == a.t && b.t < NO_HIT && b.sphere < a.sphere);
    return b_wins ? b : a;
}

// The nearest hit of one ray (bvh.c): the same as chapter 06's nearest_hit, to the bit.
Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray);

// ---- many boxes in a node ---------------------------------------------------------------------

// The same hierarchy with 16 boxes in a node and up to 16 spheres in a leaf, so that all 16 are
// asked at once (after Wald, Benthin and Boulos, 'Getting Rid of Packets', 2008). In a page, where
// a vector has 4 floats, 8 are quicker. The giants are in no node.
#ifdef __wasm__
enum { BOXES = 8 };
#else
enum { BOXES = 16 };
#endif

// All lengths are multiplied by a scale, so that the largest box has the size 1. The place of a
// node or a leaf is counted from the corner of the largest box. Places in a node are counted from
// the node's own corner, and those in a leaf from the leaf's center: near these, floats are precise
// enough.
typedef float Four __attribute__((vector_size(16))); // along x, y and z; and one more
typedef int FourInts __attribute__((vector_size(16)));

// Boxes by their low and high sides along x, y and z, larger by the error of rounding. A lane
// without a box has no inside. 512 bytes, from the start of a cache line.
typedef struct {
    alignas(64) float sides[6 * BOXES];
    int below[BOXES]; // the number of a node; ~ the number of a leaf
    Four corner;
    float size; // of the node's own box, its longest side
} WideNode;

// Spheres, larger by the error of rounding. A lane without a sphere has no radius: NaN.
typedef struct {
    alignas(64) float x[BOXES], y[BOXES], z[BOXES], r[BOXES];
    Four center;
    int first, count; // their places in the order of the hierarchy
} WideLeaf;

typedef struct {
    WideNode *nodes; // the root is the first; NULL if there are only giants, or no spheres
    WideLeaf *leaves;
    const double *numbers; // those of the hierarchy
    int *places;           // of the scene's spheres in its order
    int giants, end;       // the places of the giants: from the first one to before the end
    double corner[3], scale;
} WideHierarchy;

// From a hierarchy whose leaves have at most 16 spheres, which must outlive it. False if there is
// not enough memory.
bool wide_build(WideHierarchy *wide, const Hierarchy *hierarchy);
void wide_free(WideHierarchy *wide);

#endif
