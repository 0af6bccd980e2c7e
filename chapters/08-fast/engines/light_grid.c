// light_grid.c - the bins of step 6, seen from a light.
//
// To build: giants are left out; the others get places in a picture from the light; these are
// sorted by distance, then into the cells. To ask: shadow rays find their cells, and ask the
// spheres there.
#include "chapters/08-fast/engines/light_grid.h"

#include "chapters/08-fast/engines/bins_lanes.h"
#include "chapters/08-fast/engines/covered_pixels.h"
#include "common/large_pages.h"

#include <stdlib.h>
#include <string.h>

static const BinsLanes *const bins_lanes[LANES_KINDS] = LANES_TABLE(bins);
static const ShadowLanes *const shadow_lanes[LANES_KINDS] = LANES_TABLE(shadow_lanes);

// ---- giants -----------------------------------------------------------------------------------

static void include(Crowd *crowd, int i)
{
    const Sphere *sphere = &crowd->scene->spheres[i];
    for (int axis = 0; axis < 3; axis++) {
        double low = sphere->center[axis] - sphere->radius;
        double high = sphere->center[axis] + sphere->radius;
        crowd->low[axis] = low < crowd->low[axis] ? low : crowd->low[axis];
        crowd->high[axis] = high > crowd->high[axis] ? high : crowd->high[axis];
    }
}

// The largest spheres are giants, if together they make the box at least twice as large.
Crowd crowd_of(const Scene *scene)
{
    Crowd crowd = {.scene = scene,
                   .low = vec3_of(INFINITY, INFINITY, INFINITY),
                   .high = -vec3_of(INFINITY, INFINITY, INFINITY)};
    int *giants = crowd.giants, count = 0;
    for (int i = 0; i < scene->sphere_count; i++) { // by insertion, the largest first
        int at = count;
        while (at > 0 && scene->spheres[giants[at - 1]].radius < scene->spheres[i].radius)
            at--;
        if (at == MOST_GIANTS) {
            include(&crowd, i);
            continue;
        }
        if (count == MOST_GIANTS)
            include(&crowd, giants[--count]);
        for (int k = count++; k > at; k--)
            giants[k] = giants[k - 1];
        giants[at] = i;
    }
    while (count > 0) {
        Crowd more = crowd;
        for (int i = 0; i < count; i++)
            include(&more, giants[i]);
        if (vec3_length(more.high - more.low) > 2 * vec3_length(crowd.high - crowd.low))
            break;
        include(&crowd, giants[--count]);
    }
    crowd.giant_count = count;
    return crowd;
}

static bool is_giant(const Crowd *crowd, int sphere)
{
    for (int i = 0; i < crowd->giant_count; i++)
        if (crowd->giants[i] == sphere)
            return true;
    return false;
}

// ---- pictures ---------------------------------------------------------------------------------

// Up to this distance from the light, in sizes of the scene, a pixel of a picture is much larger
// than all rounding errors.
#define FARTHEST 1e8

static vec3 along_axis(int axis, double length)
{
    vec3 v = vec3_of(0, 0, 0);
    v[axis % 3] = length;
    return v;
}

// Rays to a distant light start on spheres. Farther than that, their cells are not certain.
static bool giants_are_near(const Crowd *crowd, vec3 middle, double size)
{
    for (int i = 0; i < crowd->giant_count; i++) {
        const Sphere *giant = &crowd->scene->spheres[crowd->giants[i]];
        if (!(vec3_length(giant->center - middle) + giant->radius < FARTHEST * size))
            return false;
    }
    return true;
}

// Chooses one picture, of the crowd, or six, of all sides. That of a distant light is drawn by
// parallel rays, from a plane before the crowd.
static void look_around(LightGrid *grid, Light light)
{
    LightCells *cells = &grid->cells;
    vec3 low = grid->crowd->low, high = grid->crowd->high, middle = (low + high) / 2;
    double size = vec3_length(high - low) / 2;
    cells->parallel = light.kind == LIGHT_DISTANT;
    vec3 towards = cells->parallel ? -light.position : middle - light.position;
    double distance = vec3_length(towards);
    vec3 forward = towards / distance, from = light.position;
    cells->slope = 1.001;
    if (cells->parallel) {
        bool usual = distance > 1e-15 && distance < 1e15 && size > 1e-15 && size < 1e15;
        cells->pictures = usual && giants_are_near(grid->crowd, middle, size);
        cells->slope *= size;
        from = middle - 1.001 * size * forward;
    } else {
        cells->pictures = !(distance < FARTHEST * size) ? 0 : distance > 1.2 * size ? 1 : 6;
        cells->slope *= cells->pictures == 1 ? size / sqrt(distance * distance - size * size) : 1;
    }
    view_store(cells->light, from);
    if (cells->pictures != 1)
        return;
    int axis = fabs(forward[0]) < 0.6 ? 0 : 1;
    vec3 right = vec3_unit(vec3_cross(forward, along_axis(axis, 1)));
    view_store(cells->forward, forward);
    view_store(cells->right, right);
    view_store(cells->up, vec3_cross(right, forward));
}

