// test.c - the arguments of a test, its random numbers, and its expected result: both sides in
// words if they differ.
#include "tests/judge/test.h"

#include "common/text.h"
#include "tests/judge/runner.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Met: the next given begins a new case. Not met: both sides are kept and the test ends.
static void settle(bool met, const char *yours, const char *expected)
{
    Record *record = record_now();
    if (met && !record_is_missing()) {
        record->closed = true;
        return;
    }
    record_keep_printed();
    snprintf(record->expected, sizeof record->expected, "%s", expected);
    snprintf(record->yours, sizeof record->yours, "%s", yours);
    ck_abort_msg("not as expected");
}

void (*expectation_listener)(const Expectation *expectation);

void expects(Expectation expectation)
{
    if (expectation_listener != NULL)
        expectation_listener(&expectation);
}

// Enough digits to see how numbers differ that are not near.
static int digits_that_tell(const double *yours, const double *expected, int count,
                            double tolerance)
{
    int digits = 6;
    for (int i = 0; i < count; i++)
        while (digits < 17 && !number_near(yours[i], expected[i], tolerance) &&
               strcmp(number_text_to(yours[i], digits).s, number_text_to(expected[i], digits).s) ==
                   0)
            digits++;
    return digits;
}

void expect_numbers(const double *yours, const double *expected, int count, double tolerance)
{
    bool met = true;
    expects((Expectation){count, yours, expected, tolerance, 0, false, 0, 0});
    for (int i = 0; i < count; i++)
        met = met && number_near(yours[i], expected[i], tolerance);
    char y[400] = "", e[400] = "";
    if (met) {
        settle(true, y, e);
        return;
    }
    int digits = digits_that_tell(yours, expected, count, tolerance);
    size_t y_used = 0, e_used = 0;
    for (int i = 0; i < count; i++) {
        Text a = number_text_to(yours[i], digits), b = number_text_to(expected[i], digits);
        int wide = (int)(strlen(a.s) > strlen(b.s) ? strlen(a.s) : strlen(b.s));
        if (record_is_missing()) // then yours is not shown
            wide = 0;
        const char *before = count == 1 ? "" : i == 0 ? "(" : ", ";
        const char *behind = count > 1 && i == count - 1 ? ")" : "";
        snprintf(y + y_used, sizeof y - y_used, "%s%*s%s", before, wide, a.s, behind);
        snprintf(e + e_used, sizeof e - e_used, "%s%*s%s", before, wide, b.s, behind);
        y_used = strlen(y);
        e_used = strlen(e);
    }
    settle(false, y, e);
}

void expect_number(double yours, double expected, double tolerance)
{
    expect_numbers(&yours, &expected, 1, tolerance);
}

void expect_vec3(vec3 yours, vec3 expected, double tolerance)
{
    const double y[3] = {yours[0], yours[1], yours[2]};
    const double e[3] = {expected[0], expected[1], expected[2]};
    expect_numbers(y, e, 3, tolerance);
}

void expect_pair(double yours_x, double yours_y, double x, double y, double tolerance)
{
    expect_numbers((const double[]){yours_x, yours_y}, (const double[]){x, y}, 2, tolerance);
}

typedef struct {
    int count;
    double at[TYPE_MOST_BYTES / sizeof(double)];
} Doubles;

static void add_double(void *context, const char *name, void *number, size_t size, bool is_double)
{
    Doubles *doubles = context;
    (void)name, (void)size;
    if (is_double)
        doubles->at[doubles->count++] = *(double *)number;
}

static Doubles doubles_of(const Type *type, const void *value)
{
    _Alignas(32) unsigned char bytes[TYPE_MOST_BYTES];
    Doubles doubles = {.count = 0};
    memcpy(bytes, value, type->size);
    type_visit(type, "", bytes, add_double, &doubles);
    return doubles;
}

