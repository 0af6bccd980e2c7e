// bvh.c - step 3: a hierarchy of boxes, one ray at a time. Every ray asks the spheres on its way.
//
// The ray enters nearer boxes first, and no box that begins farther away than a hit that was found.
// The spheres are asked as in chapter 05, so the picture is the same to the bit.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/questions.h"
#include "common/clock.h"
#include "exercises/05-quadratic.h"

// ---- boxes on the way of a ray ----------------------------------------------------------------

// A ray, and the numbers that all boxes and spheres need: for each axis, 1 / direction and whether
// the ray goes backwards; and 1 / v.v, which is NaN if squares would leave the range of a double.
typedef struct {
    double origin[3], inverse[3];
    bool backwards[3];
    double per_squared;
} PreparedRay;

static inline PreparedRay prepare(Ray ray)
{
    PreparedRay prepared;
    for (int i = 0; i < 3; i++) {
        prepared.origin[i] = ray.origin[i];
        prepared.inverse[i] = 1 / ray.direction[i];
        prepared.backwards[i] = prepared.inverse[i] < 0;
    }
    double squared = vec3_dot(ray.direction, ray.direction);
    prepared.per_squared = squared > 1e-100 && squared < 1e100 ? 1 / squared : NAN;
    return prepared;
}

// The part of the ray between two opposite sides of a box. If the ray is in the plane of a side,
// this is 0 times infinity, NaN; comparing with NaN is false, so it changes nothing.
static inline void clip(const PreparedRay *prepared, int axis, const Box *box, double *enters,
                        double *leaves)
{
    double low = box->low[axis], high = box->high[axis];
    bool backwards = prepared->backwards[axis];
    double near = ((backwards ? high : low) - prepared->origin[axis]) * prepared->inverse[axis];
    double far = ((backwards ? low : high) - prepared->origin[axis]) * prepared->inverse[axis];
    *enters = near > *enters ? near : *enters;
    *leaves = far < *leaves ? far : *leaves;
}

// The t at which the ray enters a box (0 if it starts inside); infinite if it misses the box. The
// slabs between opposite sides, one after the other (Kay and Kajiya, 'Ray Tracing Complex Scenes',
// 1986).
static inline double entry(const Box *box, const PreparedRay *prepared)
{
    double enters = 0, leaves = INFINITY;
    clip(prepared, 0, box, &enters, &leaves);
    clip(prepared, 1, box, &enters, &leaves);
    clip(prepared, 2, box, &enters, &leaves);
    return enters <= leaves ? enters : INFINITY;
}

// Whether the ray misses the sphere by so much that rounding cannot make it a hit: by Pythagoras,
// which is faster than chapter 05, and less exact. The margins are many times the rounding error of
// both.
static inline bool surely_misses(const PreparedRay *prepared, Ray ray, const Sphere *sphere)
{
    vec3 p = sphere->center - ray.origin;
    double along = vec3_dot(p, ray.direction), pp = vec3_dot(p, p), r = sphere->radius;
    return pp - along * along * prepared->per_squared > r * r * (1 + 1e-9) + pp * 1e-12 + 1e-250;
}

// ---- the walk ---------------------------------------------------------------------------------

static Hit ask_leaf(const Hierarchy *hierarchy, const Scene *scene, const Node *leaf, Ray ray,
                    const PreparedRay *prepared, Hit nearest)
{
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        int sphere = hierarchy->order[i];
        if (surely_misses(prepared, ray, &scene->spheres[sphere])) {
            ray_is_asked();
            continue;
        }
        nearest = nearer(nearest, (Hit){hit_sphere(ray, scene->spheres[sphere]), sphere});
    }
    return nearest;
}

Hit hierarchy_nearest(const Hierarchy *hierarchy, const Scene *scene, Ray ray)
{
    if (scene->sphere_count == 0)
        return (Hit){NO_HIT, -1};
    const Node *nodes = hierarchy->nodes;
    PreparedRay prepared = prepare(ray);
    struct {
        int node;
        double entry;
    } waiting[HIERARCHY_DEEPEST]; // a stack: the farther child, while the nearer one is walked
    int count = 0, node = 0;
    Hit nearest = {NO_HIT, -1};
    double enters = entry(&nodes[0].box, &prepared);
    for (;;) {
        // Because of rounding, a box may begin a little beyond a hit in it.
        if (enters < NO_HIT && enters <= nearest.t * (1 + 1e-9)) {
            if (nodes[node].other == 0) {
                nearest = ask_leaf(hierarchy, scene, &nodes[node], ray, &prepared, nearest);
            } else {
                int near = node + 1, far = nodes[node].other;
                double near_entry = entry(&nodes[near].box, &prepared);
                double far_entry = entry(&nodes[far].box, &prepared);
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

// ---- the picture ------------------------------------------------------------------------------

static Hit nearest_of(const void *of, const Scene *scene, Ray ray)
{
    return hierarchy_nearest(of, scene, ray);
}

bool cast_bvh(const Work *work, Message *message)
{
    if (extreme_scene(work))
        return cast_extreme(work, message);
    Hierarchy hierarchy;
    if (!hierarchy_build(&hierarchy, work->scene, SMALL_LEAF))
        return message_set(message, "no memory for a hierarchy of %d spheres",
                           work->scene->sphere_count);
    if (work->built != NULL)
        *work->built = clock_seconds();
    bool done = cast_rays(work, nearest_of, &hierarchy, message);
    hierarchy_free(&hierarchy);
    return done;
}
