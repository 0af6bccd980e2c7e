// 07-shading-scene-mirror.c - wrong answers to trace_ray: what a mirror shows.
#include "tests/mistakes/07-shading-scene.h"

// A mirrored ray, and what becomes of what it sees. What is not named is right.
typedef struct {
    Start *start;
    vec3 (*direction)(vec3 direction, vec3 normal);
    double (*share)(const Surface *surface);
    Color (*sum)(Color own, double share, Color seen, const Surface *surface);
    Color (*own)(const Scene *scene, Ray ray, Hit hit);
    Color (*nothing)(const Scene *scene, bool mirrored);
    bool own_sphere_left_out;
} Slips;

static double specular_of(const Surface *surface)
{
    return surface->specular;
}

static vec3 right_start(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)ray, (void)t;
    return off_surface(sphere, point, normal);
}

static Color plus_share(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return own + share * seen;
}

static Color background_of(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->background;
}

static Hit hit_of(const Slips *slips, const Scene *scene, Ray ray, int own)
{
    Hit best = {NO_HIT, -1};
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t < best.t && !(slips->own_sphere_left_out && i == own))
            best = (Hit){t, i};
    }
    return best;
}

static Color trace_with(const Slips *slips, const Scene *scene, Ray ray, int depth, int own)
{
    Hit hit = hit_of(slips, scene, ray, own);
    if (hit.sphere < 0)
        return (slips->nothing != NULL ? slips->nothing : background_of)(scene, own >= 0);
    const Surface *surface = scene_surface(scene, hit.sphere);
    double share = (slips->share != NULL ? slips->share : specular_of)(surface);
    Color color = (slips->own != NULL ? slips->own : shade)(scene, ray, hit);
    if (depth <= 0 || share == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {
        (slips->start != NULL ? slips->start : right_start)(sphere, point, normal, ray, hit.t),
        (slips->direction != NULL ? slips->direction : mirror_direction)(ray.direction, normal)};
    Color seen = trace_with(slips, scene, mirrored, depth - 1, hit.sphere);
    return (slips->sum != NULL ? slips->sum : plus_share)(color, share, seen, surface);
}

#define MIRROR(name, ...)                                                                          \
    static Color name(const Scene *scene, Ray ray, int depth)                                      \
    {                                                                                              \
        return trace_with(&(Slips){__VA_ARGS__}, scene, ray, depth, -1);                           \
    }

// ---- where to -----------------------------------------------------------------------------------

static vec3 straight_on(vec3 direction, vec3 normal)
{
    (void)normal;
    return direction;
}

static vec3 back(vec3 direction, vec3 normal)
{
    (void)normal;
    return -direction;
}

static vec3 along_the_normal(vec3 direction, vec3 normal)
{
    (void)direction;
    return normal;
}

static vec3 without_the_2(vec3 direction, vec3 normal)
{
    return direction - vec3_dot(direction, normal) * normal;
}

static vec3 start_at_the_eye(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)sphere, (void)point, (void)normal, (void)t;
    return ray.origin;
}

static vec3 start_at_the_centre(Sphere sphere, vec3 point, vec3 normal, Ray ray, double t)
{
    (void)point, (void)normal, (void)ray, (void)t;
    return sphere.center;
}

MIRROR(not_mirrored, .direction = straight_on)
MIRROR(sent_back, .direction = back)
MIRROR(normal_for_direction, .direction = along_the_normal)
MIRROR(once_the_normal, .direction = without_the_2)
MIRROR(from_the_eye, .start = start_at_the_eye)
MIRROR(from_the_centre, .start = start_at_the_centre)
MIRROR(no_offset, .start = start_there)
MIRROR(offset_inward, .start = start_inward)
MIRROR(offset_outward, .start = start_outward)
MIRROR(offset_along_the_ray, .start = start_back_along_the_ray)
MIRROR(offset_1e_3, .start = start_a_thousandth_off)
MIRROR(offset_1e_6, .start = start_a_millionth_off)
MIRROR(offset_1e_9, .start = start_a_billionth_off)
MIRROR(not_itself, .own_sphere_left_out = true)

// ---- how much, and of what ----------------------------------------------------------------------

static double all_of_it(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1;
}

static double diffuse_of(const Surface *surface)
{
    return surface->specular == 0 ? 0 : surface->diffuse;
}

static double what_is_not_diffuse(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1 - surface->diffuse;
}

static double squared(const Surface *surface)
{
    return surface->specular * surface->specular;
}

static Color blended(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return (1 - share) * own + share * seen;
}

static Color in_the_color(Color own, double share, Color seen, const Surface *surface)
{
    return own + share * surface->color * seen;
}

