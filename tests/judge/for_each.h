// for_each.h - a macro for each element of a list in parentheses, by the preprocessor.
//
// EACH(MACRO, COMMA, x, (a, b)) is MACRO(x, 0, a), MACRO(x, 1, b); with NOTHING instead of COMMA
// there is nothing between them. Up to eight elements.
#ifndef TESTS_JUDGE_FOR_EACH_H
#define TESTS_JUDGE_FOR_EACH_H

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

#endif
