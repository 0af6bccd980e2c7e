// bins_lanes.c - the inner loops of step 6, 16 pixels or spheres at a time.
//
// Compiled for several instruction sets (lanes.h). The compiler may fuse multiplications with
// additions here, which rounds less. Float decides with a margin, and leaves the rest to double.
#include "chapters/08-fast/engines/bins.h"

#include <float.h>

// ---- places of spheres ------------------------------------------------------------------------

// A pixel from 0 to most. If x is NaN, because the camera's numbers are extreme, the first or last.
static inline uint16_t first_pixel(float x, float most)
{
    x = x > 0 ? x : 0;
    return (uint16_t)(int)(x < most ? x : most);
}

static inline uint16_t end_pixel(float x, float most)
{
    x = x < most ? x : most;
    return (uint16_t)(int)(x > 0 ? x : 0);
}

// The outline of each sphere becomes pixels, and its least distance from the eye a float. In float
// the center has an error of some 2^-24 of its distance. That is more of a g that is a small part
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
    const float across = (float)eye->across, down = (float)eye->down, margin = (float)eye->margin;
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
        float x_low = width / 2 + across * (x_middle - x_half) + (0.5F - margin);
        float x_high = width / 2 + across * (x_middle + x_half) + (0.5F + margin);
        float y_low = height / 2 - down * (y_middle + y_half) + (0.5F - margin);
        float y_high = height / 2 - down * (y_middle - y_half) + (0.5F + margin);
        bool behind = ahead + r < -1e-5F * distance;
        places->left[i] = first_pixel(ordinary ? x_low : 0, width);
        places->right[i] = end_pixel(ordinary ? x_high : behind ? 0 : width, width);
        places->top[i] = first_pixel(ordinary ? y_low : 0, height);
        places->bottom[i] = end_pixel(ordinary ? y_high : height, height);
        float nearest = fabsf(distance - r) - 4e-6F * (distance + r);
        places->depth[i] = (uint16_t)(measured && nearest > 1e-15F ? depth_of(nearest) : 0);
        unusual |= !((r > 1e-15F) & (r < 1e15F) & (1e-20F * square < r * r));
    }
    return unusual == 0;
}

// ---- the items of a bin -----------------------------------------------------------------------

enum { FEW = 32 };

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

// A counting sort by 8 bits: count the items of each group, add up where each group begins, fill.
static void sort_by(const Item *items, size_t count, Item *to, int shift)
{
    enum { GROUPS = 256 };
    uint32_t begins[GROUPS] = {0}, sum = 0;
    for (size_t i = 0; i < count; i++)
        begins[items[i] >> shift & (GROUPS - 1)]++;
    for (int i = 0; i < GROUPS; i++) {
        uint32_t here = begins[i];
        begins[i] = sum;
        sum += here;
    }
    for (size_t i = 0; i < count; i++)
        to[begins[items[i] >> shift & (GROUPS - 1)]++] = items[i];
}

// By the lower half of the depth's bits, then by the upper half.
static const Item *sort(Item *items, size_t count)
{
    Item *to = items + count;
    if (count < 2)
        return items;
    if (count <= FEW) {
        sort_few(items, count, to);
        return to;
    }
    sort_by(items, count, to, ITEM_SPHERE + ITEM_PART);
    sort_by(to, count, items, ITEM_SPHERE + ITEM_PART + 8);
    return items;
}

// ---- the pixels of a tile ---------------------------------------------------------------------

static void clear(TilePixels *tile, int columns, int rows, int color)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        tile->s[i] = i % SIDE < columns && i / SIDE < rows ? INFINITY : 0;
        tile->color[i] = color;
    }
}

// The columns of a part are asked 16 at a time. If the last 16 would reach beyond the tile, the
// first 16 begin earlier by as much.
static inline int first_lane(Part part)
{
    int lanes = (part.right - part.left + LANES - 1) / LANES * LANES;
    return part.left < SIDE - lanes ? part.left : SIDE - lanes;
}

