// shading.c - chapter 07's pictures: shadows and mirrors.
//
// With plain, every ray asks every sphere. With bvh, the bins of step 6 find the spheres that the
// eye sees, and light_paths.h gives the colours there, for many samples at a time.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "common/clock.h"
#include "common/large_pages.h"
#include "exercises/07-shading.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

// Samples in a row of a block, and of a square in it.
enum { BLOCK = 16, SQUARE = 4 };

// A shaded picture, for all threads.
typedef struct {
    const Work *work;
    Rendering rendering;
    const LightWorld *world; // NULL: none
    Picture picture;
    const LightSteps *steps;
    int *seen;                     // the sphere that each sample sees, row by row; NULL: not known
    uint8_t background[3 * BLOCK]; // pixels whose samples see nothing
    pthread_mutex_t together;
    bool short_of_memory;
} Lit;

// Other threads write other rows at the same time, so image_set cannot be used.
static void set_pixel(Image *image, Pixel pixel, Color color)
{
    uint8_t *rgb = image_bytes(image, pixel);
    for (int i = 0; i < 3; i++)
        rgb[i] = byte_from_color(color[i]);
}

static void rows_are_done(Lit *lit, int rows)
{
    Image *image = lit->work->image;
    pthread_mutex_lock(&lit->together);
    image->set_count += (long)rows * image->size.width;
    if (image->progress != NULL)
        image->progress(image);
    pthread_mutex_unlock(&lit->together);
}

static void row_by_all(void *given, int row)
{
    Lit *lit = given;
    Image *image = lit->work->image;
    Scene scene = *lit->work->scene;
    for (int column = 0; column < image->size.width; column++) {
        Pixel pixel = {column, row};
        set_pixel(image, pixel, render_pixel(&lit->rendering, &scene, pixel));
    }
    rows_are_done(lit, 1);
}

bool light_plain(const Work *work, Style style, Message *message)
{
    (void)message;
    Lit lit = {.work = work, .rendering = {work->camera, work->image->size, style, trace_scene}};
    pthread_mutex_init(&lit.together, NULL);
    in_parallel(work->threads, work->image->size.height, row_by_all, &lit);
    pthread_mutex_destroy(&lit.together);
    return true;
}

// ---- by the hierarchy -------------------------------------------------------------------------

static int least(int a, int b)
{
    return a < b ? a : b;
}

static Resolution samples_of(const Rendering *rendering)
{
    int n = rendering->style.samples;
    return (Resolution){rendering->screen.width * n, rendering->screen.height * n};
}

// The bins find the spheres that are seen from the eye. If they cannot, the rays ask the hierarchy.
static void look(Lit *lit)
{
    enum { MOST_PLACES = 60000 }; // a place on the screen has 16 bits
    Resolution samples = samples_of(&lit->rendering);
    size_t count = (size_t)samples.width * (size_t)samples.height;
    if (samples.width > MOST_PLACES || samples.height > MOST_PLACES)
        return;
    Image size = {.size = samples};
    Work work = *lit->work;
    work.image = &size;
    lit->seen = large_memory(count * sizeof *lit->seen);
    if (lit->seen != NULL && !bins_spheres(&work, lit->seen)) {
        free(lit->seen);
        lit->seen = NULL;
    }
}

// A block of the picture, and the colours of its samples. Those of pixel number k are at the places
// k, PATHS + k, 2 PATHS + k, and so on.
typedef struct {
    Lit *lit;
    LightPaths paths;
    int n; // samples in each direction of a pixel
    Pixel first;
    int columns, rows; // of pixels
    double *colors[3]; // red, green, blue of each place
    // Samples that wait until there are PATHS.
    int waiting, place[PATHS], column[PATHS], row[PATHS];
} Block;

// Pixels in each direction: samples in a row, or one pixel.
static int pixels_in(int samples_in_a_row, const Lit *lit)
{
    int n = lit->rendering.style.samples;
    return n < samples_in_a_row ? samples_in_a_row / n : 1;
}

