// any_ray_lanes.c - one ray through the wide hierarchy: near boxes first for the nearest hit, any
// order for any hit.
#include "chapters/08-fast/engines/any_ray.h"

#include "chapters/08-fast/engines/meeting.h"

#include <math.h>
#ifdef __AVX2__
#include <immintrin.h>
#endif

// One bit for each of 16 ints that is negative. Compilers do not find this instruction.
static inline unsigned bits_of(const int *ints)
{
#if defined __AVX512DQ__
    return _mm512_movepi32_mask(_mm512_loadu_si512(ints));
#elif defined __AVX2__
    unsigned low = (unsigned)_mm256_movemask_ps(_mm256_loadu_ps((const float *)ints));
    return low | (unsigned)_mm256_movemask_ps(_mm256_loadu_ps((const float *)(ints + 8))) << 8;
#else
    unsigned bits = 0;
    for (int i = 0; i < LANES; i++)
        bits |= (unsigned)(ints[i] < 0) << i;
    return bits;
#endif
}

// ---- boxes, in floats -------------------------------------------------------------------------

// A ray along the axes of the world: 1 / direction, and its absolute value.
typedef struct {
    const Line *line;
    double scale;
    float inverse[3], across[3];
} Slopes;

// Never for 0: infinity times 0 would be NaN.
static Slopes slopes_of(const RayWorld *world, const Line *line)
{
    Slopes slopes = {.line = line, .scale = world->scale};
    for (int axis = 0; axis < 3; axis++) {
        float d = (float)line->direction[axis];
        float away = fabsf(d) > 1e-18F ? d : copysignf(1e-18F, d);
        slopes.inverse[axis] = 1 / away;
        slopes.across[axis] = fabsf(slopes.inverse[axis]);
    }
    return slopes;
}

// Which boxes of a node the ray enters before farthest, as bits, and where: the slabs of
// slab_test.h, for 16 boxes. For rounding, boxes are larger by 2^-20 of the numbers that are
// subtracted.
static inline unsigned enters(const Slopes *slopes, const WideNode *node, float farthest,
                              float *near)
{
    float from[3], more[3];
    for (int axis = 0; axis < 3; axis++) {
        float o = (float)((slopes->line->origin[axis] - node->corner[axis]) * slopes->scale);
        from[axis] = o * slopes->inverse[axis];
        more[axis] = 0x1p-20F * (fabsf(o) + node->size) * slopes->across[axis];
    }
    const float *inverse = slopes->inverse, *across = slopes->across;
    alignas(64) int in[LANES];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float x = node->middle[0][i] * inverse[0] - from[0];
        float y = node->middle[1][i] * inverse[1] - from[1];
        float z = node->middle[2][i] * inverse[2] - from[2];
        float half_x = node->half[0][i] * across[0] + more[0];
        float half_y = node->half[1][i] * across[1] + more[1];
        float half_z = node->half[2][i] * across[2] + more[2];
        float begin = x - half_x, end = x + half_x;
        begin = y - half_y > begin ? y - half_y : begin;
        begin = z - half_z > begin ? z - half_z : begin;
        begin = begin > 0 ? begin : 0;
        end = y + half_y < end ? y + half_y : end;
        end = z + half_z < end ? z + half_z : end;
        end = end < farthest ? end : farthest;
        near[i] = begin;
        in[i] = begin <= end ? -1 : 0;
    }
    return bits_of(in) & ((1U << node->boxes) - 1);
}

// ---- spheres, in doubles ----------------------------------------------------------------------

// Which of ASKED spheres, from place first on, the ray may meet before farthest, as bits.
static inline unsigned may_meet(const RayWorld *world, int first, int count, const Line *line,
                                double farthest)
{
    const double *xs = world->x + first, *ys = world->y + first, *zs = world->z + first;
    const double *rs = world->r + first;
    double ox = line->origin[0], oy = line->origin[1], oz = line->origin[2];
    double dx = line->direction[0], dy = line->direction[1], dz = line->direction[2];
    unsigned bits = 0;
#pragma omp simd reduction(| : bits)
    for (int i = 0; i < ASKED; i++) {
        double x = xs[i] - ox, y = ys[i] - oy, z = zs[i] - oz, rr = rs[i] * rs[i];
        double along = x * dx + y * dy + z * dz, pp = x * x + y * y + z * z;
        double margin = MARGIN * (pp + rr), outside = pp - rr - margin;
        double most = rr - pp + along * along + margin;
        // It begins before farthest if most is at least the square of what is too far.
        double beyond = along - farthest;
        beyond = beyond > 0 && outside > 0 ? beyond : 0;
        bool behind = (along < 0) & (outside > 0);
        bits |= (unsigned)((most >= beyond * beyond) & !behind) << i;
    }
    return bits & ((1U << count) - 1);
}

