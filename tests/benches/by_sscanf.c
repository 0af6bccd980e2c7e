// by_sscanf.c - NFF read as one would read it: a line at a time, by sscanf.
#include "tests/benches/by_sscanf.h"

#include <stdio.h>
#include <stdlib.h>

static void *grown(void *items, int count, size_t size)
{
    return count == 0 || (count >= 64 && (count & (count - 1)) == 0)
               ? realloc(items, size * (count == 0 ? 64 : 2 * (size_t)count))
               : items;
}

bool scene_by_sscanf(const char *path, Scene *scene)
{
    *scene = (Scene){0};
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return false;
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
    return fclose(file) == 0;
}
