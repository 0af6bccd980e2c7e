// shown.c - what a figure shows of a scene, by the answers of chapters 04 to 06.
#include "chapters/06-ray-casting/figures/figures.h"

#include "chapters/shared/camera_drawing.h"
#include "exercises/01-corners.h"
#include "exercises/03-screen.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"

#include <string.h>

enum { COARSE = 16 };

Text sphere_name(int sphere)
{
    Text name = {""};
    char *s = name.s + 8;
    *s = '\0';
    for (int i = sphere; i >= 0; i = i / 26 - 1)
        *--s = (char)('A' + i % 26);
    memmove(name.s, s, strlen(s) + 1);
    return name;
}

bool is_sphere(const Scene *scene, int sphere)
{
    return sphere >= 0 && sphere < scene->sphere_count;
}

int hits_of(Ray ray, const Scene *scene, Hit *hits, int room)
{
    int count = 0;
    Hit nearest = nearest_hit(ray, scene);
    bool any = is_sphere(scene, nearest.sphere) && nearest.t < NO_HIT;
    if (any)
        hits[count++] = nearest;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (!(t < NO_HIT) || (any && i == nearest.sphere))
            continue;
        int place = count < room ? count : room;
        for (; place > any && t < hits[place - 1].t; place--)
            if (place < room)
                hits[place] = hits[place - 1];
        if (place < room)
            hits[place] = (Hit){t, i};
        count++;
    }
    return count;
}

// A picture of the same shape with fewer pixels, if there are too many to draw.
static Resolution grid_of(Resolution size)
{
    int longer = size.width > size.height ? size.width : size.height;
    if (longer <= MOST_CELLS)
        return size;
    Resolution grid = {(size.width * COARSE + longer / 2) / longer,
                       (size.height * COARSE + longer / 2) / longer};
    return (Resolution){grid.width > 0 ? grid.width : 1, grid.height > 0 ? grid.height : 1};
}

static int hits_through(const Shown *shown, Pixel cell)
{
    const Scene *scene = shown->shot.scene;
    Ray ray = pixel_ray(shown->shot.camera, shown->grid, cell);
    int count = 0;
    for (int i = 0; i < scene->sphere_count; i++)
        count += hit_sphere(ray, scene->spheres[i]) < NO_HIT;
    return count;
}

// The pixel in the middle of the cell whose ray meets the most spheres; of several, one near the
// middle.
static Pixel telling_pixel(const Shown *shown)
{
    Resolution grid = shown->grid, size = shown->shot.size;
    double best = -1;
    Pixel cell = {0, 0};
    for (int i = 0; i < grid.width * grid.height; i++) {
        Pixel here = {i % grid.width, i / grid.width};
        double aside = (here.column + 0.5) / grid.width - 0.5;
        double up = (here.row + 0.5) / grid.height - 0.5;
        double score = hits_through(shown, here) - (aside * aside + up * up);
        if (score > best) {
            best = score;
            cell = here;
        }
    }
    return (Pixel){(2 * cell.column + 1) * size.width / (2 * grid.width),
                   (2 * cell.row + 1) * size.height / (2 * grid.height)};
}

// Seen from inside or close beside, a sphere has no outline, or one that leaves no room for others.
static bool can_be_drawn(const Shown *shown, const Sphere *sphere)
{
    double away = vec3_length(sphere->center - shown->shot.camera.origin) - sphere->radius;
    return away > 0 && sphere->radius < 6 * away;
}

static void show_sphere(Shown *shown, int sphere)
{
    if (!is_sphere(shown->shot.scene, sphere) || shown->sphere_count >= MOST_SPHERES ||
        !can_be_drawn(shown, &shown->shot.scene->spheres[sphere]))
        return;
    for (int i = 0; i < shown->sphere_count; i++)
        if (shown->spheres[i] == sphere)
            return;
    shown->spheres[shown->sphere_count++] = sphere;
}

