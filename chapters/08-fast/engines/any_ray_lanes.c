// any_ray_lanes.c - many rays from anywhere, through the wide hierarchy, near boxes first: each ray
// asks all boxes of a node at once, and then all spheres of a leaf.
//
// Boxes and spheres are floats, with margins for rounding. A sphere that floats cannot leave out is
// asked in double, also with margins.
#include "chapters/08-fast/engines/light.h"

#include <limits.h>
#ifdef __AVX512F__
#include <immintrin.h>
#elif defined __wasm_simd128__
#include <wasm_simd128.h>
#endif

// ---- boxes and spheres, in floats -------------------------------------------------------------

// A ray in the units of the hierarchy. Where it starts is the sum of two floats. Along each axis,
// it meets first the sides of a node's boxes from number first on.
typedef struct {
    Four start, rest, direction, inverse; // inverse: 1 / direction
    FourInts first, last;
} Slopes;

// Never 1 / 0: infinity times 0 would be NaN.
static inline float inverse_of(float direction)
{
    const float tiny = 1e-18F;
    return 1 / (fabsf(direction) < tiny ? tiny : direction);
}

// Whole vectors are set, because one that is read soon after its lanes were written waits for them.
static inline void set_slopes(Slopes *slopes, const WideHierarchy *wide, Vector from, Vector v)
{
    from = times(wide->scale, minus(from, vector_at(wide->corner)));
    const Four start = {(float)from.x, (float)from.y, (float)from.z};
    const Four direction = {(float)v.x, (float)v.y, (float)v.z};
    const Four inverse = {inverse_of(direction[0]), inverse_of(direction[1]),
                          inverse_of(direction[2])};
    const FourInts backwards = inverse < 0, axes = {0, 2 * BOXES, 4 * BOXES};
    slopes->start = start;
    slopes->rest =
        (Four){(float)(from.x - start[0]), (float)(from.y - start[1]), (float)(from.z - start[2])};
    slopes->direction = direction;
    slopes->inverse = inverse;
    slopes->first = axes - BOXES * backwards;
    slopes->last = axes + BOXES * (1 + backwards);
}

// Where the ray enters the boxes of a node; infinite if it does not enter before farthest. The
// slabs of bvh.c, for all boxes. Rounding changes a distance t by less than 2^-20 of t and of the
// node's size. By the latter, the boxes are larger (hierarchy.c).
static inline void enter(const Slopes *slopes, const WideNode *node, float farthest, float *near)
{
    const float *x = node->sides + slopes->first[0], *xx = node->sides + slopes->last[0];
    const float *y = node->sides + slopes->first[1], *yy = node->sides + slopes->last[1];
    const float *z = node->sides + slopes->first[2], *zz = node->sides + slopes->last[2];
    float ix = slopes->inverse[0], iy = slopes->inverse[1], iz = slopes->inverse[2];
    const Four from = (slopes->start - node->corner + slopes->rest) * slopes->inverse;
    float from_x = from[0], from_y = from[1], from_z = from[2];
#pragma omp simd
    for (int i = 0; i < BOXES; i++) {
        float begin = x[i] * ix - from_x, end = xx[i] * ix - from_x;
        float begin_y = y[i] * iy - from_y, end_y = yy[i] * iy - from_y;
        float begin_z = z[i] * iz - from_z, end_z = zz[i] * iz - from_z;
        begin = 0 < begin ? begin : 0;
        begin = begin < begin_y ? begin_y : begin;
        begin = begin < begin_z ? begin_z : begin;
        end = end_y < end ? end_y : end;
        end = end_z < end ? end_z : end;
        end = farthest < end ? farthest : end; // NaN stays: a ray of NaN enters no box
        near[i] = begin * (1 - 0x1p-19F) <= end ? begin : INFINITY;
    }
}

