// task.c - the command line and the picture of an optional task.
#include "chapters/shared/task.h"

#include "chapters/shared/room.h"
#include "common/picture.h"
#include "common/whole_file.h"

#include <stdio.h>
#include <string.h>

enum { MOST_OPTIONS = 16 };

// A scene needs a camera by the answers of chapter 02; the room has a camera of its own.
static bool begin(Drawing *drawing, const char *program, Command command, const char *scene)
{
    Message message;
    if (scene != NULL)
        return drawing_begin(drawing, program, &command, scene);
    *drawing = (Drawing){.program = program, .size = command.size};
    drawing->camera = room_camera(command.size);
    if (command.output != NULL)
        snprintf(drawing->output, sizeof drawing->output, "%s", command.output);
    else
        snprintf(drawing->output, sizeof drawing->output, "%s.png", program);
    if (file_path_is_writable(drawing->output, &message) &&
        image_create(&drawing->image, command.size, &message))
        return true;
    fprintf(stderr, "%s\n", message.text);
    return false;
}

int task_run(int argc, char **argv, Task task)
{
    static Drawing drawing;
    Command command = {.size = task.size};
    const Option shared[] = {COMMAND_OPTIONS(command), {0}};
    Option options[MOST_OPTIONS + 1] = {{0}};
    int count = 0;
    for (const Option *o = task.options; o != NULL && o->name != NULL && count < 12; o++)
        options[count++] = *o;
    for (const Option *o = shared; o->name != NULL; o++)
        options[count++] = *o;
    const char *operands = task.scene != NULL ? "[OPTION]... [SCENE.nff]" : "[OPTION]...";
    int first = options_read(argc, argv, options, (Usage){operands, task.purpose});
    if (argc - first > (task.scene != NULL))
        options_wrong(argv[0], "%s: one operand too many", word_text(argv[argc - 1]).s);
    command.scene_path = argv[first];
    if (!begin(&drawing, argv[0], command, task.scene))
        return EXIT_COULD_NOT;
    Resolution size = drawing.image.size;
    if (task.color == NULL)
        task.draw(&drawing);
    for (int row = 0; task.color != NULL && row < size.height; row++)
        for (int column = 0; column < size.width; column++) {
            Pixel pixel = {column, row};
            image_set(&drawing.image, pixel, task.color(&drawing, pixel));
        }
    int status = drawing_end(&drawing);
    if (status == EXIT_DONE && command.output == NULL)
        printf("%s\n", drawing.output);
    return status;
}
