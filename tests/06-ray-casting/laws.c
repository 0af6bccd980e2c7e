// laws.c - the laws of nearest_hit: the hit is on its sphere, and no sphere is in front of it.
#include "tests/06-ray-casting/laws.h"

#include "exercises/05-quadratic.h"
#include "tests/judge/law.h"

// The distance of the point at t from the surface, in radii: negative inside.
static double off_the_sphere(Ray ray, double t, Sphere sphere)
{
    vec3 point = ray.origin + t * ray.direction;
    return vec3_length(point - sphere.center) / sphere.radius - 1;
}

// Whether rounding may decide if the sphere is hit: the ray grazes it, or starts on it.
static bool is_doubtful(Ray ray, Sphere sphere)
{
    vec3 center = sphere.center - ray.origin;
    double foot = vec3_dot(center, ray.direction) / vec3_dot(ray.direction, ray.direction);
    return fabs(off_the_sphere(ray, foot, sphere)) < HIT_TOLERANCE ||
           fabs(off_the_sphere(ray, 0, sphere)) < HIT_TOLERANCE;
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

static bool nothing_is_before_it(Hit yours, Ray ray, const Scene *scene)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (!(t < yours.t - hit_rounding(ray, scene->spheres[i])) ||
            is_doubtful(ray, scene->spheres[i]))
            continue;
        law_broken("sphere %d is hit at t = %s, nearer than your %s", i, number_text(t).s,
                   hit_t_text(yours.t).s);
        return false;
    }
    return true;
}

static void of_equals_it_is_the_first(Hit yours, Ray ray, const Scene *scene)
{
    if (yours.sphere < 0)
        return;
    double t = hit_sphere(ray, scene->spheres[yours.sphere]);
    for (int i = 0; i < yours.sphere; i++)
        if (t < NO_HIT && hit_sphere(ray, scene->spheres[i]) == t) {
            law_broken("spheres %d and %d are both hit at t = %s: the lower index counts", i,
                       yours.sphere, number_text(t).s);
            return;
        }
}

void law_nearest_hit(Hit yours, Ray ray, const Scene *scene)
{
    if (both_or_none(yours, scene) && is_there(yours, ray, scene) &&
        nothing_is_before_it(yours, ray, scene))
        of_equals_it_is_the_first(yours, ray, scene);
}
