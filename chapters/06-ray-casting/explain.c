// explain.c - one pixel from its column and row to its color, in words and numbers.
//
// Each number comes from the exercise function that computes it. So this explains the picture of
// the answers that are linked, also if they are wrong.
#include "chapters/06-ray-casting/explain.h"

#include "common/answers.h"
#include "common/image.h"
#include "common/story.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

#include <stdio.h>
#include <string.h>

enum { MOST_CAST = 4000000 }; // pairs of a ray and a sphere: well below a second

double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// ---- which spheres ----------------------------------------------------------------------------

typedef struct {
    int sphere;
    double key;
} Ranked;

// Keeps the lowest keys in ascending order. count is the number of calls so far.
static void rank(Ranked *list, int room, int *count, Ranked one)
{
    int place = *count < room ? *count : room;
    for (; place > 0 && one.key < list[place - 1].key; place--)
        if (place < room)
            list[place] = list[place - 1];
    if (place < room)
        list[place] = one;
    ++*count;
}

// The distance at which the ray passes the center of a sphere, in radii.
static double gap(Ray ray, Sphere sphere)
{
    vec3 p = sphere.center - ray.origin;
    double t = fmax(0, vec3_dot(p, ray.direction) / vec3_dot(ray.direction, ray.direction));
    return vec3_length(p - t * ray.direction) / sphere.radius;
}

static void tell_of(Outcome *outcome, const Ranked *list, int count)
{
    for (int i = 0; i < count; i++) {
        int place = outcome->told_count++;
        for (; place > 0 && list[i].sphere < outcome->told[place - 1]; place--)
            outcome->told[place] = outcome->told[place - 1];
        outcome->told[place] = list[i].sphere;
    }
}

Outcome outcome_of(Ray ray, const Scene *scene, int room)
{
    Outcome outcome = {0};
    Ranked hits[MOST_TOLD], behind[MOST_TOLD], misses[MOST_TOLD];
    for (int i = 0; i < scene->sphere_count; i++) {
        Sphere sphere = scene->spheres[i];
        double t = hit_sphere(ray, sphere);
        if (t < NO_HIT)
            rank(hits, room, &outcome.hit, (Ranked){i, t});
        else if (sphere_roots(ray, sphere).count > 0)
            rank(behind, room, &outcome.behind, (Ranked){i, gap(ray, sphere)});
        else
            rank(misses, room, &outcome.missed, (Ranked){i, gap(ray, sphere)});
    }
    // Room for two narrow misses and one sphere behind the eye, and the rest for hits. If there are
    // fewer hits, the others get their room.
    int others = outcome.missed < 2 ? outcome.missed : 2;
    int back = outcome.behind < 1 ? outcome.behind : 1;
    int front = outcome.hit < room - others - back ? outcome.hit : room - others - back;
    back = outcome.behind < room - others - front ? outcome.behind : room - others - front;
    others = outcome.missed < room - back - front ? outcome.missed : room - back - front;
    tell_of(&outcome, hits, front);
    tell_of(&outcome, behind, back);
    tell_of(&outcome, misses, others);
    return outcome;
}

// ---- the explanation ----------------------------------------------------------------------------

static Ray the_ray(const Shot *shot)
{
    ScreenPoint point = pixel_center(shot->pixel);
    Normalized place = screen_to_normalized(point, shot->size);
    Ray ray = pixel_ray(shot->camera, shot->size, shot->pixel);
    story_heading("From the pixel to its ray");
    story_line("pixel (column, row)", "(%d, %d)", shot->pixel.column, shot->pixel.row);
    story_by("pixel_center");
    story_line("its center (x, y)", "%s", pair_text(point.x, point.y).s);
    story_by("screen_to_normalized");
    story_line("normalized (s, t)", "%s", pair_text(place.s, place.t).s);
    story_line("vector from the eye", "%s", vec3_text(ray_to_plane(ray, shot->camera).direction).s);
    story_by("pixel_ray");
    story_line("ray: origin     p", "%s", vec3_text(ray.origin).s);
    story_by("pixel_ray");
    story_line("ray: direction  v", "%s", vec3_text(ray.direction).s);
    return ray;
}

// The meaning of the discriminant. Its sign may contradict the roots because digits are lost near a
// tangent (chapter 05); if not, the answers contradict each other.
static const char *discriminant_says(Quadratic q, bool none)
{
    double d = discriminant(q);
    if ((d < 0) == none)
        return none ? " < 0, no root: missed" : "";
    if (fabs(d) < 1e-6 * q.b * q.b)
        return none ? ", by rounding: missed" : ", by rounding: it has roots";
    return none ? ", but sphere_roots finds none" : " < 0, but sphere_roots finds some";
}

