// tiles_lanes.c - step 5: a tile's whole frustum through the hierarchy.
//
// The tile asks once the questions that each of its packets would ask: a box is beside the frustum
// if it is outside one of its four sides. Then each sphere is shown to the packets where it may be
// visible, by its outline, as in step 2.
#include "chapters/08-fast/engines/packet.h"

enum { PACKETS = TILE_BLOCKS * TILE_BLOCKS, LEFT = 0, RIGHT, TOP, BOTTOM, AHEAD, PLANES };

// The sides are planes through the eye, normals inwards; and one direction in the middle. Lengths
// are those of the wide hierarchy.
typedef struct {
    float normal[PLANES][3];
    double eye[3];
    float shortest; // of the tile's rays
    float farthest; // nothing farther away is visible, along AHEAD
    Packet packets[PACKETS];
} Frustum;

// Nodes still to enter and leaves still to ask, the nearest last.
typedef struct {
    float near;
    int below; // as in WideNode
} Waiting;
enum { MOST_WAITING = HIERARCHY_DEEPEST * BOXES };

static float between(float low, float x, float high)
{
    return x < low ? low : x < high ? x : high;
}

static void frustum_begin(Frustum *frustum, const View *view, const Tile *tile)
{
    const float *x = view->x + tile->column * BLOCK, *y = view->y + tile->row * BLOCK;
    float left = x[0], right = x[TILE - 1], top = y[0], bottom = y[TILE - 1];
    double middle_x = (left + right) / 2, middle_y = (top + bottom) / 2;
    double length = sqrt(middle_x * middle_x + middle_y * middle_y + 1);
    for (int axis = 0; axis < 3; axis++) {
        double r = view->right[axis], u = view->up[axis], f = view->ahead[axis];
        frustum->normal[LEFT][axis] = (float)(r - left * f);
        frustum->normal[RIGHT][axis] = (float)(right * f - r);
        frustum->normal[TOP][axis] = (float)(top * f - u);
        frustum->normal[BOTTOM][axis] = (float)(u - bottom * f);
        frustum->normal[AHEAD][axis] = (float)((f + middle_x * r + middle_y * u) / length);
        frustum->eye[axis] = (view->eye[axis] - view->wide->corner[axis]) * view->wide->scale;
    }
    frustum->farthest = INFINITY;
    float nearest_x = between(left, 0, right), nearest_y = between(bottom, 0, top);
    frustum->shortest = sqrtf(nearest_x * nearest_x + nearest_y * nearest_y + 1);
    for (int i = 0; i < PACKETS; i++) {
        int column = tile->column + i % TILE_BLOCKS, row = tile->row + i / TILE_BLOCKS;
        packet_begin(&frustum->packets[i], view, column, row);
        if (column >= view->columns || row >= view->rows) // beyond the screen everything is hidden
            memset(frustum->packets[i].end, 0, sizeof frustum->packets[i].end);
    }
}

// The last corners of a node's boxes along a direction n; the first ones along -n.
static inline void add_last_corners(const WideNode *node, const float *n, float sign, float *last)
{
    const float *x = node->sides + (sign * n[0] > 0 ? BOXES : 0);
    const float *y = node->sides + (sign * n[1] > 0 ? 3 : 2) * BOXES;
    const float *z = node->sides + (sign * n[2] > 0 ? 5 : 4) * BOXES;
#pragma omp simd
    for (int i = 0; i < BOXES; i++)
        last[i] += n[0] * x[i] + n[1] * y[i] + n[2] * z[i];
}

// Which boxes of a node are, or may be, in the frustum, as bits; and how near each begins. If even
// the last corner of a box along the normal of a side is outside, the whole box is. For rounding,
// there is a margin of 2^-20 of the largest distance in the node.
static unsigned frustum_enters(const Frustum *frustum, const WideNode *node, float *near)
{
    float corner[3], reach = node->size;
    for (int axis = 0; axis < 3; axis++) {
        corner[axis] = (float)((double)node->corner[axis] - frustum->eye[axis]);
        reach += fabsf(corner[axis]);
    }
    float least[BOXES];
    for (int i = 0; i < BOXES; i++)
        least[i] = INFINITY;
    for (int side = LEFT; side <= AHEAD; side++) {
        const float *n = frustum->normal[side];
        float sum = fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]), last[BOXES];
        float begin = n[0] * corner[0] + n[1] * corner[1] + n[2] * corner[2];
        begin += (side == AHEAD ? -0x1p-19F : 0x1p-19F) * reach * sum;
        for (int i = 0; i < BOXES; i++)
            last[i] = begin;
        add_last_corners(node, n, side == AHEAD ? -1 : 1, last);