static vec3 light_of(const LightCells *cells)
{
    return vec3_of(cells->light[0], cells->light[1], cells->light[2]);
}

static Eye eye_of(const LightCells *cells, int picture)
{
    Eye eye = {.width = cells->columns * TILE_WIDTH, .height = cells->columns * TILE_HEIGHT};
    eye.across = eye.down = eye.width / (2 * cells->slope);
    if (cells->pictures == 1) {
        memcpy(eye.forward, cells->forward, sizeof eye.forward);
        memcpy(eye.right, cells->right, sizeof eye.right);
        memcpy(eye.up, cells->up, sizeof eye.up);
    } else {
        view_store(eye.forward, along_axis(picture / 2, picture % 2 == 0 ? 1 : -1));
        view_store(eye.right, along_axis(picture / 2 + 1, 1));
        view_store(eye.up, along_axis(picture / 2 + 2, 1));
    }
    return eye;
}

static inline double along(vec3 v, const double axis[3])
{
    return v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
}

// Whether a picture may show some of a sphere with this centre from the light: it is not beyond one
// of the picture's four sides.
static bool may_show(const Eye *eye, double slope, vec3 center, double radius)
{
    double ahead = along(center, eye->forward);
    double right = fabs(along(center, eye->right)), up = fabs(along(center, eye->up));
    return (right > up ? right : up) - slope * ahead <=
           radius * sqrt(1 + slope * slope) * (1 + 1e-9);
}

// ---- building ---------------------------------------------------------------------------------

// The spheres that a cell lists, and NOT_LISTED after them. Few rays need more.
enum { MOST_LISTED = 16 };
// Places by their distance; place_depth, without the sign that no distance has.
enum { DEPTHS = 1 << (31 - PLACE_DROPPED) };

// Places count cells here, with the rows of all pictures below each other.
typedef struct {
    LightGrid *grid;
    int columns, rows;
    Place *places;
    int count;
    uint32_t *depths;  // how many places have each; later, where the next one goes
    uint32_t *corners; // see count_cells; later, how many places each cell has
} Building;

// Cells are so large that there are few for each sphere, and that spheres are in few of them, by
// the sizes of about a thousand spheres from the light. The limits were measured with the scenes of
// the benchmarks: with smaller cells, building costs more than the rays save.
static int choose_columns(const LightGrid *grid)
{
    enum { FEWEST = 16, MOST = 1024, SAMPLES = 1024 };
    const Scene *scene = grid->crowd->scene;
    const int step = scene->sphere_count / SAMPLES + 1;
    vec3 light = light_of(&grid->cells);
    int columns = MOST;
    for (; columns > FEWEST; columns /= 2) {
        double across = columns / (2 * grid->cells.slope), entries = 0;
        double cells = (double)columns * columns * grid->cells.pictures;
        for (int i = step / 2; i < scene->sphere_count; i += step) {
            double distance =
                grid->cells.parallel ? 1 : vec3_length(scene->spheres[i].center - light);
            double wide = 2 * across * scene->spheres[i].radius / distance + 1;
            entries += step * fmin(wide * wide, cells);
        }
        if (cells <= 32.0 * scene->sphere_count + (1 << 15) &&
            entries <= 8.0 * scene->sphere_count + (1 << 16))
            break;
    }
    return columns;
}

// A place covers some columns of some rows. Only its four corners are noted; adding up along rows
// and columns gives the counts (Crow, 'Summed-Area Tables for Texture Mapping', 1984, in reverse).
// That is four steps for each place, however many cells it covers. Numbers below 0 wrap around, but
// the sums are right.
static void count_cells(const Building *building, Place place)
{
    uint32_t *corners = building->corners;
    int wide = building->columns + 1;
    corners[place.top * wide + place.left]++;
    corners[place.top * wide + place.right]--;
    corners[place.bottom * wide + place.left]--;
    corners[place.bottom * wide + place.right]++;
}

