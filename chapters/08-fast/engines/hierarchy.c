// hierarchy.c - builds a bounding volume hierarchy: chooses where to split, and splits.
//
// The choice needs no exact numbers: it is made in floats, four at a time (x, y, z and the radius).
// The first splits are chosen from a sample of the spheres. They make parts, and every sphere finds
// its part. Each part is then split by one thread. At last, from the bottom up, the nodes get their
// boxes, in double. The hierarchy does not depend on the number of threads.
#include "chapters/08-fast/engines/hierarchy.h"

#include "chapters/08-fast/engines/parallel.h"
#include "common/large_pages.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// BINS: the number of slices along an axis; FEW_BINS are enough for SMALL nodes. Nodes deeper than
// DEEP are simply halved, so that none is deeper than HIERARCHY_DEEPEST. CHUNK: spheres that find
// their part, by one thread.
enum { BINS = 16, FEW_BINS = 8, SMALL = 32, DEEP = 64 };
enum { AT_ONCE = 8, PARTS = 64, SMALLEST_PART = 1024, SAMPLES = 1 << 15, CHUNK = 1 << 13 };

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

// A node without its box. Its children are the next one and number other of the part.
typedef struct {
    int first, count, other, axis;
} Shape;

// Spheres that one thread splits further.
typedef struct {
    int first, count, depth;
    int leaf; // its number among the nodes above
    // Centre and radius of each sphere, as parts of the scene's size, in its order. They are where
    // the numbers of these spheres are put afterwards.
    Four *items;
    Shape *shapes; // room for 2 count - 1
    int shape_count;
} Part;

// A node above the parts, or the first one of a part. Spheres whose centre is before the plane are
// below its first child.
typedef struct {
    int axis;
    float plane;
    int below[2]; // if it belongs to a part, itself
    int part;     // -1: none
    int node;     // its number in the hierarchy
} Above;

// Some spheres, as they are in the scene.
typedef struct {
    vec3 low, high;    // the lowest and the highest coordinates of their centres
    int largest;       // the number of the largest sphere
    int counts[PARTS]; // spheres in each part; then the place of the next one
} Chunk;

typedef struct {
    const Scene *scene;
    Hierarchy *hierarchy;
    Shape *shapes;    // room for those of all parts
    uint8_t *part_of; // each of the scene's spheres
    Chunk *chunks;
    vec3 low; // the lowest coordinates of all centres
    double scale;
    Above above[2 * PARTS]; // each before those below it
    Part parts[PARTS];
    int chunk_count, part_count, above_count;
    int leaf;    // spheres in a leaf
    int deepest; // of the parts
} Builder;

// ---- where to split ---------------------------------------------------------------------------

// Before the plane, and the others.
typedef struct {
    int axis;
    float plane;
    float cost; // spheres times surface, both children
} Split;

static Bounds bounds_of(const Four *items, int count)
{
    Bounds bounds = nothing;
    for (int i = 0; i < count; i++)
        include(&bounds, items[i], items[i]);
    return bounds;
}

// A slice along an axis: the spheres whose centres are in it.
typedef struct {
    Bounds box;
    int count;
} Bin;

static inline void put(Bin *bin, Four low, Four high)
{
    include(&bin->box, low, high);
    bin->count++;
}

// The number of the cheapest first bin of the second child, along one axis; 0 if none is cheaper
// than cost.
static int best_along(float *cost, const Bin *bins, int count)
{
    // From the right: the cost of the second child. Then from the left: both together.
    float right[BINS];
    Bounds box = nothing;
    int from_right = 0, from_left = 0, best = 0;
    for (int i = count - 1; i > 0; i--) {
        include(&box, bins[i].box.low, bins[i].box.high);
        from_right += bins[i].count;
        right[i] = from_right > 0 ? (float)from_right * surface(&box) : 0;
    }
    box = nothing;
    for (int i = 1; i < count; i++) {
        include(&box, bins[i - 1].box.low, bins[i - 1].box.high);
        from_left += bins[i - 1].count;
        float both = (float)from_left * surface(&box) + right[i];
        if (from_left > 0 && right[i] > 0 && both < *cost) {
            *cost = both;
            best = i;
        }
    }
    return best;
}

