// scene_command.h - the command line that the programs which draw scenes share.
//
// PROGRAM [-o FILE.png] [-s WIDTHxHEIGHT] [SCENE.nff], and the options that a chapter adds.
#ifndef CHAPTERS_SHARED_SCENE_COMMAND_H
#define CHAPTERS_SHARED_SCENE_COMMAND_H

#include "common/camera.h"
#include "common/image.h"
#include "common/options.h"
#include "common/scene.h"

typedef struct {
    const char *output;       // -o; NULL: the gallery
    Resolution size;          // -s; width 0: the scene's
    const char *scene_path;   // NULL: the chapter's own
    const char *picture_name; // without -o, in the gallery; NULL: the scene's
    double turn;              // degrees, by which the eye is moved around the scene
} Command;

#define COMMAND_OPTIONS(command)                                                                   \
    {"output",          'o',                                                                       \
     "FILE.png",        option_string,                                                             \
     &(command).output, "the picture (gallery/SCENE.png)"},                                        \
    {                                                                                              \
        "size", 's', "WIDTHxHEIGHT", option_size, &(command).size,                                 \
            "size of the picture (the scene's)"                                                    \
    }

// Everything that a picture needs.
typedef struct {
    const char *program;
    Scene scene;
    Resolution size;
    Camera camera;
    Image image;
    char scene_path[4096];
    char output[4096];
} Drawing;

// Reads the scene, finds its camera, makes room for the image. own_scene is the chapter's, by its
// path from the top of the project. If something is missing: false, and the reason on stderr.
bool drawing_begin(Drawing *drawing, const char *program, const Command *command,
                   const char *own_scene);

// The same without an image, and without a file for it: scene, size and camera.
bool drawing_prepare(Drawing *drawing, const char *program, const Command *command,
                     const char *own_scene);

// Every pixel is set: no progress is shown any more.
void drawing_is_done(void);

// Writes the picture; returns the result of main.
int drawing_end(Drawing *drawing);

#endif