// A pixel is covered if its centre is; here one more on each side counts, for the rays between the
// centres.
static Place in_cells(Place place, int size, int picture, int columns)
{
    int left = place.left - (place.left > 0), right = place.right + (place.right < size);
    int top = place.top - (place.top > 0), bottom = place.bottom + (place.bottom < size);
    int above = picture * columns;
    place.left = (uint16_t)(left / TILE_WIDTH);
    place.right = (uint16_t)((right - 1) / TILE_WIDTH + 1);
    place.top = (uint16_t)(above + top / TILE_HEIGHT);
    place.bottom = (uint16_t)(above + (bottom - 1) / TILE_HEIGHT + 1);
    return place;
}

static int pixel(double x, double size)
{
    return (int)(x > 0 ? x < size ? x : size : 0);
}

// The places of spheres on a picture by parallel rays. Depths are rounded down, as they are sorted.
static void place_parallel(const Eye *eye, const Positions *positions, int count, Place *places)
{
    for (int i = 0; i < count; i++) {
        vec3 center = vec3_of(positions->x[i], positions->y[i], positions->z[i]);
        double r = positions->radius[i], size = eye->width;
        double x = along(center, eye->right), y = -along(center, eye->up);
        double near = along(center, eye->forward) - r - 1e-6 * size / eye->across;
        places[i] = (Place){.left = (uint16_t)pixel(size / 2 + eye->across * (x - r), size),
                            .right = (uint16_t)pixel(size / 2 + eye->across * (x + r) + 1, size),
                            .top = (uint16_t)pixel(size / 2 + eye->across * (y - r), size),
                            .bottom = (uint16_t)pixel(size / 2 + eye->across * (y + r) + 1, size),
                            .near = near > 0 ? (float)near : 0};
        uint32_t bits = place_depth(places[i]) << PLACE_DROPPED;
        memcpy(&places[i].near, &bits, sizeof bits);
    }
}

// The places of all spheres that a picture may show.
static void add_places(Building *building, int picture)
{
    const Crowd *crowd = building->grid->crowd;
    const LightCells *cells = &building->grid->cells;
    const Eye eye = eye_of(cells, picture);
    vec3 light = light_of(cells);
    const Sphere *spheres = crowd->scene->spheres;
    const int count = crowd->scene->sphere_count;
    int waiting = 0, numbers[PLACES];
    Positions positions = {0};
    Places seen;
    for (int i = 0; i < count; i++) {
        vec3 center = spheres[i].center - light;
        double radius = spheres[i].radius;
        positions.x[waiting] = center[0];
        positions.y[waiting] = center[1];
        positions.z[waiting] = center[2];
        positions.radius[waiting] = radius;
        numbers[waiting] = i;
        if (i + PLACES / 4 < count) // the processor itself stops at a page's end
            __builtin_prefetch(&spheres[i + PLACES / 4]);
        waiting += !is_giant(crowd, i) &&
                   (cells->pictures == 1 || may_show(&eye, cells->slope, center, radius));
        if (waiting < PLACES && i < count - 1)
            continue;
        Place *places = building->places + building->count;
        if (cells->parallel)
            place_parallel(&eye, &positions, waiting, places);
        else
            bins_lanes[lanes_best()]->place(&eye, &positions, waiting, &seen);
        for (int k = 0; k < waiting; k++) {
            Place place = cells->parallel ? places[k] : place_at(&seen, k, 0);
            places[k] = in_cells(place, (int)eye.width, picture, cells->columns);
            places[k].sphere = numbers[k];
            building->depths[place_depth(places[k])]++;
            count_cells(building, places[k]);
        }
        building->count += waiting;
        waiting = 0;
    }
}

// A counting sort.
static void sort_by_depth(Building *building, Place *sorted)
{
    uint32_t sum = 0;
    for (int depth = 0; depth < DEPTHS; depth++) {
        uint32_t here = building->depths[depth];
        building->depths[depth] = sum;
        sum += here;
    }
    for (int i = 0; i < building->count; i++) {
        Place *to = &sorted[building->depths[place_depth(building->places[i])]++];
        *to = building->places[i];
        __builtin_prefetch(to + 8, 1); // two lines of the cache on, of the same depth
    }
}

static int at_most(uint32_t count, int most)
{
    return count < (uint32_t)most ? (int)count : most;
}

