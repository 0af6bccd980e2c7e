// image_png.c - an image as a PNG file, by libpng, whole or not at all.
#include "common/image.h"

#include "common/whole_file.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- flat pictures ----------------------------------------------------------------------------

// The colours of a picture that has few, found by open addressing.
enum { MOST_COLORS = 256, SLOTS = 1024 };
typedef struct {
    int count;
    png_color colors[MOST_COLORS];
    int slots[SLOTS]; // where a colour stands, from 1; 0: none
} Palette;

// The slot of a colour, or the free slot for it. (2654435761: Knuth's, 2^32 over the golden ratio.)
static int *slot_of(Palette *palette, const uint8_t *rgb)
{
    uint32_t key = rgb[0] | (uint32_t)rgb[1] << 8 | (uint32_t)rgb[2] << 16;
    uint32_t i = (key * 2654435761u) >> 22;
    while (palette->slots[i] != 0 && memcmp(&palette->colors[palette->slots[i] - 1], rgb, 3) != 0)
        i = (i + 1) % SLOTS;
    return &palette->slots[i];
}

// False where there are too many.
static bool find_colors(const Image *image, Palette *palette)
{
    *palette = (Palette){0};
    size_t pixels = (size_t)image->size.width * (size_t)image->size.height;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *rgb = image->rgb + 3 * i;
        if (i > 0 && memcmp(rgb, rgb - 3, 3) == 0)
            continue;
        int *slot = slot_of(palette, rgb);
        if (*slot != 0)
            continue;
        if (palette->count == MOST_COLORS)
            return false;
        palette->colors[palette->count] = (png_color){rgb[0], rgb[1], rgb[2]};
        *slot = ++palette->count;
    }
    return true;
}

static void write_by_palette(png_structp png, Palette *palette, const Image *image, int row)
{
    uint8_t indices[IMAGE_MAX_SIDE];
    int width = image->size.width;
    const uint8_t *rgb = image_bytes(image, (Pixel){0, row});
    for (int i = 0; i < width; i++, rgb += 3)
        indices[i] = i > 0 && memcmp(rgb, rgb - 3, 3) == 0 ? indices[i - 1]
                                                           : (uint8_t)(*slot_of(palette, rgb) - 1);
    png_write_row(png, indices);
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

// A picture of spheres is areas, and rows that are like the row above: the difference from that,
// and of compression only runs. That takes about a quarter of the time of libpng's defaults, and a
// tenth for a flat picture, which is also half as large (tests/benches/pictures.c).
static void set_compression(png_structp png)
{
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, 3); // zlib's Z_RLE
    png_set_compression_buffer_size(png, 1 << 16);
}

// A flat picture is written by the numbers of its colours, as few bits each as will do.
static void encode(png_structp png, png_infop info, const Image *image, Palette *palette,
                   FILE *file)
{
    png_init_io(png, file);
    set_compression(png);
    int n = palette->count;
    bool flat = n > 0;
    int bits = !flat || n > 16 ? 8 : n > 4 ? 4 : n > 2 ? 2 : 1;
    png_set_IHDR(png, info, (png_uint_32)image->size.width, (png_uint_32)image->size.height, bits,
                 flat ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (flat)
        png_set_PLTE(png, info, palette->colors, n);
    png_write_info(png, info);
    png_set_packing(png);
    for (int row = 0; row < image->size.height; row++)
        if (flat)
            write_by_palette(png, palette, image, row);
        else
            png_write_row(png, image_bytes(image, (Pixel){0, row}));
    png_write_end(png, info);
}

// longjmp returns to this function, which has no local variable that it could spoil.
static bool try_to_encode(png_structp png, png_infop info, const Image *image, Palette *palette,
                          FILE *file)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    encode(png, info, image, palette, file);
    return true;
}

bool image_print_png(FILE *file, const Image *image, const char *path, Message *message)
{
    Message words = {"out of memory"};
    errno = 0;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &words, keep_words, ignore_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    Palette palette;
    if (!find_colors(image, &palette))
        palette.count = 0;
    bool done = info != NULL && try_to_encode(png, info, image, &palette, file);
    png_destroy_write_struct(&png, &info);
    if (done && fflush(file) == 0)
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
