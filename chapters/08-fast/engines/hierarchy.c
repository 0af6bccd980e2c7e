// hierarchy.c - builds a bounding volume hierarchy: chooses where to split, and splits.
//
// The choice needs no exact numbers: it is made in floats, four at a time (x, y, z and the radius).
// At last, from the bottom up, the nodes get their boxes, in double.
#include "chapters/08-fast/engines/hierarchy.h"

#include <math.h>
#include <stdlib.h>

// BINS: the number of slices along an axis; FEW_BINS are enough for SMALL nodes. Nodes deeper than
// DEEP are simply halved, so that none is deeper than HIERARCHY_DEEPEST.
enum { BINS = 16, FEW_BINS = 8, SMALL = 32, DEEP = 64 };

typedef struct {
    Four low, high;
} Bounds;

static const Bounds nothing = {{INFINITY, INFINITY, INFINITY, INFINITY},
                               {-INFINITY, -INFINITY, -INFINITY, -INFINITY}};

static inline void include(Bounds *bounds, Four low, Four high)
{
    for (int i = 0; i < 4; i++) {
        bounds->low[i] = low[i] < bounds->low[i] ? low[i] : bounds->low[i];
        bounds->high[i] = high[i] > bounds->high[i] ? high[i] : bounds->high[i];
    }
}

static inline float surface(const Bounds *bounds)
{
    Four size = bounds->high - bounds->low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

// ---- where to split ---------------------------------------------------------------------------

// Before the plane, and the others.
typedef struct {
    int axis;
    float plane;
    float cost; // spheres times surface, both children
} Split;

// A slice along an axis: the spheres whose centers are in it.
typedef struct {
    Bounds box;
    int count;
} Bin;

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

// The cheapest split along any axis; its cost is infinite if all centers are in one place. Items
// are centers and radii.
static Split best_split(const Four *items, int count)
{
    int bin_count = count < SMALL ? FEW_BINS : BINS;
    Bounds centers = nothing;
    for (int i = 0; i < count; i++)
        include(&centers, items[i], items[i]);
    Four size = centers.high - centers.low, scale = {0};
    // A little less, so that the largest center is in the last bin.
    for (int axis = 0; axis < 3; axis++)
        scale[axis] = size[axis] > 1e-30F ? 0.999999F * (float)bin_count / size[axis] : 0;

    Bin bins[3][BINS];
    for (int i = 0; i < 3 * bin_count; i++)
        bins[i / bin_count][i % bin_count] = (Bin){nothing, 0};
    for (int i = 0; i < count; i++) {
        Four radius = (Four){0} + items[i][3];
        FourInts bin = __builtin_convertvector((items[i] - centers.low) * scale, FourInts);
        for (int axis = 0; axis < 3; axis++) {
            include(&bins[axis][bin[axis]].box, items[i] - radius, items[i] + radius);
            bins[axis][bin[axis]].count++;
        }
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
        Four item = items[i];
        int index = order[i];
        items[i] = items[front];
        order[i] = order[front];
        items[front] = item;
        order[front] = index;
        front += item[split.axis] < split.plane;
    }
    return front;
}

// The giants are not before the plane: of the fourth numbers, the radii. Without one giant, others
// stand out.
static Split split_giants(const Four *items, int count)
{
    Split split = {.axis = 3, .plane = INFINITY};
    for (;;) {
        Bounds centers = nothing;
        int giants = 0;
        for (int i = 0; i < count; i++)
            if (items[i][3] < split.plane)
                include(&centers, items[i], items[i]);
        Four size = (centers.high - centers.low) / 2;
        float extent = sqrtf(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
        for (int i = 0; i < count; i++)
            giants += items[i][3] >= extent;
        if (!(extent < split.plane) || giants > MOST_GIANTS)
            return split;
        split.plane = extent;
    }
}

// ---- the nodes --------------------------------------------------------------------------------

typedef struct {
    Hierarchy *hierarchy;
    Four *items; // in the order of the hierarchy
    int leaf;    // spheres in a leaf
} Builder;

// Lengths are parts of the scene's size.
static void set_items(const Builder *builder, const Scene *scene)
{
    vec3 low = vec3_of(INFINITY, INFINITY, INFINITY), high = -low;
    for (int i = 0; i < scene->sphere_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], scene->spheres[i].center[axis]);
            high[axis] = fmax(high[axis], scene->spheres[i].center[axis]);
        }
    const vec3 middle = (low + high) / 2;
    const double size = vec3_length(high - low) / 2, scale = size > 0 ? 1 / size : 1;
    for (int i = 0; i < scene->sphere_count; i++) {
        vec3 item = (scene->spheres[i].center - middle) * scale;
        item[3] = fmin(scene->spheres[i].radius * scale, 1e15); // its square is a float
        builder->items[i] = __builtin_convertvector(item, Four);
        builder->hierarchy->order[i] = i;
    }
}

