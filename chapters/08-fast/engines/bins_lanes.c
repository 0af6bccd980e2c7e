// bins_lanes.c - the inner loops of step 6, 16 pixels or spheres at a time.
//
// Compiled for several instruction sets (lanes.h). The compiler may fuse multiplications with
// additions here, which rounds less. Float decides with a margin, and leaves the rest to double.
#include "chapters/08-fast/engines/bins_lanes.h"

#include <float.h>
#include <math.h>
#include <string.h>

// ---- places of spheres ------------------------------------------------------------------------

// A pixel from 0 to most. If x is NaN, because the camera's numbers are extreme, the first or last.
static inline int first_pixel(float x, float most)
{
    x = x > 0 ? x : 0;
    return (int)(x < most ? x : most);
}

static inline int end_pixel(float x, float most)
{
    x = x < most ? x : most;
    return (int)(x > 0 ? x : 0);
}

// A pixel is inside if its centre is. Rounding adds some of a pixel.
#define MARGIN (1.0F / 64)

// The tile of each place. It is a loop of its own, because gcc makes slower code of one loop for
// both.
static void find_tiles(const Eye *eye, int count, Places *restrict places)
{
    const int tiles = eye->tiles;
#pragma omp simd
    for (int i = 0; i < count; i++) {
        const int columns = places->right[i] - places->left[i];
        const int rows = places->bottom[i] - places->top[i];
        unsigned left = (unsigned)places->left[i], right = (unsigned)places->right[i] - 1;
        unsigned top = (unsigned)places->top[i], bottom = (unsigned)places->bottom[i] - 1;
        int tile = (int)(top / TILE_HEIGHT) * tiles + (int)(left / TILE_WIDTH);
        unsigned part = left % TILE_WIDTH * TILE_WIDTH + right % TILE_WIDTH;
        part = (part * TILE_HEIGHT + top % TILE_HEIGHT) * TILE_HEIGHT + bottom % TILE_HEIGHT;
        bool seen = (columns > 0) & (rows > 0);
        bool one =
            (left / TILE_WIDTH == right / TILE_WIDTH) & (top / TILE_HEIGHT == bottom / TILE_HEIGHT);
        int kind = one ? IN_ONE_TILE : IN_TILES;
        places->kind[i] = seen ? kind : UNSEEN;
        places->tile[i] = seen ? tile : 0;
        places->part[i] = (int)part;
    }
}

