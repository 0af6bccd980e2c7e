// wide_hierarchy.c - makes nodes of 16 boxes from a hierarchy, so that rays enter as few nodes as
// possible: the sum of the nodes' surfaces is the smallest one. Then, for rays from anywhere, the
// nodes and their leaves get the numbers that any_ray_lanes.c asks.
//
// After Ylitie, Karras and Laine, 'Efficient Incoherent Ray Traversal on GPUs Through Compressed
// Wide BVHs', 2017, section 3.1.
#include "chapters/08-fast/engines/wide_hierarchy.h"

#include "chapters/08-fast/engines/parallel.h"
#include "common/large_pages.h"

#include <math.h>
#include <stdlib.h>

// A node that one thread widens, with all that is below it. The root of the wide hierarchy has at
// most 16 boxes, and each of these at most 16 branches.
enum { ROOT, BOXES, BRANCHES, BELOW };
enum { MOST_BRANCHES = LANES * LANES };
typedef struct {
    int from;
    WideCount count, first; // how many it becomes, and the number of the first one
} Branch;

typedef struct {
    const Node *from;
    double scale;
    int few;
    uint8_t (*shares)[LANES]; // of each node: share_boxes
    WideNode *to;             // NULL: nodes are only counted
    Branch branches[MOST_BRANCHES];
    int branch_count;
} Widening;

static bool is_leaf(const Widening *widening, const Node *node)
{
    return node->other == 0 || node->count <= widening->few;
}

// Everything below a node can be in i boxes, from 1 to most of them. Finds the least sum of the
// surfaces of nodes below for each i: costs[i - 1]. shares[i - 1] is the number of these boxes in
// the first child; 0 if the node itself is the only box. shares[0] is most, which is returned.
static int share_boxes(const Widening *widening, int node, double *costs)
{
    const Node *from = &widening->from[node];
    costs[0] = 0;
    if (is_leaf(widening, from))
        return 1;
    double first[LANES], second[LANES];
    int a = share_boxes(widening, node + 1, first);
    int b = share_boxes(widening, from->other, second), most = a + b < LANES ? a + b : LANES;
    uint8_t *shares = widening->shares[node];
    for (int i = 2; i <= most; i++) {
        int least = i > b ? i - b : 1, best = least;
        for (int k = least + 1; k <= a && k < i; k++)
            if (first[k - 1] + second[i - k - 1] < first[best - 1] + second[i - best - 1])
                best = k;
        costs[i - 1] = first[best - 1] + second[i - best - 1];
        shares[i - 1] = (uint8_t)best;
    }
    costs[0] = box_surface(&from->box) + costs[most - 1];
    for (int i = 2; i < most; i++) {
        if (costs[0] <= costs[i - 1]) {
            costs[i - 1] = costs[0];
            shares[i - 1] = 0;
        }
    }
    shares[0] = (uint8_t)most;
    return most;
}

// Opens a node, so that what is below it is in these boxes: the nodes in them. Returns their end.
static int *open_boxes(const Widening *widening, int node, int boxes, int *below)
{
    int share = boxes > 1 ? widening->shares[node][boxes - 1] : 0;
    if (share == 0) {
        *below = node;
        return below + 1;
    }
    below = open_boxes(widening, node + 1, share, below);
    return open_boxes(widening, widening->from[node].other, boxes - share, below);
}

static void set_box(const Widening *widening, WideNode *wide, int i, const Node *node)
{
    for (int axis = 0; axis < 3; axis++) {
        double low = node->box.low[axis] - wide->corner[axis];
        double high = node->box.high[axis] - wide->corner[axis];
        wide->middle[axis][i] = (float)((low + high) / 2 * widening->scale);
        wide->half[axis][i] = (float)((high - low) / 2 * widening->scale);
    }
    wide->first[i] = node->first;
    wide->count[i] = (uint8_t)(is_leaf(widening, node) ? node->count : 0);
}

