// image_png.c - an image as a PNG file, by libpng, whole or not at all.
//
// The picture is written beside its place under another name and renamed when it is complete,
// so that whoever looks sees the old picture or the new one, never half of one.
#include "common/image.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

static bool write_to(FILE *file, const Image *image, const char *path, Message *message)
{
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

static bool close_written(FILE *file, const char *path, Message *message)
{
    if (fclose(file) == 0)
        return true;
    return message_set(message, "%s: cannot write the picture: %s", path, strerror(errno));
}

// The file a path leads to, links followed, so that a rename replaces the file and not the link.
static char *final_path(const char *path)
{
    char *real = realpath(path, NULL);
    return real != NULL ? real : strdup(path);
}

static bool replace_file(const Image *image, const char *path, mode_t mode, Message *message)
{
    char *target = final_path(path);
    char *temporary = target == NULL ? NULL : malloc(strlen(target) + sizeof "./.XXXXXX");
    if (temporary == NULL) {
        free(target);
        return message_set(message, "%s: out of memory", path);
    }
    char *slash = strrchr(target, '/');
    sprintf(temporary, "%.*s/.XXXXXX", slash == NULL ? 1 : (int)(slash - target),
            slash == NULL ? "." : target);

    bool done = false;
    int descriptor = mkstemp(temporary);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    if (file == NULL) {
        message_set(message, "%s: cannot create a file beside it: %s", path, strerror(errno));
    } else {
        done = fchmod(descriptor, mode) == 0 ||
               message_set(message, "%s: cannot set its permissions: %s", path, strerror(errno));
        done = done && write_to(file, image, path, message);
        done = close_written(file, path, message) && done;
        if (done && rename(temporary, target) != 0)
            done = message_set(message, "%s: cannot replace it: %s", path, strerror(errno));
    }
    if (descriptor >= 0 && file == NULL)
        close(descriptor);
    if (descriptor >= 0 && !done)
        unlink(temporary);
    free(temporary);
    free(target);
    return done;
}

bool image_path_is_writable(const char *path, Message *message)
{
    struct stat status;
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode))
            return message_set(message, "%s: is a folder, expected a file name", path);
        if (access(path, W_OK) != 0)
            return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
        return true;
    }
    if (errno != ENOENT)
        return message_set(message, "%s: cannot be written: %s", path, strerror(errno));
    if (lstat(path, &status) == 0)
        return message_set(message, "%s: is a link that leads nowhere", path);
    const char *slash = strrchr(path, '/');
    char *folder = slash == NULL ? strdup(".") : strndup(path, (size_t)(slash - path) + 1);
    bool writable = folder != NULL && access(folder, W_OK | X_OK) == 0;
    if (!writable)
        message_set(message, "%s: cannot write into the folder '%s': %s", path,
                    folder != NULL ? folder : "", strerror(errno));
    free(folder);
    return writable;
}

bool image_write_png(const Image *image, const char *path, Message *message)
{
    if (!image_path_is_writable(path, message))
        return false;
    struct stat status;
    bool exists = stat(path, &status) == 0;
    if (!exists || S_ISREG(status.st_mode)) {
        mode_t mask = umask(0);
        umask(mask);
        return replace_file(image, path, exists ? status.st_mode & 0777 : 0666 & ~mask, message);
    }
    FILE *device = fopen(path, "wb");
    if (device == NULL)
        return message_set(message, "%s: cannot be opened: %s", path, strerror(errno));
    bool done = write_to(device, image, path, message);
    return close_written(device, path, message) && done;
}
