// explain_headers.h - what the headers that an answer may include declare.
//
// The headers themselves are the only place that has all of it: the exercises, the helpers of
// common/, the types and their parts, constants, macros. This is all that the explainer asks of
// them.
#ifndef TESTS_COURSE_EXPLAIN_HEADERS_H
#define TESTS_COURSE_EXPLAIN_HEADERS_H

#include "tests/course/explain_text.h"

typedef struct {
    const char *name, *type;
    bool is_pointer;
} Field;

typedef struct {
    const char *name, *header;
    Field *fields; // of a struct
    size_t field_count;
    const char *parts;  // "x, y"; "" if it is not a struct
    const char *values; // of an enum: the first three
} DeclaredType;

typedef struct {
    const char *name, *header;
    const char *prototype; // vec3 upper_left(Camera c)
    const char *arguments; // (Camera c)
    const char *type;      // vec3
} DeclaredFunction;

typedef struct {
    const char *name, *header;
} DeclaredName;

typedef struct {
    DeclaredName *names; // of all kinds
    size_t name_count, name_room;
    DeclaredType *types;
    size_t type_count, type_room;
    DeclaredFunction *functions;
    size_t function_count, function_room;
} Headers;

// Those of exercises/ and of common/ in the current folder.
Headers headers_read(void);

// The header that declares it, or NULL.
const char *header_of(const Headers *headers, const char *name);
// A name that differs only in its capitals: of a type, or of a constant; NULL if there is none. Of
// the exercises' headers, those up to this one are looked into.
const DeclaredName *header_name_like(const Headers *headers, const char *name, bool is_type,
                                     const char *last_header);
const DeclaredFunction *header_function(const Headers *headers, const char *name);

// Whether it names a type: a struct, an enum, a vector, or a number.
bool header_type(const Headers *headers, const char *name);
// A struct's parts, "" if it is not a struct; its field, or NULL; an enum's values, or "".
const char *header_parts(const Headers *headers, const char *type);
const Field *header_field(const Headers *headers, const char *type, const char *field);
const char *header_values(const Headers *headers, const char *type);

// The types of a prototype's parameters, without const and *.
Lines header_parameter_types(const char *arguments);

#endif
