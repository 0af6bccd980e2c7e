// sphere_colors.h - the colours of a scene's spheres as bytes, computed once.
#ifndef CHAPTERS_08_FAST_ENGINES_SPHERE_COLORS_H
#define CHAPTERS_08_FAST_ENGINES_SPHERE_COLORS_H

#include "common/image.h"
#include "common/scene.h"

#include <stdbool.h>

typedef struct {
    uint8_t rgb[3];
} Paint;

// One for each surface, and after the last one the background. Free it with free; NULL if there is
// not enough memory.
Paint *paints_of(const Scene *scene);

// Colours a pixel by the sphere that it sees, -1 for none. Unlike image_set this may be called by
// several threads, for different pixels.
static inline void paint_pixel(Image *image, size_t pixel, const Scene *scene, const Paint *paints,
                               int sphere)
{
    const Paint *paint =
        &paints[sphere < 0 ? scene->surface_count : scene->spheres[sphere].surface];
    for (int i = 0; i < 3; i++)
        image->rgb[3 * pixel + (size_t)i] = paint->rgb[i];
}

#endif