static void set_wide(const Widening *widening, WideNode *wide, const Node *node, const int *below)
{
    for (int axis = 0; axis < 3; axis++) {
        double low = node->box.low[axis], high = node->box.high[axis];
        wide->corner[axis] = low;
        wide->size = fmaxf(wide->size, (float)((high - low) * widening->scale));
    }
    for (int i = 0; i < wide->boxes; i++)
        set_box(widening, wide, i, &widening->from[below[i]]);
}

// Counts the wide nodes of a node and of all that is below it, but for branches; or makes them.
// next has the numbers of the next node and the next leaf. Returns the number of this node.
static int widen(Widening *widening, int node, int depth, WideCount *next)
{
    if (depth == BRANCHES) {
        Branch *branch = &widening->branches[widening->branch_count++];
        branch->from = node;
        return branch->first.nodes;
    }
    const int number = next->nodes++;
    int below[LANES],
        most = is_leaf(widening, &widening->from[node]) ? 1 : widening->shares[node][0];
    const int boxes = (int)(open_boxes(widening, node, most, below) - below);
    WideNode *wide = widening->to == NULL ? NULL : &widening->to[number];
    if (wide != NULL) {
        *wide = (WideNode){.boxes = boxes, .leaves = next->leaves};
        set_wide(widening, wide, &widening->from[node], below);
    }
    for (int i = 0; i < boxes; i++)
        next->leaves += is_leaf(widening, &widening->from[below[i]]);
    for (int i = 0; i < boxes; i++) {
        if (is_leaf(widening, &widening->from[below[i]]))
            continue;
        int first = widen(widening, below[i], depth + 1, next);
        if (wide != NULL)
            wide->first[i] = first;
    }
    return number;
}

static void widen_above(Widening *widening, WideCount *next)
{
    widening->branch_count = 0;
    widen(widening, 0, ROOT, next);
}

static void widen_branch(void *given, int number)
{
    Widening *widening = given;
    Branch *branch = &widening->branches[number];
    WideCount next = branch->first;
    widen(widening, branch->from, BELOW, &next);
    branch->count =
        (WideCount){next.nodes - branch->first.nodes, next.leaves - branch->first.leaves};
}

static void number_branches(Widening *widening, WideCount *count)
{
    for (int i = 0; i < widening->branch_count; i++) {
        Branch *branch = &widening->branches[i];
        branch->first = *count;
        count->nodes += branch->count.nodes;
        count->leaves += branch->count.leaves;
    }
}

WideNode *wide_build(const Hierarchy *hierarchy, double scale, int few, int threads,
                     WideCount *count)
{
    Widening widening = {.from = hierarchy->nodes,
                         .scale = scale,
                         .few = few,
                         .shares = malloc((size_t)hierarchy->node_count * LANES)};
    double costs[LANES];
    *count = (WideCount){0, 0};
    if (widening.shares == NULL)
        return NULL;
    share_boxes(&widening, 0, costs);
    widen_above(&widening, count);
    in_parallel(threads, widening.branch_count, widen_branch, &widening);
    number_branches(&widening, count);
    widening.to = large_memory((size_t)count->nodes * sizeof *widening.to);
    if (widening.to != NULL) {
        widen_above(&widening, &(WideCount){0, 0});
        in_parallel(threads, widening.branch_count, widen_branch, &widening);
    }
    free(widening.shares);
    return widening.to;
}

// ---- for rays from anywhere -------------------------------------------------------------------

// A coordinate, counted from the world's corner and scaled.
static double scaled(const RayWorld *world, int axis, double at)
{
    return (at - world->corner[axis]) * world->scale;
}

static void set_leaf(const RayWorld *world, RayLeaf *leaf, const WideNode *wide, int i)
{
    *leaf = (RayLeaf){.first = wide->first[i]};
    double half = 0;
    for (int axis = 0; axis < 3; axis++) {
        leaf->center[axis] =
            (float)(scaled(world, axis, wide->corner[axis]) + (double)wide->middle[axis][i]);
        half += wide->half[axis][i];
    }
    // The sum of the sides is at least the diagonal.
    float more = (float)(0x1p-18 * half + 0x1p-40);
    for (int k = 0; k < LANES; k++)
        leaf->r[k] = NAN;
    for (int k = 0; k < wide->count[i]; k++) {
        const double *sphere = world->numbers + 4 * (size_t)(leaf->first + k);
        leaf->x[k] = (float)(scaled(world, 0, sphere[0]) - (double)leaf->center[0]);
        leaf->y[k] = (float)(scaled(world, 1, sphere[1]) - (double)leaf->center[1]);
        leaf->z[k] = (float)(scaled(world, 2, sphere[2]) - (double)leaf->center[2]);
        leaf->r[k] = (float)(sphere[3] * world->scale) + more;
    }
}