// Adds a node, with all that is below it, but without their boxes.
static void add_node(const Builder *builder, int first, int count, int depth)
{
    Hierarchy *hierarchy = builder->hierarchy;
    Node *node = &hierarchy->nodes[hierarchy->node_count++];
    *node = (Node){.first = first, .count = count};
    if (count <= builder->leaf)
        return;
    Four *items = builder->items + first;
    Split split = {.cost = INFINITY};
    if (depth < DEEP)
        split = best_split(items, count);
    int half = 0;
    if (split.cost < INFINITY)
        half = partition(items, hierarchy->order + first, count, split);
    if (half == 0 || half == count) // they cannot be told apart
        half = count / 2;
    node->axis = split.axis;
    add_node(builder, first, half, depth + 1);
    node->other = hierarchy->node_count;
    add_node(builder, first + half, count - half, depth + 1);
}

static void add_all_nodes(const Builder *builder, int count)
{
    Hierarchy *hierarchy = builder->hierarchy;
    const Split split = split_giants(builder->items, count);
    const int giants = partition(builder->items, hierarchy->order, count, split);
    hierarchy->giant_count = count - giants;
    if (giants == 0 || giants == count) {
        add_node(builder, 0, count, 0);
        return;
    }
    hierarchy->nodes[0] = (Node){.count = count};
    hierarchy->node_count = 1;
    add_node(builder, 0, giants, 1);
    hierarchy->nodes[0].other = hierarchy->node_count;
    add_node(builder, giants, count - giants, 1);
}

// The numbers of the spheres in the order of the hierarchy.
static void line_up(const Hierarchy *hierarchy, const Scene *scene)
{
    const int *order = hierarchy->order, count = scene->sphere_count;
    double *numbers = hierarchy->numbers;
    for (int i = 0; i < count; i++, numbers += 4) {
        const Sphere *sphere = &scene->spheres[order[i]];
        for (int axis = 0; axis < 3; axis++)
            numbers[axis] = sphere->center[axis];
        numbers[3] = sphere->radius;
    }
}

// The last nodes first, because they are below the others.
static void set_boxes(const Hierarchy *hierarchy)
{
    for (int i = hierarchy->node_count - 1; i >= 0; i--) {
        Node *node = &hierarchy->nodes[i];
        const double *sphere = hierarchy->numbers + 4 * (size_t)node->first;
        const Box *first = &node[1].box, *second = &hierarchy->nodes[node->other].box;
        for (int axis = 0; axis < 3; axis++) {
            double low = INFINITY, high = -INFINITY;
            for (int k = 0; k < (node->other == 0 ? node->count : 0); k++) {
                double c = sphere[4 * k + axis], r = sphere[4 * k + 3];
                double more = r + 1e-6 * r + 1e-12 * fabs(c);
                low = c - more < low ? c - more : low;
                high = c + more > high ? c + more : high;
            }
            if (node->other > 0) {
                low = fmin(first->low[axis], second->low[axis]);
                high = fmax(first->high[axis], second->high[axis]);
            }
            node->box.low[axis] = low;
            node->box.high[axis] = high;
        }
    }
}

