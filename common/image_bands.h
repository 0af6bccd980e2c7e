// image_bands.h - the rows of an image as the data of a PNG, in bands that do not wait for others.
//
// zlib compresses the bands, and their streams are joined: each ends with a whole byte
// (Z_SYNC_FLUSH) and needs no bytes of another one, so one after the other they are one stream.
// Bands do not depend on the number of threads, so the bytes of the file do not either.
#ifndef COMMON_IMAGE_BANDS_H
#define COMMON_IMAGE_BANDS_H

#include "common/image.h"

enum { BAND_ROWS = 64, MOST_COLORS = 256, ZLIB_HEADER = 2, ZLIB_CHECKSUM = 4 };

typedef struct {
    const Image *image;
    int row, rows;
    bool last;
    const uint8_t *indices; // of the band's pixels, one byte each; used if there is a palette
    uint8_t in_palette[MOST_COLORS]; // the palette's index for each of these
    int bits;                        // of an index in the file; 0 if there is no palette
    uint8_t *stream;                 // the compressed rows, with room for zlib's header before
                                     // them and the checksum after them; NULL: not encoded yet
    size_t size;                     // bytes of the compressed rows
    unsigned long check;             // Adler-32 of the rows
} Band;

// An image in bands that have no palette yet; indices are the first band's, or NULL. Free it with
// bands_free; NULL if there is not enough memory.
Band *bands_of(const Image *image, uint8_t *indices);
void bands_free(Band *bands, const Image *image);

static inline int bands_count(const Image *image)
{
    return (image->size.height + BAND_ROWS - 1) / BAND_ROWS;
}

// How many bits an index has in a palette of this many colours.
static inline int bits_of_palette(int colors)
{
    return colors > 16 ? 8 : colors > 4 ? 4 : colors > 2 ? 2 : 1;
}

// Bytes of a row in the file, without the filter's.
size_t band_row_bytes(const Band *band);

// Encodes a band of these, if it is not encoded yet. Its pixels are set, and so is the row above
// them. If there is not enough memory, it still has no stream.
void band_encode(void *bands, int i);

#endif
