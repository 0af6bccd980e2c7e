// cast_spheres.c - a picture whose colors are the numbers of spheres, also while it is cast.
#include "chapters/06-ray-casting/cast_spheres.h"

#include "exercises/06-ray-casting.h"

#include <stdlib.h>

// The bytes of a color are the digits of a number.
static Color color_of_number(int number)
{
    return vec3_of(number >> 16 & 255, number >> 8 & 255, number & 255) / 255;
}

static int number_of_color(const uint8_t *rgb)
{
    return rgb[0] << 16 | rgb[1] << 8 | rgb[2];
}

// The same spheres, each with a surface of its own.
static bool number_spheres(const Scene *scene, Scene *numbered)
{
    size_t count = (size_t)scene->sphere_count + 1; // so that no array is empty
    *numbered = *scene;
    numbered->background = color_of_number(0);
    numbered->spheres = malloc(count * sizeof *numbered->spheres);
    numbered->surfaces = calloc(count, sizeof *numbered->surfaces);
    numbered->surface_count = (int)count;
    if (numbered->spheres == NULL || numbered->surfaces == NULL)
        return false;
    for (int i = 0; i < scene->sphere_count; i++) {
        numbered->spheres[i] = scene->spheres[i];
        numbered->spheres[i].surface = i;
        numbered->surfaces[i] = (Surface){.color = color_of_number(i + 1)};
    }
    return true;
}

bool cast_spheres(const Scene *scene, Camera camera, Resolution size, int *spheres)
{
    Scene numbered;
    Image image = {0};
    Message message;
    bool cast = number_spheres(scene, &numbered) && image_create(&image, size, &message);
    if (cast) {
        cast_image_order(&numbered, camera, &image);
        for (int i = 0; i < size.width * size.height; i++)
            spheres[i] =
                number_of_color(image_bytes(&image, (Pixel){i % size.width, i / size.width})) - 1;
        image_free(&image);
    }
    free(numbered.spheres);
    free(numbered.surfaces);
    return cast;
}

typedef struct {
    PixelSet *sets;
    int room, count;
} Recorder;

static void record_set(const Image *image, Pixel pixel, void *watcher)
{
    Recorder *recorder = watcher;
    if (recorder->count < recorder->room)
        recorder->sets[recorder->count] =
            (PixelSet){pixel, number_of_color(image_bytes(image, pixel)) - 1};
    recorder->count++;
}

int cast_pixel_sets(const Scene *scene, Camera camera, Resolution size, Order order, PixelSet *sets,
                    int room)
{
    Scene numbered;
    Image image = {0};
    Message message;
    Recorder recorder = {sets, room, 0};
    double *depth = malloc(sizeof *depth * (size_t)size.width * (size_t)size.height);
    bool cast =
        number_spheres(scene, &numbered) && depth != NULL && image_create(&image, size, &message);
    if (cast) {
        image_watch(record_set, &recorder);
        if (order == IMAGE_ORDER)
            cast_image_order(&numbered, camera, &image);
        else
            cast_object_order(&numbered, camera, &image, depth);
        image_watch(NULL, NULL);
        image_free(&image);
    }
    free(depth);
    free(numbered.spheres);
    free(numbered.surfaces);
    return cast ? recorder.count : -1;
}
