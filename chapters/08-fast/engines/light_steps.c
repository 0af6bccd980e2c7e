// light_steps.c - the steps of a path by the chapters' functions, and whether the lanes agree.
#include "chapters/08-fast/engines/light_steps.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"
#include "exercises/07-shading.h"

#include <stdlib.h>
#include <string.h>

Material *materials_of(const Scene *scene)
{
    Material *materials = malloc(((size_t)scene->surface_count + 1) * sizeof *materials);
    for (int i = 0; i < scene->surface_count && materials != NULL; i++) {
        const Surface *surface = &scene->surfaces[i];
        Material *material = &materials[i];
        *material = (Material){
            .diffuse = surface->diffuse, .specular = surface->specular, .shine = surface->shine};
        for (int k = 0; k < 3; k++) {
            material->color[k] = surface->color[k];
            material->ambient[k] = surface->diffuse * surface->color[k] * scene->ambient[k];
        }
    }
    return materials;
}

void take_spheres(const Scene *scene, Paths *paths)
{
    for (int i = 0; i < paths->count; i++) {
        const Sphere *sphere = &scene->spheres[paths->sphere[i]];
        set_vector(&paths->center, i, sphere->center);
        paths->radius[i] = sphere->radius;
        paths->surface[i] = sphere->surface;
    }
}

// ---- by the chapters' functions ---------------------------------------------------------------

static Sphere sphere_of(const Paths *paths, int i)
{
    return (Sphere){vector_of(&paths->center, i), paths->radius[i], paths->surface[i]};
}

static void rays(const Picture *picture, const int *columns, const int *rows, Paths *paths)
{
    for (int i = 0; i < paths->count; i++) {
        Pixel sample = {columns[i], rows[i]};
        Ray ray = pixel_ray(picture->camera, picture->samples, sample);
        set_vector(&paths->origin, i, ray.origin);
        set_vector(&paths->direction, i, ray.direction);
    }
}

static void may_hit(const Paths *paths, const double *spheres, int sphere_count, int *may)
{
    (void)spheres;
    for (int i = 0; i < paths->count; i++)
        may[i] = (1 << sphere_count) - 1;
}

static bool hits(Paths *paths)
{
    for (int i = 0; i < paths->count; i++)
        paths->t[i] = hit_sphere(ray_of(paths, i), sphere_of(paths, i));
    return true;
}

static void leave(Paths *paths)
{
    for (int i = 0; i < paths->count; i++) {
        Ray ray = ray_of(paths, i);
        Sphere sphere = sphere_of(paths, i);
        vec3 point = ray.origin + paths->t[i] * ray.direction;
        vec3 normal = surface_normal(sphere, point);
        normal = vec3_dot(normal, ray.direction) > 0 ? -normal : normal;
        set_vector(&paths->point, i, point);
        set_vector(&paths->normal, i, normal);
        set_vector(&paths->start, i, off_surface(sphere, point, normal));
    }
}

static void to_light(const Paths *paths, const Light *light, Vectors *directions)
{
    for (int i = 0; i < paths->count; i++)
        set_vector(directions, i, ray_to_light(vector_of(&paths->start, i), *light).direction);
}

// Chapter 07's shade lights a scene of one sphere, with one light after the other that arrives. A
// hidden light would add 0.
static void shade_all(const Picture *picture, const Paths *paths, const double *lit,
                      Vectors *colors)
{
    Scene alone = *picture->scene;
    Light *lights = malloc(((size_t)alone.light_count + 1) * sizeof *lights);
    alone.sphere_count = 1;
    for (int i = 0; i < paths->count; i++) {
        Sphere sphere = sphere_of(paths, i);
        alone.spheres = &sphere;
        alone.lights = lights;
        alone.light_count = 0;
        for (int k = 0; k < picture->scene->light_count && lights != NULL; k++)
            if (lit[k * PATHS + i] != 0)
                lights[alone.light_count++] = picture->scene->lights[k];
        set_vector(colors, i, shade(&alone, ray_of(paths, i), (Hit){paths->t[i], 0}));
    }
    free(lights);
}

