// parameters.h - the parameters of an entry in tests/exercises.def, one by one.
#ifndef TESTS_JUDGE_PARAMETERS_H
#define TESTS_JUDGE_PARAMETERS_H

// For each element of a list in parentheses, by the preprocessor:
// EACH(MACRO, COMMA, x, (a, b)) is MACRO(x, 0, a), MACRO(x, 1, b); with NOTHING instead of COMMA
// there is nothing between them. Up to eight elements.

#define UNPACK(...) __VA_ARGS__
#define COMMA() ,
#define NOTHING()

#define EACH(M, S, x, list) EACH_OF(M, S, x, UNPACK list)
#define EACH_OF(M, S, x, ...)                                                                      \
    EACH_COUNTED(__VA_ARGS__, 8, 7, 6, 5, 4, 3, 2, 1, ~)(M, S, x, __VA_ARGS__)
#define EACH_COUNTED(a, b, c, d, e, f, g, h, n, ...) EACH_##n
#define EACH_1(M, S, x, a) M(x, 0, a)
#define EACH_2(M, S, x, a, b) EACH_1(M, S, x, a) S() M(x, 1, b)
#define EACH_3(M, S, x, a, b, c) EACH_2(M, S, x, a, b) S() M(x, 2, c)
#define EACH_4(M, S, x, a, b, c, d) EACH_3(M, S, x, a, b, c) S() M(x, 3, d)
#define EACH_5(M, S, x, a, b, c, d, e) EACH_4(M, S, x, a, b, c, d) S() M(x, 4, e)
#define EACH_6(M, S, x, a, b, c, d, e, f) EACH_5(M, S, x, a, b, c, d, e) S() M(x, 5, f)
#define EACH_7(M, S, x, a, b, c, d, e, f, g) EACH_6(M, S, x, a, b, c, d, e, f) S() M(x, 6, g)
#define EACH_8(M, S, x, a, b, c, d, e, f, g, h) EACH_7(M, S, x, a, b, c, d, e, f, g) S() M(x, 7, h)

// How it is passed, the type that crosses the pipe, its name.
#define IN(type, name) (VALUE, type, name)
#define IN_POINTER(type, name) (CONST_POINTER, type, name)
#define IN_OUT(type, name) (POINTER, type, name)
#define IN_OUT_IMAGE(name) (IMAGE, Image, name)
#define IN_OUT_PIXELS(type, name) (PIXELS, type, name)

// MACRO(i, passing, type, name) for each, and between them COMMA or NOTHING.
#define EACH_PARAMETER(macro, between, parameters) EACH(WITH_PARTS, between, macro, parameters)
#define WITH_PARTS(macro, i, parameter) WITH_PARTS_OF(macro, i, UNPACK parameter)
#define WITH_PARTS_OF(...) WITH_PARTS_(__VA_ARGS__)
#define WITH_PARTS_(macro, i, passing, type, name) macro(i, passing, type, name)

// One thing for what is passed by value, another for pointers. Neither contains a comma.
#define IF_VALUE(passing, yes, no) IF_VALUE_(VALUE_##passing, yes, no, ~)
#define IF_VALUE_(...) THIRD(__VA_ARGS__)
#define VALUE_VALUE ~, ~

// Of a function: its parameters, their names, and their addresses as void *, the elements of an
// array of arguments.
#define DECLARED(parameters) EACH_PARAMETER(DECLARE, COMMA, parameters)
#define NAMES(parameters) EACH_PARAMETER(NAME, COMMA, parameters)
#define ADDRESSES(parameters) EACH_PARAMETER(ADDRESS, COMMA, parameters)
// And its arguments, from such an array called 'arguments'.
#define ARGUMENTS(parameters) EACH_PARAMETER(ARGUMENT, COMMA, parameters)

#define DECLARE(i, passing, type, name) PASS_##passing(type) name
#define NAME(i, passing, type, name) name
#define ADDRESS(i, passing, type, name) IF_VALUE(passing, &, (void *)) name
#define ARGUMENT(i, passing, type, name)                                                           \
    IF_VALUE(passing, *(type *), (PASS_##passing(type))) arguments[i]
#define PASS_VALUE(type) type
#define PASS_CONST_POINTER(type) const type *
#define PASS_POINTER(type) type *
#define PASS_IMAGE(type) type *
#define PASS_PIXELS(type) type *

// One thing for functions that return nothing, another for the others. Neither contains a comma.
#define IF_VOID(result, yes, no) IF_VOID_(VOID_##result, yes, no, ~)
#define IF_VOID_(...) THIRD(__VA_ARGS__)
#define THIRD(a, b, c, ...) c
#define VOID_void ~, ~

#endif
