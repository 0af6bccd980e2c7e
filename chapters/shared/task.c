// task.c - the command line and the picture of an optional task.
#include "chapters/shared/task.h"

#include "common/picture.h"
#include "common/whole_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

// ---- the room -----------------------------------------------------------------------------------

static const double least[3] = {-4, 0, -6}, most[3] = {4, 3.6, 6};

Camera room_camera(Resolution screen)
{
    return (Camera){.origin = vec3_of(0, 1.6, -4.5),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, 1),
                    .distance = 2,
                    .width = 3,
                    .height = 3.0 * screen.height / screen.width};
}

// From the middle of a period, in periods: 0 to 0.5.
static double off_middle(double x, double period)
{
    return fabs(x / period - floor(x / period) - 0.5);
}

static bool is_even(double x, double y)
{
    return fmod(floor(x) + floor(y), 2) == 0;
}

static Color sky(vec3 v)
{
    double up = v[1] / vec3_length(v);
    return up < 0 ? vec3_of(0.42, 0.55, 0.3)
                  : (1 - up) * vec3_of(0.85, 0.92, 1) + up * vec3_of(0.25, 0.5, 0.9);
}

static Color floor_color(double x, double z)
{
    return is_even(x, z) ? vec3_of(0.86, 0.8, 0.68) : vec3_of(0.45, 0.27, 0.17);
}

static Color ceiling_color(double x, double z)
{
    if (hypot(x, z) < 0.9)
        return vec3_of(1, 0.97, 0.85);
    return off_middle(z, 1.5) < 0.1 ? vec3_of(0.5, 0.36, 0.24) : vec3_of(0.9, 0.88, 0.84);
}

// Windows at the right, and what is outside.
static Color window_wall(double y, double z, vec3 v)
{
    double across = off_middle(z, 3);
    bool opening = across < 0.3 && y > 0.9 && y < 2.9;
    if (opening && across > 0.015 && fabs(y - 1.9) > 0.04)
        return sky(v);
    return opening || (across < 0.34 && y > 0.8 && y < 3) ? vec3_of(0.97, 0.97, 0.95)
                                                          : vec3_of(0.45, 0.62, 0.6);
}

static Color brick_wall(double y, double z)
{
    double row = floor(y / 0.3), along = z / 0.75 + 0.5 * fmod(row, 2);
    bool mortar = off_middle(y, 0.3) > 0.44 || off_middle(along, 1) > 0.475;
    double shade = 0.9 + 0.1 * sin(12.9 * floor(along) + 78.2 * row);
    return mortar ? vec3_of(0.8, 0.75, 0.68) : shade * vec3_of(0.72, 0.36, 0.27);
}

// A painting of a sun over water ahead; a door behind.
static Color end_wall(double x, double y, bool ahead)
{
    if (!ahead)
        return fabs(x) < 0.6 && y < 2.2 ? vec3_of(0.35, 0.22, 0.14) : vec3_of(0.8, 0.72, 0.55);
    double up = y - 1.9;
    if (fabs(x) > 1.9 || fabs(up) > 1.1)
        return vec3_of(0.8, 0.72, 0.55);
    if (fabs(x) > 1.75 || fabs(up) > 0.95)
        return vec3_of(0.3, 0.2, 0.12);
    if (up < -0.25)
        return off_middle(y, 0.16) < 0.5 - 0.4 * fabs(x) / (0.4 - up) ? vec3_of(1, 0.7, 0.3)
                                                                      : vec3_of(0.12, 0.22, 0.42);
    return hypot(x, up - 0.1) < 0.45 ? vec3_of(1, 0.9, 0.5)
                                     : vec3_of(0.95 - 0.3 * up, 0.5 - 0.2 * up, 0.3 + 0.2 * up);
}

// Darker towards each edge of the room.
static double light_at(vec3 place, int wall)
{
    double light = 1;
    for (int i = 0; i < 3; i++) {
        double edge = fmin(place[i] - least[i], most[i] - place[i]);
        if (i != wall)
            light *= 1 - 0.45 * exp(-2 * edge);
    }
    return light;
}

Color room_color(Ray ray)
{
    double t = INFINITY;
    int wall = 0;
    for (int i = 0; i < 3; i++) {
        double v = ray.direction[i];
        double there = ((v > 0 ? most[i] : least[i]) - ray.origin[i]) / v;
        if (v != 0 && there < t) {
            t = there;
            wall = i;
        }
    }
    vec3 p = ray.origin + t * ray.direction;
    bool positive = ray.direction[wall] > 0;
    Color color;
    if (wall == 1)
        color = positive ? ceiling_color(p[0], p[2]) : floor_color(p[0], p[2]);
    else if (wall == 0)
        color = positive ? window_wall(p[1], p[2], ray.direction) : brick_wall(p[1], p[2]);
    else
        color = end_wall(p[0], p[1], positive);
    return light_at(p, wall) * color;
}

// ---- the task -----------------------------------------------------------------------------------

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
