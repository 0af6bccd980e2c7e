// scene.c - scenes: read whole or not at all, and freed.
#include "common/scene.h"

#include "common/nff.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void warn_of_left_out(const NffReader *reader, Message *warning)
{
    if (reader->cones > 0 || reader->polygons > 0)
        message_set(warning,
                    "%.200s: warning: left out: %d cones (c), %d polygons (p, pp); only "
                    "spheres are cast",
                    reader->line.file_name, reader->cones, reader->polygons);
}

bool scene_read(FILE *file, const char *name, Scene *scene, Message *message, Message *warning)
{
    *scene = (Scene){0};
    warning->text[0] = '\0';
    NffReader *reader = calloc(1, sizeof *reader);
    if (reader == NULL)
        return message_set(message, "%.200s: no memory to read it", name);
    reader->scene = scene;
    bool good = nff_begin(&reader->line, file, name, message) && nff_entities(reader) &&
                nff_view_is_complete(reader);
    scene->ambient = vec3_of(SCENE_AMBIENT, SCENE_AMBIENT, SCENE_AMBIENT);
    warn_of_left_out(reader, warning);
    if (!good)
        scene_free(scene);
    nff_end(&reader->line);
    free(reader);
    return good;
}

bool scene_load(const char *path, Scene *scene, Message *message)
{
    *scene = (Scene){0};
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return message_set(message, "%.200s: cannot be read: %s", path, strerror(errno));
    Message warning;
    bool good = scene_read(file, path, scene, message, &warning);
    fclose(file);
    if (good && warning.text[0] != '\0')
        fprintf(stderr, "%s\n", warning.text);
    return good;
}

const Surface *scene_surface(const Scene *scene, int i)
{
    if (i < 0 || i >= scene->sphere_count) {
        fprintf(stderr, "scene_surface: sphere %d does not exist in a scene of %d\n", i,
                scene->sphere_count);
        abort();
    }
    return &scene->surfaces[scene->spheres[i].surface];
}

void scene_free(Scene *scene)
{
    free(scene->spheres);
    free(scene->surfaces);
    free(scene->lights);
    *scene = (Scene){0};
}
