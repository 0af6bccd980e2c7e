// float_bounds.h - the scene as floats, seen from the eye, and the limits of their errors.
//
// A float has 7 digits. That is enough for nearly every pixel, and the program can tell if it is
// not. A ray goes from the eye along v = (x, y, 1), by the camera's axes. It passes the centre c of
// a sphere at a distance of |c x v| / |v|. So it meets the sphere, of radius r, if D = r^2 |v|^2 -
// |c x v|^2 >= 0, at t = (c.v - sqrt(D)) / v.v. The numbers in D have the size of the sphere, not
// of its distance. (D is a quarter of chapter 05's discriminant, by Lagrange's identity |c x v|^2 =
// |c|^2 |v|^2 - (c.v)^2.)
//
// Let u = 2^-24 (C writes 0x1p-24) be the error of rounding a number to a float, and e = 16u (|c| +
// r). Rounding c and v, and computing, changes c x v by less than 6u |c||v|, D by less than e (r +
// e) |v|^2, and c.v by less than e |v|. So two spheres take the place of each. If a ray misses the
// larger one, of squared radius r^2 + e (r + e), it misses the sphere. If it meets the smaller one,
// it meets the sphere. The other rays are in doubt.
#ifndef CHAPTERS_08_FAST_ENGINES_FLOAT_BOUNDS_H
#define CHAPTERS_08_FAST_ENGINES_FLOAT_BOUNDS_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/lanes.h"
#include "chapters/08-fast/engines/wide_hierarchy.h"

// Blocks have 4 x 4 pixels, 16 rays. Tiles have 4 x 4 blocks.
enum { BLOCK = 4, TILE = 16, TILE_BLOCKS = TILE / BLOCK };

typedef struct {
    float x, y, z;         // the centre by the camera's axes, from the eye
    float larger, smaller; // squared radii of the two spheres around it and inside it
    float doubt;           // e
    // The blocks where it may be visible, by its outline: columns left to right - 1, rows top to
    // bottom - 1. None for a sphere around the eye: those are kept separately.
    unsigned short left, right, top, bottom;
} Seen;

// A node of the hierarchy, from the eye, along the axes of the world. Its box is larger by 2^-19 of
// its largest distance: up to there, rounding does not move a ray by more.
typedef struct {
    float low[3], high[3];
    int other;         // child; the first sphere of a leaf
    short count, axis; // number of spheres of a leaf; 0 for other nodes
} SeenNode;

// Bits for the result: there is a sphere around the eye; there is one that floats cannot decide,
// because it touches the eye or its size is extreme.
enum { SEEN_AROUND = 1, SEEN_BADLY = 2 };

// Spheres to convert, 64 at a time, in the order of the hierarchy.
enum { SEEN_AT_ONCE = 64 };
typedef struct {
    double x[SEEN_AT_ONCE], y[SEEN_AT_ONCE], z[SEEN_AT_ONCE], radius[SEEN_AT_ONCE];
} Unseen;

// The scene and the camera for files of lanes, so without a vec3 (lanes.h).
typedef struct {
    const SeenNode *nodes; // NULL if there are no spheres, or if these are not needed
    const WideNode *wide;  // the same
    const Seen *seen;      // in the order of the hierarchy
    const int *colors;     // of these
    int background;
    const int *around; // those around the eye
    int around_count;
    double eye[3], right[3], up[3], ahead[3]; // a ray goes along ahead + x * right + y * up
    double scale_x, scale_y;                  // pixels in a unit of x and of y
    double middle_x, middle_y;                // the place of x = 0, y = 0, in pixels
    int columns, rows;                        // of blocks
    const float *x, *y;                       // of each column of pixels, of each row
} View;

// The colours of a tile's pixels, row by row. A colour is the three bytes of an image and a zero,
// so IN_DOUBT is not a colour.
enum { IN_DOUBT = -1 };
typedef struct {
    int column, row; // its first block
    int doubts;      // not 0 if some pixel is in doubt
    int colors[TILE * TILE];
} Tile;

// For each instruction set: SEEN_AT_ONCE spheres become floats; ...
typedef int See(const View *view, const Unseen *unseen, Seen *seen); // SEEN_AROUND | SEEN_BADLY
extern See see_baseline, see_avx2, see_avx512;
// ... the pixels of a tile get their colours, by packets of rays, or by the tile's frustum; ...
typedef void Walk(const View *view, Tile *tile);
extern Walk walk_packets_baseline, walk_packets_avx2, walk_packets_avx512;
extern Walk walk_frustum_baseline, walk_frustum_avx2, walk_frustum_avx512;
// ... and the colours become bytes of the image.
typedef void PaintTile(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart);
extern PaintTile paint_tile_baseline, paint_tile_avx2, paint_tile_avx512;

#endif
