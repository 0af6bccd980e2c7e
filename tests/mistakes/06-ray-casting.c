// 06-ray-casting.c - wrong answers to exercise 06.
#include "exercises/06-ray-casting.h"

#include "exercises/01-corners.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "tests/mistakes/mistakes.h"

#include <stdlib.h>

// ---- nearest_hit --------------------------------------------------------------------------------

static const Hit nothing = {NO_HIT, -1};

// The right one, among the spheres from..to - 1.
static Hit nearest_among(Ray ray, const Scene *scene, int from, int to)
{
    Hit nearest = nothing;
    for (int i = from; i < to; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
}

static Hit nearest_of_all(Ray ray, const Scene *scene)
{
    return nearest_among(ray, scene, 0, scene->sphere_count);
}

static Hit last_hit(Ray ray, const Scene *scene)
{
    Hit hit = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT)
            hit = (Hit){t, i};
    }
    return hit;
}

static Hit first_hit(Ray ray, const Scene *scene)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT)
            return (Hit){t, i};
    }
    return nothing;
}

static Hit best_starts_at_minus_1(Ray ray, const Scene *scene)
{
    Hit best = {-1, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best.t)
            best = (Hit){t, i};
    }
    return best;
}

static Hit best_starts_at_10(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    return nearest.t < 10 ? nearest : nothing;
}

static Hit higher_index_of_equals(Ray ray, const Scene *scene)
{
    Hit nearest = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT && t <= nearest.t)
            nearest = (Hit){t, i};
    }
    return nearest;
}

static Hit without_the_first(Ray ray, const Scene *scene)
{
    return nearest_among(ray, scene, 1, scene->sphere_count);
}

static Hit without_the_last(Ray ray, const Scene *scene)
{
    return nearest_among(ray, scene, 0, scene->sphere_count - 1);
}

static Hit farthest(Ray ray, const Scene *scene)
{
    Hit hit = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT && (hit.sphere < 0 || t > hit.t))
            hit = (Hit){t, i};
    }
    return hit;
}

static Hit nearest_centre(Ray ray, const Scene *scene)
{
    Hit hit = nothing;
    double best = INFINITY;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        double away = vec3_length(scene->spheres[i].center - ray.origin);
        if (t < NO_HIT && away < best) {
            best = away;
            hit = (Hit){t, i};
        }
    }
    return hit;
}

static Hit index_0_for_nothing(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    return nearest.sphere < 0 ? (Hit){NO_HIT, 0} : nearest;
}

static Hit minus_1_for_no_hit(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    return nearest.sphere < 0 ? (Hit){-1, -1} : nearest;
}

static Hit way_for_t(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    nearest.t *= vec3_length(ray.direction);
    return nearest;
}

static Hit surface_for_sphere(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    if (nearest.sphere >= 0)
        nearest.sphere = scene->spheres[nearest.sphere].surface;
    return nearest;
}

static Hit counted_from_1(Ray ray, const Scene *scene)
{
    Hit nearest = nearest_of_all(ray, scene);
    nearest.sphere += nearest.sphere >= 0;
    return nearest;
}

static Hit nearest_root(Ray ray, const Scene *scene, double least)
{
    Hit nearest = nothing;
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        if (roots.count > 0 && roots.t[0] > least && roots.t[0] < nearest.t)
            nearest = (Hit){roots.t[0], i};
    }
    return nearest;
}

static Hit behind_the_eye_too(Ray ray, const Scene *scene)
{
    return nearest_root(ray, scene, -INFINITY);
}

static Hit nothing_from_inside(Ray ray, const Scene *scene)
{
    return nearest_root(ray, scene, 0);
}

static Hit from_the_image_plane(Ray ray, const Scene *scene)
{
    return nearest_root(ray, scene, 1);
}

// ---- cast_image_order ---------------------------------------------------------------------------

// The places of the loops, which a mistake may change: which part of the image is filled, and which
// pixel's ray is taken for a pixel.
typedef struct {
    int first_column, first_row, last_column, last_row; // counted from the edges, 0 for all
    Pixel (*ray_of)(Pixel pixel, Resolution size);
    Hit (*hit)(Ray ray, const Scene *scene);
    Color (*color)(const Scene *scene, int sphere); // of a sphere, or of -1
} Loops;

static Pixel same(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel;
}

