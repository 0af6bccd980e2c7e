// wide_hierarchy.c - 16 boxes in a node: from the root of a hierarchy the largest box is opened,
// until there are 16.
#include "chapters/08-fast/engines/wide_hierarchy.h"

#include "chapters/08-fast/engines/large_memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Asking so few spheres is faster than asking their boxes.
enum { FEW = 4 };

typedef struct {
    const Node *from;
    double scale;
    WideNode *to;
    int count, room;
} Widening;

static bool is_leaf(const Node *node)
{
    return node->other == 0 || node->count <= FEW;
}

// The nodes below one, at most 16 and at least its children; returns their number.
static int open_boxes(const Node *from, int node, int *below)
{
    int count = 1;
    below[0] = node;
    while (count < LANES) {
        int largest = -1;
        for (int i = 0; i < count; i++)
            if (!is_leaf(&from[below[i]]) &&
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

static void set_box(WideNode *wide, int i, const Node *node, double scale)
{
    for (int axis = 0; axis < 3; axis++) {
        double low = node->box.low[axis] - wide->corner[axis];
        double high = node->box.high[axis] - wide->corner[axis];
        wide->middle[axis][i] = (float)((low + high) / 2 * scale);
        wide->half[axis][i] = (float)((high - low) / 2 * scale);
    }
    wide->first[i] = node->first;
    wide->count[i] = (uint8_t)(is_leaf(node) ? node->count : 0);
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
    WideNode wide = {.boxes = open_boxes(from, node, below)};
    for (int axis = 0; axis < 3; axis++) {
        double low = from[node].box.low[axis], high = from[node].box.high[axis];
        wide.corner[axis] = low;
        wide.size = fmaxf(wide.size, (float)((high - low) * widening->scale));
    }
    for (int i = 0; i < wide.boxes; i++) {
        set_box(&wide, i, &from[below[i]], widening->scale);
        if (is_leaf(&from[below[i]]))
            continue;
        wide.first[i] = widen(widening, below[i]);
        if (wide.first[i] < 0)
            return -1;
    }
    widening->to[number] = wide;
    return number;
}

WideNode *wide_build(const Hierarchy *hierarchy, double scale)
{
    Widening widening = {.from = hierarchy->nodes, .scale = scale};
    if (widen(&widening, 0) >= 0)
        return widening.to;
    free(widening.to);
    return NULL;
}
