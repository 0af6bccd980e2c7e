// render.c - a shaded picture, by the answers of chapters 04 and 07.
#include "chapters/shared/render.h"

#include "chapters/shared/needed_answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/07-shading.h"

void keep_term(Scene *scene, Term term)
{
    if (term == TERM_AMBIENT || term == TERM_FLAT)
        scene->light_count = 0;
    if (term == TERM_DIFFUSE || term == TERM_SPECULAR)
        scene->ambient = vec3_of(0, 0, 0);
    if (term == TERM_FLAT)
        scene->ambient = vec3_of(1, 1, 1);
    for (int i = 0; i < scene->surface_count && term != TERM_ALL; i++) {
        Surface *surface = &scene->surfaces[i];
        surface->diffuse = term == TERM_FLAT ? 1 : term == TERM_SPECULAR ? 0 : surface->diffuse;
        surface->specular = term == TERM_SPECULAR ? surface->specular : 0;
    }
}

Color render_pixel(const Rendering *rendering, void *world, Pixel pixel)
{
    Style style = rendering->style;
    int n = style.samples;
    Resolution fine = {rendering->screen.width * n, rendering->screen.height * n};
    Color sum = vec3_of(0, 0, 0);
    for (int i = 0; i < n * n; i++) {
        Pixel sample = {pixel.column * n + i % n, pixel.row * n + i / n};
        Ray ray = pixel_ray(rendering->camera, fine, sample);
        sum += clamp_color(rendering->trace(world, sample, ray, style.depth));
    }
    Color mean = sum / (n * n);
    return style.gamma == 1 ? mean : gamma_encode(mean, style.gamma);
}

Color trace_scene(void *world, Pixel sample, Ray ray, int depth)
{
    (void)sample;
    return trace_ray(world, ray, depth);
}

void render(const Scene *scene, Camera camera, Style style, Image *image)
{
    Rendering rendering = {camera, image->size, style, trace_scene};
    Scene world = *scene;
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            Pixel pixel = {column, row};
            image_set(image, pixel, render_pixel(&rendering, &world, pixel));
        }
}

bool shading_needs_are_met(Style style)
{
    const Light lamp = {.position = vec3_of(0, 9, -9), .color = vec3_of(1, 1, 1)};
    Surface white = {.color = vec3_of(1, 1, 1), .diffuse = 1, .specular = 1};
    Sphere ball = {.center = vec3_of(0, 0, 0), .radius = 1};
    Light light = lamp;
    Scene scene = {.spheres = &ball,
                   .sphere_count = 1,
                   .surfaces = &white,
                   .surface_count = 1,
                   .lights = &light,
                   .light_count = 1};
    Ray ray = {vec3_of(0, 0, -4), vec3_of(0, 0, 1)};
    vec3 point = vec3_of(0, 0, -1), normal = surface_normal(ball, point);
    Color white_light = lamp.color;

    ray_to_light(point, lamp);
    ambient_term(white.color, 1, white_light);
    diffuse_term(white.color, 1, white_light, normal, lamp.position);
    mirror_direction(ray.direction, normal);
    phong_term(1, 1, white_light, normal, lamp.position, -ray.direction);
    offset_from_surface(ball, point, normal);
    visibility(&scene, point, lamp);
    shade(&scene, ray, (Hit){3, 0});
    clamp_color(trace_ray(&scene, ray, 1));
    if (style.gamma != 1)
        gamma_encode(white_light, style.gamma);
    return picture_needs_are_met(IMAGE_ORDER);
}
