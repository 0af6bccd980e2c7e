// nearest.h - what one ray hits, by a hierarchy.
#ifndef CHAPTERS_08_FAST_NEAREST_H
#define CHAPTERS_08_FAST_NEAREST_H

#include "chapters/08-fast/hierarchy.h"
#include "common/ray.h"

// The same hit as chapter 06's nearest_hit, to the bit.
Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray);

#endif
