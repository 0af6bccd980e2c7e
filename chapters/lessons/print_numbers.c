// print_numbers.c - the numbers of a lesson, for fill.py: {"NAME": "TEXT", ...}
#include "chapters/lessons/fill.h"
#include "common/text.h"

#include <stdio.h>

int main(void)
{
    int count;
    fill_numbers();
    const FilledNumber *numbers = filled_numbers(&count);
    for (int i = 0; i < count; i++) {
        printf(i == 0 ? "{" : ", ");
        json_print_string(stdout, numbers[i].name);
        printf(": ");
        json_print_string(stdout, numbers[i].text);
    }
    printf("}\n");
    return 0;
}
