// right.c - right answers to exercise 06, written in other ways.
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "tests/judge/known.h"

#include <stdlib.h>

// ---- nearest_hit --------------------------------------------------------------------------------

static Hit nearer_of(Hit a, Hit b)
{
    return b.t < a.t ? b : a;
}

static Hit rest_first(Ray ray, const Scene *scene, int count)
{
    if (count == 0)
        return (Hit){NO_HIT, -1};
    Hit hit = {hit_sphere(ray, scene->spheres[count - 1]), count - 1};
    return nearer_of(rest_first(ray, scene, count - 1), hit);
}

static Hit of_half(Ray ray, const Scene *scene, int first, int end)
{
    if (end - first == 1) {
        double t = hit_sphere(ray, scene->spheres[first]);
        return (Hit){t, t < NO_HIT ? first : -1};
    }
    int middle = first + (end - first) / 2;
    return nearer_of(of_half(ray, scene, first, middle), of_half(ray, scene, middle, end));
}

static int by_t_then_index(const void *a, const void *b)
{
    const Hit *one = a, *other = b;
    if (one->t != other->t)
        return one->t < other->t ? -1 : 1;
    return (one->sphere > other->sphere) - (one->sphere < other->sphere);
}

// ---- cast_image_order ---------------------------------------------------------------------------

static Color color_along(Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere == -1)
        return scene->background;
    return scene->surfaces[scene->spheres[hit.sphere].surface].color;
}

static void rest_of_row(const Scene *scene, Camera camera, Image *image, Pixel pixel)
{
    if (pixel.column == image->size.width)
        return;
    image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
    pixel.column++;
    rest_of_row(scene, camera, image, pixel);
}

// ---- cast_object_order --------------------------------------------------------------------------

static void visit(const Scene *scene, int i, Ray ray, Pixel pixel, Image *image, double *depth)
{
    double t = hit_sphere(ray, scene->spheres[i]);
    if (t == NO_HIT || t > *depth)
        return;
    *depth = t;
    image_set(image, pixel, scene_surface(scene, i)->color);
}

typedef struct {
    int left, right, top, bottom; // the first, and the one after the last
} Box;

// The columns or rows that may meet the sphere: where two planes through the eye touch it. All of
// them, if the eye is inside or the sphere reaches beside or behind the eye.
static void span(vec3 center, double radius, vec3 forward, vec3 aside, double reach, int count,
                 int *first, int *end)
{
    double ahead = vec3_dot(center, forward), off = vec3_dot(center, aside);
    *first = 0;
    *end = count;
    double away = hypot(ahead, off);
    if (ahead <= radius || away <= radius)
        return;
    double angle = atan2(off, ahead), half = asin(radius / away);
    if (fabs(angle) + half >= 1.5)
        return;
    double low = tan(angle - half), high = tan(angle + half);
    *first = (int)fmax(0, fmin(count, floor((low / reach + 0.5) * count) - 1));
    *end = (int)fmax(0, fmin(count, ceil((high / reach + 0.5) * count) + 1));
}

RIGHT(nearest_hit, "a flag for 'found one'")
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

RIGHT(nearest_hit, "backward, with <=")
{
    Hit hit = {NO_HIT, -1};
    for (int i = scene->sphere_count; i-- > 0;) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < NO_HIT && t <= hit.t)
            hit = (Hit){t, i};
    }
    return hit;
}

RIGHT(nearest_hit, "first the least t, then its sphere")
{
    double best = NO_HIT;
    for (int i = 0; i < scene->sphere_count; i++)
        best = fmin(best, hit_sphere(ray, scene->spheres[i]));
    for (int i = 0; i < scene->sphere_count && best < NO_HIT; i++)
        if (hit_sphere(ray, scene->spheres[i]) == best)
            return (Hit){best, i};
    return (Hit){NO_HIT, -1};
}

RIGHT(nearest_hit, "pointers, and hits computed twice")
{
    const Sphere *nearest = NULL, *end = scene->spheres + scene->sphere_count;
    for (const Sphere *s = scene->spheres; s != end; s++)
        if (hit_sphere(ray, *s) < (nearest != NULL ? hit_sphere(ray, *nearest) : NO_HIT))
            nearest = s;
    return nearest == NULL ? (Hit){NO_HIT, -1}
                           : (Hit){hit_sphere(ray, *nearest), (int)(nearest - scene->spheres)};
}

// t differs a little from the reference's, by rounding.
RIGHT(nearest_hit, "hits with its own geometry")
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

