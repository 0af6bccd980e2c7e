// shown.c - what a figure shows of a scene, by the answers of chapters 04 to 06.
#include "chapters/06-ray-casting/figures/shown.h"

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

// A step that visits all the cells, each far from the one before. So if there is not room for all
// spheres, those that are shown come from all over the picture.
static int stride(int cells)
{
    int step = (int)(0.618 * cells) + 1;
    for (int a = step, b = cells; b != 1 && cells > 1;) {
        int rest = a % b;
        a = b;
        b = rest;
        if (b == 0) { // a common divisor
            a = ++step;
            b = cells;
        }
    }
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
