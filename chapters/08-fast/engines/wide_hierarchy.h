// wide_hierarchy.h - the same hierarchy with 16 boxes in a node, so that all 16 are asked at once.
// For rays from anywhere, a leaf also has up to 16 spheres, which are asked at once.
//
// After Wald, Benthin and Boulos, 'Getting Rid of Packets', 2008.
#ifndef CHAPTERS_08_FAST_ENGINES_WIDE_HIERARCHY_H
#define CHAPTERS_08_FAST_ENGINES_WIDE_HIERARCHY_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/lanes.h"
#include "common/scene.h"

#include <stdalign.h>
#include <stdint.h>

// The middles of the boxes and half their sizes, by axis, from a corner of the node's own box: near
// that corner floats are precise enough. 512 bytes, from the start of a cache line.
typedef struct {
    alignas(64) float middle[3][LANES];
    float half[3][LANES];
    int first[LANES]; // of the spheres in a box; if count is 0, a node
    uint8_t count[LANES];
    double corner[3];
    float size; // of the node's own box, its longest side
    int boxes;  // number of boxes, at most 16
    int leaves; // number of the first leaf among all leaves
} WideNode;

typedef struct {
    int nodes, leaves;
} WideCount;

// NULL if there is not enough memory. The root is the first node; count is for the number of all.
// Free it with free. A box with at most few spheres is not divided; few is at most 16. The floats
// are lengths times the scale, so that they are in the range of floats; the corners are not scaled.
WideNode *wide_build(const Hierarchy *hierarchy, double scale, int few, int threads,
                     WideCount *count);

// For rays from anywhere, all lengths are multiplied by a scale, so that the largest box has the
// size 1. The place of a node or a leaf is counted from the corner of the largest box. Places in a
// node are counted from the node's own corner, and those in a leaf from the leaf's centre: near
// these, floats are precise enough.
typedef float Four __attribute__((vector_size(16))); // x, y, z, and 0

// Boxes by their low and high sides along x, y and z, larger by the error of rounding. A lane
// without a box has no inside. 512 bytes.
typedef struct {
    alignas(64) float sides[6 * LANES];
    int below[LANES]; // where it is (ray_world_data): a node; if negative, a leaf
    Four corner;
} RayNode;

// At most 16 spheres, larger by the error of rounding. A lane without a sphere has no radius: NaN.
// 320 bytes.
typedef struct {
    alignas(64) float x[LANES], y[LANES], z[LANES], r[LANES];
    Four center;
    int first; // the place of the first one in the order of the hierarchy
} RayLeaf;

// A scene that rays from anywhere can ask.
typedef struct {
    RayNode *nodes; // the root is the first, after them the leaves; NULL if there are no spheres
    const double *numbers; // those of the hierarchy
    int *places;           // of the scene's spheres in that order
    double corner[3], scale;
} RayWorld;

// A node or a leaf: its place in memory is counted in cache lines. ~ the place of a leaf.
enum { CACHE_LINE = 64 };
static inline const void *ray_world_data(const RayWorld *world, int place)
{
    return (const char *)world->nodes + CACHE_LINE * (ptrdiff_t)(place ^ place >> 31);
}

// False if there is not enough memory. The hierarchy must outlive the world.
bool ray_world_build(RayWorld *world, const Hierarchy *hierarchy, int threads);
void ray_world_free(RayWorld *world);

#endif