#pragma omp simd
        for (int i = 0; i < BOXES; i++) {
            least[i] = side < AHEAD ? smaller(least[i], last[i]) : least[i];
            near[i] = last[i];
        }
    }
    unsigned enters = 0;
#pragma omp simd reduction(| : enters)
    for (int i = 0; i < BOXES; i++)
        enters |= (unsigned)((least[i] >= 0) & (near[i] <= frustum->farthest)) << i;
    return enters;
}

// Whether any of the packets in the sphere's outline may see it.
static bool show(Frustum *frustum, const View *view, const Tile *tile, int sphere)
{
    const Seen *seen = &view->seen[sphere];
    int left = seen->left - tile->column, right = seen->right - tile->column;
    int top = seen->top - tile->row, bottom = seen->bottom - tile->row;
    bool changed = false;
    for (int row = top > 0 ? top : 0; row < bottom && row < TILE_BLOCKS; row++) {
        for (int column = left > 0 ? left : 0; column < right && column < TILE_BLOCKS; column++) {
            int i = row * TILE_BLOCKS + column;
            Packet *packet = &frustum->packets[i];
            if (packet_may_see(packet, seen, tile->column + column, tile->row + row)) {
                packet_see(packet, seen);
                changed = true;
            }
        }
    }
    return changed;
}

// Spheres ask the tile. After that, nothing farther away than the farthest of its certain hits
// matters. (An end is t v.v, a distance times |v|: divided by the least |v| it is not less than the
// distance.)
static void ask(Frustum *frustum, const View *view, const Tile *tile, int first, int end)
{
    bool changed = false;
    for (int i = first; i < end; i++)
        changed |= show(frustum, view, tile, i);
    if (!changed)
        return;
    float last = 0;
    for (int k = 0; k < PACKETS; k++)
#pragma omp simd reduction(max : last)
        for (int i = 0; i < LANES; i++)
            last = larger(frustum->packets[k].end[i], last);
    frustum->farthest = last / frustum->shortest * (float)view->wide->scale;
}

// Adds the boxes of a node that the tile enters to the waiting ones, sorted, the nearest last;
// returns the new number.
static int enter(const Frustum *frustum, const WideNode *node, Waiting *waiting, int count)
{
    float near[BOXES];
    int before = count;
    for (unsigned enters = frustum_enters(frustum, node, near); enters != 0; enters &= enters - 1) {
        int i = __builtin_ctz(enters), place = count++; // the lowest bit that is set
        for (; place > before && waiting[place - 1].near < near[i]; place--)
            waiting[place] = waiting[place - 1];
        waiting[place] = (Waiting){near[i], node->below[i]};
    }
    return count;
}

void LANES(walk_frustum)(const View *view, Tile *tile)
{
    Frustum frustum;
    frustum_begin(&frustum, view, tile);
    Waiting waiting[MOST_WAITING];
    const WideHierarchy *wide = view->wide;
    int count = 0;
    ask(&frustum, view, tile, wide->giants, wide->end);
    if (wide->nodes != NULL)
        waiting[count++] = (Waiting){-INFINITY, 0}; // the root
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.near > frustum.farthest)
            continue;
        const WideLeaf *leaf = &wide->leaves[~next.below];
        if (next.below < 0)
            ask(&frustum, view, tile, leaf->first, leaf->first + leaf->count);
        else
            count = enter(&frustum, &wide->nodes[next.below], waiting, count);
    }
    for (int i = 0; i < PACKETS; i++)
        packet_end(&frustum.packets[i], tile->column + i % TILE_BLOCKS, tile->row + i / TILE_BLOCKS,
                   tile);
}
