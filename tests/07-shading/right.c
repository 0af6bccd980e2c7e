// right.c - right answers to exercise 07, written in other ways.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include "tests/judge/known.h"

static const Color black = {0, 0, 0};

// ---- directions ---------------------------------------------------------------------------------

RIGHT_LINE(surface_normal, "divided by the radius", return (point - sphere.center) / sphere.radius)

RIGHT(surface_normal, "long double")
{
    long double x = point[0] - sphere.center[0], y = point[1] - sphere.center[1];
    long double z = point[2] - sphere.center[2], length = sqrtl(x * x + y * y + z * z);
    return vec3_of((double)(x / length), (double)(y / length), (double)(z / length));
}

RIGHT(mirror_direction, "the parts along and across the normal")
{
    vec3 along = vec3_dot(direction, normal) * normal, across = direction - along;
    return across - along;
}

RIGHT(mirror_direction, "a unit direction, with its length restored")
{
    double length = vec3_length(direction);
    vec3 unit = direction / length;
    return length * (unit - normal * 2 * vec3_dot(normal, unit));
}

RIGHT(mirror_direction, "Householder's matrix")
{
    vec3 mirrored = direction;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            mirrored[i] -= 2 * normal[i] * normal[k] * direction[k];
    return mirrored;
}

RIGHT(mirror_direction, "half a turn around the normal, and reversed")
{
    vec3 across = vec3_cross(vec3_cross(normal, direction), normal);
    vec3 turned = vec3_dot(direction, normal) * normal - across;
    return -turned;
}

RIGHT(mirror_direction, "a frame on the mirror")
{
    int axis = fabs(normal[0]) < 0.6 ? 0 : fabs(normal[1]) < 0.6 ? 1 : 2;
    vec3 other = {0};
    other[axis] = 1;
    vec3 u = vec3_unit(vec3_cross(normal, other)), w = vec3_cross(normal, u);
    return vec3_dot(direction, u) * u + vec3_dot(direction, w) * w -
           vec3_dot(direction, normal) * normal;
}

// ---- terms --------------------------------------------------------------------------------------

RIGHT(ambient_term, "the light times kd first")
{
    Color arrives = ambient * kd;
    return arrives * surface;
}

RIGHT(ambient_term, "component by component")
{
    Color color = {0};
    for (int i = 0; i < 3; i++)
        color[i] = surface[i] * ambient[i] * kd;
    return color;
}

RIGHT(diffuse_term, "n.l / |l|, component by component")
{
    double cosine = vec3_dot(normal, to_light) / vec3_length(to_light);
    if (cosine <= 0)
        return black;
    double share = kd * cosine;
    return vec3_of(share * surface[0] * light[0], share * surface[1] * light[1],
                   share * surface[2] * light[2]);
}

RIGHT(diffuse_term, "the angle, with atan2")
{
    double aside = vec3_length(vec3_cross(normal, to_light)), up = vec3_dot(normal, to_light);
    return up > 0 ? cos(atan2(aside, up)) * kd * surface * light : black;
}

RIGHT(diffuse_term, "(c + |c|) / 2")
{
    double cosine = vec3_dot(normal, vec3_unit(to_light));
    return kd * (cosine + fabs(cosine)) / 2 * (light * surface);
}

RIGHT(diffuse_term, "the normal normalised as well")
{
    double cosine = vec3_dot(vec3_unit(to_light), vec3_unit(normal));
    return ambient_term(surface, kd, light) * (cosine > 0 ? cosine : 0);
}

// ---- highlights ---------------------------------------------------------------------------------

RIGHT(phong_term, "normalised first, then mirrored")
{
    vec3 mirrored = mirror_direction(-vec3_unit(to_light), normal);
    double cosine = vec3_dot(mirrored, to_eye) / sqrt(vec3_dot(to_eye, to_eye));
    Color color = black;
    if (cosine > 0)
        if (vec3_dot(to_light, normal) > 0)
            color += pow(cosine, shine) * (ks * light);
    return color;
}

RIGHT(phong_term, "half a turn around the normal")
{
    vec3 across = to_light - vec3_dot(to_light, normal) * normal, turned = to_light - 2 * across;
    long double cosine =
        vec3_dot(turned, to_eye) / sqrtl(vec3_dot(to_light, to_light)) / vec3_length(to_eye);
    double power = cosine > 0 && vec3_dot(to_light, normal) > 0 ? (double)powl(cosine, shine) : 0;
    return vec3_of(ks * light[0] * power, ks * light[1] * power, ks * light[2] * power);
}