// Which spheres of a leaf the ray may meet before farthest, as bits. The line passes a center at
// the distance |c x v|: no digits are lost, so its error is less than 2^-20 of the center's
// distance and of the leaf's size. The same is true of c.v, where the middle of the chord is. A
// sphere that is larger by both errors is met before and after these too. By the size's part, the
// radii are larger already (hierarchy.c).
static inline unsigned may_meet(const Slopes *slopes, const WideLeaf *leaf, float farthest)
{
    const Four from = slopes->start - leaf->center + slopes->rest;
    float px = from[0], py = from[1], pz = from[2];
    float dx = slopes->direction[0], dy = slopes->direction[1], dz = slopes->direction[2];
    alignas(64) int may[BOXES];
#pragma omp simd
    for (int i = 0; i < BOXES; i++) {
        float cx = leaf->x[i] - px, cy = leaf->y[i] - py, cz = leaf->z[i] - pz;
        float along = cx * dx + cy * dy + cz * dz;
        float ax = cy * dz - cz * dy, ay = cz * dx - cx * dz, az = cx * dy - cy * dx;
        float r = leaf->r[i] + 0x1p-19F * fabsf(along);
        float d = r * r - (ax * ax + ay * ay + az * az);
        // How far the middle of the chord is outside of the part that counts.
        float inside = along < farthest ? along : farthest;
        inside = 0 < inside ? inside : 0;
        float out = along - inside;
        may[i] = out * out <= d ? -1 : 0;
    }
#ifdef __AVX512F__ // one instruction, which compilers do not find
    return _mm512_movepi32_mask(_mm512_load_si512(may));
#elif defined __wasm_simd128__
    unsigned bits = 0;
    for (int i = 0; i < BOXES; i += 4)
        bits |= wasm_i32x4_bitmask(wasm_v128_load(may + i)) << i;
    return bits;
#else
    unsigned bits = 0;
    for (int i = 0; i < BOXES; i++)
        bits |= (unsigned)(may[i] & 1) << i;
    return bits;
#endif
}

// ---- where a ray meets a sphere, in doubles, with margins for rounding -------------------------

// The margin for a number that is the difference of two: many times their rounding error.
#define MARGIN 1e-12

// It may meet a sphere at begin or later; if end is finite, it certainly does, between begin and
// end.
typedef struct {
    double begin, end;
} Meeting;

// A sphere of radius r around p, seen from where the ray starts; v has length 1.
static inline Meeting meet(Vector p, double r, Vector v)
{
    const double rr = r * r, along = dot(p, v), pp = dot(p, p);
    const double margin = MARGIN * (pp + rr), outside = pp - rr;
    const double d = rr - pp + along * along, least = d - margin;
    const double longest = sqrt(d + margin > 0 ? d + margin : 0);
    const double shortest = sqrt(least > 0 ? least : 0), slack = MARGIN * (fabs(along) + r);
    const double near = along - longest - slack, far = along + shortest - slack;
    const bool misses = (d + margin < 0) | ((along < 0) & (outside > margin));
    const bool enters = (outside > margin) & (near > 0);
    const bool leaves = (outside < -margin) & (far > 0);
    const double begin = enters ? near : leaves ? far : 0;
    const double end = (enters & (least >= 0)) ? along - shortest + slack
                       : leaves                ? along + longest + slack
                                               : INFINITY;
    return (Meeting){misses ? INFINITY : begin, end}; // end: a miss neither enters nor leaves
}

// What is known without a root, which is most: whether a ray misses a sphere as far as it reaches,
// or certainly hits it. From outside it misses a sphere that it passes, or from which it goes away,
// or before which it ends. From inside it misses the sphere if it ends inside.
#define MISSES 1.0
#define HITS (-1.0)
#define NOT_KNOWN 0.0
static inline double glance(Vector p, double r, Vector v, double reach)
{
    const double rr = r * r, along = dot(p, v), pp = dot(p, p), outside = pp - rr;
    const double margin = MARGIN * (pp + rr), past = along * along - outside;
    if (past < -margin)
        return MISSES;
    const double ends = outside + reach * (reach - 2 * along);
    const double more = margin + MARGIN * reach * reach;
    const bool away = (along < 0) | ((along > reach) & (ends > more));
    const bool within = (outside < -margin) & (ends < -more);
    const bool misses = ((outside > margin) & away) | within;
    const bool hits = (past > margin) & (outside > margin) & (along > 0) &
                      (along * (1 + 4 * MARGIN) + MARGIN * r < reach);
    return misses ? MISSES : hits ? HITS : NOT_KNOWN;
}

enum { UNKNOWN = -3 }; // neither a place nor NO_PLACE

// Bounds of the nearest certain hit, and the least begin of all others.
typedef struct {
    double begin, end, rival;
    int place;
} Found;

