// shown_data.c - the part of a scene that a figure shows, as data, by the answers of chapters 01 to
// 06.
#include "chapters/06-ray-casting/figures/shown.h"
#include "chapters/shared/camera_drawing.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"

enum { MOST_NAMES = 12, RAY_PLACES = 240, FEW_PLACES = 60, PATCH_PLACES = 72 };

double rgb_number(Color color)
{
    return 65536.0 * byte_from_color(color[0]) + 256.0 * byte_from_color(color[1]) +
           byte_from_color(color[2]);
}

static void spheres(Plot *plot, const Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    plot_number(plot, "balls", shown->sphere_count);
    plot_number(plot, "all_balls", scene->sphere_count);
    plot_block(plot, "spheres", "number x y z radius rgb");
    for (int i = 0; i < shown->sphere_count; i++) {
        int number = shown->spheres[i];
        const Sphere *s = &scene->spheres[number];
        plot_row(plot, 6,
                 (const double[]){number, s->center[0], s->center[1], s->center[2], s->radius,
                                  rgb_number(scene_surface(scene, number)->color)});
        plot_fit(plot, s->center, s->radius);
        plot_ball(plot, s->center, s->radius);
    }
    if (shown->sphere_count == 0) // gnuplot complains about an empty block
        plot_row(plot, 6, (const double[]){0, 0, 0, 0, 0, 0});
    plot_block_end(plot);
}

// The rectangle of a pixel on the image plane.
static void rectangle(Plot *plot, Camera camera, Resolution size, Pixel pixel, double rgb)
{
    static const int corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int i = 0; i < 5; i++) {
        ScreenPoint corner = {pixel.column + corners[i][0], pixel.row + corners[i][1]};
        Normalized place = screen_to_normalized(corner, size);
        vec3 p = camera.origin + image_plane_vector(camera, place.s, place.t);
        plot_row(plot, 6, (const double[]){p[0], p[1], p[2], rgb, pixel.column, pixel.row});
    }
    plot_gap(plot);
}

void shown_cells_begin(Plot *plot, const char *name)
{
    plot_block(plot, name, "x y z of the corners, rgb, column row");
}

void shown_cell(Plot *plot, const Shown *shown, Pixel cell, Color color)
{
    rectangle(plot, shown->camera, shown->grid, cell, rgb_number(color));
}

void shown_cells_end(Plot *plot, const Shown *shown, int cells)
{
    vec3 eye = shown->shot.camera.origin;
    if (cells == 0) // a place without an area
        plot_row(plot, 6, (const double[]){eye[0], eye[1], eye[2], 0, -1, -1});
    plot_block_end(plot);
    plot_number(plot, "cells", cells);
}

void shown_ray(Plot *plot, const char *name, Ray ray, double end, double solid)
{
    int places = plot_is_dragged(plot) ? FEW_PLACES : RAY_PLACES;
    plot_block(plot, name, "x y z t, 1 where it is drawn bold");
    for (int i = 0; i <= places; i++) {
        double t = end * i / places;
        vec3 p = ray.origin + t * ray.direction;
        plot_row(plot, 5, (const double[]){p[0], p[1], p[2], t, t <= solid});
        if (t < solid && end * (i + 1) / places > solid) { // bold exactly up to there
            p = ray.origin + solid * ray.direction;
            plot_row(plot, 5, (const double[]){p[0], p[1], p[2], solid, 1});
        }
    }
    plot_block_end(plot);
    plot_line(plot, ray.origin, ray.origin + end * ray.direction, 0, 0);
    plot_fit(plot, ray.origin + end * ray.direction, 0);
}

// The place where a ray crosses the image plane. Directions have any length, so t may differ from
// 1.
static double plane_t(Camera c, Ray ray)
{
    return c.distance / vec3_dot(ray.direction, c.forward);
}

double shown_end(const Shown *shown)
{
    int hits = shown->hit_count < MOST_HITS ? shown->hit_count : MOST_HITS;
    double end = 1.2 * plane_t(shown->camera, shown->ray);
    for (int i = 0; i < hits; i++)
        if (1.1 * shown->hits[i].t > end)
            end = 1.1 * shown->hits[i].t;
    // A ray that hits nothing is drawn as far as there are spheres.
    for (int i = 0; i < shown->sphere_count && hits == 0; i++) {
        vec3 center = shown->shot.scene->spheres[shown->spheres[i]].center;
        double t = vec3_length(center - shown->ray.origin) / vec3_length(shown->ray.direction);
        if (t > end)
            end = t;
    }
    return end;
}

