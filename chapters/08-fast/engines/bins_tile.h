// bins_tile.h - one tile of the screen, and the spheres of its bin.
#ifndef CHAPTERS_08_FAST_BINS_TILE_H
#define CHAPTERS_08_FAST_BINS_TILE_H

#include "chapters/08-fast/engines/bins_lanes.h"
#include "chapters/08-fast/engines/engine.h"
#include "common/image_flat.h"

#include <math.h>

// The data that all tiles share.
typedef struct {
    const Work *work;
    const BinsLanes *lanes;
    // Of each surface, and after the last one of the background: the colour, or if the image is
    // flat its number.
    const uint32_t *colors;
    FlatImage *flat; // NULL if the image is not flat
    int *seen; // if not NULL: gets the sphere that each pixel sees, and the image gets nothing
} Tiling;

static inline Item item_of(int depth, int part, int sphere)
{
    return (Item)depth << (ITEM_PART + ITEM_SPHERE) | (Item)part << ITEM_SPHERE | (Item)sphere;
}

// The part of a place in the tile that begins at this pixel; the place covers some of it.
static inline int part_in(const Place *place, int tile_left, int tile_top)
{
    int left = place->left - tile_left, right = place->right - 1 - tile_left;
    int top = place->top - tile_top, bottom = place->bottom - 1 - tile_top;
    left = left > 0 ? left : 0;
    top = top > 0 ? top : 0;
    right = right < TILE_WIDTH ? right : TILE_WIDTH - 1;
    bottom = bottom < TILE_HEIGHT ? bottom : TILE_HEIGHT - 1;
    return ((left * TILE_WIDTH + right) * TILE_HEIGHT + top) * TILE_HEIGHT + bottom;
}

// The rays from this pixel on. They end on the plane, because the step from one pixel to the next
// is the same there.
Rays rays_from(const Work *work, Pixel first);

// Do all rays of this part hit the sphere, seen from outside? Those that do are inside a cone,
// which is convex, so it is enough to ask the corners. The square of the cosine between c, the
// centre from the eye, and a ray of the outline is 1 - radius^2 / c.c; there is a margin for
// rounding.
bool covers(const Rays *rays, vec3 c, double radius, Part part);

// A little more than the distance of the outline; the sphere hides all that begins there.
static inline double beyond_outline(vec3 c, double radius)
{
    return 1.00001 * sqrt(vec3_dot(c, c) - radius * radius);
}

// Casts the tile with this upper left pixel. The items are those of its bin, in any order; after
// them there is room for the sorted ones.
void tile_cast(const Tiling *tiling, Pixel corner, Item *items, size_t count);

#endif