static Color only_what_is_seen(Color own, double share, Color seen, const Surface *surface)
{
    (void)own, (void)surface;
    return share * seen;
}

static Color of_both(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return share * (own + seen);
}

static Color multiplied(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return own * seen;
}

static Color mean(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return (own + seen) / 2;
}

static Color clamped(Color own, double share, Color seen, const Surface *surface)
{
    Color sum = plus_share(own, share, seen, surface);
    for (int i = 0; i < 3; i++)
        sum[i] = fmin(1, sum[i]);
    return sum;
}

static Color seen_clamped(Color own, double share, Color seen, const Surface *surface)
{
    for (int i = 0; i < 3; i++)
        seen[i] = fmin(1, seen[i]);
    return plus_share(own, share, seen, surface);
}

static Color black_in_mirrors(const Scene *scene, bool mirrored)
{
    return mirrored ? vec3_of(0, 0, 0) : scene->background;
}

static Color always_black(const Scene *scene, bool mirrored)
{
    (void)scene, (void)mirrored;
    return vec3_of(0, 0, 0);
}

static Color ambient_of_the_scene(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->ambient;
}

static Color flat(const Scene *scene, Ray ray, Hit hit)
{
    (void)ray;
    return scene_surface(scene, hit.sphere)->color;
}

static Color ambient_only(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    (void)ray;
    return ambient_term(surface->color, surface->diffuse, scene->ambient);
}

static Color without_highlight(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    Color sum = ambient_only(scene, ray, hit);
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        sum += diffuse_term(surface->color, surface->diffuse, color, normal,
                            ray_to_light(point, light).direction);
    }
    return sum;
}

MIRROR(without_ks, .share = all_of_it)
MIRROR(kd_for_ks, .share = diffuse_of)
MIRROR(rest_of_kd, .share = what_is_not_diffuse)
MIRROR(ks_squared, .share = squared)
MIRROR(blended_with_ks, .sum = blended)
MIRROR(in_the_surface_color, .sum = in_the_color)
MIRROR(own_color_lost, .sum = only_what_is_seen)
MIRROR(own_color_times_ks, .sum = of_both)
MIRROR(colors_multiplied, .sum = multiplied)
MIRROR(mean_of_both, .sum = mean)
MIRROR(sum_clamped, .sum = clamped)
MIRROR(mirror_clamped, .sum = seen_clamped)
MIRROR(no_background_in_mirrors, .nothing = black_in_mirrors)
MIRROR(no_background, .nothing = always_black)
MIRROR(ambient_for_background, .nothing = ambient_of_the_scene)
MIRROR(flat_colors, .own = flat)
MIRROR(no_lights, .own = ambient_only)
MIRROR(no_highlights, .own = without_highlight)