// The outline of each sphere becomes pixels, and its least distance from the eye a float. In float
// the centre has an error of some 2^-24 of its distance. That is more of a g that is a small part
// of it, so the outline is wider by 2^-18 of its numbers, times distance / (ahead - r). If ahead -
// r is almost nothing, the rectangle is the whole screen.
static bool place(const Eye *eye, const Positions *positions, int count, Places *restrict places)
{
    float rx[3], ux[3], fx[3];
    for (int axis = 0; axis < 3; axis++) {
        rx[axis] = (float)eye->right[axis];
        ux[axis] = (float)eye->up[axis];
        fx[axis] = (float)eye->forward[axis];
    }
    const float width = (float)eye->width, height = (float)eye->height;
    const float across = (float)eye->across, down = (float)eye->down;
    int unusual = 0;
#pragma omp simd reduction(| : unusual)
    for (int i = 0; i < count; i++) {
        float x = (float)positions->x[i], y = (float)positions->y[i], z = (float)positions->z[i];
        float r = (float)positions->radius[i], square = x * x + y * y + z * z;
        float distance = sqrtf(square);
        float aside = x * rx[0] + y * rx[1] + z * rx[2];
        float above = x * ux[0] + y * ux[1] + z * ux[2];
        float ahead = x * fx[0] + y * fx[1] + z * fx[2];
        float g = (ahead - r) * (ahead + r);
        bool measured = (square > 1e-30F) & (square < 1e30F) & (r < 1e15F);
        bool ordinary = measured & (ahead - r > 1e-4F * distance);
        // The outline by the formula of exercise 08, both axes at once.
        float safe = ordinary ? g : 1, over = 1 / safe;
        float wider = ordinary ? 0x1p-18F * distance * (ahead + r) * over : 0;
        float x_middle = ahead * aside * over, x_half = r * over * sqrtf(aside * aside + safe);
        float y_middle = ahead * above * over, y_half = r * over * sqrtf(above * above + safe);
        x_half += wider * (fabsf(x_middle) + x_half + 0.5F);
        y_half += wider * (fabsf(y_middle) + y_half + 0.5F);
        float x_low = width / 2 + across * (x_middle - x_half) + (0.5F - MARGIN);
        float x_high = width / 2 + across * (x_middle + x_half) + (0.5F + MARGIN);
        float y_low = height / 2 - down * (y_middle + y_half) + (0.5F - MARGIN);
        float y_high = height / 2 - down * (y_middle - y_half) + (0.5F + MARGIN);
        bool behind = ahead + r < -1e-5F * distance;
        places->left[i] = first_pixel(ordinary ? x_low : 0, width);
        places->right[i] = end_pixel(ordinary ? x_high : behind ? 0 : width, width);
        places->top[i] = first_pixel(ordinary ? y_low : 0, height);
        places->bottom[i] = end_pixel(ordinary ? y_high : height, height);
        float nearest = fabsf(distance - r) - 4e-6F * (distance + r);
        places->depth[i] = measured && nearest > 1e-15F ? depth_of(nearest) : 0;
        unusual |= !((r > 1e-15F) & (r < 1e15F) & (1e-20F * square < r * r));
    }
    find_tiles(eye, count, places);
    return unusual == 0;
}

// ---- the items of a bin -----------------------------------------------------------------------

enum { FEW = 32, MOST_GROUPS = 1024 };

// The place of each item is the number of smaller ones.
static void sort_few(const Item *items, size_t count, Item *to)
{
    for (size_t first = 0; first < count; first += LANES) {
        Item item[LANES];
        uint64_t smaller[LANES] = {0};
        for (size_t i = 0; i < LANES; i++)
            item[i] = items[first + i < count ? first + i : 0];
        for (size_t k = 0; k < count; k++) {
            const Item other = items[k];
#pragma omp simd
            for (int i = 0; i < LANES; i++)
                smaller[i] += other < item[i] ? 1 : 0;
        }
        for (size_t i = 0; i < LANES && first + i < count; i++)
            to[smaller[i]] = item[i];
    }
}

// A counting sort: count the items of each group, add up where each group begins, fill. A group has
// the same bits of (item - first).
static void sort_by(const Item *items, size_t count, Item *to, Item first, int shift, Item bits)
{
    uint32_t begins[MOST_GROUPS], sum = 0;
    memset(begins, 0, ((size_t)bits + 1) * sizeof *begins);
    for (size_t i = 0; i < count; i++)
        begins[(items[i] - first) >> shift & bits]++;
    for (size_t i = 0; i <= bits; i++) {
        uint32_t here = begins[i];
        begins[i] = sum;
        sum += here;
    }
    for (size_t i = 0; i < count; i++)
        to[begins[(items[i] - first) >> shift & bits]++] = items[i];
}

static const Item *sort(Item *items, size_t count)
{
    enum { DEPTH = ITEM_SPHERE + ITEM_PART, HALF = (64 - DEPTH) / 2 };
    Item *to = items + count;
    if (count < 2)
        return items;
    if (count <= FEW) {
        sort_few(items, count, to);
        return to;
    }
    Item nearest = items[0], farthest = items[0];
    for (size_t i = 1; i < count; i++) {
        nearest = items[i] < nearest ? items[i] : nearest;
        farthest = items[i] > farthest ? items[i] : farthest;
    }
    const Item first = nearest >> DEPTH << DEPTH, last = (farthest - first) >> DEPTH;
    if (last < MOST_GROUPS) {
        sort_by(items, count, to, first, DEPTH, last < 256 ? 255 : last < 512 ? 511 : 1023);
        return to;
    }
    // Many depths: first by the lower half of their bits, then by the upper half.
    sort_by(items, count, to, first, DEPTH, (1 << HALF) - 1);
    sort_by(to, count, items, first, DEPTH + HALF, (1 << HALF) - 1);
    return items;
}

