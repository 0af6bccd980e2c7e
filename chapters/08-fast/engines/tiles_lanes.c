// tiles_lanes.c - step 5: a tile's whole frustum through the hierarchy.
//
// The tile asks once the questions that each of its packets would ask: a box is beside the frustum
// if it is outside one of its four sides. Then each sphere is shown to the packets where it may be
// visible, by its outline, as in step 2.
#include "chapters/08-fast/engines/packet.h"

enum { PACKETS = TILE_BLOCKS * TILE_BLOCKS, LEFT = 0, RIGHT, TOP, BOTTOM, AHEAD, PLANES };

// The sides are planes through the eye, normals inwards; and one direction in the middle.
typedef struct {
    float normal[PLANES][3];
    float shortest; // of the tile's rays
    float farthest; // nothing farther away is visible, along AHEAD
    Packet packets[PACKETS];
} Frustum;

// Nodes still to enter and spheres still to ask, the nearest last.
typedef struct {
    float near;
    int first, count; // as in WideNode
} Waiting;
enum { MOST_WAITING = HIERARCHY_DEEPEST * LANES };

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
    }
    frustum->farthest = INFINITY;
    float nearest_x = between(left, 0, right), nearest_y = between(bottom, 0, top);
    frustum->shortest = sqrtf(nearest_x * nearest_x + nearest_y * nearest_y + 1);
    for (int i = 0; i < PACKETS; i++) {
        int column = tile->column + i % TILE_BLOCKS, row = tile->row + i / TILE_BLOCKS;
        packet_begin(&frustum->packets[i], view, column, row);
        for (int k = 0; k < view->around_count; k++)
            packet_see_around(&frustum->packets[i], &view->seen[view->around[k]],
                              view->colors[view->around[k]]);
        if (column >= view->columns || row >= view->rows) // beyond the screen everything is hidden
            memset(frustum->packets[i].end, 0, sizeof frustum->packets[i].end);
    }
}

// Which boxes of a node are, or may be, in the frustum, as bits; and how near each begins. Along a
// direction n a box reaches from n.middle - |n|.half to n.middle + |n|.half. If even the latter is
// outside a side, the whole box is. For rounding, boxes are larger by 2^-20 of the largest distance
// in the node.
static unsigned frustum_enters(const Frustum *frustum, const View *view, const WideNode *node,
                               float *near)
{
    float x = (float)(node->corner[0] - view->eye[0]), y = (float)(node->corner[1] - view->eye[1]),
          z = (float)(node->corner[2] - view->eye[2]);
    float more = 0x1p-20F * (larger(larger(fabsf(x), fabsf(y)), fabsf(z)) + node->size);
    unsigned enters = 0;
#pragma omp simd reduction(| : enters)
    for (int i = 0; i < LANES; i++) {
        float middle_x = node->middle[0][i] + x, half_x = node->half[0][i] + more;
        float middle_y = node->middle[1][i] + y, half_y = node->half[1][i] + more;
        float middle_z = node->middle[2][i] + z, half_z = node->half[2][i] + more;
        bool in = i < node->boxes;
        for (int side = 0; side < AHEAD; side++) {
            const float *n = frustum->normal[side];
            in &= n[0] * middle_x + n[1] * middle_y + n[2] * middle_z + fabsf(n[0]) * half_x +
                      fabsf(n[1]) * half_y + fabsf(n[2]) * half_z >=
                  0;
        }
        const float *n = frustum->normal[AHEAD];
        near[i] = n[0] * middle_x + n[1] * middle_y + n[2] * middle_z - fabsf(n[0]) * half_x -
                  fabsf(n[1]) * half_y - fabsf(n[2]) * half_z;
        in &= near[i] <= frustum->farthest;
        enters |= (unsigned)in << i;
    }
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
            if (packet_may_see(packet, seen)) {
                packet_see(packet, seen, view->colors[sphere]);
                changed = true;
            }
        }
    }
    return changed;
}

// Floats of one sign have the order of their bits, and the largest integer is found faster.
static float largest(const float *x)
{
    int32_t most = 0;
#pragma omp simd reduction(max : most)
    for (int i = 0; i < LANES; i++) {
        int32_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        most = bits > most ? bits : most;
    }
    float result;
    memcpy(&result, &most, sizeof result);
    return result;
}

// Spheres ask the tile. After that, nothing farther away than the farthest of its certain hits
// matters. (An end is t v.v, a distance times |v|: divided by the least |v| it is not less than the
// distance.)
static void ask(Frustum *frustum, const View *view, const Tile *tile, int first, int count)
{
    bool changed = false;
    for (int i = first; i < first + count; i++)
        changed |= show(frustum, view, tile, i);
    if (!changed)
        return;
    float end[LANES] = {0};
    for (int k = 0; k < PACKETS; k++)
#pragma omp simd
        for (int i = 0; i < LANES; i++)
            end[i] = larger(end[i], frustum->packets[k].end[i]);
    frustum->farthest = largest(end) / frustum->shortest;
}

// Adds the boxes of a node that the tile enters to the waiting ones, sorted, the nearest last;
// returns the new number.
static int enter(const Frustum *frustum, const View *view, const WideNode *node, Waiting *waiting,
                 int count)
{
    float near[LANES];
    int before = count;
    for (unsigned enters = frustum_enters(frustum, view, node, near); enters != 0;
         enters &= enters - 1) {
        int i = __builtin_ctz(enters), place = count++; // the lowest bit that is set
        for (; place > before && waiting[place - 1].near < near[i]; place--)
            waiting[place] = waiting[place - 1];
        waiting[place] = (Waiting){near[i], node->first[i], node->count[i]};
    }
    return count;
}

void LANES(walk_frustum)(const View *view, Tile *tile)
{
    Frustum frustum;
    frustum_begin(&frustum, view, tile);
    Waiting waiting[MOST_WAITING];
    int count = 0;
    if (view->wide != NULL)
        waiting[count++] = (Waiting){0}; // the root
    while (count > 0) {
        Waiting next = waiting[--count];
        if (next.near > frustum.farthest)
            continue;
        if (next.count > 0)
            ask(&frustum, view, tile, next.first, next.count);
        else
            count = enter(&frustum, view, &view->wide[next.first], waiting, count);
    }
    for (int i = 0; i < PACKETS; i++)
        packet_end(&frustum.packets[i], tile->column + i % TILE_BLOCKS, tile->row + i / TILE_BLOCKS,
                   tile);
}