// The meaning of the roots, in words.
static void verdict(Quadratic q, Roots roots, double hit)
{
    bool none = roots.count == 0;
    story_line("    b^2 - 4ac", "%s%s", number_text(discriminant(q)).s, discriminant_says(q, none));
    if (none)
        return;
    story_by("sphere_roots");
    story_line("    roots", "%s and %s", number_text(roots.t[0]).s, number_text(roots.t[1]).s);
    story_by("hit_sphere");
    if (!(hit < NO_HIT))
        story_line("    hit", "none: both are behind the eye");
    else
        story_line("    hit", "t = %s, %s", number_text(hit).s,
                   roots.t[0] == roots.t[1] ? "it touches the sphere"
                   : roots.t[0] > 0         ? "the smaller root: the ray enters"
                                            : "the only root > 0: the eye is inside");
}

static void one_sphere(Ray ray, const Scene *scene, int i)
{
    Sphere sphere = scene->spheres[i];
    Ray moved = to_object_coordinates(ray, sphere);
    Quadratic q = object_quadratic(moved, sphere.radius);
    printf("  %-3s center %s, radius %s\n", sphere_name(i).s, vec3_text(sphere.center).s,
           number_text(sphere.radius).s);
    story_by("to_object_coordinates");
    story_line("    p - center", "%s", vec3_text(moved.origin).s);
    story_by("object_quadratic");
    story_line("    a, b, c", "%s, %s, %s", number_text(q.a).s, number_text(q.b).s,
               number_text(q.c).s);
    verdict(q, sphere_roots(ray, sphere), hit_sphere(ray, sphere));
}

static void the_spheres(Ray ray, const Scene *scene)
{
    Outcome outcome = outcome_of(ray, scene, MOST_TOLD);
    story_heading("Each sphere: a t^2 + b t + c = 0");
    if (scene->sphere_count > outcome.told_count)
        printf("  %d spheres; these %d have the nearest hits or the narrowest misses.\n",
               scene->sphere_count, outcome.told_count);
    for (int i = 0; i < outcome.told_count; i++)
        one_sphere(ray, scene, outcome.told[i]);
    printf("  In all: %d hit, %d behind the eye, %d missed.\n", outcome.hit, outcome.behind,
           outcome.missed);
}

static Hit the_nearest(Ray ray, const Scene *scene)
{
    Hit hits[MOST_TOLD], nearest = nearest_hit(ray, scene);
    int count = hits_of(ray, scene, hits, MOST_TOLD);
    story_heading("The smallest t > 0 is nearest");
    for (int i = 0; i < count && i < MOST_TOLD; i++) {
        vec3 place = ray.origin + hits[i].t * ray.direction;
        printf("  %-3s t = %-12s at %s%s\n", sphere_name(hits[i].sphere).s,
               number_text(hits[i].t).s, vec3_text(place).s,
               hits[i].sphere == nearest.sphere ? ": nearest" : "");
    }
    if (count > MOST_TOLD)
        printf("  and %d hits that are farther away\n", count - MOST_TOLD);
    if (count == 0)
        printf("  There is none: the pixel has the color of the background.\n");
    return nearest;
}

// The same pixel of the cast picture. False if casting the whole picture would take too long.
static bool pixel_as_cast(const Shot *shot, uint8_t rgb[3])
{
    Message message;
    Image image;
    long pixels = (long)shot->size.width * shot->size.height;
    if (pixels * (shot->scene->sphere_count + 1L) > MOST_CAST ||
        !image_create(&image, shot->size, &message))
        return false;
    cast_image_order(shot->scene, shot->camera, &image);
    memcpy(rgb, image_bytes(&image, shot->pixel), 3);
    image_free(&image);
    return true;
}

static void the_color(const Shot *shot, Hit nearest)
{
    bool any = is_sphere(shot->scene, nearest.sphere);
    Color color = any ? scene_surface(shot->scene, nearest.sphere)->color : shot->scene->background;
    char label[180] = "of the background";
    if (any)
        snprintf(label, sizeof label, "of sphere %s", sphere_name(nearest.sphere).s);
    uint8_t bytes[3], cast[3];
    for (int i = 0; i < 3; i++)
        bytes[i] = byte_from_color(color[i]);
    story_heading("The color");
    story_line(label, "%s", vec3_text(color).s);
    story_line("as bytes, round(255 c)", "%d, %d, %d  #%02x%02x%02x", bytes[0], bytes[1], bytes[2],
               bytes[0], bytes[1], bytes[2]);
    story_by("cast_image_order");
    if (pixel_as_cast(shot, cast))
        story_line("in the picture", "%d, %d, %d%s", cast[0], cast[1], cast[2],
                   memcmp(bytes, cast, 3) == 0 ? ", the same"
                                               : ": different; look at cast_image_order");
}

int explain(const Shot *shot, const char *scene_path)
{
    const char *slash = strrchr(scene_path, '/');
    printf("06-ray-casting: one pixel, explained\n");
    story_heading("The picture");
    story_line("scene", "%s", word_text(slash != NULL ? slash + 1 : scene_path).s);
    story_line("pixels", "%d x %d", shot->size.width, shot->size.height);
    story_camera(shot->camera);
    Ray ray = the_ray(shot);
    the_spheres(ray, shot->scene);
    the_color(shot, the_nearest(ray, shot->scene));
    return story_end();
}
