// mistakes-scene-lights.c - wrong answers to shade: what each light gives.
#include "tests/07-shading/mistakes-scene.h"
#include "tests/judge/wire.h"

// One light at a hit, and all that its terms are made of.
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

// One light too many: what is past the last one is the answering process's guard.
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

// Each light gives something else than it should.
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
            "each light that arrives gives both: what is scattered, and the highlight.",
            "highlights on dark spheres"),
    MISTAKE(
        "L-count", shade, one_light_too_many, "a loop up to i <= light_count",
        "n lights are number 0 to n - 1. There is no light number light_count: what is past the "
        "end of an array could be anything.",
        "a light that nobody has set, in any colour, or a crash"),
    MISTAKE("L-specular", shade, no_specular, "no specular term",
            "each light that arrives gives both: what is scattered, and the highlight.",
            "everything as dull as chalk"),
    MISTAKE("L-shadow", shade, no_shadows, "lights whether they arrive or not",
            "ask visibility first.", "no shadows"),
    MISTAKE("L-shadow-d", shade, diffuse_without_shadow, "diffuse whether the light arrives or not",
            "without light nothing is scattered. visibility is for both terms.",
            "no shadows, but highlights that end where shadows should begin"),
    MISTAKE("L-shadow-s", shade, specular_without_shadow,
            "specular whether the light arrives or not",
            "without light there is no highlight. visibility is for both terms.",
            "highlights in the shadow"),
    MISTAKE("L-inverted", shade, light_only_in_shadow, "lights that do not arrive",
            "visibility is 1 where the light arrives.", "light only where shadows should be"),
    MISTAKE("L-white", shade, light_of_white, "all lights white and 1 bright",
            "each light has a colour of its own: how much of red, green and blue it sends.",
            "coloured lights look white, weak ones as bright as others"),
    MISTAKE("L-white-d", shade, diffuse_of_white, "diffuse as if of a white light",
            "what is scattered is the colour of the surface times that of the light.",
            "only highlights show the colour of the light"),
    MISTAKE("L-white-s", shade, specular_of_white, "highlights always white",
            "they have the colour of the light.", "white highlights in coloured light"),
    MISTAKE("L-metal", shade, specular_in_the_color, "specular times the surface's colour",
            "Phong's highlight has the colour of the light, whatever the surface's is.",
            "highlights as of coloured metal"),
    MISTAKE("L-swapped", shade, kd_and_ks_swapped, "kd and ks exchanged",
            "kd is what is scattered, ks what is thrown like a mirror.",
            "shiny things dull, dull things shiny"),
    MISTAKE("L-kd", shade, without_kd, "diffuse without kd",
            "kd says how much of the light is scattered.", "too bright, all alike"),
    MISTAKE("L-ks", shade, without_ks, "specular without ks",
            "ks says how much of the light is thrown back like by a mirror: of chalk nothing.",
            "highlights on everything, chalk too"),
    MISTAKE("L-shine", shade, shine_1, "a shine of 1",
            "each surface has a shine of its own, the power of the cosine.",
            "broad, blurred highlights"),
    MISTAKE("L-shine2", shade, shine_doubled, "twice the shine",
            "the power of the cosine is shine itself.", "highlights too small"),
    MISTAKE("L-halfway", shade, halfway, "Blinn's highlight",
            "here Phong's is asked for: phong_term.", "highlights broader than asked for"),
    MISTAKE("L-square", shade, weaker_with_the_square, "light divided by the distance squared",
            "so it is in the world; here lights are as bright as they say, however far.",
            "dark, but right beside the lamps"),
    MISTAKE("L-root", shade, weaker_with_the_distance, "light divided by the distance",
            "here lights are as bright as they say, however far.",
            "dark, but right beside the lamps"),
    MISTAKE("L-eye", shade, eye_for_light, "the way to the eye for the way to the light",
            "the eye is where the ray comes from; the light is elsewhere.",
            "as if there were a lamp at the eye"),
    MISTAKE("L-clamp", shade, each_clamped, "each light at most 1",
            "what is too bright is cut off at the very end, by clamp_color.",
            "all right, but for bright lights in mirrors"),
    MISTAKE("L-distant", shade, as_if_all_distant, "l as way to a light, not l - p",
            "only a distant light has a direction; the way to a point light is l - p. And that is "
            "what ray_to_light is for.",
            "light as of the sun, from somewhere beside the lamp"),
    {0},
};