static void mirror(const Paths *paths, Vectors *directions)
{
    for (int i = 0; i < paths->count; i++)
        set_vector(directions, i,
                   mirror_direction(vector_of(&paths->direction, i), vector_of(&paths->normal, i)));
}

static void add_mirrors(const Vectors *mirrored, const double *parts, int count, Vectors *colors)
{
    for (int i = 0; i < count; i++)
        if (parts[i] > 0)
            set_vector(colors, i, vector_of(colors, i) + parts[i] * vector_of(mirrored, i));
}

static void means(double *const colors[3], int samples, int pixels, Vectors *means)
{
    for (int k = 0; k < pixels; k++) {
        Color sum = vec3_of(0, 0, 0);
        for (int i = k; i < samples * PATHS; i += PATHS)
            sum += clamp_color(vec3_of(colors[0][i], colors[1][i], colors[2][i]));
        set_vector(means, k, sum / samples);
    }
}

static void bytes(const Vectors *colors, int count, uint8_t *rgb)
{
    for (int i = 0; i < count; i++) {
        rgb[3 * i] = byte_from_color(colors->x[i]);
        rgb[3 * i + 1] = byte_from_color(colors->y[i]);
        rgb[3 * i + 2] = byte_from_color(colors->z[i]);
    }
}

const LightSteps steps_by_chapters = {rays,      may_hit, hits,        leave, to_light,
                                      shade_all, mirror,  add_mirrors, means, bytes};

// ---- whether the lanes agree ------------------------------------------------------------------

static bool same(const double *one, const double *other, int count)
{
    return memcmp(one, other, (size_t)count * sizeof *one) == 0;
}

static bool same_vectors(const Vectors *one, const Vectors *other, int count)
{
    return same(one->x, other->x, count) && same(one->y, other->y, count) &&
           same(one->z, other->z, count);
}

// Samples all over the picture.
static bool agree_on_rays(const LightSteps *steps, const Picture *picture, Paths *one, Paths *other)
{
    int columns[PATHS], rows[PATHS];
    one->count = other->count = PATHS;
    for (int i = 0; i < PATHS; i++) {
        columns[i] = (int)((i % 16 + 0.5) / 16 * picture->samples.width);
        rows[i] = (int)((i / 16 + 0.5) / 16 * picture->samples.height);
    }
    steps_by_chapters.rays(picture, columns, rows, one);
    steps->rays(picture, columns, rows, other);
    return same_vectors(&one->origin, &other->origin, PATHS) &&
           same_vectors(&one->direction, &other->direction, PATHS);
}

// Rays to spheres all over the scene: from the eye, past the middle, and every fourth one from
// inside its sphere.
static void set_rays_to_spheres(const Picture *picture, Paths *paths)
{
    const Scene *scene = picture->scene;
    for (int i = 0; i < PATHS; i++) {
        paths->sphere[i] = (int)((double)i / PATHS * scene->sphere_count);
        const Sphere *sphere = &scene->spheres[paths->sphere[i]];
        vec3 aside = sphere->radius * vec3_of(i % 7 - 3, i % 5 - 2, i % 3 - 1) / 5;
        vec3 from = i % 4 == 3 ? sphere->center + aside : picture->camera.origin;
        vec3 to = i % 4 == 3 ? sphere->center - 2 * aside : sphere->center + aside;
        if (vec3_dot(to - from, to - from) == 0)
            to = from + picture->camera.forward;
        set_vector(&paths->origin, i, from);
        set_vector(&paths->direction, i, to - from);
    }
    paths->count = PATHS;
    take_spheres(scene, paths);
}