// The end of a ray, where a light is, is like a hit there: only what is nearer matters.
static inline Found nothing_found(double reach)
{
    return (Found){reach * (1 - MARGIN), reach * (1 + MARGIN), INFINITY, NO_PLACE};
}

// Returns whether this is the nearest so far.
static inline bool learn(Found *found, int place, Meeting meeting)
{
    const bool wins = meeting.end < found->end;
    const double other = wins ? found->begin : meeting.begin;
    if (wins) {
        found->begin = meeting.begin;
        found->end = meeting.end;
        found->place = place;
    }
    found->rival = other < found->rival ? other : found->rival;
    return wins;
}

// Rays with directions of length 1, where they end, and what they ask first.
typedef struct {
    const Vectors *origin;
    Vectors direction;
    alignas(64) double reach[PATHS];
    bool any_found; // otherwise all begin with nothing_found
    Found found[PATHS];
    int missed[PATHS]; // the sphere that a ray leaves, if it certainly misses that, or -BOXES
} Starts;

// Usually a ray certainly misses the sphere that it leaves; or this hides the light from its own
// back. Otherwise, the answer is still UNKNOWN.
static void ask_own(const Rays *rays, Starts *starts, int *answers)
{
    double own[PATHS];
    starts->origin = rays->origin;
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        const Vector v = get(rays->direction, i),
                     p = minus(get(rays->center, i), get(rays->origin, i));
        const double length = sqrt(dot(v, v));
        const Vector u = times(1 / length, v);
        const double reach = rays->grid == NULL ? INFINITY : length;
        put(&starts->direction, i, u);
        starts->reach[i] = reach;
        own[i] = glance(p, rays->radius[i], u, reach);
    }
    for (int i = 0; i < rays->count; i++) {
        const int left = rays->left[i];
        starts->missed[i] = left >= 0 && own[i] == MISSES ? left : -BOXES;
        answers[i] = rays->any && left >= 0 && own[i] == HITS ? left : UNKNOWN;
    }
}

// ---- the giants -------------------------------------------------------------------------------

// Whether any ray may hit a sphere: most rays to a light go away from the ground, or stay inside
// the sky.
static bool may_hit(const double *sphere, const Starts *starts, int count)
{
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < count; i++) {
        const Vector p = minus(vector_at(sphere), get(starts->origin, i));
        any |= glance(p, sphere[3], get(&starts->direction, i), starts->reach[i]) != MISSES;
    }
    return any != 0;
}

// All rays ask the giants.
static void ask_giants(const WideHierarchy *wide, const Rays *rays, Starts *starts, int *answers)
{
    starts->any_found = false;
    for (int place = wide->giants; place < wide->end; place++) {
        const double *sphere = wide->numbers + 4 * (size_t)place;
        double begin[PATHS], end[PATHS];
        if (!may_hit(sphere, starts, rays->count))
            continue;
        for (int i = 0; i < rays->count && !starts->any_found; i++)
            starts->found[i] = nothing_found(starts->reach[i]);
        starts->any_found = true;
#pragma omp simd
        for (int i = 0; i < rays->count; i++) {
            const Vector p = minus(vector_at(sphere), get(starts->origin, i));
            const Meeting meeting = meet(p, sphere[3], get(&starts->direction, i));
            begin[i] = meeting.begin;
            end[i] = meeting.end;
        }
        for (int i = 0; i < rays->count; i++)
            if (place != starts->missed[i])
                learn(&starts->found[i], place, (Meeting){begin[i], end[i]});
    }
    for (int i = 0; i < rays->count && rays->any && starts->any_found; i++)
        if (answers[i] == UNKNOWN && starts->found[i].end < starts->reach[i] * (1 - MARGIN))
            answers[i] = starts->found[i].place;
}

// ---- the cells of a light ---------------------------------------------------------------------

// The cell of each ray's start; -1 if no sphere is there.
static void find_cells(const Bins *bins, const Rays *rays, int *cells)
{
    const Vector f = vector_at(bins->eye.forward), r = vector_at(bins->eye.right);
    const Vector u = vector_at(bins->eye.up);
    const Vector from = {bins->from[0], bins->from[1], bins->from[2]};
    const double size = bins->columns, across = bins->eye.across / SIDE;
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        const Vector p = minus(get(rays->origin, i), from);
        double ahead = dot(p, f), scale = across / ahead;
        double column = size / 2 + scale * dot(p, r), row = size / 2 - scale * dot(p, u);
        bool shown = (ahead > 0) & (column >= 0) & (column < size) & (row >= 0) & (row < size);
        cells[i] = shown ? (int)row * (int)size + (int)column : -1;
    }
}

