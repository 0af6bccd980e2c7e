// any_ray_lanes.c - rays through the wide hierarchy: near boxes first for the nearest hit, any
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

// ---- boxes and spheres, in floats -------------------------------------------------------------

// A ray, its direction in floats, and along the axes 1 / direction and its absolute value.
typedef struct {
    Line line;
    float direction[3], inverse[3], across[3];
} Slopes;

// Never for 0: infinity times 0 would be NaN.
static inline void set_slopes(Slopes *slopes, const Line *line)
{
    slopes->line = *line;
    for (int axis = 0; axis < 3; axis++) {
        float d = (float)line->direction[axis];
        float away = fabsf(d) > 1e-18F ? d : copysignf(1e-18F, d);
        slopes->direction[axis] = d;
        slopes->inverse[axis] = 1 / away;
        slopes->across[axis] = fabsf(slopes->inverse[axis]);
    }
}

// Which boxes of a node the ray enters before farthest, as bits, and where: the slabs of
// slab_test.h, for 16 boxes. For rounding, boxes are larger by 2^-20 of the numbers that are
// subtracted.
static inline unsigned enters(const Slopes *slopes, const WideNode *node, double scale,
                              float farthest, float *near)
{
    float from[3], more[3];
    for (int axis = 0; axis < 3; axis++) {
        float o = (float)((slopes->line.origin[axis] - node->corner[axis]) * scale);
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

// Which spheres of a leaf the ray may meet before farthest, as bits. Floats count from the point of
// the ray that is nearest to the leaf's centre, so that they are not larger than the leaf. Their
// errors are less than 2^-21 of the lengths, and 2^-19 of the squares.
static inline unsigned may_meet(const Slopes *slopes, const WideLeaf *leaf, double scale,
                                float farthest)
{
    const double *o = slopes->line.origin, *v = slopes->line.direction;
    double x = o[0] - leaf->center[0], y = o[1] - leaf->center[1], z = o[2] - leaf->center[2];
    double ahead = -(x * v[0] + y * v[1] + z * v[2]);
    float px = (float)((x + ahead * v[0]) * scale), py = (float)((y + ahead * v[1]) * scale);
    float pz = (float)((z + ahead * v[2]) * scale), t = (float)(ahead * scale);
    float dx = slopes->direction[0], dy = slopes->direction[1], dz = slopes->direction[2];
    float size = fabsf(px) + fabsf(py) + fabsf(pz) + leaf->size + 0x1p-28F * fabsf(t);
    float margin = 0x1p-18F * size * size + 1e-36F, more = 0x1p-20F * (size + fabsf(t));
    float first = -t - more, last = farthest - t + more;
    alignas(64) int may[LANES];
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float cx = leaf->x[i] - px, cy = leaf->y[i] - py, cz = leaf->z[i] - pz, r = leaf->r[i];
        float along = cx * dx + cy * dy + cz * dz;
        float d = r * r - (cx * cx + cy * cy + cz * cz) + along * along + margin;
        // How far the middle of the chord is outside of the part that counts.
        float before = first - along, beyond = along - last;
        float out = before > beyond ? before : beyond;
        out = out > 0 ? out : 0;
        may[i] = out * out <= d ? -1 : 0;
    }
    return bits_of(may) & ((1U << leaf->count) - 1);
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

// Nodes still to enter and leaves still to ask, the next one last.
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
    Slopes slopes;
    set_slopes(&slopes, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.near > farthest)
            continue;
        if (next.count == 0) {
            const WideNode *node = &world->nodes[next.first];
            unsigned bits = enters(&slopes, node, world->scale, farthest, near);
            count = push(waiting, count, node, bits, near);
            continue;
        }
        const WideLeaf *leaf = &world->leaves[next.first];
        unsigned bits = may_meet(&slopes, leaf, world->scale, farthest);
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
    set_slopes(&slopes, line);
    candidates->count = 0;
    if (world->nodes != NULL)
        waiting[count++] = (Waiting){0};
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.count == 0) {
            const WideNode *node = &world->nodes[next.first];
            unsigned bits = enters(&slopes, node, world->scale, farthest, near);
            for (; bits != 0; bits &= bits - 1) {
                int i = __builtin_ctz(bits);
                waiting[count++] = (Waiting){near[i], node->first[i], node->count[i]};
            }
            continue;
        }
        const WideLeaf *leaf = &world->leaves[next.first];
        unsigned bits = may_meet(&slopes, leaf, world->scale, farthest);
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
enum { MOST_BOXES = 64 };
typedef struct {
    alignas(64) float near[MOST_BOXES + LANES];
    int box[MOST_BOXES + LANES]; // a node; if negative, ~ the number of a leaf
    int count, next;
    int number; // of the ray
    float farthest;
    int place;
    double begin, end, rival; // bounds of the nearest certain hit, and of all others
    Slopes slopes;
} Walker;

// Adds the boxes of a node that the ray enters.
static inline void add_boxes(Walker *walker, const WideNode *node, unsigned bits, const float *near)
{
#ifdef __AVX512F__
    __m512i first = _mm512_load_si512(node->first);
    __m512i count = _mm512_cvtepu8_epi32(_mm_loadu_si128((const __m128i *)node->count));
    __mmask16 leaves = _mm512_test_epi32_mask(count, count);
    first = _mm512_mask_xor_epi32(first, leaves, first, _mm512_set1_epi32(-1));
    __m512 entries = _mm512_maskz_compress_ps((__mmask16)bits, _mm512_load_ps(near));
    int added = __builtin_popcount(bits);
    __mmask16 rest = (__mmask16)(0xFFFFU << added);
    _mm512_storeu_ps(walker->near + walker->count,
                     _mm512_mask_mov_ps(entries, rest, _mm512_set1_ps(INFINITY)));
    _mm512_storeu_si512(walker->box + walker->count,
                        _mm512_maskz_compress_epi32((__mmask16)bits, first));
    walker->count += added;
#else
    for (; bits != 0; bits &= bits - 1) {
        int i = __builtin_ctz(bits);
        walker->near[walker->count] = near[i];
        walker->box[walker->count++] = node->count[i] > 0 ? ~node->first[i] : node->first[i];
    }
#endif
}

// Takes the nearest of the boxes that wait. False at the end.
static inline bool take_nearest(Walker *walker)
{
#ifdef __AVX512F__
    __m512 least = _mm512_load_ps(walker->near);
    for (int i = LANES; i < walker->count; i += LANES)
        least = _mm512_min_ps(least, _mm512_load_ps(walker->near + i));
    float nearest = _mm512_reduce_min_ps(least);
    if (!(nearest <= walker->farthest) || walker->count == 0)
        return false;
    unsigned bits = 0;
    int at = -LANES;
    do {
        at += LANES;
        bits = _mm512_cmp_ps_mask(_mm512_load_ps(walker->near + at), _mm512_set1_ps(nearest),
                                  _CMP_EQ_OQ);
    } while (bits == 0);
    at += __builtin_ctz(bits);
#else
    float nearest = INFINITY;
    int at = 0;
    for (int i = 0; i < walker->count; i++) {
        at = walker->near[i] < nearest ? i : at;
        nearest = walker->near[i] < nearest ? walker->near[i] : nearest;
    }
    if (!(nearest <= walker->farthest) || walker->count == 0)
        return false;
#endif
    walker->next = walker->box[at];
    int last = --walker->count;
    walker->near[at] = walker->near[last];
    walker->box[at] = walker->box[last];
    walker->near[last] = INFINITY;
    return true;
}

static inline void ask_leaf(Walker *walker, const RayWorld *world, const WideLeaf *leaf)
{
    unsigned bits = may_meet(&walker->slopes, leaf, world->scale, walker->farthest);
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

static inline void start(Walker *walker, const Line *line, int number)
{
    walker->count = walker->next = 0;
    walker->number = number;
    walker->farthest = INFINITY;
    walker->place = NO_PLACE;
    walker->begin = walker->end = walker->rival = INFINITY;
    for (int i = 0; i < MOST_BOXES + LANES; i++)
        walker->near[i] = INFINITY;
    set_slopes(&walker->slopes, line);
}

enum { WALKERS = 32 };

void LANES(nearest_of_many)(const RayWorld *world, const Line *lines, int count, int *places)
{
    Walker walkers[WALKERS];
    int at_node[WALKERS], at_leaf[WALKERS], nodes = 0, leaves = 0, started = 0;
    for (int i = 0; i < count; i++)
        places[i] = NO_PLACE;
    if (world->nodes == NULL)
        return;
    for (; started < count && started < WALKERS; started++) {
        start(&walkers[started], &lines[started], started);
        at_node[nodes++] = started;
    }
    while (nodes + leaves > 0) {
        int moved[WALKERS], moving = 0;
        for (int k = 0; k < nodes; k++) {
            Walker *walker = &walkers[at_node[k]];
            const WideNode *node = &world->nodes[walker->next];
            alignas(64) float near[LANES];
            unsigned bits = enters(&walker->slopes, node, world->scale, walker->farthest, near);
            add_boxes(walker, node, bits, near);
            moved[moving++] = at_node[k];
        }
        for (int k = 0; k < leaves; k++) {
            Walker *walker = &walkers[at_leaf[k]];
            ask_leaf(walker, world, &world->leaves[~walker->next]);
            moved[moving++] = at_leaf[k];
        }
        nodes = leaves = 0;
        for (int k = 0; k < moving; k++) {
            Walker *walker = &walkers[moved[k]];
            bool full = walker->count > MOST_BOXES;
            if (!full && take_nearest(walker)) {
                int leaf = walker->next < 0;
                const char *data = leaf ? (const char *)&world->leaves[~walker->next]
                                        : (const char *)&world->nodes[walker->next];
                for (int i = 0; i < 512; i += 64)
                    __builtin_prefetch(data + i);
                at_node[nodes] = moved[k];
                at_leaf[leaves] = moved[k];
                nodes += !leaf;
                leaves += leaf;
                continue;
            }
            bool doubt = full || (walker->rival <= walker->end && walker->rival < INFINITY);
            places[walker->number] = doubt ? IN_DOUBT : walker->place;
            if (started == count)
                continue;
            start(walker, &lines[started], started);
            started++;
            at_node[nodes++] = moved[k];
        }
    }
}
