// any_ray_lanes.c - the nearest hits of rays from anywhere, through the wide hierarchy, near boxes
// first: one ray alone, or many rays in turns.
#include "chapters/08-fast/engines/any_ray.h"

#include <limits.h>
#include <math.h>
#include <string.h>
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

// ---- boxes and spheres, in floats -------------------------------------------------------------

typedef int FourInts __attribute__((vector_size(16)));

// A ray in the units of the world. Where it starts is the sum of two floats. Along each axis, it
// meets first the sides of a node's boxes from number first on.
typedef struct {
    Four start, rest, direction, inverse; // inverse: 1 / direction
    FourInts first, last;
} Slopes;

typedef double FourDoubles __attribute__((vector_size(32)));

// Never 1 / 0: infinity times 0 would be NaN.
static inline void set_slopes(Slopes *slopes, const RayWorld *world, const Line *line)
{
    const double *o = line->origin, *v = line->direction, *corner = world->corner;
    FourDoubles at = {o[0] - corner[0], o[1] - corner[1], o[2] - corner[2], 0};
    at *= world->scale;
    slopes->start = __builtin_convertvector(at, Four);
    slopes->rest =
        __builtin_convertvector(at - __builtin_convertvector(slopes->start, FourDoubles), Four);
    Four direction = {(float)v[0], (float)v[1], (float)v[2], 1}, tiny = {1e-18F, 1e-18F, 1e-18F, 0};
    FourInts is_tiny = (Four)((FourInts)direction & INT_MAX) < tiny;
    FourInts is_negative = direction <= -tiny;
    Four away = (Four)(((FourInts)direction & ~is_tiny) | ((FourInts)tiny & is_tiny));
    slopes->direction = direction;
    slopes->inverse = 1 / away;
    slopes->first = LANES * ((FourInts){0, 2, 4, 0} - is_negative);
    slopes->last = LANES * ((FourInts){1, 3, 5, 0} + is_negative);
}

// Where the ray enters the boxes of a node; infinite if it does not enter before farthest. The
// slabs of bvh.c, for 16 boxes. Rounding changes a distance t by less than 2^-20 of t and of the
// node's size. By the latter, the boxes are larger (wide_hierarchy.c).
static inline void enter(const Slopes *slopes, const RayNode *node, float farthest, float *near)
{
    Four from = (slopes->start - node->corner + slopes->rest) * slopes->inverse;
    const float *x = node->sides + slopes->first[0], *xx = node->sides + slopes->last[0];
    const float *y = node->sides + slopes->first[1], *yy = node->sides + slopes->last[1];
    const float *z = node->sides + slopes->first[2], *zz = node->sides + slopes->last[2];
    float ix = slopes->inverse[0], iy = slopes->inverse[1], iz = slopes->inverse[2];
    float from_x = from[0], from_y = from[1], from_z = from[2];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float begin = x[i] * ix - from_x, end = xx[i] * ix - from_x;
        float begin_y = y[i] * iy - from_y, end_y = yy[i] * iy - from_y;
        float begin_z = z[i] * iz - from_z, end_z = zz[i] * iz - from_z;
        begin = begin > 0 ? begin : 0;
        begin = begin_y > begin ? begin_y : begin;
        begin = begin_z > begin ? begin_z : begin;
        end = end_y < end ? end_y : end;
        end = end_z < end ? end_z : end;
        end = end < farthest ? end : farthest;
        near[i] = begin * (1 - 0x1p-19F) <= end ? begin : INFINITY;
    }
}

// Which spheres of a leaf the ray may meet before farthest, as bits. The line passes a centre at
// the distance |c x v|: no digits are lost, so its error is less than 2^-20 of the centre's
// distance and of the leaf's size. The same is true of c.v, where the middle of the chord is. A
// sphere that is larger by both errors is met before and after these too. By the size's part, the
// radii are larger already (wide_hierarchy.c).
static inline unsigned may_meet(const Slopes *slopes, const RayLeaf *leaf, float farthest)
{
    Four local = slopes->start - leaf->center + slopes->rest;
    float px = local[0], py = local[1], pz = local[2];
    float dx = slopes->direction[0], dy = slopes->direction[1], dz = slopes->direction[2];
    alignas(64) int may[LANES];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float cx = leaf->x[i] - px, cy = leaf->y[i] - py, cz = leaf->z[i] - pz;
        float along = cx * dx + cy * dy + cz * dz;
        float ax = cy * dz - cz * dy, ay = cz * dx - cx * dz, az = cx * dy - cy * dx;
        float r = leaf->r[i] + 0x1p-19F * fabsf(along);
        float d = r * r - (ax * ax + ay * ay + az * az);
        // How far the middle of the chord is outside of the part that counts.
        float inside = along < farthest ? along : farthest;
        inside = inside > 0 ? inside : 0;
        float out = along - inside;
        may[i] = out * out <= d ? -1 : 0;
    }
    return bits_of(may);
}

static inline Meeting meet_place(const RayWorld *world, int place, const Line *line)
{
    const double *sphere = world->numbers + 4 * (size_t)place;
    return meet(sphere[0] - line->origin[0], sphere[1] - line->origin[1],
                sphere[2] - line->origin[2], sphere[3], line);
}

