// picture_panels.c - three pictures side by side: yours, what was expected, and where they differ.
//
// Pixels are drawn as squares. In the third picture the pixels that are alike are dark and those
// that differ are bright.
#include "tests/judge/figure.h"

#include <stdlib.h>
#include <string.h>

enum {
    PANELS = 3,
    PANEL = 288,
    GAP = 16,
    LETTER = 6,
    HIGH = 8,
    SCALE = 2,
    HEAD = 3 * HIGH * SCALE / 2
};

static const char *const words[PANELS] = {"yours", "expected", "difference"};

// Seven rows of five bits, the leftmost the highest.
static const struct {
    char letter;
    unsigned char rows[7];
} letters[] = {
    {'c', {0, 0, 14, 16, 16, 17, 14}}, {'d', {1, 1, 13, 19, 17, 17, 15}},
    {'e', {0, 0, 14, 17, 31, 16, 14}}, {'f', {6, 9, 8, 28, 8, 8, 8}},
    {'i', {4, 0, 12, 4, 4, 4, 14}},    {'n', {0, 0, 22, 25, 17, 17, 17}},
    {'o', {0, 0, 14, 17, 17, 17, 14}}, {'p', {0, 0, 30, 17, 30, 16, 16}},
    {'r', {0, 0, 22, 25, 16, 16, 16}}, {'s', {0, 0, 15, 16, 14, 1, 30}},
    {'t', {8, 8, 28, 8, 8, 9, 6}},     {'u', {0, 0, 17, 17, 17, 19, 13}},
    {'x', {0, 0, 17, 10, 4, 10, 17}},  {'y', {0, 0, 17, 17, 15, 1, 14}},
};

static void fill(Image *image, int x, int y, int width, int height, Color color)
{
    for (int row = y; row < y + height; row++)
        for (int column = x; column < x + width; column++)
            image_set(image, (Pixel){column, row}, color);
}

static void write_letter(Image *image, int x, int y, char letter, Color ink)
{
    for (size_t i = 0; i < sizeof letters / sizeof letters[0]; i++)
        for (int bit = 0; letters[i].letter == letter && bit < 35; bit++)
            if (letters[i].rows[bit / 5] >> (4 - bit % 5) & 1)
                fill(image, x + bit % 5 * SCALE, y + bit / 5 * SCALE, SCALE, SCALE, ink);
}

static Color color_at(const Image *image, size_t pixel)
{
    const uint8_t *rgb = image->rgb + 3 * pixel;
    return vec3_of(rgb[0], rgb[1], rgb[2]) / 255;
}

int picture_bytes_apart(const Image *yours, const Image *right, size_t pixel)
{
    int most = 0;
    for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
        int apart = abs(yours->rgb[i] - right->rgb[i]);
        most = apart > most ? apart : most;
    }
    return most;
}

// The three squares of one pixel.
static void draw_pixel(Image *out, const Image *yours, const Image *right, int alike, Pixel pixel,
                       int side)
{
    static const Color dark = {0.12, 0.14, 0.17}, bright = {1, 0.82, 0.35};
    size_t i = image_index(right, pixel);
    bool differ = picture_bytes_apart(yours, right, i) > alike;
    const Color colors[PANELS] = {color_at(yours, i), color_at(right, i), differ ? bright : dark};
    for (int panel = 0; panel < PANELS; panel++)
        fill(out, GAP + panel * (right->size.width * side + GAP) + pixel.column * side,
             HEAD + GAP + pixel.row * side, side, side, colors[panel]);
}

bool picture_panels_write(const Image *yours, const Image *right, int alike, const char *path)
{
    static const Color paper = {1, 1, 1}, ink = {0.1, 0.11, 0.13};
    Resolution size = right->size;
    int longest = size.width > size.height ? size.width : size.height;
    // Narrow panels still leave room for their words.
    int side = longest > PANEL ? 1 : PANEL / longest;
    int room = LETTER * SCALE * (int)strlen("difference");
    while (size.width * side < room)
        side++;
    Image out;
    Message message;
    Resolution all = {GAP + PANELS * (size.width * side + GAP),
                      HEAD + 2 * GAP + size.height * side};
    if (!image_create(&out, all, &message))
        return false;
    fill(&out, 0, 0, all.width, all.height, paper);
    for (int panel = 0; panel < PANELS; panel++)
        for (int i = 0; words[panel][i] != '\0'; i++)
            write_letter(&out, GAP + panel * (size.width * side + GAP) + i * LETTER * SCALE, GAP,
                         words[panel][i], ink);
    for (int i = 0; i < size.width * size.height; i++)
        draw_pixel(&out, yours, right, alike, (Pixel){i % size.width, i / size.width}, side);
    bool written = image_write_png(&out, path, &message);
    image_free(&out);
    return written;
}
