// programs.c - POV-Ray and Tachyon as peers: the scene in their own language, their own clocks.
//
// Their pictures are read back, so that they can be compared like all others.
#include "chapters/07-shading/export.h"
#include "tests/benches/measure.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A folder of the bench's own, which its caller removes: BENCH_SCRATCH.
static const char *scratch(void)
{
    const char *folder = getenv("BENCH_SCRATCH");
    return folder != NULL ? folder : "/tmp";
}

// The columns and rows of a PNG after the first more_columns and more_rows, into the image.
static bool read_picture(const char *path, Image *image, int more_rows, int more_columns,
                         Message *message)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (png_image_begin_read_from_file(&png, path) == 0)
        return message_set(message, "%.200s: %.100s", path, png.message);
    png.format = PNG_FORMAT_RGB;
    int width = image->size.width + more_columns, height = image->size.height + more_rows;
    uint8_t *rgb = malloc(PNG_IMAGE_SIZE(png));
    bool good = rgb != NULL && (int)png.width == width && (int)png.height == height &&
                png_image_finish_read(&png, NULL, rgb, 0, NULL) != 0;
    for (int row = 0; good && row < image->size.height; row++)
        memcpy(image_bytes(image, (Pixel){0, row}),
               rgb + 3 * (size_t)(row + more_rows) * (size_t)width, 3 * (size_t)image->size.width);
    free(rgb);
    png_image_free(&png);
    return good || message_set(message, "%.200s: not the picture that was asked for", path);
}

// Their clocks tick in thousandths, or tenths of them: of a picture of no time, so much.
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

// Runs a command and takes from what it prints how long it built and cast. False where it fails or
// does not say.
static bool run(const char *command, const char *build, const char *cast)
{
    char line[4096];
    FILE *pipe = popen(command, "r");
    while (pipe != NULL && fgets(line, sizeof line, pipe) != NULL) {
        // Progress is written over itself.
        const char *last = strrchr(line, '\r');
        const char *text = last != NULL ? last + 1 : line;
        text += strspn(text, " ");
        take_seconds(text, build, &measured.build);
        take_seconds(text, cast, &measured.cast);
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

static bool povray(const Work *work, Export what, char *last, size_t size, Message *message)
{
    char path[500], picture[500], command[2000];
    snprintf(path, sizeof path, "%.400s/peer%s.pov", scratch(), what.flat ? "" : "-shaded");
    snprintf(picture, sizeof picture, "%.400s/povray.png", scratch());
    what.format = EXPORT_POV;
    what.scene = work->scene;
    what.camera = work->camera;
    what.name = (Text){"peer"};
    if (is_new(last, size, work) && !export_scene(&what, path, message))
        return false;
    snprintf(command, sizeof command, "povray '+I%s' '+O%s' +W%d +H%d +WT%d -A -D 2>&1", path,
             picture, what.size.width, what.size.height, work->threads);
    if (!run(command, "Bounding Time:", "Trace Time:"))
        return message_set(message, "povray fails, or does not say how long it took");
    return true;
}

bool cast_povray(const Work *work, Message *message)
{
    static char last[4300];
    char picture[500];
    snprintf(picture, sizeof picture, "%.400s/povray.png", scratch());
    Export what = {.size = work->image->size, .depth = 1, .flat = true};
    return povray(work, what, last, sizeof last, message) &&
           read_picture(picture, work->image, 0, 0, message);
}

// Of more than one sample a pixel it draws a larger picture, and each pixel is the mean of some of
// that. Its clock does not count the mean.
bool light_povray(const Work *work, Style style, Message *message)
{
    static char last[4300];
    char picture[500];
    Image *image = work->image, large;
    int n = style.samples;
    snprintf(picture, sizeof picture, "%.400s/povray.png", scratch());
    Export what = {.size = {n * image->size.width, n * image->size.height}, .depth = style.depth};
    if (!image_create(&large, what.size, message))
        return false;
    bool done = povray(work, what, last, sizeof last, message);
    done = done && read_picture(picture, &large, 0, 0, message);
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

// Tachyon's rays go through the corners of pixels, not their centres: a picture that is a row and a
// column larger, of the same pixels, has ours in it. Its axes are left-handed; in the camera's own
// that is right, up, forward.
static bool write_tachyon(const Work *work, const char *path)
{
    FILE *file = fopen(path, "w");
    if (file == NULL)
        return false;
    const Scene *scene = work->scene;
    Camera c = work->camera;
    Resolution size = work->image->size;
    vec3 back = scene->background;
    fprintf(file,
            "BEGIN_SCENE\nRESOLUTION %d %d\nCAMERA\nZOOM %.12g\nASPECTRATIO 1\nANTIALIASING 0\n"
            "RAYDEPTH 1\nCENTER 0 0 0\nVIEWDIR 0 0 1\nUPDIR 0 1 0\nEND_CAMERA\n"
            "BACKGROUND %g %g %g\n",
            size.width + 1, size.height + 1,
            c.distance / (c.height / size.height * (size.height + 1)), back[0], back[1], back[2]);
    for (int i = 0; i < scene->surface_count; i++) {
        vec3 color = scene->surfaces[i].color;
        fprintf(file,
                "TEXDEF s%d AMBIENT 1 DIFFUSE 0 SPECULAR 0 OPACITY 1 COLOR %g %g %g TEXFUNC 0\n", i,
                color[0], color[1], color[2]);
    }
    for (int i = 0; i < scene->sphere_count; i++) {
        Sphere sphere = scene->spheres[i];
        vec3 to = sphere.center - c.origin;
        fprintf(file, "SPHERE CENTER %.12g %.12g %.12g RAD %.12g s%d\n", vec3_dot(to, c.right),
                vec3_dot(to, c.up), vec3_dot(to, c.forward), sphere.radius, sphere.surface);
    }
    fprintf(file, "END_SCENE\n");
    return fclose(file) == 0;
}

bool cast_tachyon(const Work *work, Message *message)
{
    static char last[4300];
    char path[500], picture[500], command[2000];
    snprintf(path, sizeof path, "%.400s/peer.dat", scratch());
    snprintf(picture, sizeof picture, "%.400s/tachyon.png", scratch());
    if (is_new(last, sizeof last, work) && !write_tachyon(work, path))
        return message_set(message, "%s: %s", path, strerror(errno));
    snprintf(command, sizeof command,
             "tachyon '%s' -lowestshade -numthreads %d -format PNG -o '%s' 2>&1", path,
             work->threads, picture);
    if (!run(command, "Preprocessing Time:", "Ray Tracing Time:"))
        return message_set(message, "tachyon fails, or does not say how long it took");
    return read_picture(picture, work->image, 1, 1, message);
}
