// image_png.c - an image as a PNG file, for programs in a page: no library, and not compressed.
//
// Stands in for common/image_png.c, whose libpng needs longjmp. The pixels are the same.
#include "common/image.h"

#include "common/whole_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void put_number(uint8_t *into, uint32_t number)
{
    for (int i = 0; i < 4; i++)
        into[i] = (uint8_t)(number >> (24 - 8 * i));
}

// The checksum of PNG's parts: CRC-32.
static uint32_t checksum(const uint8_t *bytes, size_t size)
{
    uint32_t sum = ~0u;
    for (size_t i = 0; i < size; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (0xedb88320u & (0u - (sum & 1)));
    }
    return ~sum;
}

// A part: its size, its name and contents (together in bytes), their checksum.
static bool put_part(FILE *file, const uint8_t *bytes, size_t size)
{
    uint8_t before[4], after[4];
    put_number(before, (uint32_t)(size - 4));
    put_number(after, checksum(bytes, size));
    return fwrite(before, 4, 1, file) == 1 && fwrite(bytes, size, 1, file) == 1 &&
           fwrite(after, 4, 1, file) == 1;
}

// zlib's format: each row is a stored block (its size, and the size's complement), and in the end
// the checksum of all rows, Adler-32. In front of the pixels of a row stands how it is filtered:
// not.
static size_t put_rows(uint8_t *into, const Image *image)
{
    size_t width = 3 * (size_t)image->size.width, size = width + 1;
    uint8_t *at = into;
    uint32_t low = 1, high = 0;
    *at++ = 0x78;
    *at++ = 0x01;
    for (int row = 0; row < image->size.height; row++) {
        *at++ = row == image->size.height - 1;
        *at++ = (uint8_t)size;
        *at++ = (uint8_t)(size >> 8);
        *at++ = (uint8_t)~size;
        *at++ = (uint8_t)(~size >> 8);
        *at = 0;
        memcpy(at + 1, image->rgb + (size_t)row * width, width);
        for (size_t i = 0; i < size; i++) {
            low = (low + at[i]) % 65521;
            high = (high + low) % 65521;
        }
        at += size;
    }
    put_number(at, high << 16 | low);
    return (size_t)(at + 4 - into);
}

bool image_print_png(FILE *file, const Image *image, const char *path, Message *message)
{
    static const uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t header[17] = {'I', 'H', 'D', 'R', 0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0};
    put_number(header + 4, (uint32_t)image->size.width);
    put_number(header + 8, (uint32_t)image->size.height);
    size_t height = (size_t)image->size.height, width = (size_t)image->size.width;
    uint8_t *data = malloc(4 + 6 + height * (3 * width + 6));
    errno = ENOMEM;
    bool good = data != NULL && fwrite(signature, sizeof signature, 1, file) == 1 &&
                put_part(file, header, sizeof header);
    if (good) {
        memcpy(data, "IDAT", 4);
        good = put_part(file, data, 4 + put_rows(data + 4, image)) &&
               put_part(file, (const uint8_t *)"IEND", 4) && fflush(file) == 0;
    }
    free(data);
    return good || message_set(message, "%s: cannot write the picture: %s", path, strerror(errno));
}

static bool write_png(FILE *file, const void *given, const char *path, Message *message)
{
    return image_print_png(file, given, path, message);
}

bool image_write_png(const Image *image, const char *path, Message *message)
{
    return file_write_whole(path, write_png, image, message);
}
