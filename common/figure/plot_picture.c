// plot_picture.c - figures: pictures, which are in the script as PNGs in base64.
#include "common/figure/plot_internal.h"

#include <math.h>
#include <stdlib.h>

enum { PARTS = 20 }; // in each direction

// ---- base64 -----------------------------------------------------------------------------------

static void print_base64(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    enum { A_LINE = 32 }; // groups of 3 bytes
    for (size_t i = 0; i < size; i += 3) {
        size_t count = size - i < 3 ? size - i : 3;
        unsigned group = (unsigned)bytes[i] << 16 | (count > 1 ? (unsigned)bytes[i + 1] << 8 : 0) |
                         (count > 2 ? bytes[i + 2] : 0);
        for (size_t k = 0; k < 4; k++)
            putc(k <= count ? digits[group >> (18 - 6 * k) & 63] : '=', out);
        if (i / 3 % A_LINE == A_LINE - 1 || size - i <= 3)
            putc('\n', out);
    }
}

// False, and a message on stderr, if there is not enough memory.
static bool print_picture(FILE *out, const char *name, const Image *image)
{
    char *bytes;
    size_t size;
    Message message;
    FILE *png = open_memstream(&bytes, &size);
    bool done = png != NULL && image_print_png(png, image, name, &message);
    if (png != NULL)
        fclose(png);
    if (done)
        print_base64(out, (const unsigned char *)bytes, size);
    else
        fprintf(stderr, "%s\n", png != NULL ? message.text : "out of memory");
    if (png != NULL)
        free(bytes);
    return done;
}

// ---- mean colors -----------------------------------------------------------------------------

typedef struct {
    double rgb[PARTS * PARTS][3];
} MeanColors;

static int part_of(int i, int length)
{
    return (int)((long)i * PARTS / length);
}

static void find_means(const Image *image, MeanColors *means)
{
    long counts[PARTS * PARTS] = {0};
    *means = (MeanColors){0};
    for (int row = 0; row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++) {
            const uint8_t *rgb = image_bytes(image, (Pixel){column, row});
            int part =
                part_of(row, image->size.height) * PARTS + part_of(column, image->size.width);
            counts[part]++;
            for (int i = 0; i < 3; i++)
                means->rgb[part][i] += rgb[i];
        }
    for (int part = 0; part < PARTS * PARTS; part++)
        for (int i = 0; i < 3 && counts[part] > 0; i++)
            means->rgb[part][i] /= (double)counts[part];
}

// Whether rows of numbers, as below, differ by no more than allowed.
static bool are_near(const MeanColors *means, const char *rows, double allowed)
{
    for (int part = 0; part < PARTS * PARTS; part++)
        for (int i = 0; i < 3; i++) {
            char *end;
            double x = strtod(rows, &end);
            if (end == rows || !(fabs(x - means->rgb[part][i]) <= allowed))
                return false;
            rows = end;
        }
    return true;
}

// ---- all of it --------------------------------------------------------------------------------

// Where the picture goes. In a page that is beside the script, because gnuplot draws only a frame
// (common/figure/plot.gp): the script has its name.
static FILE *picture_begin(const Plot *plot, const char *yours, const char *name)
{
    FILE *out = plot->pictures != NULL ? plot->pictures : plot->script;
    if (out != plot->script)
        fprintf(plot->script, "$%s%s << EOD\n# beside the script\nEOD\n", yours, name);
    fprintf(out, "$%s%s << EOD\n# a PNG in base64\n", yours, name);
    return out;
}

void plot_picture(Plot *plot, const char *name, const Image *image, double allowed)
{
    Text parts = text_of("%s_parts", name);
    const char *right_means, *right_picture;
    MeanColors means;
    plot_block_end(plot);
    find_means(image, &means);
    size_t means_size = plot_right_rows(plot, parts.s, &right_means);
    size_t picture_size = plot_right_rows(plot, name, &right_picture);
    bool has_right = means_size > 0 && picture_size > 0;
    bool is_wrong = has_right && !are_near(&means, right_means, allowed);
    if (has_right)
        fprintf(picture_begin(plot, "", name), "%.*sEOD\n", (int)picture_size, right_picture);
    if (!has_right || is_wrong) {
        FILE *out = picture_begin(plot, has_right ? "your_" : "", name);
        plot->failed = !print_picture(out, name, image) || plot->failed;
        fprintf(out, "EOD\n");
    }
    fprintf(plot->script, "$%s << EOD\n# the mean red, green, blue of %d x %d parts\n", parts.s,
            PARTS, PARTS);
    for (int part = 0; part < PARTS * PARTS; part++)
        fprintf(plot->script, "%.3f %.3f %.3f\n", means.rgb[part][0], means.rgb[part][1],
                means.rgb[part][2]);
    fprintf(plot->script, "EOD\n");
    plot->wrong = plot->wrong || is_wrong;
}
