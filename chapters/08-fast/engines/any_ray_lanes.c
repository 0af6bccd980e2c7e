// any_ray_lanes.c - rays from anywhere through the wide hierarchy, near boxes first: one ray alone,
// for the nearest hit or for any hit; or many rays in turns, for their nearest hits.
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
    Four start, rest, direction, inverse, across; // inverse: 1 / direction; across: without sign
    FourInts first, last;
    Line line;
} Slopes;

static inline Four without_sign(Four v)
{
    return (Four)((FourInts)v & 0x7FFFFFFF);
}

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
    FourInts is_tiny = without_sign(direction) < tiny, is_negative = direction <= -tiny;
    Four away = (Four)(((FourInts)direction & ~is_tiny) | ((FourInts)tiny & is_tiny));
    slopes->direction = direction;
    slopes->inverse = 1 / away;
    slopes->across = without_sign(slopes->inverse);
    slopes->first = LANES * ((FourInts){0, 2, 4, 0} - is_negative);
    slopes->last = LANES * ((FourInts){1, 3, 5, 0} + is_negative);
    slopes->line = *line;
}

// Where the ray enters the boxes of a node; infinite if it does not enter before farthest. The
// slabs of bvh.c, for 16 boxes. For rounding, boxes are larger by 2^-20 of the numbers that are
// subtracted.
static inline void enter(const Slopes *slopes, const RayNode *node, float farthest, float *near)
{
    Four local = slopes->start - node->corner + slopes->rest;
    Four from = local * slopes->inverse;
    Four more = 0x1p-20F * (without_sign(local) + node->size) * slopes->across;
    Four begins = from + more, ends = from - more;
    const float *x = node->sides + slopes->first[0], *xx = node->sides + slopes->last[0];
    const float *y = node->sides + slopes->first[1], *yy = node->sides + slopes->last[1];
    const float *z = node->sides + slopes->first[2], *zz = node->sides + slopes->last[2];
    float ix = slopes->inverse[0], iy = slopes->inverse[1], iz = slopes->inverse[2];
    float x1 = begins[0], y1 = begins[1], z1 = begins[2];
    float x2 = ends[0], y2 = ends[1], z2 = ends[2];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float begin = x[i] * ix - x1, begin_y = y[i] * iy - y1, begin_z = z[i] * iz - z1;
        float end = xx[i] * ix - x2, end_y = yy[i] * iy - y2, end_z = zz[i] * iz - z2;
        begin = begin_y > begin ? begin_y : begin;
        begin = begin_z > begin ? begin_z : begin;
        begin = begin > 0 ? begin : 0;
        end = end_y < end ? end_y : end;
        end = end_z < end ? end_z : end;
        end = end < farthest ? end : farthest;
        near[i] = begin <= end ? begin : INFINITY;
    }
}

// Which spheres of a leaf the ray may meet before farthest, as bits. The line passes a centre at
// the distance |c x v|: no digits are lost, so its error is less than 2^-21 of the centre's
// distance.
static inline unsigned may_meet(const Slopes *slopes, const RayLeaf *leaf, float farthest)
{
    Four local = slopes->start - leaf->center + slopes->rest, away = without_sign(local);
    float px = local[0], py = local[1], pz = local[2], size = leaf->size;
    float dx = slopes->direction[0], dy = slopes->direction[1], dz = slopes->direction[2];
    float error = 0x1p-21F * (away[0] + away[1] + away[2] + 2 * size);
    float margin = error * (2 * size + error) + 0x1p-21F * size * size + 1e-36F;
    float last = farthest + error;
    alignas(64) int may[LANES];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float cx = leaf->x[i] - px, cy = leaf->y[i] - py, cz = leaf->z[i] - pz, r = leaf->r[i];
        float along = cx * dx + cy * dy + cz * dz;
        float ax = cy * dz - cz * dy, ay = cz * dx - cx * dz, az = cx * dy - cy * dx;
        float d = r * r + margin - (ax * ax + ay * ay + az * az);
        // How far the middle of the chord is outside of the part that counts.
        float before = -error - along, beyond = along - last;
        float out = before > beyond ? before : beyond;
        out = out > 0 ? out : 0;
        may[i] = out * out <= d ? -1 : 0;
    }
    return bits_of(may) & leaf->spheres;
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
    return (float)(distance * scale) * (1 + 0x1p-20F);
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
        if (next.box >= 0) {
            enter(&slopes, &world->nodes[next.box], farthest, near);
            count = push(waiting, count, &world->nodes[next.box], near);
            continue;
        }
        const RayLeaf *leaf = &world->leaves[~next.box];
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

