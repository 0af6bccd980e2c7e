// pictures.c - how long writing a PNG takes, and how large it is, by libpng's settings.
//
// Usage: pictures FILE.png...: each is written again, in memory, with each setting; milliseconds of
// the processor's time, the median of 5, and bytes. As red, green and blue, and with a palette if
// it has few colours. The settings of common/image_png.c were chosen by these numbers.
#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <zlib.h>

enum { ROUNDS = 5, MOST_COLORS = 256 };

typedef struct {
    const char *name;
    int level, filters, strategy;
} Setting;
static const Setting settings[] = {
    {"libpng's defaults", Z_DEFAULT_COMPRESSION, -1, -1},
    {"stored", 0, PNG_FILTER_NONE, Z_DEFAULT_STRATEGY},
    {"level 1, no filter", 1, PNG_FILTER_NONE, Z_DEFAULT_STRATEGY},
    {"level 1, sub", 1, PNG_FILTER_SUB, Z_DEFAULT_STRATEGY},
    {"level 1, up", 1, PNG_FILTER_UP, Z_DEFAULT_STRATEGY},
    {"level 1, Paeth", 1, PNG_FILTER_PAETH, Z_DEFAULT_STRATEGY},
    {"level 1, any", 1, PNG_ALL_FILTERS, Z_DEFAULT_STRATEGY},
    {"level 3, up", 3, PNG_FILTER_UP, Z_DEFAULT_STRATEGY},
    {"level 6, no filter", 6, PNG_FILTER_NONE, Z_DEFAULT_STRATEGY},
    {"level 6, sub", 6, PNG_FILTER_SUB, Z_DEFAULT_STRATEGY},
    {"runs, no filter", 1, PNG_FILTER_NONE, Z_RLE},
    {"runs, sub", 1, PNG_FILTER_SUB, Z_RLE},
    {"runs, up", 1, PNG_FILTER_UP, Z_RLE},
};

typedef struct {
    uint32_t width, height;
    uint8_t *rgb, *indices;
    png_color colors[MOST_COLORS];
    int color_count; // 0: too many
} Picture;

static double processor_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static void count_bytes(png_structp png, png_bytep data, png_size_t size)
{
    (void)data;
    *(size_t *)png_get_io_ptr(png) += size;
}

static void flush_nothing(png_structp png)
{
    (void)png;
}

static size_t write_once(const Picture *picture, Setting setting, int by_palette)
{
    size_t bytes = 0;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    int n = picture->color_count;
    int bits = !by_palette || n > 16 ? 8 : n > 4 ? 4 : n > 2 ? 2 : 1;
    png_set_write_fn(png, &bytes, count_bytes, flush_nothing);
    png_set_IHDR(png, info, picture->width, picture->height, bits,
                 by_palette ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (setting.filters >= 0)
        png_set_filter(png, PNG_FILTER_TYPE_BASE, setting.filters);
    if (setting.strategy >= 0)
        png_set_compression_strategy(png, setting.strategy);
    if (setting.level >= 0)
        png_set_compression_level(png, setting.level);
    if (by_palette)
        png_set_PLTE(png, info, picture->colors, n);
    png_write_info(png, info);
    png_set_packing(png);
    for (size_t row = 0; row < picture->height; row++)
        png_write_row(png, by_palette ? picture->indices + row * picture->width
                                      : picture->rgb + 3 * row * picture->width);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void measure(const Picture *picture, Setting setting, int by_palette)
{
    double took[ROUNDS];
    size_t bytes = 0;
    for (int i = 0; i < ROUNDS; i++) {
        double began = processor_ms();
        bytes = write_once(picture, setting, by_palette);
        took[i] = processor_ms() - began;
    }
    qsort(took, ROUNDS, sizeof *took, by_value);
    printf(" %9.2f ms %9zu bytes", took[ROUNDS / 2], bytes);
}

static void find_colors(Picture *picture)
{
    size_t pixels = (size_t)picture->width * picture->height;
    int count = 0, last = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *rgb = picture->rgb + 3 * i;
        if (count == 0 || memcmp(&picture->colors[last], rgb, 3) != 0)
            for (last = 0; last < count && memcmp(&picture->colors[last], rgb, 3) != 0;)
                last++;
        if (last == MOST_COLORS)
            return;
        if (last == count)
            picture->colors[count++] = (png_color){rgb[0], rgb[1], rgb[2]};
        picture->indices[i] = (uint8_t)last;
    }
    picture->color_count = count;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        png_image png = {.version = PNG_IMAGE_VERSION};
        if (png_image_begin_read_from_file(&png, argv[i]) == 0)
            return 1;
        png.format = PNG_FORMAT_RGB;
        Picture picture = {.width = png.width, .height = png.height};
        picture.rgb = malloc(PNG_IMAGE_SIZE(png));
        picture.indices = malloc((size_t)png.width * png.height);
        if (picture.rgb == NULL || picture.indices == NULL ||
            png_image_finish_read(&png, NULL, picture.rgb, 0, NULL) == 0)
            return 1;
        find_colors(&picture);
        printf("%s, %u x %u, %d colours (0: many)\n", argv[i], picture.width, picture.height,
               picture.color_count);
        for (size_t k = 0; k < sizeof settings / sizeof settings[0]; k++) {
            printf("  %-18s", settings[k].name);
            measure(&picture, settings[k], 0);
            if (picture.color_count > 0)
                measure(&picture, settings[k], 1);
            printf("\n");
        }
        free(picture.rgb);
        free(picture.indices);
    }
    return 0;
}
