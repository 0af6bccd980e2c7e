// export.h - the scene for the renderers that the deck lists as reading: POV-Ray and pbrt-v4.
#ifndef CHAPTERS_07_SHADING_EXPORT_H
#define CHAPTERS_07_SHADING_EXPORT_H

#include "common/camera.h"
#include "common/scene.h"
#include "common/text.h"

#include <stdbool.h>

typedef enum { EXPORT_NONE, EXPORT_POV, EXPORT_PBRT } ExportFormat;

typedef struct {
    ExportFormat format;
    const Scene *scene;
    Camera camera;
    Resolution size;
    int depth; // number of mirrors that a ray follows
    bool flat; // surfaces shine by themselves, in their color
    Text name; // of the scene, for a comment
} Export;

// Writes the scene to a file, completely or not at all. If it fails: false, and a message.
bool export_scene(const Export *what, const char *path, Message *message);

#endif
