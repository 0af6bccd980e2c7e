// together_lanes.c - 16 rays from anywhere through the hierarchy.
#include "chapters/08-fast/engines/together.h"

#include <math.h>

#define MARGIN 1e-12 // as in any_ray_lanes.c

// The rays in floats, from the start of the first one.
typedef struct {
    alignas(64) float x[LANES];
    float y[LANES], z[LANES];
    float inverse_x[LANES], inverse_y[LANES], inverse_z[LANES];
    float end[LANES]; // a box beyond this is not entered; -1: the ray asks no more
    double base[3], scale;
    float farthest; // of their starts, from the base
    bool backwards[3];
} Way;

static inline float inverse(double d)
{
    float x = (float)d;
    return 1 / (fabsf(x) > 1e-18F ? x : 1e-18F);
}

static void way_of(Way *way, const RayWorld *world, const Lines *lines)
{
    way->base[0] = lines->x[0];
    way->base[1] = lines->y[0];
    way->base[2] = lines->z[0];
    way->scale = world->scale;
    way->backwards[0] = lines->dx[0] < 0;
    way->backwards[1] = lines->dy[0] < 0;
    way->backwards[2] = lines->dz[0] < 0;
    way->farthest = 0;
    for (int i = 0; i < LANES; i++) {
        int from = i < lines->count ? i : 0;
        way->x[i] = (float)((lines->x[from] - way->base[0]) * way->scale);
        way->y[i] = (float)((lines->y[from] - way->base[1]) * way->scale);
        way->z[i] = (float)((lines->z[from] - way->base[2]) * way->scale);
        float away = fabsf(way->x[i]) + fabsf(way->y[i]) + fabsf(way->z[i]);
        way->farthest = away > way->farthest ? away : way->farthest;
        way->inverse_x[i] = inverse(lines->dx[from]);
        way->inverse_y[i] = inverse(lines->dy[from]);
        way->inverse_z[i] = inverse(lines->dz[from]);
        way->end[i] =
            i < lines->count ? (float)(lines->reach[i] * way->scale) * (1 + 0x1p-20F) : -1;
    }
}

// A side of a box from the base; more: what rounding may change.
static inline float side(const Way *way, double at, int axis, float *more)
{
    float x = (float)((at - way->base[axis]) * way->scale);
    float away = fabsf(x) + way->farthest;
    *more = away > *more ? away : *more;
    return x;
}

// Whether any ray enters the box before its end.
static inline bool any_enters(const Way *way, const Box *box)
{
    float more = 0;
    float low_x = side(way, box->low[0], 0, &more), high_x = side(way, box->high[0], 0, &more);
    float low_y = side(way, box->low[1], 1, &more), high_y = side(way, box->high[1], 1, &more);
    float low_z = side(way, box->low[2], 2, &more), high_z = side(way, box->high[2], 2, &more);
    more *= 0x1p-20F;
    low_x -= more, low_y -= more, low_z -= more;
    high_x += more, high_y += more, high_z += more;
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < LANES; i++) {
        float ax = (low_x - way->x[i]) * way->inverse_x[i];
        float bx = (high_x - way->x[i]) * way->inverse_x[i];
        float ay = (low_y - way->y[i]) * way->inverse_y[i];
        float by = (high_y - way->y[i]) * way->inverse_y[i];
        float az = (low_z - way->z[i]) * way->inverse_z[i];
        float bz = (high_z - way->z[i]) * way->inverse_z[i];
        float begin = ax < bx ? ax : bx, end = ax < bx ? bx : ax;
        float begin_y = ay < by ? ay : by, end_y = ay < by ? by : ay;
        float begin_z = az < bz ? az : bz, end_z = az < bz ? bz : az;
        begin = begin_y > begin ? begin_y : begin;
        begin = begin_z > begin ? begin_z : begin;
        begin = begin > 0 ? begin : 0;
        end = end_y < end ? end_y : end;
        end = end_z < end ? end_z : end;
        end = way->end[i] < end ? way->end[i] : end;
        any |= begin <= end;
    }
    return any != 0;
}

// What the rays know so far: the bounds of the nearest certain hit, the lower bound of all others,
// and the place of the nearest.
typedef struct {
    alignas(64) double begin[LANES];
    double end[LANES], rival[LANES], place[LANES];
} Known;

// Whether any ray may meet a sphere before what it knows.
static inline bool any_may_meet(const Lines *lines, const Known *known, const RayWorld *world,
                                int place)
{
    double cx = world->x[place], cy = world->y[place], cz = world->z[place];
    double rr = world->r[place] * world->r[place];
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < LANES; i++) {
        double x = cx - lines->x[i], y = cy - lines->y[i], z = cz - lines->z[i];
        double along = x * lines->dx[i] + y * lines->dy[i] + z * lines->dz[i];
        double pp = x * x + y * y + z * z, margin = MARGIN * (pp + rr);
        double outside = pp - rr - margin, most = rr - pp + along * along + margin;
        double beyond = along - known->end[i];
        beyond = ((beyond > 0) & (outside > 0)) ? beyond : 0;
        any |= (most >= beyond * beyond) & !((along < 0) & (outside > 0));
    }
    return any != 0;
}

