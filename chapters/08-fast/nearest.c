// nearest.c - what one ray hits: nearer boxes first, and none that begins behind what is hit
// already.
#include "chapters/08-fast/nearest.h"

#include "exercises/05-quadratic.h"

// A ray and, for each axis, 1 / direction and whether it goes backwards; and 1 / v.v, which is not
// a number where squares would leave the range of a double.
typedef struct {
    double origin[3], inverse[3];
    bool backwards[3];
    double per_squared;
} Way;

static Way way_of(Ray ray)
{
    Way way;
    for (int i = 0; i < 3; i++) {
        way.origin[i] = ray.origin[i];
        way.inverse[i] = 1 / ray.direction[i];
        way.backwards[i] = way.inverse[i] < 0;
    }
    double squared = vec3_dot(ray.direction, ray.direction);
    way.per_squared = squared > 1e-100 && squared < 1e100 ? 1 / squared : NAN;
    return way;
}

// What of the way lies between two opposite sides of a box. In the plane of a side that is 0 times
// infinity, which is no number; comparing with it is false, so it changes nothing.
static inline void clip(const Way *way, int axis, const Box *box, double *enters, double *leaves)
{
    double low = box->low[axis], high = box->high[axis];
    bool backwards = way->backwards[axis];
    double near = ((backwards ? high : low) - way->origin[axis]) * way->inverse[axis];
    double far = ((backwards ? low : high) - way->origin[axis]) * way->inverse[axis];
    *enters = near > *enters ? near : *enters;
    *leaves = far < *leaves ? far : *leaves;
}

// Where the ray enters a box (0 where it starts inside); infinite where it misses it. The slabs
// between opposite sides, one after the other (Kay and Kajiya, 'Ray Tracing Complex Scenes', 1986).
static inline double entry(const Box *box, const Way *way)
{
    double enters = 0, leaves = INFINITY;
    clip(way, 0, box, &enters, &leaves);
    clip(way, 1, box, &enters, &leaves);
    clip(way, 2, box, &enters, &leaves);
    return enters <= leaves ? enters : INFINITY;
}

// Whether the ray passes so far beside the sphere that rounding makes no hit of it: by Pythagoras,
// which is quicker than chapter 05, and less exact. The margins are many times what is rounded off
// on either way.
static inline bool surely_misses(const Way *way, Ray ray, const Sphere *sphere)
{
    vec3 p = sphere->center - ray.origin;
    double along = vec3_dot(p, ray.direction), pp = vec3_dot(p, p), r = sphere->radius;
    return pp - along * along * way->per_squared > r * r * (1 + 1e-9) + pp * 1e-12 + 1e-250;
}

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
        // A box may begin a rounding behind a hit in it.
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
