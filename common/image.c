// image.c - pixels in memory. Its PNG is in image_png.c.
#include "common/image.h"

#include "common/failed_check.h"

#include <stdio.h>
#include <stdlib.h>

bool image_create(Image *image, Resolution size, Message *message)
{
    *image = (Image){.size = size};
    if (size.width < 1 || size.height < 1 || size.width > IMAGE_MAX_SIDE ||
        size.height > IMAGE_MAX_SIDE)
        return message_set(message, "an image of %d x %d pixels, expected 1 to %d each way",
                           size.width, size.height, IMAGE_MAX_SIDE);
    image->rgb = calloc((size_t)size.width * (size_t)size.height, 3);
    if (image->rgb == NULL)
        return message_set(message, "no memory for an image of %d x %d pixels", size.width,
                           size.height);
    return true;
}

void image_free(Image *image)
{
    free(image->rgb);
    image->rgb = NULL;
}

static ImageWatch *image_watched;
static void *image_watcher;

void image_watch(ImageWatch *watch, void *watcher)
{
    image_watched = watch;
    image_watcher = watcher;
}

void(image_set)(Image *image, Pixel pixel, Color color)
{
    if (pixel.column < 0 || pixel.column >= image->size.width || pixel.row < 0 ||
        pixel.row >= image->size.height)
        check_failed(CHECKED_PIXEL, (long[]){pixel.column, pixel.row, image->size.width,
                                             image->size.height, image->set_count});
    uint8_t *rgb = image_bytes(image, pixel);
    for (int i = 0; i < 3; i++)
        rgb[i] = byte_from_color(color[i]);
    if (++image->set_count % IMAGE_PROGRESS_STEP == 0 && image->progress != NULL)
        image->progress(image);
    if (image_watched != NULL)
        image_watched(image, pixel, image_watcher);
}