static void trace_waiting(Block *block)
{
    LightPaths *paths = &block->paths;
    paths->paths->count = block->waiting;
    paths->steps->rays(&paths->picture, block->column, block->row, paths->paths);
    path_colors(paths, block->lit->seen != NULL);
    for (int i = 0; i < block->waiting; i++) {
        block->colors[0][block->place[i]] = paths->colors->x[i];
        block->colors[1][block->place[i]] = paths->colors->y[i];
        block->colors[2][block->place[i]] = paths->colors->z[i];
    }
    block->waiting = 0;
}

// The spheres that samples in a row see, -1 for none; NULL if they are not known.
static const int *seen_from(const Lit *lit, int column, int row)
{
    size_t columns = (size_t)lit->picture.samples.width;
    return lit->seen == NULL ? NULL : lit->seen + (size_t)row * columns + column;
}

// Samples in a row, of whole pixels: place is that of the first one. All are written to the list,
// but only those that see a sphere count: a processor cannot predict an 'if' here.
static void trace_samples(Block *block, int left, int row, int count, int place)
{
    const int unknown = 0, *seen = seen_from(block->lit, left, row);
    const Scene *scene = block->lit->work->scene;
    int *spheres = block->paths.paths->sphere, waiting = block->waiting;
    for (int pixel = 0; pixel < count; pixel += block->n, place++)
        for (int k = 0; k < block->n; k++) {
            int sphere = seen == NULL ? unknown : seen[pixel + k];
            spheres[waiting] = sphere;
            block->place[waiting] = place + k * PATHS;
            block->column[waiting] = left + pixel + k;
            block->row[waiting] = row;
            __builtin_prefetch(&scene->spheres[sphere < 0 ? 0 : sphere]);
            waiting += sphere >= 0;
            if (waiting == PATHS) {
                block->waiting = waiting;
                trace_waiting(block);
                waiting = 0;
            }
        }
    block->waiting = waiting;
}

// In squares of about 4 x 4 samples: paths that are traced one after the other are neighbours, and
// most of them ask the same spheres, which are then in the cache.
static void trace_block(Block *block)
{
    int n = block->n, side = pixels_in(SQUARE, block->lit);
    for (int top = 0; top < block->rows; top += side)
        for (int left = 0; left < block->columns; left += side)
            for (int row = top * n; row < least(top + side, block->rows) * n; row++)
                trace_samples(block, (block->first.column + left) * n, block->first.row * n + row,
                              least(side, block->columns - left) * n,
                              row % n * n * PATHS + row / n * block->columns + left);
    if (block->waiting > 0)
        trace_waiting(block);
}

// The colours of samples that see no sphere.
static void see_nothing(Block *block)
{
    for (int i = 0; i < 3; i++)
        for (int sample = 0; sample < block->n * block->n; sample++)
            for (int k = 0; k < block->rows * block->columns; k++)
                block->colors[i][sample * PATHS + k] = block->lit->work->scene->background[i];
}

// step: bytes from one row to the next.
static void paint_rows(const Block *block, const uint8_t *rgb, int step)
{
    Pixel left = block->first;
    for (; left.row < block->first.row + block->rows; left.row++, rgb += step)
        memcpy(image_bytes(block->lit->work->image, left), rgb, 3 * (size_t)block->columns);
}

static void paint_colors(Block *block)
{
    const LightSteps *steps = block->paths.steps;
    int count = block->rows * block->columns;
    double gamma = block->lit->rendering.style.gamma;
    Vectors *means = block->paths.directions;
    uint8_t rgb[3 * PATHS];
    steps->means(block->colors, block->n * block->n, count, means);
    for (int i = 0; i < count && gamma != 1; i++)
        set_vector(means, i, gamma_encode(vector_of(means, i), gamma));
    steps->bytes(means, count, rgb);
    paint_rows(block, rgb, 3 * block->columns);
}

