// bins_lanes.h - the inner loops of step 6, as numbers and arrays.
#ifndef CHAPTERS_08_FAST_BINS_LANES_H
#define CHAPTERS_08_FAST_BINS_LANES_H

#include "chapters/08-fast/lanes.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TILE_WIDTH = 32, TILE_HEIGHT = 32 };

// Where on the screen a sphere is (columns left to right - 1, rows top to bottom - 1), and how near
// it comes to the eye: a little less rather than more, and without the last PLACE_DROPPED bits of
// the float, so that places can be sorted by what is left.
enum { PLACE_DROPPED = 15 };
typedef struct {
    uint16_t left, right, top, bottom;
    float near;
    int sphere;
} Place;

// Spheres as seen from the eye, and the camera: its axes, and from the plane at distance 1 to
// pixels.
enum { PLACES = 256 };
typedef struct {
    double x[PLACES], y[PLACES], z[PLACES], radius[PLACES];
} Positions;
typedef struct {
    double right[3], up[3], forward[3];
    double across, down; // pixels per unit of the plane
    double width, height;
} Eye;

// The pixels of a tile. s is how far the nearest surface is, as t |v|^2; a pixel that float cannot
// decide has UNSURE in its colour.
enum { UNSURE = 1 << 24 };
typedef struct {
    float s[TILE_HEIGHT * TILE_WIDTH];
    int color[TILE_HEIGHT * TILE_WIDTH]; // red, 256 green, 65536 blue
} Tile;

// A part of a tile.
typedef struct {
    int left, right, top, bottom;
} Part;

// A sphere as a tile sees it. x and y columns and rows from the pixel (column, row), a ray v has
//   D = d + dx x + dy y + dxx x^2 + dxy x y + dyy y^2    and    b = b + bx x + by y,
// and meets the sphere at t |v|^2 = b - sqrt(D). Nearer than s it is where D > u^2, u = b - s, or
// where u < 0 and D > 0; by less than doubt + slope |u| it may be otherwise.
typedef struct {
    float column, row;
    float d, dx, dy, dxx, dxy, dyy;
    float b, bx, by;
    float doubt, slope;
    Part part;
    int color;
} Outline;

typedef struct {
    // Where so many spheres are; the first one is this one.
    void (*place)(const Eye *eye, const Positions *positions, int first, int count, Place *places);
    // Nothing seen yet, in so many columns and rows; there is nothing to see in the others.
    void (*clear)(Tile *tile, int columns, int rows, int color);
    // The largest s.
    float (*farthest)(const Tile *tile, Part part);
    // A sphere asks the pixels of its part.
    void (*ask)(Tile *tile, const Outline *sphere);
    // Is any pixel unsure?
    bool (*unsure)(const Tile *tile);
    // Writes bytes of red, green and blue; rows of the image are so many bytes apart.
    void (*paint)(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart);
} BinsLanes;

extern const BinsLanes bins_baseline, bins_avx2, bins_avx512;

#endif