RIGHT_LINE(nearest_hit, "recursion", return rest_first(ray, scene, scene->sphere_count))
RIGHT_LINE(nearest_hit, "recursion by halves",
           return scene->sphere_count == 0 ? (Hit){NO_HIT, -1}
                                           : of_half(ray, scene, 0, scene->sphere_count))

RIGHT(nearest_hit, "sorted by t, then by index")
{
    Hit *hits = calloc((size_t)scene->sphere_count + 1, sizeof *hits), first = {NO_HIT, -1};
    int count = 0;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t != NO_HIT)
            hits[count++] = (Hit){t, i};
    }
    qsort(hits, (size_t)count, sizeof *hits, by_t_then_index);
    if (count > 0)
        first = hits[0];
    free(hits);
    return first;
}

// The first sphere is the best so far, hit or not.
RIGHT(nearest_hit, "starting with sphere 0")
{
    if (scene->sphere_count == 0)
        return (Hit){.t = NO_HIT, .sphere = -1};
    Hit hit = {hit_sphere(ray, scene->spheres[0]), 0};
    for (int i = 1; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < hit.t) {
            hit.t = t;
            hit.sphere = i;
        }
    }
    if (hit.t == NO_HIT)
        hit.sphere = -1;
    return hit;
}

RIGHT(nearest_hit, "all roots that are more than 0")
{
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        for (int k = 0; k < roots.count; k++)
            if (roots.t[k] > 0 && roots.t[k] < hit.t)
                hit = (Hit){roots.t[k], i};
    }
    return hit;
}

// Distances along a unit direction, in long double, and t only at the end.
RIGHT(nearest_hit, "distances in long double")
{
    long double length = sqrtl(vec3_dot(ray.direction, ray.direction)), best = INFINITY;
    Hit hit = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        long double distance = t * length;
        if (distance < best) {
            best = distance;
            hit = (Hit){t, i};
        }
    }
    return hit;
}

RIGHT(cast_image_order, "by columns, with a helper")
{
    for (int x = 0; x < image->size.width; ++x)
        for (int y = 0; y < image->size.height; ++y) {
            Pixel pixel = {.row = y, .column = x};
            image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
        }
}

RIGHT(cast_image_order, "from the last pixel on")
{
    for (int i = image->size.width * image->size.height; i-- > 0;) {
        Pixel pixel = {i % image->size.width, i / image->size.width};
        image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
    }
}

RIGHT(cast_image_order, "bytes written through a pointer")
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

RIGHT(cast_image_order, "background first, then the hits")
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

RIGHT(cast_image_order, "rays with unit directions")
{
    for (Pixel p = {0, 0}; p.row < image->size.height; p.row++)
        for (p.column = 0; p.column < image->size.width; p.column++) {
            Ray ray = pixel_ray(camera, image->size, p);
            ray.direction = vec3_unit(ray.direction);
            image_set(image, p, color_along(ray, scene));
        }
}

// Each pixel searches for its own nearest hit, without nearest_hit.
RIGHT(cast_image_order, "without nearest_hit and image_set")
{
    const Resolution size = image->size;
    for (int k = 0, row = 0; row < size.height; row++)
        for (int column = 0; column < size.width; column++, k++) {
            Ray ray = pixel_ray(camera, size, (Pixel){column, row});
            Color color = scene->background;
            double nearest = NO_HIT;
            for (int i = 0; i < scene->sphere_count; i++) {
                double t = hit_sphere(ray, scene->spheres[i]);
                if (t >= nearest)
                    continue;
                nearest = t;
                color = scene_surface(scene, i)->color;
            }
            for (int c = 0; c < 3; c++)
                image->rgb[3 * k + c] = byte_from_color(color[c]);
        }
}

RIGHT(cast_image_order, "rows by recursion, from the bottom")
{
    int row = image->size.height;
    while (row-- > 0)
        rest_of_row(scene, camera, image, (Pixel){0, row});
}

// The image plane spanned by hand: its upper left corner, and a step to the right and one down.
RIGHT(cast_image_order, "steps on the image plane")
{
    vec3 right = camera.width / image->size.width * camera.right;
    vec3 down = -camera.height / image->size.height * camera.up;
    vec3 corner = camera.distance * camera.forward - camera.width / 2 * camera.right +
                  camera.height / 2 * camera.up;
    for (int y = 0; y < image->size.height; y++)
        for (int x = 0; x < image->size.width; x++) {
            Ray ray = {camera.origin, corner + (x + 0.5) * right + (y + 0.5) * down};
            image_set(image, (Pixel){x, y}, color_along(ray, scene));
        }
}