// Ray i asks a sphere, unless it certainly misses that.
static inline int ask_place(const WideHierarchy *wide, int place, const Starts *starts, int i)
{
    const double *sphere = wide->numbers + 4 * (size_t)place;
    const Vector p = minus(vector_at(sphere), get(starts->origin, i));
    const Vector v = get(&starts->direction, i);
    if (place == starts->missed[i])
        return NO_PLACE;
    const double verdict = glance(p, sphere[3], v, starts->reach[i]);
    return verdict == MISSES ? NO_PLACE : verdict == HITS ? place : UNKNOWN;
}

// The rays about which no giant is in doubt ask the spheres of their cells, as far as they are
// nearer to the light than the start. First all memory that will be needed is asked for, so that no
// ray waits for it.
static void ask_cells(const WideHierarchy *wide, const Rays *rays, Starts *starts, int *answers)
{
    const Item *items = rays->grid->items;
    const BinsShare *bins = &rays->grid->shares[0];
    const Item *shown[PATHS], *end[PATHS];
    int cells[PATHS];
    find_cells(rays->grid, rays, cells);
    for (int i = 0; i < rays->count; i++) {
        shown[i] = &items[cells[i] < 0 ? 0 : bins->begin[cells[i]]];
        end[i] = &items[cells[i] < 0 ? 0 : bins->next[cells[i]]];
        __builtin_prefetch(shown[i]);
        const bool doubt = starts->any_found && starts->found[i].rival <= starts->found[i].end;
        answers[i] = answers[i] == UNKNOWN && !doubt ? NO_PLACE : answers[i];
    }
    for (int i = 0; i < rays->count; i++)
        __builtin_prefetch(&wide->numbers[4 * (size_t)sphere_of(*shown[i])]);
    for (int i = 0; i < rays->count; i++) {
        const float reach = (float)(starts->reach[i] * (1 + 1e-6));
        const Item *at = shown[i];
        for (; at < end[i] && near_of(*at) <= reach && answers[i] == NO_PLACE; at++)
            answers[i] = ask_place(wide, sphere_of(*at), starts, i);
    }
}

// ---- rays on their way ------------------------------------------------------------------------

// A ray on its way: boxes to enter, in no order, and the nearest hit so far. After the last box all
// distances are infinite, and there is room for those of another node.
enum { INDICES = 64, MOST_WAITING = INDICES - BOXES };
typedef struct {
    union {
        alignas(64) float near[MOST_WAITING + BOXES];
        int bits[MOST_WAITING + BOXES]; // the same floats: as ints they have the same order
    };
    int box[MOST_WAITING + BOXES]; // as WideNode's below
    int count;
    Slopes slopes;
    int number; // of the ray
    float farthest;
    bool lost;     // there was no room for all boxes, or the ray has no direction
    int missed;    // a sphere that it certainly does not hit
    double enough; // a hit that certainly ends before this suffices
    Found found;
} Walker;

#ifdef __wasm_simd128__
// For 4 bits, one for each box that a ray enters: the bytes of these boxes, then of the others.
#define BYTES(box) 4 * box, 4 * box + 1, 4 * box + 2, 4 * box + 3
#define ORDER(a, b, c, d)                                                                          \
    {                                                                                              \
        BYTES(a), BYTES(b), BYTES(c), BYTES(d)                                                     \
    }
static const alignas(16) uint8_t entered_first[16][16] = {
    ORDER(0, 1, 2, 3), ORDER(0, 1, 2, 3), ORDER(1, 0, 2, 3), ORDER(0, 1, 2, 3),
    ORDER(2, 0, 1, 3), ORDER(0, 2, 1, 3), ORDER(1, 2, 0, 3), ORDER(0, 1, 2, 3),
    ORDER(3, 0, 1, 2), ORDER(0, 3, 1, 2), ORDER(1, 3, 0, 2), ORDER(0, 1, 3, 2),
    ORDER(2, 3, 0, 1), ORDER(0, 2, 3, 1), ORDER(1, 2, 3, 0), ORDER(0, 1, 2, 3)};
#endif

