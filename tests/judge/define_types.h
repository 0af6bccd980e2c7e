// define_types.h - makes a Type of each entry that follows (types.def says what entries are).
#ifndef TESTS_JUDGE_DEFINE_TYPES_H
#define TESTS_JUDGE_DEFINE_TYPES_H

#include "tests/judge/parameters.h"
#include "tests/judge/types.h"

#define NUMBERS(type, n) const Type type_##type = {#type, sizeof(type), TYPE_OF_NUMBERS, n, NULL};
#define WHOLE(type) const Type type_##type = {#type, sizeof(type), TYPE_OF_WHOLE, 1, NULL};
#define STRUCT(type, list)                                                                         \
    static const Field fields_of_##type[] = {EACH(FIELD_IN, COMMA, type, list)};                   \
    const Type type_##type = {#type, sizeof(type), TYPE_OF_FIELDS,                                 \
                              sizeof fields_of_##type / sizeof(Field), fields_of_##type};          \
    _Static_assert(sizeof(type) <= TYPE_MOST_BYTES, "TYPE_MOST_BYTES is too small");

#define FIELD(type, field) (FIELD_OF_ONE, type, field, #field " ")
#define FIELD_AS(label, type, field) (FIELD_OF_ONE, type, field, label)
#define LENGTH(type, field) (FIELD_OF_LENGTH, type, field, #field " ")
#define LENGTH_AS(label, type, field) (FIELD_OF_LENGTH, type, field, label)
#define LIST(type, field, count) (FIELD_OF_LIST, type, field, count)
#define PIXELS(field) (FIELD_OF_PIXELS, ~, field, size)

#define FIELD_IN(owner, i, field) FIELD_IN_(owner, UNPACK field)
#define FIELD_IN_(...) FIELD_BY_KIND(__VA_ARGS__)
#define FIELD_BY_KIND(owner, kind, type, field, other) IN_##kind(owner, type, field, other)
#define IN_FIELD_OF_ONE(owner, type, field, label)                                                 \
    {                                                                                              \
        FIELD_OF_ONE, #field, label, &type_##type, offsetof(owner, field), 0, false                \
    }
#define IN_FIELD_OF_LENGTH(owner, type, field, label)                                              \
    {                                                                                              \
        FIELD_OF_ONE, #field, label, &type_##type, offsetof(owner, field), 0, true                 \
    }
#define IN_FIELD_OF_LIST(owner, type, field, count)                                                \
    {                                                                                              \
        FIELD_OF_LIST, #field, NULL, &type_##type, offsetof(owner, field), offsetof(owner, count), \
            false                                                                                  \
    }
#define IN_FIELD_OF_PIXELS(owner, type, field, size)                                               \
    {                                                                                              \
        FIELD_OF_PIXELS, #field, NULL, NULL, offsetof(owner, field), offsetof(owner, size), false  \
    }

#endif
