// 07-shading.c - exercise 07: light, and the color that a surface sends back.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/07-shading.h. The lesson: chapters/07-shading/README.md.
// After each change:   make exercises EX=07
#include "exercises/07-shading.h"

#include "common/answers.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

// BEGIN SOLUTION
// The color is a sum: the ambient light, and for each light that no sphere hides, the diffuse and
// the specular light. A mirror asks the same question again, with another ray.
// END SOLUTION

vec3 surface_normal(Sphere sphere, vec3 point)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return vec3_unit(point - sphere.center);
    // END SOLUTION
}

Ray ray_to_light(vec3 from, Light light)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Ray);
    return (Ray){from, light.kind == LIGHT_DISTANT ? light.position : light.position - from};
    // END SOLUTION
}

Color ambient_term(Color surface, double kd, Color ambient)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    return kd * surface * ambient;
    // END SOLUTION
}

Color diffuse_term(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    double cosine = vec3_dot(normal, vec3_unit(to_light));
    return kd * fmax(0, cosine) * surface * light;
    // END SOLUTION
}

vec3 mirror_direction(vec3 direction, vec3 normal)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    return direction - 2 * vec3_dot(direction, normal) * normal;
    // END SOLUTION
}

// BEGIN SOLUTION
static Color highlight(double ks, double shine, Color light, double cosine, bool lit)
{
    return lit && cosine > 0 ? ks * pow(cosine, shine) * light : vec3_of(0, 0, 0);
}
// END SOLUTION

Color phong_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    vec3 mirrored = mirror_direction(-to_light, normal);
    double cosine = vec3_dot(vec3_unit(mirrored), vec3_unit(to_eye));
    return highlight(ks, shine, light, cosine, vec3_dot(normal, to_light) > 0);
    // END SOLUTION
}

Color halfway_term(double ks, double shine, Color light, vec3 normal, vec3 to_light, vec3 to_eye)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    vec3 halfway = vec3_unit(to_light) + vec3_unit(to_eye);
    double cosine = vec3_dot(normal, vec3_unit(halfway));
    return highlight(ks, shine, light, cosine, vec3_dot(normal, to_light) > 0);
    // END SOLUTION
}

vec3 offset_from_surface(Sphere sphere, vec3 point, vec3 normal)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(vec3);
    vec3 c = sphere.center;
    double size = sphere.radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
    return point + 0x1p-30 * size * normal;
    // END SOLUTION
}

double visibility(const Scene *scene, vec3 from, Light light)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    Ray ray = ray_to_light(from, light);
    double reach = light.kind == LIGHT_DISTANT ? NO_HIT : 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hit_sphere(ray, scene->spheres[i]) < reach)
            return 0;
    return 1;
    // END SOLUTION
}

// BEGIN SOLUTION
// The normal at a hit, turned to the side from which the ray came.
static vec3 normal_at(Sphere sphere, vec3 point, Ray ray)
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
}
// END SOLUTION

Color shade(const Scene *scene, Ray ray, Hit hit)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    Sphere sphere = scene->spheres[hit.sphere];
    const Surface *surface = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_at(sphere, point, ray);
    vec3 start = offset_from_surface(sphere, point, normal);

    Color sum = ambient_term(surface->color, surface->diffuse, scene->ambient);
    for (int i = 0; i < scene->light_count; i++) {
        Color light = scene->lights[i].color * visibility(scene, start, scene->lights[i]);
        vec3 to_light = ray_to_light(point, scene->lights[i]).direction;
        sum += diffuse_term(surface->color, surface->diffuse, light, normal, to_light);
        sum +=
            phong_term(surface->specular, surface->shine, light, normal, to_light, -ray.direction);
    }
    return sum;
    // END SOLUTION
}

Color trace_ray(const Scene *scene, Ray ray, int depth)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (depth > 0 && ks > 0) {
        Sphere sphere = scene->spheres[hit.sphere];
        vec3 point = ray.origin + hit.t * ray.direction;
        vec3 normal = normal_at(sphere, point, ray);
        Ray mirrored = {offset_from_surface(sphere, point, normal),
                        mirror_direction(ray.direction, normal)};
        color += ks * trace_ray(scene, mirrored, depth - 1);
    }
    return color;
    // END SOLUTION
}

Color clamp_color(Color color)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    for (int i = 0; i < 3; i++)
        color[i] = fmin(1, fmax(0, color[i]));
    return color;
    // END SOLUTION
}

Color gamma_encode(Color color, double gamma)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Color);
    return vec3_of(pow(color[0], 1 / gamma), pow(color[1], 1 / gamma), pow(color[2], 1 / gamma));
    // END SOLUTION
}