// Where the lists of cells begin, each at start[cell + 1] until it is filled; and the room in them.
static size_t begin_lists(Building *building, uint8_t *room)
{
    const int columns = building->columns;
    uint32_t *start = building->grid->cells.start, sum = 0;
    *start++ = 0;
    for (int row = 0; row < building->rows; row++) {
        uint32_t in_row = 0, *counts = building->corners + row * (columns + 1);
        for (int column = 0; column < columns; column++) {
            in_row += counts[column];
            counts[column] = in_row + (row > 0 ? counts[column - columns - 1] : 0);
            *room = (uint8_t)at_most(counts[column], MOST_LISTED + 1);
            *start++ = sum;
            sum += *room++;
        }
    }
    *start = sum;
    return sum;
}

// Near ones come first, because the places are sorted.
static void fill_lists(const Building *building, const Place *sorted, uint8_t *room)
{
    const LightCells *cells = &building->grid->cells;
    const int columns = building->columns;
    for (const Place *place = sorted; place < sorted + building->count; place++)
        for (int row = place->top; row < place->bottom; row++)
            for (int cell = row * columns + place->left; cell < row * columns + place->right;
                 cell++)
                if (room[cell] > 0) {
                    room[cell]--;
                    cells->shown[cells->start[cell + 1]++] = (Shown){place->near, place->sphere};
                }
    for (int row = 0; row < building->rows; row++)
        for (int column = 0; column < columns; column++)
            if (building->corners[row * (columns + 1) + column] > MOST_LISTED)
                cells->shown[cells->start[row * columns + column + 1] - 1].sphere = NOT_LISTED;
}

static bool build_cells(Building *building)
{
    LightCells *cells = &building->grid->cells;
    const size_t count = (size_t)building->columns * (size_t)building->rows;
    for (int i = 0; i < cells->pictures; i++)
        add_places(building, i);
    Place *sorted = large_memory(((size_t)building->count + 1) * sizeof *sorted);
    uint8_t *room = large_memory(count);
    cells->start = large_memory((count + 2) * sizeof *cells->start);
    if (sorted != NULL && room != NULL && cells->start != NULL) {
        size_t entries = begin_lists(building, room);
        cells->shown = large_memory((entries + 1) * sizeof *cells->shown);
        if (cells->shown != NULL) {
            sort_by_depth(building, sorted);
            fill_lists(building, sorted, room);
            cells->shown[entries] = (Shown){INFINITY, 0};
        }
    }
    free(sorted);
    free(room);
    return cells->shown != NULL;
}

bool light_grid_build(LightGrid *grid, const Crowd *crowd, Light light)
{
    *grid = (LightGrid){.crowd = crowd};
    size_t spheres = (size_t)crowd->scene->sphere_count;
    if (crowd->giant_count == crowd->scene->sphere_count)
        return true;
    look_around(grid, light);
    if (grid->cells.pictures == 0)
        return true;
    grid->cells.columns = choose_columns(grid);
    Building building = {.grid = grid,
                         .columns = grid->cells.columns,
                         .rows = grid->cells.columns * grid->cells.pictures};
    building.places =
        large_memory(((size_t)grid->cells.pictures * spheres + PLACES) * sizeof *building.places);
    building.depths = calloc(DEPTHS, sizeof *building.depths);
    building.corners = calloc((size_t)(building.columns + 1) * (size_t)(building.rows + 1),
                              sizeof *building.corners);
    bool done = building.places != NULL && building.depths != NULL && building.corners != NULL &&
                build_cells(&building);
    free(building.places);
    free(building.depths);
    free(building.corners);
    return done;
}

void light_grid_free(LightGrid *grid)
{
    free(grid->cells.shown);
    free(grid->cells.start);
}

// ---- asking -----------------------------------------------------------------------------------

void light_grid_ask(const LightGrid *grid, const ShadowRays *rays, int *verdicts)
{
    const Crowd *crowd = grid->crowd;
    const ShadowLanes *lanes = shadow_lanes[lanes_best()];
    const bool any = grid->cells.pictures > 0;
    for (int i = 0; i < rays->count; i++)
        verdicts[i] = rays->passes[i] == NO_RAY ? HIDDEN : any ? ARRIVES : DOUBTFUL;
    for (int i = 0; any && i < crowd->giant_count; i++)
        lanes->ask_one(rays, crowd->scene->spheres, crowd->giants[i], verdicts);
    if (any)
        lanes->ask_cells(rays, crowd->scene->spheres, &grid->cells, verdicts);
}
