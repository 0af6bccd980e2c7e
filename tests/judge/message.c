// message.c - one call of an exercise as a message.
#include "tests/judge/message.h"

#include <string.h>

void (*before_call)(void);

// The image of a call, whose size gives the number of pixels.
static Image *image_of(const Exercise *exercise, void *const *arguments)
{
    for (int i = 0; i < exercise->parameter_count; i++)
        if (exercise->parameters[i].passing == PASSED_IMAGE)
            return arguments[i];
    return NULL;
}

void put_arguments(Wire *wire, int number, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    const Image *image = image_of(exercise, arguments);
    for (int i = 0; i < exercise->parameter_count; i++) {
        if (exercise->parameters[i].passing == PASSED_PIXELS)
            wire_put_doubles(wire, arguments[i], image);
        else
            wire_put_value(wire, exercise->parameters[i].type, arguments[i]);
    }
}

void put_results(Wire *wire, int number, const void *result, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    const Image *image = image_of(exercise, arguments);
    wire_put_value(wire, exercise->result, result);
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if (passing == PASSED_POINTER)
            wire_put_value(wire, exercise->parameters[i].type, arguments[i]);
        if (passing == PASSED_IMAGE)
            wire_put_pixels(wire, image);
        if (passing == PASSED_PIXELS)
            wire_put_doubles(wire, arguments[i], image);
    }
}

void get_results(Wire *wire, int number, void *result, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    Image *image = image_of(exercise, arguments);
    wire_get_value(wire, exercise->result, result);
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if (passing == PASSED_POINTER)
            wire_get_value(wire, exercise->parameters[i].type, arguments[i]);
        if (passing == PASSED_IMAGE)
            wire_get_pixels(wire, image);
        if (passing == PASSED_PIXELS)
            wire_get_into_doubles(wire, arguments[i], image);
    }
}

// The conditions that the reference relies on, if a student's process calls it.
static bool are_allowed(const Wire *wire, const Exercise *exercise, void *const *arguments)
{
    bool allowed = true;
    const Scene *scene = NULL;
    for (int i = 0; i < exercise->parameter_count; i++) {
        const Type *type = exercise->parameters[i].type;
        const void *value = arguments[i];
        if (type == &type_Scene)
            scene = value;
        if (type == &type_Hit)
            allowed = allowed && scene != NULL && wire_allows_hit(wire, *(const Hit *)value, scene);
        if (type == &type_int)
            allowed = allowed && wire_allows_depth(wire, *(const int *)value);
        if (type == &type_Light)
            allowed = allowed && wire_allows_light(wire, *(const Light *)value);
        if (type == &type_Handedness)
            allowed = allowed && wire_allows_world(wire, *(const Handedness *)value);
    }
    return allowed;
}

// Whether an array that came from a message was written past its end.
static bool have_overrun(const Exercise *exercise, void *const *arguments)
{
    const Image *image = image_of(exercise, arguments);
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if ((passing == PASSED_IMAGE && wire_pixels_overran(image)) ||
            (passing == PASSED_PIXELS && wire_doubles_overran(arguments[i], image)))
            return true;
    }
    return false;
}

typedef struct {
    _Alignas(32) unsigned char bytes[TYPE_MOST_BYTES];
} Value;

static void free_arguments(const Exercise *exercise, Value *values, void *const *arguments)
{
    for (int i = 0; i < exercise->parameter_count; i++)
        if (exercise->parameters[i].passing == PASSED_PIXELS)
            wire_free_doubles(arguments[i]);
        else
            wire_free_value(exercise->parameters[i].type, &values[i]);
}

// The function may change everything in an image, so its results are read with the image of the
// arguments.
bool apply(int number, AnyFunction *function, Wire *in, Wire *out)
{
    const Exercise *exercise = &exercises[number];
    Value values[MOST_PARAMETERS], given[MOST_PARAMETERS], result;
    void *arguments[MOST_PARAMETERS], *results[MOST_PARAMETERS];
    for (int i = 0; i < exercise->parameter_count; i++) {
        const Parameter *parameter = &exercise->parameters[i];
        arguments[i] = results[i] = &values[i];
        if (parameter->passing == PASSED_PIXELS) {
            arguments[i] = results[i] = wire_get_doubles(in, image_of(exercise, arguments));
            continue;
        }
        wire_get_value(in, parameter->type, &values[i]);
        if (!type_is_flat(parameter->type)) {
            given[i] = values[i];
            results[i] = &given[i];
        }
    }
    bool good = wire_is_read(in) && are_allowed(in, exercise, arguments);
    if (good) {
        if (before_call != NULL)
            before_call();
        exercise->call(function, &result, arguments);
        put_results(out, number, &result, results);
        out->overran = out->overran || have_overrun(exercise, results);
    }
    free_arguments(exercise, given, results);
    return good;
}
