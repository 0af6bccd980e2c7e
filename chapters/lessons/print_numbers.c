// print_numbers.c - the numbers of the example as JSON: {"NAME": "TEXT", ...}
#include "chapters/lessons/numbers.h"
#include "common/text.h"

#include <stdio.h>

int main(void)
{
    int count;
    const NamedNumber *numbers = named_numbers(&count);
    for (int i = 0; i < count; i++) {
        printf(i == 0 ? "{" : ", ");
        json_print_string(stdout, numbers[i].name);
        printf(": ");
        json_print_string(stdout, numbers[i].text);
    }
    printf("}\n");
    return 0;
}