bool hierarchy_build(Hierarchy *hierarchy, const Scene *scene, int leaf)
{
    const size_t count = (size_t)scene->sphere_count;
    Builder builder = {hierarchy, lanes_memory((count + 1) * sizeof *builder.items), leaf};
    // There are fewer than twice as many nodes; what is not used takes no memory.
    *hierarchy = (Hierarchy){.nodes = lanes_memory((2 * count + 1) * sizeof *hierarchy->nodes),
                             .order = lanes_memory((count + 1) * sizeof *hierarchy->order),
                             .numbers = lanes_memory((count + 1) * 4 * sizeof(double))};
    bool built = builder.items != NULL && hierarchy->nodes != NULL && hierarchy->order != NULL &&
                 hierarchy->numbers != NULL;
    if (built) {
        set_items(&builder, scene);
        add_all_nodes(&builder, scene->sphere_count);
        line_up(hierarchy, scene);
        set_boxes(hierarchy);
    } else {
        hierarchy_free(hierarchy);
    }
    free(builder.items);
    return built;
}

void hierarchy_free(Hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    free(hierarchy->numbers);
    *hierarchy = (Hierarchy){0};
}

// ---- many boxes in a node ---------------------------------------------------------------------

// Nodes are counted, and when there is memory for them, they are made.
typedef struct {
    const Node *from;
    WideHierarchy *to;
    int nodes, leaves;
} Widening;

static float box_surface(const Box *box)
{
    float x = (float)(box->high[0] - box->low[0]), y = (float)(box->high[1] - box->low[1]);
    float z = (float)(box->high[2] - box->low[2]);
    return x * y + y * z + z * x;
}

// Opens a node, and then the largest of those in it, because rays enter it most often, until there
// are enough. Returns their number.
static int open_boxes(const Node *nodes, int node, int *below)
{
    float surface[BOXES]; // 0: a leaf, which is not opened
    int count = 1, largest = 0;
    below[0] = node;
    surface[0] = nodes[node].other == 0 ? 0 : 1;
    while (count < BOXES && surface[largest] > 0) {
        const int both[2] = {below[largest] + 1, nodes[below[largest]].other};
        const int into[2] = {largest, count++};
        for (int i = 0; i < 2; i++) {
            below[into[i]] = both[i];
            surface[into[i]] = nodes[both[i]].other == 0 ? 0 : box_surface(&nodes[both[i]].box);
        }
        for (int i = largest = 0; i < count; i++)
            largest = surface[i] > surface[largest] ? i : largest;
    }
    return count;
}

// A coordinate, counted from the corner of the largest box and scaled.
static double scaled(const WideHierarchy *wide, int axis, double at)
{
    return (at - wide->corner[axis]) * wide->scale;
}

// A side of a lane without a box; not infinite, because infinity times 0 is NaN.
#define NOWHERE 1e30F

static void set_node(const WideHierarchy *wide, WideNode *node, const Box *own)
{
    *node = (WideNode){.size = 0};
    for (int axis = 0; axis < 3; axis++) {
        float size = (float)((own->high[axis] - own->low[axis]) * wide->scale);
        node->corner[axis] = (float)scaled(wide, axis, own->low[axis]);
        node->size = fmaxf(node->size, size);
        for (int i = 0; i < BOXES; i++) {
            node->sides[2 * axis * BOXES + i] = NOWHERE;
            node->sides[(2 * axis + 1) * BOXES + i] = -NOWHERE;
        }
    }
}

