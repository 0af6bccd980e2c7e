// support-exact.c - light and mirrors in long double, by geometry and without an offset.
//
// A ray that leaves a sphere outwards never meets it again; one that leaves it inwards meets it at
// the end of a chord. So no ray must be moved off the surface that it starts from.
#include "tests/07-shading/support-scene.h"

// Anything nearer to an edge than this, in radii or in lengths of the ray, is left undecided.
#define DOUBT 2e-3L

typedef long double Exact;

typedef struct {
    Exact x, y, z;
} Vector;

typedef struct {
    Vector from, along;
    int own;     // the sphere on whose surface it starts; -1: none
    bool inside; // of that sphere
} Way;

typedef struct {
    const Scene *scene;
    bool doubtful;
} Look;

static Vector exact(vec3 v)
{
    return (Vector){v[0], v[1], v[2]};
}

static Vector plus(Vector v, Exact t, Vector w)
{
    return (Vector){v.x + t * w.x, v.y + t * w.y, v.z + t * w.z};
}

static Exact dot(Vector v, Vector w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static Vector unit(Vector v)
{
    return plus((Vector){0, 0, 0}, 1 / sqrtl(dot(v, v)), v);
}

// The first t > 0 at which the ray meets sphere i, from the foot of the perpendicular; -1 if none.
static Exact first_meeting(Look *look, Way way, int i)
{
    const Sphere *sphere = &look->scene->spheres[i];
    Exact a = dot(way.along, way.along), r = sphere->radius;
    Vector from_center = plus(way.from, -1, exact(sphere->center));
    Exact foot = -dot(from_center, way.along) / a;
    if (i == way.own) { // half the chord is as long as the way to the foot
        look->doubtful = look->doubtful || fabsl(foot * sqrtl(a)) < DOUBT * r;
        return !way.inside ? (foot > 0 ? 0 : -1) : foot > 0 ? 2 * foot : 0;
    }
    Vector closest = plus(from_center, foot, way.along);
    Exact aside = sqrtl(dot(closest, closest));
    look->doubtful = look->doubtful || fabsl(aside - r) < DOUBT * r;
    if (aside >= r)
        return -1;
    Exact half = sqrtl((r - aside) * (r + aside) / a), near = foot - half, far = foot + half;
    Exact least = DOUBT * r / sqrtl(a);
    look->doubtful = look->doubtful || fabsl(near) < least || fabsl(far) < least;
    return near > 0 ? near : far > 0 ? far : -1;
}

static bool arrives(Look *look, Way way, const Light *light)
{
    way.along = light->kind == LIGHT_DISTANT ? exact(light->position)
                                             : plus(exact(light->position), -1, way.from);
    bool free = true;
    for (int i = 0; i < look->scene->sphere_count; i++) {
        Exact t = first_meeting(look, way, i);
        if (light->kind == LIGHT_POINT)
            look->doubtful = look->doubtful || fabsl(t - 1) < DOUBT;
        free = free && (t < 0 || (light->kind == LIGHT_POINT && t > 1));
    }
    return free;
}

static int nearest(Look *look, Way way, Exact *t)
{
    int found = -1;
    *t = -1;
    for (int i = 0; i < look->scene->sphere_count; i++) {
        Exact here = first_meeting(look, way, i);
        if (here < 0)
            continue;
        look->doubtful = look->doubtful || (found >= 0 && fabsl(here - *t) < DOUBT * *t);
        if (found < 0 || here < *t) {
            found = i;
            *t = here;
        }
    }
    return found;
}

// The end of a ray, seen from its start.
typedef struct {
    Way back;      // from there, towards where it came from
    Vector normal; // on that side
    const Surface *surface;
} Place;

static Place place_at(const Look *look, Way way, Exact t, int i)
{
    Vector point = plus(way.from, t, way.along);
    Vector normal = unit(plus(point, -1, exact(look->scene->spheres[i].center)));
    bool inside = dot(normal, way.along) > 0;
    Vector back = plus((Vector){0, 0, 0}, -1, way.along);
    return (Place){.back = {point, back, i, inside},
                   .normal = plus((Vector){0, 0, 0}, inside ? -1 : 1, normal),
                   .surface = scene_surface(look->scene, i)};
}

// The cosine between the mirrored light and the eye is 2 (n.l)(n.e) - l.e.
static void add_light(Look *look, const Place *place, const Light *light, Exact sum[3])
{
    const Surface *surface = place->surface;
    Vector l = light->kind == LIGHT_DISTANT
                   ? unit(exact(light->position))
                   : unit(plus(exact(light->position), -1, place->back.from));
    Vector e = unit(place->back.along);
    Exact cosine = dot(place->normal, l);
    if (!arrives(look, place->back, light) || cosine <= 0)
        return;
    Exact mirrored = 2 * cosine * dot(place->normal, e) - dot(l, e);
    Exact highlight = mirrored > 0 ? surface->specular * powl(mirrored, surface->shine) : 0;
    for (int i = 0; i < 3; i++)
        sum[i] += (surface->diffuse * cosine * surface->color[i] + highlight) * light->color[i];
}

static void add_shade(Look *look, const Place *place, Exact sum[3])
{
    for (int i = 0; i < 3; i++)
        sum[i] +=
            (Exact)place->surface->diffuse * place->surface->color[i] * look->scene->ambient[i];
    for (int i = 0; i < look->scene->light_count; i++)
        add_light(look, place, &look->scene->lights[i], sum);
}

// A loop: the share of the next colour that comes through all the mirrors so far.
static void add_trace(Look *look, Way way, int depth, Exact sum[3])
{
    Exact share = 1;
    for (;; depth--) {
        Exact t, here[3] = {0};
        int sphere = nearest(look, way, &t);
        for (int i = 0; sphere < 0 && i < 3; i++)
            sum[i] += share * look->scene->background[i];
        if (sphere < 0)
            return;
        Place place = place_at(look, way, t, sphere);
        add_shade(look, &place, here);
        for (int i = 0; i < 3; i++)
            sum[i] += share * here[i];
        share *= place.surface->specular;
        if (depth == 0 || place.surface->specular == 0)
            return;
        way = place.back;
        way.along = plus(plus((Vector){0, 0, 0}, -1, place.back.along),
                         2 * dot(place.back.along, place.normal), place.normal);
    }
}

// ---- as the answers compute it -----------------------------------------------------------------

static Way way_of(Ray ray)
{
    return (Way){exact(ray.origin), exact(ray.direction), -1, false};
}

static Color color_of(const Exact sum[3])
{
    return vec3_of((double)sum[0], (double)sum[1], (double)sum[2]);
}

bool exact_visibility(const World *world, vec3 from, Light light, double *visibility)
{
    Look look = {&world->scene, false};
    *visibility = arrives(&look, way_of((Ray){from, from}), &light);
    return !look.doubtful;
}

bool exact_hit(const World *world, Ray ray, Hit *hit)
{
    Look look = {&world->scene, false};
    Exact t;
    int sphere = nearest(&look, way_of(ray), &t);
    *hit = sphere < 0 ? (Hit){NO_HIT, -1} : (Hit){(double)t, sphere};
    return !look.doubtful;
}

bool exact_shade(const World *world, Ray ray, Color *color)
{
    Look look = {&world->scene, false};
    Exact t, sum[3] = {0};
    int sphere = nearest(&look, way_of(ray), &t);
    if (sphere < 0)
        return false;
    Place place = place_at(&look, way_of(ray), t, sphere);
    add_shade(&look, &place, sum);
    *color = color_of(sum);
    return !look.doubtful;
}

bool exact_trace(const World *world, Ray ray, int depth, Color *color)
{
    Look look = {&world->scene, false};
    Exact sum[3] = {0};
    add_trace(&look, way_of(ray), depth, sum);
    *color = color_of(sum);
    return !look.doubtful;
}
