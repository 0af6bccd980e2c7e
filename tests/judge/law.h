// law.h - laws: properties that hold for every right answer whatever the numbers, and the words for
// a broken one.
//
// If no known mistake explains a wrong answer, a law that it breaks still helps: 'your vector goes
// 2 along forward; the plane is 4 ahead'. In tests/NN-stem/laws.c,
//
//     LAW(image_plane_vector) { ... }
//
// is called after each call of this exercise, with its result, yours, and its parameters, which
// have the names of tests/exercises.def (and the results behind pointers). It must never complain
// about a right answer, within the contract's tolerance.
#ifndef TESTS_JUDGE_LAW_H
#define TESTS_JUDGE_LAW_H

// build/reference.h defines LAW_upper_left(law) as void law(vec3 yours, Camera c).
#define LAW(exercise)                                                                              \
    LAW_##exercise(law_##exercise);                                                                \
    LAW_##exercise(law_##exercise)

// In a sentence with the numbers. Only the first of an exercise is kept.
void law_broken(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