static void hits(Plot *plot, const Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    bool any = shown->hit_count > 0;
    plot_number(plot, "all_hits", shown->hit_count);
    plot_block(plot, "hits", "x y z t sphere");
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++) {
        Hit hit = shown->hits[i];
        vec3 p = shown->ray.origin + hit.t * shown->ray.direction;
        plot_row_dot(plot, 5, (const double[]){p[0], p[1], p[2], hit.t, hit.sphere});
    }
    // The first hit and the others are drawn separately, and gnuplot complains about an empty
    // block.
    plot_row(plot, 5, (const double[]){NAN, NAN, NAN, NAN, -1});
    plot_row(plot, 5, (const double[]){NAN, NAN, NAN, NAN, -1});
    plot_block_end(plot);
    plot_number(plot, "nearest", any ? shown->hits[0].t : 0);
    plot_text(plot, "nearest_name", any ? sphere_name(shown->hits[0].sphere).s : "");
    plot_number(
        plot, "pixel_rgb",
        rgb_number(any ? scene_surface(scene, shown->hits[0].sphere)->color : scene->background));
}

// A place of a sphere, near the point in the direction 'out' from the centre. It is a share of the
// radius away from that point, in a direction around it. side is a unit vector at right angles to
// out.
static vec3 on_sphere(Sphere s, vec3 out, vec3 side, double share, double angle)
{
    vec3 round = s.radius * cos(angle) * side + sin(angle) * vec3_cross(out, side);
    return s.center + sqrt(1 - share * share) * out + share * round;
}

static bool is_shown(const Shown *shown, int sphere)
{
    for (int i = 0; i < shown->sphere_count; i++)
        if (shown->spheres[i] == sphere)
            return true;
    return false;
}

void shown_patches(Plot *plot, const Shown *shown)
{
    Camera c = shown->camera;
    vec3 names[MOST_HITS];
    int numbers[MOST_HITS], count = 0;
    plot_block(plot, "patches", "x y z rgb");
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++) {
        int number = shown->hits[i].sphere;
        if (!is_sphere(shown->shot.scene, number) || is_shown(shown, number))
            continue;
        Sphere s = shown->shot.scene->spheres[number];
        vec3 hit = shown->ray.origin + shown->hits[i].t * shown->ray.direction;
        vec3 out = hit - s.center;
        vec3 side = fabs(vec3_dot(out, c.right)) < 0.9 * s.radius ? c.right : c.forward;
        side = vec3_unit(side - vec3_dot(side, out) / vec3_dot(out, out) * out);
        double away = 0.2 * vec3_length(hit - c.origin) / s.radius;
        for (int k = 0; k <= PATCH_PLACES; k++) {
            vec3 p = on_sphere(s, out, side, fmin(1, away), 2 * PI * k / PATCH_PLACES);
            double rgb = rgb_number(scene_surface(shown->shot.scene, number)->color);
            plot_row(plot, 4, (const double[]){p[0], p[1], p[2], rgb});
            plot_fit(plot, p, 0);
        }
        plot_gap(plot);
        names[count] = on_sphere(s, out, side, fmin(1, 0.6 * away), 0);
        numbers[count++] = number;
    }
    plot_block_end(plot);
    plot_block(plot, "patch_names", "x y z sphere");
    for (int i = 0; i < count; i++)
        plot_row(plot, 4, (const double[]){names[i][0], names[i][1], names[i][2], numbers[i]});
    plot_block_end(plot);
    plot_number(plot, "patched", count);
}

static void the_pixel(Plot *plot, const Shown *shown)
{
    Shot shot = shown->shot;
    char text[60];
    snprintf(text, sizeof text, "(%d, %d)", shot.pixel.column, shot.pixel.row);
    plot_text(plot, "pixel_text", text);
    snprintf(text, sizeof text, "%d × %d", shot.size.width, shot.size.height);
    plot_text(plot, "size_text", text);
    snprintf(text, sizeof text, "%d × %d", shown->grid.width, shown->grid.height);
    plot_text(plot, "grid_text", text);
    plot_number(plot, "coarse",
                shot.size.width != shown->grid.width || shot.size.height != shown->grid.height);
    plot_block(plot, "pixel", "x y z of the corners, rgb, column row");
    rectangle(plot, shown->camera, shot.size, shot.pixel, 0);
    plot_block_end(plot);
    plot_point(plot, "crossing",
               shown->ray.origin + plane_t(shown->camera, shown->ray) * shown->ray.direction);
}