// The cheapest split along any axis; its cost is infinite if all centres are in one place.
static Split best_split(const Four *items, int count)
{
    int bin_count = count < SMALL ? FEW_BINS : BINS;
    Bounds centers = bounds_of(items, count);
    Four size = centers.high - centers.low, scale = {0};
    // A little less, so that the largest centre is in the last bin.
    for (int axis = 0; axis < 3; axis++)
        scale[axis] = size[axis] > 1e-30F ? 0.999999F * (float)bin_count / size[axis] : 0;

    Bin bins[3][BINS];
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < bin_count; i++)
            bins[axis][i] = (Bin){nothing, 0};
    for (int i = 0; i < count; i++) {
        Four item = items[i], radius = (Four){0} + item[3];
        Four low = item - radius, high = item + radius;
        FourInts bin = __builtin_convertvector((item - centers.low) * scale, FourInts);
        put(&bins[0][bin[0]], low, high);
        put(&bins[1][bin[1]], low, high);
        put(&bins[2][bin[2]], low, high);
    }
    Split split = {.cost = INFINITY};
    for (int axis = 0; axis < 3; axis++) {
        int bin = scale[axis] > 0 ? best_along(&split.cost, bins[axis], bin_count) : 0;
        if (bin > 0) {
            split.axis = axis;
            split.plane = centers.low[axis] + (float)bin / scale[axis];
        }
    }
    return split;
}

// Moves the spheres before the plane to the front; returns their number. Without a branch, because
// no processor can guess it: every sphere changes places with the first one that is not before the
// plane.
static int partition(Four *items, int *order, int count, Split split)
{
    int front = 0;
    for (int i = 0; i < count; i++) {
        float center = items[i][split.axis];
        Four item = items[i];
        int index = order[i];
        items[i] = items[front];
        order[i] = order[front];
        items[front] = item;
        order[front] = index;
        front += center < split.plane;
    }
    return front;
}

// Splits spheres in two; returns the number of the first ones, 0 if they cannot be told apart.
static int split_in_two(Four *items, int *order, int count, Split *split)
{
    *split = best_split(items, count);
    int half = split->cost < INFINITY ? partition(items, order, count, *split) : 0;
    return half < count ? half : 0;
}

// ---- the parts --------------------------------------------------------------------------------

static Four item_of(const Builder *builder, const Sphere *sphere)
{
    vec3 item = (sphere->center - builder->low) * builder->scale;
    // Squares of what is larger would not be floats.
    double radius = sphere->radius * builder->scale;
    item[3] = radius < 1e15 ? radius : 1e15;
    return __builtin_convertvector(item, Four);
}

static int chunk_end(const Builder *builder, int chunk)
{
    int end = (chunk + 1) * CHUNK, count = builder->scene->sphere_count;
    return end < count ? end : count;
}

static void measure_chunk(void *given, int number)
{
    const Builder *builder = given;
    const Sphere *spheres = builder->scene->spheres;
    int first = number * CHUNK, largest = first;
    vec3 low = spheres[first].center, high = low;
    for (int i = first; i < chunk_end(builder, number); i++) {
        vec3 center = spheres[i].center;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = center[axis] < low[axis] ? center[axis] : low[axis];
            high[axis] = center[axis] > high[axis] ? center[axis] : high[axis];
        }
        largest = spheres[i].radius > spheres[largest].radius ? i : largest;
    }
    builder->chunks[number] = (Chunk){.low = low, .high = high, .largest = largest};
}

static void set_scale(Builder *builder)
{
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < builder->chunk_count; i++) {
            low = fmin(low, builder->chunks[i].low[axis]);
            high = fmax(high, builder->chunks[i].high[axis]);
        }
        builder->low[axis] = low;
        size = fmax(size, high - low);
    }
    builder->scale = size > 0 ? 1 / size : 1;
}

// One sphere of every few, by chance: a regular choice could miss what is regular in the scene. And
// the largest of each chunk, because a large sphere changes much. Returns their number.
static int take_sample(const Builder *builder, Four *samples)
{
    const Scene *scene = builder->scene;
    int step = scene->sphere_count / SAMPLES + 1, count = scene->sphere_count / step;
    uint32_t chance = 1;
    for (int i = 0; i < count; i++) {
        chance = chance * 1664525 + 1013904223; // Knuth, 'The Art of Computer Programming', 3.3.4
        int sphere = i * step + (int)((chance >> 8) % (uint32_t)step);
        samples[i] = item_of(builder, &scene->spheres[sphere]);
    }
    for (int i = 0; i < builder->chunk_count && step > 1; i++)
        samples[count++] = item_of(builder, &scene->spheres[builder->chunks[i].largest]);
    return count;
}

static void part_begin(Builder *builder, int number, Part part)
{
    part.leaf = builder->above_count++;
    builder->above[part.leaf] = (Above){.below = {part.leaf, part.leaf}, .part = number};
    builder->parts[number] = part;
    builder->deepest = part.depth > builder->deepest ? part.depth : builder->deepest;
}