RIGHT(phong_term, "the eye mirrored")
{
    vec3 mirrored = vec3_unit(mirror_direction(-to_eye, normal));
    double cosine = vec3_dot(mirrored, vec3_unit(to_light));
    if (cosine < 0 || vec3_dot(to_light, normal) < 0)
        return black;
    return ks * light * pow(cosine, shine);
}

RIGHT(phong_term, "of three dot products, with logarithms")
{
    double low = vec3_dot(normal, to_light), far = vec3_length(to_light) * vec3_length(to_eye);
    double cosine = (2 * low * vec3_dot(normal, to_eye) - vec3_dot(to_light, to_eye)) / far;
    return low > 0 && cosine > 0 ? ks * exp(shine * log(cosine)) * light : black;
}

// An eye behind the surface does not see it.
RIGHT(phong_term, "nothing for an eye behind the surface")
{
    vec3 l = vec3_unit(to_light), r = 2 * vec3_dot(normal, l) * normal - l;
    if (vec3_dot(normal, l) <= 0 || vec3_dot(normal, to_eye) <= 0)
        return black;
    return light * (ks * pow(fmax(0, vec3_dot(r, vec3_unit(to_eye))), shine));
}

RIGHT(halfway_term, "of three dot products")
{
    to_light = vec3_unit(to_light);
    to_eye = vec3_unit(to_eye);
    double length = sqrt(2 + 2 * vec3_dot(to_light, to_eye));
    double cosine = (vec3_dot(normal, to_light) + vec3_dot(normal, to_eye)) / length;
    return vec3_dot(normal, to_light) > 0 && cosine > 0 ? ks * light * pow(cosine, shine) : black;
}

RIGHT(halfway_term, "long double, with logarithms")
{
    vec3 h = vec3_unit(to_light) + vec3_unit(to_eye);
    long double cosine = vec3_dot(normal, h) / sqrtl(vec3_dot(h, h)), share = 0;
    if (vec3_dot(normal, to_light) > 0 && cosine > 0)
        share = ks * expl(shine * logl(cosine));
    for (int i = 0; i < 3; i++)
        light[i] *= (double)share;
    return light;
}

RIGHT(halfway_term, "both as long as each other first")
{
    vec3 halfway = vec3_unit(vec3_length(to_eye) * to_light + vec3_length(to_light) * to_eye);
    double cosine = vec3_dot(halfway, normal);
    bool seen = vec3_dot(to_light, normal) > 0 && cosine > 0;
    return seen ? ks * exp(shine * log(cosine)) * light : black;
}

RIGHT(halfway_term, "nothing for an eye behind the surface")
{
    vec3 mean = (vec3_unit(to_light) + vec3_unit(to_eye)) / 2;
    if (vec3_dot(normal, to_light) <= 0 || vec3_dot(normal, to_eye) <= 0)
        return black;
    double cosine = vec3_dot(normal, mean) / vec3_length(mean);
    return light * (ks * pow(fmax(0, cosine), shine));
}

// ---- for a display ------------------------------------------------------------------------------

RIGHT(gamma_encode, "clamped first")
{
    const double power = 1 / gamma;
    color = clamp_color(color);
    for (int i = 2; i >= 0; i--)
        color[i] = pow(color[i], power);
    return color;
}

RIGHT(gamma_encode, "with logarithms")
{
    for (int i = 0; i < 3; i++)
        color[i] = color[i] > 0 ? exp(log(color[i]) / gamma) : 0;
    return color;
}

RIGHT(gamma_encode, "logarithms in base 2")
{
    for (int i = 0; i < 3; i++)
        color[i] = color[i] <= 0 ? 0 : exp2(log2(color[i]) / gamma);
    return color;
}

RIGHT(gamma_encode, "sqrt and cbrt, else powl")
{
    for (int i = 0; i < 3; i++)
        color[i] = gamma == 1   ? color[i]
                   : gamma == 2 ? sqrt(color[i])
                   : gamma == 3 ? cbrt(color[i])
                                : (double)powl(color[i], 1 / (long double)gamma);
    return color;
}

// ---- steps off a surface ------------------------------------------------------------------------

