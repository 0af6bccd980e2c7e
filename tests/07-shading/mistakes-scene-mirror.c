// mistakes-scene-mirror.c - wrong answers to trace_ray: where a mirrored ray goes.
#include "tests/07-shading/mistakes-mirror.h"

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

const Mistake mirrored_mistakes[] = {
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
    {0},
};
