// image_png.c - an image as a PNG file, by libpng and zlib, whole or not at all.
//
// The rows are encoded in bands, by the threads that a program lends. libpng compresses rows only
// one after the other, so zlib compresses the bands, and their streams are joined: each ends with a
// whole byte (Z_SYNC_FLUSH) and needs no bytes of another one, so one after the other they are one
// stream. libpng writes the parts of the file. Bands do not depend on the number of threads, so the
// bytes of the file do not either.
#include "common/image.h"

#include "common/whole_file.h"
#include "common/workers.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { BAND_ROWS = 64, BANDS_AT_ONCE = 32, MOST_COLORS = 256, SLOTS = 1024 };

// Different colours, found by open addressing. A key is never 0, which is the key of a free slot.
typedef struct {
    int count;
    uint32_t keys[MOST_COLORS];
    struct {
        uint32_t key, index;
    } slots[SLOTS];
} Colors;

typedef struct {
    const Image *image;
    int row, rows;
    bool flat; // at most MOST_COLORS colours
    Colors colors;
    uint8_t *indices;                // of the band's pixels, into its colours
    uint8_t in_palette[MOST_COLORS]; // the palette's index of each of its colours
    int bits;                        // of an index; 0 if the picture has no palette
    bool last;
    uint8_t *stream; // room for zlib's header, the compressed rows, room for their checksum
    size_t size, row_bytes;
    uLong check; // Adler-32 of the rows
} Band;

enum { HEADER = 2, CHECKSUM = 4 };

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
    Band *band = (Band *)given + i;
    const uint8_t *rgb = image_bytes(band->image, (Pixel){0, band->row});
    const size_t width = (size_t)band->image->size.width, all = (size_t)band->rows * width;
    for (size_t k = 0; k < all; k += SOME) {
        size_t count = all - k < SOME ? all - k : SOME;
        if (k >= width && width >= count &&
            memcmp(rgb + 3 * k, rgb + 3 * (k - width), 3 * count) == 0)
            memcpy(band->indices + k, band->indices + k - width, count);
        else if (!find_indices(&band->colors, rgb + 3 * k, count, band->indices + k))
            return;
    }
    band->flat = true;
}

// The colours of all bands, in the order of the pixels. False if there are too many.
static bool join_colors(Band *bands, int count, Colors *palette)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < bands[i].colors.count; k++) {
            int index = bands[i].flat ? index_of(palette, bands[i].colors.keys[k]) : -1;
            if (index < 0)
                return false;
            bands[i].in_palette[k] = (uint8_t)index;
        }
    return true;
}

// ---- bands ------------------------------------------------------------------------------------

// The indices of a row of the band, as few bits each as will do.
static void pack(const Band *band, int row, uint8_t *to)
{
    int width = band->image->size.width, in_byte = 8 / band->bits;
    const uint8_t *indices = band->indices + (size_t)row * (size_t)width;
    for (int left = 0; left < width; left += in_byte) {
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

// PNG's filter: each byte less the one above it.
static void filter(const Band *band, uint8_t *packed, uint8_t *to)
{
    size_t size = band->row_bytes;
    uint8_t *spare = packed + size;
    memset(spare, 0, size);
    const uint8_t *above = band->row > 0 ? bytes_of(band - 1, BAND_ROWS - 1, spare) : spare;
    for (int row = 0; row < band->rows; row++) {
        const uint8_t *bytes = bytes_of(band, row, row % 2 == 0 ? packed : spare);
        *to++ = PNG_FILTER_VALUE_UP;
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
    band->stream = malloc(HEADER + room + CHECKSUM);
    z.next_out = band->stream == NULL ? NULL : band->stream + HEADER;
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

// If there is not enough memory, the band has no stream.
static void encode(void *given, int i)
{
    Band *band = (Band *)given + i;
    size_t size = (size_t)band->rows * (band->row_bytes + 1);
    uint8_t *packed = malloc(2 * band->row_bytes), *rows = malloc(size);
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
    Band *bands;
    int count;
    Colors palette; // empty: none
    FILE *file;
} Picture;

static void write_header(png_structp png, png_infop info, const Picture *picture)
{
    Resolution size = picture->bands[0].image->size;
    int bits = picture->bands[0].bits, count = picture->palette.count;
    png_color colors[MOST_COLORS];
    for (int i = 0; i < count; i++) {
        uint32_t key = picture->palette.keys[i];
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
    static const uint8_t header[HEADER] = {0x78, 0x01};
    uint8_t *start = band->stream + HEADER;
    size_t size = band->size;
    if (band->row == 0) {
        start = memcpy(band->stream, header, HEADER);
        size += HEADER;
    }
    if (band->last) {
        png_save_uint_32(start + size, (png_uint_32)check);
        size += CHECKSUM;
    }
    png_write_chunk(png, (png_const_bytep) "IDAT", start, size);
    free(band->stream);
    band->stream = NULL;
}

static void write_picture(png_structp png, png_infop info, Picture *picture)
{
    uLong check = 1;
    write_header(png, info, picture);
    for (int first = 0; first < picture->count; first += BANDS_AT_ONCE) {
        int rest = picture->count - first, count = rest < BANDS_AT_ONCE ? rest : BANDS_AT_ONCE;
        workers_do(count, encode, picture->bands + first);
        for (Band *band = picture->bands + first; count > 0; band++, count--) {
            if (band->stream == NULL)
                png_error(png, "out of memory");
            check = adler32_combine(check, band->check,
                                    (z_off_t)((size_t)band->rows * (band->row_bytes + 1)));
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

// ---- pictures ---------------------------------------------------------------------------------

// Cuts a picture into bands, and finds its palette.
static void prepare(Picture *picture, const Image *image, uint8_t *indices)
{
    size_t width = (size_t)image->size.width;
    for (int i = 0; i < picture->count; i++) {
        int row = i * BAND_ROWS, rest = image->size.height - row;
        picture->bands[i] = (Band){.image = image,
                                   .row = row,
                                   .rows = rest < BAND_ROWS ? rest : BAND_ROWS,
                                   .indices = indices + (size_t)row * width,
                                   .last = rest <= BAND_ROWS};
    }
    workers_do(picture->count, find_colors, picture->bands);
    bool flat = join_colors(picture->bands, picture->count, &picture->palette);
    int n = picture->palette.count, bits = !flat ? 0 : n > 16 ? 8 : n > 4 ? 4 : n > 2 ? 2 : 1;
    for (int i = 0; i < picture->count; i++) {
        picture->bands[i].bits = bits;
        picture->bands[i].row_bytes = flat ? (width * (size_t)bits + 7) / 8 : 3 * width;
    }
}

bool image_print_png(FILE *file, const Image *image, const char *path, Message *message)
{
    Message words = {"out of memory"};
    errno = 0;
    Picture picture = {.count = (image->size.height + BAND_ROWS - 1) / BAND_ROWS, .file = file};
    picture.bands = calloc((size_t)picture.count, sizeof *picture.bands);
    uint8_t *indices = malloc((size_t)image->size.width * (size_t)image->size.height);
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &words, keep_words, ignore_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    bool done = false;
    if (info != NULL && picture.bands != NULL && indices != NULL) {
        prepare(&picture, image, indices);
        done = try_to_write(png, info, &picture);
    }
    for (int i = 0; picture.bands != NULL && i < picture.count; i++)
        free(picture.bands[i].stream);
    png_destroy_write_struct(&png, &info);
    free(picture.bands);
    free(indices);
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
