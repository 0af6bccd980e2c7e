// light_grid.c - the bins of step 6, seen from a light.
//
// Shadow rays to a point light all end in one place. Backwards they are rays from an eye: every
// cell of a grid in front of the light lists the spheres that it shows. (Haines and Greenberg, 'The
// Light Buffer', 1986.)
//
// The giants are not in it: every ray asks them.
#include "chapters/08-fast/engines/light.h"

#include <stdlib.h>

// Up to this distance from the light, in sizes of the scene, a pixel of its picture is much larger
// than all rounding errors; up to this slope, it is not much longer than wide.
#define FARTHEST 1e8
#define STEEPEST 40
#define NOT_STEEP 2

// If a light looks forward, how far rays to its spheres go aside for each step ahead; infinite if
// some go back. And the sum of the spheres' areas on the plane at distance 1.
typedef struct {
    double slope, area;
} Sight;

// If the slope is more than enough, it is not finished.
static Sight sight(const Bins *bins, vec3 forward, double enough)
{
    const Scene *scene = bins->scene;
    Sight sight = {0, 0};
    for (int i = 0; i < scene->sphere_count && sight.slope < enough; i++) {
        if (bins->numbers[i] >= bins->end)
            continue;
        const vec3 c = scene->spheres[i].center - bins->from;
        const double r = scene->spheres[i].radius, cc = vec3_dot(c, c), distance = sqrt(cc);
        const double ahead = vec3_dot(c, forward), aside = sqrt(fmax(cc - ahead * ahead, 0));
        // The ray that touches the sphere on the side farther from the middle.
        const double tangent = sqrt(cc - r * r), x = aside * tangent + ahead * r;
        const double y = ahead * tangent - aside * r;
        const bool seen = distance > 1.001 * r && distance < FARTHEST * r && y > 0;
        sight.slope = fmax(sight.slope, seen ? x / y : INFINITY);
        sight.area += r * r * distance / (ahead * ahead * ahead);
    }
    return sight;
}

// The light looks at the middle of the spheres; or along an axis of the world, as a lamp looks at
// the floor.
static Sight look(Bins *bins)
{
    const Scene *scene = bins->scene;
    vec3 best = {0}, middle = {0};
    Sight least = {INFINITY, 0};
    for (int i = 0; i < scene->sphere_count; i++)
        if (bins->numbers[i] < bins->end)
            middle += vec3_unit(scene->spheres[i].center - bins->from);
    for (int way = 0; way < 7 && least.slope > NOT_STEEP; way++) {
        vec3 forward = way == 0 ? vec3_unit(middle) : (vec3){0};
        if (way > 0)
            forward[way % 3] = way <= 3 ? -1 : 1;
        const Sight seen = sight(bins, forward, least.slope);
        if (seen.slope < least.slope) {
            least = seen;
            best = forward;
        }
    }
    vec3 aside = fabs(best[0]) < 0.6 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0);
    vec3 right = vec3_unit(vec3_cross(best, aside));
    view_store(bins->eye.forward, best);
    view_store(bins->eye.right, right);
    view_store(bins->eye.up, vec3_cross(right, best));
    bins->eye.margin = 0.5 + ROUNDING; // rays between the pixels' centers
    return least;
}

// Near items first. False if there is not enough memory.
static bool sort_cells(const Bins *bins, long long count)
{
    const BinsShare *cells = &bins->shares[0];
    const BinsLanes *lanes = LANES_BEST(bins);
    Item *items = malloc((2 * (size_t)count + 1) * sizeof *items);
    for (int cell = 0; cell < bins->columns * bins->rows && items != NULL; cell++) {
        Item *shown = &bins->items[cells->begin[cell]];
        const size_t size = cells->next[cell] - cells->begin[cell];
        memcpy(items, shown, size * sizeof *items);
        memcpy(shown, lanes->sort(items, size), size * sizeof *items);
    }
    free(items);
    return items != NULL;
}

bool light_grid_build(Bins *bins, const Scene *scene, const WideHierarchy *wide, Light light)
{
    *bins = (Bins){
        .scene = scene, .numbers = wide->places, .end = wide->giants, .from = light.position};
    const int spheres = scene->sphere_count;
    if (wide->giants == 0 || spheres >> ITEM_SPHERE > 0 || light.kind == LIGHT_DISTANT)
        return true;
    const Sight seen = look(bins);
    const double slope = 1.001 * seen.slope;
    if (!(slope < STEEPEST))
        return true;
    // Few cells for each sphere, and few spheres in each cell: a sphere that is x cells wide is in
    // about (1 + x)^2, which is at most 2 + 2 x^2. With smaller cells, building costs more than the
    // rays save.
    enum { FEWEST = 16, MOST = 1024 };
    const double most = 8.0 * spheres + (1 << 16);
    int columns = (int)fmin(sqrt(32.0 * spheres + (1 << 15)), MOST);
    while (columns > FEWEST && 2 * (spheres + pow(columns / slope, 2) * seen.area) > most)
        columns /= 2;
    bins->columns = bins->rows = columns;
    bins->eye.width = bins->eye.height = columns * SIDE;
    bins->eye.across = bins->eye.down = columns * SIDE / (2 * slope);
    long long count = bins_count(bins, 1);
    if ((double)count <= 2 * most)
        return count >= 0 && bins_fill(bins, count) && sort_cells(bins, count);
    bins_free(bins);
    *bins = (Bins){.scene = scene}; // too many for their memory to be worth it
    return true;
}
