// hierarchy.c - builds a bounding volume hierarchy: chooses where to split, and splits.
//
// The choice needs no exact numbers: it is made in floats, four at a time (x, y, z and the radius).
// The boxes of the nodes are made afterwards, from the bottom up, in double. The first splits make
// enough parts for all threads. Each part is then built by one thread.
#include "chapters/08-fast/engines/hierarchy.h"

#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// BINS: the number of slices along an axis; FEW_BINS are enough for SMALL nodes. Nodes deeper than
// DEEP are simply halved, so that none is deeper than HIERARCHY_DEEPEST. PARTS: at least this many
// for each thread.
enum { BINS = 16, FEW_BINS = 8, SMALL = 32, DEEP = 64, PARTS = 16, SMALLEST_PART = 1024 };

typedef float Four __attribute__((vector_size(16)));
typedef int FourInts __attribute__((vector_size(16)));

static inline Four lower(Four a, Four b)
{
    for (int i = 0; i < 4; i++)
        a[i] = a[i] < b[i] ? a[i] : b[i];
    return a;
}

static inline Four higher(Four a, Four b)
{
    for (int i = 0; i < 4; i++)
        a[i] = a[i] > b[i] ? a[i] : b[i];
    return a;
}

typedef struct {
    Four low, high;
} Bounds;

static const Bounds nothing = {{INFINITY, INFINITY, INFINITY, INFINITY},
                               {-INFINITY, -INFINITY, -INFINITY, -INFINITY}};

static inline void include(Bounds *bounds, Four low, Four high)
{
    bounds->low = lower(bounds->low, low);
    bounds->high = higher(bounds->high, high);
}

static inline float surface(const Bounds *bounds)
{
    Four size = bounds->high - bounds->low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

// Spheres that a thread builds a part of the hierarchy from.
typedef struct {
    int first, count, depth;
    Bounds centers;
    Node *nodes; // room for 2 count - 1
    int node_count;
} Part;

// A node above the parts, or a part.
typedef struct {
    int first, count, axis;
    int part; // its number; -1: a node
} Above;

typedef struct {
    const Scene *scene;
    int *order;
    Four *items; // centre and radius of each, in this order, as parts of the scene's size
    Node *nodes; // room for the nodes of all parts
    Part *parts;
    Above *above; // each before those below it
    int part_count, above_count;
    int largest_part, leaf; // spheres
} Builder;

// ---- where to split ---------------------------------------------------------------------------

typedef struct {
    Four low, scale; // bin = (centre - low) * scale
    int axis, bin;   // the first bin of the second child
    float cost;      // spheres times surface, both children
} Split;

static inline FourInts bins_of(const Split *split, Four item)
{
    return __builtin_convertvector((item - split->low) * split->scale, FourInts);
}

// The cheapest split along the axis number axis, of the bins of this axis.
static void best_along(Split *split, int axis, const Bounds *boxes, const int *counts, int bins)
{
    // From the right: the cost of the second child. Then from the left: both together.
    float right[BINS];
    Bounds box = nothing;
    int from_right = 0, from_left = 0;
    for (int i = bins - 1; i > 0; i--) {
        include(&box, boxes[i].low, boxes[i].high);
        from_right += counts[i];
        right[i] = from_right > 0 ? (float)from_right * surface(&box) : 0;
    }
    box = nothing;
    for (int i = 1; i < bins; i++) {
        include(&box, boxes[i - 1].low, boxes[i - 1].high);
        from_left += counts[i - 1];
        float cost = (float)from_left * surface(&box) + right[i];
        if (from_left > 0 && right[i] > 0 && cost < split->cost) {
            split->cost = cost;
            split->axis = axis;
            split->bin = i;
        }
    }
}

// The cheapest split along any axis; its cost is infinite if all centres are in one place.
static Split best_split(const Four *items, int count, Bounds centers)
{
    int bins = count < SMALL ? FEW_BINS : BINS;
    Four size = centers.high - centers.low;
    Split split = {.low = centers.low, .cost = INFINITY};
    // A little less, so that the largest centre is in the last bin.
    for (int axis = 0; axis < 3; axis++)
        split.scale[axis] = size[axis] > 1e-30F ? 0.999999F * (float)bins / size[axis] : 0;

    Bounds boxes[3][BINS];
    int counts[3][BINS] = {0};
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < bins; i++)
            boxes[axis][i] = nothing;
    for (int i = 0; i < count; i++) {
        Four item = items[i], radius = (Four){0} + item[3];
        Four low = item - radius, high = item + radius;
        FourInts bin = bins_of(&split, item);
        for (int axis = 0; axis < 3; axis++) {
            include(&boxes[axis][bin[axis]], low, high);
            counts[axis][bin[axis]]++;
        }
    }
    for (int axis = 0; axis < 3; axis++)
        if (split.scale[axis] > 0)
            best_along(&split, axis, boxes[axis], counts[axis], bins);
    return split;
}

