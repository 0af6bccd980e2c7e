// 06-ray-casting.c - right answers to exercise 06, written otherwise.
#include "exercises/06-ray-casting.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "tests/variants/variants.h"

#include <stdlib.h>

// ---- nearest_hit --------------------------------------------------------------------------------

static Hit with_a_flag(Ray ray, const Scene *scene)
{
    bool found = false;
    double best = -1;
    int which = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (isfinite(t) && (!found || t < best)) {
            found = true;
            best = t;
            which = i;
        }
    }
    if (!found)
        return (Hit){NO_HIT, -1};
    return (Hit){best, which};
}

static Hit backward(Ray ray, const Scene *scene)
{
    Hit hit = {NO_HIT, -1};
    for (int i = scene->sphere_count; i-- > 0;) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT && t <= hit.t)
            hit = (Hit){t, i};
    }
    return hit;
}

static Hit first_t_then_sphere(Ray ray, const Scene *scene)
{
    double best = NO_HIT;
    for (int i = 0; i < scene->sphere_count; i++)
        best = fmin(best, hit_sphere(ray, scene->spheres[i]));
    for (int i = 0; i < scene->sphere_count && best < NO_HIT; i++)
        if (hit_sphere(ray, scene->spheres[i]) == best)
            return (Hit){best, i};
    return (Hit){NO_HIT, -1};
}

static Hit with_pointers(Ray ray, const Scene *scene)
{
    const Sphere *nearest = NULL, *end = scene->spheres + scene->sphere_count;
    for (const Sphere *s = scene->spheres; s != end; s++)
        if (hit_sphere(ray, *s) < (nearest != NULL ? hit_sphere(ray, *nearest) : NO_HIT))
            nearest = s;
    return nearest == NULL ? (Hit){NO_HIT, -1}
                           : (Hit){hit_sphere(ray, *nearest), (int)(nearest - scene->spheres)};
}

// t is a little different from the reference's, by rounding.
static Hit by_the_foot_of_the_perpendicular(Ray ray, const Scene *scene)
{
    double length = vec3_length(ray.direction);
    vec3 unit = vec3_unit(ray.direction);
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        vec3 center = scene->spheres[i].center - ray.origin;
        double foot = vec3_dot(center, unit), radius = scene->spheres[i].radius;
        vec3 aside = center - foot * unit;
        double half_chord_squared = radius * radius - vec3_dot(aside, aside);
        if (half_chord_squared < 0)
            continue;
        double half_chord = sqrt(half_chord_squared);
        double t = (foot - half_chord > 0 ? foot - half_chord : foot + half_chord) / length;
        if (t > 0 && t < hit.t)
            hit = (Hit){t, i};
    }
    return hit;
}

// ---- cast_image_order ---------------------------------------------------------------------------

static Color color_along(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere == -1)
        return scene->background;
    return scene->surfaces[scene->spheres[hit.sphere].surface].color;
}

static void column_by_column(const Scene *scene, Camera camera, Image *image)
{
    for (int x = 0; x < image->size.width; ++x)
        for (int y = 0; y < image->size.height; ++y) {
            Pixel pixel = {.row = y, .column = x};
            image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
        }
}

static void from_the_last_pixel_to_the_first(const Scene *scene, Camera camera, Image *image)
{
    for (int i = image->size.width * image->size.height; i-- > 0;) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
    }
}

static void bytes_into_rows(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++) {
        uint8_t *byte = image->rgb + (size_t)row * 3 * (size_t)image->size.width;
        for (int column = 0; column < image->size.width; column++) {
            Ray ray = pixel_ray(camera, image->size, (Pixel){column, row});
            Color color = color_along(ray, scene);
            for (int k = 0; k < 3; k++)
                *byte++ = byte_from_color(color[k]);
        }
    }
}

static void background_first(const Scene *scene, Camera camera, Image *image)
{
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            image_set(image, (Pixel){column, row}, scene->background);
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, row};
            Hit hit = nearest_hit(pixel_ray(camera, image->size, pixel), scene);
            if (hit.t < NO_HIT)
                image_set(image, pixel, scene_surface(scene, hit.sphere)->color);
        }
}

static void unit_directions(const Scene *scene, Camera camera, Image *image)
{
    for (Pixel p = {0, 0}; p.row < image->size.height; p.row++)
        for (p.column = 0; p.column < image->size.width; p.column++) {
            Ray ray = pixel_ray(camera, image->size, p);
            ray.direction = vec3_unit(ray.direction);
            image_set(image, p, color_along(ray, scene));
        }
}

