// image_flat.c - an image of few colours: its numbers of colours, and when its bands are encoded.
#include "common/image_flat.h"

#include "common/large_pages.h"

#include <stdlib.h>

static FlatImage *the_flat_image; // there is one at a time

FlatImage *image_flat(const Image *image)
{
    return the_flat_image != NULL && the_flat_image->image == image ? the_flat_image : NULL;
}

// Adds a colour in its place, if it is new. False if there are too many.
static bool add_color(FlatImage *flat, uint32_t color)
{
    int place = 0;
    while (place < flat->color_count && flat->colors[place] < color)
        place++;
    if (place < flat->color_count && flat->colors[place] == color)
        return true;
    if (flat->color_count == FLAT_COLORS)
        return false;
    for (int i = flat->color_count++; i > place; i--)
        flat->colors[i] = flat->colors[i - 1];
    flat->colors[place] = color;
    return true;
}

// The numbers of colours of this set become 0, 1, 2 and so on.
static void set_palette(Band *band, uint32_t set)
{
    int count = 0;
    for (int i = 0; i < FLAT_COLORS; i++)
        if (set >> i & 1)
            band->in_palette[i] = (uint8_t)count++;
    band->bits = bits_of_palette(count);
}

static bool make_bands(FlatImage *flat)
{
    const Image *image = flat->image;
    const size_t size = (size_t)image->size.width * (size_t)image->size.height;
    const int count = bands_count(image);
    flat->numbers = large_memory(size);
    flat->missing = malloc((size_t)count * sizeof *flat->missing);
    if (flat->numbers == NULL || flat->missing == NULL ||
        (flat->bands = bands_of(image, flat->numbers)) == NULL)
        return false;
    for (int i = 0; i < count; i++) {
        set_palette(&flat->bands[i], flat->expected);
        atomic_init(&flat->missing[i], flat->bands[i].rows + (i > 0 ? 1 : 0));
    }
    return true;
}

static void flat_free(FlatImage *flat)
{
    if (flat != NULL) {
        bands_free(flat->bands, flat->image);
        free(flat->numbers);
        free(flat->missing);
    }
    free(flat);
}

bool image_flatten(const Image *image, const uint32_t *colors, int count, int unlikely)
{
    image_unflatten(image);
    if (the_flat_image != NULL)
        return false;
    FlatImage *flat = calloc(1, sizeof *flat);
    bool done = flat != NULL;
    if (done)
        flat->image = image;
    for (int i = 0; i < count && done; i++)
        done = add_color(flat, colors[i]);
    for (int i = unlikely; i < count && done; i++)
        flat->expected |= 1U << flat_number(flat, colors[i]);
    done = done && make_bands(flat);
    if (done)
        the_flat_image = flat;
    else
        flat_free(flat);
    return done;
}

void image_unflatten(const Image *image)
{
    if (image_flat(image) == NULL)
        return;
    flat_free(the_flat_image);
    the_flat_image = NULL;
}

int flat_number(const FlatImage *flat, uint32_t color)
{
    int i = 0;
    while (i < flat->color_count - 1 && flat->colors[i] != color)
        i++;
    return i;
}

// The first row of a band is filtered by the row above, so the band waits for that as well.
static void have_rows(FlatImage *flat, int band, int count)
{
    if (atomic_fetch_sub(&flat->missing[band], count) == count)
        band_encode(flat->bands, band);
}

void flat_rows_are_set(FlatImage *flat, int row, int count)
{
    for (int end = row + count; row < end;) {
        int band = row / BAND_ROWS, band_end = (band + 1) * BAND_ROWS;
        int until = end < band_end ? end : band_end;
        have_rows(flat, band, until - row);
        if (until == band_end && until < flat->image->size.height)
            have_rows(flat, band + 1, 1);
        row = until;
    }
}

int flat_palette(FlatImage *flat, uint32_t *colors)
{
    const uint32_t seen = atomic_load(&flat->seen);
    int count = 0;
    for (int i = 0; i < flat->color_count; i++)
        if (seen >> i & 1)
            colors[count++] = flat->colors[i];
    for (int i = 0; i < bands_count(flat->image) && seen != flat->expected; i++) {
        free(flat->bands[i].stream);
        flat->bands[i].stream = NULL;
        set_palette(&flat->bands[i], seen);
    }
    return count;
}