// ---- splitting --------------------------------------------------------------------------------

// Moves the spheres before the split to the front; returns their number. centers: of both children.
static int partition(Four *items, int *order, int count, const Split *split, Bounds centers[2])
{
    int front = 0, back = count - 1;
    centers[0] = centers[1] = nothing;
    while (front <= back) {
        Four item = items[front];
        if (bins_of(split, item)[split->axis] < split->bin) {
            include(&centers[0], item, item);
            front++;
        } else {
            include(&centers[1], item, item);
            int index = order[front];
            items[front] = items[back];
            order[front] = order[back];
            items[back] = item;
            order[back--] = index;
        }
    }
    return front;
}

static int halve(const Four *items, int count, Bounds centers[2])
{
    int half = count / 2;
    centers[0] = centers[1] = nothing;
    for (int i = 0; i < count; i++)
        include(&centers[i >= half], items[i], items[i]);
    return half;
}

// Splits spheres in two; returns the number of the first ones, 0 if they should stay together.
static int split_in_two(const Builder *builder, const Part *part, Bounds centers[2], int *axis)
{
    Four *items = builder->items + part->first;
    *axis = 0;
    if (part->count <= builder->leaf)
        return 0;
    Split split = best_split(items, part->count, part->centers);
    if (!(split.cost < INFINITY) || part->depth >= DEEP)
        return halve(items, part->count, centers);
    *axis = split.axis;
    return partition(items, builder->order + part->first, part->count, &split, centers);
}

static Box around(const Builder *builder, int first, int count)
{
    Box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = first; i < first + count; i++) {
        Sphere sphere = builder->scene->spheres[builder->order[i]];
        for (int axis = 0; axis < 3; axis++) {
            double c = sphere.center[axis], r = sphere.radius;
            double more = r + 1e-6 * r + 1e-12 * fabs(c);
            box.low[axis] = c - more < box.low[axis] ? c - more : box.low[axis];
            box.high[axis] = c + more > box.high[axis] ? c + more : box.high[axis];
        }
    }
    return box;
}

static Box around_both(const Box *a, const Box *b)
{
    Box box = *a;
    for (int i = 0; i < 3; i++) {
        box.low[i] = b->low[i] < box.low[i] ? b->low[i] : box.low[i];
        box.high[i] = b->high[i] > box.high[i] ? b->high[i] : box.high[i];
    }
    return box;
}

// Builds a part, or what is below one of its nodes.
static void build(const Builder *builder, Part *part)
{
    Node *node = &part->nodes[part->node_count++];
    *node = (Node){.first = part->first, .count = part->count};
    Bounds centers[2];
    int half = split_in_two(builder, part, centers, &node->axis);
    if (half == 0) {
        node->box = around(builder, part->first, part->count);
        return;
    }
    Part below = *part;
    below.depth++;
    below.count = half;
    below.centers = centers[0];
    build(builder, &below);
    node->other = below.node_count;
    below.first += half;
    below.count = part->count - half;
    below.centers = centers[1];
    build(builder, &below);
    part->node_count = below.node_count;
    node->box = around_both(&node[1].box, &part->nodes[node->other].box);
}

static void build_part(void *given, int number)
{
    Builder *builder = given;
    build(builder, &builder->parts[number]);
}

// ---- the parts, and the nodes above them ------------------------------------------------------

// Splits until the parts are small enough. Nodes above them: the first child is the next one.
static void divide(Builder *builder, Part part)
{
    Above *above = &builder->above[builder->above_count++];
    *above = (Above){.first = part.first, .count = part.count, .part = -1};
    Bounds centers[2];
    int half = 0;
    if (part.count > builder->largest_part && part.depth < DEEP)
        half = split_in_two(builder, &part, centers, &above->axis);
    if (half == 0) {
        above->part = builder->part_count;
        part.nodes = builder->nodes + 2 * (size_t)part.first;
        builder->parts[builder->part_count++] = part;
        return;
    }
    Part below = part;
    below.depth++;
    below.count = half;
    below.centers = centers[0];
    divide(builder, below);
    below.first += half;
    below.count = part.count - half;
    below.centers = centers[1];
    divide(builder, below);
}

