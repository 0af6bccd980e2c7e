// task_state.c - how far an optional task is: its picture beside the committed one.
//
//   task_state check NAME FOLDER EXPECTED.png
//       compares FOLDER/NAME.png, and writes FOLDER/NAME.state; FOLDER/NAME.words is what the
//       task's program printed
//   task_state show NAME FOLDER
//       prints that; exit status 1 if the picture is not right
//   task_state list FOLDER SOURCE.c...
//       prints one line about each task, and its state
//
// The first line of a state is the state in short. A picture is right if at most one pixel in 200
// differs by more than 4 of 255: other ways to compute the same round differently.
#include "common/image.h"
#include "tests/judge/picture_panels.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ALIKE = 4, ONE_IN = 200, LINE = 600 };
static const char right[] = "right";

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

// Writes the state; the details, if any, are further lines. Returns the exit status.
static int set_state(const char *name, const char *folder, const char *state, const char *details)
{
    Path path;
    snprintf(path, sizeof path, "%s/%s.state", folder, name);
    FILE *file = fopen(path, "w");
    bool written = file != NULL && fprintf(file, "%s\n%s", state, details) > 0;
    if (file != NULL && fclose(file) != 0)
        written = false;
    if (!written)
        fprintf(stderr, "%s: cannot be written\n", path);
    return written ? 0 : 2;
}

// The first line of a file, without its end; empty if there is none.
static void first_line(const char *path, char line[LINE])
{
    FILE *file = fopen(path, "r");
    if (file == NULL || fgets(line, LINE, file) == NULL)
        line[0] = '\0';
    if (file != NULL)
        fclose(file);
    line[strcspn(line, "\n")] = '\0';
}

// The functions that are missing, or else what the program printed.
static int no_picture(const char *name, const char *folder)
{
    static const char missing[] = "not answered yet: ";
    Path path;
    char line[LINE], state[LINE] = "";
    snprintf(path, sizeof path, "%s/%s.words", folder, name);
    FILE *file = fopen(path, "r");
    while (file != NULL && fgets(line, LINE, file) != NULL) {
        const char *at = strstr(line, missing);
        line[strcspn(line, "\n")] = '\0';
        if (at == NULL)
            continue;
        size_t used = strlen(state);
        snprintf(state + used, sizeof state - used, "%s%s", used > 0 ? ", " : "needs ",
                 at + strlen(missing));
    }
    if (file != NULL)
        fclose(file);
    if (state[0] == '\0') {
        first_line(path, line);
        snprintf(state, sizeof state, "no picture%s%.300s", line[0] != '\0' ? ": " : "", line);
    }
    char details[LINE];
    snprintf(details, sizeof details,
             "  the task: exercises/optional/%s.c\n  hints: exercises/optional/README.md\n", name);
    return set_state(name, folder, state, details);
}

static int compare(const char *name, const char *folder, const Image *yours, const Image *expected)
{
    char state[LINE], details[2 * sizeof(Path)];
    Path panels;
    Resolution a = yours->size, b = expected->size;
    if (a.width != b.width || a.height != b.height) {
        snprintf(state, sizeof state, "the picture has %d x %d pixels, expected %d x %d", a.width,
                 a.height, b.width, b.height);
        return set_state(name, folder, state, "");
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
        snprintf(details, sizeof details, "  your picture: %s/%s.png\n", folder, name);
        return set_state(name, folder, right, details);
    }
    snprintf(state, sizeof state,
             "%zu of %zu pixels differ, by up to %d of 255; the first is column %zu, row %zu",
             different, pixels, most, first % (size_t)a.width, first / (size_t)a.width);
    snprintf(panels, sizeof panels, "%.4000s/%.60s-panels.png", folder, name);
    if (!picture_panels_write(yours, expected, ALIKE, panels))
        return set_state(name, folder, state, "");
    snprintf(details, sizeof details,
             "  yours, expected, difference: %s\n  hints: exercises/optional/README.md\n", panels);
    return set_state(name, folder, state, details);
}

static int check(const char *name, const char *folder, const char *expected_path)
{
    Path path;
    Image yours, expected;
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    if (!read_png(path, &yours))
        return no_picture(name, folder);
    if (!read_png(expected_path, &expected)) {
        fprintf(stderr, "%s: cannot be read\n", expected_path);
        image_free(&yours);
        return 2;
    }
    int status = compare(name, folder, &yours, &expected);
    image_free(&yours);
    image_free(&expected);
    return status;
}

static int show(const char *name, const char *folder)
{
    Path path;
    char line[LINE];
    snprintf(path, sizeof path, "%s/%s.state", folder, name);
    first_line(path, line);
    bool is_right = strcmp(line, right) == 0;
    FILE *file = fopen(path, "r");
    printf("%s: ", name);
    for (int c; file != NULL && (c = getc(file)) != EOF;)
        putchar(c);
    if (file != NULL)
        fclose(file);
    return is_right ? 0 : 1;
}

// The first line of a task's source is '// NAME.c - what it is.'
static int list(const char *folder, char **sources)
{
    for (; *sources != NULL; sources++) {
        Path path;
        char line[LINE], state[LINE];
        const char *slash = strrchr(*sources, '/'), *name = slash != NULL ? slash + 1 : *sources;
        int length = (int)strcspn(name, ".");
        first_line(*sources, line);
        const char *what = strstr(line, " - ");
        snprintf(path, sizeof path, "%s/%.*s.state", folder, length, name);
        first_line(path, state);
        state[strcspn(state, ";")] = '\0'; // a line has at most 80 columns
        printf("  %-18.*s %s\n", length, name, state[0] != '\0' ? state : "not begun");
        printf("    %s\n", what != NULL ? what + 3 : "");
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 5 && strcmp(argv[1], "check") == 0)
        return check(argv[2], argv[3], argv[4]);
    if (argc == 4 && strcmp(argv[1], "show") == 0)
        return show(argv[2], argv[3]);
    if (argc > 2 && strcmp(argv[1], "list") == 0)
        return list(argv[2], argv + 3);
    fprintf(
        stderr,
        "Usage: %s check NAME FOLDER EXPECTED.png | show NAME FOLDER | list FOLDER SOURCE.c...\n",
        argv[0]);
    return 2;
}
