// by_sscanf.h - how scenes are read by a program that does not care how long it takes.
#ifndef TESTS_BENCHES_BY_SSCANF_H
#define TESTS_BENCHES_BY_SSCANF_H

#include "common/scene.h"

#include <stdbool.h>

// Spheres, colours, background and view. False if the file cannot be read, without
// a reason. Free it with scene_free.
bool scene_by_sscanf(const char *path, Scene *scene);

#endif