static inline Meeting meet_place(const RayWorld *world, int place, const Line *line)
{
    return meet(world->x[place] - line->origin[0], world->y[place] - line->origin[1],
                world->z[place] - line->origin[2], world->r[place], line);
}

// ---- the walk ---------------------------------------------------------------------------------

// Nodes still to enter and spheres still to ask, the next one last.
typedef struct {
    float near;
    int first, count; // as in WideNode
} Waiting;
enum { MOST_WAITING = HIERARCHY_DEEPEST * LANES };

static inline int push(Waiting *waiting, int count, const WideNode *node, unsigned bits,
                       const float *near)
{
    int bottom = count;
    for (; bits != 0; bits &= bits - 1) {
        int i = __builtin_ctz(bits), at = count++;
        for (; at > bottom && waiting[at - 1].near < near[i]; at--)
            waiting[at] = waiting[at - 1];
        waiting[at] = (Waiting){near[i], node->first[i], node->count[i]};
    }
    return count;
}

// Forgets the candidates that begin beyond the nearest certain hit. A list that is not complete
// stays so.
static void forget(PossibleHits *candidates, double *begins, double nearest)
{
    int kept = 0;
    if (candidates->count > MOST_CANDIDATES)
        return;
    for (int i = 0; i < candidates->count; i++) {
        if (begins[i] <= nearest) {
            begins[kept] = begins[i];
            candidates->places[kept++] = candidates->places[i];
        }
    }
    candidates->count = kept;
}

void LANES(nearest_of)(const RayWorld *world, const Line *line, PossibleHits *candidates)
{
    Waiting waiting[MOST_WAITING];
    double begins[MOST_CANDIDATES], nearest = INFINITY;
    float near[LANES], farthest = INFINITY;
    int count = 0;
    Slopes slopes = slopes_of(world, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.near > farthest)
            continue;
        if (next.count == 0) {
            const WideNode *node = &world->nodes[next.first];
            count = push(waiting, count, node, enters(&slopes, node, farthest, near), near);
            continue;
        }
        unsigned bits = may_meet(world, next.first, next.count, line, nearest);
        for (; bits != 0; bits &= bits - 1) {
            int place = next.first + __builtin_ctz(bits);
            Meeting meeting = meet_place(world, place, line);
            if (meeting.begin > nearest)
                continue;
            if (meeting.end < nearest) {
                nearest = meeting.end;
                farthest = (float)(nearest * world->scale) * (1 + 0x1p-20F);
                forget(candidates, begins, nearest);
            }
            if (candidates->count < MOST_CANDIDATES)
                begins[candidates->count] = meeting.begin;
            add_candidate(candidates, place);
        }
    }
}

bool LANES(any_before)(const RayWorld *world, const Line *line, double reach,
                       PossibleHits *candidates)
{
    Waiting waiting[MOST_WAITING];
    float near[LANES], farthest = (float)(reach * world->scale) * (1 + 0x1p-20F);
    int count = 0;
    Slopes slopes = slopes_of(world, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.count == 0) {
            const WideNode *node = &world->nodes[next.first];
            unsigned bits = enters(&slopes, node, farthest, near);
            for (; bits != 0; bits &= bits - 1) {
                int i = __builtin_ctz(bits);
                waiting[count++] = (Waiting){near[i], node->first[i], node->count[i]};
            }
            continue;
        }
        unsigned bits = may_meet(world, next.first, next.count, line, reach * (1 + MARGIN));
        for (; bits != 0; bits &= bits - 1) {
            int place = next.first + __builtin_ctz(bits);
            Meeting meeting = meet_place(world, place, line);
            if (meeting.begin > reach * (1 + MARGIN))
                continue;
            if (meeting.end < reach * (1 - MARGIN)) {
                *candidates = (PossibleHits){1, {place}};
                return true;
            }
            add_candidate(candidates, place);
        }
    }
    return false;
}