// If no sample of the block sees a sphere, it gets the background at once.
static void paint_block(Block *block)
{
    int n = block->n, all = -1, any = 0; // negative: all samples see nothing, or at least one
    for (int row = 0; row < block->rows * n && block->lit->seen != NULL; row++) {
        const int *seen =
            seen_from(block->lit, block->first.column * n, block->first.row * n + row);
        __builtin_prefetch(seen + 4 * BLOCK);
        for (int i = 0; i < block->columns * n; i++) {
            all &= seen[i];
            any |= seen[i];
        }
    }
    if (any < 0 && all < 0) {
        paint_rows(block, block->lit->background, 0);
        return;
    }
    if (any < 0)
        see_nothing(block);
    trace_block(block);
    paint_colors(block);
}

static bool block_begin(Block *block, Lit *lit)
{
    int n = lit->rendering.style.samples;
    size_t places = (size_t)n * (size_t)n * PATHS;
    double *colors = large_memory(3 * places * sizeof *colors);
    *block = (Block){.lit = lit, .n = n};
    if (colors != NULL &&
        light_paths_begin(&block->paths, lit->world, lit->rendering.style.depth)) {
        for (size_t i = 0; i < 3; i++)
            block->colors[i] = colors + i * places;
        block->paths.picture = lit->picture;
        block->paths.steps = lit->steps;
        return true;
    }
    free(colors);
    return false;
}

static void blocks_in_a_row(void *given, int number)
{
    Lit *lit = given;
    Resolution image = lit->work->image->size;
    Block block;
    if (!block_begin(&block, lit)) {
        pthread_mutex_lock(&lit->together);
        lit->short_of_memory = true;
        pthread_mutex_unlock(&lit->together);
        return;
    }
    int side = pixels_in(BLOCK, lit);
    block.first.row = number * side;
    block.rows = least(side, image.height - block.first.row);
    for (int left = 0; left < image.width; left += side) {
        block.first.column = left;
        block.columns = least(side, image.width - left);
        paint_block(&block);
    }
    light_paths_end(&block.paths);
    free(block.colors[0]);
    rows_are_done(lit, block.rows);
}

static Color see_background(void *world, Pixel sample, Ray ray, int depth)
{
    const Lit *lit = world;
    (void)sample, (void)ray, (void)depth;
    return lit->work->scene->background;
}

static void set_background(Lit *lit)
{
    Image row = {.size = {BLOCK, 1}, .rgb = lit->background};
    Color color = render_pixel(&lit->rendering, lit, (Pixel){0, 0});
    for (int column = 0; column < BLOCK; column++)
        set_pixel(&row, (Pixel){column, 0}, color);
}

bool light_bvh(const Work *work, Style style, Message *message)
{
    if (extreme_light(work))
        return light_plain(work, style, message);
    LightWorld world;
    Lit lit = {.work = work,
               .rendering = {work->camera, work->image->size, style, see_background},
               .world = &world};
    bool ready = light_world_build(&world, work->scene, work->threads);
    if (work->built != NULL)
        *work->built = clock_seconds();
    pthread_mutex_init(&lit.together, NULL);
    if (ready) {
        lit.picture =
            (Picture){work->scene, world.materials, work->camera, samples_of(&lit.rendering)};
        lit.steps = steps_for(&lit.picture);
        look(&lit);
        set_background(&lit);
        int side = pixels_in(BLOCK, &lit);
        in_parallel(work->threads, (work->image->size.height + side - 1) / side, blocks_in_a_row,
                    &lit);
    }
    pthread_mutex_destroy(&lit.together);
    free(lit.seen);
    light_world_free(&world);
    if (ready && !lit.short_of_memory)
        return true;
    return message_set(message, "no memory for a hierarchy of %d spheres",
                       work->scene->sphere_count);
}
