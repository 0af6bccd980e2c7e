// image_png.c - an image as a PNG file, by libpng, whole or not at all.
#include "common/image.h"

#include "common/whole_file.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

// Everything between here and the jump lives in the caller, so that nothing is lost by it.
static bool encode(png_structp png, png_infop info, const Image *image, FILE *file)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)image->size.width, (png_uint_32)image->size.height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int row = 0; row < image->size.height; row++)
        png_write_row(png, image->rgb + 3 * (size_t)row * (size_t)image->size.width);
    png_write_end(png, info);
    return true;
}

static bool write_png(FILE *file, const void *given, const char *path, Message *message)
{
    const Image *image = given;
    Message words = {"out of memory"};
    errno = 0;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &words, keep_words, ignore_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    bool done = info != NULL && encode(png, info, image, file);
    png_destroy_write_struct(&png, &info);
    if (done && fflush(file) == 0)
        return true;
    return message_set(message, "%s: cannot write the picture: %s", path,
                       errno != 0 ? strerror(errno) : words.text);
}

bool image_write_png(const Image *image, const char *path, Message *message)
{
    return file_write_whole(path, write_png, image, message);
}