// A distance in floats that is certainly not less.
static inline float at_least(double distance, double scale)
{
    return (float)(distance * scale) * (1 + 0x1p-18F);
}

// ---- one ray ----------------------------------------------------------------------------------

// Boxes still to enter, the next one last.
typedef struct {
    float near;
    int box; // as RayNode's below
} Waiting;
enum { MOST_WAITING = HIERARCHY_DEEPEST * LANES };

// Adds the boxes that the ray enters, the nearest last.
static inline int push(Waiting *waiting, int count, const RayNode *node, const float *near)
{
    int bottom = count;
    for (int i = 0; i < LANES; i++) {
        if (near[i] == INFINITY)
            continue;
        int at = count++;
        for (; at > bottom && waiting[at - 1].near < near[i]; at--)
            waiting[at] = waiting[at - 1];
        waiting[at] = (Waiting){near[i], node->below[i]};
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
    Slopes slopes;
    set_slopes(&slopes, world, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.near > farthest)
            continue;
        const void *data = ray_world_data(world, next.box);
        if (next.box >= 0) {
            const RayNode *node = data;
            enter(&slopes, node, farthest, near);
            count = push(waiting, count, node, near);
            continue;
        }
        const RayLeaf *leaf = data;
        unsigned bits = may_meet(&slopes, leaf, farthest);
        for (; bits != 0; bits &= bits - 1) {
            int place = leaf->first + __builtin_ctz(bits);
            Meeting meeting = meet_place(world, place, line);
            if (!(meeting.begin <= nearest) || meeting.begin == INFINITY)
                continue;
            if (meeting.end < nearest) {
                nearest = meeting.end;
                farthest = at_least(nearest, world->scale);
                forget(candidates, begins, nearest);
            }
            if (candidates->count < MOST_CANDIDATES)
                begins[candidates->count] = meeting.begin;
            add_candidate(candidates, place);
        }
    }
}

// ---- many rays in turns -----------------------------------------------------------------------

// A ray on its way: boxes to enter, and the nearest hit so far. Boxes wait in no order. Where none
// waits, or one that begins beyond farthest, another one may be written.
typedef struct {
    union {
        alignas(64) float near[LANES];
        int bits[LANES]; // the same floats: as ints they have the same order
    };
    int box[LANES]; // as RayNode's below
    Slopes slopes;
    const Line *line;
    int number;               // of the ray
    float farthest, lost;     // lost: where the first box began for which there was no room
    int place, missed;        // missed: a sphere that it certainly does not hit
    double begin, end, rival; // bounds of the nearest certain hit, and of all others
} Walker;

// Adds the boxes of a node that the ray enters.
static inline void add_boxes(Walker *walker, const RayNode *node, const float *near)
{
#ifdef __AVX512F__
    const __m512 none = _mm512_set1_ps(INFINITY), found = _mm512_loadu_ps(near);
    __m512 waiting = _mm512_load_ps(walker->near);
    __mmask16 entered = _mm512_cmp_ps_mask(found, none, _CMP_LT_OQ);
    __mmask16 room = _mm512_cmp_ps_mask(waiting, _mm512_set1_ps(walker->farthest), _CMP_GE_OQ);
    __m512 some = _mm512_mask_compress_ps(none, entered, found);
    __m512i boxes = _mm512_maskz_compress_epi32(entered, _mm512_load_si512(node->below));
    _mm512_store_ps(walker->near, _mm512_mask_expand_ps(waiting, room, some));
    _mm512_store_si512(walker->box,
                       _mm512_mask_expand_epi32(_mm512_load_si512(walker->box), room, boxes));
    int places = __builtin_popcount(room);
    if (__builtin_popcount(entered) > places) {
        __mmask16 beyond = (__mmask16)(0xFFFFU << places);
        walker->lost = fminf(walker->lost, _mm512_mask_reduce_min_ps(beyond, some));
    }
#else
    int at = 0;
    for (int i = 0; i < LANES; i++) {
        if (near[i] == INFINITY)
            continue;
        while (at < LANES && walker->near[at] < walker->farthest)
            at++;
        if (at < LANES) {
            walker->near[at] = near[i];
            walker->box[at] = node->below[i];
        } else
            walker->lost = fminf(walker->lost, near[i]);
    }
#endif
}

// Takes the nearest of the boxes that wait, and returns where it begins, infinite if there is none.
// The last 4 bits of a distance are replaced by its place, so the least number says where it is.
static inline float take_nearest(Walker *walker, int *next)
{
    int least = INT_MAX;
#pragma omp simd reduction(min : least)
    for (int i = 0; i < LANES; i++) {
        int bits = (walker->bits[i] & -LANES) | i;
        least = bits < least ? bits : least;
    }
    int at = least & (LANES - 1);
    float nearest;
    least &= -LANES;
    memcpy(&nearest, &least, sizeof nearest);
    *next = walker->box[at];
    walker->near[at] = INFINITY;
    return nearest;
}