static void centers(Plot *plot, const Shown *shown)
{
    Resolution grid = shown->grid;
    plot_undrawn(plot); // the lines around the pixels are
    plot_block(plot, "centers", "x y z of the pixels' centres");
    for (int i = 0; i < grid.width * grid.height; i++) {
        Pixel cell = {i % grid.width, i / grid.width};
        Ray ray = ray_to_plane(pixel_ray(shown->shot.camera, grid, cell), shown->camera);
        plot_row_point(plot, ray.origin + ray.direction);
    }
    plot_block_end(plot);
}

// What the picture leaves out, or draws elsewhere.
static void note(Plot *plot, const Shown *shown, double plane_at)
{
    Resolution grid = shown->grid, size = shown->shot.size;
    int all = shown->shot.scene->sphere_count;
    char pixels[80] = "", spheres[80] = "", plane[200] = "", text[400];
    if (grid.width != size.width || grid.height != size.height)
        snprintf(pixels, sizeof pixels, ", %d × %d of %d × %d pixels", grid.width, grid.height,
                 size.width, size.height);
    if (shown->sphere_count < all)
        snprintf(spheres, sizeof spheres, ", %d of %d spheres", shown->sphere_count, all);
    if (plane_at != 1)
        snprintf(plane, sizeof plane, ", the image plane at t = %s", number_text_to(plane_at, 4).s);
    snprintf(text, sizeof text, "%s%s%s", pixels, spheres, plane);
    char words[420] = "";
    if (text[0] != '\0')
        snprintf(words, sizeof words, "Drawn: %s", text + 2);
    plot_text(plot, "drawn_text", words);
    if (words[0] != '\0')
        plot_say(plot, 0, 1, &(Label){.text = "{drawn}", .color = "grey"}, 1);
}

void shown_look(Plot *plot, const Shown *shown)
{
    Camera c = shown->camera;
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_name(plot, (Label){"eye", "blue", .block = "eye"});
    // First those that the ray meets (shown_choose).
    for (int i = 0; i < shown->sphere_count && i < MOST_NAMES; i++) {
        Sphere s = shown->shot.scene->spheres[shown->spheres[i]];
        Text name = sphere_name(shown->spheres[i]);
        plot_name(plot, (Label){name.s, "ink", .place = s.center, .ball = s.radius});
    }
    note(plot, shown, c.distance / shown->shot.camera.distance);
}

static void pixel_handle(Plot *plot, const Shown *shown)
{
    Camera c = shown->camera;
    Resolution size = shown->shot.size;
    Pixel pixel = shown->shot.pixel;
    vec3 corner = image_plane_vector(c, 0, 1);
    vec3 across = (image_plane_vector(c, 1, 1) - corner) / size.width;
    vec3 down = (image_plane_vector(c, 0, 0) - corner) / size.height;
    ScreenPoint middle = pixel_center(pixel);
    plot_handle(plot, (Handle){.words = "the pixel",
                               .place = c.origin + corner + middle.x * across + middle.y * down,
                               .option = {"pixel"},
                               .count = 2,
                               .value = vec3_of(pixel.column, pixel.row, 0),
                               .along = {across, down},
                               .most = {size.width - 1, size.height - 1},
                               .whole = true});
}

Handle shown_sphere(const Shown *shown, vec3 across, vec3 up)
{
    vec3 center = shown->shot.scene->spheres[0].center;
    return (Handle){.words = "the centre of sphere A",
                    .place = center,
                    .option = {"center"},
                    .count = 3,
                    .value = center,
                    .along = {across, up}};
}

void shown_data(Plot *plot, const Shown *shown)
{
    Shot shot = shown->shot;
    plane_data(plot, shown->camera, shown->grid.width, shown->grid.height);
    plot_number(plot, "plane_t", shown->camera.distance / shot.camera.distance);
    plot_direction(plot, "at", shot.camera.origin);
    spheres(plot, shown);
    centers(plot, shown);
    the_pixel(plot, shown);
    shown_ray(plot, "ray", shown->ray, shown_end(shown),
              shown->hit_count > 0 ? shown->hits[0].t : shown_end(shown));
    hits(plot, shown);
    pixel_handle(plot, shown);
    if (is_shown(shown, 0))
        plot_handle(plot, shown_sphere(shown, shown->camera.right, shown->camera.up));
}
