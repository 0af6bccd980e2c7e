// shading.c - chapter 07's pictures: shadows and mirrors.
//
// With plain, every ray asks every sphere. With bvh, the bins of step 6 find the spheres that the
// eye sees, and light_paths.h gives the colours there, for many samples at a time.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/system.h"
#include "exercises/07-shading.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

// A shaded picture, for all threads.
typedef struct {
    const Work *work;
    Rendering rendering;
    const LightWorld *world; // NULL: none
    Picture picture;
    const LightSteps *steps;
    int *seen;             // the sphere that each sample sees, row by row; NULL: not known
    uint8_t background[3]; // of a pixel whose samples see nothing
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

// A block of pixels that see a sphere, and the colours that their samples see. A sample is a place:
// those of pixel number k are k, PATHS + k, 2 PATHS + k, and so on.
enum { BLOCK = 16, SQUARE = 4 }; // samples in a row
typedef struct {
    Lit *lit;
    LightPaths paths;
    int pixel_count;
    Pixel pixels[PATHS];
    double *colors[3]; // red, green, blue of each place
    // Samples that wait until there are PATHS.
    int count;
    int places[PATHS], columns[PATHS], rows[PATHS];
} Block;

static void trace_waiting(Block *block)
{
    LightPaths *paths = &block->paths;
    paths->paths->count = block->count;
    paths->steps->rays(&paths->picture, block->columns, block->rows, paths->paths);
    path_colors(paths, block->lit->seen != NULL);
    for (int i = 0; i < block->count; i++) {
        block->colors[0][block->places[i]] = paths->colors->x[i];
        block->colors[1][block->places[i]] = paths->colors->y[i];
        block->colors[2][block->places[i]] = paths->colors->z[i];
    }
    block->count = 0;
}

// The sphere that a sample sees, or -1; 0 if that is not known.
static int seen_by(const Lit *lit, Pixel sample)
{
    size_t columns = (size_t)lit->picture.samples.width;
    return lit->seen == NULL ? 0 : lit->seen[(size_t)sample.row * columns + (size_t)sample.column];
}

static void trace_sample(Block *block, Pixel sample, int place)
{
    int seen = seen_by(block->lit, sample);
    if (seen < 0) {
        for (int i = 0; i < 3; i++)
            block->colors[i][place] = block->lit->work->scene->background[i];
        return;
    }
    int i = block->count++;
    block->places[i] = place;
    block->columns[i] = sample.column;
    block->rows[i] = sample.row;
    block->paths.paths->sphere[i] = seen;
    if (block->count == PATHS)
        trace_waiting(block);
}

static bool sees_something(const Lit *lit, Pixel first)
{
    int n = lit->rendering.style.samples;
    for (int row = first.row; row < first.row + n && lit->seen != NULL; row++)
        for (int column = first.column; column < first.column + n; column++)
            if (seen_by(lit, (Pixel){column, row}) >= 0)
                return true;
    return lit->seen == NULL;
}

// If no sample of the pixel sees a sphere, the pixel gets the background at once.
static void trace_pixel(Block *block, Pixel pixel)
{
    const Lit *lit = block->lit;
    int n = lit->rendering.style.samples, place = block->pixel_count;
    Pixel first = {pixel.column * n, pixel.row * n};
    if (!sees_something(lit, first)) {
        memcpy(image_bytes(lit->work->image, pixel), lit->background, sizeof lit->background);
        return;
    }
    block->pixels[block->pixel_count++] = pixel;
    for (int row = first.row; row < first.row + n; row++)
        for (int column = first.column; column < first.column + n; column++, place += PATHS)
            trace_sample(block, (Pixel){column, row}, place);
}

static void paint_pixels(Block *block)
{
    Style style = block->lit->rendering.style;
    Vectors *means = block->paths.directions;
    uint8_t rgb[3 * PATHS];
    block->paths.steps->means(block->colors, style.samples * style.samples, block->pixel_count,
                              means);
    for (int i = 0; i < block->pixel_count && style.gamma != 1; i++)
        set_vector(means, i, gamma_encode(vector_of(means, i), style.gamma));
    block->paths.steps->bytes(means, block->pixel_count, rgb);
    for (int i = 0; i < block->pixel_count; i++)
        memcpy(image_bytes(block->lit->work->image, block->pixels[i]), &rgb[3 * i], 3);
    block->pixel_count = 0;
}

// Pixels in each direction: samples in a row, or one pixel.
static int pixels_in(int samples_in_a_row, const Lit *lit)
{
    int n = lit->rendering.style.samples;
    return n < samples_in_a_row ? samples_in_a_row / n : 1;
}

// In squares of about 4 x 4 samples: paths that are traced one after the other are neighbours, and
// most of them ask the same spheres, which are then in the cache.
static void paint_block(Block *block, Pixel first, Pixel end)
{
    int side = pixels_in(SQUARE, block->lit);
    for (int top = first.row; top < end.row; top += side)
        for (int left = first.column; left < end.column; left += side)
            for (int row = top; row < top + side && row < end.row; row++)
                for (int column = left; column < left + side && column < end.column; column++)
                    trace_pixel(block, (Pixel){column, row});
    if (block->count > 0)
        trace_waiting(block);
    paint_pixels(block);
}

static bool block_begin(Block *block, Lit *lit)
{
    size_t samples = (size_t)lit->rendering.style.samples * (size_t)lit->rendering.style.samples;
    double *colors = large_memory(3 * samples * PATHS * sizeof *colors);
    *block = (Block){.lit = lit};
    if (colors != NULL &&
        light_paths_begin(&block->paths, lit->world, lit->rendering.style.depth)) {
        for (size_t i = 0; i < 3; i++)
            block->colors[i] = colors + i * samples * PATHS;
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
    int side = pixels_in(BLOCK, lit), top = number * side;
    int bottom = top + side < image.height ? top + side : image.height;
    for (int left = 0; left < image.width; left += side)
        paint_block(&block, (Pixel){left, top},
                    (Pixel){left + side < image.width ? left + side : image.width, bottom});
    light_paths_end(&block.paths);
    free(block.colors[0]);
    rows_are_done(lit, bottom - top);
}

static Color see_background(void *world, Pixel sample, Ray ray, int depth)
{
    const Lit *lit = world;
    (void)sample, (void)ray, (void)depth;
    return lit->work->scene->background;
}

static void set_background(Lit *lit)
{
    Image pixel = {.size = {1, 1}, .rgb = lit->background};
    set_pixel(&pixel, (Pixel){0, 0}, render_pixel(&lit->rendering, lit, (Pixel){0, 0}));
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
