// mistakes-scene-lights.c - wrong answers to shade: what each light adds.
#include "tests/07-shading/mistakes-scene.h"
#include "tests/judge/wire.h"

// One light at a hit, and the arguments of its terms.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, to_light, to_eye;
    Color color; // of the light
    double visible;
    double kd, ks, shine;
} Lit;

static Color diffuse_of(Lit l)
{
    return diffuse_term(l.surface->color, l.kd, l.visible * l.color, l.normal, l.to_light);
}

static Color specular_of(Lit l)
{
    return phong_term(l.ks, l.shine, l.visible * l.color, l.normal, l.to_light, l.to_eye);
}

static Color both_of(Lit l)
{
    return diffuse_of(l) + specular_of(l);
}

static Lit shadowless(Lit l)
{
    l.visible = 1;
    return l;
}

typedef Color Give(Lit lit);

// One light too many: the guard of the answering process comes after the last one.
static Color shade_lights(bool too_many, Give *give, const Scene *scene, Ray ray, Hit hit)
{
    Sphere sphere = scene->spheres[hit.sphere];
    const Surface *s = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Color sum = ambient_term(s->color, s->diffuse, scene->ambient);
    int lights = scene->light_count + (too_many ? 1 : 0);
    for (int i = 0; i < lights; i++) {
        Light light = i < scene->light_count ? scene->lights[i] : GUARD_LIGHT;
        sum += give((Lit){.scene = scene,
                          .surface = s,
                          .point = point,
                          .normal = normal,
                          .to_light = ray_to_light(point, light).direction,
                          .to_eye = -ray.direction,
                          .color = light.color,
                          .visible = visibility(scene, off_surface(sphere, point, normal), light),
                          .kd = s->diffuse,
                          .ks = s->specular,
                          .shine = s->shine});
    }
    return sum;
}

static Color shade_with(Give *give, const Scene *scene, Ray ray, Hit hit)
{
    return shade_lights(false, give, scene, ray, hit);
}

static Color one_light_too_many(const Scene *scene, Ray ray, Hit hit)
{
    return shade_lights(true, both_of, scene, ray, hit);
}

