// self_hit.c - why a ray must not start on the surface that it leaves, as the data of a figure.
//
// The numbers are those of a real ray, but a rounding error is too small to be seen. So it is drawn
// as a fifth of the radius, and so is the distance of the remedy. Two pictures show what follows,
// with real rounding errors.
#include "chapters/07-shading/figures/self_hit.h"

#include "common/camera.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>

static const double shown_error = 0.22; // of the radius
static const double window[2][2] = {{-1.2, 1.2}, {0.45, 1.9}};

// ---- the rays ---------------------------------------------------------------------------------

// The first of the rays for which a second ray, from the hit point to the light, immediately meets
// the sphere again, because rounding put the point inside. Each formula rounds in its own way and
// finds its own ray. They differ by so little that the figure is the same.
static Ray unlucky_ray(Sphere sphere, Light light)
{
    Ray ray = {vec3_of(-1.15, 1.575, 0), vec3_of(1, 0, 0)};
    for (int i = 0; i < 10000; i++) {
        ray.direction = vec3_of(1, -0.5 - 1e-14 * i, 0);
        double t = hit_sphere(ray, sphere);
        vec3 point = ray.origin + t * ray.direction;
        if (t < NO_HIT && hit_sphere(ray_to_light(point, light), sphere) < 1)
            return ray;
    }
    return ray;
}

// What is true of the ray, in numbers: none of it can be drawn.
static void true_numbers(Plot *plot, Sphere sphere, Light light, vec3 point)
{
    vec3 normal = surface_normal(sphere, point);
    vec3 start = off_surface(sphere, point, normal);
    Roots roots = sphere_roots(ray_to_light(start, light), sphere);
    plot_undrawn(plot);
    plot_vector(plot, "offset", point, start - point);
    plot_number(plot, "offset_size", vec3_length(start - point));
    plot_number(plot, "self_t", hit_sphere(ray_to_light(point, light), sphere));
    plot_number(plot, "inside_by", sphere.radius - vec3_length(point - sphere.center));
    plot_number(plot, "roots_from_start", roots.count);
    plot_number(plot, "largest_from_start", roots.count > 0 ? roots.t[roots.count - 1] : NAN);
}

// The upper part of the sphere that is in the window.
static void cap_data(Plot *plot, const char *name, Sphere sphere)
{
    enum { PLACES = 72 };
    double low = asin(window[1][0] / sphere.radius);
    plot_block(plot, name, "x y z");
    for (int i = 0; i <= PLACES; i++) {
        double a = low + (PI - 2 * low) * i / PLACES;
        plot_row_point(plot, sphere.center + sphere.radius * vec3_of(cos(a), sin(a), 0));
    }
    plot_block_end(plot);
}

// The same in both panels: the sphere, the ray that the eye sees along, the light.
static void panel_data(Plot *plot, int panel, Sphere sphere, Light light, Ray ray, vec3 point)
{
    static const Room rooms[] = {{0.012, 0.488, 0.33, 0.845}, {0.512, 0.988, 0.33, 0.845}};
    char name[20];
    plot_panel(plot, panel);
    plot_room(plot, rooms[panel - 1], rooms[panel - 1]);
    plot_fit(plot, vec3_of(window[0][0], window[1][0], 0), 0);
    plot_fit(plot, vec3_of(window[0][1], window[1][1], 0), 0);
    snprintf(name, sizeof name, "cap_%d", panel);
    cap_data(plot, name, sphere);
    snprintf(name, sizeof name, "light_%d", panel);
    plot_point(plot, name, light.position);
    plot_name(plot,
              (Label){.text = "light", .color = "ink", .block = name, .step = panel == 1 ? 1 : 4});
    snprintf(name, sizeof name, "seen_%d", panel);
    plot_vector(plot, name, ray.origin, point - ray.origin);
}

static void drawn_rays(Plot *plot, Sphere sphere, Light light, Ray ray, vec3 point)
{
    vec3 normal = surface_normal(sphere, point);
    vec3 inside = point - shown_error * sphere.radius * normal;
    vec3 outside = point + shown_error * sphere.radius * normal;
    Ray back = ray_to_light(inside, light);
    vec3 to_itself = hit_sphere(back, sphere) * back.direction;

    panel_data(plot, 1, sphere, light, ray, point);
    plot_vector(plot, "wanted", point, light.position - point);
    plot_point(plot, "point", point);
    plot_point(plot, "inside", inside);
    plot_vector(plot, "to_itself", inside, to_itself);
    plot_point(plot, "own_hit", inside + to_itself);
    plot_name(plot,
              (Label){.text = "from the eye", .color = "grey", .block = "seen_1", .part = 0.3});
    plot_name(plot, (Label){.text = "computed hit", .color = "ink", .block = "inside", .step = 2});
    plot_name(plot, (Label){.text = "hits itself", .color = "ink", .block = "own_hit", .step = 3});

    panel_data(plot, 2, sphere, light, ray, point);
    plot_vector(plot, "normal", point, outside - point);
    plot_point(plot, "outside", outside);
    // Its tip does not cover the light.
    plot_vector(plot, "to_light", outside, 0.93 * (light.position - outside));
    plot_name(plot,
              (Label){.text = "$n$", .color = "green", .block = "normal", .part = 0.5, .step = 4});
    plot_name(plot, (Label){.text = "start", .color = "blue", .block = "outside", .step = 4});
}

