// light_grid.c - the bins of step 6, seen from a light.
//
// Shadow rays to a point light all end in one place. Backwards they are rays from an eye: every
// cell of a grid in front of the light lists the spheres that it shows. (Haines and Greenberg, 'The
// Light Buffer', 1986.)
//
// A few giants, such as a ground or a sky, would make the grid so large that everything else is in
// one cell. They are not in it: every ray asks them. A giant is larger than the box around the
// centers of the others.
#include "chapters/08-fast/engines/light.h"

#include <stdlib.h>

// Up to this distance from the light, in sizes of the scene, a pixel of its picture is much larger
// than all rounding errors.
#define FARTHEST 1e8

// The light looks at the middle of a ball around the spheres that are no giants, and must be
// outside of it. Sets how far rays go aside for each step ahead, and the sum of the squares of
// radius / distance. False if there is no grid.
static bool look(LightGrid *grid, const WideHierarchy *wide, Light light, double *slope,
                 double *squares)
{
    Bins *bins = &grid->bins;
    const Scene *scene = bins->scene;
    vec3 middle;
    bins->largest = INFINITY;
    for (int i = 0; i <= MOST_GIANTS; i++) { // without one giant, others stand out
        double extent = extent_of(scene, bins->largest, &middle);
        if (i == MOST_GIANTS || !(extent < bins->largest))
            break;
        bins->largest = extent;
    }
    vec3 towards = middle - light.position;
    double distance = vec3_length(towards), radius = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        const Sphere *sphere = &scene->spheres[i];
        if (sphere->radius <= bins->largest) {
            radius = fmax(radius, vec3_length(sphere->center - middle) + sphere->radius);
            *squares += pow(sphere->radius / vec3_length(sphere->center - light.position), 2);
        } else if (grid->giant_count < MOST_GIANTS)
            grid->giants[grid->giant_count++] = wide->places[i];
        else
            return false;
    }
    if (light.kind == LIGHT_DISTANT || !(distance > 1.05 * radius && distance < FARTHEST * radius))
        return false;
    *slope = 1.001 * radius / sqrt(distance * distance - radius * radius);
    vec3 forward = towards / distance;
    vec3 aside = fabs(forward[0]) < 0.6 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0);
    vec3 right = vec3_unit(vec3_cross(forward, aside));
    bins->from = light.position;
    view_store(bins->eye.forward, forward);
    view_store(bins->eye.right, right);
    view_store(bins->eye.up, vec3_cross(right, forward));
    bins->eye.margin = 0.5 + ROUNDING; // rays between the pixels' centers
    return true;
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

bool light_grid_build(LightGrid *grid, const Scene *scene, const WideHierarchy *wide, Light light)
{
    *grid = (LightGrid){.bins = {.scene = scene, .numbers = wide->places}};
    Bins *bins = &grid->bins;
    const int spheres = scene->sphere_count;
    double slope, squares = 0;
    if (spheres == 0 || spheres >> ITEM_SPHERE > 0 || !look(grid, wide, light, &slope, &squares))
        return true;
    // Few cells for each sphere, and few spheres in each cell: a sphere that is x cells wide is in
    // about (1 + x)^2, which is at most 2 + 2 x^2. With smaller cells, building costs more than the
    // rays save.
    enum { FEWEST = 16, MOST = 1024 };
    const double most = 8.0 * spheres + (1 << 16);
    int columns = (int)fmin(sqrt(32.0 * spheres + (1 << 15)), MOST);
    while (columns > FEWEST && 2 * (spheres + pow(columns / slope, 2) * squares) > most)
        columns /= 2;
    bins->columns = bins->rows = columns;
    bins->eye.width = bins->eye.height = columns * SIDE;
    bins->eye.across = bins->eye.down = columns * SIDE / (2 * slope);
    long long count = bins_count(bins, 1);
    if ((double)count <= 2 * most)
        return count >= 0 && bins_fill(bins, count) && sort_cells(bins, count);
    bins_free(bins);
    *grid = (LightGrid){.bins = {.scene = scene}}; // too many for their memory to be worth it
    return true;
}