static void set_box(const WideHierarchy *wide, WideNode *node, int i, const Box *box)
{
    const double more = 0x1p-20 * (double)node->size + 0x1p-45;
    for (int axis = 0; axis < 3; axis++) {
        float *low = &node->sides[2 * axis * BOXES + i], *high = low + BOXES;
        double corner = node->corner[axis];
        *low = (float)(scaled(wide, axis, box->low[axis]) - corner - more);
        *high = (float)(scaled(wide, axis, box->high[axis]) - corner + more);
    }
}

static void set_leaf(const WideHierarchy *wide, WideLeaf *leaf, const Node *node)
{
    *leaf = (WideLeaf){.first = node->first, .count = node->count};
    double size = 0; // the sum of the sides is at least the diagonal
    for (int axis = 0; axis < 3; axis++) {
        double low = scaled(wide, axis, node->box.low[axis]);
        double high = scaled(wide, axis, node->box.high[axis]);
        leaf->center[axis] = (float)((low + high) / 2);
        size += (high - low) / 2;
    }
    for (int k = 0; k < BOXES; k++) {
        const double *sphere = wide->numbers + 4 * (size_t)(leaf->first + k);
        leaf->r[k] = NAN;
        if (k >= leaf->count)
            continue;
        leaf->x[k] = (float)(scaled(wide, 0, sphere[0]) - (double)leaf->center[0]);
        leaf->y[k] = (float)(scaled(wide, 1, sphere[1]) - (double)leaf->center[1]);
        leaf->z[k] = (float)(scaled(wide, 2, sphere[2]) - (double)leaf->center[2]);
        leaf->r[k] = (float)(sphere[3] * wide->scale + 0x1p-18 * size + 0x1p-40);
    }
}

// Returns the number of the wide node. (The root of only a few spheres is a leaf, in a node.)
static int widen(Widening *widening, int number)
{
    const Node *from = widening->from, *node = &from[number];
    WideHierarchy *to = widening->to;
    const int made = widening->nodes++;
    int inside[BOXES], count = open_boxes(from, number, inside);
    if (to->nodes != NULL)
        set_node(to, &to->nodes[made], &node->box);
    for (int i = 0; i < count; i++) {
        const Node *below = &from[inside[i]];
        int next = below->other == 0 ? ~widening->leaves++ : widen(widening, inside[i]);
        if (to->nodes == NULL)
            continue;
        set_box(to, &to->nodes[made], i, &below->box);
        to->nodes[made].below[i] = next;
        if (next < 0)
            set_leaf(to, &to->leaves[~next], below);
    }
    return made;
}

bool wide_build(WideHierarchy *wide, const Hierarchy *hierarchy)
{
    const int count = hierarchy->nodes[0].count, giants = count - hierarchy->giant_count;
    const int top = giants < count ? 1 : 0; // the node of those that are no giants
    const Node *root = &hierarchy->nodes[top];
    *wide = (WideHierarchy){.numbers = hierarchy->numbers, .giants = giants, .end = count};
    wide->places = lanes_memory((size_t)(count + 1) * sizeof *wide->places);
    for (int i = 0; i < count && wide->places != NULL; i++)
        wide->places[hierarchy->order[i]] = i;
    if (giants == 0)
        return wide->places != NULL;
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
        size = fmax(size, root->box.high[axis] - root->box.low[axis]);
        wide->corner[axis] = root->box.low[axis];
    }
    wide->scale = 1 / size;
    Widening counted = {.from = hierarchy->nodes, .to = wide}, fill = counted;
    widen(&counted, top);
    wide->nodes = lanes_memory((size_t)counted.nodes * sizeof *wide->nodes);
    wide->leaves = lanes_memory((size_t)counted.leaves * sizeof *wide->leaves);
    if (wide->nodes == NULL || wide->leaves == NULL || wide->places == NULL) {
        wide_free(wide);
        return false;
    }
    widen(&fill, top);
    return true;
}

void wide_free(WideHierarchy *wide)
{
    free(wide->nodes);
    free(wide->leaves);
    free(wide->places);
    *wide = (WideHierarchy){0};
}
