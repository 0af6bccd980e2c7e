// facts.c - what the laws of exercise 07 need to know: cosines, what hides a light, and what each
// part of a color adds.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include "tests/judge/known.h"

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

FACTS(diffuse_term)
{
    fact(cosine_between(normal, to_light));
}

// Of the light and of the eye, and of the highlight.
FACTS(phong_term)
{
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    fact(low);
    fact(high);
    fact(2 * low * high - cosine_between(to_light, to_eye));
}

// An eye opposite to the light has no halfway vector: as if it were on the edge.
FACTS(halfway_term)
{
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    double length = sqrt(2 + 2 * cosine_between(to_light, to_eye)); // of the sum of both
    fact(low);
    fact(high);
    fact(length > 1e-3 ? (low + high) / length : 0);
}

static void color_fact(Color color)
{
    for (int i = 0; i < 3; i++)
        fact(color[i]);
}

FACTS(visibility)
{
    Ray ray = ray_to_light(from, light);
    color_fact(ray.direction);
    for (int i = 0; i < scene->sphere_count; i++)
        fact(hit_sphere(ray, scene->spheres[i]));
}

// The ambient part alone, and what each light adds to it.
static Color with_lights(const Scene *scene, Ray ray, Hit hit, int first, int end)
{
    Scene some = *scene;
    some.lights += first;
    some.light_count = end - first;
    return shade(&some, ray, hit);
}

FACTS(shade)
{
    Color ambient = with_lights(scene, ray, hit, 0, 0);
    color_fact(ambient);
    for (int i = 0; i < scene->light_count; i++)
        color_fact(with_lights(scene, ray, hit, i, i + 1) - ambient);
}

// The color of shade, and the sphere that is hit.
FACTS(trace_ray)
{
    Hit hit = nearest_hit(ray, scene);
    color_fact(hit.sphere < 0 ? scene->background : shade(scene, ray, hit));
    fact(hit.sphere);
}