static Color flat(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene_surface(scene, sphere)->color;
}

static void cast_with(Loops loops, const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    for (int row = loops.first_row; row < size.height - loops.last_row; row++)
        for (int column = loops.first_column; column < size.width - loops.last_column; column++) {
            Pixel pixel = {column, row};
            Ray ray =
                pixel_ray(camera, size, (loops.ray_of != NULL ? loops.ray_of : same)(pixel, size));
            Hit hit = (loops.hit != NULL ? loops.hit : nearest_of_all)(ray, scene);
            image_set(image, pixel, (loops.color != NULL ? loops.color : flat)(scene, hit.sphere));
        }
}

#define IMAGE_ORDER(name, ...)                                                                     \
    static void name(const Scene *scene, Camera camera, Image *image)                              \
    {                                                                                              \
        cast_with((Loops){__VA_ARGS__}, scene, camera, image);                                     \
    }

IMAGE_ORDER(first_column_left_out, .first_column = 1)
IMAGE_ORDER(first_row_left_out, .first_row = 1)
IMAGE_ORDER(last_column_left_out, .last_column = 1)
IMAGE_ORDER(last_row_left_out, .last_row = 1)

static Pixel upside_down(Pixel pixel, Resolution size)
{
    return (Pixel){pixel.column, size.height - 1 - pixel.row};
}

static Pixel mirrored(Pixel pixel, Resolution size)
{
    return (Pixel){size.width - 1 - pixel.column, pixel.row};
}

static Pixel swapped(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.row, pixel.column};
}

static Pixel next_one(Pixel pixel, Resolution size)
{
    (void)size;
    return (Pixel){pixel.column + 1, pixel.row + 1};
}

static Pixel always_the_first(Pixel pixel, Resolution size)
{
    (void)size;
    (void)pixel;
    return (Pixel){0, 0};
}

IMAGE_ORDER(picture_upside_down, .ray_of = upside_down)
IMAGE_ORDER(picture_mirrored, .ray_of = mirrored)
IMAGE_ORDER(row_and_column_swapped, .ray_of = swapped)
IMAGE_ORDER(counted_from_pixel_1, .ray_of = next_one)
IMAGE_ORDER(one_ray_for_all, .ray_of = always_the_first)

IMAGE_ORDER(last_sphere_wins, .hit = last_hit)
IMAGE_ORDER(first_sphere_wins, .hit = first_hit)
IMAGE_ORDER(later_of_equals_wins, .hit = higher_index_of_equals)
IMAGE_ORDER(ghosts_from_behind, .hit = behind_the_eye_too)
IMAGE_ORDER(inside_is_nothing, .hit = nothing_from_inside)
IMAGE_ORDER(near_things_vanish, .hit = from_the_image_plane)
IMAGE_ORDER(farthest_wins, .hit = farthest)

static Color black_background(const Scene *scene, int sphere)
{
    return sphere < 0 ? vec3_of(0, 0, 0) : flat(scene, sphere);
}

static Color sphere_0_is_nothing(const Scene *scene, int sphere)
{
    return sphere > 0 ? flat(scene, sphere) : scene->background;
}

static Color surface_of_that_number(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[sphere % scene->surface_count].color;
}

static Color first_surface(const Scene *scene, int sphere)
{
    return sphere < 0 ? scene->background : scene->surfaces[0].color;
}

static Color blue_before_red(const Scene *scene, int sphere)
{
    Color color = flat(scene, sphere);
    return vec3_of(color[2], color[1], color[0]);
}

static Color times_255(const Scene *scene, int sphere)
{
    return 255 * flat(scene, sphere);
}

IMAGE_ORDER(background_is_black, .color = black_background)
IMAGE_ORDER(first_sphere_not_seen, .color = sphere_0_is_nothing)
IMAGE_ORDER(sphere_for_surface, .color = surface_of_that_number)
IMAGE_ORDER(always_surface_0, .color = first_surface)
IMAGE_ORDER(blue_green_red, .color = blue_before_red)
IMAGE_ORDER(colours_times_255, .color = times_255)

static void background_left_out(const Scene *scene, Camera camera, Image *image)
{
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        Hit hit = nearest_of_all(pixel_ray(camera, image->size, pixel), scene);
        if (hit.sphere >= 0)
            image_set(image, pixel, flat(scene, hit.sphere));
    }
}

