// type_words.c - a value in words, by the fields of its type.
#include "tests/judge/types.h"

#include "common/text.h"

#include <stdio.h>
#include <string.h>

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