// Nothing if the place is NO_PLACE, or in another leaf.
static inline unsigned bit_of_place(const RayLeaf *leaf, int place)
{
    unsigned bit = (unsigned)(place - leaf->first);
    return bit < LANES ? 1U << bit : 0;
}

static inline void ask_spheres(Walker *walker, const RayWorld *world, const RayLeaf *leaf,
                               unsigned bits)
{
    for (; bits != 0; bits &= bits - 1) {
        int place = leaf->first + __builtin_ctz(bits);
        Meeting meeting = meet_place(world, place, walker->line);
        double other = meeting.begin;
        if (meeting.end < walker->end) {
            other = walker->begin;
            walker->begin = meeting.begin;
            walker->end = meeting.end;
            walker->place = place;
            walker->farthest = at_least(meeting.end, world->scale);
        }
        walker->rival = other < walker->rival ? other : walker->rival;
    }
}

static inline void start(Walker *walker, const RayWorld *world, const Line *line, int left,
                         int number)
{
    for (int i = 0; i < LANES; i++)
        walker->near[i] = INFINITY;
    walker->number = number;
    walker->line = line;
    walker->farthest = walker->lost = INFINITY;
    walker->place = NO_PLACE;
    walker->begin = walker->end = walker->rival = INFINITY;
    set_slopes(&walker->slopes, world, line);
    walker->missed = left >= 0 && meet_place(world, left, line).begin == INFINITY ? left : -LANES;
}

// One bit for each ray on its way.
enum { WALKERS = 64 };
typedef uint64_t Bits;

// The rays whose next box is a leaf.
static inline Bits at_leaves(const int *next)
{
    Bits bits = 0;
    for (int i = 0; i < WALKERS; i += LANES)
        bits |= (Bits)bits_of(next + i) << i;
    return bits;
}

// Rays at nodes enter the boxes there.
static inline void leave_nodes(const RayWorld *world, Walker *walkers, const int *next, Bits bits)
{
    for (; bits != 0; bits &= bits - 1) {
        int number = __builtin_ctzll(bits);
        const RayNode *node = ray_world_data(world, next[number]);
        alignas(64) float near[LANES];
        enter(&walkers[number].slopes, node, walkers[number].farthest, near);
        add_boxes(&walkers[number], node, near);
    }
}

// Rays at leaves ask the spheres there.
static inline void leave_leaves(const RayWorld *world, Walker *walkers, const int *next, Bits bits)
{
    Bits asking = 0;
    unsigned spheres[WALKERS];
    for (; bits != 0; bits &= bits - 1) {
        int number = __builtin_ctzll(bits);
        const Walker *walker = &walkers[number];
        const RayLeaf *leaf = ray_world_data(world, next[number]);
        spheres[number] =
            may_meet(&walker->slopes, leaf, walker->farthest) & ~bit_of_place(leaf, walker->missed);
        asking |= (Bits)(spheres[number] != 0) << number;
    }
    for (; asking != 0; asking &= asking - 1) {
        int number = __builtin_ctzll(asking);
        ask_spheres(&walkers[number], world, ray_world_data(world, next[number]), spheres[number]);
    }
}

// Rays go to the nearest of their boxes. Returns those that end.
static inline Bits go_on(Walker *walkers, int *next, Bits bits)
{
    Bits ended = 0;
    for (; bits != 0; bits &= bits - 1) {
        int number = __builtin_ctzll(bits);
        bool ends = !(take_nearest(&walkers[number], &next[number]) < walkers[number].farthest);
        ended |= (Bits)ends << number;
    }
    return ended;
}

// Each round takes all rays a step: those at a node enter its boxes, those at a leaf ask its
// spheres, and then all go to their nearest box. Each loop does one short thing, for all rays that
// need it. So no ray waits for itself, and where it goes need not be predicted. A ray that ends
// gives its answer, and the next one starts in its place.
void LANES(nearest_of_many)(const RayWorld *world, const Line *lines, const int *left, int count,
                            int *places)
{
    Walker walkers[WALKERS];
    alignas(64) int next[WALKERS] = {0};
    Bits walking = 0;
    int started = 0;
    for (int i = 0; i < count; i++)
        places[i] = NO_PLACE;
    if (world->nodes == NULL)
        return;
    for (; started < count && started < WALKERS; started++) {
        start(&walkers[started], world, &lines[started], left[started], started);
        walking |= (Bits)1 << started;
    }
    while (walking != 0) {
        Bits leaves = at_leaves(next);
        leave_nodes(world, walkers, next, walking & ~leaves);
        leave_leaves(world, walkers, next, walking & leaves);
        Bits ended = go_on(walkers, next, walking);
        walking &= ~ended;
        for (; ended != 0; ended &= ended - 1) {
            int number = __builtin_ctzll(ended);
            Walker *walker = &walkers[number];
            bool doubt = walker->lost < walker->farthest ||
                         (walker->rival <= walker->end && walker->rival < INFINITY);
            places[walker->number] = doubt ? IN_DOUBT : walker->place;
            if (started == count)
                continue;
            start(walker, world, &lines[started], left[started], started);
            started++;
            next[number] = 0;
            walking |= (Bits)1 << number;
        }
    }
}