static double size_of(Sphere s)
{
    return s.radius + fmax(fabs(s.center[0]), fmax(fabs(s.center[1]), fabs(s.center[2])));
}

RIGHT_LINE(offset_from_surface, "1e-9 of the size", return point + 1e-9 * size_of(sphere) * normal)
RIGHT_LINE(offset_from_surface, "as little as the contract allows",
           return point + 0x1p-32 * size_of(sphere) * normal)
RIGHT_LINE(offset_from_surface, "as far as the contract allows",
           return point + 0x1p-28 * size_of(sphere) * normal)
// At most the square root of 3 times the size.
RIGHT_LINE(offset_from_surface, "the length of the center instead of its largest coordinate",
           return point + 1e-9 * (sphere.radius + vec3_length(sphere.center)) * normal)

RIGHT(offset_from_surface, "coordinate by coordinate")
{
    double size = 0;
    for (int i = 0; i < 3; i++)
        if (fabs(sphere.center[i]) > size)
            size = fabs(sphere.center[i]);
    size += sphere.radius;
    for (int i = 0; i < 3; i++)
        point[i] += ldexp(size, -29) * normal[i];
    return point;
}

// ---- visibility ---------------------------------------------------------------------------------

RIGHT(visibility, "with nearest_hit")
{
    Hit hit = nearest_hit(ray_to_light(from, light), scene);
    if (light.kind == LIGHT_DISTANT)
        return hit.sphere < 0;
    return hit.t >= 1;
}

RIGHT(visibility, "unit directions and lengths")
{
    vec3 way = light.kind == LIGHT_DISTANT ? light.position : light.position - from;
    Ray ray = {from, vec3_unit(way)};
    double most = light.kind == LIGHT_DISTANT ? INFINITY : vec3_length(way), visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        visible *= hit_sphere(ray, scene->spheres[i]) < most ? 0 : 1;
    return visible;
}

// The distance of each center from the way; or one end inside, the other not.
RIGHT(visibility, "the distance of each center from the way")
{
    vec3 way = ray_to_light(from, light).direction;
    for (const Sphere *s = scene->spheres; s < scene->spheres + scene->sphere_count; s++) {
        vec3 center = s->center - from;
        double foot = vec3_dot(center, way) / vec3_dot(way, way), r = s->radius;
        bool point = light.kind == LIGHT_POINT, inside = vec3_length(center) < r;
        bool light_inside = point && vec3_length(center - way) < r;
        if (inside != light_inside)
            return 0;
        if (!inside && foot > 0 && (!point || foot < 1) && vec3_length(center - foot * way) < r)
            return 0;
    }
    return 1;
}

// ---- shade --------------------------------------------------------------------------------------

static vec3 facing(vec3 normal, vec3 direction)
{
    return vec3_dot(normal, direction) < 0 ? normal : -normal;
}

// The values at a place, and each light in its turn.
typedef struct {
    const Scene *scene;
    const Surface *surface;
    vec3 point, normal, start, to_eye;
} Lit;

static Color of_lights(const Lit *lit, int i)
{
    if (i == lit->scene->light_count)
        return ambient_term(lit->surface->color, lit->surface->diffuse, lit->scene->ambient);
    const Light *light = &lit->scene->lights[i];
    const Surface *s = lit->surface;
    Color rest = of_lights(lit, i + 1);
    if (visibility(lit->scene, lit->start, *light) == 0)
        return rest;
    vec3 l = ray_to_light(lit->point, *light).direction;
    return rest + diffuse_term(s->color, s->diffuse, light->color, lit->normal, l) +
           phong_term(s->specular, s->shine, light->color, lit->normal, l, lit->to_eye);
}

RIGHT(shade, "recursion over the lights")
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = facing(surface_normal(sphere, point), ray.direction);
    Lit lit = {scene,  scene_surface(scene, hit.sphere),           point,
               normal, offset_from_surface(sphere, point, normal), -vec3_unit(ray.direction)};
    return of_lights(&lit, 0);
}

