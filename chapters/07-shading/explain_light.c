// explain_light.c - the light that one pixel sees, term by term, in words and numbers.
//
// Each number comes from the exercise function that computes it, as in chapter 06's explain.c.
#include "chapters/07-shading/explain_light.h"

#include "common/story.h"
#include "common/text.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The color that shade returns for one light alone, and a surface with only one of the two terms.
static vec3 one_term(const Scene *scene, Light light, Ray ray, Hit hit, bool diffuse)
{
    Surface surface = *scene_surface(scene, hit.sphere);
    Scene alone = *scene;
    *(diffuse ? &surface.specular : &surface.diffuse) = 0;
    alone.ambient = vec3_of(0, 0, 0);
    alone.lights = &light;
    alone.light_count = 1;
    alone.surfaces = &surface;
    alone.surface_count = 1;
    Sphere *spheres = malloc((size_t)scene->sphere_count * sizeof *spheres);
    if (spheres == NULL)
        return vec3_of(NAN, NAN, NAN);
    memcpy(spheres, scene->spheres, (size_t)scene->sphere_count * sizeof *spheres);
    for (int i = 0; i < scene->sphere_count; i++)
        spheres[i].surface = 0;
    alone.spheres = spheres;
    vec3 color = shade(&alone, ray, hit);
    free(spheres);
    return color;
}

static void tell_surface(const Scene *scene, int sphere)
{
    const Surface *surface = scene_surface(scene, sphere);
    story_line("color, Kd, Ks, Shine", "%s, %s, %s, %s", vec3_text(surface->color).s,
               number_text(surface->diffuse).s, number_text(surface->specular).s,
               number_text(surface->shine).s);
    story_by("ambient_term");
    story_line("ambient", "%s",
               vec3_text(ambient_term(surface->color, surface->diffuse, scene->ambient)).s);
}

static void tell_light(const Scene *scene, int i, Ray ray, Hit hit, vec3 normal, vec3 start)
{
    Light light = scene->lights[i];
    const Surface *surface = scene_surface(scene, hit.sphere);
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 to_light = ray_to_light(point, light).direction;
    bool arrives = visibility(scene, start, light) > 0;
    story_segment(arrives ? "light" : "shadow", start,
                  start + ray_to_light(start, light).direction);
    story_heading("Light %d, %s", i + 1, vec3_text(light.color).s);
    story_by("ray_to_light");
    story_line("from the point to it", "%s, unit %s", vec3_text(to_light).s,
               vec3_text_to(vec3_unit(to_light), 4).s);
    story_by("visibility");
    story_line("arrives", "%s", arrives ? "yes" : "no: something is in between");
    story_line("cosine with the normal", "%s",
               number_text(vec3_dot(normal, vec3_unit(to_light))).s);
    story_by("shade diffuse_term");
    story_line("diffuse", "%s", vec3_text_to(one_term(scene, light, ray, hit, true), 4).s);
    story_by("shade phong_term");
    story_line("specular, Phong", "%s", vec3_text_to(one_term(scene, light, ray, hit, false), 4).s);
    story_by("halfway_term");
    story_line("specular, Blinn", "%s",
               vec3_text_to(halfway_term(surface->specular, surface->shine,
                                         arrives ? light.color : vec3_of(0, 0, 0), normal, to_light,
                                         -ray.direction),
                            4)
                   .s);
}

void explain_light(const Scene *scene, Camera camera, Resolution screen, Pixel pixel, int depth,
                   TellMirrors *tell_mirrors)
{
    Ray ray = pixel_ray(camera, screen, pixel);
    Hit hit = nearest_hit(ray, scene);
    printf("07-shading: light, and the color that a surface sends back\n");
    story_heading("What pixel (%d, %d) sees", pixel.column, pixel.row);
    if (hit.sphere < 0) {
        story_segment("ray", ray.origin, ray.origin + 2 * ray_to_plane(ray, camera).direction);
        story_line("nothing", "the background, %s", vec3_text(scene->background).s);
        return;
    }
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(sphere, point);
    if (vec3_dot(normal, ray.direction) > 0) // from inside
        normal = -normal;
    vec3 start = offset_from_surface(sphere, point, normal);
    story_segment("ray", ray.origin, point);
    story_segment("normal", point, point + normal);
    story_by("nearest_hit");
    story_line("sphere", "%c, t = %s", 'A' + hit.sphere % 26, number_text(hit.t).s);
    story_line("point", "%s", vec3_text(point).s);
    story_by("surface_normal");
    story_line("normal", "%s", vec3_text(normal).s);
    story_by("offset_from_surface");
    story_line("shadow bias", "%s", number_text(vec3_length(start - point)).s);
    tell_surface(scene, hit.sphere);
    for (int i = 0; i < scene->light_count; i++)
        tell_light(scene, i, ray, hit, normal, start);
    if (tell_mirrors != NULL)
        tell_mirrors(scene, ray, hit, depth);
    story_heading("Together");
    story_by("shade");
    story_line("shade", "%s", vec3_text_to(shade(scene, ray, hit), 4).s);
    story_by("trace_ray");
    story_line("with mirrors", "%s", vec3_text_to(trace_ray(scene, ray, depth), 4).s);
    story_by("clamp_color");
    story_line("clamped", "%s", vec3_text_to(clamp_color(trace_ray(scene, ray, depth)), 4).s);
}
