// bins_tile.h - one tile of the screen, and the spheres of its bin.
#ifndef CHAPTERS_08_FAST_BINS_TILE_H
#define CHAPTERS_08_FAST_BINS_TILE_H

#include "chapters/08-fast/engines/bins_lanes.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/sphere_colors.h"

// The data that all tiles share.
typedef struct {
    const Work *work;
    const BinsLanes *lanes;
    const Place *places; // near ones first
    const Paint *paints;
    int *seen; // if not NULL: gets the sphere that each pixel sees, and the image gets nothing
} Tiling;

// Casts the tile with this upper left pixel. bin has the places of its count spheres, near ones
// first.
void tile_cast(const Tiling *tiling, Pixel corner, const int *bin, size_t count);

#endif
