// clipped_circle.c - a disc cut at a window's four edges.
#include "chapters/06-ray-casting/figures/clipped_circle.h"

#include "common/vec3.h"

#include <math.h>
#include <string.h>

// Keeps the part on the window's side of one edge: sign * at[axis] <= sign * limit.
static int cut(Place *places, int count, int axis, double limit, double sign)
{
    Place left[MOST_PLACES];
    int kept = 0;
    for (int i = 0; i < count; i++) {
        Place a = places[i], b = places[(i + 1) % count];
        double a_over = sign * (a.at[axis] - limit), b_over = sign * (b.at[axis] - limit);
        if (a_over <= 0)
            left[kept++] = a;
        if ((a_over <= 0) != (b_over <= 0)) {
            double part = a_over / (a_over - b_over);
            Place edge = {.on_circle = false};
            edge.at[1 - axis] = a.at[1 - axis] + part * (b.at[1 - axis] - a.at[1 - axis]);
            edge.at[axis] = limit;
            left[kept++] = edge;
        }
    }
    memcpy(places, left, (size_t)kept * sizeof *places);
    return kept;
}

int window_part(Window window, const double middle[2], double radius, Place places[MOST_PLACES])
{
    // Only the sector that contains the window, because a whole large circle would not be smooth.
    double x = (window.low[0] + window.high[0]) / 2 - middle[0];
    double y = (window.low[1] + window.high[1]) / 2 - middle[1];
    double half = hypot(window.high[0] - window.low[0], window.high[1] - window.low[1]) / 2;
    double flat = half / fmin(radius, hypot(x, y));
    double wide = flat < 1 ? asin(flat) : PI, towards = atan2(y, x);
    int count = 0;
    for (int k = 0; k <= ARC_PLACES; k++) {
        double angle = towards + wide * (2.0 * k / ARC_PLACES - 1);
        places[count++] =
            (Place){{middle[0] + radius * cos(angle), middle[1] + radius * sin(angle)}, true};
    }
    if (flat < 1)
        places[count++] = (Place){{middle[0], middle[1]}, false};
    for (int axis = 0; axis < 2; axis++) {
        count = cut(places, count, axis, window.low[axis], -1);
        count = cut(places, count, axis, window.high[axis], 1);
    }
    return count;
}