static void square_part_only(const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    Loops loops = {.last_column = size.width > size.height ? size.width - size.height : 0,
                   .last_row = size.height > size.width ? size.height - size.width : 0};
    cast_with(loops, scene, camera, image);
}

static void width_and_height_swapped(const Scene *scene, Camera camera, Image *image)
{
    Resolution turned = {image->size.height, image->size.width};
    for (int i = 0; i < image->size.width * image->size.height; i++) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        Hit hit = nearest_of_all(pixel_ray(camera, turned, pixel), scene);
        image_set(image, pixel, flat(scene, hit.sphere));
    }
}

// An own ray, through the pixel's upper left corner.
static void corner_of_the_pixel(const Scene *scene, Camera camera, Image *image)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++) {
        Pixel pixel = {i % size.width, i / size.width};
        double s = (double)pixel.column / size.width, t = 1 - (double)pixel.row / size.height;
        Ray ray = {camera.origin, image_plane_vector(camera, s, t)};
        image_set(image, pixel, flat(scene, nearest_of_all(ray, scene).sphere));
    }
}

static void from_the_origin_of_the_world(const Scene *scene, Camera camera, Image *image)
{
    camera.origin = vec3_of(0, 0, 0);
    cast_with((Loops){.hit = NULL}, scene, camera, image);
}

// ---- cast_object_order --------------------------------------------------------------------------

// Again the parts that a mistake may change.
typedef struct {
    bool depth_kept;                         // not set before the loops
    double depth_first;                      // what it is set to, where it is not 0
    bool background_kept;                    // not set before the loops
    bool depth_set_for_each;                 // anew for each sphere
    bool depth_not_stored;                   // never written in the loops
    int first_sphere, last_sphere, last_row; // how many are left out
    Pixel (*ray_of)(Pixel pixel, Resolution size);
    int (*place)(Pixel pixel, Resolution size); // in depth
    bool (*nearer)(double t, double depth);
    Color (*color)(const Scene *scene, int sphere);
    bool background_where_missed; // each sphere colours what it misses too
} Objects;

static int row_by_row(Pixel pixel, Resolution size)
{
    return pixel.row * size.width + pixel.column;
}

static bool less(double t, double depth)
{
    return t < depth;
}

static Pixel pixel_number(int i, Resolution size)
{
    return (Pixel){i % size.width, i / size.width};
}

static void set_depth(const Objects *o, int count, double *depth)
{
    for (int i = 0; i < count; i++)
        depth[i] = o->depth_first == 0 ? NO_HIT : o->depth_first;
}

static void draw_one(const Objects *o, const Scene *scene, int sphere, Camera camera, Image *image,
                     double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * (size.height - o->last_row); i++) {
        Pixel pixel = pixel_number(i, size);
        Ray ray = pixel_ray(camera, size, (o->ray_of != NULL ? o->ray_of : same)(pixel, size));
        double t = hit_sphere(ray, scene->spheres[sphere]);
        double *at = &depth[(o->place != NULL ? o->place : row_by_row)(pixel, size)];
        if ((o->nearer != NULL ? o->nearer : less)(t, *at)) {
            image_set(image, pixel, (o->color != NULL ? o->color : flat)(scene, sphere));
            if (!o->depth_not_stored)
                *at = t;
        } else if (o->background_where_missed && !(t < NO_HIT)) {
            image_set(image, pixel, scene->background);
        }
    }
}

static void draw_with(Objects o, const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    int count = size.width * size.height;
    if (!o.depth_kept)
        set_depth(&o, count, depth);
    for (int i = 0; i < count && !o.background_kept; i++)
        image_set(image, pixel_number(i, size), scene->background);
    for (int i = o.first_sphere; i < scene->sphere_count - o.last_sphere; i++) {
        if (o.depth_set_for_each)
            set_depth(&o, count, depth);
        draw_one(&o, scene, i, camera, image, depth);
    }
}

#define OBJECT_ORDER(name, ...)                                                                    \
    static void name(const Scene *scene, Camera camera, Image *image, double *depth)               \
    {                                                                                              \
        draw_with((Objects){__VA_ARGS__}, scene, camera, image, depth);                            \
    }

