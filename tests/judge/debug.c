// debug.c - the calls of one test of a table, made directly: for gdb (tests/course/course.c).
//
//   PROGRAM STEM --test NAME
#include "tests/judge/table.h"

#include "tests/judge/exercise.h"
#include "tests/judge/message.h"

#include <string.h>

void case_begins(int number);

// Where gdb stops.
__attribute__((noinline)) void case_begins(int number)
{
    __asm__ volatile("" ::"r"(number));
}

static void make_calls(int exercise, const TableTest *test)
{
    static Numbers ignored;
    for (int i = 0; i < test->question_count; i++) {
        numbers_clear(&ignored);
        case_begins(i + 1);
        dispatch(exercise, &test->questions[i].arguments, &ignored);
    }
}

int main(int argc, char **argv)
{
    static Table table;
    if (argc != 4) {
        fprintf(stderr, "Usage: %s STEM --test NAME\n", argv[0]);
        return 2;
    }
    table_load(argv[1], &table);
    for (int i = 0; i < table.test_count; i++)
        if (strcmp(table.tests[i].name, argv[3]) == 0)
            make_calls(exercise_number(table.tests[i].function), &table.tests[i]);
    return 0;
}
