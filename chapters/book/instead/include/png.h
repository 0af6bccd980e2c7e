// png.h - reads the pictures that image_png.c writes, by the names of libpng's simple interface.
//
// Their rows are stored, not compressed, so they are copied.
#ifndef CHAPTERS_BOOK_INSTEAD_PNG_H
#define CHAPTERS_BOOK_INSTEAD_PNG_H

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { PNG_IMAGE_VERSION = 1, PNG_FORMAT_RGB = 2 };

typedef struct {
    int version, format;
    uint32_t width, height;
    FILE *file;
} png_image;

#define PNG_IMAGE_SIZE(png) (3 * (size_t)(png).width * (png).height)

static inline uint32_t png_number(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static inline int png_image_begin_read_from_file(png_image *png, const char *path)
{
    uint8_t head[43]; // to zlib's header: the signature, the header's part, the start of the next
    png->file = fopen(path, "rb");
    if (png->file == NULL || fread(head, sizeof head, 1, png->file) != 1)
        return 0;
    png->width = png_number(head + 16);
    png->height = png_number(head + 20);
    return memcmp(head + 41, "\x78\x01", 2) == 0; // as image_png.c begins the rows
}

static inline int png_image_finish_read(png_image *png, const void *background, void *rgb, int row,
                                        void *colors)
{
    (void)background;
    (void)row;
    (void)colors;
    int good = 1;
    for (uint32_t i = 0; good && i < png->height; i++) {
        uint8_t before[6]; // a stored block's size, and how the row is filtered
        good = fread(before, sizeof before, 1, png->file) == 1 &&
               fread((uint8_t *)rgb + 3 * (size_t)png->width * i, 3 * (size_t)png->width, 1,
                     png->file) == 1;
    }
    fclose(png->file);
    return good;
}

#endif