static void expect_parts(const Type *type, const char *yours, const char *expected,
                         double tolerance, double tolerance_of_lengths)
{
    if (type->kind == TYPE_OF_NUMBERS)
        expects((Expectation){type->count, (const double *)yours, (const double *)expected,
                              tolerance, 0, false, 0, 0});
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        const Field *field = &type->fields[i];
        expect_parts(field->type, yours + field->offset, expected + field->offset,
                     field->is_length ? tolerance_of_lengths : tolerance, tolerance_of_lengths);
    }
}

void expect_value(const Type *type, const void *yours, const void *expected, double tolerance,
                  double size)
{
    bool met = type_near(type, yours, expected, tolerance, tolerance * size);
    char y[CAMERA_WORDS] = "", e[CAMERA_WORDS] = "";
    Doubles its = doubles_of(type, yours), right = doubles_of(type, expected);
    expect_parts(type, yours, expected, tolerance, tolerance * size);
    int digits = digits_that_tell(its.at, right.at, its.count, tolerance);
    while (!met && strcmp(y, e) == 0 && digits <= 17) {
        type_words(type, yours, digits, y, sizeof y);
        type_words(type, expected, digits++, e, sizeof e);
    }
    settle(met, y, e);
}

void expect_camera(Camera yours, Camera expected, double tolerance)
{
    expect_value(&type_Camera, &yours, &expected, tolerance, 1);
}

void expect_camera_of_size(Camera yours, Camera expected, double tolerance, double size)
{
    expect_value(&type_Camera, &yours, &expected, tolerance, size);
}

void expect_fault(CameraFault yours, CameraFault expected)
{
    settle(yours == expected, yours == CAMERA_OK ? "a camera" : camera_fault_text(yours),
           expected == CAMERA_OK ? "a camera" : camera_fault_text(expected));
}

void expect_int(long yours, long expected)
{
    char y[32], e[32];
    snprintf(y, sizeof y, "%ld", yours);
    snprintf(e, sizeof e, "%ld", expected);
    settle(yours == expected, y, e);
}

void expect_text(const char *yours, const char *expected)
{
    settle(strcmp(yours, expected) == 0, yours, expected);
}

void expect_same_ray(Ray yours, Ray expected, double tolerance)
{
    double length = vec3_length(yours.direction);
    vec3 scaled = vec3_length(expected.direction) / length * yours.direction;
    Ray like = {yours.origin, scaled};
    bool met = length > 0 && type_near(&type_Ray, &like, &expected, tolerance, tolerance);
    char y[400], e[400];
    Doubles its = doubles_of(&type_Ray, &like);
    Doubles right = doubles_of(&type_Ray, &expected);
    int digits = digits_that_tell(its.at, right.at, its.count, tolerance);
    digits = digits < 9 ? 9 : digits;
    expects((Expectation){6, its.at, right.at, tolerance, 0, true, 0, 0});
    snprintf(y, sizeof y, "origin %s, direction %s", vec3_text_to(yours.origin, digits).s,
             vec3_text_to(yours.direction, digits).s);
    snprintf(e, sizeof e, "origin %s, direction %s (or any positive multiple)",
             vec3_text_to(expected.origin, digits).s, vec3_text_to(expected.direction, digits).s);
    settle(met, y, e);
}

void expect_same_image(const Image *yours, const Image *expected)
{
    size_t pixels = (size_t)expected->size.width * (size_t)expected->size.height;
    size_t first = 0, different = 0;
    for (size_t i = pixels; i-- > 0;)
        if (memcmp(yours->rgb + 3 * i, expected->rgb + 3 * i, 3) != 0) {
            first = i;
            different++;
        }
    const uint8_t *y = yours->rgb + 3 * first, *e = expected->rgb + 3 * first;
    size_t width = (size_t)expected->size.width;
    char yw[200], ew[200];
    snprintf(ew, sizeof ew, "in column %zu, row %zu: red %d, green %d, blue %d", first % width,
             first / width, e[0], e[1], e[2]);
    snprintf(yw, sizeof yw,
             "in column %zu, row %zu: red %d, green %d, blue %d; %zu of %zu pixels "
             "differ",
             first % width, first / width, y[0], y[1], y[2], different, pixels);
    settle(different == 0, yw, ew);
}

