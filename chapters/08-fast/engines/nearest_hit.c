// nearest_hit.c - the nearest hit of one ray. It enters nearer boxes first, and no box that begins
// farther away than a hit that was found.
#include "chapters/08-fast/engines/nearest_hit.h"

#include "chapters/08-fast/engines/slab_test.h"
#include "exercises/05-quadratic.h"

static Hit ask_leaf(const Hierarchy *hierarchy, const Scene *scene, const Node *leaf, Ray ray,
                    const Way *way, Hit nearest)
{
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        int sphere = hierarchy->order[i];
        if (surely_misses(way, ray, &scene->spheres[sphere]))
            continue;
        nearest = nearer(nearest, (Hit){hit_sphere(ray, scene->spheres[sphere]), sphere});
    }
    return nearest;
}

Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray)
{
    if (scene->sphere_count == 0)
        return (Hit){NO_HIT, -1};
    const Node *nodes = hierarchy->nodes;
    Way way = way_of(ray);
    struct {
        int node;
        double entry;
    } waiting[HIERARCHY_DEEPEST]; // a stack: the farther child, while the nearer one is walked
    int count = 0, node = 0;
    Hit nearest = {NO_HIT, -1};
    double enters = entry(&nodes[0].box, &way);
    for (;;) {
        // Because of rounding, a box may begin a little beyond a hit in it.
        if (enters < NO_HIT && enters <= nearest.t * (1 + 1e-9)) {
            if (nodes[node].other == 0) {
                nearest = ask_leaf(hierarchy, scene, &nodes[node], ray, &way, nearest);
            } else {
                int near = node + 1, far = nodes[node].other;
                double near_entry = entry(&nodes[near].box, &way);
                double far_entry = entry(&nodes[far].box, &way);
                bool swap = far_entry < near_entry;
                waiting[count].node = swap ? near : far;
                waiting[count++].entry = swap ? near_entry : far_entry;
                node = swap ? far : near;
                enters = swap ? far_entry : near_entry;
                continue;
            }
        }
        if (count == 0)
            return nearest;
        node = waiting[--count].node;
        enters = waiting[count].entry;
    }
}