// Puts the next of these nodes and all that is below it into the hierarchy.
static void join(const Builder *builder, int *next, Hierarchy *hierarchy)
{
    const Above *above = &builder->above[(*next)++];
    int number = hierarchy->node_count;
    Node *node = &hierarchy->nodes[number];
    if (above->part >= 0) {
        const Part *part = &builder->parts[above->part];
        memcpy(node, part->nodes, (size_t)part->node_count * sizeof *node);
        for (int i = 0; i < part->node_count; i++)
            if (node[i].other != 0)
                node[i].other += number;
        hierarchy->node_count += part->node_count;
        return;
    }
    hierarchy->node_count++;
    join(builder, next, hierarchy);
    int other = hierarchy->node_count;
    join(builder, next, hierarchy);
    *node = (Node){.box = around_both(&node[1].box, &hierarchy->nodes[other].box),
                   .first = above->first,
                   .count = above->count,
                   .other = other,
                   .axis = above->axis};
}

// ---- the whole --------------------------------------------------------------------------------

static double extent(const Scene *scene, double low[3])
{
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
        double high = -INFINITY;
        low[axis] = INFINITY;
        for (int i = 0; i < scene->sphere_count; i++) {
            double c = scene->spheres[i].center[axis];
            low[axis] = c < low[axis] ? c : low[axis];
            high = c > high ? c : high;
        }
        size = high - low[axis] > size ? high - low[axis] : size;
    }
    return size;
}

// All spheres as one part.
static Part all_items(Builder *builder)
{
    const Scene *scene = builder->scene;
    Part all = {.count = scene->sphere_count, .centers = nothing};
    double low[3], size = extent(scene, low), scale = size > 0 ? 1 / size : 1;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        Four item;
        for (int axis = 0; axis < 3; axis++)
            item[axis] = (float)((sphere->center[axis] - low[axis]) * scale);
        // Squares of what is larger would not be floats.
        double radius = sphere->radius * scale;
        item[3] = (float)(radius < 1e15 ? radius : 1e15);
        builder->items[i] = item;
        builder->order[i] = i;
        include(&all.centers, item, item);
    }
    return all;
}

static bool build_all(Builder *builder, Hierarchy *hierarchy, int threads)
{
    divide(builder, all_items(builder));
    in_parallel(threads, builder->part_count, build_part, builder);
    int nodes = builder->above_count, next = 0;
    for (int i = 0; i < builder->part_count; i++)
        nodes += builder->parts[i].node_count;
    hierarchy->nodes = large_memory((size_t)nodes * sizeof(Node));
    if (hierarchy->nodes != NULL)
        join(builder, &next, hierarchy);
    return hierarchy->nodes != NULL;
}

bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene, int leaf, int threads)
{
    size_t count = (size_t)scene->sphere_count;
    int share = scene->sphere_count / (PARTS * threads) + 1;
    Builder builder = {.scene = scene,
                       .leaf = leaf,
                       .largest_part = share > SMALLEST_PART ? share : SMALLEST_PART};
    // On each level few nodes are larger than that.
    size_t most = (DEEP + 1) * (count / (size_t)builder.largest_part + 1) + 1;
    builder.order = large_memory((count + 1) * sizeof *builder.order);
    builder.items = large_memory((count + 1) * sizeof *builder.items);
    builder.nodes = malloc((2 * count + 1) * sizeof *builder.nodes);
    builder.parts = malloc(most * sizeof *builder.parts);
    builder.above = malloc(2 * most * sizeof *builder.above);
    *hierarchy = (Hierarchy){.order = builder.order};
    bool built = builder.order != NULL && builder.items != NULL && builder.nodes != NULL &&
                 builder.parts != NULL && builder.above != NULL &&
                 build_all(&builder, hierarchy, threads);
    free(builder.items);
    free(builder.nodes);
    free(builder.parts);
    free(builder.above);
    if (!built)
        hierarchy_free(hierarchy);
    return built;
}

void hierarchy_free(Hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    *hierarchy = (Hierarchy){0};
}