static void set_node(const RayWorld *world, RayNode *node, const WideNode *wide)
{
    *node = (RayNode){.corner = {0}};
    double more = 0x1p-20 * (double)wide->size + 0x1p-45;
    for (int axis = 0; axis < 3; axis++) {
        double corner = scaled(world, axis, wide->corner[axis]);
        node->corner[axis] = (float)corner;
        double from = corner - (double)node->corner[axis];
        float *low = node->sides + 2 * axis * LANES, *high = low + LANES;
        for (int i = 0; i < LANES; i++) {
            double middle = wide->middle[axis][i] + from, half = wide->half[axis][i] + more;
            low[i] = i < wide->boxes ? (float)(middle - half) : INFINITY;
            high[i] = i < wide->boxes ? (float)(middle + half) : -INFINITY;
        }
    }
}

typedef struct {
    RayWorld *world;
    const Hierarchy *hierarchy;
    const WideNode *wide;
    int node_count, sphere_count;
} Setting;
enum { NODES = 64, SPHERES = 8192 }; // that one thread sets at a time

static void set_nodes(void *given, int part)
{
    enum { NODE_LINES = sizeof(RayNode) / CACHE_LINE, LEAF_LINES = sizeof(RayLeaf) / CACHE_LINE };
    const Setting *setting = given;
    RayWorld *world = setting->world;
    RayLeaf *leaves = (RayLeaf *)(world->nodes + setting->node_count);
    for (int n = NODES * part; n < NODES * (part + 1) && n < setting->node_count; n++) {
        const WideNode *wide = &setting->wide[n];
        int leaf = wide->leaves;
        set_node(world, &world->nodes[n], wide);
        for (int i = 0; i < wide->boxes; i++) {
            bool is_leaf = wide->count[i] > 0;
            world->nodes[n].below[i] = is_leaf
                                           ? ~(NODE_LINES * setting->node_count + LEAF_LINES * leaf)
                                           : NODE_LINES * wide->first[i];
            if (is_leaf)
                set_leaf(world, &leaves[leaf++], wide, i);
        }
    }
}

static void set_places(void *given, int part)
{
    const Setting *setting = given;
    for (int i = SPHERES * part; i < SPHERES * (part + 1) && i < setting->sphere_count; i++)
        setting->world->places[setting->hierarchy->order[i]] = i;
}

bool ray_world_build(RayWorld *world, const Hierarchy *hierarchy, int threads)
{
    *world = (RayWorld){.numbers = hierarchy->numbers};
    const Node *root = &hierarchy->nodes[0];
    if (root->count == 0)
        return true;
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
        size = fmax(size, root->box.high[axis] - root->box.low[axis]);
        world->corner[axis] = root->box.low[axis];
    }
    world->scale = 1 / size;
    WideCount count;
    WideNode *wide = wide_build(hierarchy, world->scale, LANES, threads, &count);
    world->places = large_memory((size_t)root->count * sizeof *world->places);
    world->nodes = large_memory((size_t)count.nodes * sizeof(RayNode) +
                                (size_t)count.leaves * sizeof(RayLeaf));
    Setting setting = {world, hierarchy, wide, count.nodes, root->count};
    bool built = wide != NULL && world->places != NULL && world->nodes != NULL;
    if (built) {
        in_parallel(threads, (root->count + SPHERES - 1) / SPHERES, set_places, &setting);
        in_parallel(threads, (count.nodes + NODES - 1) / NODES, set_nodes, &setting);
    }
    free(wide);
    if (!built)
        ray_world_free(world);
    return built;
}

void ray_world_free(RayWorld *world)
{
    free(world->nodes);
    free(world->places);
    *world = (RayWorld){0};
}
