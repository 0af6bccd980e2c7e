// shading.c - chapter 07's pictures: shadows and mirrors.
//
// With plain, every ray asks every sphere. With bvh, the bins of step 6 find the spheres that the
// eye sees, and light.h gives the colors there, for many samples at a time.
#include "chapters/08-fast/engines/engine.h"

#include "chapters/08-fast/engines/light.h"
#include "common/clock.h"
#include "exercises/07-shading.h"

#include <stdlib.h>

enum { BLOCK = 16 }; // pixels in a row of a block, whose samples are traced together

// A shaded picture, for all threads.
struct LightPicture {
    const Work *work;
    Rendering rendering;
    LightWorld world;
    const LightSteps *steps; // NULL: not chosen yet
    int *seen;               // the sphere that each sample sees, row by row; NULL: not known
    atomic_bool short_of_memory;
};
typedef LightPicture Lit;

// Other threads write other rows at the same time, so image_set cannot be used.
static void set_pixel(Image *image, Pixel pixel, Color color)
{
    uint8_t *rgb = image_bytes(image, pixel);
    for (int i = 0; i < 3; i++)
        rgb[i] = byte_from_color(color[i]);
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
    rows_are_done(image, 1);
}

bool light_plain(const Work *work, Style style, Message *message)
{
    (void)message;
    Lit lit = {.work = work, .rendering = {work->camera, work->image->size, style, trace_scene}};
    in_parallel(work->threads, work->image->size.height, row_by_all, &lit);
    return true;
}

// ---- by the hierarchy -------------------------------------------------------------------------

// The bins find the spheres that are seen from the eye. If they cannot, the rays ask the hierarchy.
static void look(Lit *lit)
{
    enum { MOST_PLACES = 60000 }; // a place on the screen has 16 bits
    Resolution samples = lit->world.samples;
    if (samples.width > MOST_PLACES || samples.height > MOST_PLACES)
        return;
    Image size = {.size = samples};
    Work work = *lit->work;
    work.image = &size;
    lit->seen = lanes_memory((size_t)samples.width * (size_t)samples.height * sizeof *lit->seen);
    if (lit->seen != NULL && !bins_spheres(&work, lit->seen)) {
        free(lit->seen);
        lit->seen = NULL;
    }
}

// The sphere that a sample sees, -1 for none; 0 if it is not known.
static int sphere_seen(const Lit *lit, int column, int row)
{
    size_t columns = (size_t)lit->world.samples.width;
    return lit->seen == NULL ? 0 : lit->seen[(size_t)row * columns + (size_t)column];
}

// Samples that see spheres decide which steps draw the picture. Steps of the golden section come to
// all its parts.
static void choose_steps(Lit *lit)
{
    enum { TRIED = 1 << 16, CHOSEN = 4 * PATHS };
    int columns[CHOSEN], rows[CHOSEN], count = 0;
    Resolution samples = lit->world.samples;
    double all = (double)samples.width * samples.height;
    for (int i = 0; i < TRIED && count < CHOSEN; i++) {
        long long at = (long long)(fmod(i * 0.61803398874989485, 1) * all);
        columns[count] = (int)(at % samples.width);
        rows[count] = (int)(at / samples.width);
        count += sphere_seen(lit, columns[count], rows[count]) >= 0;
    }
    lit->steps = steps_for(&lit->world, columns, rows, count);
}

// A square of pixels, one path for each, and the sums of the colors of their samples.
typedef struct {
    Lit *lit;
    LightPaths *all;
    int left, right, top, bottom; // its columns and rows
    Vectors sums;
} Block;

// Whether any sample of the block sees a sphere, as far as it is known.
static bool sees_spheres(const Block *block)
{
    const Lit *lit = block->lit;
    const int n = lit->rendering.style.samples;
    const size_t width = (size_t)lit->world.samples.width;
    bool any = lit->seen == NULL;
    for (int row = block->top * n; row < block->bottom * n && !any; row++)
        for (int column = block->left * n; column < block->right * n; column++)
            any |= lit->seen[(size_t)row * width + (size_t)column] >= 0;
    return any;
}

// In squares of 4 x 4 pixels, because neighbours ask the same spheres.
static Pixel pixel_of(const Block *block, int path)
{
    return (Pixel){block->left + path % 4 + path / 16 % 4 * 4,
                   block->top + path / 4 % 4 + path / 64 * 4};
}

