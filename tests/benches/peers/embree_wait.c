// embree_wait.c - an Embree program as one would write it: NFF by sscanf, a picture by libpng's
// defaults. Between them the faster of the two ways that are measured (embree.c).
//
// Usage: embree_wait SCENE.nff FILE.png WIDTH HEIGHT THREADS
#include "chapters/shared/scene_camera.h"
#include "tests/benches/by_sscanf.h"
#include "tests/benches/measure.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>

Measured measured;

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
    Scene scene;
    Image image;
    Message message;
    if (argc != 6 || !scene_by_sscanf(argv[1], &scene))
        return 2;
    Resolution size = {atoi(argv[3]), atoi(argv[4])};
    Work work = {.scene = &scene, .image = &image, .threads = atoi(argv[5])};
    return scene_camera(&scene.view, size, &work.camera) != CAMERA_OK ||
           !image_create(&image, size, &message) || !cast_embree_user(&work, &message) ||
           write_png(&image, argv[2]) != 0;
}