OBJECT_ORDER(depth_not_reset, .depth_kept = true)
OBJECT_ORDER(depth_starts_at_minus_1, .depth_first = -1)
OBJECT_ORDER(depth_starts_at_1000, .depth_first = 1000)
OBJECT_ORDER(depth_reset_for_each_sphere, .depth_set_for_each = true)
OBJECT_ORDER(depth_not_stored, .depth_not_stored = true)
OBJECT_ORDER(objects_without_background, .background_kept = true)
OBJECT_ORDER(objects_wipe_each_other, .background_where_missed = true)
OBJECT_ORDER(first_object_left_out, .first_sphere = 1)
OBJECT_ORDER(last_object_left_out, .last_sphere = 1)
OBJECT_ORDER(objects_without_last_row, .last_row = 1)
OBJECT_ORDER(objects_upside_down, .ray_of = upside_down)
OBJECT_ORDER(objects_mirrored, .ray_of = mirrored)
OBJECT_ORDER(objects_swapped, .ray_of = swapped)
OBJECT_ORDER(objects_sphere_for_surface, .color = surface_of_that_number)
OBJECT_ORDER(objects_always_surface_0, .color = first_surface)
OBJECT_ORDER(objects_blue_green_red, .color = blue_before_red)

static bool more(double t, double depth)
{
    return t < NO_HIT && (depth == NO_HIT || t > depth);
}

static bool not_more(double t, double depth)
{
    return t < NO_HIT && t <= depth;
}

static bool still_empty(double t, double depth)
{
    return t < NO_HIT && depth == NO_HIT;
}

static bool behind_the_plane(double t, double depth)
{
    return t > 1 && t < depth;
}

OBJECT_ORDER(farthest_object, .nearer = more)
OBJECT_ORDER(later_of_equal_objects, .nearer = not_more)
OBJECT_ORDER(first_object_wins, .nearer = still_empty)
OBJECT_ORDER(near_objects_vanish, .nearer = behind_the_plane)

static int column_by_column(Pixel pixel, Resolution size)
{
    return pixel.column * size.height + pixel.row;
}

static int from_the_bottom(Pixel pixel, Resolution size)
{
    return (size.height - 1 - pixel.row) * size.width + pixel.column;
}

static int one_row_for_all(Pixel pixel, Resolution size)
{
    (void)size;
    return pixel.column;
}

OBJECT_ORDER(depth_column_by_column, .place = column_by_column)
OBJECT_ORDER(depth_from_the_bottom, .place = from_the_bottom)
OBJECT_ORDER(depth_of_one_row, .place = one_row_for_all)

// Right, then something is done to the depth.
static void depth_is_a_distance(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    draw_with((Objects){.ray_of = NULL}, scene, camera, image, depth);
    for (int i = 0; i < size.width * size.height; i++)
        depth[i] *= vec3_length(pixel_ray(camera, size, pixel_number(i, size)).direction);
}

static void depth_0_for_nothing(const Scene *scene, Camera camera, Image *image, double *depth)
{
    draw_with((Objects){.ray_of = NULL}, scene, camera, image, depth);
    for (int i = 0; i < image->size.width * image->size.height; i++)
        depth[i] = depth[i] < NO_HIT ? depth[i] : 0;
}

static void depth_in_memory_of_its_own(const Scene *scene, Camera camera, Image *image,
                                       double *depth)
{
    double *own = malloc((size_t)(image->size.width * image->size.height) * sizeof *own);
    draw_with((Objects){.ray_of = NULL}, scene, camera, image, own);
    free(own);
    (void)depth;
}

static void objects_on_black(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Scene black = *scene;
    black.background = vec3_of(0, 0, 0);
    draw_with((Objects){.ray_of = NULL}, &black, camera, image, depth);
}

static void one_object_only(const Scene *scene, Camera camera, Image *image, double *depth)
{
    draw_with((Objects){.last_sphere = scene->sphere_count > 1 ? scene->sphere_count - 1 : 0},
              scene, camera, image, depth);
}

static void objects_from_the_origin(const Scene *scene, Camera camera, Image *image, double *depth)
{
    camera.origin = vec3_of(0, 0, 0);
    draw_with((Objects){.ray_of = NULL}, scene, camera, image, depth);
}

