// bvh.c - step 3: a hierarchy of boxes, one ray at a time. Every ray asks the spheres on its way.
//
// Nearer boxes first, and none that begins behind what is hit already. The spheres are asked as in
// chapter 05, so the picture is the same to the bit.
#include "chapters/08-fast/engine.h"

#include "chapters/08-fast/hierarchy.h"
#include "chapters/08-fast/paint.h"
#include "chapters/08-fast/parallel.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <stdlib.h>

typedef struct {
    const Work *work;
    const Paint *paints;
    Hierarchy hierarchy;
} ByRay;

// Where the ray enters a box (0 where it starts inside); infinite where it misses it. The slabs
// between opposite sides, one after the other (Kay and Kajiya, 'Ray Tracing Complex Scenes', 1986).
static double entry(const Box *box, vec3 origin, vec3 inverse)
{
    double enters = 0, leaves = INFINITY;
    for (int i = 0; i < 3; i++) {
        double a = (box->low[i] - origin[i]) * inverse[i];
        double b = (box->high[i] - origin[i]) * inverse[i];
        enters = fmax(enters, fmin(a, b));
        leaves = fmin(leaves, fmax(a, b));
    }
    return enters <= leaves ? enters : INFINITY;
}

static Hit ask_leaf(const ByRay *by_ray, const Node *leaf, Ray ray, Hit nearest)
{
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        int sphere = by_ray->hierarchy.order[i];
        double t = hit_sphere(ray, by_ray->work->scene->spheres[sphere]);
        if (t < nearest.t || (t == nearest.t && t < NO_HIT && sphere < nearest.sphere))
            nearest = (Hit){t, sphere};
    }
    return nearest;
}

static Hit nearest_on_the_way(const ByRay *by_ray, Ray ray)
{
    if (by_ray->work->scene->sphere_count == 0)
        return (Hit){NO_HIT, -1};
    const Node *nodes = by_ray->hierarchy.nodes;
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
            if (nodes[node].count > 0) {
                nearest = ask_leaf(by_ray, &nodes[node], ray, nearest);
            } else {
                int near = node + 1, far = nodes[node].first;
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

static void cast_row(void *given, int row)
{
    const ByRay *by_ray = given;
    const Work *work = by_ray->work;
    Resolution screen = work->image->size;
    for (int column = 0; column < screen.width; column++) {
        Hit hit = nearest_on_the_way(by_ray, pixel_ray(work->camera, screen, (Pixel){column, row}));
        size_t pixel = (size_t)row * (size_t)screen.width + (size_t)column;
        paint_pixel(work->image, pixel, work->scene, by_ray->paints, hit.sphere);
    }
}

bool cast_bvh(const Work *work, Message *message)
{
    Paint *paints = paints_of(work->scene);
    ByRay by_ray = {.work = work, .paints = paints};
    bool ready = paints != NULL && hierarchy_build(&by_ray.hierarchy, work->scene);
    if (ready)
        in_parallel(work->threads, work->image->size.height, cast_row, &by_ray);
    else
        message_set(message, "no memory for a hierarchy of %d spheres", work->scene->sphere_count);
    hierarchy_free(&by_ray.hierarchy);
    free(paints);
    return ready;
}