// All rays that meet their spheres remain in both.
static bool agree_on_hits(const LightSteps *steps, const Picture *picture, Paths *one, Paths *other)
{
    set_rays_to_spheres(picture, one);
    *other = *one;
    steps_by_chapters.hits(one);
    if (steps->hits(other) && !same(one->t, other->t, PATHS))
        return false;
    int count = 0;
    for (int i = 0; i < PATHS; i++)
        if (one->t[i] < NO_HIT) {
            one->sphere[count] = one->sphere[i];
            set_vector(&one->origin, count, vector_of(&one->origin, i));
            set_vector(&one->direction, count, vector_of(&one->direction, i));
            one->t[count++] = one->t[i];
        }
    one->count = count;
    take_spheres(picture->scene, one);
    *other = *one;
    return true;
}

static bool agree_on_leaving(const LightSteps *steps, const Picture *picture, Paths *one,
                             Paths *other)
{
    int count = one->count;
    steps_by_chapters.leave(one);
    steps->leave(other);
    Vectors these, those;
    bool agree = same_vectors(&one->point, &other->point, count) &&
                 same_vectors(&one->normal, &other->normal, count) &&
                 same_vectors(&one->start, &other->start, count);
    for (int i = 0; i < picture->scene->light_count && agree; i++) {
        steps_by_chapters.to_light(one, &picture->scene->lights[i], &these);
        steps->to_light(other, &picture->scene->lights[i], &those);
        agree = same_vectors(&these, &those, count);
    }
    steps_by_chapters.mirror(one, &these);
    steps->mirror(other, &those);
    return agree && same_vectors(&these, &those, count);
}

// One light at a time, then without any. A light arrives unless the sphere hides it from itself.
static bool agree_on_light(const LightSteps *steps, const Picture *picture, const Paths *paths)
{
    Scene scene = *picture->scene;
    Picture single = *picture;
    double lit[PATHS];
    Vectors these, those;
    single.scene = &scene;
    for (int k = 0; k <= picture->scene->light_count; k++) {
        scene.light_count = k < picture->scene->light_count;
        scene.lights = picture->scene->lights + k;
        for (int i = 0; i < paths->count && scene.light_count > 0; i++) {
            Sphere sphere = sphere_of(paths, i);
            Scene alone = {.spheres = &sphere, .sphere_count = 1};
            lit[i] = visibility(&alone, vector_of(&paths->start, i), *scene.lights) > 0;
        }
        steps_by_chapters.shade(&single, paths, lit, &these);
        steps->shade(&single, paths, lit, &those);
        if (!same_vectors(&these, &those, paths->count))
            return false;
    }
    return true;
}

// Pixels of two samples, from black to too bright.
static bool agree_on_pixels(const LightSteps *steps)
{
    double color[2 * PATHS];
    double *const colors[3] = {color, color + 64, color + PATHS / 2};
    enum { PIXELS = PATHS / 4 };
    Vectors these, those;
    uint8_t one[3 * PIXELS], other[3 * PIXELS];
    for (int i = 0; i < 2 * PATHS; i++)
        color[i] = (double)(i * 37 % (2 * PATHS)) / PATHS - 0.25;
    steps_by_chapters.means(colors, 2, PIXELS, &these);
    steps->means(colors, 2, PIXELS, &those);
    steps_by_chapters.bytes(&these, PIXELS, one);
    steps->bytes(&those, PIXELS, other);
    return same_vectors(&these, &those, PIXELS) && memcmp(one, other, sizeof one) == 0;
}

const LightSteps *steps_for(const Picture *picture)
{
    static const LightSteps *const lanes[LANES_KINDS] = LANES_TABLE(light_steps);
    const LightSteps *steps = lanes[lanes_best()];
    Paths *paths = aligned_alloc(alignof(Paths), 2 * sizeof *paths);
    bool agree =
        paths != NULL && agree_on_rays(steps, picture, paths, paths + 1) && agree_on_pixels(steps);
    if (agree && picture->scene->sphere_count > 0)
        agree = agree_on_hits(steps, picture, paths, paths + 1) &&
                agree_on_leaving(steps, picture, paths, paths + 1) &&
                agree_on_light(steps, picture, paths);
    free(paths);
    return agree ? steps : &steps_by_chapters;
}
