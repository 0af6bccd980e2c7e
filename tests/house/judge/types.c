// types.c - what a type's entry brings (types.def): here for a Plane, which is this test's
// own, and for every type that there is.
#include "tests/judge/define_types.h"
#include "tests/judge/test.h"
#include "tests/judge/wire.h"

#include <string.h>

// A vec3 whose fourth lane is nobody's, and seven bytes at the end that are.
typedef struct {
    vec3 normal;
    double offset;
    char kind;
} Plane;
STRUCT(Plane, (FIELD(vec3, normal), LENGTH(double, offset), FIELD(char, kind)))

typedef struct {
    int plane_count;
    Plane *planes;
} Planes;
STRUCT(Planes, (LIST(Plane, planes, plane_count)))

enum { SECRET = 0xa5 };

// With a secret wherever no field is.
static Plane secret_plane(double x, char kind)
{
    Plane plane;
    memset(&plane, SECRET, sizeof plane);
    plane.normal[0] = x;
    plane.normal[1] = 2;
    plane.normal[2] = 3;
    plane.offset = 4;
    memcpy(&plane.kind, &kind, 1);
    return plane;
}

static bool is_in(size_t at, size_t from, size_t size)
{
    return at >= from && at < from + size;
}

TEST(types, the_padding_of_a_plane_crosses_as_zeros)
{
    Wire wire = {0};
    Plane plane = secret_plane(1, 'p');
    wire_put_value(&wire, &type_Plane, &plane);
    expect_int((long)wire.size, sizeof plane);
    for (size_t at = 0; at < sizeof plane; at++) {
        bool is_value = is_in(at, offsetof(Plane, normal), 3 * sizeof(double)) ||
                        is_in(at, offsetof(Plane, offset), sizeof(double)) ||
                        at == offsetof(Plane, kind);
        given("byte", "%zu of a Plane", at);
        expect_int(wire.bytes[at], is_value ? ((unsigned char *)&plane)[at] : 0);
    }
    wire_free(&wire);
}
END_TEST

TEST(types, what_is_received_has_no_padding_of_the_other_side)
{
    Wire wire = {0};
    Plane plane = secret_plane(1, 'p'), got;
    wire_put(&wire, &plane, sizeof plane); // by somebody who does not clear it
    memset(&got, 0, sizeof got);
    wire_get_value(&wire, &type_Plane, &got);
    expect_vec3(got.normal, vec3_of(1, 2, 3), 0);
    expect_int(isnan(got.normal[3]), true); // so that nobody's result depends on it
    expect_number(got.offset, 4, 0);
    expect_int(got.kind, 'p');
    expect_int(((unsigned char *)&got)[sizeof got - 1], 0xff);
    wire_free(&wire);
}
END_TEST

TEST(types, a_list_of_planes_comes_back_and_has_no_secrets)
{
    Wire wire = {0};
    Plane planes[] = {secret_plane(1, 'a'), secret_plane(5, 'b')};
    Planes sent = {2, planes}, got;
    wire_put_value(&wire, &type_Planes, &sent);
    for (size_t at = 0; at + sizeof(double) <= wire.size; at++)
        expect_int(wire.bytes[at] == SECRET && wire.bytes[at + 1] == SECRET, 0);
    wire_get_value(&wire, &type_Planes, &got);
    expect_int(wire_is_read(&wire), 1);
    expect_int(got.plane_count, 2);
    expect_vec3(got.planes[1].normal, vec3_of(5, 2, 3), 0);
    expect_int(got.planes[1].kind, 'b');
    expect_int(isnan(got.planes[0].normal[3]) && isnan(got.planes[1].normal[3]), true);
    wire_free_value(&type_Planes, &got);
    wire_free(&wire);
}
END_TEST

static void add_bytes(void *context, const char *name, void *number, size_t size, bool is_double)
{
    (void)name, (void)number, (void)is_double;
    *(size_t *)context += size;
}

// Of all bytes set, as many arrive as the numbers of the type have.
TEST(types, no_type_sends_more_bytes_than_its_numbers_have)
{
#undef NUMBERS
#undef WHOLE
#undef STRUCT
    static const Type *const types[] = {
#define NUMBERS(type, n) &type_##type,
#define WHOLE(type) &type_##type,
#define STRUCT(type, list) &type_##type,
#include "tests/judge/types.def"
        &type_Plane};
    int seen = 0;
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES];
        Wire wire = {0};
        size_t expected = 0;
        long set = 0;
        if (!type_is_flat(types[i]))
            continue;
        memset(value, 0xff, sizeof value);
        type_visit(types[i], "", value, add_bytes, &expected);
        wire_put_value(&wire, types[i], value);
        for (size_t at = 0; at < wire.size; at++)
            set += wire.bytes[at] != 0;
        given("type", "%s", types[i]->name);
        expect_int(set, (long)expected);
        wire_free(&wire);
        seen++;
    }
    expect_int(seen > 20, 1);
}
END_TEST

TEST(types, a_plane_is_told_in_the_words_of_its_entry)
{
    char words[200];
    Plane plane = secret_plane(1, 7);
    type_words(&type_Plane, &plane, 6, words, sizeof words);
    expect_text(words, "normal (1, 2, 3), offset 4, kind 7");
    type_words(&type_Plane, &plane, 6, words, 20);
    expect_text(words, "normal (1, 2, 3), o");
    Sphere sphere = {{1, 2, 3}, 4, 5};
    type_words(&type_Sphere, &sphere, 6, words, sizeof words);
    expect_text(words, "center (1, 2, 3), radius 4");
}
END_TEST

TEST(types, planes_are_equal_within_the_tolerances_of_their_fields)
{
    const double number = 1e-9, length = 1e-3;
    Plane plane = secret_plane(1, 'p'), other = plane;
    memset((char *)&other + sizeof other - 1, 0, 1); // padding is not compared
    other.normal[3] = 7;
    other.normal[2] += 0.9e-9;
    other.offset -= 0.9e-3;
    expect_int(type_near(&type_Plane, &other, &plane, number, length), 1);
    expect_value(&type_Plane, &other, &plane, 1e-9, 1e6);
    expect_int(type_near(&type_Plane, &other, &plane, number, number), 0);
    Plane turned = plane, kind = plane, none = plane;
    turned.normal[1] += 1e-8;
    kind.kind = 'q';
    none.offset = NAN;
    expect_int(type_near(&type_Plane, &turned, &plane, number, length), 0);
    expect_int(type_near(&type_Plane, &kind, &plane, number, length), 0);
    expect_int(type_near(&type_Plane, &none, &plane, number, length), 0);
}
END_TEST