// ---- what follows, as pictures ----------------------------------------------------------------

typedef vec3 Starter(Sphere sphere, vec3 point, vec3 normal);

static vec3 at_the_point(Sphere sphere, vec3 point, vec3 normal)
{
    (void)sphere;
    (void)normal;
    return point;
}

// Brighter the more the surface faces the eye, so that it looks round; and dark where a ray to the
// light that starts as told does not arrive.
static Color light_and_dark(const Scene *scene, Ray ray, Starter *start)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere != 0)
        return scene->background;
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(scene->spheres[0], point);
    double facing = fabs(vec3_dot(normal, vec3_unit(ray.direction)));
    vec3 from = start(scene->spheres[0], point, normal);
    double left = visibility(scene, from, scene->lights[0]) > 0 ? 1 : 0.2;
    return left * facing * scene_surface(scene, 0)->color;
}

// With samples x samples rays a pixel.
static void picture_data(Plot *plot, const char *name, Starter *start, int samples, double allowed)
{
    enum { SIDE = 150 };
    // Neither at the origin nor exactly before the eye, where rounding makes symmetrical patterns.
    const vec3 place = vec3_of(2, 2, 1);
    Sphere sphere = {.center = place, .radius = 1};
    Surface surface = {.color = vec3_of(1, 1, 1)};
    Light light = {place + vec3_of(3, 5, 6), vec3_of(1, 1, 1), LIGHT_POINT};
    const double grey = 127 / 255.0;
    Scene scene = {.spheres = &sphere,
                   .sphere_count = 1,
                   .surfaces = &surface,
                   .surface_count = 1,
                   .lights = &light,
                   .light_count = 1,
                   .background = vec3_of(grey, grey, grey)};
    Camera camera = {.origin = place + vec3_of(0.011, 0.007, 6),
                     .right = vec3_of(1, 0, 0),
                     .up = vec3_of(0, 1, 0),
                     .forward = vec3_of(0, 0, -1),
                     .distance = 6,
                     .width = 2.25,
                     .height = 2.25};
    Image image;
    Message message;
    Resolution fine = {SIDE * samples, SIDE * samples};
    if (!image_create(&image, (Resolution){SIDE, SIDE}, &message))
        return;
    for (int i = 0; i < SIDE * SIDE; i++) {
        Color sum = vec3_of(0, 0, 0);
        for (int k = 0; k < samples * samples; k++) {
            Pixel sample = {i % SIDE * samples + k % samples, i / SIDE * samples + k / samples};
            sum += light_and_dark(&scene, pixel_ray(camera, fine, sample), start);
        }
        image_set(&image, (Pixel){i % SIDE, i / SIDE}, sum / (samples * samples));
    }
    plot_picture(plot, name, &image, allowed);
    plot_number(plot, "side", SIDE);
    image_free(&image);
}

// ---- all of it --------------------------------------------------------------------------------

void self_hit_data(Plot *plot, void *given)
{
    (void)given;
    const Sphere sphere = {.center = vec3_of(0, 0, 0), .radius = 1};
    const Light light = {vec3_of(0.85, 1.8, 0), vec3_of(1, 1, 1), LIGHT_POINT};
    Ray ray = unlucky_ray(sphere, light);
    vec3 point = ray.origin + hit_sphere(ray, sphere) * ray.direction;
    plot_look_flat(plot);
    plot_fill_room(plot);
    plot_keep_clear(plot, (Room){0, 1, 0, 0.33}, (Room){0, 1, 0, 0.33});
    true_numbers(plot, sphere, light, point);
    drawn_rays(plot, sphere, light, ray, point);
    plot_include(plot, "common/figure/pictures.gp");
    // Right answers round in different ways, and each has specks of its own.
    picture_data(plot, "specks", at_the_point, 1, 255);
    picture_data(plot, "smooth", off_surface, 3, ROUNDING);
}
