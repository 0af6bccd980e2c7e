// image.h - the image: bytes of red, green and blue, and its PNG.
//
// Colors are numbers from 0 to 1; a pixel holds them as bytes, round(255 c), with what lies
// outside clamped. No gamma.
#ifndef COMMON_IMAGE_H
#define COMMON_IMAGE_H

#include "common/failed_check.h"
#include "common/screen.h"
#include "common/text.h"
#include "common/vec3.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

// Red, green, blue, each from 0 to 1.
typedef vec3 Color;

// Neither side is longer; 16384 x 16384 is 805 MB.
#define IMAGE_MAX_SIDE 16384

typedef struct Image Image;
struct Image {
    Resolution size;
    uint8_t *rgb; // three bytes a pixel, row by row from the top

    // Called, where not NULL, after every IMAGE_PROGRESS_STEP pixels that were set.
    void (*progress)(const Image *image);
    long set_count; // how often a pixel was set
};

enum { IMAGE_PROGRESS_STEP = 1024 };

// A black image. False, and a message, where the size is out of range or memory is short.
bool image_create(Image *image, Resolution size, Message *message);
void image_free(Image *image);

// The index of a pixel, which must be inside the image, and the place of its three bytes.
static inline size_t image_index(const Image *image, Pixel pixel)
{
    return (size_t)pixel.row * (size_t)image->size.width + (size_t)pixel.column;
}

static inline uint8_t *image_bytes(const Image *image, Pixel pixel)
{
    return image->rgb + 3 * image_index(image, pixel);
}

// 255 c, rounded, from 0 to 255; 0 where c is not a number.
static inline uint8_t byte_from_color(double c)
{
    double x = c > 0 ? c < 1 ? 255 * c : 255 : 0;
    int whole = (int)x;
    return (uint8_t)(whole + (x - whole >= 0.5));
}

// Colors one pixel. It must lie in the image: where it does not, the program ends, and says so.
void image_set(Image *image, Pixel pixel, Color color);

// From now on, calls a function after each image_set, with the pixel and what the watcher keeps.
// NULL: none. It is no part of an Image, because students read what an Image consists of.
typedef void ImageWatch(const Image *image, Pixel pixel, void *watcher);
void image_watch(ImageWatch *watch, void *watcher);

// Writes a PNG, whole or not at all (whole_file.h). False, and a message, if it could not.
bool image_write_png(const Image *image, const char *path, Message *message);

// The same into an open file; messages name the path.
bool image_print_png(FILE *file, const Image *image, const char *path, Message *message);

// Last, because messages about a call are to point at the call, not at the macro.
#pragma GCC system_header
#ifndef WITHOUT_LINES_OF_CALLS
#define image_set(...) (called_in(__FILE__, __LINE__), image_set(__VA_ARGS__))
#endif

#endif
