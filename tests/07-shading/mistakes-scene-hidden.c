// mistakes-scene-hidden.c - wrong answers to shade: which lights count, and what is left in the
// shadow.
#include "tests/07-shading/mistakes-scene.h"

static Color with_lights(const Scene *scene, int first, int end, Ray ray, Hit hit)
{
    Scene some = *scene;
    some.lights += first;
    some.light_count = end > first ? end - first : 0;
    return shade(&some, ray, hit);
}

static Color first_light(const Scene *scene, Ray ray, Hit hit)
{
    return with_lights(scene, 0, scene->light_count > 0, ray, hit);
}

static Color last_light(const Scene *scene, Ray ray, Hit hit)
{
    int last = scene->light_count > 0 ? scene->light_count - 1 : 0;
    return with_lights(scene, last, scene->light_count, ray, hit);
}

static Color but_the_first(const Scene *scene, Ray ray, Hit hit)
{
    return with_lights(scene, scene->light_count > 0, scene->light_count, ray, hit);
}

static Color but_the_last(const Scene *scene, Ray ray, Hit hit)
{
    return with_lights(scene, 0, scene->light_count - 1, ray, hit);
}

// Which lights arrive.
static bool arrives(const Scene *scene, Ray ray, Hit hit, int light)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 start = off_surface(sphere, point, normal_turned(sphere, point, ray));
    return visibility(scene, start, scene->lights[light]) > 0;
}

static int first_hidden(const Scene *scene, Ray ray, Hit hit)
{
    int i = 0;
    while (i < scene->light_count && arrives(scene, ray, hit, i))
        i++;
    return i;
}

static bool any_hidden(const Scene *scene, Ray ray, Hit hit)
{
    return first_hidden(scene, ray, hit) < scene->light_count;
}

static bool any_arrives(const Scene *scene, Ray ray, Hit hit)
{
    for (int i = 0; i < scene->light_count; i++)
        if (arrives(scene, ray, hit, i))
            return true;
    return false;
}

static Color until_one_is_hidden(const Scene *scene, Ray ray, Hit hit)
{
    return with_lights(scene, 0, first_hidden(scene, ray, hit), ray, hit);
}

static Color ambient_where_any_is_hidden(const Scene *scene, Ray ray, Hit hit)
{
    return with_lights(scene, 0, any_hidden(scene, ray, hit) ? 0 : scene->light_count, ray, hit);
}

static Color black_in_shadow(const Scene *scene, Ray ray, Hit hit)
{
    bool lit = scene->light_count == 0 || any_arrives(scene, ray, hit);
    return lit ? shade(scene, ray, hit) : vec3_of(0, 0, 0);
}

static Color black_where_any_is_hidden(const Scene *scene, Ray ray, Hit hit)
{
    return any_hidden(scene, ray, hit) ? vec3_of(0, 0, 0) : shade(scene, ray, hit);
}

// Ambient light as if it came from each light, and were hidden with it.
static Color ambient_shadowed(const Scene *scene, Ray ray, Hit hit)
{
    Color ambient = with_lights(scene, 0, 0, ray, hit), sum = -ambient;
    for (int i = 0; i < scene->light_count; i++)
        sum += arrives(scene, ray, hit, i) ? ambient : vec3_of(0, 0, 0);
    return shade(scene, ray, hit) + sum;
}

static Color background_in_shadow(const Scene *scene, Ray ray, Hit hit)
{
    return any_arrives(scene, ray, hit) ? shade(scene, ray, hit) : scene->background;
}

const Mistake hidden_light_mistakes[] = {
    MISTAKE("L-first", shade, first_light, "the first light only", "all lights add up.",
            "too dark, shadows of one lamp only"),
    MISTAKE("L-last", shade, last_light, "the last light only",
            "each light overwrites the one before. They add up: +=.",
            "too dark, shadows of one lamp only"),
    MISTAKE("L-from1", shade, but_the_first, "light 0 left out", "lights are counted from 0.",
            "the first lamp is off"),
    MISTAKE("L-but-last", shade, but_the_last, "the last light left out",
            "counted from 0, the last of n lights has the index n - 1, and it must be added.",
            "the last lamp is off"),
    MISTAKE("L-break", shade, until_one_is_hidden, "lights up to the first that is hidden",
            "the next light may still arrive: go on with it.",
            "shadows of one lamp darken the others"),
    MISTAKE("L-any", shade, ambient_where_any_is_hidden, "ambient only, if any light is hidden",
            "a hidden light does not take away the others.",
            "shadows of one lamp where another shines"),
    MISTAKE("L-black", shade, black_in_shadow, "black if no light arrives",
            "the ambient light is everywhere, also in the shadow.", "pitch-black shadows"),
    MISTAKE("L-black-any", shade, black_where_any_is_hidden, "black if any light is hidden",
            "the ambient light is everywhere; and the other lights may arrive.",
            "pitch-black shadows, also where another lamp shines"),
    MISTAKE("L-ambient", shade, ambient_shadowed, "ambient with each light that arrives",
            "ambient light comes from no particular place and nothing hides it: add it once.",
            "pitch-black shadows; too bright where several lights arrive"),
    MISTAKE("L-sky", shade, background_in_shadow, "the background if no light arrives",
            "the surface is still there, in ambient light.", "holes instead of shadows"),
    {0},
};