// ---- the pixels of a tile ---------------------------------------------------------------------

static void clear(Tile *tile, int columns, int rows, int color)
{
    for (int i = 0; i < TILE_WIDTH * TILE_HEIGHT; i++) {
        tile->s[i] = i % TILE_WIDTH < columns && i / TILE_WIDTH < rows ? INFINITY : 0;
        tile->color[i] = color;
    }
}

// The columns of a part are asked 16 at a time. If the last 16 would reach beyond the tile, the
// first 16 begin earlier by as much.
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

// By Lagrange's identity D = b^2 - |v|^2 (|c|^2 - r^2) is r^2 |v|^2 - |c x v|^2: there no large
// numbers cancel. The ray x columns and y rows away is v + x g + y h. Counted from the middle of
// the sphere's part, no term is much larger than the largest D in it. So the error of D in float is
// about 2^-24 of the sum of the terms.
static void outline(const Rays *rays, const Candidates *from, Outlines *to)
{
    const double *f = rays->first, *g = rays->column, *h = rays->row;
#pragma omp simd
    for (int i = 0; i < OUTLINES; i++) {
        double column = from->column[i], row = from->row[i];
        double half_x = from->half_width[i], half_y = from->half_height[i];
        double cx = from->x[i], cy = from->y[i], cz = from->z[i];
        double r = from->radius[i], square = r * r;
        double vx = f[0] + column * g[0] + row * h[0];
        double vy = f[1] + column * g[1] + row * h[1];
        double vz = f[2] + column * g[2] + row * h[2];
        // c x v, c x g and c x h; then dot products of these, and of v and g, v and h.
        double wx = cy * vz - cz * vy, wy = cz * vx - cx * vz, wz = cx * vy - cy * vx;
        double gx = cy * g[2] - cz * g[1], gy = cz * g[0] - cx * g[2], gz = cx * g[1] - cy * g[0];
        double hx = cy * h[2] - cz * h[1], hy = cz * h[0] - cx * h[2], hz = cx * h[1] - cy * h[0];
        double vv = vx * vx + vy * vy + vz * vz, ww = wx * wx + wy * wy + wz * wz;
        double vg = vx * g[0] + vy * g[1] + vz * g[2], wg = wx * gx + wy * gy + wz * gz;
        double vh = vx * h[0] + vy * h[1] + vz * h[2], wh = wx * hx + wy * hy + wz * hz;
        double gg = gx * gx + gy * gy + gz * gz, hh = hx * hx + hy * hy + hz * hz;
        double gh = gx * hx + gy * hy + gz * hz;
        double d = square * vv - ww;
        double dx = 2 * (square * vg - wg), dy = 2 * (square * vh - wh);
        double dxx = square * rays->columns - gg, dyy = square * rays->rows - hh;
        double dxy = 2 * (square * rays->both - gh);
        double b = cx * vx + cy * vy + cz * vz;
        double bx = cx * g[0] + cy * g[1] + cz * g[2], by = cx * h[0] + cy * h[1] + cz * h[2];

        // The sum of D's terms, and how much b varies.
        double d_sum = fabs(d) + (fabs(dx) + fabs(dxx) * half_x) * half_x +
                       (fabs(dy) + fabs(dyy) * half_y) * half_y + fabs(dxy) * half_x * half_y;
        double b_range = fabs(bx) * half_x + fabs(by) * half_y, b_sum = fabs(b) + b_range;
        double apart = cx * cx + cy * cy + cz * cz;
        bool safe = (apart - square > 1e-3 * apart) & (b - b_range > 1e-6 * b_sum) &
                    (b_sum < 1e15) & (d_sum > 1e-30) & (d_sum < 1e30);
        // Each term is rounded at most six times in float, and double is not exact either.
        double d_error = 4 * FLT_EPSILON * d_sum + 1e-14 * (square * vv + sqrt(ww * vv * apart));
        // A square root near 0 magnifies its error, so such a small D is also in doubt.
        double doubt = 0x1p-16 * d_sum + 2 * d_error;
        to->x[i] = (float)column;
        to->y[i] = (float)row;
        to->d[i] = (float)d;
        to->dx[i] = (float)dx;
        to->dy[i] = (float)dy;
        to->dxx[i] = (float)dxx;
        to->dxy[i] = (float)dxy;
        to->dyy[i] = (float)dyy;
        to->b[i] = (float)b;
        to->bx[i] = (float)bx;
        to->by[i] = (float)by;
        to->doubt[i] = (float)doubt;
        to->b_error[i] = (float)(3 * FLT_EPSILON * b_sum);
        to->s_error[i] = (float)(5 * FLT_EPSILON * b_sum + d_error / sqrt(doubt));
        to->safe[i] = safe ? 1 : 0;
    }
}