static void by_object_order(const Scene *scene, Camera camera, Image *image)
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    cast_object_order(scene, camera, image, depth);
    free(depth);
}

// ---- cast_object_order --------------------------------------------------------------------------

static void by_image_order_and_nearest(const Scene *scene, Camera camera, Image *image,
                                       double *depth)
{
    cast_image_order(scene, camera, image);
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            *depth++ = nearest_hit(pixel_ray(camera, image->size, (Pixel){column, row}), scene).t;
}

static void visit(const Scene *scene, int i, Ray ray, Pixel pixel, Image *image, double *depth)
{
    double t = hit_sphere(ray, scene->spheres[i]);
    if (t == NO_HIT || t > *depth)
        return;
    *depth = t;
    image_set(image, pixel, scene_surface(scene, i)->color);
}

static void spheres_backward(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    for (int i = 0; i < size.width * size.height; i++)
        depth[i] = NO_HIT;
    for (int row = 0; row < size.height; row++)
        for (int column = 0; column < size.width; column++)
            image_set(image, (Pixel){column, row}, scene->background);
    for (int i = scene->sphere_count - 1; i >= 0; i--)
        for (int column = 0; column < size.width; column++)
            for (int row = 0; row < size.height; row++) {
                Pixel pixel = {column, row};
                visit(scene, i, pixel_ray(camera, size, pixel), pixel, image,
                      depth + row * size.width + column);
            }
}

static void background_last(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    int pixels = size.width * size.height;
    for (double *d = depth; d < depth + pixels; d++)
        *d = NO_HIT;
    for (int k = 0; k < scene->sphere_count * pixels; k++) {
        int sphere = k / pixels, i = k % pixels;
        Pixel pixel = {i % size.width, i / size.width};
        double t = hit_sphere(pixel_ray(camera, size, pixel), scene->spheres[sphere]);
        if (depth[i] <= t)
            continue;
        depth[i] = t;
        image_set(image, pixel, scene_surface(scene, sphere)->color);
    }
    for (int i = 0; i < pixels; i++)
        if (isinf(depth[i]))
            image_set(image, (Pixel){i % size.width, i / size.width}, scene->background);
}

// Which sphere is remembered too, and all is painted at the end.
static void indices_first(const Scene *scene, Camera camera, Image *image, double *depth)
{
    Resolution size = image->size;
    int pixels = size.width * size.height;
    int *sphere = calloc((size_t)pixels, sizeof *sphere); // counted from 1
    for (int i = 0; i < pixels; i++)
        depth[i] = NO_HIT;
    for (int s = 1; s <= scene->sphere_count; s++)
        for (int i = 0; i < pixels; i++) {
            Ray ray = pixel_ray(camera, size, (Pixel){i % size.width, i / size.width});
            double t = hit_sphere(ray, scene->spheres[s - 1]);
            sphere[i] = t < depth[i] ? s : sphere[i];
            depth[i] = fmin(t, depth[i]);
        }
    for (int i = 0; i < pixels; i++)
        image_set(image, (Pixel){i % size.width, i / size.width},
                  sphere[i] ? scene_surface(scene, sphere[i] - 1)->color : scene->background);
    free(sphere);
}

const Variant variants[] = {
    VARIANT(nearest_hit, with_a_flag, "a flag for 'found one'"),
    VARIANT(nearest_hit, backward, "backward, with <="),
    VARIANT(nearest_hit, first_t_then_sphere, "first the least t, then whose it is"),
    VARIANT(nearest_hit, with_pointers, "pointers, and hits computed twice"),
    VARIANT(nearest_hit, by_the_foot_of_the_perpendicular, "hits by geometry of one's own"),
    VARIANT(cast_image_order, column_by_column, "by columns, with a helper"),
    VARIANT(cast_image_order, from_the_last_pixel_to_the_first, "from the last pixel on"),
    VARIANT(cast_image_order, bytes_into_rows, "bytes written through a pointer"),
    VARIANT(cast_image_order, background_first, "background first, then the hits"),
    VARIANT(cast_image_order, unit_directions, "rays with unit directions"),
    VARIANT(cast_image_order, by_object_order, "by object order"),
    VARIANT(cast_object_order, by_image_order_and_nearest, "by image order and nearest_hit"),
    VARIANT(cast_object_order, spheres_backward, "spheres backward, by columns, with a helper"),
    VARIANT(cast_object_order, background_last, "one loop, the background last"),
    VARIANT(cast_object_order, indices_first, "colours at the end, with fmin"),
    {0},
};
