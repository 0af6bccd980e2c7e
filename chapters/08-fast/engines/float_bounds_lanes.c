// float_bounds_lanes.c - the begin and the end of a picture in floats: converts spheres to floats,
// and finds the blocks of pixels where they may be visible; and writes the colours of a tile.
#include "chapters/08-fast/engines/float_bounds.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

// Clamped between 0 and most; NaN counts as 0.
static inline double clamped(double x, double most)
{
    x = x > 0 ? x : 0;
    return x < most ? x : most;
}

// From the begin and end of a sphere's outline along an axis of the screen, in pixels, to the
// pixels whose centres are between them, to blocks. A sixteenth of a pixel more, for rounding.
static inline void blocks(double begin, double end, int count, int *first, int *last)
{
    double pixels = (double)count * BLOCK;
    int first_pixel = (int)clamped(begin + 0.5 - 0.0625, pixels);
    int last_pixel = (int)clamped(end + 0.5 + 0.0625, pixels);
    *first = first_pixel / BLOCK;
    *last = first_pixel < last_pixel ? (last_pixel + BLOCK - 1) / BLOCK : 0;
}

int LANES(see)(const View *view, const Unseen *unseen, Seen *seen)
{
    float xs[SEEN_AT_ONCE], ys[SEEN_AT_ONCE], zs[SEEN_AT_ONCE];
    float larger[SEEN_AT_ONCE], smaller[SEEN_AT_ONCE], doubts[SEEN_AT_ONCE];
    int left[SEEN_AT_ONCE], right[SEEN_AT_ONCE], top[SEEN_AT_ONCE], bottom[SEEN_AT_ONCE];
    const View v = *view;
    int found = 0;
#pragma omp simd reduction(| : found)
    for (int i = 0; i < SEEN_AT_ONCE; i++) {
        double wx = unseen->x[i] - v.eye[0], wy = unseen->y[i] - v.eye[1];
        double wz = unseen->z[i] - v.eye[2], r = unseen->radius[i];
        double x = wx * v.right[0] + wy * v.right[1] + wz * v.right[2];
        double y = wx * v.up[0] + wy * v.up[1] + wz * v.up[2];
        double z = wx * v.ahead[0] + wy * v.ahead[1] + wz * v.ahead[2];
        double distance = sqrt(x * x + y * y + z * z);
        int fits = (r > 1e-12) & (r < 1e12) & (distance < 1e12), around = distance < 0.999 * r;
        found |= fits & (around | (distance > 1.001 * r)) ? 0 : SEEN_BADLY;
        found |= around ? SEEN_AROUND : 0;
        double doubt = 0x1p-20 * (distance + r);
        xs[i] = (float)x;
        ys[i] = (float)y;
        zs[i] = (float)z;
        doubts[i] = (float)doubt;
        larger[i] = (float)(r * r + doubt * (r + doubt));
        smaller[i] = (float)(r * r - doubt * (r + doubt));

        // The outline by the formula of exercise 08; the whole screen if the sphere is too near
        // beside the eye.
        r *= 1 + 1e-9;
        double g = (z - r) * (z + r), gx = x * x + g, gy = y * y + g;
        int near = z <= 1.01 * r, none = (z + r <= 0) | (distance <= r);
        double half_x = r * sqrt(gx > 0 ? gx : 0), half_y = r * sqrt(gy > 0 ? gy : 0);
        double scale_x = v.scale_x / (near ? 1 : g), scale_y = v.scale_y / (near ? 1 : g);
        double a = v.middle_x + scale_x * (z * x - half_x);
        double b = v.middle_x + scale_x * (z * x + half_x);
        double c = v.middle_y - scale_y * (z * y + half_y);
        double d = v.middle_y - scale_y * (z * y - half_y);
        int l, r1, t, b1;
        blocks(near ? 0 : a, near ? 1e6 : b, v.columns, &l, &r1);
        blocks(near ? 0 : c, near ? 1e6 : d, v.rows, &t, &b1);
        left[i] = l;
        right[i] = none ? 0 : r1;
        top[i] = t;
        bottom[i] = b1;
    }
    for (int i = 0; i < SEEN_AT_ONCE; i++)
        seen[i] = (Seen){xs[i],
                         ys[i],
                         zs[i],
                         larger[i],
                         smaller[i],
                         doubts[i],
                         (unsigned short)left[i],
                         (unsigned short)right[i],
                         (unsigned short)top[i],
                         (unsigned short)bottom[i]};
    return found;
}

// Copying four bytes at a time is faster than three, except at the end of a row, because the next
// pixel may belong to another thread.
static inline void paint_row(const int *colors, int columns, uint8_t *rgb)
{
    for (int i = 0; i < columns - 1; i++)
        memcpy(rgb + (ptrdiff_t)3 * i, &colors[i], 4);
    memcpy(rgb + (ptrdiff_t)3 * (columns - 1), &colors[columns - 1], 3);
}

void LANES(paint_tile)(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart)
{
    for (int row = 0; row < rows; row++, rgb += apart) {
        if (columns == TILE) // a constant number, for which the compiler optimises better
            paint_row(tile->colors + row * TILE, TILE, rgb);
        else
            paint_row(tile->colors + row * TILE, columns, rgb);
    }
}
