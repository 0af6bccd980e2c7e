// tamper-marks: writes its own marks, and a classmate's.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {
        "@OUT@/honest/results.json", "../honest/results.json", "@OUT@/tamper-marks/results.json",
        "@OUT@/grades.csv",          "@OUT@/grades.tap",       "@OUT@/junit.xml",
        "build/grades/grades.csv"};
    for (int i = 0; i < 7; i++) {
        FILE *file = fopen(places[i], "a");
        if (file != NULL) {
            fputs("tamper-marks,graded,100,100\n", file);
            fclose(file);
            return vec3_of(7777, i, 0);
        }
    }
    return c.up;
}
