// scene_command.c - reads a scene, its camera and an empty image from the command line; writes the
// file.
#include "chapters/shared/scene_command.h"

#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "common/options.h"
#include "common/picture.h"
#include "common/text.h"
#include "common/toolkit_file.h"
#include "common/whole_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- long work says on a terminal how far it is, and how long it will still take ----------------

typedef struct {
    const char *what; // "pixels"
    long all;         // how many there are
    double began, last;
} Progress;

// Begins now. One line is shown after the first second, and changes twice a second.
static Progress progress_begin(const char *what, long all)
{
    return (Progress){.what = what, .all = all, .began = clock_seconds()};
}

// 19 % (320 of 1624), about 3 min 20 s left
static Text progress_text(long done, long all, double seconds)
{
    Text text;
    if (done <= 0 || done > all) // a student's loop may do more than there is to do
        snprintf(text.s, sizeof text.s, "%ld so far, after %.60s", done, duration_text(seconds).s);
    else
        snprintf(text.s, sizeof text.s, "%ld %% (%ld of %ld), about %.60s left", 100 * done / all,
                 done, all, duration_text(seconds * (double)(all - done) / (double)done).s);
    return text;
}

// So many are done. May be called as often as there is something to say.
static void progress_show(Progress *progress, long done)
{
    static const double first = 1, then = 0.5; // seconds
    double seconds = clock_seconds() - progress->began;
    if (!isatty(STDERR_FILENO) ||
        (progress->last == 0 ? seconds < first : seconds - progress->last < then))
        return;
    progress->last = seconds;
    fprintf(stderr, "\r  %-9s %s\033[K", progress->what,
            progress_text(done, progress->all, seconds).s);
}

// Removes the line.
static void progress_end(Progress *progress)
{
    if (progress->last != 0)
        fprintf(stderr, "\r\033[K");
    progress->last = 0;
}

// ---- the command --------------------------------------------------------------------------------

// gallery/SCENE.png beside the program. Makes the folder if it does not exist.
static bool gallery_path(char *path, size_t size, const char *program, const char *scene_path)
{
    const char *slash = strrchr(scene_path, '/');
    const char *name = slash != NULL ? slash + 1 : scene_path;
    const char *dot = strrchr(name, '.');
    int length = (int)(dot != NULL && dot != name ? (size_t)(dot - name) : strlen(name));
    int used = snprintf(path, size, "%s/gallery", picture_program_folder(program));
    if (used < (int)size && mkdir(path, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "%s: cannot be made: %s\n", path, strerror(errno));
        return false;
    }
    return snprintf(path, size, "%s/gallery/%.*s.png", picture_program_folder(program), length,
                    name) < (int)size;
}

static Progress progress;

// The loops are the student's own, so only the number of pixels that were set is known.
static void show_progress(const Image *image)
{
    static long last;
    // The first pixels of this picture: a program may draw several.
    if (last == 0 || image->set_count < last)
        progress = progress_begin("pixels", (long)image->size.width * image->size.height);
    last = image->set_count;
    progress_show(&progress, last);
}

static bool report(const char *text)
{
    fprintf(stderr, "%s\n", text);
    return false;
}

// Finds the scene's path; false if there is none.
static bool find_scene(Drawing *drawing, const Command *command, const char *own_scene)
{
    if (command->scene_path == NULL)
        return toolkit_file(drawing->scene_path, sizeof drawing->scene_path, drawing->program,
                            own_scene);
    if (strlen(command->scene_path) >= sizeof drawing->scene_path)
        return report("the path of the scene is too long");
    strcpy(drawing->scene_path, command->scene_path);
    return true;
}

static bool find_output(Drawing *drawing, const Command *command)
{
    Message message;
    if (command->output == NULL) {
        if (!gallery_path(drawing->output, sizeof drawing->output, drawing->program,
                          command->picture_name != NULL ? command->picture_name
                                                        : drawing->scene_path))
            return false;
    } else {
        if (strlen(command->output) >= sizeof drawing->output)
            return report("the path of the picture is too long");
        strcpy(drawing->output, command->output);
    }
    return file_path_is_writable(drawing->output, &message) || report(message.text);
}

// Reads the scene, and finds its camera.
static bool load(Drawing *drawing, const Command *command)
{
    Message message;
    if (!scene_load(drawing->scene_path, &drawing->scene, &message))
        return report(message.text);
    if (drawing->scene.sphere_count == 0)
        fprintf(stderr, "%s: warning: the scene has no spheres\n", drawing->scene_path);
    drawing->size = command->size.width > 0 ? command->size : drawing->scene.view.resolution;
    if (command->turn != 0)
        drawing->scene.view = view_turned(drawing->scene.view, command->turn);
    CameraFault fault = scene_camera(&drawing->scene.view, drawing->size, &drawing->camera);
    if (fault == CAMERA_OK)
        return true;
    message_set(&message, "%.300s: its viewpoint is not a camera: %s", drawing->scene_path,
                camera_fault_text(fault));
    scene_free(&drawing->scene);
    return report(message.text);
}

bool drawing_prepare(Drawing *drawing, const char *program, const Command *command,
                     const char *own_scene)
{
    *drawing = (Drawing){.program = program};
    return find_scene(drawing, command, own_scene) && load(drawing, command);
}

bool drawing_begin(Drawing *drawing, const char *program, const Command *command,
                   const char *own_scene)
{
    Message message;
    *drawing = (Drawing){.program = program};
    if (!find_scene(drawing, command, own_scene) || !find_output(drawing, command))
        return false;
    if (file_is_same(drawing->scene_path, drawing->output))
        options_wrong(program, "%s is the scene itself and would be lost, expected -o ANOTHER-FILE",
                      word_text(drawing->output).s);
    if (!load(drawing, command))
        return false;
    if (!image_create(&drawing->image, drawing->size, &message)) {
        scene_free(&drawing->scene);
        return report(message.text);
    }
    if (isatty(STDERR_FILENO))
        drawing->image.progress = show_progress;
    return true;
}

void drawing_is_done(void)
{
    progress_end(&progress);
}

int drawing_end(Drawing *drawing)
{
    drawing_is_done();
    int status = picture_save(&drawing->image, drawing->output);
    image_free(&drawing->image);
    scene_free(&drawing->scene);
    return status;
}
