// seen.h - the scene as floats, as the eye sees it, and what floats can be trusted with.
//
// A float has 7 digits: enough for nearly every pixel, and where it is not, that can be known. A
// ray goes from the eye along v = (x, y, 1), by the camera's axes; a sphere round c of radius r is
// |c x v| / |v| beside it. So the ray meets it where D = r^2 |v|^2 - |c x v|^2 >= 0, at
// t = (c.v - sqrt(D)) / v.v. What is subtracted in D has the size of the sphere, not of how far
// away it is. (D is a quarter of chapter 05's discriminant, by Lagrange's identity
// |c x v|^2 = |c|^2 |v|^2 - (c.v)^2.)
//
// With u = 2^-24 (C writes 0x1p-24), what rounds a number to a float: rounding c and v and
// computing puts c x v off by less than 6u |c||v|, D by less than e (r + e) |v|^2, and c.v by less
// than e |v|, where e = 16u (|c| + r). So two spheres stand for each. A ray that misses the larger,
// of squared radius r^2 + e (r + e), misses it; a ray that meets the smaller meets it; the others
// are in doubt.
#ifndef CHAPTERS_08_FAST_SEEN_H
#define CHAPTERS_08_FAST_SEEN_H

#include "chapters/08-fast/hierarchy.h"
#include "chapters/08-fast/lanes.h"
#include "chapters/08-fast/wide.h"

// Pixels go in blocks of 4 x 4, 16 rays, and these in tiles of 4 x 4.
enum { BLOCK = 4, TILE = 16, TILE_BLOCKS = TILE / BLOCK };

typedef struct {
    float x, y, z;         // the centre by the camera's axes, from the eye
    float larger, smaller; // squared radii: of what it lies in, of what lies in it
    float doubt;           // e
    // The blocks where it may be seen, by its outline: columns left to right - 1, rows top to
    // bottom - 1. None for a sphere round the eye: those are kept apart.
    unsigned short left, right, top, bottom;
} Seen;

// A node of the hierarchy, from the eye, along the axes of the world. Its box is larger by 2^-19 of
// how far away it reaches: rounding moves no ray by more, as far as that.
typedef struct {
    float low[3], high[3];
    int other;         // child; the first sphere of a leaf
    short count, axis; // how many spheres, of a leaf; else 0
} SeenNode;

// What was found: a sphere round the eye; one that floats cannot judge, because it touches the eye
// or is of no ordinary size.
enum { SEEN_AROUND = 1, SEEN_BADLY = 2 };

// Spheres to be seen, 64 at a time, in the order of the hierarchy.
enum { SEEN_AT_ONCE = 64 };
typedef struct {
    double x[SEEN_AT_ONCE], y[SEEN_AT_ONCE], z[SEEN_AT_ONCE], radius[SEEN_AT_ONCE];
} Unseen;

// What a file of lanes is told: nothing in it is a vec3.
typedef struct {
    const SeenNode *nodes; // NULL where there is no sphere, or these are not wanted
    const WideNode *wide;  // the same
    const Seen *seen;      // in the order of the hierarchy
    const int *colors;     // of these
    int background;
    const int *around; // those round the eye
    int around_count;
    double eye[3], right[3], up[3], ahead[3]; // a ray goes along ahead + x * right + y * up
    double scale_x, scale_y;                  // pixels in a unit of x and of y
    double middle_x, middle_y;                // where x and y are 0, in pixels
    int columns, rows;                        // of blocks
    const float *x, *y;                       // of each column of pixels, of each row
} View;

// The colours of a tile's pixels, row by row. A colour is the three bytes of an image and a zero,
// so IN_DOUBT is none.
enum { IN_DOUBT = -1 };
typedef struct {
    int column, row; // its first block
    int doubts;      // not 0 where some pixel is in doubt
    int colors[TILE * TILE];
} Tile;

// For each instruction set: SEEN_AT_ONCE spheres become floats; ...
typedef int See(const View *view, const Unseen *unseen, Seen *seen); // SEEN_AROUND | SEEN_BADLY
extern See see_baseline, see_avx2, see_avx512;
// ... and what the pixels of a tile see, by packets of rays, or by the tile's frustum.
typedef void Walk(const View *view, Tile *tile);
extern Walk walk_packets_baseline, walk_packets_avx2, walk_packets_avx512;
extern Walk walk_frustum_baseline, walk_frustum_avx2, walk_frustum_avx512;
// ... and the bytes of its pixels, in rows that are so far apart.
typedef void PaintTile(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart);
extern PaintTile paint_tile_baseline, paint_tile_avx2, paint_tile_avx512;

#endif
