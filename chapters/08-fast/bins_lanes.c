// bins_lanes.c - the inner loops of step 6, 16 pixels or spheres at a time.
//
// Compiled for several instruction sets (lanes.h). Multiplications may be fused with additions
// here, which rounds less; what is float's to decide is decided with a margin, the rest is left to
// double.
#include "chapters/08-fast/bins_lanes.h"

#include <math.h>
#include <string.h>

// ---- where spheres are ------------------------------------------------------------------------

static inline double between(double low, double x, double high)
{
    return x > low ? x < high ? x : high : low;
}

// A pixel is in where its centre is; rounding is far below so much of a pixel.
#define MARGIN (1.0 / 64)

static inline float coarse(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits &= ~((1U << PLACE_DROPPED) - 1);
    memcpy(&x, &bits, sizeof x);
    return x;
}

static void place(const Eye *eye, const Positions *positions, int first, int count,
                  Place *places)
{
    double left[PLACES], right[PLACES], top[PLACES], bottom[PLACES], near[PLACES];
    const double *rx = eye->right, *ux = eye->up, *fx = eye->forward;
    double width = eye->width, height = eye->height, across = eye->across, down = eye->down;
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double x = positions->x[i], y = positions->y[i], z = positions->z[i];
        double exact = positions->radius[i], r = exact * (1 + 1e-9);
        double aside = x * rx[0] + y * rx[1] + z * rx[2];
        double above = x * ux[0] + y * ux[1] + z * ux[2];
        double ahead = x * fx[0] + y * fx[1] + z * fx[2];
        double g = (ahead - r) * (ahead + r);
        // view.c: outline(), both axes at once.
        double safe = ahead > r && g > 0 ? g : 1;
        double x_middle = ahead * aside / safe, y_middle = ahead * above / safe;
        double x_half = r * sqrt(aside * aside + safe) / safe;
        double y_half = r * sqrt(above * above + safe) / safe;
        double all = ahead > r && g > 0 ? 0 : 1e30;
        double none = ahead + r > 0 ? 0 : 1e30;
        double x_low = width / 2 + across * (x_middle - x_half) - all + none;
        double x_high = width / 2 + across * (x_middle + x_half) + all;
        double y_low = height / 2 - down * (y_middle + y_half) - all + none;
        double y_high = height / 2 - down * (y_middle - y_half) + all;
        left[i] = between(0, x_low + 0.5 - MARGIN, width);
        right[i] = between(0, x_high + 0.5 + MARGIN, width);
        top[i] = between(0, y_low + 0.5 - MARGIN, height);
        bottom[i] = between(0, y_high + 0.5 + MARGIN, height);
        double distance = sqrt(x * x + y * y + z * z);
        double nearest = fabs(distance - exact) - 1e-6 * distance;
        near[i] = nearest > 1e-37 ? nearest < 1e37 ? nearest : 1e37 : 0;
    }
    for (int i = 0; i < count; i++)
        places[i] = (Place){(uint16_t)left[i], (uint16_t)right[i], (uint16_t)top[i],
                            (uint16_t)bottom[i], coarse((float)near[i]), first + i};
}

// ---- the pixels of a tile ---------------------------------------------------------------------

static void clear(Tile *tile, int columns, int rows, int color)
{
    for (int i = 0; i < TILE_WIDTH * TILE_HEIGHT; i++) {
        tile->s[i] = i % TILE_WIDTH < columns && i / TILE_WIDTH < rows ? INFINITY : 0;
        tile->color[i] = color;
    }
}

// The columns of a part are asked 16 at a time: the first ones, which leave no room beyond the
// tile.
static inline int first_lane(Part part)
{
    int lanes = (part.right - part.left + LANES - 1) / LANES * LANES;
    return part.left < TILE_WIDTH - lanes ? part.left : TILE_WIDTH - lanes;
}

static float farthest(const Tile *tile, Part part)
{
    float most[LANES] = {0};
    for (int first = first_lane(part); first < part.right; first += LANES) {
        float in[LANES];
#pragma omp simd
        for (int i = 0; i < LANES; i++)
            in[i] = first + i >= part.left && first + i < part.right ? INFINITY : 0;
        for (int row = part.top; row < part.bottom; row++) {
            const float *s = &tile->s[row * TILE_WIDTH + first];
#pragma omp simd
            for (int i = 0; i < LANES; i++) {
                float seen = s[i] < in[i] ? s[i] : in[i];
                most[i] = most[i] > seen ? most[i] : seen;
            }
        }
    }
    float result = 0;
#pragma omp simd reduction(max : result)
    for (int i = 0; i < LANES; i++)
        result = most[i] > result ? most[i] : result;
    return result;
}

static void ask(Tile *restrict tile, const Outline *restrict sphere)
{
    const Part part = sphere->part;
    const float doubt = sphere->doubt, slope = sphere->slope;
    const int color = sphere->color;
    for (int first = first_lane(part); first < part.right; first += LANES) {
        float x[LANES], d[LANES], b[LANES];
#pragma omp simd
        for (int i = 0; i < LANES; i++) {
            int column = first + i;
            x[i] = (float)column - sphere->column;
            d[i] = x[i] * (sphere->dx + x[i] * sphere->dxx);
            d[i] = column >= part.left && column < part.right ? d[i] : -INFINITY;
            b[i] = x[i] * sphere->bx;
        }
        for (int row = part.top; row < part.bottom; row++) {
            float y = (float)row - sphere->row;
            float d_row = sphere->d + y * (sphere->dy + y * sphere->dyy);
            float d_both = y * sphere->dxy, b_row = sphere->b + y * sphere->by;
            float *restrict s = &tile->s[row * TILE_WIDTH + first];
            int *restrict seen = &tile->color[row * TILE_WIDTH + first];
#pragma omp simd
            for (int i = 0; i < LANES; i++) {
                float D = d[i] + d_row + d_both * x[i];
                float middle = b[i] + b_row;
                float u = middle - s[i];
                u = u > 0 ? u : 0;
                float sure = D - u * u, margin = doubt + slope * u;
                float root = sqrtf(D > 0 ? D : 0);
                int kept = sure > margin ? color | (seen[i] & UNSURE) : seen[i];
                int unsure = fabsf(sure) <= margin ? UNSURE : 0;
                s[i] = sure > margin ? middle - root : s[i];
                seen[i] = kept | unsure;
            }
        }
    }
}

static bool unsure(const Tile *tile)
{
    int all = 0;
#pragma omp simd reduction(| : all)
    for (int i = 0; i < TILE_WIDTH * TILE_HEIGHT; i++)
        all |= tile->color[i];
    return (all & UNSURE) != 0;
}

static void paint(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart)
{
    for (int row = 0; row < rows; row++) {
        const int *restrict color = &tile->color[row * TILE_WIDTH];
        uint8_t *restrict to = rgb + (size_t)row * apart;
        for (int i = 0; i < columns; i++) {
            to[3 * i] = (uint8_t)color[i];
            to[3 * i + 1] = (uint8_t)(color[i] >> 8);
            to[3 * i + 2] = (uint8_t)(color[i] >> 16);
        }
    }
}

const BinsLanes LANES(bins) = {place, clear, farthest, ask, unsure, paint};
