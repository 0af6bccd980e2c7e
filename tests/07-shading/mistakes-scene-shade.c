// mistakes-scene-shade.c - wrong answers to shade: the terms of the sum, and the surface.
#include "tests/07-shading/mistakes-scene.h"

// The values that are known at a hit.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, start, to_eye;
} Place;

static Place place_of(const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    return (Place){scene,  scene_surface(scene, hit.sphere),   point,
                   normal, off_surface(sphere, point, normal), -ray.direction};
}

static Color ambient_at(const Place *p)
{
    return ambient_term(p->surface->color, p->surface->diffuse, p->scene->ambient);
}

static Color lit_by(const Place *p, Light light, double visible)
{
    const Surface *s = p->surface;
    vec3 to_light = ray_to_light(p->point, light).direction;
    Color color = visible * light.color;
    return diffuse_term(s->color, s->diffuse, color, p->normal, to_light) +
           phong_term(s->specular, s->shine, color, p->normal, to_light, p->to_eye);
}

static Color lights_at(const Place *p)
{
    Color sum = vec3_of(0, 0, 0);
    for (int i = 0; i < p->scene->light_count; i++)
        sum += lit_by(p, p->scene->lights[i], visibility(p->scene, p->start, p->scene->lights[i]));
    return sum;
}

static Color sum_of(Place p)
{
    return ambient_at(&p) + lights_at(&p);
}

// ---- the sum ------------------------------------------------------------------------------------

// A place that differs from the right one in some way, and the usual sum.
#define AT(name, ...)                                                                              \
    static Color name(const Scene *scene, Ray ray, Hit hit)                                        \
    {                                                                                              \
        Place p = place_of(scene, ray, hit);                                                       \
        __VA_ARGS__;                                                                               \
        return sum_of(p);                                                                          \
    }

// Another sum at the right place.
#define SUM(name, sum)                                                                             \
    static Color name(const Scene *scene, Ray ray, Hit hit)                                        \
    {                                                                                              \
        Place p = place_of(scene, ray, hit);                                                       \
        return sum;                                                                                \
    }

static Color clamped(Color color)
{
    for (int i = 0; i < 3; i++)
        color[i] = fmin(1, fmax(0, color[i]));
    return color;
}

SUM(no_ambient, lights_at(&p))
SUM(ambient_alone, ambient_at(&p))
SUM(flat, p.surface->color)
SUM(sum_clamped, clamped(sum_of(p)))
SUM(sum_times_color, sum_of(p) * p.surface->color)
SUM(ambient_for_each_light, scene->light_count *ambient_at(&p) + lights_at(&p))
SUM(lights_averaged, ambient_at(&p) + lights_at(&p) / fmax(1, scene->light_count))
SUM(all_averaged, sum_of(p) / (1 + scene->light_count))
SUM(ambient_is_the_light, scene->ambient + lights_at(&p))
SUM(ambient_without_kd, p.surface->color * scene->ambient + lights_at(&p))
SUM(ambient_of_nff, SCENE_AMBIENT *p.surface->diffuse *p.surface->color + lights_at(&p))
SUM(ambient_of_the_background,
    ambient_term(p.surface->color, p.surface->diffuse, scene->background) + lights_at(&p))
SUM(background_added, sum_of(p) + p.surface->specular * scene->background)

// ---- the place ----------------------------------------------------------------------------------

#define START_AT(name, start_of)                                                                   \
    AT(name, p.start = start_of(scene->spheres[hit.sphere], p.point, p.normal, ray, hit.t))

AT(surface_of_that_number, p.surface = &scene->surfaces[hit.sphere])
AT(surface_0, p.surface = &scene->surfaces[0])
AT(surface_of_sphere_0, p.surface = scene_surface(scene, 0))
AT(normal_not_turned, p.normal = surface_normal(scene->spheres[hit.sphere], p.point);
   p.start = off_surface(scene->spheres[hit.sphere], p.point, p.normal))
AT(normal_reversed, p.normal = -p.normal;
   p.start = off_surface(scene->spheres[hit.sphere], p.point, p.normal))
AT(normal_not_unit, p.normal *= scene->spheres[hit.sphere].radius)
AT(normal_from_the_origin, p.normal = vec3_unit(p.point))
AT(eye_reversed, p.to_eye = ray.direction)
AT(eye_is_a_place, p.to_eye = ray.origin)
AT(eye_at_the_origin, p.to_eye = -p.point)
AT(point_as_if_unit, p = place_of(scene, (Ray){ray.origin, vec3_unit(ray.direction)}, hit))
AT(seen_from_the_eye, p.start = ray.origin)
START_AT(no_offset, start_there)
START_AT(offset_outward, start_outward)
START_AT(offset_along_the_ray, start_back_along_the_ray)
START_AT(offset_1e_3, start_a_thousandth_off)
START_AT(offset_1e_4, start_1e_4_off)
START_AT(offset_1e_5, start_1e_5_off)
START_AT(offset_1e_6, start_a_millionth_off)
START_AT(offset_1e_9, start_a_billionth_off)