void expect_law(bool holds, const char *expected, const char *format, ...)
{
    char yours[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(yours, sizeof yours, format, arguments);
    va_end(arguments);
    settle(holds, yours, expected);
}

// ---- the arguments of a test, in words for its reader ------------------------------------------

void type_words(const Type *type, const void *value, int digits, char *words, size_t size)
{
    if (type->kind == TYPE_OF_NUMBERS && type->count == 3)
        snprintf(words, size, "%s", vec3_text_to(*(const vec3 *)value, digits).s);
    else if (type->kind == TYPE_OF_NUMBERS)
        snprintf(words, size, "%s", number_text_to(*(const double *)value, digits).s);
    else if (type->kind == TYPE_OF_WHOLE)
        snprintf(words, size, "%d", type->size == 1 ? *(const char *)value : *(const int *)value);
    const char *comma = "";
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        const Field *field = &type->fields[i];
        if (field->label == NULL)
            continue;
        snprintf(words, size, "%s%s", comma, field->label);
        comma = ", ";
        size -= strlen(words);
        words += strlen(words);
        type_words(field->type, (const char *)value + field->offset, digits, words, size);
        size -= strlen(words);
        words += strlen(words);
    }
}

__attribute__((noinline)) void case_begins(int number)
{
    Record *record = record_now();
    record->cases = number;
    record->closed = false;
    record->given[0] = '\0';
}

void given(const char *name, const char *format, ...)
{
    Record *record = record_now();
    if (record->cases == 0 || record->closed)
        case_begins(record->cases + 1);
    char value[CAMERA_WORDS];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(value, sizeof value, format, arguments);
    va_end(arguments);
    size_t used = strlen(record->given);
    snprintf(record->given + used, sizeof record->given - used, "%s\t%s\n", name, value);
}

void given_number(const char *name, double x)
{
    given(name, "%s", number_text_to(x, 10).s);
}

void given_vec3(const char *name, vec3 v)
{
    given(name, "%s", vec3_text_to(v, 10).s);
}

static void given_value(const char *name, const Type *type, const void *value, int digits)
{
    char words[CAMERA_WORDS];
    type_words(type, value, digits, words, sizeof words);
    given(name, "%s", words);
}

void given_camera(Camera camera)
{
    given_value("camera", &type_Camera, &camera, 6);
}

void given_ray(Ray ray)
{
    given_value("ray", &type_Ray, &ray, 10);
}

void given_sphere(Sphere sphere)
{
    given_value("sphere", &type_Sphere, &sphere, 10);
}

Camera camera_of_the_deck(void)
{
    return (Camera){.origin = vec3_of(2, 2, -4),
                    .right = vec3_of(1, 0, 0),
                    .up = vec3_of(0, 1, 0),
                    .forward = vec3_of(0, 0, 1),
                    .distance = 4,
                    .width = 2,
                    .height = 2};
}

// ---- expected roots, and both sides in words if they differ ------------------------------------

static Text roots_text(Roots roots, int digits)
{
    Text first = number_text_to(roots.t[0], digits), second = number_text_to(roots.t[1], digits);
    return roots.count == 1   ? text_of("1 root, %s", first.s)
           : roots.count == 2 ? text_of("2 roots, %s and %s", first.s, second.s)
                              : text_of("%d roots", roots.count);
}

void expect_roots(Roots yours, Roots expected, double within)
{
    bool same = yours.count == expected.count;
    for (int i = 0; i < expected.count; i++) {
        expects((Expectation){1, &yours.t[i], &expected.t[i], within, 0, false, 0, 0});
        same = same && number_near(yours.t[i], expected.t[i], within);
    }
    int digits = 6;
    while (digits < 17 && !same &&
           strcmp(roots_text(yours, digits).s, roots_text(expected, digits).s) == 0)
        digits++;
    expect_law(same, roots_text(expected, digits).s, "%s", roots_text(yours, digits).s);
}

// ---- numbers that look random, and that are the same for the same seed -------------------------

