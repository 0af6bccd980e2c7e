// embree_wait.c - an Embree program as one would write it: NFF by sscanf, a picture by libpng's
// defaults. Between them the faster of the two ways that are measured (embree.c).
//
// Usage: embree_wait SCENE.nff FILE.png WIDTH HEIGHT THREADS
#include "chapters/06-ray-casting/scene_camera.h"
#include "tests/benches/measure.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Measured measured;

static void *grown(void *items, int count, size_t size)
{
    return count == 0 || (count >= 64 && (count & (count - 1)) == 0)
               ? realloc(items, size * (count == 0 ? 64 : 2 * (size_t)count))
               : items;
}

static void read_scene(FILE *file, Scene *scene)
{
    char line[1024];
    double n[4];
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "s %lf %lf %lf %lf", &n[0], &n[1], &n[2], &n[3]) == 4) {
            scene->spheres = grown(scene->spheres, scene->sphere_count, sizeof *scene->spheres);
            scene->spheres[scene->sphere_count++] =
                (Sphere){vec3_of(n[0], n[1], n[2]), n[3], scene->surface_count - 1};
        } else if (sscanf(line, "f %lf %lf %lf", &n[0], &n[1], &n[2]) == 3) {
            scene->surfaces = grown(scene->surfaces, scene->surface_count, sizeof *scene->surfaces);
            scene->surfaces[scene->surface_count++] = (Surface){.color = vec3_of(n[0], n[1], n[2])};
        } else if (sscanf(line, "b %lf %lf %lf", &n[0], &n[1], &n[2]) == 3) {
            scene->background = vec3_of(n[0], n[1], n[2]);
        } else if (sscanf(line, "from %lf %lf %lf", &n[0], &n[1], &n[2]) == 3) {
            scene->view.from = vec3_of(n[0], n[1], n[2]);
        } else if (sscanf(line, "at %lf %lf %lf", &n[0], &n[1], &n[2]) == 3) {
            scene->view.at = vec3_of(n[0], n[1], n[2]);
        } else if (sscanf(line, "up %lf %lf %lf", &n[0], &n[1], &n[2]) == 3) {
            scene->view.up = vec3_of(n[0], n[1], n[2]);
        } else if (sscanf(line, "angle %lf", &n[0]) == 1) {
            scene->view.angle = n[0];
        }
    }
}

static int write_png(const Image *image, const char *path)
{
    FILE *file = fopen(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (file == NULL || setjmp(png_jmpbuf(png)) != 0)
        return 1;
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)image->size.width, (png_uint_32)image->size.height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int row = 0; row < image->size.height; row++)
        png_write_row(png, image_bytes(image, (Pixel){0, row}));
    png_write_end(png, info);
    return fclose(file);
}

int main(int argc, char **argv)
{
    Scene scene = {0};
    Image image;
    Message message;
    FILE *file = argc == 6 ? fopen(argv[1], "r") : NULL;
    if (file == NULL)
        return 2;
    read_scene(file, &scene);
    Resolution size = {atoi(argv[3]), atoi(argv[4])};
    Work work = {.scene = &scene, .image = &image, .threads = atoi(argv[5])};
    return scene_camera(&scene.view, size, &work.camera) != CAMERA_OK ||
           !image_create(&image, size, &message) || !cast_embree_user(&work, &message) ||
           write_png(&image, argv[2]) != 0;
}
