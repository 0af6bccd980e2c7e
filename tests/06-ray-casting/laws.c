// laws.c - the laws of exercise 06: a hit is on its sphere, and no sphere is in front of it.
#include "exercises/06-ray-casting.h"

#include "common/text.h"
#include "tests/judge/law.h"

// How far a hit may be off, in radii along the ray (exercises/05-quadratic.h).
#define HIT_TOLERANCE 1e-6

// The distance of the point at t from the surface, in radii: negative inside.
static double off_the_sphere(Ray ray, double t, Sphere sphere)
{
    vec3 point = ray.origin + t * ray.direction;
    return vec3_length(point - sphere.center) / sphere.radius - 1;
}

static bool both_or_none(Hit yours, const Scene *scene)
{
    int count = scene->sphere_count;
    if (yours.sphere < -1 || yours.sphere >= count)
        law_broken("your sphere is number %d, but the scene has %d, counted from 0", yours.sphere,
                   count);
    else if (yours.sphere == -1 && yours.t != NO_HIT)
        law_broken("your sphere is -1, no sphere, but your t is %s; without a hit t is NO_HIT",
                   number_text(yours.t).s);
    else if (yours.sphere >= 0 && yours.t == NO_HIT)
        law_broken("your sphere is number %d, but your t is NO_HIT: set either both or neither",
                   yours.sphere);
    else
        return true;
    return false;
}

static bool is_there(Hit yours, Ray ray, const Scene *scene)
{
    if (yours.sphere < 0)
        return true;
    double off = off_the_sphere(ray, yours.t, scene->spheres[yours.sphere]);
    if (yours.t > 0 && fabs(off) <= HIT_TOLERANCE)
        return true;
    double radius = scene->spheres[yours.sphere].radius;
    if (!(yours.t > 0))
        law_broken("your t is %s: a hit is in front of the eye, t > 0", number_text(yours.t).s);
    else
        law_broken("your t is %s on sphere %d, but that point is %s from its centre, and its "
                   "radius is %s",
                   number_text(yours.t).s, yours.sphere, number_text((off + 1) * radius).s,
                   number_text(radius).s);
    return false;
}

// The right hit is: nearer by more than rounding, or as near and of a lower index.
static void something_is_before_it(Hit yours, Hit right, Ray ray, const Scene *scene)
{
    if (right.sphere < 0)
        return;
    double rounding =
        HIT_TOLERANCE * scene->spheres[right.sphere].radius / vec3_length(ray.direction);
    if (right.t < yours.t - rounding)
        law_broken("sphere %d is hit at t = %s, nearer than your %s", right.sphere,
                   number_text(right.t).s, yours.t == NO_HIT ? "NO_HIT" : number_text(yours.t).s);
    else if (right.t == yours.t && right.sphere < yours.sphere)
        law_broken("spheres %d and %d are both hit at t = %s: the lower index counts", right.sphere,
                   yours.sphere, number_text(right.t).s);
}

LAW(nearest_hit)
{
    if (both_or_none(yours, scene) && is_there(yours, ray, scene))
        something_is_before_it(yours, right, ray, scene);
}