bool LANES(any_before)(const RayWorld *world, const Line *line, double reach,
                       PossibleHits *candidates)
{
    Waiting waiting[MOST_WAITING];
    float near[LANES], farthest = at_least(reach, world->scale);
    int count = 0;
    Slopes slopes;
    set_slopes(&slopes, world, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.box >= 0) {
            enter(&slopes, &world->nodes[next.box], farthest, near);
            count = push(waiting, count, &world->nodes[next.box], near);
            continue;
        }
        const RayLeaf *leaf = &world->leaves[~next.box];
        unsigned bits = may_meet(&slopes, leaf, farthest);
        for (; bits != 0; bits &= bits - 1) {
            int place = leaf->first + __builtin_ctz(bits);
            Meeting meeting = meet_place(world, place, line);
            if (!(meeting.begin <= reach * (1 + MARGIN)) || meeting.begin == INFINITY)
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

// ---- many rays in turns -----------------------------------------------------------------------

// A ray on its way: the box to enter next, those that wait, and the nearest hit so far. Boxes that
// wait are in no order. After the last one their distances are infinite.
enum { MOST_BOXES = 32 };
typedef struct {
    alignas(64) float near[MOST_BOXES + LANES];
    int box[MOST_BOXES + LANES]; // as RayNode's below
    int count, next;
    int number; // of the ray
    float farthest;
    int place, missed;        // missed: a sphere that it certainly does not hit
    double begin, end, rival; // bounds of the nearest certain hit, and of all others
    Slopes slopes;
} Walker;

static inline bool is_full(const Walker *walker)
{
    return walker->count > MOST_BOXES;
}

// Adds the boxes of a node that the ray enters.
static inline void add_boxes(Walker *walker, const RayNode *node, const float *near)
{
    float *to = walker->near + walker->count;
    int *box = walker->box + walker->count;
#ifdef __AVX512F__
    __m512 distances = _mm512_loadu_ps(near), none = _mm512_set1_ps(INFINITY);
    __mmask16 entered = _mm512_cmp_ps_mask(distances, none, _CMP_LT_OQ);
    _mm512_storeu_ps(to, _mm512_mask_compress_ps(none, entered, distances));
    _mm512_storeu_si512(box, _mm512_maskz_compress_epi32(entered, _mm512_load_si512(node->below)));
    walker->count += __builtin_popcount(entered);
#else
    int added = 0;
    for (int i = 0; i < LANES; i++) {
        if (near[i] < INFINITY) {
            to[added] = near[i];
            box[added++] = node->below[i];
        }
    }
    walker->count += added;
#endif
}

// The place of the nearest of the boxes that wait. Its distance may be less by 2^-16 of it.
static inline int place_of_nearest(const Walker *walker, float *nearest)
{
#ifdef __AVX512F__
    // The last 7 bits of each float are its place, so the least float says where it is.
    const __m512i last_bits = _mm512_set1_epi32(0x7F), step = _mm512_set1_epi32(LANES);
    __m512i places = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    __m512i least = _mm512_set1_epi32(INT_MAX);
    int i = 0;
    do {
        __m512i some = _mm512_load_si512(walker->near + i);
        least = _mm512_min_epi32(least, _mm512_ternarylogic_epi32(last_bits, places, some, 0xCA));
        places = _mm512_add_epi32(places, step);
        i += LANES;
    } while (i < walker->count);
    int bits = _mm512_reduce_min_epi32(least), distance = bits & ~0x7F;
    memcpy(nearest, &distance, sizeof *nearest);
    return bits & 0x7F;
#else
    int at = 0;
    *nearest = INFINITY;
    for (int i = 0; i < walker->count; i++) {
        at = walker->near[i] < *nearest ? i : at;
        *nearest = walker->near[i] < *nearest ? walker->near[i] : *nearest;
    }
    return at;
#endif
}

// Takes the nearest of the boxes that wait. False if there is none, or too many for the list: the
// ray ends.
static inline bool take_nearest(Walker *walker)
{
    float nearest;
    int at = place_of_nearest(walker, &nearest), last = walker->count - (walker->count > 0);
    bool goes_on = (nearest <= walker->farthest) & (walker->count > 0) & !is_full(walker);
    walker->next = walker->box[at];
    walker->near[at] = walker->near[last];
    walker->box[at] = walker->box[last];
    walker->near[last] = INFINITY;
    walker->count -= goes_on;
    return goes_on;
}

// Nothing if the place is NO_PLACE, or in another leaf.
static inline unsigned bit_of_place(const RayLeaf *leaf, int place)
{
    unsigned bit = (unsigned)(place - leaf->first);
    return bit < LANES ? 1U << bit : 0;
}

static inline unsigned spheres_to_ask(const Walker *walker, const RayLeaf *leaf)
{
    return may_meet(&walker->slopes, leaf, walker->farthest) & ~bit_of_place(leaf, walker->missed);
}

static inline void ask_spheres(Walker *walker, const RayWorld *world, unsigned bits)
{
    const RayLeaf *leaf = &world->leaves[~walker->next];
    for (; bits != 0; bits &= bits - 1) {
        int place = leaf->first + __builtin_ctz(bits);
        Meeting meeting = meet_place(world, place, &walker->slopes.line);
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
    for (int i = 0; i < walker->count; i++)
        walker->near[i] = INFINITY;
    walker->count = walker->next = walker->box[0] = 0;
    walker->number = number;
    walker->farthest = INFINITY;
    walker->place = NO_PLACE;
    walker->begin = walker->end = walker->rival = INFINITY;
    set_slopes(&walker->slopes, world, line);
    walker->missed = left >= 0 && meet_place(world, left, line).begin == INFINITY ? left : -LANES;
}

// Begins to load what a ray asks next.
static inline void load(const RayWorld *world, int box)
{
    const char *data =
        box < 0 ? (const char *)&world->leaves[~box] : (const char *)&world->nodes[box];
    for (int i = 0; i < (int)sizeof(RayNode); i += 64)
        __builtin_prefetch(data + i);
}

enum { WALKERS = 64 };

// The rays that go to the same kind of place. There is room for one more, which add_if may write.
typedef struct {
    int numbers[WALKERS + 1], count;
} List;

// Always writes, but only counts a number that belongs to the list: a processor cannot predict an
// 'if' here, and a wrong prediction costs more than writing.
static inline void add_if(List *list, int number, bool belongs)
{
    list->numbers[list->count] = number;
    list->count += belongs;
}

// Each round takes all rays one step: those at a node enter its boxes, those at a leaf ask its
// spheres, and then all go to their nearest box. Each loop does one thing, for all rays that need
// it. A ray that ends gives its answer, and the next one starts in its place.
void LANES(nearest_of_many)(const RayWorld *world, const Line *lines, const int *left, int count,
                            int *places)
{
    Walker walkers[WALKERS];
    List at_node = {.count = 0}, at_leaf = {.count = 0}, asking, moved, ended = {.count = 0};
    unsigned bits[WALKERS];
    int started = 0;
    for (int i = 0; i < count; i++)
        places[i] = NO_PLACE;
    if (world->nodes == NULL)
        return;
    for (; started < count && started < WALKERS; started++) {
        walkers[started].count = MOST_BOXES + LANES;
        start(&walkers[started], world, &lines[started], left[started], started);
        add_if(&at_node, started, true);
    }
    while (at_node.count + at_leaf.count > 0) {
        moved.count = asking.count = 0;
        for (int k = 0; k < at_node.count; k++) {
            Walker *walker = &walkers[at_node.numbers[k]];
            const RayNode *node = &world->nodes[walker->next];
            alignas(64) float near[LANES];
            enter(&walker->slopes, node, walker->farthest, near);
            add_boxes(walker, node, near);
            add_if(&moved, at_node.numbers[k], true);
        }
        for (int k = 0; k < at_leaf.count; k++) {
            int number = at_leaf.numbers[k];
            const Walker *walker = &walkers[number];
            bits[number] = spheres_to_ask(walker, &world->leaves[~walker->next]);
            add_if(&asking, number, bits[number] != 0);
            add_if(&moved, number, true);
        }
        for (int k = 0; k < asking.count; k++)
            ask_spheres(&walkers[asking.numbers[k]], world, bits[asking.numbers[k]]);
        at_node.count = at_leaf.count = ended.count = 0;
        for (int k = 0; k < moved.count; k++) {
            int number = moved.numbers[k];
            bool goes_on = take_nearest(&walkers[number]), to_leaf = walkers[number].next < 0;
            load(world, walkers[number].next);
            add_if(&at_node, number, goes_on & !to_leaf);
            add_if(&at_leaf, number, goes_on & to_leaf);
            add_if(&ended, number, !goes_on);
        }
        for (int k = 0; k < ended.count; k++) {
            Walker *walker = &walkers[ended.numbers[k]];
            bool doubt =
                is_full(walker) || (walker->rival <= walker->end && walker->rival < INFINITY);
            places[walker->number] = doubt ? IN_DOUBT : walker->place;
            if (started == count)
                continue;
            start(walker, world, &lines[started], left[started], started);
            started++;
            add_if(&at_node, ended.numbers[k], true);
        }
    }
}