// Adds the boxes of a node that the ray enters, without an 'if', because no processor can predict
// them. AVX-512 packs them with one instruction, which compilers do not find.
static inline void add_boxes(Walker *walker, const WideNode *node, const float *near)
{
    int count = walker->count;
    if (count > MOST_WAITING) {
        walker->lost = true;
        return;
    }
#ifdef __AVX512F__
    const __m512 found = _mm512_loadu_ps(near), none = _mm512_set1_ps(INFINITY);
    const __mmask16 entered = _mm512_cmp_ps_mask(found, none, _CMP_LT_OQ);
    const __m512i boxes = _mm512_maskz_compress_epi32(entered, _mm512_load_si512(node->below));
    _mm512_storeu_ps(walker->near + count, _mm512_mask_compress_ps(none, entered, found));
    _mm512_storeu_si512(walker->box + count, boxes);
    walker->count = count + __builtin_popcount(entered);
#elif defined __wasm_simd128__
    const v128_t none = wasm_f32x4_splat(INFINITY);
    for (int i = 0; i < BOXES; i += 4) {
        const v128_t found = wasm_v128_load(near + i), boxes = wasm_v128_load(node->below + i);
        const uint32_t entered = wasm_i32x4_bitmask(wasm_f32x4_lt(found, none));
        const v128_t order = wasm_v128_load(entered_first[entered]);
        wasm_v128_store(walker->near + count, wasm_i8x16_swizzle(found, order));
        wasm_v128_store(walker->box + count, wasm_i8x16_swizzle(boxes, order));
        count += __builtin_popcount(entered);
    }
    walker->count = count;
#else
    for (int i = 0; i < BOXES; i++) {
        walker->near[count] = near[i];
        walker->box[count] = node->below[i];
        count += near[i] < INFINITY;
    }
    walker->count = count;
#endif
}

// The last 6 bits of a distance are replaced by its index, so the least number says where it is.
static inline int least_distance(const Walker *walker, int begin, int end)
{
    int least_bits = INT_MAX;
#pragma omp simd reduction(min : least_bits)
    for (int i = begin; i < end; i++) {
        int bits = (walker->bits[i] & -INDICES) | i;
        least_bits = bits < least_bits ? bits : least_bits;
    }
    return least_bits;
}

// Takes the nearest of the boxes that wait, and returns where it begins, infinite if there is none.
// Mostly few wait.
static inline float take_nearest(Walker *walker, int *next)
{
    int nearest_bits = least_distance(walker, 0, BOXES);
    if (walker->count >= BOXES)
        nearest_bits = least(nearest_bits, least_distance(walker, BOXES, INDICES));
    const int at = nearest_bits & (INDICES - 1), last = walker->count - (walker->count > 0);
    const float nearest = walker->near[at];
    *next = walker->box[at];
    walker->near[at] = walker->near[last];
    walker->box[at] = walker->box[last];
    walker->near[last] = INFINITY;
    walker->count = last;
    return nearest;
}

static inline void set_farthest(Walker *walker, const WideHierarchy *wide)
{
    walker->farthest = (float)(walker->found.end * wide->scale) * (1 + 0x1p-18F); // rounded up
}

static inline void meet_place(Walker *walker, const WideHierarchy *wide, int place,
                              const Starts *starts)
{
    const double *sphere = wide->numbers + 4 * (size_t)place;
    const Vector p = minus(vector_at(sphere), get(starts->origin, walker->number));
    const Vector v = get(&starts->direction, walker->number);
    if (learn(&walker->found, place, meet(p, sphere[3], v)))
        set_farthest(walker, wide);
    if (walker->found.end < walker->enough) { // nothing else matters
        walker->farthest = -1;
        walker->found.rival = INFINITY;
    }
}

static int answer_of(const Walker *walker)
{
    const Found *found = &walker->found;
    const bool doubt = found->rival <= found->end && found->rival < INFINITY;
    return walker->lost || doubt ? IN_DOUBT : found->place;
}

