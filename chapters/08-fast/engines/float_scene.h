// float_scene.h - the scene as floats, seen from the eye, and the limits of their errors.
//
// A float has 7 digits. That is enough for nearly every pixel, and the program can tell if it is
// not. A ray goes from the eye along v = (x, y, 1), by the camera's axes. It passes the center c of
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
#ifndef CHAPTERS_08_FAST_FLOAT_SCENE_H
#define CHAPTERS_08_FAST_FLOAT_SCENE_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/lanes.h"

// Blocks have 4 x 4 pixels, 16 rays. Tiles have 4 x 4 blocks.
enum { BLOCK = 4, TILE = 16, TILE_BLOCKS = TILE / BLOCK };

typedef struct {
    float x, y, z; // the center by the camera's axes, from the eye
    // Squared radii: the ray meets the first sphere before the real one, and the second one after
    // it. From outside the first is the larger one. If the eye is inside, the ray meets them on its
    // way out: then side is -1, and the first is the smaller one.
    float first, second, side;
    float doubt; // e
    int color;
    // The blocks where it may be visible: columns left to right - 1, rows top to bottom - 1.
    unsigned short left, right, top, bottom;
} Seen;

// A box of the hierarchy from the eye, along the axes of the world. It is larger by 2^-19 of its
// largest distance: up to there, rounding does not move a ray by more.
typedef struct {
    float low[3], high[3];
} SeenBox;

// The scene and the camera for files of lanes, so without a vec3 (lanes.h).
typedef struct {
    const Node *nodes;         // NULL if there are no spheres
    const SeenBox *boxes;      // of the nodes; NULL if they are not needed
    const WideHierarchy *wide; // NULL if it is not needed
    const Seen *seen;          // in the order of the hierarchy
    int background;
    double eye[3], right[3], up[3], ahead[3]; // a ray goes along ahead + x * right + y * up
    int columns, rows;                        // of blocks
    const float *x, *y;                       // of each column of pixels, of each row
} View;

// The colors of a tile's pixels, row by row; IN_DOUBT is not a color.
enum { IN_DOUBT = -1 };
typedef struct {
    int column, row; // its first block
    int doubts;      // not 0 if some pixel is in doubt
    int colors[TILE * TILE];
} Tile;

// For each instruction set: the pixels of a tile get their colors, by packets of rays, or by the
// tile's frustum.
typedef void Walk(const View *view, Tile *tile);
extern Walk walk_packets_baseline, walk_packets_avx2, walk_packets_avx512;
extern Walk walk_frustum_baseline, walk_frustum_avx2, walk_frustum_avx512;

#endif
