// message.c - one call of an exercise as a message.
#include "tests/judge/message.h"

#include <stdio.h>
#include <string.h>

void (*before_call)(void *result, size_t size);

const void *message_block(MessageHeader header, const Numbers *numbers, size_t *size)
{
    static struct {
        size_t room;
        unsigned char *bytes;
    } block;
    header.size = (uint64_t)numbers->count * sizeof *numbers->at;
    *size = sizeof header + (size_t)header.size;
    if (*size > block.room) {
        free(block.bytes);
        block.room = 2 * *size;
        block.bytes = malloc(block.room);
        if (block.bytes == NULL)
            abort();
    }
    memcpy(block.bytes, &header, sizeof header);
    if (numbers->count > 0)
        memcpy(block.bytes + sizeof header, numbers->at, (size_t)header.size);
    return block.bytes;
}

bool message_make_room(const MessageHeader *header, Numbers *numbers)
{
    numbers_clear(numbers);
    bool good = header->magic == MESSAGE_MAGIC && header->size % sizeof *numbers->at == 0 &&
                numbers_make_room(numbers, header->size / sizeof *numbers->at);
    numbers->count = good ? (int)(header->size / sizeof *numbers->at) : 0;
    return good;
}

// The image of a call, whose size gives the number of pixels.
static Image *image_of(const Exercise *exercise, void *const *arguments)
{
    for (int i = 0; i < exercise->parameter_count; i++)
        if (exercise->parameters[i].passing == PASSED_IMAGE)
            return arguments[i];
    return NULL;
}

static void put_arguments(Numbers *numbers, int number, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    const Image *image = image_of(exercise, arguments);
    for (int i = 0; i < exercise->parameter_count; i++) {
        if (exercise->parameters[i].passing == PASSED_PIXELS)
            numbers_put_doubles(numbers, arguments[i], image);
        else
            numbers_put(numbers, exercise->parameters[i].type, arguments[i]);
    }
}

static void put_results(Numbers *numbers, int number, const void *result, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    const Image *image = image_of(exercise, arguments);
    int first = numbers->count;
    numbers_put(numbers, exercise->result, result);
    // If there are fewer roots, the values of the unused t do not matter.
    for (int i = 0; exercise->result == &type_Roots && i < 2; i++)
        if (!(i < numbers->at[first]))
            numbers->at[first + 1 + i] = 0;
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if (passing == PASSED_POINTER)
            numbers_put(numbers, exercise->parameters[i].type, arguments[i]);
        if (passing == PASSED_IMAGE)
            numbers_put_pixels(numbers, image);
        if (passing == PASSED_PIXELS)
            numbers_put_doubles(numbers, arguments[i], image);
    }
}

void get_results(Numbers *numbers, int number, void *result, void *const *arguments)
{
    const Exercise *exercise = &exercises[number];
    Image *image = image_of(exercise, arguments);
    numbers_get(numbers, exercise->result, result);
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if (passing == PASSED_POINTER)
            numbers_get(numbers, exercise->parameters[i].type, arguments[i]);
        if (passing == PASSED_IMAGE)
            numbers_get_pixels(numbers, image);
        if (passing == PASSED_PIXELS)
            numbers_get_into_doubles(numbers, arguments[i], image);
    }
}

Resolution image_size(int number, const Numbers *arguments)
{
    const Exercise *exercise = &exercises[number];
    Numbers rest = numbers_again(arguments);
    Resolution size = {0, 0};
    for (int i = 0; i < exercise->parameter_count; i++) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES];
        const Type *type = exercise->parameters[i].type;
        if (exercise->parameters[i].passing == PASSED_IMAGE) {
            NUMBERS_GET(&rest, Resolution, size);
            break;
        }
        numbers_get(&rest, type, value);
        numbers_free_value(type, value);
    }
    return size;
}

// The conditions that the reference relies on, if a student's process calls it.
static bool are_allowed(const Numbers *numbers, const Exercise *exercise, void *const *arguments)
{
    enum { MOST_DEPTH = 100 };
    bool allowed = true;
    const Scene *scene = NULL;
    for (int i = 0; numbers->is_hostile && i < exercise->parameter_count; i++) {
        const Type *type = exercise->parameters[i].type;
        const void *value = arguments[i];
        if (type == &type_Scene)
            scene = value;
        if (type == &type_Hit) {
            int sphere = ((const Hit *)value)->sphere;
            allowed = allowed && scene != NULL && sphere >= 0 && sphere < scene->sphere_count;
        }
        if (type == &type_int)
            allowed = allowed && *(const int *)value <= MOST_DEPTH;
        if (type == &type_Light)
            allowed = allowed && is_light_kind(((const Light *)value)->kind);
        if (type == &type_Handedness) {
            Handedness world = *(const Handedness *)value;
            allowed = allowed && (world == LEFT_HANDED || world == RIGHT_HANDED);
        }
    }
    return allowed;
}

