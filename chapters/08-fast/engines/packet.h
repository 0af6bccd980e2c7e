// packet.h - 16 rays at a time: what they see so far, and how they ask one sphere.
//
// The rays compare t v.v = c.v - sqrt(D) (float_scene.h), so that they need not divide. It is
// between two known bounds. A sphere is certainly the nearest if the lower bounds of all others are
// greater than its upper bound.
#ifndef CHAPTERS_08_FAST_PACKET_H
#define CHAPTERS_08_FAST_PACKET_H

#include "chapters/08-fast/engines/float_scene.h"
#include "chapters/08-fast/engines/questions.h"

#include <stdalign.h>
#include <stdbool.h>
#include <string.h>

typedef struct {
    alignas(64) float x[LANES];     // aligned to a cache line, where vectors are read fastest
    float y[LANES], squared[LANES]; // the rays are (x, y, 1); their v.v
    float begin[LANES], end[LANES]; // the bounds of the nearest certain hit
    float rival[LANES];             // the lower bound of all others
    int color[LANES];
} Packet;

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
// spheres need square roots. D is that of the first sphere, so no sphere is left out.
static inline bool packet_may_see(const Packet *packet, const Seen *seen, int column, int row)
{
    pixels_are_asked(column * BLOCK, (column + 1) * BLOCK, row * BLOCK, (row + 1) * BLOCK);
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < LANES; i++) {
        float x = packet->x[i], y = packet->y[i], a = packet->squared[i];
        float along = seen->x * x + seen->y * y + seen->z;
        float behind = along - seen->doubt * a - packet->end[i];
        behind = behind > 0 ? behind : 0;
        any |= seen->first * a - aside(seen, x, y) >= behind * behind;
    }
    return any != 0;
}

static inline float root(float d)
{
    return sqrtf(d > 0 ? d : 0);
}

// Asks a sphere: each ray certainly hits it between begin and end. If end is infinite, the ray may
// hit it, at begin or later; if both are infinite, it misses.
static inline void packet_see(Packet *packet, const Seen *seen)
{
    const float behind = seen->side > 0 ? 0 : -INFINITY; // from inside, nothing is behind the eye
#pragma omp simd
    for (int i = 0; i < LANES; i++) {
        float x = packet->x[i], y = packet->y[i], a = packet->squared[i];
        float along = seen->x * x + seen->y * y + seen->z, across = aside(seen, x, y);
        float first = seen->first * a - across, second = seen->second * a - across;
        float begin = along - seen->doubt * a - seen->side * root(first);
        float end = along + seen->doubt * a - seen->side * root(second);
        first = along > behind ? first : -1;
        second = along > behind ? second : -1;
        begin = first >= 0 ? begin : INFINITY;
        end = second >= 0 ? end : INFINITY;

        float old_begin = packet->begin[i], old_end = packet->end[i], rival = packet->rival[i];
        int old_color = packet->color[i];
        bool wins = end < old_end;
        float loser = wins ? old_begin : begin;
        packet->begin[i] = wins ? begin : old_begin;
        packet->end[i] = smaller(end, old_end);
        packet->color[i] = wins ? seen->color : old_color;
        packet->rival[i] = smaller(loser, rival);
    }
}

// Gives the 16 colors to the tile. The nearest is certain if no other can begin before its end.
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