// Starts the next ray without an answer. False if there is none.
static inline bool start_next(Walker *walker, const WideHierarchy *wide, const Rays *rays,
                              const Starts *starts, const int *answers, int *started)
{
    while (*started < rays->count && answers[*started] != UNKNOWN)
        (*started)++;
    if (*started == rays->count)
        return false;
    const int i = walker->number = (*started)++;
    for (int k = 0; k < MOST_WAITING + BOXES; k++)
        walker->near[k] = INFINITY;
    walker->count = 0;
    walker->lost = isnan(starts->direction.x[i]);
    walker->found = starts->any_found ? starts->found[i] : nothing_found(starts->reach[i]);
    set_farthest(walker, wide);
    walker->enough = rays->any ? starts->reach[i] * (1 - MARGIN) : 0;
    walker->missed = starts->missed[i];
    set_slopes(&walker->slopes, wide, get(rays->origin, i), get(&starts->direction, i));
    return true;
}

// One bit for each ray on its way.
enum { WALKERS = 64 };
typedef uint64_t Bits;

// Rays at nodes enter the boxes there.
static inline void leave_nodes(const WideHierarchy *wide, Walker *walkers, const int *next,
                               Bits bits)
{
    for (; bits != 0; bits &= bits - 1) {
        Walker *walker = &walkers[__builtin_ctzll(bits)];
        const WideNode *node = &wide->nodes[next[__builtin_ctzll(bits)]];
        alignas(64) float near[BOXES];
        enter(&walker->slopes, node, walker->farthest, near);
        add_boxes(walker, node, near);
    }
}

// Rays at leaves ask the spheres there.
static inline void leave_leaves(const WideHierarchy *wide, const Starts *starts, Walker *walkers,
                                const int *next, Bits bits)
{
    Bits asking = 0;
    unsigned spheres[WALKERS];
    for (; bits != 0; bits &= bits - 1) {
        int number = __builtin_ctzll(bits);
        const Walker *walker = &walkers[number];
        const WideLeaf *leaf = &wide->leaves[~next[number]];
        unsigned missed = (unsigned)(walker->missed - leaf->first); // its place in this leaf
        spheres[number] = may_meet(&walker->slopes, leaf, walker->farthest) &
                          ~(missed < BOXES ? 1U << missed : 0);
        asking |= (Bits)(spheres[number] != 0) << number;
    }
    for (; asking != 0; asking &= asking - 1) {
        int number = __builtin_ctzll(asking);
        Walker *walker = &walkers[number];
        const int first = wide->leaves[~next[number]].first;
        for (unsigned found = spheres[number]; found != 0; found &= found - 1)
            meet_place(walker, wide, first + __builtin_ctz(found), starts);
    }
}

// Each round takes all rays a step: those at a node enter its boxes, those at a leaf ask its
// spheres, and then all go to their nearest box. Each loop does one short thing, for all rays that
// need it. So no ray waits for itself, and where it goes need not be predicted. A ray that ends
// gives its answer, and the next one starts in its place.
void LANES(nearest_of_many)(const WideHierarchy *wide, const Rays *rays, int *places)
{
    Walker walkers[WALKERS];
    Starts starts;
    int next[WALKERS] = {0}, started = 0;
    Bits going = 0, leaves = 0;
    for (int i = 0; i < rays->count; i++)
        places[i] = NO_PLACE;
    ask_own(rays, &starts, places);
    ask_giants(wide, rays, &starts, places);
    if (rays->grid != NULL && rays->grid->items != NULL)
        ask_cells(wide, rays, &starts, places);
    while (wide->nodes == NULL &&
           start_next(&walkers[0], wide, rays, &starts, places, &started)) // there are only giants
        places[walkers[0].number] = answer_of(&walkers[0]);
    for (int i = 0; i < WALKERS; i++)
        if (start_next(&walkers[i], wide, rays, &starts, places, &started))
            going |= (Bits)1 << i;
    while (going != 0) {
        leave_nodes(wide, walkers, next, going & ~leaves);
        leave_leaves(wide, &starts, walkers, next, leaves);
        Bits ended = 0;
        leaves = 0;
        for (Bits bits = going; bits != 0; bits &= bits - 1) {
            int i = __builtin_ctzll(bits);
            bool ends = !(take_nearest(&walkers[i], &next[i]) < walkers[i].farthest);
            ended |= (Bits)ends << i;
            leaves |= (Bits)(!ends & (next[i] < 0)) << i;
        }
        for (; ended != 0; ended &= ended - 1) {
            int i = __builtin_ctzll(ended);
            places[walkers[i].number] = answer_of(&walkers[i]);
            next[i] = 0;
            if (!start_next(&walkers[i], wide, rays, &starts, places, &started))
                going &= ~((Bits)1 << i);
        }
    }
}
