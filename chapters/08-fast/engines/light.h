// light.h - shadows and mirrors: what the files of the shaded picture share.
#ifndef CHAPTERS_08_FAST_ENGINES_LIGHT_H
#define CHAPTERS_08_FAST_ENGINES_LIGHT_H

#include "chapters/08-fast/engines/bins.h"
#include "chapters/08-fast/engines/hierarchy.h"

#include <stdalign.h>

// ---- the steps of paths -----------------------------------------------------------------------

// Every path takes the same steps: its ray, the place where that hits a sphere, the normal there,
// the light, the mirror. Each step is done for all paths before the next one.
//
// There are two tables of steps. steps_by_chapters calls the functions of chapters 04, 05 and 07
// for one path after the other. light_steps_KIND has the formulas of the solutions, in lanes. A
// student's functions may be different, so before a picture both tables compute rays of its scene.
// If one bit differs, the chapters' functions draw it.

// Paths that are traced together.
enum { PATHS = 256 };

typedef struct {
    alignas(64) double x[PATHS], y[PATHS], z[PATHS];
} Vectors;

// Where paths are: their rays, what these hit, and where the next rays start and go.
typedef struct {
    Vectors origin, direction, center, point, normal, start, mirrored;
    alignas(64) double t[PATHS], radius[PATHS];
    int number[PATHS]; // of the path: those that end are removed from these arrays
    int sphere[PATHS], surface[PATHS];
    int count;
} Paths;

typedef struct LightWorld LightWorld;

typedef struct {
    // The rays of samples of the picture.
    void (*rays)(const LightWorld *world, const int *columns, const int *rows, Paths *paths);
    // Where the rays hit their spheres: t. False: only the chapter can compute these numbers.
    bool (*hits)(Paths *paths);
    // From there: point, normal, start, mirrored.
    void (*leave)(Paths *paths);
    // The directions of the rays to a light, from start.
    void (*to_light)(const Paths *paths, const Light *light, Vectors *directions);
    // The colors there. Light number i arrives if lit[i * PATHS + path] is not 0.
    void (*shade)(const Scene *scene, const Paths *paths, const double *lit, Vectors *colors);
    // Adds the colors, clamped, to the sums at their places.
    void (*add_clamped)(const Vectors *colors, const int *places, int count, Vectors *sums);
} LightSteps;

extern const LightSteps steps_by_chapters;
extern const LightSteps light_steps_baseline, light_steps_avx2, light_steps_avx512;

static inline vec3 vector_of(const Vectors *vectors, int i)
{
    return vec3_of(vectors->x[i], vectors->y[i], vectors->z[i]);
}

static inline void set_vector(Vectors *vectors, int i, vec3 v)
{
    vectors->x[i] = v[0];
    vectors->y[i] = v[1];
    vectors->z[i] = v[2];
}

static inline Vector get(const Vectors *from, int i)
{
    return (Vector){from->x[i], from->y[i], from->z[i]};
}

static inline void put(Vectors *to, int i, Vector v)
{
    to->x[i] = v.x;
    to->y[i] = v.y;
    to->z[i] = v.z;
}

// ---- rays from anywhere -----------------------------------------------------------------------

// The scene as a light sees it, without the giants (light_grid.c): an item of a cell has its
// sphere's place in the hierarchy. There are no cells if the light is distant, surrounded by
// spheres, or extremely far away. False if there is not enough memory.
bool light_grid_build(Bins *bins, const Scene *scene, const WideHierarchy *wide, Light light);

// Rays that start anywhere (any_ray_lanes.c).
typedef struct {
    const Vectors *origin, *direction;
    const Bins *grid; // of the light where they end; NULL: they go on forever
    bool any;         // any hit suffices, it need not be the nearest
    int count;
    // The sphere that each ray leaves: its place, or NO_PLACE; and its numbers.
    int left[PATHS];
    const Vectors *center;
    const double *radius;
} Rays;

// For each ray, the place in the hierarchy of the only sphere that may be the answer; or NO_PLACE
// if the ray certainly misses all; or IN_DOUBT: then ask hierarchy_nearest. Many rays in turns are
// faster than one after the other: while one waits for memory, others compute.
enum { NO_PLACE = -1, IN_DOUBT = -2 };
typedef void NearestOfMany(const WideHierarchy *wide, const Rays *rays, int *places);
extern NearestOfMany nearest_of_many_baseline, nearest_of_many_avx2, nearest_of_many_avx512;

// ---- paths ------------------------------------------------------------------------------------

// Chapter 07's color of a ray, without asking every sphere.
//
// A ray needs few spheres: the one that it hits, and for each light one that hides it, if any. The
// wide hierarchy finds them. A hidden light adds 0, so the numbers are the same, to the last digit.

// A scene that rays from anywhere can ask, and its picture.
struct LightWorld {
    const Scene *scene;
    Camera camera;
    Resolution samples;
    int depth;
    Hierarchy hierarchy;
    WideHierarchy wide;
    Bins *grids; // of each light
};

// Builds the hierarchies and the grids. False if there is not enough memory.
bool light_world_build(LightWorld *world);
void light_world_free(LightWorld *world);

// The paths of one thread.
typedef struct {
    const LightWorld *world;
    const LightSteps *steps;
    NearestOfMany *nearest_of_many; // for this processor
    Paths paths;
    Vectors directions;
    double *lit; // for each light and path: not 0 if the light arrives
    // For each mirror and path: the color there, and the part of it that the next one adds. In the
    // end colors[0] are those of the paths.
    Vectors *colors;
    double *parts;
} LightPaths;

// NULL if there is not enough memory. Free it with free. steps: steps_by_chapters or those of
// lanes.
LightPaths *light_paths_create(const LightWorld *world, const LightSteps *steps);

// The steps of the best lanes, if they give these samples of the picture the colors that the
// chapters' functions give, to the last bit; otherwise, or if there is not enough memory,
// steps_by_chapters. The answers that are linked may be a student's, with other formulas.
const LightSteps *steps_for(const LightWorld *world, const int *columns, const int *rows,
                            int count);

// Finds the colors that trace_ray finds in the scene for all->paths.count rays; set their origin
// and direction, or let steps->rays set them. known: paths.sphere has the sphere that each ray
// hits. Otherwise they are searched.
void path_colors(LightPaths *all, bool known);

// ---- a picture, part by part ------------------------------------------------------------------

typedef struct LightPicture LightPicture;

// The world of a scene. NULL if there is not enough memory.
LightPicture *light_picture_build(const Scene *scene);
void light_picture_free(LightPicture *picture);

// From now on the picture is work's, which stays where it is. May be called again, with another
// camera, image or style. whole: all of it will be painted, so it is worth finding first what each
// sample sees, by bins.
void light_picture_look(LightPicture *picture, const Work *work, Style style, bool whole);

// Paints the columns left to right - 1 and the rows top to bottom - 1 of the image. False if there
// is not enough memory.
bool light_picture_paint(LightPicture *picture, int left, int top, int right, int bottom);

#endif
