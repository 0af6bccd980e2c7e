// parameters.h - the parameters of an entry in tests/exercises.def, one by one.
#ifndef TESTS_JUDGE_PARAMETERS_H
#define TESTS_JUDGE_PARAMETERS_H

#include "tests/judge/for_each.h"

// How it is passed, the type that crosses the pipe, its name.
#define IN(type, name) (VALUE, type, name)
#define IN_POINTER(type, name) (CONST_POINTER, type, name)
#define IN_OUT(type, name) (POINTER, type, name)
#define IN_OUT_IMAGE(name) (IMAGE, Image, name)
#define IN_OUT_PIXELS(type, name) (PIXELS, type, name)

// MACRO_VALUE(i, type, name), MACRO_POINTER(i, type, name) and so on, by how it is passed.
#define BY_PASSING(macro, i, parameter) BY_PASSING_OF(macro, i, UNPACK parameter)
#define BY_PASSING_OF(...) BY_PASSING_(__VA_ARGS__)
#define BY_PASSING_(macro, i, passing, type, name) macro##_##passing(i, type, name)

// Its declaration: of a function, DECLARED(parameters).
#define DECLARED(parameters) EACH(BY_PASSING, COMMA, DECLARE, parameters)
#define DECLARE_VALUE(i, type, name) type name
#define DECLARE_CONST_POINTER(i, type, name) const type *name
#define DECLARE_POINTER(i, type, name) type *name
#define DECLARE_IMAGE(i, type, name) type *name
#define DECLARE_PIXELS(i, type, name) type *name

// The address of its value, as void *: the elements of an array of arguments.
#define ADDRESSES(parameters) EACH(BY_PASSING, COMMA, ADDRESS, parameters)
#define ADDRESS_VALUE(i, type, name) &name
#define ADDRESS_CONST_POINTER(i, type, name) (void *)name
#define ADDRESS_POINTER(i, type, name) name
#define ADDRESS_IMAGE(i, type, name) name
#define ADDRESS_PIXELS(i, type, name) name

// The argument, from such an array called 'arguments'.
#define ARGUMENTS(parameters) EACH(BY_PASSING, COMMA, ARGUMENT, parameters)
#define ARGUMENT_VALUE(i, type, name) *(type *)arguments[i]
#define ARGUMENT_CONST_POINTER(i, type, name) (const type *)arguments[i]
#define ARGUMENT_POINTER(i, type, name) (type *)arguments[i]
#define ARGUMENT_IMAGE(i, type, name) (type *)arguments[i]
#define ARGUMENT_PIXELS(i, type, name) (type *)arguments[i]

// One thing for functions that return nothing, another for the others. Neither contains a comma.
#define IF_VOID(result, yes, no) IF_VOID_(VOID_##result, yes, no, ~)
#define IF_VOID_(...) THIRD(__VA_ARGS__)
#define THIRD(a, b, c, ...) c
#define VOID_void ~, ~

#endif