// Whether an array that came from a message was written past its end.
static bool have_overrun(const Exercise *exercise, void *const *arguments)
{
    const Image *image = image_of(exercise, arguments);
    for (int i = 0; i < exercise->parameter_count; i++) {
        Passing passing = exercise->parameters[i].passing;
        if ((passing == PASSED_IMAGE && pixels_overran(image)) ||
            (passing == PASSED_PIXELS && doubles_overran(arguments[i], image)))
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
            numbers_free_doubles(arguments[i]);
        else
            numbers_free_value(exercise->parameters[i].type, &values[i]);
}

// A result that is returned in memory may be built in the frame of the function that makes the
// call. The room puts that frame below those of before_call, which has filled the stack below them.
static __attribute__((noinline)) void call_below(const Exercise *exercise, AnyFunction *function,
                                                 void *result, void *const *arguments)
{
    unsigned char room[512];
    __asm__ volatile("" : : "r"(room) : "memory");
    exercise->call(function, result, arguments);
}

// The function may change everything in an image, so its results are read with the image of the
// arguments.
bool apply(int number, AnyFunction *function, Numbers *in, Numbers *out)
{
    const Exercise *exercise = &exercises[number];
    Value values[MOST_PARAMETERS], given[MOST_PARAMETERS], result;
    void *arguments[MOST_PARAMETERS], *results[MOST_PARAMETERS];
    for (int i = 0; i < exercise->parameter_count; i++) {
        const Parameter *parameter = &exercise->parameters[i];
        arguments[i] = results[i] = &values[i];
        if (parameter->passing == PASSED_PIXELS) {
            arguments[i] = results[i] = numbers_get_doubles(in, image_of(exercise, arguments));
            continue;
        }
        numbers_get(in, parameter->type, &values[i]);
        if (!type_is_flat(parameter->type)) {
            given[i] = values[i];
            results[i] = &given[i];
        }
    }
    bool good = numbers_are_read(in) && are_allowed(in, exercise, arguments);
    if (good) {
        if (before_call != NULL)
            before_call(&result, sizeof result);
        call_below(exercise, function, &result, arguments);
        put_results(out, number, &result, results);
        out->overran = out->overran || have_overrun(exercise, results);
    }
    free_arguments(exercise, given, results);
    return good;
}

// ---- a call by the transport that was chosen ---------------------------------------------------

static Transport *transport;
static void (*refuse_answer)(int exercise);

void transport_use(Transport *wanted, void (*refuse)(int exercise))
{
    transport = wanted;
    refuse_answer = refuse;
}

Numbers *transport_ask(int exercise, Numbers *question)
{
    return transport(exercise, question);
}

void transport_check(int exercise, const Numbers *answer)
{
    if (refuse_answer != NULL && !numbers_are_read(answer))
        refuse_answer(exercise);
}

void transport_call(int exercise, void *result, void *const *arguments)
{
    static Numbers question;
    numbers_clear(&question);
    put_arguments(&question, exercise, arguments);
    Numbers *answer = transport_ask(exercise, &question);
    get_results(answer, exercise, result, arguments);
    transport_check(exercise, answer);
}

// To a function of this process.
static AnyFunction *answering;

static Numbers *ask_here(int exercise, Numbers *question)
{
    static Numbers answer;
    answer_here(exercise, answering, question, &answer);
    return &answer;
}

void answer_here_by(AnyFunction *function)
{
    transport_use(ask_here, NULL);
    answering = function;
}

void answer_here(int exercise, AnyFunction *function, Numbers *in, Numbers *out)
{
    in->read = 0;
    numbers_clear(out);
    if (!apply(exercise, function, in, out))
        fprintf(stderr, "%s: its arguments are not a valid message\n", exercises[exercise].name);
}

// ---- the memory that nobody has set ------------------------------------------------------------

static int paint_now;

void paint_calls(int paint)
{
    paint_now = paint;
}

// No value is wrong in every place: a large number is never the smallest, NaN is neither larger nor
// smaller than any, fmin and fmax skip it; -1 is the index of no sphere; a bool is true or false.
// So these take turns, a number of them that no pattern of the tests has: as doubles they are
// -5e303, NaN, 5e303, 0 and 1e209.
int paint_of_call(int exercise)
{
    static const unsigned char bytes[] = {0xfe, 0xff, 0x7e, 0x00, PAINT};
    static unsigned calls[EXERCISE_COUNT];
    if (paint_now != NO_PAINT)
        return paint_now;
    return bytes[calls[exercise]++ % sizeof bytes];
}

bool is_paint(double number, int paint)
{
    double painted;
    int painted_int;
    memset(&painted, paint, sizeof painted);
    memset(&painted_int, paint, sizeof painted_int);
    return number == painted || number == painted_int;
}
