// wide_hierarchy.c - makes nodes of 16 boxes from a hierarchy: in each node, the largest box is
// replaced by the two boxes in it, until there are 16. Then, for rays from anywhere, the nodes and
// their leaves get the numbers that any_ray_lanes.c asks.
#include "chapters/08-fast/engines/wide_hierarchy.h"

#include "chapters/08-fast/engines/system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const Node *from;
    double scale;
    int few;
    WideNode *to;
    int count, room;
} Widening;

static bool is_leaf(const Widening *widening, const Node *node)
{
    return node->other == 0 || node->count <= widening->few;
}

// The nodes below one, at most 16 and at least its children; returns their number.
static int open_boxes(const Widening *widening, int node, int *below)
{
    const Node *from = widening->from;
    int count = 1;
    below[0] = node;
    while (count < LANES) {
        int largest = -1;
        for (int i = 0; i < count; i++)
            if (!is_leaf(widening, &from[below[i]]) &&
                (largest < 0 ||
                 box_surface(&from[below[i]].box) > box_surface(&from[below[largest]].box)))
                largest = i;
        if (largest < 0)
            break;
        int opened = below[largest];
        below[largest] = opened + 1;
        below[count++] = from[opened].other;
    }
    return count;
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

// Like realloc, but each node begins at the start of a cache line.
static bool make_room(Widening *widening)
{
    int room = 2 * widening->room + 16;
    WideNode *to = large_memory((size_t)room * sizeof *to);
    if (to == NULL)
        return false;
    if (widening->count > 0)
        memcpy(to, widening->to, (size_t)widening->count * sizeof *to);
    free(widening->to);
    widening->to = to;
    widening->room = room;
    return true;
}

// The number of the new node; negative if there is not enough memory.
static int widen(Widening *widening, int node)
{
    if (widening->count == widening->room && !make_room(widening))
        return -1;
    int number = widening->count++, below[LANES];
    const Node *from = widening->from;
    WideNode wide = {.boxes = open_boxes(widening, node, below)};
    for (int axis = 0; axis < 3; axis++) {
        double low = from[node].box.low[axis], high = from[node].box.high[axis];
        wide.corner[axis] = low;
        wide.size = fmaxf(wide.size, (float)((high - low) * widening->scale));
    }
    for (int i = 0; i < wide.boxes; i++) {
        set_box(widening, &wide, i, &from[below[i]]);
        if (is_leaf(widening, &from[below[i]]))
            continue;
        wide.first[i] = widen(widening, below[i]);
        if (wide.first[i] < 0)
            return -1;
    }
    widening->to[number] = wide;
    return number;
}

WideNode *wide_build(const Hierarchy *hierarchy, double scale, int few, int *node_count)
{
    Widening widening = {.from = hierarchy->nodes, .scale = scale, .few = few};
    bool built = widen(&widening, 0) >= 0;
    *node_count = widening.count;
    if (built)
        return widening.to;
    free(widening.to);
    return NULL;
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

static bool set_nodes(RayWorld *world, const WideNode *wide, int node_count)
{
    size_t count = 0;
    for (int n = 0; n < node_count; n++)
        for (int i = 0; i < wide[n].boxes; i++)
            count += wide[n].count[i] > 0;
    world->nodes = large_memory((size_t)node_count * sizeof(RayNode) + count * sizeof(RayLeaf));
    if (world->nodes == NULL)
        return false;
    enum { NODE_LINES = sizeof(RayNode) / CACHE_LINE, LEAF_LINES = sizeof(RayLeaf) / CACHE_LINE };
    RayLeaf *leaf = (RayLeaf *)(world->nodes + node_count);
    int place = NODE_LINES * node_count;
    for (int n = 0; n < node_count; n++) {
        set_node(world, &world->nodes[n], &wide[n]);
        for (int i = 0; i < wide[n].boxes; i++) {
            bool is_leaf = wide[n].count[i] > 0;
            world->nodes[n].below[i] = is_leaf ? ~place : NODE_LINES * wide[n].first[i];
            if (!is_leaf)
                continue;
            set_leaf(world, leaf++, &wide[n], i);
            place += LEAF_LINES;
        }
    }
    return true;
}

bool ray_world_build(RayWorld *world, const Hierarchy *hierarchy, const Scene *scene)
{
    *world = (RayWorld){0};
    if (scene->sphere_count == 0)
        return true;
    const Box *box = &hierarchy->nodes[0].box;
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
        size = fmax(size, box->high[axis] - box->low[axis]);
        world->corner[axis] = box->low[axis];
    }
    world->scale = 1 / size;
    world->numbers = large_memory(4 * (size_t)scene->sphere_count * sizeof(double));
    world->places = large_memory((size_t)scene->sphere_count * sizeof *world->places);
    if (world->numbers == NULL || world->places == NULL) {
        ray_world_free(world);
        return false;
    }
    for (int i = 0; i < scene->sphere_count; i++) {
        world->places[hierarchy->order[i]] = i;
        const Sphere *sphere = &scene->spheres[hierarchy->order[i]];
        for (int axis = 0; axis < 3; axis++)
            world->numbers[4 * (size_t)i + (size_t)axis] = sphere->center[axis];
        world->numbers[4 * (size_t)i + 3] = sphere->radius;
    }
    int node_count = 0;
    WideNode *wide = wide_build(hierarchy, world->scale, LANES, &node_count);
    bool built = wide != NULL && set_nodes(world, wide, node_count);
    free(wide);
    if (built)
        return true;
    ray_world_free(world);
    return false;
}

void ray_world_free(RayWorld *world)
{
    free(world->nodes);
    free(world->numbers);
    free(world->places);
    *world = (RayWorld){0};
}
