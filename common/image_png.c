// image_png.c - an image as a PNG file, by libpng and zlib, whole or not at all.
//
// The rows are encoded in bands, by the threads that a program lends (image_bands.c), because
// libpng compresses rows only one after the other. libpng writes the parts of the file.
#include "common/image_bands.h"
#include "common/image_flat.h"
#include "common/whole_file.h"
#include "common/workers.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { BANDS_AT_ONCE = 32, SLOTS = 1024 };

// Different colours, found by open addressing. A key is never 0, which is the key of a free slot.
typedef struct {
    int count;
    uint32_t keys[MOST_COLORS];
    struct {
        uint32_t key, index;
    } slots[SLOTS];
} Colors;

// A picture that may have a palette, while its colours are looked for.
typedef struct {
    Band *bands;
    Colors *colors; // of each band
    bool *flat;     // has it at most MOST_COLORS?
    uint8_t *indices;
} Coloring;

// ---- flat pictures ----------------------------------------------------------------------------

static uint32_t key_of(const uint8_t *rgb)
{
    return rgb[0] | (uint32_t)rgb[1] << 8 | (uint32_t)rgb[2] << 16 | 1u << 24;
}

// 2654435761: Knuth's, 2^32 over the golden ratio.
static uint32_t first_slot(uint32_t key)
{
    return (key * 2654435761u) >> 22;
}

// The index of a colour, which is added if it is new; -1 if there are too many.
static int index_of(Colors *colors, uint32_t key)
{
    uint32_t i = first_slot(key);
    while (colors->slots[i].key != 0 && colors->slots[i].key != key)
        i = (i + 1) % SLOTS;
    if (colors->slots[i].key == 0) {
        if (colors->count == MOST_COLORS)
            return -1;
        colors->slots[i].key = colors->keys[colors->count] = key;
        colors->slots[i].index = (uint32_t)colors->count++;
    }
    return (int)colors->slots[i].index;
}

// The indices of some pixels; false if there are too many colours. Most colours are in their first
// slot. It is quicker to look there each time than to ask whether the colour is that of the pixel
// before, which no processor can predict.
static bool find_indices(Colors *colors, const uint8_t *rgb, size_t count, uint8_t *to)
{
    for (size_t k = 0; k < count; k++, rgb += 3) {
        uint32_t key = key_of(rgb), slot = first_slot(key);
        int index = (int)colors->slots[slot].index;
        if (colors->slots[slot].key != key && (index = index_of(colors, key)) < 0)
            return false;
        to[k] = (uint8_t)index;
    }
    return true;
}

// Pixels that are like those above them have the same indices.
static void find_colors(void *given, int i)
{
    enum { SOME = 16 };
    const Coloring *coloring = given;
    const Image *image = coloring->bands[i].image;
    const Pixel first = {0, coloring->bands[i].row};
    const uint8_t *rgb = image_bytes(image, first);
    uint8_t *indices = coloring->indices + image_index(image, first);
    const size_t width = (size_t)image->size.width;
    const size_t all = (size_t)coloring->bands[i].rows * width;
    for (size_t k = 0; k < all; k += SOME) {
        size_t count = all - k < SOME ? all - k : SOME;
        if (k >= width && width >= count &&
            memcmp(rgb + 3 * k, rgb + 3 * (k - width), 3 * count) == 0)
            memcpy(indices + k, indices + k - width, count);
        else if (!find_indices(&coloring->colors[i], rgb + 3 * k, count, indices + k))
            return;
    }
    coloring->flat[i] = true;
}

// Adds the colours of all bands. False if there are too many.
static bool join_colors(const Coloring *coloring, int count, Colors *palette)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < coloring->colors[i].count; k++)
            if (!coloring->flat[i] || index_of(palette, coloring->colors[i].keys[k]) < 0)
                return false;
    return true;
}

static int by_number(const void *a, const void *b)
{
    const uint32_t *p = a, *q = b;
    return *p < *q ? -1 : *p > *q;
}

// A palette is in rising order, so it does not depend on where the colours are.
static void set_palette(const Coloring *coloring, int i, const Colors *palette)
{
    Band *band = &coloring->bands[i];
    band->bits = bits_of_palette(palette->count);
    for (int k = 0; k < coloring->colors[i].count; k++) {
        const uint32_t *found = bsearch(&coloring->colors[i].keys[k], palette->keys,
                                        (size_t)palette->count, sizeof(uint32_t), by_number);
        band->in_palette[k] = (uint8_t)(found - palette->keys);
    }
}

// Finds the palette of an image, if it has at most MOST_COLORS. False if there is not enough
// memory.
static bool find_palette(const Image *image, Coloring *coloring, Colors *palette)
{
    const size_t count = (size_t)bands_count(image);
    coloring->indices = malloc((size_t)image->size.width * (size_t)image->size.height);
    coloring->colors = calloc(count, sizeof *coloring->colors);
    coloring->flat = calloc(count, sizeof *coloring->flat);
    coloring->bands = bands_of(image, coloring->indices);
    if (coloring->indices == NULL || coloring->colors == NULL || coloring->flat == NULL ||
        coloring->bands == NULL)
        return false;
    workers_do((int)count, find_colors, coloring);
    if (!join_colors(coloring, (int)count, palette)) {
        palette->count = 0;
        return true;
    }
    qsort(palette->keys, (size_t)palette->count, sizeof *palette->keys, by_number);
    for (int i = 0; i < (int)count; i++)
        set_palette(coloring, i, palette);
    return true;
}