const Mistake shade_mistakes[] = {
    MISTAKE("S-ambient", shade, no_ambient, "the lights alone",
            "the scene also has a light that is everywhere: add its term once.",
            "pitch-black shadows"),
    MISTAKE("S-only-ambient", shade, ambient_alone, "ambient alone",
            "each light that arrives adds its diffuse and its specular term. If you add them: does "
            "the ray to the light start on the eye's side of the surface, or below it? And does "
            "the vector point to the light, or away from it?",
            "flat and dark spheres"),
    MISTAKE("S-flat", shade, flat, "the surface's colour",
            "that is chapter 06: now the lights decide how much of it is seen.",
            "flat spheres, as before"),
    MISTAKE("S-clamp", shade, sum_clamped, "the sum, at most 1",
            "colours are clamped only at the very end, by clamp_color; in a mirror this one may be "
            "just right.",
            "no visible difference, except for dull highlights in mirrors"),
    MISTAKE("S-twice", shade, sum_times_color, "the whole sum times the surface's colour",
            "the terms contain the colour already; and highlights have that of the light.",
            "colours too dark, highlights as if of coloured metal"),
    MISTAKE("S-each", shade, ambient_for_each_light, "ambient once for each light",
            "it does not depend on the lights: add it once, before the loop.",
            "pale shadows where there are several lights"),
    MISTAKE("S-average", shade, lights_averaged, "the mean of the lights",
            "two lamps give more light than one: they add up.",
            "darker with every light that is added"),
    MISTAKE("S-average-all", shade, all_averaged, "the mean of ambient and all lights",
            "two lamps give more light than one: all of it adds up.",
            "darker with every light that is added"),
    MISTAKE("S-raw", shade, ambient_is_the_light, "the ambient light itself",
            "the surface reflects only its part of it: ambient_term has kd and the colour.",
            "grey shadows on surfaces of any colour"),
    MISTAKE("S-kd", shade, ambient_without_kd, "ambient without kd",
            "the surface scatters only kd of the ambient light as well: ambient_term.",
            "pale shadows"),
    MISTAKE("S-nff", shade, ambient_of_nff, "SCENE_AMBIENT instead of the scene's ambient light",
            "that is the initial value for a scene from a file. Use the value of this scene.",
            "no visible difference, until a scene has another ambient light"),
    MISTAKE("S-background", shade, ambient_of_the_background, "the background as ambient light",
            "the scene has both, and they differ.", "shadows in the colour of the sky"),
    MISTAKE("S-mirror", shade, background_added, "plus ks times the background",
            "mirrors come later, in trace_ray; here there are only lights.",
            "everything glows a little"),
    MISTAKE("S-index", shade, surface_of_that_number, "the surface of the sphere's number",
            "spheres and surfaces are numbered separately; each sphere has the number of its "
            "surface: scene_surface.",
            "spheres in each other's colours"),
    MISTAKE("S-surface0", shade, surface_0, "always surface 0",
            "each sphere has the number of its surface: scene_surface.",
            "all spheres in one colour"),
    MISTAKE("S-sphere0", shade, surface_of_sphere_0, "the surface of sphere 0",
            "the hit has the index of its sphere.", "all spheres in the colour of the first"),
    MISTAKE("S-turn", shade, normal_not_turned, "the normal outward, even from inside",
            "from inside the other side of the surface is visible: reverse the normal if it points "
            "away from the eye.",
            "hollow spheres dark inside, lit by the lights outside"),
    MISTAKE("W3-shade", shade, normal_reversed, "the normal on the side away from the eye",
            "it must point to the side of the eye: if the dot product of the normal and the ray's "
            "direction is positive, reverse it.",
            "dark spheres"),
    MISTAKE("W-unit", shade, normal_not_unit, "p - c as normal",
            "this is as long as the radius: divide by it.", "large spheres too bright"),
    MISTAKE("W2-shade", shade, normal_from_the_origin, "p / |p| as normal",
            "the vector from the centre to the point is p - c.",
            "right only for a sphere at the origin of the world"),
    MISTAKE("S-eye", shade, eye_reversed, "the ray's direction as direction to the eye",
            "the ray comes from the eye. The direction to the eye is the opposite, -v.",
            "highlights only at edges, opposite the light"),
    MISTAKE("S-eye-place", shade, eye_is_a_place, "the ray's origin as direction to the eye",
            "this is a point. The vector from the hit to it is -v, or o - p.",
            "highlights at wrong places"),
    MISTAKE("S-eye-origin", shade, eye_at_the_origin, "-p as direction to the eye",
            "this is the direction to the origin of the world; the eye is where the ray starts.",
            "highlights at wrong places, unless the eye is at the origin"),
    MISTAKE("S-t", shade, point_as_if_unit, "o + t v / |v|",
            "t counts in lengths of v, unchanged: o + t v.", "right only for rays of length 1"),
    MISTAKE("S-from-eye", shade, seen_from_the_eye, "visibility from the eye",
            "test visibility from the surface: does the light arrive there?",
            "no shadows, or all dark when the eye is in one"),
    MISTAKE("S-acne", shade, no_offset, "visibility from p itself",
            "rounding leaves p on either side of its surface, and from below the surface hides "
            "every light: off_surface.",
            "black speckles on all lit surfaces"),
    MISTAKE("S-outside", shade, offset_outward,
            "inside, the normal reversed for only one of the two",
            "the terms and off_surface both need the normal on the eye's side; if not, the surface "
            "hides its own light.",
            "hollow spheres dark inside"),
    MISTAKE("S-back", shade, offset_along_the_ray, "visibility from o + (1 - 1e-9) t v",
            "this step depends on the distance of the eye. The precision of the numbers depends on "
            "the sphere: off_surface.",
            "speckles on objects close to the eye; lost shadows far away"),
    MISTAKE("S-1e-3", shade, offset_1e_3, "visibility from p + 0.001 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles or lost shadows in others"),
    MISTAKE("S-1e-4", shade, offset_1e_4, "visibility from p + 1e-4 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles or lost shadows in others"),
    MISTAKE("S-1e-5", shade, offset_1e_5, "visibility from p + 1e-5 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles or lost shadows in others"),
    MISTAKE("S-1e-6", shade, offset_1e_6, "visibility from p + 1e-6 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles or lost shadows in others"),
    MISTAKE("S-1e-9", shade, offset_1e_9, "visibility from p + 1e-9 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles or lost shadows in others"),
    {0},
};
