// packet_lanes.c - step 4: 16 rays at a time through the hierarchy.
//
// The packet enters a box if any of the 16 rays enters it. A sphere is asked for all 16 at once.
#include "chapters/08-fast/engines/packet.h"

typedef struct {
    float x[LANES], y[LANES], z[LANES]; // 1 / direction, along the axes of the world
    float per_squared[LANES];
    float end[LANES]; // a little more than the t of the nearest certain hit
    float middle[3];  // a direction in the middle
} Inverse;

static float direction(const View *view, int axis, float x, float y)
{
    return (float)view->ahead[axis] + x * (float)view->right[axis] + y * (float)view->up[axis];
}

// Never for 0: infinity times 0 would be NaN.
static float inverse(float x)
{
    return 1 / (fabsf(x) > 1e-30F ? x : 1e-30F);
}

static void inverse_of(Inverse *of, const View *view, const Packet *packet)
{
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        of->x[i] = inverse(direction(view, 0, packet->x[i], packet->y[i]));
        of->y[i] = inverse(direction(view, 1, packet->x[i], packet->y[i]));
        of->z[i] = inverse(direction(view, 2, packet->x[i], packet->y[i]));
        of->per_squared[i] = (1 + 0x1p-20F) / packet->squared[i];
        of->end[i] = packet->end[i] * of->per_squared[i];
    }
    for (int axis = 0; axis < 3; axis++)
        of->middle[axis] = direction(view, axis, packet->x[LANES / 2], packet->y[LANES / 2]);
}

// Whether any ray enters the box before its nearest certain hit: the slabs of bvh.c, for 16 rays.
static inline bool packet_enters(const Inverse *of, const SeenBox *box)
{
    float low_x = box->low[0], low_y = box->low[1], low_z = box->low[2];
    float high_x = box->high[0], high_y = box->high[1], high_z = box->high[2];
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < LANES; i++) {
        float ax = low_x * of->x[i], bx = high_x * of->x[i];
        float ay = low_y * of->y[i], by = high_y * of->y[i];
        float az = low_z * of->z[i], bz = high_z * of->z[i];
        float enters = larger(larger(smaller(ax, bx), smaller(ay, by)), smaller(az, bz));
        float leaves = smaller(smaller(larger(ax, bx), larger(ay, by)), larger(az, bz));
        leaves = smaller(leaves * (1 + 0x1p-20F), of->end[i]);
        any |= larger(enters, 0) <= leaves;
    }
    return any != 0;
}

static void ask_leaf(Packet *packet, Inverse *of, const View *view, const Node *leaf, int column,
                     int row)
{
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        const Seen *seen = &view->seen[i];
        if (column < seen->left || column >= seen->right || row < seen->top ||
            row >= seen->bottom || !packet_may_see(packet, seen, column, row))
            continue;
        packet_see(packet, seen);
#pragma omp simd
        for (int k = 0; k < LANES; k++)
            of->end[k] = packet->end[k] * of->per_squared[k];
    }
}

// Depth first. Of two children, the first is the one that the ray in the middle meets first, by its
// direction along the axis of the split.
static void walk(Packet *packet, const View *view, int column, int row)
{
    Inverse of;
    inverse_of(&of, view, packet);
    int waiting[HIERARCHY_DEEPEST + 1], count = 0;
    waiting[count++] = 0; // the root
    while (count > 0) {
        int number = waiting[--count];
        const Node *node = &view->nodes[number];
        if (node->other == 0) {
            ask_leaf(packet, &of, view, node, column, row);
            continue;
        }
        bool swap = of.middle[node->axis] < 0;
        int near = swap ? node->other : number + 1, far = swap ? number + 1 : node->other;
        bool near_in = packet_enters(&of, &view->boxes[near]);
        bool far_in = packet_enters(&of, &view->boxes[far]);
        if (far_in)
            waiting[count++] = far;
        if (near_in)
            waiting[count++] = near; // the next
    }
}

void LANES(walk_packets)(const View *view, Tile *tile)
{
    for (int i = 0; i < TILE_BLOCKS * TILE_BLOCKS; i++) {
        int column = tile->column + i % TILE_BLOCKS, row = tile->row + i / TILE_BLOCKS;
        if (column >= view->columns || row >= view->rows)
            continue;
        Packet packet;
        packet_begin(&packet, view, column, row);
        if (view->nodes != NULL)
            walk(&packet, view, column, row);
        packet_end(&packet, column, row, tile);
    }
}