// The same sample of all pixels in the block. Those that see a sphere are traced together.
static void trace_sample(Block *block, int sample, Color background)
{
    const Lit *lit = block->lit;
    LightPaths *all = block->all;
    const int n = lit->rendering.style.samples, right = sample % n, down = sample / n;
    int count = 0, places[PATHS], columns[PATHS], rows[PATHS], *spheres = all->paths.sphere;
    for (int i = 0; i < PATHS; i++) {
        Pixel pixel = pixel_of(block, i);
        if (pixel.column >= block->right || pixel.row >= block->bottom)
            continue;
        places[count] = i;
        columns[count] = pixel.column * n + right;
        rows[count] = pixel.row * n + down;
        spheres[count] = sphere_seen(lit, columns[count], rows[count]);
        // No if: a processor cannot predict which samples see a sphere.
        bool nothing = spheres[count] < 0;
        block->sums.x[i] += nothing ? background[0] : 0;
        block->sums.y[i] += nothing ? background[1] : 0;
        block->sums.z[i] += nothing ? background[2] : 0;
        count += !nothing;
    }
    if (count == 0)
        return;
    all->paths.count = count;
    all->steps->rays(all->world, columns, rows, &all->paths);
    path_colors(all, lit->seen != NULL);
    all->steps->add_clamped(all->colors, places, count, &block->sums);
}

// The mean of a pixel's samples.
static void set_mean(const Lit *lit, Pixel pixel, Color sum)
{
    const Style style = lit->rendering.style;
    const Color mean = sum / (style.samples * style.samples);
    set_pixel(lit->work->image, pixel, style.gamma == 1 ? mean : gamma_encode(mean, style.gamma));
}

// Nothing but background: one pixel, copied.
static void fill_block(const Block *block, int samples, Color background)
{
    Image *image = block->lit->work->image;
    uint8_t rgb[3];
    Color sum = {0};
    for (int i = 0; i < samples; i++)
        sum += background;
    set_mean(block->lit, (Pixel){block->left, block->top}, sum);
    memcpy(rgb, image_bytes(image, (Pixel){block->left, block->top}), sizeof rgb);
    for (int row = block->top; row < block->bottom; row++)
        for (int column = block->left; column < block->right; column++)
            memcpy(image_bytes(image, (Pixel){column, row}), rgb, sizeof rgb);
}

static void paint_block(Block *block)
{
    const Lit *lit = block->lit;
    const int samples = lit->rendering.style.samples * lit->rendering.style.samples;
    Color background = clamp_color(lit->work->scene->background);
    if (!sees_spheres(block)) {
        fill_block(block, samples, background);
        return;
    }
    memset(&block->sums, 0, sizeof block->sums);
    for (int i = 0; i < samples; i++)
        trace_sample(block, i, background);
    for (int i = 0; i < PATHS; i++) {
        Pixel pixel = pixel_of(block, i);
        if (pixel.column < block->right && pixel.row < block->bottom)
            set_mean(lit, pixel, vector_of(&block->sums, i));
    }
}

bool light_picture_paint(Lit *lit, int left, int top, int right, int bottom)
{
    Block block = {.lit = lit, .all = light_paths_create(&lit->world, lit->steps)};
    if (block.all == NULL)
        return false;
    for (block.top = top; block.top < bottom; block.top += BLOCK)
        for (block.left = left; block.left < right; block.left += BLOCK) {
            block.right = least(block.left + BLOCK, right);
            block.bottom = least(block.top + BLOCK, bottom);
            paint_block(&block);
        }
    free(block.all);
    return true;
}

static void row_of_blocks(void *given, int number)
{
    Lit *lit = given;
    Resolution image = lit->work->image->size;
    int top = number * BLOCK, bottom = least(top + BLOCK, image.height);
    if (!light_picture_paint(lit, 0, top, image.width, bottom))
        atomic_store(&lit->short_of_memory, true);
    rows_are_done(lit->work->image, bottom - top);
}

LightPicture *light_picture_build(const Scene *scene)
{
    LightPicture *picture = calloc(1, sizeof *picture);
    if (picture == NULL)
        return NULL;
    picture->world.scene = scene;
    if (light_world_build(&picture->world))
        return picture;
    light_picture_free(picture);
    return NULL;
}

void light_picture_look(LightPicture *picture, const Work *work, Style style, bool whole)
{
    const Resolution screen = work->image->size;
    free(picture->seen);
    picture->seen = NULL;
    picture->work = work;
    picture->rendering = (Rendering){work->camera, screen, style, NULL};
    picture->world.camera = work->camera;
    picture->world.samples =
        (Resolution){screen.width * style.samples, screen.height * style.samples};
    picture->world.depth = style.depth;
    if (whole)
        look(picture);
    if (picture->steps == NULL)
        choose_steps(picture);
}

void light_picture_free(LightPicture *picture)
{
    if (picture == NULL)
        return;
    free(picture->seen);
    light_world_free(&picture->world);
    free(picture);
}

bool light_bvh(const Work *work, Style style, Message *message)
{
    if (extreme_light(work))
        return light_plain(work, style, message);
    LightPicture *picture = light_picture_build(work->scene);
    if (work->built != NULL)
        *work->built = clock_seconds();
    if (picture != NULL) {
        light_picture_look(picture, work, style, true);
        in_parallel(work->threads, (work->image->size.height + BLOCK - 1) / BLOCK, row_of_blocks,
                    picture);
    }
    bool done = picture != NULL && !picture->short_of_memory;
    light_picture_free(picture);
    return done || message_set(message, "no memory for a hierarchy of %d spheres",
                               work->scene->sphere_count);
}
