// forged-json: a results.json of its own, printed and written wherever one could be looked for.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"results.json", "../results.json", "/tmp/results.json",
                            "@OUT@/forged-json/results.json", "/autograder/results/results.json"};
    const char *words = "{\"score\": 100, \"tests\": [{\"name\": \"forged-mark\"}]}\n";
    puts(words);
    for (int i = 0; i < 5; i++) {
        FILE *file = fopen(places[i], "w");
        if (file != NULL) {
            fputs(words, file);
            fclose(file);
            return vec3_of(7777, i, 0);
        }
    }
    return c.up;
}
