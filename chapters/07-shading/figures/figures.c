// figures.c - the data of the figures of chapter 07.
#include "chapters/07-shading/figures/figures.h"

#include "chapters/shared/render.h"
#include "common/camera.h"
#include "common/figure/plot.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>
#include <stdlib.h>

// ---- flat and shaded --------------------------------------------------------------------------

const Style closing_style = {.samples = 3, .depth = 0, .gamma = 1};

// Twice the units of the canvas that a picture takes: as fine as the figure's PNG.
enum { MOST_COLUMNS = 920, MOST_ROWS = 690 };

// The words point at pixels of a coarser picture: what they name is larger than that.
enum { COARSE = 6 };

// As large as there is room, with the proportions of the drawing; in parts of that.
static Resolution picture_size(Resolution size, double parts)
{
    double scale = fmin(MOST_COLUMNS / parts / size.width, MOST_ROWS / parts / size.height);
    return (Resolution){(int)fmax(1, scale * size.width), (int)fmax(1, scale * size.height)};
}

typedef struct {
    const Drawing *drawing;
    Resolution screen; // coarse
    vec3 *points;      // that its pixels see
    Hit *hits;
} View;

static bool view_create(View *view, const Drawing *drawing, Resolution size)
{
    Resolution screen = {size.width / COARSE + 1, size.height / COARSE + 1};
    size_t count = (size_t)screen.width * (size_t)screen.height;
    *view = (View){drawing, screen, malloc(count * sizeof *view->points),
                   malloc(count * sizeof *view->hits)};
    if (view->points == NULL || view->hits == NULL)
        return false;
    for (int i = 0; i < (int)count; i++) {
        Pixel pixel = {i % screen.width, i / screen.width};
        Ray ray = pixel_ray(drawing->camera, screen, pixel);
        view->hits[i] = nearest_hit(ray, &drawing->scene);
        if (view->hits[i].sphere >= drawing->scene.sphere_count)
            view->hits[i].sphere = -1;
        view->points[i] = ray.origin + view->hits[i].t * ray.direction;
    }
    return true;
}

static void view_free(View *view)
{
    free(view->points);
    free(view->hits);
}

// How much of the first light arrives at a point of a surface, 0 or 1, whichever side it falls on.
static double light_here(const View *view, int i, vec3 normal)
{
    const Scene *scene = &view->drawing->scene;
    vec3 start = offset_from_surface(scene->spheres[view->hits[i].sphere], view->points[i], normal);
    return visibility(scene, start, scene->lights[0]);
}

// How exactly the first light is mirrored into the eye; the first shiny sphere has priority.
static double highlight_here(const View *view, int i)
{
    const Scene *scene = &view->drawing->scene;
    Hit hit = view->hits[i];
    vec3 point = view->points[i];
    vec3 normal = surface_normal(scene->spheres[hit.sphere], point);
    vec3 to_light = ray_to_light(point, scene->lights[0]).direction;
    vec3 to_eye = view->drawing->camera.origin - point;
    double cosine = phong_term(1, 1, vec3_of(1, 1, 1), normal, to_light, to_eye)[0];
    bool seen = scene_surface(scene, hit.sphere)->specular > 0 && cosine > 0.95 &&
                light_here(view, i, normal) > 0;
    return seen ? cosine + scene->sphere_count - hit.sphere : 0;
}

// The cosine between the normal and the first light if the surface faces it, but is dark; else 0.
static double darkened(const View *view, int i)
{
    const Scene *scene = &view->drawing->scene;
    vec3 point = view->points[i];
    if (view->hits[i].sphere < 0)
        return 0;
    vec3 normal = surface_normal(scene->spheres[view->hits[i].sphere], point);
    vec3 to_light = vec3_unit(ray_to_light(point, scene->lights[0]).direction);
    return light_here(view, i, normal) > 0 ? 0 : fmax(0, vec3_dot(normal, to_light));
}