// Two checkerboards, the second of the pixels that the first left out.
RIGHT(cast_image_order, "two checkerboards")
{
    for (int pass = 0; pass < 2; pass++)
        for (int row = 0; row < image->size.height; row++)
            for (int column = (row + pass) % 2; column < image->size.width; column += 2) {
                Pixel pixel = {column, row};
                image_set(image, pixel, color_along(pixel_ray(camera, image->size, pixel), scene));
            }
}

RIGHT(cast_image_order, "by object order")
{
    double *depth = calloc((size_t)image->size.width * (size_t)image->size.height, sizeof *depth);
    cast_object_order(scene, camera, image, depth);
    free(depth);
}

RIGHT(cast_object_order, "by image order and nearest_hit")
{
    cast_image_order(scene, camera, image);
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            *depth++ = nearest_hit(pixel_ray(camera, image->size, (Pixel){column, row}), scene).t;
}

RIGHT(cast_object_order, "spheres backward, by columns, with a helper")
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

RIGHT(cast_object_order, "one loop, the background last")
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

// The sphere is remembered as well, and everything is painted at the end.
RIGHT(cast_object_order, "colours at the end, with fmin")
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

// A depth array of its own, in long double, copied at the end.
RIGHT(cast_object_order, "a depth of its own, in long double")
{
    Resolution size = image->size;
    size_t pixels = (size_t)size.width * (size_t)size.height;
    long double *own = malloc(pixels * sizeof *own);
    for (size_t i = 0; i < pixels; i++)
        own[i] = HUGE_VALL;
    for (int row = 0; row < size.height; row++)
        for (int column = 0; column < size.width; column++)
            image_set(image, (Pixel){column, row}, scene->background);
    for (int sphere = 0; sphere < scene->sphere_count; sphere++)
        for (int row = 0; row < size.height; row++)
            for (int column = 0; column < size.width; column++) {
                Pixel pixel = {.column = column, .row = row};
                long double t = hit_sphere(pixel_ray(camera, size, pixel), scene->spheres[sphere]);
                if (t < own[image_index(image, pixel)]) {
                    own[image_index(image, pixel)] = t;
                    image_set(image, pixel, scene_surface(scene, sphere)->color);
                }
            }
    for (size_t i = 0; i < pixels; i++)
        depth[i] = (double)own[i];
    free(own);
}

RIGHT(cast_object_order, "spheres in their bounding boxes, backward")
{
    Resolution size = image->size;
    for (int row = 0; row < size.height; row++)
        for (int column = 0; column < size.width; column++) {
            depth[row * size.width + column] = NO_HIT;
            image_set(image, (Pixel){column, row}, scene->background);
        }
    for (int i = scene->sphere_count; i-- > 0;) {
        const Sphere *s = &scene->spheres[i];
        vec3 center = s->center - camera.origin;
        Box box;
        span(center, s->radius, camera.forward, camera.right, camera.width / camera.distance,
             size.width, &box.left, &box.right);
        span(center, s->radius, camera.forward, -camera.up, camera.height / camera.distance,
             size.height, &box.top, &box.bottom);
        for (int row = box.top; row < box.bottom; row++)
            for (int column = box.left; column < box.right; column++) {
                Pixel pixel = {column, row};
                visit(scene, i, pixel_ray(camera, size, pixel), pixel, image,
                      depth + row * size.width + column);
            }
    }
}

RIGHT(cast_object_order, "rays and colours in arrays")
{
    Resolution size = image->size;
    int count = size.width * size.height;
    Ray *rays = aligned_alloc(_Alignof(Ray), (size_t)count * sizeof *rays);
    Color *colors = aligned_alloc(_Alignof(Color), (size_t)count * sizeof *colors);
    for (int i = 0; i < count; i++) {
        rays[i] = pixel_ray(camera, size, (Pixel){i % size.width, i / size.width});
        colors[i] = scene->background;
        depth[i] = NO_HIT;
    }
    for (int s = 0; s < scene->sphere_count; s++)
        for (int i = 0; i < count; i++) {
            double t = hit_sphere(rays[i], scene->spheres[s]);
            if (t < depth[i]) {
                depth[i] = t;
                colors[i] = scene_surface(scene, s)->color;
            }
        }
    for (int i = 0; i < count; i++)
        image_set(image, (Pixel){i % size.width, i / size.width}, colors[i]);
    free(rays);
    free(colors);
}
