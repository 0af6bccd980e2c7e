// compare_task.c - how far an optional task is: its picture beside the committed one.
//
// Usage: compare_task NAME FOLDER EXPECTED.png
//
// FOLDER/NAME.png is the task's picture, FOLDER/NAME.words what its program printed. The first line
// of the output is the state in short. A picture is right if at most one pixel in 200 differs by
// more than 4 of 255: other ways to compute the same round differently.
#include "common/image.h"
#include "tests/judge/figure.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALIKE = 4, ONE_IN = 200 };

typedef char Path[4096];

static bool read_png(const char *path, Image *image)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    *image = (Image){{0, 0}, NULL, NULL, 0};
    if (!png_image_begin_read_from_file(&png, path))
        return false;
    png.format = PNG_FORMAT_RGB;
    Message message;
    Resolution size = {(int)png.width, (int)png.height};
    if (image_create(image, size, &message) &&
        png_image_finish_read(&png, NULL, image->rgb, 0, NULL))
        return true;
    png_image_free(&png);
    return false;
}

// The functions that are missing, or else the first line that the program printed.
static void say_no_picture(const char *name, const char *words)
{
    static const char missing[] = "not answered yet: ";
    char line[300], first[300] = "";
    bool needs = false;
    FILE *file = fopen(words, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        const char *at = strstr(line, missing);
        line[strcspn(line, "\n")] = '\0';
        if (first[0] == '\0')
            strcpy(first, line);
        if (at != NULL)
            printf("%s%s", needs ? ", " : "needs ", at + strlen(missing));
        needs = needs || at != NULL;
    }
    if (file != NULL)
        fclose(file);
    if (!needs)
        printf("no picture%s%s", first[0] != '\0' ? ": " : "", first);
    printf("\n  the task: exercises/optional/%s.c\n  hints: exercises/optional/README.md\n", name);
}

static void say_difference(const Image *yours, const Image *expected, const char *picture,
                           const char *panels)
{
    Resolution a = yours->size, b = expected->size;
    if (a.width != b.width || a.height != b.height) {
        printf("the picture has %d x %d pixels, expected %d x %d\n", a.width, a.height, b.width,
               b.height);
        return;
    }
    size_t pixels = (size_t)a.width * (size_t)a.height, different = 0, first = 0;
    int most = 0;
    for (size_t i = 0; i < pixels; i++) {
        int apart = picture_bytes_apart(yours, expected, i);
        most = apart > most ? apart : most;
        if (apart > ALIKE && different++ == 0)
            first = i;
    }
    if (different * ONE_IN <= pixels) {
        printf("right\n  your picture: %s\n", picture);
        return;
    }
    printf("%zu of %zu pixels differ, by up to %d of 255; the first is column %zu, row %zu\n",
           different, pixels, most, first % (size_t)a.width, first / (size_t)a.width);
    if (picture_panels_write(yours, expected, ALIKE, panels))
        printf("  yours, expected, difference: %s\n  hints: exercises/optional/README.md\n",
               panels);
}

int main(int argc, char **argv)
{
    Path picture, words, panels;
    Image yours, expected;
    if (argc != 4) {
        fprintf(stderr, "Usage: %s NAME FOLDER EXPECTED.png\n", argv[0]);
        return 2;
    }
    snprintf(picture, sizeof picture, "%s/%s.png", argv[2], argv[1]);
    snprintf(words, sizeof words, "%s/%s.words", argv[2], argv[1]);
    snprintf(panels, sizeof panels, "%s/%s-panels.png", argv[2], argv[1]);
    if (!read_png(argv[3], &expected)) {
        fprintf(stderr, "%s: cannot be read\n", argv[3]);
        return 2;
    }
    if (!read_png(picture, &yours))
        say_no_picture(argv[1], words);
    else
        say_difference(&yours, &expected, picture, panels);
    image_free(&yours);
    image_free(&expected);
    return 0;
}