// Splits the largest part of the sample again and again.
static void divide(Builder *builder)
{
    Four *samples = (Four *)builder->hierarchy->numbers; // they are not needed before
    int *order = builder->hierarchy->order, count = take_sample(builder, samples);
    const double each = (builder->scene->sphere_count + 1.0) / (count + 1.0);
    part_begin(builder, builder->part_count++, (Part){.count = count});
    while (builder->part_count < PARTS) {
        int largest = 0;
        for (int i = 1; i < builder->part_count; i++)
            if (builder->parts[i].count > builder->parts[largest].count)
                largest = i;
        Part part = builder->parts[largest];
        Split split;
        int half = 0;
        if (part.count * each > SMALLEST_PART && part.depth < DEEP)
            half = split_in_two(samples + part.first, order, part.count, &split);
        if (half == 0)
            return;
        builder->above[part.leaf] =
            (Above){.axis = split.axis,
                    .plane = split.plane,
                    .below = {builder->above_count, builder->above_count + 1},
                    .part = -1};
        Part other = part;
        part.depth = ++other.depth;
        part.count = half;
        other.first += half;
        other.count -= half;
        part_begin(builder, largest, part);
        part_begin(builder, builder->part_count++, other);
    }
}

// The parts of a few spheres. All go down together: while one waits for a number, others compute.
static void find_parts(const Builder *builder, const Sphere *spheres, int count, uint8_t *parts)
{
    int at[AT_ONCE] = {0};
    float items[AT_ONCE][4];
    for (int i = 0; i < AT_ONCE; i++) {
        Four item = item_of(builder, &spheres[i < count ? i : 0]);
        memcpy(items[i], &item, sizeof item);
    }
    for (int depth = 0; depth < builder->deepest; depth++) {
        for (int i = 0; i < AT_ONCE; i++) {
            const Above *above = &builder->above[at[i]];
            at[i] = above->below[!(items[i][above->axis] < above->plane)];
        }
    }
    for (int i = 0; i < count; i++)
        parts[i] = (uint8_t)builder->above[at[i]].part;
}

static void count_chunk(void *given, int number)
{
    const Builder *builder = given;
    int end = chunk_end(builder, number);
    for (int i = number * CHUNK; i < end; i += AT_ONCE) {
        int count = end - i < AT_ONCE ? end - i : AT_ONCE;
        find_parts(builder, &builder->scene->spheres[i], count, &builder->part_of[i]);
        for (int k = i; k < i + count; k++)
            builder->chunks[number].counts[builder->part_of[k]]++;
    }
}

// The parts below get their places, one after the other.
static void place_parts(Builder *builder, const Above *above, int *next)
{
    if (above->part < 0) {
        place_parts(builder, &builder->above[above->below[0]], next);
        place_parts(builder, &builder->above[above->below[1]], next);
        return;
    }
    Part *part = &builder->parts[above->part];
    part->first = *next;
    for (int i = 0; i < builder->chunk_count; i++) {
        int *of = &builder->chunks[i].counts[above->part], count = *of;
        *of = *next;
        *next += count;
    }
    part->count = *next - part->first;
    part->items = (Four *)(builder->hierarchy->numbers + 4 * (size_t)part->first);
}

static void move_chunk(void *given, int number)
{
    const Builder *builder = given;
    int *next = builder->chunks[number].counts;
    for (int i = number * CHUNK; i < chunk_end(builder, number); i++) {
        const Part *part = &builder->parts[builder->part_of[i]];
        int at = next[builder->part_of[i]]++;
        part->items[at - part->first] = item_of(builder, &builder->scene->spheres[i]);
        builder->hierarchy->order[at] = i;
    }
}

// ---- the nodes --------------------------------------------------------------------------------

// Splits what is in a node of a part, and what is below.
static void split_node(const Builder *builder, Part *part, int first, int count, int depth)
{
    Shape *shape = &part->shapes[part->shape_count++];
    *shape = (Shape){.first = first, .count = count};
    if (count <= builder->leaf)
        return;
    Split split = {0};
    int half = 0;
    if (depth < DEEP)
        half = split_in_two(part->items + (first - part->first), builder->hierarchy->order + first,
                            count, &split);
    half = half > 0 ? half : count / 2;
    shape->axis = split.axis;
    split_node(builder, part, first, half, depth + 1);
    shape->other = part->shape_count;
    split_node(builder, part, first + half, count - half, depth + 1);
}

static void split_part(void *given, int number)
{
    const Builder *builder = given;
    Part *part = &((Builder *)given)->parts[number];
    part->shapes = builder->shapes + 2 * (size_t)part->first;
    split_node(builder, part, part->first, part->count, part->depth);
}

// This one and the nodes below get their numbers.
static void number_nodes(Builder *builder, Above *above, int *next)
{
    above->node = *next;
    if (above->part >= 0) {
        *next += builder->parts[above->part].shape_count;
        return;
    }
    ++*next;
    number_nodes(builder, &builder->above[above->below[0]], next);
    number_nodes(builder, &builder->above[above->below[1]], next);
}