// A scene may have its image plane among its spheres, where it would hide half of them, or so near
// to the eye, for what it shows, that nobody sees it; and with a wide angle it is larger than all
// else. Nearer to the eye, or farther, and smaller or larger by the same factor, it makes the same
// rays (chapter 01).
static Camera with_plane_before_spheres(const Shown *shown)
{
    Camera c = shown->shot.camera;
    double room = INFINITY; // before the first sphere
    for (int i = 0; i < shown->sphere_count; i++) {
        Sphere s = shown->shot.scene->spheres[shown->spheres[i]];
        double ahead = vec3_dot(s.center - c.origin, c.forward) - s.radius;
        if (ahead > 0 && ahead < room)
            room = ahead;
    }
    double diagonal = hypot(c.width, c.height) / c.distance;
    bool fits = c.distance <= room && c.distance >= room / 8 && c.distance * diagonal <= 3 * room;
    if (!isfinite(room) || fits)
        return c;
    double factor = fmin(0.6 * room, room / diagonal) / c.distance;
    c.distance *= factor;
    c.width *= factor;
    c.height *= factor;
    return c;
}

// If no drawn pixel sees a sphere, the one nearest to the middle of the picture: so the plane is
// before it, and the figure shows why.
static void show_one_at_least(Shown *shown)
{
    const Scene *scene = shown->shot.scene;
    Camera c = shown->shot.camera;
    double best = 0;
    int sphere = -1;
    for (int i = 0; i < scene->sphere_count && shown->sphere_count == 0; i++) {
        double cosine = vec3_dot(vec3_unit(scene->spheres[i].center - c.origin), c.forward);
        if (cosine > best && can_be_drawn(shown, &scene->spheres[i])) {
            best = cosine;
            sphere = i;
        }
    }
    show_sphere(shown, sphere);
}

static int common_divisor(int a, int b)
{
    return b == 0 ? a : common_divisor(b, a % b);
}

// A step that visits all the cells, each far from the one before. So if there is not room for all
// spheres, those that are shown come from all over the picture.
static int stride(int cells)
{
    int step = (int)(0.618 * cells) + 1;
    while (common_divisor(step, cells) > 1)
        step++;
    return step;
}

void shown_choose(Shown *shown, Shot shot)
{
    *shown = (Shown){.shot = shot, .grid = grid_of(shot.size)};
    if (shot.pixel.column < 0)
        shown->shot.pixel = telling_pixel(shown);
    shown->ray = ray_to_plane(pixel_ray(shot.camera, shot.size, shown->shot.pixel), shot.camera);
    shown->hit_count = hits_of(shown->ray, shot.scene, shown->hits, MOST_HITS);
    for (int i = 0; i < shown->hit_count && i < MOST_HITS; i++)
        show_sphere(shown, shown->hits[i].sphere);
    int cells = shown->grid.width * shown->grid.height, step = stride(cells);
    for (int i = 0; i < cells; i++) {
        int there = (int)((long)i * step % cells);
        Pixel cell = {there % shown->grid.width, there / shown->grid.width};
        show_sphere(shown,
                    nearest_hit(pixel_ray(shot.camera, shown->grid, cell), shot.scene).sphere);
    }
    show_one_at_least(shown);
    shown->camera = with_plane_before_spheres(shown);
}

void shown_only(Shown *shown, int sphere)
{
    shown->sphere_count = 0;
    show_sphere(shown, sphere);
    shown->camera = with_plane_before_spheres(shown);
}

// ---- as data, by the answers of chapters 01 to 06 -----------------------------------------------

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
        plot_row(plot, number, s->center[0], s->center[1], s->center[2], s->radius,
                 rgb_number(scene_surface(scene, number)->color));
        plot_fit(plot, s->center, s->radius);
        plot_ball(plot, s->center, s->radius);
    }
    if (shown->sphere_count == 0) // gnuplot complains about an empty block
        plot_row(plot, 0, 0, 0, 0, 0, 0);
}

// The rectangle of a pixel on the image plane.
static void rectangle(Plot *plot, Camera camera, Resolution size, Pixel pixel, double rgb)
{
    static const int corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int i = 0; i < 5; i++) {
        ScreenPoint corner = {pixel.column + corners[i][0], pixel.row + corners[i][1]};
        Normalized place = screen_to_normalized(corner, size);
        vec3 p = camera.origin + image_plane_vector(camera, place.s, place.t);
        plot_row_at(plot, p, rgb, pixel.column, pixel.row);
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
        plot_row_at(plot, eye, 0, -1, -1);
    plot_number(plot, "cells", cells);
}