// The far side of each sphere, so that a sphere is before another where it ends before it.
static void objects_by_their_far_side(const Scene *scene, Camera camera, Image *image,
                                      double *depth)
{
    Resolution size = image->size;
    draw_with((Objects){.last_sphere = scene->sphere_count}, scene, camera, image, depth);
    for (int sphere = 0; sphere < scene->sphere_count; sphere++)
        for (int i = 0; i < size.width * size.height; i++) {
            Pixel pixel = pixel_number(i, size);
            Roots roots = sphere_roots(pixel_ray(camera, size, pixel), scene->spheres[sphere]);
            if (roots.count > 0 && roots.t[1] > 0 && roots.t[1] < depth[i]) {
                depth[i] = roots.t[1];
                image_set(image, pixel, flat(scene, sphere));
            }
        }
}

// The near side, even where it is behind the eye.
static void objects_behind_the_eye(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    draw_with((Objects){.last_sphere = scene->sphere_count}, scene, camera, image, depth);
    for (int sphere = 0; sphere < scene->sphere_count; sphere++)
        for (int i = 0; i < size.width * size.height; i++) {
            Pixel pixel = pixel_number(i, size);
            Roots roots = sphere_roots(pixel_ray(camera, size, pixel), scene->spheres[sphere]);
            if (roots.count > 0 && roots.t[0] < depth[i]) {
                depth[i] = roots.t[0];
                image_set(image, pixel, flat(scene, sphere));
            }
        }
}