const Mistake mirror_mistakes[] = {
    MISTAKE("T-into", trace_ray, not_mirrored,
            "a direction into the surface: v, v + 2 (v.n) n or -(v - 2 (v.n) n)",
            "a mirror sends the ray away from its surface, at the same angle: mirror_direction. "
            "This one meets the same place again.",
            "shiny things too bright, and nothing in them but themselves"),
    MISTAKE("T-back", trace_ray, sent_back, "the ray goes back where it came from",
            "only straight ahead. Else the angle out is the angle in, on the other side of the "
            "normal: mirror_direction.",
            "every mirror shows what is behind the eye"),
    MISTAKE("T-normal", trace_ray, normal_for_direction, "along the normal",
            "the angle out is the angle in: mirror_direction.",
            "mirrors show the same from wherever one looks"),
    MISTAKE("T-once", trace_ray, once_the_normal, "v - (v.n) n",
            "that is the way along the surface. Twice as much mirrors it: mirror_direction.",
            "mirrors show what lies beside them"),
    MISTAKE("T-eye", trace_ray, from_the_eye, "the mirrored ray from the eye",
            "it begins where the mirror was hit.", "mirrors show what lies beside the eye"),
    MISTAKE("T-centre", trace_ray, from_the_centre, "the mirrored ray from the centre",
            "it begins where the mirror was hit.", "every ball shows its own inside"),
    MISTAKE("T-acne", trace_ray, no_offset, "the mirrored ray from the surface itself",
            "rounding leaves the point on either side of it, and from below the ray meets the "
            "surface that it starts from: off_surface.",
            "speckles in mirrors"),
    MISTAKE("T-below", trace_ray, offset_inward, "the mirrored ray from below the surface",
            "off_surface moves to the side of the normal, and that has to be the eye's.",
            "every ball shows its own inside"),
    MISTAKE("T-outside", trace_ray, offset_outward, "the mirrored ray from outside, inside too",
            "from inside it has to stay inside: give off_surface the normal that is turned to "
            "the eye.",
            "hollow mirrors show what is outside"),
    MISTAKE("T-along", trace_ray, offset_along_the_ray, "the mirrored ray from o + (1 - 1e-9) t v",
            "that depends on how far the eye is. How coarse the numbers are depends on the sphere: "
            "off_surface.",
            "speckles in mirrors that are close to the eye or far from the origin"),
    MISTAKE("T-1e-3", trace_ray, offset_1e_3, "the mirrored ray from p + 0.001 n",
            "that is too far in a small scene and nothing in a huge one: off_surface.",
            "all right in a scene of one size, speckles in others"),
    MISTAKE("T-1e-6", trace_ray, offset_1e_6, "the mirrored ray from p + 1e-6 n",
            "that is too far in a small scene and nothing in a huge one: off_surface.",
            "all right in a scene of one size, speckles in others"),
    MISTAKE("T-1e-9", trace_ray, offset_1e_9, "the mirrored ray from p + 1e-9 n",
            "that is too far in a small scene and nothing in a huge one: off_surface.",
            "all right in a scene of one size, speckles in others"),
    MISTAKE("T-itself", trace_ray, not_itself, "a mirrored ray that cannot meet its own sphere",
            "from outside it does not, but inside a hollow ball it meets the other side.",
            "hollow mirrors without mirror images"),
    MISTAKE("T-ks", trace_ray, without_ks, "all of what the mirror shows",
            "specular says how much of it comes back.", "every shiny thing a perfect mirror"),
    MISTAKE("T-kd", trace_ray, kd_for_ks, "kd times what the mirror shows",
            "kd is what is scattered; what is mirrored is ks.",
            "bright things mirror, whether shiny or not"),
    MISTAKE("T-rest", trace_ray, rest_of_kd, "1 - kd times what the mirror shows",
            "kd and ks need not make 1: the surface says its ks.",
            "mirrors too strong or too weak"),
    MISTAKE("T-square", trace_ray, ks_squared, "ks times ks of what the mirror shows",
            "each mirror takes its ks once.", "mirrors too weak"),
    MISTAKE("T-blend", trace_ray, blended_with_ks, "(1 - ks) times shade + ks times the mirror",
            "kd and ks say already how much there is of each; what shade says stays whole.",
            "shiny things too dark"),
    MISTAKE("T-color", trace_ray, in_the_surface_color, "the mirror in the surface's colour",
            "here mirrors are like highlights: as white as what they show.",
            "mirrors as of coloured metal"),
    MISTAKE("T-only", trace_ray, own_color_lost, "ks times the mirror, without shade",
            "the surface still sends back what lights give it: add that.",
            "shiny things without a colour of their own"),
    MISTAKE("T-both", trace_ray, own_color_times_ks, "ks times (shade + the mirror)",
            "what shade says has its kd and ks already; only the mirror is multiplied.",
            "shiny things too dark"),
    MISTAKE("T-times", trace_ray, colors_multiplied, "shade times the mirror", "light adds up.",
            "shiny things too dark"),
    MISTAKE("T-mean", trace_ray, mean_of_both, "the mean of shade and the mirror",
            "specular says how much of the mirror comes on top.", "all mirrors alike"),
    MISTAKE("T-clamp", trace_ray, sum_clamped, "the sum, at most 1",
            "what is too bright is cut off at the very end, by clamp_color; in the next mirror it "
            "may be just right.",
            "dull highlights in mirrors"),
    MISTAKE("T-clamp-seen", trace_ray, mirror_clamped, "what the mirror shows, at most 1",
            "what is too bright is cut off at the very end, by clamp_color; in a mirror it may be "
            "just right.",
            "dull highlights in mirrors"),
    MISTAKE("T-black", trace_ray, no_background_in_mirrors, "black for the background in mirrors",
            "a mirrored ray that hits nothing sees the background, like any other.",
            "mirrors too dark where they show the sky"),
    MISTAKE("T-night", trace_ray, no_background, "black where nothing is hit",
            "the scene says what its background is.", "everything on black"),
    MISTAKE("T-ambient-sky", trace_ray, ambient_for_background,
            "the ambient light where nothing is hit",
            "the scene has both, and they differ: the background is asked for.",
            "a background that is grey"),
    MISTAKE("T-flat", trace_ray, flat_colors, "flat colours", "what is hit is lit: shade.",
            "flat spheres with mirror images"),
    MISTAKE("T-ambient", trace_ray, no_lights, "ambient light only",
            "what is hit is lit by every light that arrives: shade.",
            "dark spheres with mirror images"),
    MISTAKE("T-highlight", trace_ray, no_highlights, "shade without highlights",
            "the highlight is the mirror image of the lamp, which no ray meets. It stays.",
            "mirrors without highlights"),
    {0},
};
