// sphere_colors.c - the colours of a scene's spheres as bytes.
#include "chapters/08-fast/engines/sphere_colors.h"

#include <stdlib.h>

static Paint paint_of(Color color)
{
    return (Paint){
        {byte_from_color(color[0]), byte_from_color(color[1]), byte_from_color(color[2])}};
}

Paint *paints_of(const Scene *scene)
{
    Paint *paints = malloc(((size_t)scene->surface_count + 1) * sizeof *paints);
    for (int i = 0; paints != NULL && i < scene->surface_count; i++)
        paints[i] = paint_of(scene->surfaces[i].color);
    if (paints != NULL)
        paints[scene->surface_count] = paint_of(scene->background);
    return paints;
}