// SplitMix64 (Steele, Lea, Flood, 'Fast Splittable Pseudorandom Number Generators'). Each test
// starts again, whatever ran before it: from 2015, or, if the environment has SEED, from that seed
// and the test's name. Inputs made from a SEED are hidden from the student. Probes are the same in
// every run.

static bool seeded, is_hidden; // by the environment; and in this test
static uint64_t seed, state;

void random_take_seed(void)
{
    const char *wanted = getenv("SEED");
    seeded = wanted != NULL;
    if (!seeded)
        return;
    char *end;
    errno = 0;
    long long number = strtoll(wanted, &end, 10);
    if (!isdigit((unsigned char)wanted[0]) || *end != '\0' || errno != 0) {
        fprintf(stderr, "SEED=%s: expected a whole number from 0 to %lld\n", wanted,
                (long long)INT64_MAX);
        exit(2);
    }
    seed = (uint64_t)number;
}

static uint64_t mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint64_t next(void)
{
    return mixed(state += 0x9e3779b97f4a7c15u);
}

void random_begin(const char *test, bool is_probe)
{
    is_hidden = seeded && !is_probe;
    state = is_hidden ? seed : 2015;
    if (!is_hidden && !is_probe)
        return;
    for (; *test != '\0'; test++)
        state = next() ^ (unsigned char)*test;
    state = next();
}

double random_number(double low, double high)
{
    if (is_hidden)
        record_now()->hidden = true;
    return low + (high - low) * (double)(next() >> 11) / 9007199254740992.0;
}

double random_scale(int i, int count)
{
    double jitter = random_number(0, 1);
    if (i == 0 || i == count - 1)
        return i == 0 ? 1e-6 : 1e6;
    return pow(10, -6 + 12 * (i + jitter) / count);
}

vec3 random_vec3(double low, double high)
{
    double x = random_number(low, high), y = random_number(low, high);
    return vec3_of(x, y, random_number(low, high));
}

vec3 random_unit(void)
{
    for (;;) {
        vec3 v = random_vec3(-1, 1);
        double length = vec3_length(v);
        if (length > 0.1 && length <= 1)
            return v / length;
    }
}

Camera tilted_camera(void)
{
    return (Camera){.origin = vec3_of(3, -5, 7),
                    .right = vec3_of(2, -2, 1) / 3,
                    .up = vec3_of(2, 1, -2) / 3,
                    .forward = vec3_of(1, 2, 2) / 3,
                    .distance = 6,
                    .width = 9,
                    .height = 3};
}

Camera random_camera(void)
{
    vec3 forward = random_unit();
    vec3 right = vec3_unit(vec3_cross(forward, random_unit()));
    vec3 up = vec3_cross(right, forward);
    if (random_number(0, 1) < 0.5)
        up = -up; // the other handedness
    // One by one: C does not define in which order an initialiser calls them.
    vec3 origin = random_vec3(-5, 5);
    double distance = random_number(0.5, 6), width = random_number(0.5, 4);
    return (Camera){.origin = origin,
                    .right = right,
                    .up = up,
                    .forward = forward,
                    .distance = distance,
                    .width = width,
                    .height = random_number(0.5, 4)};
}

Ray random_ray(double origin, double direction)
{
    vec3 from = random_vec3(-origin, origin);
    return (Ray){from, random_vec3(-direction, direction)};
}

Sphere random_sphere(double center, double low, double high)
{
    vec3 place = random_vec3(-center, center);
    return (Sphere){.center = place, .radius = random_number(low, high)};
}

Resolution random_screen(int low, int below)
{
    int width = (int)random_number(low, below);
    return (Resolution){width, (int)random_number(low, below)};
}

Resolution random_shape(int i, int middle, int most)
{
    int shorter = (int)random_number(2, middle), longer = (int)random_number(middle, most);
    const Resolution shapes[] = {{1, longer}, {longer, 1}, {shorter, longer}, {longer, shorter}};
    return shapes[i % 4];
}

Pixel random_pixel(Resolution screen)
{
    int column = (int)random_number(0, screen.width);
    return (Pixel){column, (int)random_number(0, screen.height)};
}