void shown_ray(Plot *plot, const char *name, Ray ray, double end, double solid)
{
    int places = plot_is_dragged(plot) ? FEW_PLACES : RAY_PLACES;
    plot_block(plot, name, "x y z t, 1 where it is drawn bold");
    for (int i = 0; i <= places; i++) {
        double t = end * i / places;
        vec3 p = ray.origin + t * ray.direction;
        plot_row_at(plot, p, t, t <= solid);
        if (t < solid && end * (i + 1) / places > solid) { // bold exactly up to there
            p = ray.origin + solid * ray.direction;
            plot_row_at(plot, p, solid, 1);
        }
    }
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
        plot_row_dot(plot, p, hit.t, hit.sphere);
    }
    // The first hit and the others are drawn separately, and gnuplot complains about an empty
    // block.
    plot_row(plot, NAN, NAN, NAN, NAN, -1);
    plot_row(plot, NAN, NAN, NAN, NAN, -1);
    plot_number(plot, "nearest", any ? shown->hits[0].t : 0);
    plot_text(plot, "nearest_name", any ? sphere_name(shown->hits[0].sphere).s : "");
    plot_number(
        plot, "pixel_rgb",
        rgb_number(any ? scene_surface(scene, shown->hits[0].sphere)->color : scene->background));
}

// A place of a sphere, near the point in the direction 'out' from the center. It is a share of the
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
            plot_row_at(plot, p, rgb);
            plot_fit(plot, p, 0);
        }
        plot_gap(plot);
        names[count] = on_sphere(s, out, side, fmin(1, 0.6 * away), 0);
        numbers[count++] = number;
    }
    plot_block(plot, "patch_names", "x y z sphere");
    for (int i = 0; i < count; i++)
        plot_row_at(plot, names[i], numbers[i]);
    plot_number(plot, "patched", count);
}

static void the_pixel(Plot *plot, const Shown *shown)
{
    Shot shot = shown->shot;
    plot_text(plot, "pixel_text", text_of("(%d, %d)", shot.pixel.column, shot.pixel.row).s);
    plot_text(plot, "size_text", text_of("%d × %d", shot.size.width, shot.size.height).s);
    plot_text(plot, "grid_text", text_of("%d × %d", shown->grid.width, shown->grid.height).s);
    plot_number(plot, "coarse",
                shot.size.width != shown->grid.width || shot.size.height != shown->grid.height);
    plot_block(plot, "pixel", "x y z of the corners, rgb, column row");
    rectangle(plot, shown->camera, shot.size, shot.pixel, 0);
    plot_point(plot, "crossing",
               shown->ray.origin + plane_t(shown->camera, shown->ray) * shown->ray.direction);
}

static void centers(Plot *plot, const Shown *shown)
{
    Resolution grid = shown->grid;
    plot_undrawn(plot); // the lines around the pixels are
    plot_block(plot, "centers", "x y z of the pixels' centers");
    for (int i = 0; i < grid.width * grid.height; i++) {
        Pixel cell = {i % grid.width, i / grid.width};
        Ray ray = ray_to_plane(pixel_ray(shown->shot.camera, grid, cell), shown->camera);
        plot_row_point(plot, ray.origin + ray.direction);
    }
}

// What the picture leaves out, or draws elsewhere.
static void note(Plot *plot, const Shown *shown, double plane_at)
{
    Resolution grid = shown->grid, size = shown->shot.size;
    int all = shown->shot.scene->sphere_count;
    Text words = {""};
    if (grid.width != size.width || grid.height != size.height)
        words = text_of(", %d × %d of %d × %d pixels", grid.width, grid.height, size.width,
                        size.height);
    if (shown->sphere_count < all)
        words = text_of("%s, %d of %d spheres", words.s, shown->sphere_count, all);
    if (plane_at != 1)
        words = text_of("%s, the image plane at t = %s", words.s, number_shown(plane_at).s);
    if (words.s[0] != '\0')
        words = text_of("Drawn: %s", words.s + 2);
    plot_text(plot, "drawn_text", words.s);
    plot_say(plot, 0, 1, {.text = words.s[0] != '\0' ? "{drawn}" : "", .color = "grey"});
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
    vec3 corner = image_plane_vector(c, 0, 1);
    vec3 across = (image_plane_vector(c, 1, 1) - corner) / size.width;
    vec3 down = (image_plane_vector(c, 0, 0) - corner) / size.height;
    ScreenPoint middle = pixel_center(shown->shot.pixel);
    plot_handle_pixel(plot, c.origin + corner + middle.x * across + middle.y * down,
                      shown->shot.pixel, size, across, down);
}

