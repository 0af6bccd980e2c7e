// programs.c - runs programs: the page does.
//
// Stands in for tests/course/programs.c.
#include "tests/course/course.h"

#include "chapters/book/instead/page.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void programs_end_with_us(void)
{
}

void programs_end_as_usual_by_interrupt(void)
{
}

bool program_is_there(const char *name)
{
    return program_exists(name);
}

int program_run(char *const *words, const char *output, int seconds)
{
    char *all = NULL;
    size_t size;
    FILE *out = open_memstream(&all, &size);
    if (out == NULL)
        return 127;
    for (; *words != NULL; words++)
        fwrite(*words, strlen(*words) + 1, 1, out);
    fclose(out);
    fflush(NULL);
    int status = program_start(all, size, output, seconds);
    free(all);
    return status;
}