// How deep inside a shadow a pixel is, in pixels to the nearest edge, times the cosine: where a
// surface is nearly edge-on to the light, it would be dark anyway.
static double shadow_here(const View *view, int i)
{
    double cosine = darkened(view, i);
    int x = i % view->screen.width, y = i / view->screen.width;
    for (int away = 1; cosine > 0; away++)
        for (int k = 0; k < 9; k++) {
            int column = x + (k % 3 - 1) * away, row = y + (k / 3 - 1) * away;
            if (column < 0 || row < 0 || column >= view->screen.width ||
                row >= view->screen.height ||
                !(darkened(view, row * view->screen.width + column) > 0))
                return away * away * cosine;
        }
    return 0;
}

// Of the pixels that see a sphere, the one with the largest value greater than 0; else -1.
static int most(const View *view, double (*value)(const View *, int))
{
    int best = -1;
    double largest = 0;
    for (int i = 0; i < view->screen.width * view->screen.height; i++) {
        double here = view->hits[i].sphere < 0 ? 0 : value(view, i);
        if (here > largest) {
            largest = here;
            best = i;
        }
    }
    return best;
}

// A place on the picture, in its pixels, from the lower left; and whether there is one.
static void spot_data(Plot *plot, const char *name, const char *has, const View *view, int i,
                      Resolution size)
{
    double x = (i % view->screen.width + 0.5) / view->screen.width;
    double y = 1 - (i / view->screen.width + 0.5) / view->screen.height;
    plot_block(plot, name, "x y on the picture, in pixels from the lower left");
    plot_row(plot, 2, (const double[]){x * size.width, y * size.height});
    plot_block_end(plot);
    plot_number(plot, has, i >= 0);
}

static void spots_data(Plot *plot, const Drawing *drawing, Resolution size)
{
    View view;
    bool lit = drawing->scene.light_count > 0;
    if (view_create(&view, drawing, size)) {
        int highlight = lit ? most(&view, highlight_here) : -1;
        int shadow = lit ? most(&view, shadow_here) : -1;
        spot_data(plot, "highlight", "has_highlight", &view, highlight, size);
        spot_data(plot, "shadow", "has_shadow", &view, shadow, size);
        plot_number(plot, "shadow_first",
                    shadow % view.screen.width <= highlight % view.screen.width);
    }
    view_free(&view);
}

// Two panels, from which the layout leaves room for a line of words above, and three below.
static void side_by_side(Plot *plot, Resolution size)
{
    static const Room rooms[] = {{0.012, 0.494, 0.155, 0.795}, {0.506, 0.988, 0.155, 0.795}};
    plot_look_flat(plot);
    plot_fill_room(plot);
    for (int i = 0; i < 2; i++) {
        plot_panel(plot, i + 1);
        plot_room(plot, rooms[i], rooms[i]);
        plot_fit(plot, vec3_of(0, 0, 0), 0);
        plot_fit(plot, vec3_of(size.width, size.height, 0), 0);
    }
}

// The light can be dragged over the shaded picture: to the side that it comes from. A light of the
// scene becomes a distant one.
static void light_handles(Plot *plot, const Drawing *drawing, Resolution size)
{
    const Scene *scene = &drawing->scene;
    plot_typed(plot, "ambient light", "ambient", number_text(scene->ambient[0]).s);
    if (scene->light_count == 0)
        return;
    vec3 sun = scene->lights[0].position, right = drawing->camera.right, up = drawing->camera.up;
    double reach = 0.45 * fmin(size.width, size.height) / vec3_length(sun);
    plot_panel(plot, 2);
    plot_handle(plot, (Handle){.words = "the light",
                               .place = vec3_of(size.width / 2.0 + reach * vec3_dot(sun, right),
                                                size.height / 2.0 + reach * vec3_dot(sun, up), 0),
                               .option = {"sun"},
                               .count = 3,
                               .value = sun,
                               .along = {right, up},
                               .way = {vec3_of(reach, 0, 0), vec3_of(0, reach, 0)}});
}

// What the command line gives.
typedef struct {
    Drawing drawing;
    Plane plane; // NaN: the figure's own
} Given;