const Mistake mistakes[] = {
    MISTAKE("H1", nearest_hit, last_hit, "the last hit wins"),
    MISTAKE("H1-first", nearest_hit, first_hit, "the first hit wins"),
    MISTAKE("H3", nearest_hit, best_starts_at_minus_1, "the best t starts at -1"),
    MISTAKE("H3-10", nearest_hit, best_starts_at_10, "the best t starts at 10"),
    MISTAKE("H-tie", nearest_hit, higher_index_of_equals, "<= for <"),
    MISTAKE("H-from1", nearest_hit, without_the_first, "the first sphere left out"),
    MISTAKE("H-last", nearest_hit, without_the_last, "the last sphere left out"),
    MISTAKE("H-far", nearest_hit, farthest, "the farthest"),
    MISTAKE("H-centre", nearest_hit, nearest_centre, "the nearest centre"),
    MISTAKE("H-none0", nearest_hit, index_0_for_nothing, "index 0 for none"),
    MISTAKE("H-none-1", nearest_hit, minus_1_for_no_hit, "t = -1 for none"),
    MISTAKE("H-way", nearest_hit, way_for_t, "the distance for t"),
    MISTAKE("H-surface", nearest_hit, surface_for_sphere, "the surface's index"),
    MISTAKE("H-count1", nearest_hit, counted_from_1, "spheres counted from 1"),
    MISTAKE("R7-scene", nearest_hit, behind_the_eye_too, "what is behind the eye too"),
    MISTAKE("R8-scene", nearest_hit, nothing_from_inside, "nothing from inside"),
    MISTAKE("D1-scene", nearest_hit, from_the_image_plane, "nothing before the plane"),

    MISTAKE("I-flip", cast_image_order, picture_upside_down, "upside down"),
    MISTAKE("I-mirror", cast_image_order, picture_mirrored, "mirrored"),
    MISTAKE("P4", cast_image_order, row_and_column_swapped, "row and column swapped"),
    MISTAKE("I-from1", cast_image_order, counted_from_pixel_1, "pixels counted from 1"),
    MISTAKE("I-one", cast_image_order, one_ray_for_all, "one ray for all pixels"),
    MISTAKE("I-column0", cast_image_order, first_column_left_out, "the first column left out"),
    MISTAKE("I-row0", cast_image_order, first_row_left_out, "the first row left out"),
    MISTAKE("I-column", cast_image_order, last_column_left_out, "the last column left out"),
    MISTAKE("I-row", cast_image_order, last_row_left_out, "the last row left out"),
    MISTAKE("I-square", cast_image_order, square_part_only, "a square of the image only"),
    MISTAKE("I-size", cast_image_order, width_and_height_swapped, "width and height swapped"),
    MISTAKE("P1", cast_image_order, corner_of_the_pixel, "the pixel's corner"),
    MISTAKE("P7", cast_image_order, from_the_origin_of_the_world, "rays from the world's origin"),
    MISTAKE("I-last", cast_image_order, last_sphere_wins, "the last hit wins"),
    MISTAKE("I-first", cast_image_order, first_sphere_wins, "the first hit wins"),
    MISTAKE("I-tie", cast_image_order, later_of_equals_wins, "the later of equals"),
    MISTAKE("I-far", cast_image_order, farthest_wins, "the farthest"),
    MISTAKE("R7-image", cast_image_order, ghosts_from_behind, "what is behind the eye too"),
    MISTAKE("R8-image", cast_image_order, inside_is_nothing, "nothing from inside"),
    MISTAKE("D1-image", cast_image_order, near_things_vanish, "nothing before the plane"),
    MISTAKE("I-black", cast_image_order, background_is_black, "a black background"),
    MISTAKE("I-rest", cast_image_order, background_left_out, "the background not set"),
    MISTAKE("I-0", cast_image_order, first_sphere_not_seen, "sphere 0 taken for none"),
    MISTAKE("I-index", cast_image_order, sphere_for_surface, "the sphere's index as surface"),
    MISTAKE("I-white", cast_image_order, always_surface_0, "always surface 0"),
    MISTAKE("I-bgr", cast_image_order, blue_green_red, "blue, green, red"),
    MISTAKE("I-255", cast_image_order, colours_times_255, "colours times 255"),

    MISTAKE("Z-kept", cast_object_order, depth_not_reset, "depth not reset"),
    MISTAKE("Z-minus", cast_object_order, depth_starts_at_minus_1, "depth starts at -1"),
    MISTAKE("Z-1000", cast_object_order, depth_starts_at_1000, "depth starts at 1000"),
    MISTAKE("Z-each", cast_object_order, depth_reset_for_each_sphere, "depth reset each time"),
    MISTAKE("Z-never", cast_object_order, depth_not_stored, "depth never stored"),
    MISTAKE("Z-own", cast_object_order, depth_in_memory_of_its_own, "depth not handed back"),
    MISTAKE("Z-more", cast_object_order, farthest_object, "compared with >"),
    MISTAKE("Z-tie", cast_object_order, later_of_equal_objects, "compared with <="),
    MISTAKE("Z-first", cast_object_order, first_object_wins, "the first object wins"),
    MISTAKE("D1-object", cast_object_order, near_objects_vanish, "nothing before the plane"),
    MISTAKE("Z-turned", cast_object_order, depth_column_by_column, "depth column by column"),
    MISTAKE("Z-bottom", cast_object_order, depth_from_the_bottom, "depth from the bottom"),
    MISTAKE("Z-row", cast_object_order, depth_of_one_row, "depth of one row for all"),
    MISTAKE("Z-way", cast_object_order, depth_is_a_distance, "the distance for t"),
    MISTAKE("Z-none0", cast_object_order, depth_0_for_nothing, "0 for NO_HIT"),
    MISTAKE("R6-object", cast_object_order, objects_by_their_far_side, "the far side"),
    MISTAKE("R7-object", cast_object_order, objects_behind_the_eye, "what is behind the eye too"),
    MISTAKE("O-rest", cast_object_order, objects_without_background, "the background not set"),
    MISTAKE("O-wipe", cast_object_order, objects_wipe_each_other, "the background where missed"),
    MISTAKE("O-black", cast_object_order, objects_on_black, "a black background"),
    MISTAKE("O-from1", cast_object_order, first_object_left_out, "the first object left out"),
    MISTAKE("O-last", cast_object_order, last_object_left_out, "the last object left out"),
    MISTAKE("O-one", cast_object_order, one_object_only, "the first object only"),
    MISTAKE("O-row", cast_object_order, objects_without_last_row, "the last row left out"),
    MISTAKE("O-flip", cast_object_order, objects_upside_down, "upside down"),
    MISTAKE("O-mirror", cast_object_order, objects_mirrored, "mirrored"),
    MISTAKE("P4-object", cast_object_order, objects_swapped, "row and column swapped"),
    MISTAKE("P7-object", cast_object_order, objects_from_the_origin,
            "rays from the world's origin"),
    MISTAKE("O-index", cast_object_order, objects_sphere_for_surface, "the sphere's index"),
    MISTAKE("O-white", cast_object_order, objects_always_surface_0, "always surface 0"),
    MISTAKE("O-bgr", cast_object_order, objects_blue_green_red, "blue, green, red"),
    {0},
};
