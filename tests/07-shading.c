// 07-shading.c - tests of exercise 07: the list of them.
#include "tests/07-shading-scene.h"

void list_tests(void)
{
    list_tests_of_off_surface();
    list_tests_of_visibility();
    list_tests_of_shade();
    list_tests_of_trace_ray();
}
