// same_picture.c - do two PNG files hold the same picture?
//
// The same size and the same decoded 8-bit RGB, however each was encoded. Exit status 0 where they
// do, 1 with the first difference where not, 2 where one cannot be read.
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

static png_bytep read_picture(const char *path, png_image *image)
{
    *image = (png_image){.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(image, path)) {
        fprintf(stderr, "%s: %s\n", path, image->message);
        exit(2);
    }
    image->format = PNG_FORMAT_RGB;
    png_bytep pixels = malloc(PNG_IMAGE_SIZE(*image));
    if (pixels == NULL || !png_image_finish_read(image, NULL, pixels, 0, NULL)) {
        fprintf(stderr, "%s: %s\n", path, image->message);
        exit(2);
    }
    return pixels;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "Usage: %s ONE.png OTHER.png\n", argv[0]);
        return 2;
    }
    png_image one, other;
    png_bytep a = read_picture(argv[1], &one), b = read_picture(argv[2], &other);
    int status = 0;
    if (one.width != other.width || one.height != other.height) {
        printf("%u x %u pixels against %u x %u\n", one.width, one.height, other.width,
               other.height);
        status = 1;
    }
    for (size_t i = 0; status == 0 && i < PNG_IMAGE_SIZE(one); i++)
        if (a[i] != b[i]) {
            size_t pixel = i / 3;
            printf("differ first in column %zu, row %zu\n", pixel % one.width, pixel / one.width);
            status = 1;
        }
    free(a);
    free(b);
    return status;
}
