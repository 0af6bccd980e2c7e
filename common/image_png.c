// image_png.c - an image as a PNG file, by libpng's simplified interface, whole or not at all.
#include "common/image.h"

#include "common/whole_file.h"

#include <errno.h>
#include <png.h>
#include <string.h>

// PNG_IMAGE_FLAG_FAST: most pictures are looked at once, and then drawn again.
bool image_print_png(FILE *file, const Image *image, const char *path, Message *message)
{
    png_image png = {.version = PNG_IMAGE_VERSION,
                     .width = (png_uint_32)image->size.width,
                     .height = (png_uint_32)image->size.height,
                     .format = PNG_FORMAT_RGB,
                     .flags = PNG_IMAGE_FLAG_FAST};
    errno = 0;
    if (png_image_write_to_stdio(&png, file, 0, image->rgb, 0, NULL) != 0 && fflush(file) == 0)
        return true;
    return message_set(message, "%s: cannot write the picture: %s", path,
                       errno != 0 ? strerror(errno) : png.message);
}

static bool write_png(FILE *file, const void *given, const char *path, Message *message)
{
    return image_print_png(file, given, path, message);
}

bool image_write_png(const Image *image, const char *path, Message *message)
{
    return file_write_whole(path, write_png, image, message);
}
