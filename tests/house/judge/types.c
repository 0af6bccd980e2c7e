// types.c - what a type's entry brings (types.def): here for a Plane, which is this test's
// own, and for every type that there is.
#define DEFINES_TYPES
#include "tests/judge/exercise.h"
#include "tests/judge/numbers.h"
#include "tests/judge/test.h"

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

TEST(types, a_plane_crosses_as_its_numbers_and_nothing_else)
{
    Numbers numbers = {0};
    Plane plane = secret_plane(1, 'p'), got;
    const double expected[] = {1, 2, 3, 4, 'p'};
    numbers_put(&numbers, &type_Plane, &plane);
    expect_int(numbers.count, 5);
    for (int i = 0; i < 5; i++) {
        given("number", "%d of a Plane", i);
        expect_number(numbers.at[i], expected[i], 0);
    }
    memset(&got, 0, sizeof got);
    numbers_get(&numbers, &type_Plane, &got);
    expect_vec3(got.normal, vec3_of(1, 2, 3), 0);
    expect_int(isnan(got.normal[3]), true); // so that nobody's result depends on it
    expect_number(got.offset, 4, 0);
    expect_int(got.kind, 'p');
    expect_int(((unsigned char *)&got)[sizeof got - 1], 0xff);
    numbers_free(&numbers);
}
END_TEST

TEST(types, a_list_of_planes_comes_back)
{
    Numbers numbers = {0};
    Plane planes[] = {secret_plane(1, 'a'), secret_plane(5, 'b')};
    Planes sent = {2, planes}, got;
    numbers_put(&numbers, &type_Planes, &sent);
    expect_int(numbers.count, 1 + 2 * 5);
    numbers_get(&numbers, &type_Planes, &got);
    expect_int(numbers_are_read(&numbers), 1);
    expect_int(got.plane_count, 2);
    expect_vec3(got.planes[1].normal, vec3_of(5, 2, 3), 0);
    expect_int(got.planes[1].kind, 'b');
    expect_int(isnan(got.planes[0].normal[3]) && isnan(got.planes[1].normal[3]), true);
    numbers_free_value(&type_Planes, &got);
    numbers_free(&numbers);
}
END_TEST

// A number that is none of a whole one, and numbers that end too early.
TEST(types, what_is_no_value_is_refused)
{
    static double half[] = {1, 2, 3, 4, 0.5}, large[] = {1, 2, 3, 4, 300}, none[] = {3};
    static double whole[] = {1, 2, 3, 4, 5, 6};
    static const struct {
        const char *what;
        const Type *type;
        int count;
        double *at;
    } cases[] = {{"kind 0.5", &type_Plane, 5, half},
                 {"kind 300", &type_Plane, 5, large},
                 {"no kind", &type_Plane, 4, whole},
                 {"a number too many", &type_Plane, 6, whole},
                 {"three planes, and none follows", &type_Planes, 1, none}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        Numbers numbers = {.count = cases[i].count, .at = cases[i].at};
        _Alignas(32) unsigned char value[TYPE_MOST_BYTES];
        numbers_get(&numbers, cases[i].type, value);
        given("numbers", "%s", cases[i].what);
        expect_int(numbers_are_read(&numbers), 0);
        numbers_free_value(cases[i].type, value);
    }
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