static float farthest(const TilePixels *tile, Part part)
{
    float most[LANES] = {0};
    for (int first = first_lane(part); first < part.right; first += LANES) {
        float in[LANES];
#pragma omp simd
        for (int i = 0; i < LANES; i++)
            in[i] = first + i >= part.left && first + i < part.right ? INFINITY : 0;
        for (int row = part.top; row < part.bottom; row++) {
            const float *s = &tile->s[row * SIDE + first];
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
static void outline(const TileRays *rays, const Candidates *from, Outlines *to)
{
    const Vector g = {rays->column[0], rays->column[1], rays->column[2]};
    const Vector h = {rays->row[0], rays->row[1], rays->row[2]};
    const Vector first = {rays->first[0], rays->first[1], rays->first[2]};
#pragma omp simd
    for (int i = 0; i < OUTLINES; i++) {
        double column = from->column[i], row = from->row[i];
        double half_x = from->half_width[i], half_y = from->half_height[i];
        double r = from->radius[i], square = r * r;
        Vector c = {from->x[i], from->y[i], from->z[i]};
        Vector v = plus(first, plus(times(column, g), times(row, h)));
        Vector c_v = cross(c, v), c_g = cross(c, g), c_h = cross(c, h);
        double vv = dot(v, v), aside = dot(c_v, c_v);
        double d = square * vv - aside;
        double dx = 2 * (square * dot(v, g) - dot(c_v, c_g));
        double dy = 2 * (square * dot(v, h) - dot(c_v, c_h));
        double dxx = square * dot(g, g) - dot(c_g, c_g);
        double dyy = square * dot(h, h) - dot(c_h, c_h);
        double dxy = 2 * (square * dot(g, h) - dot(c_g, c_h));
        double b = dot(c, v), bx = dot(c, g), by = dot(c, h);

        // The sum of D's terms, and how much b varies.
        double d_sum = fabs(d) + (fabs(dx) + fabs(dxx) * half_x) * half_x +
                       (fabs(dy) + fabs(dyy) * half_y) * half_y + fabs(dxy) * half_x * half_y;
        double b_range = fabs(bx) * half_x + fabs(by) * half_y, b_sum = fabs(b) + b_range;
        double apart = dot(c, c);
        bool safe = (apart - square > 1e-3 * apart) & (b - b_range > 1e-6 * b_sum) &
                    (b_sum < 1e15) & (d_sum > 1e-30) & (d_sum < 1e30);
        // Each term is rounded at most six times in float, and double is not exact either.
        double d_error = 4 * FLT_EPSILON * d_sum + 1e-14 * (square * vv + sqrt(aside * vv * apart));
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
static void ask(TilePixels *restrict tile, const Outlines *restrict of, int n, Part part,
                float slack, int color)
{
    const float u_error = of->b_error[n] + slack;
    const float doubt = of->doubt[n] + u_error * u_error, slope = 2 * u_error;
    float d_row[SIDE], d_both[SIDE], b_row[SIDE];
#pragma omp simd
    for (int row = 0; row < SIDE; row++) {
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
            float *restrict s = &tile->s[row * SIDE + first];
            int *restrict seen = &tile->color[row * SIDE + first];
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
// nearly equal numbers: the product of both roots is out v.v.
// If the eye is almost on the sphere, out loses its digits even in double.
static float ask_in_double(TilePixels *tile, const TileRays *rays, const Candidates *from, int n,
                           Part part, float nearest, float slack, int color)
{
    const Vector c = {from->x[n], from->y[n], from->z[n]};
    const Vector g = {rays->column[0], rays->column[1], rays->column[2]};
    const double rr = from->radius[n] * from->radius[n], cc = dot(c, c), out = cc - rr;
    const double size = 1e-12 * (cc + rr);
    bool inside = out < 0, lost = !(fabs(out) > 1e-8 * (cc + rr));
    float most[LANES] = {0};
    for (int row = part.top; row < part.bottom; row++) {
        const Vector begin = plus(vector_at(rays->first), times(row, vector_at(rays->row)));
        for (int first = first_lane(part); first < part.right; first += LANES) {
            float *s = &tile->s[row * SIDE + first];
            int *seen = &tile->color[row * SIDE + first];
#pragma omp simd
            for (int i = 0; i < LANES; i++) {
                int column = first + i;
                Vector v = plus(begin, times(column, g)), p = cross(c, v);
                double vv = dot(v, v), d = rr * vv - dot(p, p), b = dot(c, v);
                double q = fabs(b) + sqrt(d > 0 ? d : 0), other = vv * out / q;
                double at = !inside ? other : b > 0 ? q : -other;
                double margin = 2 * slack + 4 * FLT_EPSILON * at;
                bool asks =
                    (column >= part.left) & (column < part.right) & !(nearest > s[i] + slack);
                bool edge = lost | (fabs(d) <= size * vv), hit = (d > 0) & (inside | (b > 0));
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

static bool unsure(const TilePixels *tile)
{
    int all = 0;
#pragma omp simd reduction(| : all)
    for (int i = 0; i < SIDE * SIDE; i++)
        all |= tile->color[i];
    return (all & UNSURE) != 0;
}

// The compiler optimises better for a constant number of columns.
static inline void paint_row(const int *restrict color, int columns, uint8_t *restrict rgb)
{
    for (int i = 0; i < columns; i++) {
        rgb[3 * i] = (uint8_t)color[i];
        rgb[3 * i + 1] = (uint8_t)(color[i] >> 8);
        rgb[3 * i + 2] = (uint8_t)(color[i] >> 16);
    }
}

static void paint(const int *colors, int side, int columns, int rows, uint8_t *rgb, size_t apart)
{
    for (int row = 0; row < rows; row++, rgb += apart, colors += side) {
        if (columns == SIDE)
            paint_row(colors, SIDE, rgb);
        else
            paint_row(colors, columns, rgb);
    }
}

const BinsLanes LANES(bins) = {place, sort,          clear,  farthest, outline,
                               ask,   ask_in_double, unsure, paint};
