// laws_by_reference.c - the laws of exercise 06 that ask the reference: a pixel shows the first hit
// of its ray.
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include "common/text.h"
#include "tests/judge/law.h"

#include <stdio.h>
#include <string.h>

// How far a hit may be off, in radii along the ray (exercises/05-quadratic.h), and therefore in t.
#define HIT_TOLERANCE 1e-6

static double hit_rounding(Ray ray, Sphere sphere)
{
    return HIT_TOLERANCE * sphere.radius / vec3_length(ray.direction);
}

static Text hit_t_text(double t)
{
    return t == NO_HIT ? (Text){"NO_HIT"} : number_text(t);
}

// ---- the laws of both orders: each pixel shows the first hit of its ray -------------------------

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

// The sphere of this colour that the ray hits first; if it hits none of them, any; with NO_HIT, -1
// if there is none.
static Hit coloured_so(const uint8_t *bytes, Ray ray, const Scene *scene)
{
    Hit found = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        if (!are(bytes, scene_surface(scene, i)->color))
            continue;
        double t = hit_sphere(ray, scene->spheres[i]);
        if (found.sphere < 0 || t < found.t)
            found = (Hit){t, i};
    }
    return found;
}

static bool colours_are_of_the_scene(const Scene *scene, const Image *image)
{
    const Ray any = {vec3_of(0, 0, 0), vec3_of(0, 0, 1)};
    int strange = 0;
    Pixel first = {0, 0};
    for (int i = pixel_count(image); i-- > 0;) {
        const uint8_t *bytes = image_bytes(image, pixel_number(image, i));
        if (!is_background(bytes, scene) && coloured_so(bytes, any, scene).sphere < 0) {
            strange++;
            first = pixel_number(image, i);
        }
    }
    if (strange == 0)
        return true;
    const uint8_t *bytes = image_bytes(image, first);
    law_broken("%d of %d pixels are not set, or not to a colour of the scene; the first, in "
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

static bool is_not_turned(const Image *yours, const Image *right)
{
    static const char *const turns[] = {"upside down", "mirrored", "turned by 180 degrees",
                                        "with rows and columns swapped"};
    Resolution size = right->size;
    for (int turn = 0; turn < 4; turn++) {
        bool same = true, different = false;
        for (int i = 0; i < pixel_count(right) && same; i++) {
            Pixel here = pixel_number(right, i), there = turned(turn, here, size);
            if (there.column >= size.width || there.row >= size.height)
                continue;
            const uint8_t *bytes = image_bytes(yours, here);
            same = memcmp(bytes, image_bytes(right, there), 3) == 0;
            different = different || memcmp(bytes, image_bytes(right, here), 3) != 0;
        }
        if (same && different) {
            law_broken("the picture is the right one %s", turns[turn]);
            return false;
        }
    }
    return true;
}

static bool depth_is_right(Pixel pixel, double yours, Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene);
    if (yours == hit.t)
        return true;
    if (hit.sphere < 0)
        law_broken("the depth in column %d, row %d is %s, but nothing is hit there: NO_HIT",
                   pixel.column, pixel.row, number_text(yours).s);
    else if (!(fabs(yours - hit.t) <= hit_rounding(ray, scene->spheres[hit.sphere])))
        law_broken("the depth in column %d, row %d is %s, but sphere %d is hit there at t = %s",
                   pixel.column, pixel.row,
                   yours == NO_HIT ? hit_t_text(yours).s : apart(yours, hit.t).yours.s, hit.sphere,
                   apart(yours, hit.t).right.s);
    else
        return true;
    return false;
}

static void say_what_is_shown(Pixel pixel, const uint8_t *yours, Ray ray, const Scene *scene)
{
    Hit hit = nearest_hit(ray, scene), shown = coloured_so(yours, ray, scene);
    char hits[80] = "hits nothing", colour[80] = "the background";
    if (hit.sphere >= 0)
        snprintf(hits, sizeof hits, "first hits sphere %d, at t = %.20s", hit.sphere,
                 number_text(hit.t).s);
    if (shown.t < NO_HIT && shown.t == hit.t)
        snprintf(colour, sizeof colour, "sphere %d, hit at the same t: the lower index counts",
                 shown.sphere);
    else if (shown.t < NO_HIT)
        snprintf(colour, sizeof colour, "sphere %d, hit at t = %.20s", shown.sphere,
                 number_text(shown.t).s);
    else if (!is_background(yours, scene))
        snprintf(colour, sizeof colour, "sphere %d, which it misses", shown.sphere);
    law_broken("the ray of column %d, row %d %s, but the pixel's colour is that of %s",
               pixel.column, pixel.row, hits, colour);
}

static void law_of_pictures(const Scene *scene, Camera camera, const Image *yours,
                            const double *depth)
{
    Image right;
    Message message;
    if (!image_create(&right, yours->size, &message))
        return;
    cast_image_order(scene, camera, &right);
    int pixels = pixel_count(&right), wrong = 0;
    while (wrong < pixels && memcmp(yours->rgb + 3 * wrong, right.rgb + 3 * wrong, 3) == 0)
        wrong++;
    bool fine =
        wrong == pixels || (colours_are_of_the_scene(scene, yours) && is_not_turned(yours, &right));
    for (int i = 0; i < pixels && fine; i++) {
        Pixel pixel = pixel_number(&right, i);
        if (depth != NULL)
            fine = depth_is_right(pixel, depth[i], pixel_ray(camera, right.size, pixel), scene);
    }
    if (fine && wrong < pixels) {
        Pixel pixel = pixel_number(&right, wrong);
        say_what_is_shown(pixel, image_bytes(yours, pixel), pixel_ray(camera, right.size, pixel),
                          scene);
    }
    image_free(&right);
}

LAW(cast_image_order)
{
    law_of_pictures(scene, camera, image, NULL);
}

LAW(cast_object_order)
{
    law_of_pictures(scene, camera, image, depth);
}
