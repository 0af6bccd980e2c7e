// figures.c - the data of the figures of chapter 07.
#include "chapters/07-shading/figures/figures.h"

#include "chapters/shared/render.h"
#include "common/camera.h"
#include "common/figure/plot.h"
#include "exercises/04-pixel-ray.h"
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
    plot_row(plot, x * size.width, y * size.height);
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

// Two panels, from which the layout leaves room for a line of words above, and two below.
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
    if (scene->light_count > 0) {
        vec3 sun = scene->lights[0].position, right = drawing->camera.right;
        vec3 up = drawing->camera.up;
        double reach = 0.45 * fmin(size.width, size.height) / vec3_length(sun);
        plot_panel(plot, 2);
        plot_handle(plot,
                    (Handle){.words = "the light",
                             .place = vec3_of(size.width / 2.0 + reach * vec3_dot(sun, right),
                                              size.height / 2.0 + reach * vec3_dot(sun, up), 0),
                             .option = {"sun"},
                             .count = 3,
                             .value = sun,
                             .along = {right, up},
                             .way = {vec3_of(reach, 0, 0), vec3_of(0, reach, 0)}});
    }
    plot_handle(plot, (Handle){.words = "ambient light",
                               .option = {"ambient"},
                               .count = 1,
                               .value = scene->ambient,
                               .typed = true});
}

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
    plot_picture(plot, "shaded", &image, COLOR_ROUNDING);
    keep_term(&drawing.scene, TERM_FLAT);
    render(&drawing.scene, drawing.camera, style, &image);
    plot_picture(plot, "flat", &image, COLOR_ROUNDING);
    image_free(&image);
}

// ---- all of them ------------------------------------------------------------------------------

const Figure shading_figures[] = {
    {"flat-and-shaded", flat_and_shaded},     {"surface-vectors", surface_vectors},
    {"beam-and-lobe", beam_and_lobe},         {"self-hit", self_hit},
    {"shadow-and-mirror", shadow_and_mirror}, {0}};
