// peers.c - the peers: Embree, and POV-Ray, which gets the scene in its own language and has its
// own clock. Its pictures are read back, so that they can be compared like all others.
#include "chapters/07-shading/export.h"
#include "tests/benches/measure.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_picture(const char *path, Image *image, Message *message)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (png_image_begin_read_from_file(&png, path) == 0)
        return message_set(message, "%.200s: %.100s", path, png.message);
    png.format = PNG_FORMAT_RGB;
    bool good = (int)png.width == image->size.width && (int)png.height == image->size.height &&
                png_image_finish_read(&png, NULL, image->rgb, 0, NULL) != 0;
    png_image_free(&png);
    return good || message_set(message, "%.200s: not the picture that was asked for", path);
}

// POV-Ray's clock counts thousandths of a second: this is the time of a picture that took none.
#define LEAST 1e-4

// The seconds in a line that begins so: the number in parentheses, or the first.
static void take_seconds(const char *text, const char *start, double *seconds)
{
    if (strncmp(text, start, strlen(start)) != 0)
        return;
    const char *number = strchr(text, '(');
    number = number != NULL ? number + 1 : text + strcspn(text, "0123456789");
    *seconds = fmax(atof(number), LEAST);
}

// Runs POV-Ray and takes from its output how long it built and cast. False if it fails or does not
// say.
static bool run(const char *command)
{
    char line[4096];
    FILE *pipe = popen(command, "r");
    while (pipe != NULL && fgets(line, sizeof line, pipe) != NULL) {
        // Progress is written over itself.
        const char *last = strrchr(line, '\r');
        const char *text = last != NULL ? last + 1 : line;
        text += strspn(text, " ");
        take_seconds(text, "Bounding Time:", &measured.build);
        take_seconds(text, "Trace Time:", &measured.cast);
    }
    return pipe != NULL && pclose(pipe) == 0 && measured.cast > 0;
}

// Scenes are written once, not for every round.
static bool is_new(char *last, size_t size, const Work *work)
{
    char key[4300];
    snprintf(key, sizeof key, "%s %d %d", measured.scene_path, work->image->size.width,
             work->image->size.height);
    if (strcmp(last, key) == 0)
        return false;
    snprintf(last, size, "%s", key);
    return true;
}

// Its picture is read into the image.
static bool povray(const Work *work, Export what, char *last, size_t size, Image *image,
                   Message *message)
{
    char path[500], picture[500], command[2000];
    snprintf(path, sizeof path, "%.400s/peer%s.pov", measured.folder, what.flat ? "" : "-shaded");
    snprintf(picture, sizeof picture, "%.400s/povray.png", measured.folder);
    what.format = EXPORT_POV;
    what.scene = work->scene;
    what.camera = work->camera;
    what.name = (Text){"peer"};
    if (is_new(last, size, work) && !export_scene(&what, path, message))
        return false;
    snprintf(command, sizeof command, "povray '+I%s' '+O%s' +W%d +H%d +WT%d -A -D 2>&1", path,
             picture, what.size.width, what.size.height, work->threads);
    if (!run(command))
        return message_set(message, "povray fails, or does not say how long it took");
    return read_picture(picture, image, message);
}

static bool cast_povray(const Work *work, Message *message)
{
    static char last[4300];
    Export what = {.size = work->image->size, .depth = 1, .flat = true};
    return povray(work, what, last, sizeof last, work->image, message);
}

// Of more than one sample a pixel it draws a larger picture, and each pixel is the mean of some of
// that. Its clock does not count the mean.
static bool light_povray(const Work *work, Style style, Message *message)
{
    static char last[4300];
    Image *image = work->image, large;
    int n = style.samples;
    Export what = {.size = {n * image->size.width, n * image->size.height}, .depth = style.depth};
    if (!image_create(&large, what.size, message))
        return false;
    bool done = povray(work, what, last, sizeof last, &large, message);
    for (int row = 0; done && row < image->size.height; row++)
        for (int column = 0; column < image->size.width; column++)
            for (int k = 0; k < 3; k++) {
                int sum = n * n / 2;
                for (int i = 0; i < n * n; i++)
                    sum += image_bytes(&large, (Pixel){column * n + i % n, row * n + i / n})[k];
                image_bytes(image, (Pixel){column, row})[k] = (uint8_t)(sum / (n * n));
            }
    image_free(&large);
    return done;
}

// ---- the peers -------------------------------------------------------------------------------

const Engine peers[] = {
    {"embree-8", "Embree's sphere points, 8 rays at a time", cast_embree_8, NULL},
    {"embree-16", "Embree's sphere points, 16 rays at a time", cast_embree_16, NULL},
    {"embree-user", "Embree's hierarchy, 16 rays a call, a test of our own", cast_embree_user,
     light_embree},
    {"povray", "POV-Ray", cast_povray, light_povray},
    {0},
};

bool peer_is_here(const Engine *peer, Message *message)
{
    bool is_here = strcmp(peer->name, "povray") == 0
                       ? system("command -v povray >/dev/null 2>&1") == 0
                       : peer->cast != NULL;
    return is_here ||
           message_set(message, "%s is not installed, so it is not measured: make setup FOR=bench",
                       peer->name);
}
