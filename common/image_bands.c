// image_bands.c - encodes the rows of an image, band by band: palette, filter, compression.
#include "common/image_bands.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

Band *bands_of(const Image *image, uint8_t *indices)
{
    Band *bands = calloc((size_t)bands_count(image), sizeof *bands);
    for (int i = 0; bands != NULL && i < bands_count(image); i++) {
        int row = i * BAND_ROWS, rest = image->size.height - row;
        bands[i].image = image;
        bands[i].row = row;
        bands[i].rows = rest < BAND_ROWS ? rest : BAND_ROWS;
        bands[i].last = rest <= BAND_ROWS;
        if (indices != NULL)
            bands[i].indices = indices + image_index(image, (Pixel){0, row});
    }
    return bands;
}

void bands_free(Band *bands, const Image *image)
{
    for (int i = 0; bands != NULL && i < bands_count(image); i++)
        free(bands[i].stream);
    free(bands);
}

size_t band_row_bytes(const Band *band)
{
    size_t width = (size_t)band->image->size.width;
    return band->bits == 0 ? 3 * width : (width * (size_t)band->bits + 7) / 8;
}

// The indices of a row of the band, as few bits each as will do.
static void pack(const Band *band, int row, uint8_t *to)
{
    int width = band->image->size.width, in_byte = 8 / band->bits, left = 0;
    const uint8_t *indices = band->indices + (size_t)row * (size_t)width;
    // Most pictures of spheres have 3 to 16 colours.
    if (band->bits == 4)
        for (; left + 1 < width; left += 2)
            *to++ = (uint8_t)(band->in_palette[indices[left]] << 4 |
                              band->in_palette[indices[left + 1]]);
    for (; left < width; left += in_byte) {
        unsigned byte = 0;
        for (int k = left; k < left + in_byte; k++)
            byte = byte << band->bits | (k < width ? band->in_palette[indices[k]] : 0);
        *to++ = (uint8_t)byte;
    }
}

// The bytes of a row of the band, before they are filtered. packed is where they are put if the
// image does not have them.
static const uint8_t *bytes_of(const Band *band, int row, uint8_t *packed)
{
    if (band->bits == 0)
        return image_bytes(band->image, (Pixel){0, band->row + row});
    pack(band, row, packed);
    return packed;
}

// PNG's filter 'up': each byte less the one above it.
static void filter(const Band *band, uint8_t *packed, uint8_t *to)
{
    enum { UP = 2 };
    size_t size = band_row_bytes(band);
    uint8_t *spare = packed + size;
    memset(spare, 0, size);
    const uint8_t *above = band->row > 0 ? bytes_of(band - 1, BAND_ROWS - 1, spare) : spare;
    for (int row = 0; row < band->rows; row++) {
        const uint8_t *bytes = bytes_of(band, row, row % 2 == 0 ? packed : spare);
        *to++ = UP;
        for (size_t i = 0; i < size; i++)
            to[i] = (uint8_t)(bytes[i] - above[i]);
        to += size;
        above = bytes;
    }
}

// A picture of spheres is areas, and rows that are like the row above: the difference from that,
// and of compression only runs (Z_RLE). That takes about a quarter of the time of libpng's
// defaults, and a tenth for a flat picture, which is also half as large (tests/benches/pictures.c).
static bool compress_rows(Band *band, uint8_t *rows, size_t size)
{
    z_stream z = {.next_in = rows, .avail_in = (uInt)size};
    if (deflateInit2(&z, 1, Z_DEFLATED, -MAX_WBITS, 8, Z_RLE) != Z_OK)
        return false;
    size_t room = deflateBound(&z, (uLong)size) + 16; // for the end of a band
    band->stream = malloc(ZLIB_HEADER + room + ZLIB_CHECKSUM);
    z.next_out = band->stream == NULL ? NULL : band->stream + ZLIB_HEADER;
    z.avail_out = (uInt)room;
    bool done =
        band->stream != NULL &&
        deflate(&z, band->last ? Z_FINISH : Z_SYNC_FLUSH) == (band->last ? Z_STREAM_END : Z_OK) &&
        z.avail_in == 0 && z.avail_out > 0;
    band->size = room - z.avail_out;
    band->check = adler32(1, rows, (uInt)size);
    deflateEnd(&z);
    return done;
}

void band_encode(void *bands, int i)
{
    Band *band = (Band *)bands + i;
    if (band->stream != NULL)
        return;
    size_t row_bytes = band_row_bytes(band), size = (size_t)band->rows * (row_bytes + 1);
    uint8_t *packed = malloc(2 * row_bytes), *rows = malloc(size);
    if (packed != NULL && rows != NULL) {
        filter(band, packed, rows);
        if (!compress_rows(band, rows, size)) {
            free(band->stream);
            band->stream = NULL;
        }
    }
    free(packed);
    free(rows);
}
