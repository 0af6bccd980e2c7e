// task.h - what the optional tasks share: their command line, their camera, and their picture.
#ifndef CHAPTERS_SHARED_TASK_H
#define CHAPTERS_SHARED_TASK_H

#include "chapters/shared/scene_command.h"
#include "common/camera.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/screen.h"

// The color of one pixel. drawing holds the camera, the scene and the image with its size.
typedef Color TaskColor(const Drawing *drawing, Pixel pixel);

typedef struct {
    const char *purpose;   // one sentence for --help
    const char *scene;     // its path from the top of the project; NULL: the room, without a scene
    Resolution size;       // of the picture, unless -s gives another
    const Option *options; // the task's own; the last one has no name
    TaskColor *color;      // called for every pixel, or
    void (*draw)(Drawing *drawing); // called once, if color is NULL
} Task;

// Reads the options (the task's, -o and -s), draws the picture and writes it. Returns the result of
// main. Without -o the picture is in the folder gallery/ beside the program.
int task_run(int argc, char **argv, Task task);

// ---- a room with tiled walls and spheres, which tasks look into ---------------------------------

// A camera near one end of the room that looks along z, to the other end. Its image plane has the
// shape of the screen.
Camera room_camera(Resolution screen);

// The color that a ray sees if it starts inside the room.
Color room_color(Ray ray);

#endif
