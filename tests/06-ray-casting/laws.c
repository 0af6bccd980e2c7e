// laws.c - the laws of exercise 06: a hit is on its sphere, no sphere is in front of it, and a
// pixel shows the first hit of its ray.
#include "exercises/06-ray-casting.h"

#include "common/text.h"
#include "tests/judge/known.h"

#include <stdio.h>

// How far a hit may be off, in radii along the ray (exercises/05-quadratic.h).
#define HIT_TOLERANCE 1e-6

// The distance of the point at t from the surface, in radii: negative inside.
static double off_the_sphere(Ray ray, double t, Sphere sphere)
{
    vec3 point = ray.origin + t * ray.direction;
    return vec3_length(point - sphere.center) / sphere.radius - 1;
}

static bool both_or_none(Hit yours, const Scene *scene)
{
    int count = scene->sphere_count;
    if (yours.sphere < -1 || yours.sphere >= count)
        law_broken("your sphere is number %d, but the scene has %d, counted from 0", yours.sphere,
                   count);
    else if (yours.sphere == -1 && yours.t != NO_HIT)
        law_broken("your sphere is -1, no sphere, but your t is %s; without a hit t is NO_HIT",
                   number_text(yours.t).s);
    else if (yours.sphere >= 0 && yours.t == NO_HIT)
        law_broken("your sphere is number %d, but your t is NO_HIT: set either both or neither",
                   yours.sphere);
    else
        return true;
    return false;
}

static bool is_there(Hit yours, Ray ray, const Scene *scene)
{
    if (yours.sphere < 0)
        return true;
    double off = off_the_sphere(ray, yours.t, scene->spheres[yours.sphere]);
    if (yours.t > 0 && fabs(off) <= HIT_TOLERANCE)
        return true;
    double radius = scene->spheres[yours.sphere].radius;
    if (!(yours.t > 0))
        law_broken("your t is %s: a hit is in front of the eye, t > 0", number_text(yours.t).s);
    else
        law_broken("your t is %s on sphere %d, but that point is %s from its center, and its "
                   "radius is %s",
                   number_text(yours.t).s, yours.sphere, number_text((off + 1) * radius).s,
                   number_text(radius).s);
    return false;
}

// The right hit is: nearer by more than rounding, or as near and of a lower index.
static void something_is_before_it(Hit yours, Hit right, Ray ray, const Scene *scene)
{
    if (right.sphere < 0)
        return;
    double rounding =
        HIT_TOLERANCE * scene->spheres[right.sphere].radius / vec3_length(ray.direction);
    if (right.t < yours.t - rounding)
        law_broken("sphere %d is hit at t = %s, nearer than your %s", right.sphere,
                   number_text(right.t).s, yours.t == NO_HIT ? "NO_HIT" : number_text(yours.t).s);
    else if (right.t == yours.t && right.sphere < yours.sphere)
        law_broken("spheres %d and %d are both hit at t = %s: the lower index counts", right.sphere,
                   yours.sphere, number_text(right.t).s);
}

LAW(nearest_hit)
{
    if (both_or_none(yours, scene) && is_there(yours, ray, scene))
        something_is_before_it(yours, right, ray, scene);
}

// ---- the laws of both orders: each pixel shows the first hit of its ray -------------------------

static Text hit_t_text(double t)
{
    return t == NO_HIT ? (Text){"NO_HIT"} : number_text(t);
}

// Of the ray of a pixel (facts.c): the length of its direction, and where it hits each sphere.
typedef struct {
    double length;
    const double *t;
} PixelRay;

static PixelRay ray_of_pixel(const Scene *scene, int i)
{
    const double *facts = law_facts() + i * (1 + scene->sphere_count);
    return (PixelRay){facts[0], facts + 1};
}

static Hit first_hit(PixelRay ray, const Scene *scene)
{
    Hit first = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++)
        if (ray.t[i] < first.t)
            first = (Hit){ray.t[i], i};
    return first;
}

static int pixel_count(const Image *image)
{
    return image->size.width * image->size.height;
}

static Pixel pixel_number(const Image *image, int i)
{
    return (Pixel){i % image->size.width, i / image->size.width};
}

static bool are(const uint8_t *bytes, Color color)
{
    return bytes[0] == byte_from_color(color[0]) && bytes[1] == byte_from_color(color[1]) &&
           bytes[2] == byte_from_color(color[2]);
}

static bool is_background(const uint8_t *bytes, const Scene *scene)
{
    return are(bytes, scene->background);
}

// The sphere of this color that the ray hits first; if it hits none of them, any; with NO_HIT, -1
// if there is none.
static Hit colored_so(const uint8_t *bytes, PixelRay ray, const Scene *scene)
{
    Hit found = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        if (!are(bytes, scene_surface(scene, i)->color))
            continue;
        if (found.sphere < 0 || ray.t[i] < found.t)
            found = (Hit){ray.t[i], i};
    }
    return found;
}

