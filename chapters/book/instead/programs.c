// programs.c - starts programs: the page does.
//
// Stands in for tests/course/programs.c.
#include "tests/course/programs.h"

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

int program_run(const Command *command, const char *output)
{
    return program_run_for(command, output, 0);
}

int program_run_for(const Command *command, const char *output, int seconds)
{
    char *words = NULL;
    size_t size;
    FILE *out = open_memstream(&words, &size);
    if (out == NULL)
        return 127;
    for (int i = 0; i < command->count; i++)
        fwrite(command->words[i], strlen(command->words[i]) + 1, 1, out);
    fclose(out);
    fflush(NULL);
    int status = program_start(words, size, output, seconds);
    free(words);
    return status;
}

void work_side_by_side(int count, int (*work)(int number, void *given), void *given, int *statuses)
{
    for (int i = 0; i < count; i++)
        statuses[i] = work(i, given);
}
