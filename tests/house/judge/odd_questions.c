// odd_questions.c - questions that a hostile answer asks the judge for what is lent: each argument
// of each exercise with numbers that nobody asks for. The reference must come back from all of
// them.
#include "tests/judge/message.h"
#include "tests/judge/test.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { QUESTIONS = 4000 }; // of each exercise

static uint64_t state = 2015;

static unsigned draw(unsigned below)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33) % below;
}

static double odd_double(void)
{
    static const double odd[] = {0,       -0.0,     NAN,     INFINITY, -INFINITY,
                                 DBL_MAX, -DBL_MAX, DBL_MIN, 5e-324,   1e9};
    return draw(3) != 0 ? (double)draw(2000) / 100 - 10 : odd[draw(sizeof odd / sizeof odd[0])];
}

static int odd_int(int most)
{
    static const int odd[] = {-1,  INT_MIN, INT_MAX, 1 << 30, 1 << 28,
                              100, 101,     16384,   16385,   65536};
    return draw(3) != 0 ? (int)draw((unsigned)most + 1) : odd[draw(sizeof odd / sizeof odd[0])];
}

static void set_odd(void *most, const char *name, void *at, size_t size, bool is_double)
{
    double x = odd_double();
    int i = odd_int(*(int *)most);
    (void)name;
    memcpy(at, is_double ? (void *)&x : (void *)&i, size);
}

// A picture with that many pixels, or one that only claims so.
static size_t put_image(Numbers *numbers)
{
    Resolution size = {(int)draw(9), (int)draw(9)}, said = size;
    if (draw(4) == 0)
        said = (Resolution){odd_int(9), odd_int(9)};
    size_t pixels = (size_t)size.width * (size_t)size.height;
    numbers_put(numbers, &type_Resolution, &said);
    for (size_t i = 0; i < 3 * pixels; i++)
        numbers_add(numbers, 0);
    return pixels;
}

// A list has as many items as it says, or not.
static void put_type(Numbers *numbers, const Type *type)
{
    if (type_is_flat(type)) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES] = {0};
        int most = type == &type_Resolution || type == &type_Pixel ? 640 : 4;
        type_visit(type, "", value, set_odd, &most);
        numbers_put(numbers, type, value);
        return;
    }
    for (const Field *field = type->fields; field < type->fields + type->count; field++) {
        int there = field->kind == FIELD_OF_ONE ? 1 : (int)draw(5);
        if (field->kind != FIELD_OF_ONE)
            numbers_add(numbers, draw(8) != 0 ? there : odd_int(5));
        while (there-- > 0)
            put_type(numbers, field->type);
    }
}

static void put(Numbers *numbers, const char *name, size_t *pixels)
{
    if (strcmp(name, "Image") == 0)
        *pixels = put_image(numbers);
    else if (strcmp(name, "Doubles") != 0)
        put_type(numbers, type_named(name));
    else
        for (size_t i = 0; i < *pixels; i++)
            put_type(numbers, &type_double);
}

static void ask(int exercise, Numbers *question)
{
    char name[40];
    int used;
    size_t pixels = 0;
    numbers_clear(question);
    for (const char *types = exercises[exercise].arguments;
         sscanf(types, " %39s%n", name, &used) == 1; types += used)
        put(question, name, &pixels);
    question->is_hostile = true;
}

TEST(apply, the_reference_comes_back_from_any_question)
{
    Numbers question = {0}, answer = {0};
    for (int i = 0; exercises[i].name != NULL; i++) {
        int answers = 0;
        given("function", "%s", exercises[i].name);
        for (int n = 0; n < QUESTIONS; n++) {
            ask(i, &question);
            numbers_clear(&answer);
            answers += apply(i, exercises[i].reference, &question, &answer);
        }
        expect_law(answers > 0, "some of these questions have an answer", "none has");
    }
    numbers_free(&question);
    numbers_free(&answer);
}
END_TEST