// All rays ask a sphere: where may they meet it, and where do they certainly?
static inline void meet(const Lines *lines, Known *known, const RayWorld *world, int place)
{
    double cx = world->x[place], cy = world->y[place], cz = world->z[place];
    double r = world->r[place], rr = r * r;
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        double x = cx - lines->x[i], y = cy - lines->y[i], z = cz - lines->z[i];
        double along = x * lines->dx[i] + y * lines->dy[i] + z * lines->dz[i];
        double pp = x * x + y * y + z * z, margin = MARGIN * (pp + rr), out = pp - rr;
        double most = rr - pp + along * along + margin, least = most - 2 * margin;
        double longest = sqrt(most > 0 ? most : 0), shortest = sqrt(least > 0 ? least : 0);
        double slack = MARGIN * (fabs(along) + r);
        double side = out > 0 ? -1 : 1; // from outside the first root, from inside the second
        double one = along + side * longest, other = along + side * shortest;
        double begin = (one < other ? one : other) - slack;
        double end = (one < other ? other : one) + slack;
        bool certain = (fabs(out) > margin) & (least >= 0) & (begin > 0);
        bool misses = (most < 0) | ((out > margin) & (along < 0));
        begin = fabs(out) > margin && begin > 0 ? begin : 0;
        begin = misses ? INFINITY : begin;
        end = (certain & !misses) ? end : INFINITY;
        bool wins = end < known->end[i];
        double loser = wins ? known->begin[i] : begin;
        known->begin[i] = wins ? begin : known->begin[i];
        known->end[i] = wins ? end : known->end[i];
        known->place[i] = wins ? place : known->place[i];
        known->rival[i] = loser < known->rival[i] ? loser : known->rival[i];
    }
}

// Rays that are not asked know something that nothing can be nearer than.
static void know(Known *known, const Lines *lines)
{
    for (int i = 0; i < LANES; i++) {
        known->begin[i] = known->rival[i] = INFINITY;
        known->end[i] = i < lines->count ? lines->reach[i] * (1 + MARGIN) : -1;
        known->place[i] = -1;
    }
}

// Nodes still to enter, the next one last.
typedef struct {
    int waiting[HIERARCHY_DEEPEST + 1], count;
} Stack;

static void begin(const RayWorld *world, const Lines *lines, Way *way, Known *known, Stack *stack)
{
    way_of(way, world, lines);
    know(known, lines);
    stack->waiting[0] = 0;
    stack->count = world->nodes != NULL;
}

// The next leaf that any ray enters; NULL at the end.
static inline const Node *next_leaf(const Way *way, const Node *nodes, Stack *stack)
{
    while (stack->count > 0) {
        int number = stack->waiting[--stack->count];
        const Node *node = &nodes[number];
        if (!any_enters(way, &node->box))
            continue;
        if (node->other == 0)
            return node;
        bool swap = way->backwards[node->axis];
        stack->waiting[stack->count++] = swap ? number + 1 : node->other;
        stack->waiting[stack->count++] = swap ? node->other : number + 1;
    }
    return NULL;
}

void LANES(nearest_of_lines)(const RayWorld *world, const Node *nodes, const Lines *lines,
                             Answers *answers)
{
    Way way;
    Known known;
    Stack stack;
    begin(world, lines, &way, &known, &stack);
    for (const Node *leaf; (leaf = next_leaf(&way, nodes, &stack)) != NULL;) {
        for (int place = leaf->first; place < leaf->first + leaf->count; place++) {
            if (!any_may_meet(lines, &known, world, place))
                continue;
            meet(lines, &known, world, place);
#pragma omp simd
            for (int i = 0; i < LANES; i++)
                way.end[i] = (float)(known.end[i] * way.scale) * (1 + 0x1p-20F);
        }
    }
    answers->hit = answers->doubt = 0;
    for (int i = 0; i < lines->count; i++) {
        bool doubt = known.rival[i] <= known.end[i] && known.rival[i] < INFINITY;
        answers->places[i] = (int)known.place[i];
        answers->doubt |= (unsigned)doubt << i;
        answers->hit |= (unsigned)(known.place[i] >= 0 && !doubt) << i;
    }
}

void LANES(any_of_lines)(const RayWorld *world, const Node *nodes, const Lines *lines,
                         Answers *answers)
{
    Way way;
    Known known;
    Stack stack;
    begin(world, lines, &way, &known, &stack);
    unsigned asking = (1U << lines->count) - 1;
    answers->hit = answers->doubt = 0;
    for (const Node *leaf; asking != 0 && (leaf = next_leaf(&way, nodes, &stack)) != NULL;) {
        for (int place = leaf->first; place < leaf->first + leaf->count; place++) {
            if (!any_may_meet(lines, &known, world, place))
                continue;
            meet(lines, &known, world, place);
            for (int i = 0; i < lines->count; i++) {
                if ((asking >> i & 1) == 0 || known.place[i] < 0 ||
                    !(known.end[i] < lines->reach[i] * (1 - MARGIN)))
                    continue;
                answers->hit |= 1U << i;
                asking &= ~(1U << i);
                way.end[i] = -1;
                known.end[i] = -1;
            }
        }
    }
    // A ray that may meet something, but hits nothing for certain, is in doubt.
    for (int i = 0; i < lines->count; i++)
        if ((asking >> i & 1) != 0 &&
            (known.place[i] >= 0 || known.rival[i] < lines->reach[i] * (1 + MARGIN)))
            answers->doubt |= 1U << i;
}