static bool colors_are_of_the_scene(const Scene *scene, const Image *image)
{
    int strange = 0;
    Pixel first = {0, 0};
    for (int i = pixel_count(image); i-- > 0;) {
        const uint8_t *bytes = image_bytes(image, pixel_number(image, i));
        if (!is_background(bytes, scene) &&
            colored_so(bytes, ray_of_pixel(scene, i), scene).sphere < 0) {
            strange++;
            first = pixel_number(image, i);
        }
    }
    if (strange == 0)
        return true;
    const uint8_t *bytes = image_bytes(image, first);
    law_broken("%d of %d pixels are not set, or not to a color of the scene; the first, in "
               "column %d, row %d, is red %d, green %d, blue %d",
               strange, pixel_count(image), first.column, first.row, bytes[0], bytes[1], bytes[2]);
    return false;
}

// The pixel of the right picture that a turned picture shows here.
static Pixel turned(int turn, Pixel here, Resolution size)
{
    Pixel opposite = {size.width - 1 - here.column, size.height - 1 - here.row};
    const Pixel pixels[] = {{here.column, opposite.row},
                            {opposite.column, here.row},
                            opposite,
                            {here.row, here.column}};
    return pixels[turn];
}

// Whether a pixel has these bytes in the right picture.
static bool is_right(const uint8_t *bytes, int pixel)
{
    const double *right = law_right() + 3 * pixel;
    return bytes[0] == right[0] && bytes[1] == right[1] && bytes[2] == right[2];
}

static bool is_not_turned(const Image *yours)
{
    static const char *const turns[] = {"upside down", "mirrored", "turned by 180 degrees",
                                        "with rows and columns swapped"};
    Resolution size = yours->size;
    for (int turn = 0; turn < 4; turn++) {
        bool same = true, different = false;
        for (int i = 0; i < pixel_count(yours) && same; i++) {
            Pixel here = pixel_number(yours, i), there = turned(turn, here, size);
            if (there.column >= size.width || there.row >= size.height)
                continue;
            const uint8_t *bytes = image_bytes(yours, here);
            same = is_right(bytes, there.row * size.width + there.column);
            different = different || !is_right(bytes, i);
        }
        if (same && different) {
            law_broken("the picture is the right one %s", turns[turn]);
            return false;
        }
    }
    return true;
}

static bool depth_is_right(Pixel pixel, double yours, PixelRay ray, const Scene *scene)
{
    Hit hit = first_hit(ray, scene);
    if (yours == hit.t)
        return true;
    if (hit.sphere < 0)
        law_broken("the depth in column %d, row %d is %s, but nothing is hit there: NO_HIT",
                   pixel.column, pixel.row, number_text(yours).s);
    else if (!(fabs(yours - hit.t) <=
               HIT_TOLERANCE * scene->spheres[hit.sphere].radius / ray.length))
        law_broken("the depth in column %d, row %d is %s, but sphere %d is hit there at t = %s",
                   pixel.column, pixel.row,
                   yours == NO_HIT ? hit_t_text(yours).s : apart(yours, hit.t).yours.s, hit.sphere,
                   apart(yours, hit.t).right.s);
    else
        return true;
    return false;
}

static void say_what_is_shown(Pixel pixel, const uint8_t *yours, PixelRay ray, const Scene *scene)
{
    Hit hit = first_hit(ray, scene), shown = colored_so(yours, ray, scene);
    char hits[80] = "hits nothing", color[80] = "the background";
    if (hit.sphere >= 0)
        snprintf(hits, sizeof hits, "first hits sphere %d, at t = %.20s", hit.sphere,
                 number_text(hit.t).s);
    if (shown.t < NO_HIT && shown.t == hit.t)
        snprintf(color, sizeof color, "sphere %d, hit at the same t: the lower index counts",
                 shown.sphere);
    else if (shown.t < NO_HIT)
        snprintf(color, sizeof color, "sphere %d, hit at t = %.20s", shown.sphere,
                 number_text(shown.t).s);
    else if (!is_background(yours, scene))
        snprintf(color, sizeof color, "sphere %d, which it misses", shown.sphere);
    law_broken("the ray of column %d, row %d %s, but the pixel's color is that of %s", pixel.column,
               pixel.row, hits, color);
}

static void law_of_pictures(const Scene *scene, const Image *yours, const double *depth)
{
    int pixels = pixel_count(yours), wrong = 0;
    while (wrong < pixels && is_right(yours->rgb + 3 * wrong, wrong))
        wrong++;
    bool fine = wrong == pixels || (colors_are_of_the_scene(scene, yours) && is_not_turned(yours));
    for (int i = 0; i < pixels && fine && depth != NULL; i++)
        fine = depth_is_right(pixel_number(yours, i), depth[i], ray_of_pixel(scene, i), scene);
    if (fine && wrong < pixels)
        say_what_is_shown(pixel_number(yours, wrong), yours->rgb + 3 * wrong,
                          ray_of_pixel(scene, wrong), scene);
}

LAW(cast_image_order)
{
    law_of_pictures(scene, image, NULL);
}

LAW(cast_object_order)
{
    law_of_pictures(scene, image, depth);
}