// The spheres of a part in the order of the hierarchy. They come from all over the memory.
static void line_up(const Builder *builder, const Part *part)
{
    enum { AHEAD = 16 };
    const Sphere *spheres = builder->scene->spheres;
    const int *order = builder->hierarchy->order;
    for (int i = part->first, end = i + part->count; i < end; i++) {
        const Sphere *soon = &spheres[order[i + AHEAD < end ? i + AHEAD : i]];
        __builtin_prefetch(&soon->center);
        __builtin_prefetch(&soon->radius);
        const Sphere *sphere = &spheres[order[i]];
        double *numbers = builder->hierarchy->numbers + 4 * (size_t)i;
        for (int axis = 0; axis < 3; axis++)
            numbers[axis] = sphere->center[axis];
        numbers[3] = sphere->radius;
    }
}

static Box around(const double *numbers, int count)
{
    Box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < count; i++, numbers += 4) {
        for (int axis = 0; axis < 3; axis++) {
            double c = numbers[axis], r = numbers[3];
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

// The nodes of a part: the last ones first, because they are below the others.
static void finish_part(void *given, int number)
{
    const Builder *builder = given;
    const Part *part = &builder->parts[number];
    const int begin = builder->above[part->leaf].node;
    Node *nodes = builder->hierarchy->nodes + begin;
    line_up(builder, part);
    for (int i = part->shape_count - 1; i >= 0; i--) {
        Shape shape = part->shapes[i];
        nodes[i] = (Node){.first = shape.first, .count = shape.count, .axis = shape.axis};
        if (shape.other == 0) {
            nodes[i].box =
                around(builder->hierarchy->numbers + 4 * (size_t)shape.first, shape.count);
        } else {
            nodes[i].box = around_both(&nodes[i + 1].box, &nodes[shape.other].box);
            nodes[i].other = begin + shape.other;
        }
    }
}

static void finish_above(const Builder *builder)
{
    Node *nodes = builder->hierarchy->nodes;
    for (int i = builder->above_count - 1; i >= 0; i--) {
        const Above *above = &builder->above[i];
        if (above->part >= 0)
            continue;
        int other = builder->above[above->below[1]].node;
        const Node *first = &nodes[above->node + 1];
        nodes[above->node] = (Node){.box = around_both(&first->box, &nodes[other].box),
                                    .first = first->first,
                                    .count = first->count + nodes[other].count,
                                    .other = other,
                                    .axis = above->axis};
    }
}

// ---- the whole --------------------------------------------------------------------------------

static bool build_all(Builder *builder, int threads)
{
    Hierarchy *hierarchy = builder->hierarchy;
    int placed = 0;
    in_parallel(threads, builder->chunk_count, measure_chunk, builder);
    set_scale(builder);
    divide(builder);
    in_parallel(threads, builder->chunk_count, count_chunk, builder);
    place_parts(builder, builder->above, &placed);
    in_parallel(threads, builder->chunk_count, move_chunk, builder);
    in_parallel(threads, builder->part_count, split_part, builder);
    number_nodes(builder, builder->above, &hierarchy->node_count);
    hierarchy->nodes = large_memory((size_t)hierarchy->node_count * sizeof(Node));
    if (hierarchy->nodes == NULL)
        return false;
    in_parallel(threads, builder->part_count, finish_part, builder);
    finish_above(builder);
    return true;
}

bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene, int leaf, int threads)
{
    const size_t count = (size_t)scene->sphere_count, chunks = (count + CHUNK - 1) / CHUNK;
    *hierarchy = (Hierarchy){.order = large_memory((count + 1) * sizeof *hierarchy->order),
                             .numbers = large_memory((count + 1) * 4 * sizeof(double))};
    Builder builder = {.scene = scene,
                       .hierarchy = hierarchy,
                       .leaf = leaf,
                       .chunk_count = (int)chunks,
                       .chunks = malloc((chunks + 1) * sizeof *builder.chunks),
                       .shapes = malloc((2 * count + 1) * sizeof *builder.shapes),
                       .part_of = malloc(count + 1)};
    bool built = hierarchy->order != NULL && hierarchy->numbers != NULL && builder.chunks != NULL &&
                 builder.shapes != NULL && builder.part_of != NULL && build_all(&builder, threads);
    free(builder.chunks);
    free(builder.shapes);
    free(builder.part_of);
    if (!built)
        hierarchy_free(hierarchy);
    return built;
}

void hierarchy_free(Hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    free(hierarchy->numbers);
    *hierarchy = (Hierarchy){0};
}