Handle shown_sphere(const Shown *shown, vec3 across, vec3 up)
{
    vec3 center = shown->shot.scene->spheres[0].center;
    return (Handle){"the center of sphere A", center, {"center"}, 3, center, .along = {across, up}};
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

// ---- the outline of a sphere --------------------------------------------------------------------

enum { OUTLINE_PLACES = 72, LINES = 6, LINE_PLACES = 160, SHORT_PLACES = 40 };

// A place of the circle that is the sphere's outline, seen from the eye. There the line of sight
// touches the sphere, at right angles to its radius.
static vec3 outline_place(Camera c, Sphere sphere, double angle)
{
    vec3 axis = sphere.center - c.origin;
    double away = vec3_length(axis);
    double flat = sphere.radius / away;
    vec3 aside =
        vec3_unit(vec3_cross(fabs(vec3_dot(axis, c.up)) < 0.9 * away ? c.up : c.right, axis));
    vec3 up = vec3_unit(vec3_cross(axis, aside));
    return c.origin + (1 - flat * flat) * axis +
           sphere.radius * sqrt(1 - flat * flat) * (cos(angle) * aside + sin(angle) * up);
}

// The place where a line of sight crosses the image plane. NaN if the line goes backwards, or
// crosses far beside the plane, as the outline of a ground does.
static vec3 on_plane(Camera c, vec3 v)
{
    vec3 place = c.distance / vec3_dot(v, c.forward) * v;
    bool near = vec3_dot(v, c.forward) > 0 && fabs(vec3_dot(place, c.right)) <= c.width &&
                fabs(vec3_dot(place, c.up)) <= c.height;
    return near ? c.origin + place : vec3_of(NAN, NAN, NAN);
}

static vec3 line_of_sight(Camera c, Sphere sphere, int i)
{
    return outline_place(c, sphere, 2 * PI * i / OUTLINE_PLACES) - c.origin;
}

void outline_on_plane(Plot *plot, const char *name, Camera c, Sphere sphere)
{
    plot_block(plot, name, "x y z of the outline on the image plane");
    for (int i = 0; i <= OUTLINE_PLACES; i++)
        plot_row_point(plot, on_plane(c, line_of_sight(c, sphere, i)));
}

// Half way along a line of sight to the plane. It must be a separate function: inside the loop that
// calls it, gcc 14 to 16 stop with an internal compiler error (-O2).
static void arrow_head(Plot *plot, Camera c, vec3 v)
{
    double ahead = vec3_dot(v, c.forward);
    vec3 w = (ahead > 0 ? fmin(1, c.distance / ahead) : 1) * v, p = c.origin + 0.8 * w;
    plot_row_vector(plot, p, -0.3 * w);
}

void lines_to_eye(Plot *plot, const char *lines_name, const char *heads, Camera c, Sphere sphere,
                  bool drawn)
{
    int near[OUTLINE_PLACES], count = 0, lines = 0;
    for (int i = 0; i < OUTLINE_PLACES; i++)
        if (!isnan(on_plane(c, line_of_sight(c, sphere, i))[0]))
            near[count++] = i;
    vec3 v[LINES];
    double part[LINES];
    for (int i = 0; i < LINES && count > 0; i++) {
        vec3 whole = line_of_sight(c, sphere, near[(4 * i + 1) * count / (4 * LINES)]);
        part[i] = drawn ? 1 : fmin(1, 1.6 * c.distance / vec3_dot(whole, c.forward));
        v[i] = part[i] * whole;
        lines++;
    }
    int places = plot_is_dragged(plot) ? SHORT_PLACES : LINE_PLACES;
    plot_block(plot, lines_name, "x y z t, 1 where it is drawn bold");
    for (int i = 0; i < lines; i++) {
        for (int k = 0; k <= places; k++) {
            vec3 p = c.origin + (double)k / places * v[i];
            plot_row_at(plot, p, part[i] * k / places, 1);
        }
        plot_gap(plot);
        plot_line(plot, c.origin, c.origin + v[i], 0, 0);
    }
    plot_block(plot, heads, "x y z of the start, x y z of the vector");
    for (int i = 0; i < lines; i++)
        arrow_head(plot, c, v[i]);
}