// One sphere asks its pixels, 16 in a row at a time. sure is the difference of D and u^2: above the
// margin the sphere is certainly nearer (then D is positive), below -margin it is certainly not.
static void ask(Tile *restrict tile, const Outlines *restrict of, int n, Part part, float slack,
                int color)
{
    const float u_error = of->b_error[n] + slack;
    const float doubt = of->doubt[n] + u_error * u_error, slope = 2 * u_error;
    float d_row[TILE_HEIGHT], d_both[TILE_HEIGHT], b_row[TILE_HEIGHT];
#pragma omp simd
    for (int row = 0; row < TILE_HEIGHT; row++) {
        float y = (float)row - of->y[n];
        d_row[row] = of->d[n] + y * (of->dy[n] + y * of->dyy[n]);
        d_both[row] = y * of->dxy[n];
        b_row[row] = of->b[n] + y * of->by[n];
    }
    for (int first = first_lane(part); first < part.right; first += LANES) {
        float x[LANES], d[LANES], b[LANES];
#pragma omp simd
        for (int i = 0; i < LANES; i++) {
            int column = first + i;
            x[i] = (float)column - of->x[n];
            d[i] = x[i] * (of->dx[n] + x[i] * of->dxx[n]);
            d[i] = column >= part.left && column < part.right ? d[i] : -INFINITY;
            b[i] = x[i] * of->bx[n];
        }
        for (int row = part.top; row < part.bottom; row++) {
            float *restrict s = &tile->s[row * TILE_WIDTH + first];
            int *restrict seen = &tile->color[row * TILE_WIDTH + first];
#pragma omp simd
            for (int i = 0; i < LANES; i++) {
                float D = d[i] + d_row[row] + d_both[row] * x[i];
                float middle = b[i] + b_row[row];
                float u = middle - (s[i] < middle ? s[i] : middle);
                float sure = D - u * u, margin = doubt + slope * u;
                float near = middle - sqrtf(D);
                int kept = sure > margin ? color | (seen[i] & UNSURE) : seen[i];
                s[i] = sure > margin ? near : s[i];
                seen[i] = fabsf(sure) <= margin ? kept | UNSURE : kept;
            }
        }
    }
}