static void coloring_free(Coloring *coloring, const Image *image)
{
    bands_free(coloring->bands, image);
    free(coloring->indices);
    free(coloring->colors);
    free(coloring->flat);
}

// ---- libpng -----------------------------------------------------------------------------------

// libpng reports through a jump; its words are kept for the message.
static void keep_words(png_structp png, png_const_charp words)
{
    Message *message = png_get_error_ptr(png);
    if (message != NULL)
        snprintf(message->text, sizeof message->text, "%s", words);
    longjmp(png_jmpbuf(png), 1);
}

static void ignore_warning(png_structp png, png_const_charp words)
{
    (void)png;
    (void)words;
}

typedef struct {
    const Image *image;
    Band *bands;
    int color_count; // 0: no palette
    const uint32_t *colors;
    FILE *file;
} Picture;

static void write_header(png_structp png, png_infop info, const Picture *picture)
{
    Resolution size = picture->image->size;
    int bits = picture->bands[0].bits, count = picture->color_count;
    png_color colors[MOST_COLORS];
    for (int i = 0; i < count; i++) {
        uint32_t key = picture->colors[i];
        colors[i] = (png_color){(uint8_t)key, (uint8_t)(key >> 8), (uint8_t)(key >> 16)};
    }
    png_init_io(png, picture->file);
    png_set_IHDR(png, info, (png_uint_32)size.width, (png_uint_32)size.height, bits > 0 ? bits : 8,
                 bits > 0 ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (bits > 0)
        png_set_PLTE(png, info, colors, count);
    png_write_info(png, info);
}

// One part IDAT of the file for each band. Before the first band is zlib's header, after the last
// one the checksum of all rows.
static void write_band(png_structp png, Band *band, uLong check)
{
    static const uint8_t header[ZLIB_HEADER] = {0x78, 0x01};
    uint8_t *start = band->stream + ZLIB_HEADER;
    size_t size = band->size;
    if (band->row == 0) {
        start = memcpy(band->stream, header, ZLIB_HEADER);
        size += ZLIB_HEADER;
    }
    if (band->last) {
        png_save_uint_32(start + size, (png_uint_32)check);
        size += ZLIB_CHECKSUM;
    }
    png_write_chunk(png, (png_const_bytep) "IDAT", start, size);
    free(band->stream);
    band->stream = NULL;
}

static void write_picture(png_structp png, png_infop info, Picture *picture)
{
    uLong check = 1;
    write_header(png, info, picture);
    for (int first = 0; first < bands_count(picture->image); first += BANDS_AT_ONCE) {
        int rest = bands_count(picture->image) - first;
        int count = rest < BANDS_AT_ONCE ? rest : BANDS_AT_ONCE;
        workers_do(count, band_encode, picture->bands + first);
        for (Band *band = picture->bands + first; count > 0; band++, count--) {
            if (band->stream == NULL)
                png_error(png, "out of memory");
            check = adler32_combine(check, band->check,
                                    (z_off_t)((size_t)band->rows * (band_row_bytes(band) + 1)));
            write_band(png, band, check);
        }
    }
    png_write_chunk(png, (png_const_bytep) "IEND", NULL, 0);
}

// longjmp returns to this function, which has no local variable that it could spoil.
static bool try_to_write(png_structp png, png_infop info, Picture *picture)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    write_picture(png, info, picture);
    return true;
}

static bool print(Picture *picture, Message *words)
{
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, words, keep_words, ignore_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    bool done = info != NULL && try_to_write(png, info, picture) && fflush(picture->file) == 0;
    png_destroy_write_struct(&png, &info);
    return done;
}

static bool print_flat(Picture *picture, FlatImage *flat, Message *words)
{
    uint32_t colors[FLAT_COLORS] = {0};
    picture->bands = flat->bands;
    picture->color_count = flat_palette(flat, colors);
    picture->colors = colors;
    return print(picture, words);
}

static bool print_full(Picture *picture, Message *words)
{
    Coloring coloring = {0};
    Colors palette = {0};
    bool done = find_palette(picture->image, &coloring, &palette);
    picture->bands = coloring.bands;
    picture->color_count = palette.count;
    picture->colors = palette.keys;
    done = done && print(picture, words);
    coloring_free(&coloring, picture->image);
    return done;
}

bool image_print_png(FILE *file, const Image *image, const char *path, Message *message)
{
    Message words = {"out of memory"};
    errno = 0;
    Picture picture = {.image = image, .file = file};
    FlatImage *flat = image_flat(image);
    if (flat != NULL ? print_flat(&picture, flat, &words) : print_full(&picture, &words))
        return true;
    return message_set(message, "%s: cannot write the picture: %s", path,
                       errno != 0 ? strerror(errno) : words.text);
}

static bool write_png(FILE *file, const void *given, const char *path, Message *message)
{
    return image_print_png(file, given, path, message);
}

bool image_write_png(const Image *image, const char *path, Message *message)
{
    return file_write_whole(path, write_png, image, message);
}
