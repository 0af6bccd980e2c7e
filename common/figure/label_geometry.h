// label_geometry.h - boxes, spots and lines on the canvas, for the labels of a figure: shared by
// the files that implement labels.h. They are asked millions of times: small, and in a header.
#ifndef COMMON_FIGURE_LABEL_GEOMETRY_H
#define COMMON_FIGURE_LABEL_GEOMETRY_H

#include "common/figure/labels.h"

#include <math.h>

// Of numbers, never of NaN: fmin and fmax take several times as long.
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline Area box_of(const PlacedLabel *label, Spot middle)
{
    return (Area){middle.u - label->width / 2, middle.u + label->width / 2,
                  middle.v - label->height / 2, middle.v + label->height / 2};
}

static inline Area grown(Area box, double by)
{
    return (Area){box.left - by, box.right + by, box.bottom - by, box.top + by};
}

static inline bool overlap(Area a, Area b)
{
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

static inline Spot between(Spot from, Spot to, double part)
{
    return (Spot){from.u + part * (to.u - from.u), from.v + part * (to.v - from.v)};
}

// Nearly: hypot takes five times as long.
static inline double nearly_long(Spot by)
{
    return sqrt(by.u * by.u + by.v * by.v);
}

static inline double spots_apart(Spot a, Spot b)
{
    return hypot(a.u - b.u, a.v - b.v);
}

// From the box to a spot, to the right or left and up or down; 0 inside.
static inline Spot aside(Area box, Spot spot)
{
    return (Spot){larger(0, larger(box.left - spot.u, spot.u - box.right)),
                  larger(0, larger(box.bottom - spot.v, spot.v - box.top))};
}

static inline double away(Area box, Spot spot)
{
    Spot by = aside(box, spot);
    return by.u == 0 || by.v == 0 ? by.u + by.v : hypot(by.u, by.v);
}

// The part of a line between low and high in one direction: narrows first .. last, and is false if
// nothing is left.
static inline bool cut(double from, double to, double low, double high, double *first, double *last)
{
    double d = to - from;
    if (d == 0)
        return from >= low && from <= high;
    double a = (low - from) / d, b = (high - from) / d;
    *first = larger(*first, smaller(a, b));
    *last = smaller(*last, larger(a, b));
    return *first <= *last;
}

static inline bool beyond(double a, double b, double low, double high)
{
    return (a < low && b < low) || (a > high && b > high);
}

static inline bool crosses(Area box, Spot from, Spot to)
{
    if (beyond(from.u, to.u, box.left, box.right) || beyond(from.v, to.v, box.bottom, box.top))
        return false;
    double first = 0, last = 1;
    return cut(from.u, to.u, box.left, box.right, &first, &last) &&
           cut(from.v, to.v, box.bottom, box.top, &first, &last);
}

// How near a line comes to a spot, and where.
static inline Spot nearest_on(Spot from, Spot to, Spot spot)
{
    double u = to.u - from.u, v = to.v - from.v, long2 = u * u + v * v;
    double part = long2 > 0 ? ((spot.u - from.u) * u + (spot.v - from.v) * v) / long2 : 0;
    return between(from, to, smaller(1, larger(0, part)));
}

// From the box to a line: between two that do not meet, one of the corners or one of the ends is
// nearest.
static inline double distance(Area box, Spot from, Spot to)
{
    if (from.u == to.u && from.v == to.v)
        return away(box, from);
    if (crosses(box, from, to))
        return 0;
    const Spot corners[] = {
        {box.left, box.bottom}, {box.right, box.bottom}, {box.left, box.top}, {box.right, box.top}};
    double least = smaller(away(box, from), away(box, to));
    for (int i = 0; i < 4; i++)
        least = smaller(least, spots_apart(nearest_on(from, to, corners[i]), corners[i]));
    return least;
}

#endif
