// packet.h - 16 rays at a time: what they see so far, and how they ask one sphere.
//
// The rays compare t v.v = c.v - sqrt(D) (float_bounds.h), so that they need not divide. It is
// between two known bounds. A sphere is certainly the nearest if the lower bounds of all others are
// greater than its upper bound.
#ifndef CHAPTERS_08_FAST_PACKET_H
#define CHAPTERS_08_FAST_PACKET_H

#include "chapters/08-fast/engines/float_bounds.h"

#include <math.h>
#include <stdalign.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef struct {
    alignas(64) float x[LANES];     // aligned to a cache line, where vectors are read fastest
    float y[LANES], squared[LANES]; // the rays are (x, y, 1); their v.v
    float begin[LANES], end[LANES]; // the bounds of the nearest certain hit
    float rival[LANES];             // the lower bound of all others
    int color[LANES];
} Packet;

static inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

static inline float larger(float a, float b)
{
    return a > b ? a : b;
}

static inline void packet_begin(Packet *packet, const View *view, int column, int row)
{
    for (int i = 0; i < BLOCK; i++) {
        for (int k = 0; k < BLOCK; k++) {
            packet->x[i * BLOCK + k] = view->x[column * BLOCK + k];
            packet->y[i * BLOCK + k] = view->y[row * BLOCK + i];
        }
    }
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        packet->squared[i] = packet->x[i] * packet->x[i] + packet->y[i] * packet->y[i] + 1;
        packet->begin[i] = packet->end[i] = packet->rival[i] = INFINITY;
        packet->color[i] = view->background;
    }
}

// |c x v|^2
static inline float aside(const Seen *seen, float x, float y)
{
    float a = seen->y - seen->z * y, b = seen->z * x - seen->x, c = seen->x * y - seen->y * x;
    return a * a + b * b + c * c;
}

// Whether any ray may hit the sphere before its nearest certain hit: D >= 0, and c.v - sqrt(D) <=
// end. That is true if c.v - end is not positive, or if its square is at most D. So only a few
// spheres need square roots. D is that of the larger sphere, so no sphere is left out.
static inline bool packet_may_see(const Packet *packet, const Seen *seen)
{
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < LANES; i++) {
        float x = packet->x[i], y = packet->y[i], a = packet->squared[i];
        float along = seen->x * x + seen->y * y + seen->z;
        float behind = along - seen->doubt * a - packet->end[i];
        behind = behind > 0 ? behind : 0;
        any |= seen->larger * a - aside(seen, x, y) >= behind * behind;
    }
    return any != 0;
}

static inline float root(float d)
{
    return sqrtf(d > 0 ? d : 0);
}

// Ray i learns about a sphere: it hits the sphere between begin and end. If end is infinite, it may
// hit the sphere, at begin or later; if both are infinite, it misses.
static inline void packet_take(Packet *packet, int i, int color, float begin, float end)
{
    float old_begin = packet->begin[i], old_end = packet->end[i], rival = packet->rival[i];
    int old_color = packet->color[i];
    bool wins = end < old_end;
    float loser = wins ? old_begin : begin;
    packet->begin[i] = wins ? begin : old_begin;
    packet->end[i] = smaller(end, old_end);
    packet->color[i] = wins ? color : old_color;
    packet->rival[i] = loser < rival ? loser : rival;
}

// Asks a sphere, which is between a larger and a smaller one: the ray enters the larger one first.
static inline void packet_see(Packet *packet, const Seen *seen, int color)
{
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float x = packet->x[i], y = packet->y[i], a = packet->squared[i];
        float along = seen->x * x + seen->y * y + seen->z, across = aside(seen, x, y);
        float most = seen->larger * a - across, least = seen->smaller * a - across;
        float begin = along - seen->doubt * a - root(most);
        float end = along + seen->doubt * a - root(least);
        most = along > 0 ? most : -1; // behind the eye
        least = along > 0 ? least : -1;
        begin = most >= 0 ? begin : INFINITY;
        end = least >= 0 ? end : INFINITY;
        packet_take(packet, i, color, begin, end);
    }
}

// The eye is in the sphere: every ray hits it, on its way out.
static inline void packet_see_around(Packet *packet, const Seen *seen, int color)
{
    for (int i = 0; i < LANES; i++) {
        float x = packet->x[i], y = packet->y[i], a = packet->squared[i];
        float along = seen->x * x + seen->y * y + seen->z, across = aside(seen, x, y);
        packet_take(packet, i, color, along - seen->doubt * a + root(seen->smaller * a - across),
                    along + seen->doubt * a + root(seen->larger * a - across));
    }
}

// Gives the 16 colours to the tile. The nearest is certain if no other can begin before its end.
static inline void packet_end(const Packet *packet, int column, int row, Tile *tile)
{
    int colors[LANES], doubts = 0;
#pragma omp simd reduction(| : doubts)
    for (int i = 0; i < LANES; i++) {
        float end = packet->end[i], rival = packet->rival[i];
        bool doubt = rival <= end && rival < INFINITY;
        colors[i] = doubt ? IN_DOUBT : packet->color[i];
        doubts |= doubt;
    }
    tile->doubts |= doubts;
    int *to = tile->colors + ((row - tile->row) * TILE + (column - tile->column)) * BLOCK;
    for (int i = 0; i < BLOCK; i++)
        memcpy(to + i * TILE, colors + i * BLOCK, BLOCK * sizeof *colors);
}

#endif
