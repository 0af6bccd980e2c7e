// shading.c - chapter 07's pictures: shadows and mirrors. Every ray asks every sphere (plain), or
// the spheres on its way (bvh).
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/clock.h"
#include "chapters/08-fast/engines/large_memory.h"
#include "chapters/08-fast/engines/light_paths.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "exercises/04-pixel-ray.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const Work *work;
    Rendering rendering;
    const LightWorld *world; // NULL: none
    int *seen;               // the sphere that each sample sees, row by row; NULL: not known
    uint8_t background[3];   // of a pixel whose samples see nothing
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

// A block of pixels, and the colours that their samples see.
enum { BLOCK = 16 }; // samples in a row, or all those of one pixel
typedef struct {
    Lit *lit;
    LightPaths paths;
    Pixel corner; // the first sample
    Resolution size;
    Color *colors;
    // Samples that wait until there are PATHS.
    int count;
    int places[PATHS], spheres[PATHS];
    Ray rays[PATHS];
} Block;

static Color color_in_block(void *world, Pixel sample, Ray ray, int depth)
{
    const Block *block = world;
    (void)ray, (void)depth;
    return block->colors[(sample.row - block->corner.row) * block->size.width + sample.column -
                         block->corner.column];
}

static void trace_waiting(Block *block)
{
    Color colors[PATHS];
    const int *spheres = block->lit->seen == NULL ? NULL : block->spheres;
    path_colors(&block->paths, block->rays, spheres, block->count, colors);
    for (int i = 0; i < block->count; i++)
        block->colors[block->places[i]] = colors[i];
    block->count = 0;
}

static void trace_sample(Block *block, int column, int row)
{
    const Lit *lit = block->lit;
    Resolution samples = samples_of(&lit->rendering);
    Pixel sample = {block->corner.column + column, block->corner.row + row};
    int place = row * block->size.width + column, i = block->count;
    if (lit->seen != NULL) {
        size_t index = (size_t)sample.row * (size_t)samples.width + (size_t)sample.column;
        block->spheres[i] = lit->seen[index];
        block->colors[place] = lit->work->scene->background;
        if (block->spheres[i] < 0)
            return;
    }
    block->places[i] = place;
    block->rays[i] = pixel_ray(lit->rendering.camera, samples, sample);
    if (++block->count == PATHS)
        trace_waiting(block);
}

// In squares of 4 x 4, so that 16 rays in a row are neighbours.
static void trace_block(Block *block)
{
    Resolution size = block->size;
    for (int top = 0; top < size.height; top += 4)
        for (int left = 0; left < size.width; left += 4)
            for (int row = top; row < top + 4 && row < size.height; row++)
                for (int column = left; column < left + 4 && column < size.width; column++)
                    trace_sample(block, column, row);
    trace_waiting(block);
}

// Whether no sample of a pixel sees a sphere.
static bool sees_nothing(const Lit *lit, Pixel pixel)
{
    int n = lit->rendering.style.samples;
    size_t columns = (size_t)samples_of(&lit->rendering).width;
    if (lit->seen == NULL)
        return false;
    const int *seen = lit->seen + (size_t)pixel.row * (size_t)n * columns + pixel.column * n;
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++)
            if (seen[(size_t)row * columns + (size_t)column] >= 0)
                return false;
    return true;
}

// Pixels in each direction of a block.
static int pixels_in_block(const Lit *lit)
{
    int n = lit->rendering.style.samples;
    return n < BLOCK ? BLOCK / n : 1;
}

static void paint_block(Block *block, Pixel first, Resolution pixels)
{
    const Lit *lit = block->lit;
    Image *image = lit->work->image;
    int n = lit->rendering.style.samples;
    block->corner = (Pixel){first.column * n, first.row * n};
    block->size = (Resolution){pixels.width * n, pixels.height * n};
    trace_block(block);
    for (int row = 0; row < pixels.height; row++) {
        for (int column = 0; column < pixels.width; column++) {
            Pixel pixel = {first.column + column, first.row + row};
            if (sees_nothing(lit, pixel))
                memcpy(image_bytes(image, pixel), lit->background, sizeof lit->background);
            else
                set_pixel(image, pixel, render_pixel(&lit->rendering, block, pixel));
        }
    }
}

static bool block_begin(Block *block, Lit *lit)
{
    size_t most = (size_t)pixels_in_block(lit) * (size_t)lit->rendering.style.samples;
    *block = (Block){.lit = lit, .colors = malloc(most * most * sizeof *block->colors)};
    if (block->colors != NULL &&
        light_paths_begin(&block->paths, lit->world, lit->rendering.style.depth))
        return true;
    free(block->colors);
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
    int side = pixels_in_block(lit), top = number * side;
    int height = image.height - top < side ? image.height - top : side;
    for (int left = 0; left < image.width; left += side)
        paint_block(&block, (Pixel){left, top},
                    (Resolution){image.width - left < side ? image.width - left : side, height});
    light_paths_end(&block.paths);
    free(block.colors);
    rows_are_done(lit, height);
}

static Color see_background(void *world, Pixel sample, Ray ray, int depth)
{
    const Lit *lit = world;
    (void)sample, (void)ray, (void)depth;
    return lit->work->scene->background;
}

static void set_background(Lit *lit)
{
    Rendering empty = lit->rendering;
    Image pixel = {.size = {1, 1}, .rgb = lit->background};
    empty.trace = see_background;
    set_pixel(&pixel, (Pixel){0, 0}, render_pixel(&empty, lit, (Pixel){0, 0}));
}

bool light_bvh(const Work *work, Style style, Message *message)
{
    if (extreme_light(work))
        return light_plain(work, style, message);
    LightWorld world;
    Lit lit = {.work = work,
               .rendering = {work->camera, work->image->size, style, color_in_block},
               .world = &world};
    bool ready = light_world_build(&world, work->scene, work->threads);
    if (work->built != NULL)
        *work->built = clock_seconds();
    pthread_mutex_init(&lit.together, NULL);
    if (ready) {
        look(&lit);
        set_background(&lit);
        int side = pixels_in_block(&lit);
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