// Seen from inside, the far root counts, and from outside the near one. Neither is a difference of
// nearly equal numbers: the product of both roots is g v.v.
static float ask_in_double(Tile *tile, const Rays *rays, const double center[3], double radius,
                           Part part, float nearest, float slack, int color)
{
    double cx = center[0], cy = center[1], cz = center[2], rr = radius * radius;
    double cc = cx * cx + cy * cy + cz * cz, g = cc - rr, size = 1e-12 * (cc + rr);
    bool inside = g < 0;
    float most[LANES] = {0};
    for (int row = part.top; row < part.bottom; row++) {
        double x0 = rays->first[0] + row * rays->row[0], y0 = rays->first[1] + row * rays->row[1];
        double z0 = rays->first[2] + row * rays->row[2];
        for (int first = first_lane(part); first < part.right; first += LANES) {
            float *s = &tile->s[row * TILE_WIDTH + first];
            int *seen = &tile->color[row * TILE_WIDTH + first];
#pragma omp simd
            for (int i = 0; i < LANES; i++) {
                int column = first + i;
                double x = x0 + column * rays->column[0], y = y0 + column * rays->column[1];
                double z = z0 + column * rays->column[2], vv = x * x + y * y + z * z;
                double px = cy * z - cz * y, py = cz * x - cx * z, pz = cx * y - cy * x;
                double d = rr * vv - (px * px + py * py + pz * pz), b = cx * x + cy * y + cz * z;
                double q = fabs(b) + sqrt(d > 0 ? d : 0), other = vv * g / q;
                double at = !inside ? other : b > 0 ? q : -other;
                double margin = 2 * slack + 4 * FLT_EPSILON * at;
                bool asks =
                    (column >= part.left) & (column < part.right) & !(nearest > s[i] + slack);
                bool edge = fabs(d) <= size * vv, hit = (d > 0) & (inside | (b > 0));
                bool close = !((at > 1e-30) & (at < 1e30) & (fabs(at - s[i]) > margin));
                bool doubt = asks & (edge | (hit & close)),
                     wins = asks & hit & !doubt & (at < s[i]);
                seen[i] = wins ? color | (seen[i] & UNSURE) : doubt ? seen[i] | UNSURE : seen[i];
                s[i] = wins ? (float)at : s[i];
                most[i] = wins && (float)at > most[i] ? (float)at : most[i];
            }
        }
    }
    float largest = 0;
    for (int i = 0; i < LANES; i++)
        largest = most[i] > largest ? most[i] : largest;
    return largest;
}

static bool unsure(const Tile *tile)
{
    int all = 0;
#pragma omp simd reduction(| : all)
    for (int i = 0; i < TILE_WIDTH * TILE_HEIGHT; i++)
        all |= tile->color[i];
    return (all & UNSURE) != 0;
}

static inline void paint_row(const int *restrict color, int columns, uint8_t *restrict rgb)
{
    for (int i = 0; i < columns; i++) {
        rgb[3 * i] = (uint8_t)color[i];
        rgb[3 * i + 1] = (uint8_t)(color[i] >> 8);
        rgb[3 * i + 2] = (uint8_t)(color[i] >> 16);
    }
}

static void paint(const Tile *tile, int columns, int rows, uint8_t *rgb, size_t apart)
{
    for (int row = 0; row < rows; row++, rgb += apart) {
        // The compiler optimises better for a constant number of columns.
        if (columns == TILE_WIDTH)
            paint_row(&tile->color[row * TILE_WIDTH], TILE_WIDTH, rgb);
        else
            paint_row(&tile->color[row * TILE_WIDTH], columns, rgb);
    }
}

static inline uint32_t paint_flat_row(const int *restrict color, int columns,
                                      uint8_t *restrict numbers)
{
    uint32_t set = 0;
#pragma omp simd reduction(| : set)
    for (int i = 0; i < columns; i++) {
        numbers[i] = (uint8_t)color[i];
        set |= 1U << color[i];
    }
    return set;
}

static uint32_t paint_flat(const Tile *tile, int columns, int rows, uint8_t *numbers, size_t apart)
{
    uint32_t set = 0;
    for (int row = 0; row < rows; row++, numbers += apart) {
        const int *color = &tile->color[row * TILE_WIDTH];
        if (columns == TILE_WIDTH) // a constant, as in paint
            set |= paint_flat_row(color, TILE_WIDTH, numbers);
        else
            set |= paint_flat_row(color, columns, numbers);
    }
    return set;
}

const BinsLanes LANES(bins) = {place, sort,          clear,  farthest, outline,
                               ask,   ask_in_double, unsure, paint,    paint_flat};
