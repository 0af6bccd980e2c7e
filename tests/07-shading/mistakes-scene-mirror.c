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
            "This one hits the same place again.",
            "shiny objects too bright, with nothing in them but themselves"),
    MISTAKE("T-back", trace_ray, sent_back, "the ray goes back to where it came from",
            "that is right only straight ahead. In general the ray leaves at the same angle, on "
            "the other side of the normal: mirror_direction.",
            "every mirror shows the scene behind the eye"),
    MISTAKE("T-normal", trace_ray, normal_for_direction, "along the normal",
            "the ray leaves at the same angle as it arrives: mirror_direction.",
            "mirrors show the same from everywhere"),
    MISTAKE("T-once", trace_ray, once_the_normal, "v - (v.n) n",
            "this runs along the surface. Subtract twice as much: mirror_direction.",
            "mirrors show the scene beside them"),
    MISTAKE("T-eye", trace_ray, from_the_eye, "the mirrored ray from the eye",
            "it starts at the point of the hit.", "mirrors show the scene beside the eye"),
    MISTAKE("T-centre", trace_ray, from_the_centre, "the mirrored ray from the centre",
            "it starts at the point of the hit.", "every ball shows its own inside"),
    MISTAKE("T-acne", trace_ray, no_offset, "the mirrored ray from the surface itself",
            "rounding leaves the point on either side of the surface, and from below the ray hits "
            "the surface that it starts from: off_surface.",
            "speckles in mirrors"),
    MISTAKE("T-below", trace_ray, offset_inward, "the mirrored ray from below the surface",
            "off_surface moves to the side of the normal: give it the normal on the eye's side.",
            "every ball shows its own inside"),
    MISTAKE("T-outside", trace_ray, offset_outward,
            "the mirrored ray from outside, even from inside a sphere",
            "from inside it must stay inside: give off_surface the normal on the eye's side.",
            "hollow mirrors show the scene outside"),
    MISTAKE("T-along", trace_ray, offset_along_the_ray, "the mirrored ray from o + (1 - 1e-9) t v",
            "this step depends on the distance of the eye. The precision of the numbers depends on "
            "the sphere: off_surface.",
            "speckles in mirrors that are close to the eye or far from the origin"),
    MISTAKE("T-1e-3", trace_ray, offset_1e_3, "the mirrored ray from p + 0.001 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles in others"),
    MISTAKE("T-1e-6", trace_ray, offset_1e_6, "the mirrored ray from p + 1e-6 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles in others"),
    MISTAKE("T-1e-9", trace_ray, offset_1e_9, "the mirrored ray from p + 1e-9 n",
            "this is too far in a small scene and nothing in a huge one: off_surface.",
            "right in scenes of one size, speckles in others"),
    MISTAKE("T-itself", trace_ray, not_itself, "a mirrored ray that cannot hit its own sphere",
            "from outside it does not, but inside a hollow ball it hits the other side.",
            "hollow mirrors without mirror images"),
    {0},
};
