// same_picture.c - do two PNG files hold the same picture?
//
// The same size and the same decoded 8-bit RGB, however each was encoded. Exit status 0 where they
// do, 1 with the first difference where not, 2 where one cannot be read. ONE.png OTHER.png PIXELS:
// so many may differ; with MEAN, by more than 1, and all by at most so much on average.
#include <math.h>
#include <png.h>
#include <stdbool.h>
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

// How far apart two pixels are: the largest of three differences of bytes.
static int apart(const png_byte *a, const png_byte *b)
{
    int most = 0;
    for (int i = 0; i < 3; i++) {
        int d = abs(a[i] - b[i]);
        most = d > most ? d : most;
    }
    return most;
}

int main(int argc, char **argv)
{
    if (argc < 3 || argc > 5) {
        fprintf(stderr, "Usage: %s ONE.png OTHER.png [PIXELS [MEAN]]\n", argv[0]);
        return 2;
    }
    long allowed = argc > 3 ? atol(argv[3]) : 0;
    double most_mean = argc > 4 ? atof(argv[4]) : NAN;
    png_image one, other;
    png_bytep a = read_picture(argv[1], &one), b = read_picture(argv[2], &other);
    bool same = one.width == other.width && one.height == other.height;
    if (!same)
        printf("%u x %u pixels against %u x %u\n", one.width, one.height, other.width,
               other.height);
    size_t pixels = (size_t)one.width * one.height, first = 0;
    long different = 0;
    double sum = 0;
    for (size_t i = 0; same && i < pixels; i++) {
        int d = apart(a + 3 * i, b + 3 * i);
        sum += d;
        if (d > (isnan(most_mean) ? 0 : 1) && different++ == 0)
            first = i;
    }
    if (different > allowed || sum / (double)pixels > most_mean) {
        printf("%ld pixels differ, first in column %zu, row %zu; by %g on average\n", different,
               first % one.width, first / one.width, sum / (double)pixels);
        same = false;
    }
    free(a);
    free(b);
    return same ? 0 : 1;
}
