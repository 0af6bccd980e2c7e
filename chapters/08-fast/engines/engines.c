// engines.c - the engines, in the order of the lesson.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/questions.h"

#include <string.h>

Questions questions;

const Engine engines[] = {
    {"plain", "every pixel asks every sphere", cast_plain, light_plain},
    {"object", "every sphere asks the pixels of its rectangle", cast_object, NULL},
    {"bvh", "every ray asks the spheres on its way", cast_bvh, light_bvh},
    {"packet", "16 rays at a time ask the spheres on their way", cast_packet, NULL},
    {"tiles", "a tile of pixels asks the spheres in its frustum", cast_tiles, NULL},
    {"bins", "every tile asks the spheres in it, near ones first", cast_bins, NULL},
    {0},
};

const Engine *engine_named(const char *name)
{
    for (const Engine *engine = engines; engine->name != NULL; engine++)
        if (strcmp(engine->name, name) == 0)
            return engine;
    return NULL;
}