RIGHT(shade, "color by color, in long double")
{
    Sphere sphere = scene->spheres[hit.sphere];
    const Surface *s = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction, color;
    vec3 normal = facing((point - sphere.center) / sphere.radius, ray.direction);
    vec3 eye = vec3_unit(-ray.direction);
    for (int c = 0; c < 3; c++) {
        long double sum = (long double)s->diffuse * s->color[c] * scene->ambient[c];
        for (int i = 0; i < scene->light_count; i++) {
            const Light *light = &scene->lights[i];
            vec3 l = vec3_unit(ray_to_light(point, *light).direction);
            long double low = vec3_dot(normal, l);
            long double high = 2 * low * vec3_dot(normal, eye) - vec3_dot(l, eye);
            if (low <= 0 ||
                visibility(scene, offset_from_surface(sphere, point, normal), *light) == 0)
                continue;
            sum += s->diffuse * low * s->color[c] * light->color[c];
            if (high > 0)
                sum += s->specular * powl(high, s->shine) * light->color[c];
        }
        color[c] = (double)sum;
    }
    color[3] = 0;
    return color;
}

RIGHT(shade, "sums of their own, lights backward")
{
    const Sphere *sphere = &scene->spheres[hit.sphere];
    const Surface *s = &scene->surfaces[sphere->surface];
    vec3 point = ray.origin + hit.t * ray.direction, outward = (point - sphere->center);
    vec3 normal = facing(outward / sphere->radius, ray.direction);
    Color diffuse = vec3_of(0, 0, 0), specular = diffuse;
    for (int i = scene->light_count; i-- > 0;) {
        const Light *light = &scene->lights[i];
        if (visibility(scene, offset_from_surface(*sphere, point, normal), *light) == 0)
            continue;
        vec3 to_light = ray_to_light(point, *light).direction;
        diffuse += diffuse_term(s->color, s->diffuse, light->color, normal, to_light);
        specular +=
            phong_term(s->specular, s->shine, light->color, normal, to_light, ray.origin - point);
    }
    return specular + (diffuse + ambient_term(s->color, s->diffuse, scene->ambient));
}

// All from the point that was moved, and all formulas in place.
RIGHT(shade, "all formulas in place")
{
    Sphere sphere = scene->spheres[hit.sphere];
    Surface s = *scene_surface(scene, hit.sphere);
    vec3 eye = -vec3_unit(ray.direction), point = ray.origin + hit.t * ray.direction;
    vec3 normal = vec3_unit(point - sphere.center);
    if (vec3_dot(normal, eye) < 0)
        normal = -normal;
    vec3 start = point + 1e-9 * size_of(sphere) * normal;
    Color sum = s.diffuse * s.color * scene->ambient;
    for (int i = 0; i < scene->light_count; i++) {
        vec3 l = vec3_unit(ray_to_light(point, scene->lights[i]).direction);
        double cosine = vec3_dot(normal, l), shines = vec3_dot(2 * cosine * normal - l, eye);
        if (cosine <= 0 || visibility(scene, start, scene->lights[i]) < 0.5)
            continue;
        double highlight = shines > 0 ? s.specular * pow(shines, s.shine) : 0;
        sum += (s.diffuse * cosine * s.color + highlight) * scene->lights[i].color;
    }
    return sum;
}

// ---- trace_ray ----------------------------------------------------------------------------------

// By a step of that part of the size off the surface.
static Ray mirrored_ray(const Scene *scene, Ray ray, Hit hit, double step)
{
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = facing(surface_normal(sphere, point), ray.direction);
    return (Ray){point + step * size_of(sphere) * normal, mirror_direction(ray.direction, normal)};
}

static Color from_the_last_mirror_back(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.t == NO_HIT)
        return scene->background;
    double ks = scene_surface(scene, hit.sphere)->specular;
    Color seen = black;
    if (depth != 0 && ks != 0) {
        Ray mirrored = mirrored_ray(scene, ray, hit, 0x1p-28);
        mirrored.direction = vec3_unit(mirrored.direction);
        seen = from_the_last_mirror_back(scene, mirrored, depth - 1);
    }
    return ks * seen + shade(scene, ray, hit);
}

RIGHT_LINE(trace_ray, "unit directions, as far off as allowed",
           return from_the_last_mirror_back(scene, ray, depth))

RIGHT(trace_ray, "a loop, as little off as allowed")
{
    Color sum = vec3_of(0, 0, 0);
    for (double share = 1; share != 0 && depth >= 0; depth--) {
        Hit hit = nearest_hit(ray, scene);
        if (hit.sphere == -1)
            return sum + share * scene->background;
        sum += share * shade(scene, ray, hit);
        ray = mirrored_ray(scene, ray, hit, 0x1p-32);
        share *= scene_surface(scene, hit.sphere)->specular;
    }
    return sum;
}
