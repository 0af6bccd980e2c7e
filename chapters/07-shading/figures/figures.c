// figures.c - the data of the figures of chapter 07.
#include "chapters/07-shading/figures/figures.h"

#include "chapters/shared/render.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <string.h>

// ---- flat and shaded --------------------------------------------------------------------------

enum { COLUMNS = 112, ROWS = 84 };

// A picture as numbers, 65536 red + 256 green + blue, row by row from the bottom.
static void picture_data(Plot *plot, const char *name, const Image *image)
{
    plot_block(plot, name, "65536 red + 256 green + blue, in rows from the lowest");
    for (int row = image->size.height - 1; row >= 0; row--) {
        double numbers[COLUMNS];
        for (int column = 0; column < image->size.width; column++) {
            const uint8_t *rgb = image_bytes(image, (Pixel){column, row});
            numbers[column] = 65536.0 * rgb[0] + 256.0 * rgb[1] + rgb[2];
        }
        plot_row(plot, image->size.width, numbers);
    }
    plot_block_end(plot);
}

// A place on the picture, in pixels from the lower left; and whether there is one.
static void spot_data(Plot *plot, const char *name, const char *has, Pixel pixel)
{
    plot_block(plot, name, "x y on the picture");
    plot_row(plot, 2, (const double[]){pixel.column + 0.5, ROWS - pixel.row - 0.5});
    plot_block_end(plot);
    plot_number(plot, has, pixel.column >= 0);
}

#define NO_PIXEL ((Pixel){-1, -1})

// Of the pixels that see a sphere, the one with the largest value greater than 0.
static Pixel most(const Drawing *drawing, double (*value)(const Drawing *, Ray, Hit))
{
    const Resolution screen = {COLUMNS, ROWS};
    Pixel best = NO_PIXEL;
    double largest = 0;
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        Pixel pixel = {i % COLUMNS, i / COLUMNS};
        Ray ray = pixel_ray(drawing->camera, screen, pixel);
        Hit hit = nearest_hit(ray, &drawing->scene);
        double here = hit.sphere < 0 ? 0 : value(drawing, ray, hit);
        if (here > largest) {
            largest = here;
            best = pixel;
        }
    }
    return best;
}

// How much of the first light arrives at a point of a surface, 0 or 1, whichever side it falls on.
static double light_here(const Drawing *drawing, vec3 point, Hit hit, vec3 normal)
{
    vec3 start = off_surface(drawing->scene.spheres[hit.sphere], point, normal);
    return visibility(&drawing->scene, start, drawing->scene.lights[0]);
}

// How exactly the first light is mirrored into the eye; the first shiny sphere has priority.
static double highlight_here(const Drawing *drawing, Ray ray, Hit hit)
{
    const Scene *scene = &drawing->scene;
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(scene->spheres[hit.sphere], point);
    vec3 to_light = ray_to_light(point, scene->lights[0]).direction;
    double cosine = phong_term(1, 1, vec3_of(1, 1, 1), normal, to_light, -ray.direction)[0];
    bool seen = scene_surface(scene, hit.sphere)->specular > 0 && cosine > 0.95 &&
                light_here(drawing, point, hit, normal) > 0;
    return seen ? cosine + scene->sphere_count - hit.sphere : 0;
}

// The surface faces the light, but is dark.
static double shadow_here(const Drawing *drawing, Ray ray, Hit hit)
{
    const Scene *scene = &drawing->scene;
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(scene->spheres[hit.sphere], point);
    vec3 to_light = vec3_unit(ray_to_light(point, scene->lights[0]).direction);
    return vec3_dot(normal, to_light) - 2 * light_here(drawing, point, hit, normal);
}

static void flat_and_shaded(Plot *plot, void *given)
{
    Drawing drawing = *(const Drawing *)given;
    Image image;
    Message message;
    Style style = {.samples = 1, .depth = 0, .gamma = 1};
    if (!image_create(&image, (Resolution){COLUMNS, ROWS}, &message))
        return;
    Pixel highlight = most(&drawing, highlight_here), shadow = most(&drawing, shadow_here);
    spot_data(plot, "highlight", "has_highlight", highlight);
    spot_data(plot, "shadow", "has_shadow", shadow);
    plot_number(plot, "shadow_first", shadow.column <= highlight.column);
    plot_number(plot, "columns", COLUMNS);
    plot_number(plot, "rows", ROWS);
    plot_number(plot, "ambient", drawing.scene.ambient[0]);
    plot_number(plot, "spheres", drawing.scene.sphere_count);
    render(&drawing.scene, drawing.camera, style, &image);
    picture_data(plot, "shaded", &image);
    keep_term(&drawing.scene, TERM_FLAT);
    render(&drawing.scene, drawing.camera, style, &image);
    picture_data(plot, "flat", &image);
    image_free(&image);
}

// ---- a surface that hits itself ---------------------------------------------------------------

// The first of the rays for which a second ray, from the hit point to the light, immediately meets
// the sphere again, because rounding put the point inside. Each formula rounds in its own way and
// finds its own ray. They differ by so little that the figure is the same.
static Ray unlucky_ray(Sphere sphere, Light light)
{
    Ray ray = {vec3_of(-4, 3, 0), vec3_of(1, 0, 0)};
    for (int i = 0; i < 10000; i++) {
        ray.direction = vec3_of(1, -0.62 - 1e-14 * i, 0);
        double t = hit_sphere(ray, sphere);
        vec3 point = ray.origin + t * ray.direction;
        if (t < NO_HIT && hit_sphere(ray_to_light(point, light), sphere) < 1)
            return ray;
    }
    return ray;
}

static void self_hit(Plot *plot, void *given)
{
    (void)given;
    const Sphere sphere = {.center = vec3_of(0, 0, 0), .radius = 1};
    const Light light = {vec3_of(-1, 4, 0), vec3_of(1, 1, 1), LIGHT_POINT};
    Ray ray = unlucky_ray(sphere, light);
    vec3 point = ray.origin + hit_sphere(ray, sphere) * ray.direction;
    vec3 normal = surface_normal(sphere, point);
    vec3 start = off_surface(sphere, point, normal);
    vec3 offset = start - point;

    plot_number(plot, "radius", sphere.radius);
    plot_point(plot, "center", sphere.center);
    plot_point(plot, "light", light.position);
    plot_vector(plot, "seen", ray.origin, point - ray.origin);
    plot_vector(plot, "normal", point, normal);
    plot_vector(plot, "offset", point, offset);
    plot_number(plot, "offset_size", vec3_length(offset));
    plot_vector(plot, "to_light", point, ray_to_light(point, light).direction);
    plot_vector(plot, "from_start", start, ray_to_light(start, light).direction);
    vec3 to_light = vec3_unit(ray_to_light(point, light).direction);
    plot_number(plot, "light_angle", acos(vec3_dot(normal, to_light)) * 180 / PI);
    plot_number(plot, "self_t", hit_sphere(ray_to_light(point, light), sphere));
    plot_number(plot, "inside_by", sphere.radius - vec3_length(point - sphere.center));
    Roots roots = sphere_roots(ray_to_light(start, light), sphere);
    plot_number(plot, "roots_from_start", roots.count);
    plot_number(plot, "largest_from_start", roots.count > 0 ? roots.t[roots.count - 1] : NAN);
}

static const Figure figures[] = {{"flat-and-shaded", flat_and_shaded}, {"self-hit", self_hit}, {0}};

int shading_figure(FigureCommand command, const Drawing *drawing)
{
    Drawing copy = *drawing;
    return plot_figure(drawing->program, "chapters/07-shading", figures, command, &copy);
}