// Each light adds something else than it should.
#define GIVES(name, ...)                                                                           \
    static Color give_##name(Lit l)                                                                \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
    }                                                                                              \
    static Color name(const Scene *scene, Ray ray, Hit hit)                                        \
    {                                                                                              \
        return shade_with(give_##name, scene, ray, hit);                                           \
    }

GIVES(no_diffuse, return specular_of(l))
GIVES(no_specular, return diffuse_of(l))
GIVES(no_shadows, return both_of(shadowless(l)))
GIVES(diffuse_without_shadow, return diffuse_of(shadowless(l)) + specular_of(l))
GIVES(specular_without_shadow, return diffuse_of(l) + specular_of(shadowless(l)))
GIVES(light_only_in_shadow, l.visible = 1 - l.visible; return both_of(l))
GIVES(light_of_white, l.color = vec3_of(1, 1, 1); return both_of(l))
GIVES(diffuse_of_white, Lit white = l; white.color = vec3_of(1, 1, 1);
      return diffuse_of(white) + specular_of(l))
GIVES(specular_of_white, Lit white = l; white.color = vec3_of(1, 1, 1);
      return diffuse_of(l) + specular_of(white))
GIVES(specular_in_the_color, return diffuse_of(l) + l.surface->color * specular_of(l))
GIVES(kd_and_ks_swapped, l.kd = l.surface->specular; l.ks = l.surface->diffuse; return both_of(l))
GIVES(without_kd, l.kd = 1; return both_of(l))
GIVES(without_ks, l.ks = 1; return both_of(l))
GIVES(shine_1, l.shine = 1; return both_of(l))
GIVES(shine_doubled, l.shine *= 2; return both_of(l))
GIVES(halfway, return diffuse_of(l) + halfway_term(l.ks, l.shine, l.visible *l.color, l.normal,
                                                   l.to_light, l.to_eye))
GIVES(weaker_with_the_square, return both_of(l) / vec3_dot(l.to_light, l.to_light))
GIVES(weaker_with_the_distance, return both_of(l) / vec3_length(l.to_light))
GIVES(eye_for_light, l.to_light = l.to_eye; return both_of(l))
GIVES(each_clamped, Color sum = both_of(l); for (int i = 0; i < 3; i++) sum[i] = fmin(1, sum[i]);
      return sum)
GIVES(as_if_all_distant, l.to_light += l.point; return both_of(l))

const Mistake shade_light_mistakes[] = {
    MISTAKE("L-diffuse", shade, no_diffuse, "no diffuse term",
            "each light that arrives adds both: the diffuse term and the highlight.",
            "highlights on dark spheres"),
    MISTAKE("L-count", shade, one_light_too_many, "a loop up to i <= light_count",
            "n lights have the numbers 0 to n - 1. There is no light number light_count: reading "
            "past the end of an array can give anything.",
            "a light that was never set, in any colour, or a crash"),
    MISTAKE("L-specular", shade, no_specular, "no specular term",
            "each light that arrives adds both: the diffuse term and the highlight.",
            "everything as dull as chalk"),
    MISTAKE("L-shadow", shade, no_shadows, "lights added whether they arrive or not",
            "call visibility first.", "no shadows"),
    MISTAKE("L-shadow-d", shade, diffuse_without_shadow,
            "diffuse added whether the light arrives or not",
            "without light nothing is scattered. visibility counts for both terms.",
            "no shadows, but highlights that end where shadows should start"),
    MISTAKE("L-shadow-s", shade, specular_without_shadow,
            "specular added whether the light arrives or not",
            "without light there is no highlight. visibility counts for both terms.",
            "highlights in the shadow"),
    MISTAKE("L-inverted", shade, light_only_in_shadow, "lights added only if they do not arrive",
            "visibility is 1 if the light arrives.", "light only where shadows should be"),
    MISTAKE("L-white", shade, light_of_white, "all lights white, with brightness 1",
            "each light has its own colour: how much red, green and blue it sends.",
            "coloured lights look white, weak ones as bright as others"),
    MISTAKE("L-white-d", shade, diffuse_of_white, "diffuse as if of a white light",
            "the diffuse term is the colour of the surface times that of the light.",
            "only highlights show the colour of the light"),
    MISTAKE("L-white-s", shade, specular_of_white, "highlights always white",
            "highlights have the colour of the light.", "white highlights in coloured light"),
    MISTAKE("L-metal", shade, specular_in_the_color, "specular times the surface's colour",
            "Phong's highlight has the colour of the light, whatever the surface's is.",
            "highlights as if of coloured metal"),
    MISTAKE("L-swapped", shade, kd_and_ks_swapped, "kd and ks swapped",
            "kd belongs to the diffuse term, ks to the highlight.",
            "shiny objects dull, dull objects shiny"),
    MISTAKE("L-kd", shade, without_kd, "diffuse without kd",
            "kd says how much of the light is scattered.", "everything too bright"),
    MISTAKE("L-ks", shade, without_ks, "specular without ks",
            "ks says how much of the light is reflected as by a mirror: chalk reflects nothing.",
            "highlights on everything, even on chalk"),
    MISTAKE("L-shine", shade, shine_1, "a shine of 1",
            "each surface has its own shine, the power of the cosine.",
            "broad, blurred highlights"),
    MISTAKE("L-shine2", shade, shine_doubled, "twice the shine",
            "the power of the cosine is shine itself.", "highlights too small"),
    MISTAKE("L-halfway", shade, halfway, "Blinn's highlight",
            "this function needs Phong's: phong_term.", "highlights too broad"),
    MISTAKE("L-square", shade, weaker_with_the_square, "light divided by the distance squared",
            "it is so in reality; here a light has the same brightness at any distance.",
            "dark, except right beside the lamps"),
    MISTAKE("L-root", shade, weaker_with_the_distance, "light divided by the distance",
            "here a light has the same brightness at any distance.",
            "dark, except right beside the lamps"),
    MISTAKE("L-eye", shade, eye_for_light,
            "the direction to the eye instead of the direction to the light",
            "the ray comes from the eye; the light is elsewhere.",
            "as if there were a lamp at the eye"),
    MISTAKE("L-clamp", shade, each_clamped, "each light at most 1",
            "colours are clamped only at the very end, by clamp_color.",
            "no visible difference, except for bright lights in mirrors"),
    MISTAKE("L-distant", shade, as_if_all_distant, "l as direction to a light, not l - p",
            "only a distant light is a direction; the vector to a point light is l - p. "
            "ray_to_light does this.",
            "light as if of the sun, from a wrong direction"),
    {0},
};