static void flat_and_shaded(Plot *plot, void *given)
{
    Drawing drawing = ((const Given *)given)->drawing;
    Image image;
    Message message;
    bool dragged = plot_is_dragged(plot);
    Resolution size = picture_size(drawing.size, 1);
    if (!image_create(&image, dragged ? picture_size(drawing.size, 8) : size, &message))
        return;
    side_by_side(plot, size);
    plot_number(plot, "columns", size.width);
    plot_number(plot, "rows", size.height);
    plot_number(plot, "ambient", drawing.scene.ambient[0]);
    plot_number(plot, "spheres", drawing.scene.sphere_count);
    spots_data(plot, &drawing, size);
    light_handles(plot, &drawing, size);
    // Two pixels wide for a unit of the canvas, so 16 rays for each: as smooth as the chapter's
    // picture.
    Style style = closing_style;
    style.samples = dragged ? 1 : 2;
    render(&drawing.scene, drawing.camera, style, &image);
    plot_include(plot, "common/figure/pictures.gp");
    plot_picture(plot, "shaded", &image, ROUNDING);
    keep_term(&drawing.scene, TERM_FLAT);
    render(&drawing.scene, drawing.camera, style, &image);
    plot_picture(plot, "flat", &image, ROUNDING);
    image_free(&image);
}

// ---- self-hit -----------------------------------------------------------------------------------

// Why a ray must not start on the surface that it leaves. The numbers are those of a real ray, but
// a rounding error is too small to be seen. So it is drawn as a fifth of the radius, and so is the
// distance of the remedy. Two pictures show what follows, with real rounding errors.
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
    vec3 start = offset_from_surface(sphere, point, normal);
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

// With samples x samples rays a pixel. The rays are the figure's own: a camera that is wrong is not
// what it shows.
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
    const vec3 eye = place + vec3_of(0.011, 0.007, 6);
    const double across = 2.25; // of a square window, 6 before the eye
    Image image;
    Message message;
    const double fine = SIDE * samples;
    if (!image_create(&image, (Resolution){SIDE, SIDE}, &message))
        return;
    for (int i = 0; i < SIDE * SIDE; i++) {
        Color sum = vec3_of(0, 0, 0);
        for (int k = 0; k < samples * samples; k++) {
            double s = (i % SIDE * samples + k % samples + 0.5) / fine,
                   t = 1 - (i / SIDE * samples + k / samples + 0.5) / fine;
            Ray ray = {eye, vec3_of((s - 0.5) * across, (t - 0.5) * across, -6)};
            sum += light_and_dark(&scene, ray, start);
        }
        image_set(&image, (Pixel){i % SIDE, i / SIDE}, sum / (samples * samples));
    }
    plot_picture(plot, name, &image, allowed);
    plot_number(plot, "side", SIDE);
    image_free(&image);
}

// ---- all of it --------------------------------------------------------------------------------

static void self_hit_data(Plot *plot, void *given)
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
    picture_data(plot, "smooth", offset_from_surface, 3, ROUNDING);
}

// ---- in a plane -------------------------------------------------------------------------------

static Plane or_own(const void *given, vec3 light, vec3 eye)
{
    Plane plane = ((const Given *)given)->plane;
    return (Plane){isnan(plane.light[0]) ? light : plane.light,
                   isnan(plane.eye[0]) ? eye : plane.eye};
}

static void surface_vectors_data(Plot *plot, void *given)
{
    Plane plane = or_own(given, vec3_of(-2.4, 1.7, 0), vec3_of(1.5, 1.9, 0));
    surface_vectors(plot, &plane);
}

static void beam_and_lobe_data(Plot *plot, void *given)
{
    Plane plane = or_own(given, vec3_of(-1.5, 1.6, 0), vec3_of(0, 1, 0));
    beam_and_lobe(plot, &plane);
}

static void shadow_and_mirror_data(Plot *plot, void *given)
{
    Plane plane = or_own(given, vec3_of(0.3, 4.2, 0), vec3_of(-4.4, 2.6, 0));
    shadow_and_mirror(plot, &plane);
}

static const Figure figures[] = {
    {"flat-and-shaded", flat_and_shaded},          {"surface-vectors", surface_vectors_data},
    {"beam-and-lobe", beam_and_lobe_data},         {"self-hit", self_hit_data},
    {"shadow-and-mirror", shadow_and_mirror_data}, {0}};

int shading_figure(FigureCommand command, const Drawing *drawing, Plane plane)
{
    Given given = {*drawing, plane};
    return plot_figure(drawing->program, "chapters/07-shading", figures, command, &given);
}
