// same_picture.c - do two PNG files hold the same picture?
//
// The same size and the same decoded 8-bit RGB, however each was encoded. Exit status 0 if they
// are the same, 1 with the first difference if not, 2 if one cannot be read. ONE.png OTHER.png
// PIXELS: the number of pixels that may differ; with MEAN, by more than 1, and all by at most so
// much on average. --blocks MOST: the means of each 8 x 8 pixels differ by at most so much, as for
// a picture that was given a palette.
#include <math.h>
#include <png.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

enum { BLOCK = 8 };

// The largest difference of the means of a block, of three.
static double block_apart(const png_byte *a, const png_byte *b, const png_image *image,
                          png_uint_32 left, png_uint_32 top)
{
    double sum[3] = {0}, most = 0;
    int count = 0;
    for (png_uint_32 row = top; row < top + BLOCK && row < image->height; row++)
        for (png_uint_32 column = left; column < left + BLOCK && column < image->width;
             column++, count++)
            for (size_t i = 0; i < 3; i++) {
                size_t at = 3 * ((size_t)row * image->width + column) + i;
                sum[i] += a[at] - b[at];
            }
    for (int i = 0; i < 3; i++) {
        double mean = (sum[i] < 0 ? -sum[i] : sum[i]) / count;
        most = mean > most ? mean : most;
    }
    return most;
}

static int compare_blocks(const char *one_path, const char *other_path, double allowed)
{
    png_image one, other;
    png_bytep a = read_picture(one_path, &one), b = read_picture(other_path, &other);
    bool same = one.width == other.width && one.height == other.height;
    double most = 0;
    png_uint_32 where[2] = {0, 0};
    for (png_uint_32 top = 0; same && top < one.height; top += BLOCK)
        for (png_uint_32 left = 0; left < one.width; left += BLOCK) {
            double d = block_apart(a, b, &one, left, top);
            if (d > most) {
                most = d;
                where[0] = left;
                where[1] = top;
            }
        }
    printf("%s: the means of %d x %d pixels differ by at most %g, at (%u, %u)\n",
           same ? "same size" : "different sizes", BLOCK, BLOCK, most, where[0], where[1]);
    free(a);
    free(b);
    return !same || most > allowed;
}

int main(int argc, char **argv)
{
    if (argc == 5 && strcmp(argv[3], "--blocks") == 0)
        return compare_blocks(argv[1], argv[2], atof(argv[4]));
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
