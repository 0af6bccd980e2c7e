// nearest.c - what one ray hits: nearer boxes first, and none that begins behind what is hit
// already.
#include "chapters/08-fast/nearest.h"

#include "exercises/05-quadratic.h"

// Where the ray enters a box (0 where it starts inside); infinite where it misses it. The slabs
// between opposite sides, one after the other (Kay and Kajiya, 'Ray Tracing Complex Scenes', 1986).
static double entry(const Box *box, vec3 origin, vec3 inverse)
{
    double enters = 0, leaves = INFINITY;
    for (int i = 0; i < 3; i++) {
        double a = (box->low[i] - origin[i]) * inverse[i];
        double b = (box->high[i] - origin[i]) * inverse[i];
        double near = a < b ? a : b, far = a < b ? b : a;
        enters = near > enters ? near : enters;
        leaves = far < leaves ? far : leaves;
    }
    return enters <= leaves ? enters : INFINITY;
}

static Hit ask_leaf(const Hierarchy *hierarchy, const Scene *scene, const Node *leaf, Ray ray,
                    Hit nearest)
{
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        int sphere = hierarchy->order[i];
        double t = hit_sphere(ray, scene->spheres[sphere]);
        if (t < nearest.t || (t == nearest.t && t < NO_HIT && sphere < nearest.sphere))
            nearest = (Hit){t, sphere};
    }
    return nearest;
}

Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray)
{
    if (scene->sphere_count == 0)
        return (Hit){NO_HIT, -1};
    const Node *nodes = hierarchy->nodes;
    vec3 inverse = vec3_of(1, 1, 1) / ray.direction;
    struct {
        int node;
        double entry;
    } waiting[HIERARCHY_DEEPEST];
    int count = 0, node = 0;
    Hit nearest = {NO_HIT, -1};
    double enters = entry(&nodes[0].box, ray.origin, inverse);
    for (;;) {
        // A box may begin a rounding behind a hit in it.
        if (enters < NO_HIT && enters <= nearest.t * (1 + 1e-9)) {
            if (nodes[node].other == 0) {
                nearest = ask_leaf(hierarchy, scene, &nodes[node], ray, nearest);
            } else {
                int near = node + 1, far = nodes[node].other;
                double near_entry = entry(&nodes[near].box, ray.origin, inverse);
                double far_entry = entry(&nodes[far].box, ray.origin, inverse);
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
