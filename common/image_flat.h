// image_flat.h - an image of few colours that are known before it is drawn.
//
// A program that draws many pixels at a time sets the number of each pixel's colour, one byte
// instead of three. As soon as rows are set, they are encoded for the PNG, by the thread that set
// the last of them.
#ifndef COMMON_IMAGE_FLAT_H
#define COMMON_IMAGE_FLAT_H

#include "common/image_bands.h"

#include <stdatomic.h>

enum { FLAT_COLORS = 32 }; // at most: a set of them is the bits of one number

typedef struct {
    const Image *image;
    uint8_t *numbers; // one byte a pixel, row by row: the number of its colour
    int color_count;
    uint32_t colors[FLAT_COLORS]; // red + 256 green + 65536 blue; all different, in rising order
    uint32_t expected;            // bit i: probably some pixel has colour i
    atomic_uint seen;             // bit i: some pixel has it
    Band *bands;
    atomic_int *missing; // for each band: the rows that it waits for
} FlatImage;

// From now on the pixels of the image are not in image->rgb, but in the numbers of a flat image.
// The colours may come in any order, and several times. All but the first ones, which are unlikely,
// are expected in the picture: if others are seen, all bands are encoded once more. False, and
// nothing is changed, if there are too many colours or not enough memory, or if another image is
// flat. Call image_unflatten before the Image is freed, or used in another way.
bool image_flatten(const Image *image, const uint32_t *colors, int count, int unlikely);
void image_unflatten(const Image *image);

// The flat image of this image; NULL if it is not flat. It is not a field of Image, because
// students read what an Image consists of.
FlatImage *image_flat(const Image *image);

// The number of a colour. It must be one of image_flatten's.
int flat_number(const FlatImage *flat, uint32_t color);

// Some pixels have these colours: the bits of a set.
static inline void flat_are_seen(FlatImage *flat, uint32_t set)
{
    if (set & ~atomic_load_explicit(&flat->seen, memory_order_relaxed))
        atomic_fetch_or(&flat->seen, set);
}

// These rows are set, and their colours are seen. Each row is given once, by any thread.
void flat_rows_are_set(FlatImage *flat, int row, int count);

// When all rows are set: the bands have a palette of the colours that are seen. Returns their
// number; colors has room for FLAT_COLORS.
int flat_palette(FlatImage *flat, uint32_t *colors);

#endif
