// bins.h - the inner loops of step 6, and the numbers and arrays that they work on.
//
// A sphere has a place on the screen. In the bin of a tile it is an item; a tile that is cast makes
// candidates of the items, and outlines of the candidates. Outlines ask the pixels.
#ifndef CHAPTERS_08_FAST_ENGINES_BINS_H
#define CHAPTERS_08_FAST_ENGINES_BINS_H

#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/lanes.h"

#include <stdatomic.h>
#include <stdint.h>
#include <string.h>

enum { SIDE = 32 }; // pixels of a tile, in each direction

// The camera's axes, and from the plane at distance 1 to pixels.
typedef struct {
    double right[3], up[3], forward[3];
    double across, down; // pixels per unit of the plane
    double width, height;
    // A pixel is in the place of a sphere if its center is, or is outside by this, in pixels:
    // ROUNDING for rays through the centers.
    double margin;
} Eye;
#define ROUNDING (1.0 / 64)

Eye eye_of(const Work *work);

// Spheres as seen from the eye, PLACES at a time.
enum { PLACES = 256 };
typedef struct {
    double x[PLACES], y[PLACES], z[PLACES], radius[PLACES];
} Positions;

static inline void position_set(Positions *positions, int i, vec3 c, double radius)
{
    positions->x[i] = c[0];
    positions->y[i] = c[1];
    positions->z[i] = c[2];
    positions->radius[i] = radius;
}

// Their places on the screen (columns left to right - 1, rows top to bottom - 1), and their least
// distances from the eye, rounded down: a float without its last DEPTH_DROPPED bits.
enum { DEPTH_DROPPED = 15 };
typedef struct {
    uint16_t left[PLACES], right[PLACES], top[PLACES], bottom[PLACES], depth[PLACES];
} Places;

static inline int depth_of(float near)
{
    uint32_t bits;
    memcpy(&bits, &near, sizeof bits); // floats from 0 up have the order of their bits
    return (int)(bits >> DEPTH_DROPPED);
}

// A part of a tile: columns left to right - 1, rows top to bottom - 1.
typedef struct {
    int left, right, top, bottom;
} Part;

// A sphere of a bin in one number: from the highest bits on its depth, its part of the tile, and
// its number in the scene. So a bin is sorted by depth if its numbers are sorted.
typedef uint64_t Item;
enum { ITEM_SPHERE = 28, ITEM_PART = 20 }; // bits

static inline Item item_of(int depth, Part part, int sphere)
{
    int bits = ((part.left * SIDE + part.right - 1) * SIDE + part.top) * SIDE + part.bottom - 1;
    return (Item)depth << (ITEM_PART + ITEM_SPHERE) | (Item)bits << ITEM_SPHERE | (Item)sphere;
}

static inline int sphere_of(Item item)
{
    return (int)(item & ((1 << ITEM_SPHERE) - 1));
}

static inline Part part_of(Item item)
{
    int bits = (int)(item >> ITEM_SPHERE & ((1 << ITEM_PART) - 1));
    return (Part){bits / (SIDE * SIDE * SIDE), bits / (SIDE * SIDE) % SIDE + 1, bits / SIDE % SIDE,
                  bits % SIDE + 1};
}

// The least distance from the eye, rounded down.
static inline float near_of(Item item)
{
    uint32_t bits = (uint32_t)(item >> (ITEM_SPHERE + ITEM_PART)) << DEPTH_DROPPED;
    float near;
    memcpy(&near, &bits, sizeof near);
    return near;
}

// The pixels of a tile. s is t v.v of the nearest hit so far: its distance times |v|. A pixel that
// float cannot decide has UNSURE in its color.
enum { UNSURE = 1 << 24 };
typedef struct {
    _Alignas(64) float s[SIDE * SIDE]; // from the start of a cache line, so that 16 are in a line
    int color[SIDE * SIDE];            // or a sphere's number + 1
} TilePixels;

// The rays of a tile: that of the first pixel, and the differences from column to column and from
// row to row.
typedef struct {
    double first[3], column[3], row[3];
} TileRays;

// Up to OUTLINES spheres that may be visible: the center from the eye, the radius; a pixel in the
// middle of the sphere's part of the tile, and how far that part reaches from there.
enum { OUTLINES = 8 };
typedef struct {
    double x[OUTLINES], y[OUTLINES], z[OUTLINES], radius[OUTLINES];
    double column[OUTLINES], row[OUTLINES], half_width[OUTLINES], half_height[OUTLINES];
} Candidates;

// Spheres, seen from a tile. D is a quarter of chapter 05's discriminant, c the center from the
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
    // (engine.h).
    bool (*place)(const Eye *eye, const Positions *positions, int count, Places *places);
    // Sorts the items of a bin, near ones first. After them there is room for as many. Returns
    // where the sorted ones are: in this room, or in the place of the others.
    const Item *(*sort)(Item *items, size_t count);
    // Clears these columns and rows; the other pixels of the tile are outside the screen.
    void (*clear)(TilePixels *tile, int columns, int rows, int color);
    // The largest s.
    float (*farthest)(const TilePixels *tile, Part part);
    // The outlines of all OUTLINES candidates, seen from the tile; the compiler optimises better
    // for a constant number.
    void (*outline)(const TileRays *rays, const Candidates *candidates, Outlines *outlines);
    // Sphere number n of these asks the pixels of its part. slack is the largest error of any s.
    void (*ask)(TilePixels *tile, const Outlines *outlines, int n, Part part, float slack,
                int color);
    // Candidate number n asks in double, if float is not reliable; its s is nowhere less than
    // nearest. Returns the largest s that it set.
    float (*ask_in_double)(TilePixels *tile, const TileRays *rays, const Candidates *candidates,
                           int n, Part part, float nearest, float slack, int color);
    // Is any pixel unsure?
    bool (*unsure)(const TilePixels *tile);
    // Colors, in rows of a tile, become bytes of red, green and blue; apart is the number of bytes
    // from row to row.
    void (*paint)(const int *colors, int side, int columns, int rows, uint8_t *rgb, size_t apart);
} BinsLanes;

extern const BinsLanes bins_baseline, bins_avx2, bins_avx512;

// ---- bins of all tiles ------------------------------------------------------------------------

// All bins are in one array. First the items of each bin are counted, so that it is known where the
// bin begins; then the array is filled.

// Each thread has a share of the spheres, and a part of each bin: no thread waits for another.
typedef struct {
    uint32_t *begin, *next; // of each tile: the first item, and after the last one
} BinsShare;

enum { MOST_SHARES = 256 };
typedef struct {
    const Scene *scene;
    vec3 from; // where the eye is
    // NULL, or numbers of the spheres that items have instead of those in the scene. Spheres whose
    // numbers are not less than end are in no bin.
    const int *numbers;
    int end;
    Eye eye;
    int columns, rows; // of tiles
    BinsShare shares[MOST_SHARES];
    int share_count;
    Places *places;
    Item *items;         // NULL while they are counted
    atomic_bool unusual; // the numbers of some sphere may be extreme (engine.h)
} Bins;

// Counts the items. -1 if there is not enough memory. bins_free in any case.
long long bins_count(Bins *bins, int threads);
// Then adds so many. False if there is not enough memory.
bool bins_fill(Bins *bins, long long count);
void bins_free(Bins *bins);

#endif
