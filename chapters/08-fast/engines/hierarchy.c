// hierarchy.c - builds a bounding volume hierarchy: chooses where to split, and splits.
#include "chapters/08-fast/engines/hierarchy.h"

#include "chapters/08-fast/engines/large_memory.h"

#include <math.h>
#include <stdlib.h>

// BINS: the number of slices along an axis. LEAF: more spheres than these are split even if that
// costs more. Deeper than DEEP they are simply halved, so that no node is deeper than
// HIERARCHY_DEEPEST.
enum { BINS = 16, LEAF = 4, DEEP = 64 };

typedef struct {
    Hierarchy *hierarchy;
    const Sphere *spheres;
} Builder;

static const Box nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

// Not fmin and fmax: their rules for NaN cost a function call.
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static Box around_both(Box a, Box b)
{
    for (int i = 0; i < 3; i++) {
        a.low[i] = smaller(a.low[i], b.low[i]);
        a.high[i] = larger(a.high[i], b.high[i]);
    }
    return a;
}

static Box around_sphere(Sphere sphere)
{
    Box box;
    for (int i = 0; i < 3; i++) {
        double more = 1e-6 * sphere.radius + 1e-12 * fabs(sphere.center[i]);
        box.low[i] = sphere.center[i] - sphere.radius - more;
        box.high[i] = sphere.center[i] + sphere.radius + more;
    }
    return box;
}

// ---- where to split ---------------------------------------------------------------------------

typedef struct {
    int axis;
    double low, scale; // bin = (center - low) * scale
    int bin;           // the first bin of the second child
    double cost;       // spheres times surface, both children
} Split;

static int bin_of(Split split, Sphere sphere)
{
    int bin = (int)((sphere.center[split.axis] - split.low) * split.scale);
    return bin < BINS ? bin : BINS - 1;
}

// The cheapest split along an axis; its cost is infinite if all centres are in one place.
static Split best_split_along(const Builder *builder, int axis, int first, int count)
{
    const int *order = builder->hierarchy->order + first;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < count; i++) {
        low = smaller(low, builder->spheres[order[i]].center[axis]);
        high = larger(high, builder->spheres[order[i]].center[axis]);
    }
    Split split = {axis, low, BINS / (high - low), 0, INFINITY};
    if (!(high > low) || !isfinite(split.scale))
        return split;

    Box boxes[BINS];
    int counts[BINS] = {0};
    for (int i = 0; i < BINS; i++)
        boxes[i] = nothing;
    for (int i = 0; i < count; i++) {
        Sphere sphere = builder->spheres[order[i]];
        int bin = bin_of(split, sphere);
        boxes[bin] = around_both(boxes[bin], around_sphere(sphere));
        counts[bin]++;
    }
    // From the right: the cost of the second child. Then from the left: the cost of both together.
    double right[BINS];
    Box box = nothing;
    for (int i = BINS - 1, n = 0; i > 0; i--) {
        box = around_both(box, boxes[i]);
        n += counts[i];
        right[i] = n * box_surface(&box);
    }
    box = nothing;
    for (int i = 1, n = 0; i < BINS; i++) {
        box = around_both(box, boxes[i - 1]);
        n += counts[i - 1];
        double cost = n * box_surface(&box) + right[i];
        if (n > 0 && n < count && cost < split.cost) {
            split.cost = cost;
            split.bin = i;
        }
    }
    return split;
}

// ---- splitting --------------------------------------------------------------------------------

// Moves the spheres before the split to the front; returns their number.
static int partition(const Builder *builder, Split split, int first, int count)
{
    int *order = builder->hierarchy->order;
    int front = first, back = first + count - 1;
    while (front <= back) {
        if (bin_of(split, builder->spheres[order[front]]) < split.bin) {
            front++;
        } else {
            int other = order[back];
            order[back--] = order[front];
            order[front] = other;
        }
    }
    return front - first;
}

static void build(const Builder *builder, int first, int count, int depth)
{
    Hierarchy *hierarchy = builder->hierarchy;
    Node *node = &hierarchy->nodes[hierarchy->node_count++];
    *node = (Node){.box = nothing, .first = first, .count = count};
    for (int i = first; i < first + count; i++)
        node->box = around_both(node->box, around_sphere(builder->spheres[hierarchy->order[i]]));
    if (count <= 1)
        return;
    Split split = {.cost = INFINITY};
    for (int axis = 0; axis < 3; axis++) {
        Split other = best_split_along(builder, axis, first, count);
        if (other.cost < split.cost)
            split = other;
    }
    // A step down costs about as much as one sphere.
    bool worth = split.cost + box_surface(&node->box) < count * box_surface(&node->box);
    if (count <= LEAF && !worth)
        return;
    int half =
        isfinite(split.cost) && depth < DEEP ? partition(builder, split, first, count) : count / 2;
    node->axis = split.axis;
    build(builder, first, half, depth + 1);
    node->other = hierarchy->node_count;
    build(builder, first + half, count - half, depth + 1);
}

bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene)
{
    size_t count = (size_t)scene->sphere_count;
    *hierarchy = (Hierarchy){.nodes = large_memory((2 * count + 1) * sizeof(Node)),
                             .order = large_memory((count + 1) * sizeof(int))};
    if (hierarchy->nodes == NULL || hierarchy->order == NULL) {
        hierarchy_free(hierarchy);
        return false;
    }
    for (int i = 0; i < scene->sphere_count; i++)
        hierarchy->order[i] = i;
    Builder builder = {hierarchy, scene->spheres};
    build(&builder, 0, scene->sphere_count, 0);
    return true;
}

void hierarchy_free(Hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    *hierarchy = (Hierarchy){0};
}
