// nearest_hit.h - the nearest hit of one ray, by a hierarchy.
#ifndef CHAPTERS_08_FAST_ENGINES_NEAREST_HIT_H
#define CHAPTERS_08_FAST_ENGINES_NEAREST_HIT_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "common/ray.h"

// The nearer of two hits; as in chapter 06, the lower index wins if both are equally near.
static inline Hit nearer(Hit a, Hit b)
{
    bool b_wins = b.t < a.t || (b.t == a.t && b.t < NO_HIT && b.sphere < a.sphere);
    return b_wins ? b : a;
}

// The same hit as chapter 06's nearest_hit, to the bit.
Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray);

#endif
