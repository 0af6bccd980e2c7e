// bins_lanes.h - the inner loops of step 6, and the numbers and arrays that they work on.
//
// A sphere has a place on the screen. In the bin of a tile it is an item; a tile that is cast makes
// candidates of the items, and outlines of the candidates. Outlines ask the pixels.
#ifndef CHAPTERS_08_FAST_BINS_LANES_H
#define CHAPTERS_08_FAST_BINS_LANES_H

#include "chapters/08-fast/engines/lanes.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { TILE_WIDTH = 32, TILE_HEIGHT = 32 };

// The place of a sphere on the screen (columns left to right - 1, rows top to bottom - 1), and its
// least distance from the eye. That is rounded down, without the last PLACE_DROPPED bits of the
// float; places are sorted by the other bits.
enum { PLACE_DROPPED = 15 };
typedef struct {
    uint16_t left, right, top, bottom;
    float near;
    int sphere;
} Place;

static inline int depth_of(float near)
{
    uint32_t bits;
    memcpy(&bits, &near, sizeof bits); // floats from 0 up have the order of their bits
    return (int)(bits >> PLACE_DROPPED);
}

static inline uint32_t place_depth(Place place)
{
    return (uint32_t)depth_of(place.near);
}

// A sphere of a bin in one number: from the highest bits on its depth, its part of the tile, and
// its number in the scene. So a bin is sorted by depth if its numbers are sorted.
typedef uint64_t Item;
enum { ITEM_SPHERE = 28, ITEM_PART = 20 }; // bits

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
    int tiles; // in a row
} Eye;

// The places of spheres, and the tile of those in one tile.
typedef enum { UNSEEN, IN_ONE_TILE, IN_TILES } PlaceKind;
typedef struct {
    int left[PLACES], right[PLACES], top[PLACES], bottom[PLACES], depth[PLACES];
    int kind[PLACES], tile[PLACES], part[PLACES];
} Places;

static inline Place place_at(const Places *places, int i, int sphere)
{
    const uint32_t bits = (uint32_t)places->depth[i] << PLACE_DROPPED;
    Place place = {.left = (uint16_t)places->left[i],
                   .right = (uint16_t)places->right[i],
                   .top = (uint16_t)places->top[i],
                   .bottom = (uint16_t)places->bottom[i],
                   .sphere = sphere};
    memcpy(&place.near, &bits, sizeof bits);
    return place;
}

// The pixels of a tile. s is t v.v of the nearest hit so far: its distance times |v|. A pixel that
// float cannot decide has UNSURE in its colour.
enum { UNSURE = 1 << 24 };
typedef struct {
    // Aligned to a cache line, so that 16 of them are in one line.
    _Alignas(64) float s[TILE_HEIGHT * TILE_WIDTH];
    int color[TILE_HEIGHT * TILE_WIDTH]; // red, 256 green, 65536 blue; or a colour's number
} Tile;

// A part of a tile.
typedef struct {
    int left, right, top, bottom;
} Part;

// The rays of a tile: that of the first pixel, and the differences from column to column and from
// row to row; and the dot products of these two differences.
typedef struct {
    double first[3], column[3], row[3];
    double columns, rows, both;
} Rays;

// Up to OUTLINES spheres that may be visible: the centre from the eye, the radius; a pixel in the
// middle of the sphere's part of the tile, and how far that part reaches from there.
enum { OUTLINES = 8 };
typedef struct {
    double x[OUTLINES], y[OUTLINES], z[OUTLINES], radius[OUTLINES];
    double column[OUTLINES], row[OUTLINES], half_width[OUTLINES], half_height[OUTLINES];
} Candidates;

// Spheres, seen from a tile. D is a quarter of chapter 05's discriminant, c the centre from the
// eye, v the ray. For the ray x columns and y rows from the pixel (x, y)
//   D   = d + dx x + dy y + dxx x^2 + dxy x y + dyy y^2
//   c.v = b + bx x + by y
// and it meets the sphere at t v.v = c.v - sqrt(D). With u = c.v - s that is nearer than s if D >
// u^2, or if u < 0 and D > 0. If the two sides differ by less than doubt, float cannot decide. The
// error of c.v is at most b_error, and that of the new s at most s_error.
typedef struct {
    float x[OUTLINES], y[OUTLINES];
    float d[OUTLINES], dx[OUTLINES], dy[OUTLINES], dxx[OUTLINES], dxy[OUTLINES], dyy[OUTLINES];
    float b[OUTLINES], bx[OUTLINES], by[OUTLINES];
    float doubt[OUTLINES], b_error[OUTLINES], s_error[OUTLINES];
    // 0 if float is not reliable: if the eye is inside the sphere or close to it, if the sphere is
    // partly beside or behind the eye, or if its size is extreme.
    int safe[OUTLINES];
} Outlines;

typedef struct {
    // The places of count spheres on the screen. False if the numbers of any may be extreme
    // (number_limits.h).
    bool (*place)(const Eye *eye, const Positions *positions, int count, Places *places);
    // Sorts the items of a bin, near ones first. After them there is room for as many. Returns
    // where the sorted ones are: in this room, or in the place of the others.
    const Item *(*sort)(Item *items, size_t count);
    // Clears these columns and rows; the other pixels of the tile are outside the screen.
    void (*clear)(Tile *tile, int columns, int rows, int color);
    // The largest s.
    float (*farthest)(const Tile *tile, Part part);
    // The outlines of all OUTLINES candidates, seen from the tile; the compiler optimises better
    // for a constant number.
    void (*outline)(const Rays *rays, const Candidates *candidates, Outlines *outlines);
    // Sphere number n of these asks the pixels of its part. slack is the largest error of any s.
    void (*ask)(Tile *tile, const Outlines *outlines, int n, Part part, float slack, int color);
    // The same in double, if float is not reliable: the centre from the eye and the radius; the s
    // of this sphere is nowhere less than nearest. Returns the largest s that it set.
    float (*ask_in_double)(Tile *tile, const Rays *rays, const double center[3], double radius,
                           Part part, float nearest, float slack, int color);
    // Is any pixel unsure?
    bool (*unsure)(const Tile *tile);
    // Writes bytes of red, green and blue; apart is the number of bytes from row to row.
    void (*paint)(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart);
    // Writes one byte a pixel, the number of its colour, which is less than 32. Returns the set of
    // these numbers, as bits.
    uint32_t (*paint_flat)(const Tile *tile, int columns, int rows, uint8_t *numbers, size_t apart);
} BinsLanes;

extern const BinsLanes bins_baseline, bins_avx2, bins_avx512;

#endif
