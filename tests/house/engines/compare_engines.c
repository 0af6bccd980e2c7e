// compare_engines.c - the engines of chapter 08, each against one and the same picture.
#include "tests/house/engines/compare_engines.h"

#include "chapters/08-fast/engines/lanes.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int passed, failed;

void against_fail(const char *name, const char *why)
{
    failed++;
    printf("not ok: %s: %s\n", name, why);
}

int against_end(const char *name)
{
    printf("%s: %d passed, %d failed\n", name, passed, failed);
    return failed > 0;
}

// ---- whole pictures --------------------------------------------------------------------------

static void compare(const char *name, const Engine *engine, const Work *right, int threads)
{
    char who[200];
    snprintf(who, sizeof who, "%s, %s for %s, %d threads", name, engine->name,
             lanes_names[lanes_best()], threads);
    Message message;
    Image image;
    Work work = *right;
    work.image = &image;
    work.threads = threads;
    if (!image_create(&image, right->image->size, &message)) {
        against_fail(who, message.text);
        return;
    }
    // No engine may rely on what was in the image.
    size_t pixels = (size_t)image.size.width * (size_t)image.size.height;
    memset(image.rgb, 0xa5, 3 * pixels);
    bool cast = engine->cast(&work, &message);
    size_t different = 0, first = 0;
    for (size_t i = pixels; cast && i-- > 0;)
        if (memcmp(image.rgb + 3 * i, right->image->rgb + 3 * i, 3) != 0) {
            different++;
            first = i;
        }
    char why[120];
    snprintf(why, sizeof why, "%zu of %zu pixels differ, first (%zu, %zu)", different, pixels,
             first % (size_t)image.size.width, first / (size_t)image.size.width);
    if (cast && different == 0)
        passed++;
    else
        against_fail(who, !cast ? message.text : why);
    image_free(&image);
}

static bool has_lanes(const Engine *engine)
{
    static const char *const with_lanes[] = {"packet", "tiles", "bins"};
    for (size_t i = 0; i < sizeof with_lanes / sizeof with_lanes[0]; i++)
        if (strcmp(engine->name, with_lanes[i]) == 0)
            return true;
    return false;
}

// Engines that are not compiled for several instruction sets are tried with one.
void against_all(const char *name, const Engine *first, const Work *right, const int *threads,
                 How how)
{
    lanes_at_most = LANES_AVX512;
    const int best = (int)lanes_best();
    const int *turn = threads;
    for (const Engine *engine = first; engine->name != NULL; engine++) {
        for (int kind = has_lanes(engine) && how != BEST_SET ? LANES_BASELINE : best; kind <= best;
             kind++) {
            lanes_at_most = (LanesKind)kind;
            for (const int *n = threads; how == EACH && *n > 0; n++)
                compare(name, engine, right, *n);
            if (how != EACH) {
                compare(name, engine, right, *turn);
                turn = turn[1] > 0 ? turn + 1 : threads;
            }
        }
    }
    lanes_at_most = LANES_AVX512;
}

// ---- rows ------------------------------------------------------------------------------------

// The spheres that a row's rays may hit. All its rays lie in a plane through the eye; what is
// farther from the plane than its radius is not hit. In their order, so that ties are the same.
static int near_row(const Work *work, int row, Sphere *near)
{
    Resolution screen = work->image->size;
    Camera camera = work->camera;
    vec3 ray = pixel_ray(camera, screen, (Pixel){0, row}).direction;
    vec3 normal = vec3_unit(vec3_cross(ray, camera.right));
    int count = 0;
    for (int i = 0; i < work->scene->sphere_count; i++) {
        Sphere sphere = work->scene->spheres[i];
        vec3 c = sphere.center - camera.origin;
        if (fabs(vec3_dot(c, normal)) <= sphere.radius * (1 + 1e-6) + 1e-7 * vec3_length(c))
            near[count++] = sphere;
    }
    return count;
}

// How many pixels of a row are not chapter 06's.
static int wrong_in_row(const Work *right, const Scene *near, int row)
{
    Resolution screen = right->image->size;
    int wrong = 0;
    for (int column = 0; column < screen.width; column++) {
        Hit hit = nearest_hit(pixel_ray(right->camera, screen, (Pixel){column, row}), near);
        Color color = hit.sphere < 0 ? near->background : scene_surface(near, hit.sphere)->color;
        size_t pixel = (size_t)row * (size_t)screen.width + (size_t)column;
        for (int i = 0; i < 3; i++)
            if (right->image->rgb[3 * pixel + (size_t)i] != byte_from_color(color[i])) {
                wrong++;
                break;
            }
    }
    return wrong;
}

void against_rows(const char *name, const Work *right, int rows, double tests)
{
    Scene near = *right->scene;
    near.spheres = malloc(((size_t)near.sphere_count + 1) * sizeof *near.spheres);
    if (near.spheres == NULL) {
        against_fail(name, "no memory for its rows");
        return;
    }
    // Steps of the golden section come near every row, and to none twice for long.
    const int height = right->image->size.height;
    double done = 0, place = 0.5;
    for (int i = 0; i < rows && i < height && done < tests; i++) {
        int row = (int)(place * height);
        place = fmod(place + 0.61803398874989485, 1);
        near.sphere_count = near_row(right, row, near.spheres);
        done += (double)near.sphere_count * right->image->size.width;
        int wrong = wrong_in_row(right, &near, row);
        char why[80];
        snprintf(why, sizeof why, "%d pixels of row %d are not chapter 06's", wrong, row);
        if (wrong == 0)
            passed++;
        else
            against_fail(name, why);
    }
    free(near.spheres);
}
