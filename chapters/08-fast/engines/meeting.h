// meeting.h - where a line meets a sphere, in doubles, with margins for rounding.
#ifndef CHAPTERS_08_FAST_ENGINES_MEETING_H
#define CHAPTERS_08_FAST_ENGINES_MEETING_H

#include "chapters/08-fast/engines/any_ray.h"

#include <math.h>

// The margin for a number that is the difference of two: many times their rounding error.
#define MARGIN 1e-12

// A line may meet a sphere at begin or later; if end is finite, it certainly does, between begin
// and end.
typedef struct {
    double begin, end;
} Meeting;

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

// A sphere with its centre at (x, y, z) from the start of the line, and the radius r.
static inline Meeting meet(double x, double y, double z, double r, const Line *line)
{
    double rr = r * r;
    double along = x * line->direction[0] + y * line->direction[1] + z * line->direction[2];
    double pp = x * x + y * y + z * z, margin = MARGIN * (pp + rr), outside = pp - rr;
    double d = rr - pp + along * along, least = d - margin;
    if (d + margin < 0 || (along < 0 && outside > margin))
        return (Meeting){INFINITY, INFINITY};
    double longest = sqrt(larger(d + margin, 0)), shortest = sqrt(larger(least, 0));
    double slack = MARGIN * (fabs(along) + r);
    if (outside > margin && least >= 0 && along - longest - slack > 0)
        return (Meeting){along - longest - slack, along - shortest + slack};
    if (outside > margin)
        return (Meeting){larger(along - longest - slack, 0), INFINITY};
    if (outside < -margin && along + shortest - slack > 0)
        return (Meeting){along + shortest - slack, along + longest + slack};
    return (Meeting){0, INFINITY};
}

static inline void add_candidate(PossibleHits *candidates, int place)
{
    if (candidates->count < MOST_CANDIDATES)
        candidates->places[candidates->count] = place;
    candidates->count++;
}

#endif
