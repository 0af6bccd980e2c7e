// types.c - the parts of a type.
#define DEFINES_TYPES
#include "tests/judge/types.h"

#include <math.h>
#include <string.h>

#include "tests/judge/types.def"
const Type type_void = {"void", 0, TYPE_OF_NUMBERS, 0, NULL};

#undef NUMBERS
#undef WHOLE
#undef STRUCT
#define NUMBERS(type, n) &type_##type,
#define WHOLE(type) &type_##type,
#define STRUCT(type, list) &type_##type,
static const Type *const types[] = {
#include "tests/judge/types.def"
};

const Type *type_named(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strcmp(types[i]->name, name) == 0)
            return types[i];
    return NULL;
}

bool type_is_flat(const Type *type)
{
    bool flat = true;
    for (int i = 0; type->kind == TYPE_OF_FIELDS && i < type->count; i++)
        flat = flat && type->fields[i].kind == FIELD_OF_ONE && type_is_flat(type->fields[i].type);
    return flat;
}

bool number_near(double yours, double expected, double tolerance)
{
    return yours == expected || fabs(yours - expected) <= tolerance;
}

bool type_near(const Type *type, const void *yours, const void *expected, double tolerance,
               double tolerance_of_lengths)
{
    const double *y = yours, *e = expected;
    if (type->kind == TYPE_OF_WHOLE)
        return memcmp(yours, expected, type->size) == 0;
    bool near = true;
    for (int i = 0; near && type->kind == TYPE_OF_NUMBERS && i < type->count; i++)
        near = number_near(y[i], e[i], tolerance);
    for (int i = 0; near && type->kind == TYPE_OF_FIELDS && i < type->count; i++) {
        const Field *field = &type->fields[i];
        near = type_near(field->type, (const char *)yours + field->offset,
                         (const char *)expected + field->offset,
                         field->is_length ? tolerance_of_lengths : tolerance, tolerance_of_lengths);
    }
    return near;
}

void type_visit(const Type *type, const char *name, void *value, NumberVisitor *visit,
                void *context)
{
    if (type->kind == TYPE_OF_NUMBERS)
        for (int i = 0; i < type->count; i++)
            visit(context, name, (double *)value + i, sizeof(double), true);
    else if (type->kind == TYPE_OF_WHOLE)
        visit(context, name, value, type->size, false);
    else
        for (const Field *field = type->fields; field < type->fields + type->count; field++)
            type_visit(field->type, field->name, (char *)value + field->offset, visit, context);
}
