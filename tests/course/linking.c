// linking.c - one link of objects with answers, by the commands of the plan.
#include "tests/course/linking.h"

#include <stdlib.h>
#include <string.h>

Linking linking_begin(const JudgingPlan *plan, const char *program)
{
    return (Linking){.plan = plan, .program = program};
}

void linking_add(Linking *linking, const char *objects)
{
    command_words(&linking->words, objects);
}

void linking_tell(Linking *linking, const char *option, const char *name)
{
    command_words_for(&linking->words, option, name);
}

static int link_by_cc(const Linking *linking, const char *quick, const char *said)
{
    Command command = {.count = 0};
    command_words(&command, linking->plan->link);
    command_words(&command, quick);
    command_add(&command, "-o");
    command_add(&command, linking->program);
    for (int i = 0; i < linking->words.count; i++)
        command_add(&command, linking->words.words[i]);
    command_add(&command, "-lm");
    int status = program_run(&command, said);
    command_free(&command);
    return status;
}

// The plan's words, with the objects in the place of OBJECTS.
static int link_directly(const Linking *linking, const char *said)
{
    static const char through_cc[] = "-Wl,";
    Command planned = {.count = 0}, command = {.count = 0};
    command_words_for(&planned, linking->plan->directly, linking->program);
    for (int i = 0; i < planned.count; i++) {
        bool is_place = strcmp(planned.words[i], "OBJECTS") == 0;
        if (!is_place)
            command_add(&command, planned.words[i]);
        for (int k = 0; is_place && k < linking->words.count; k++) {
            const char *word = linking->words.words[k];
            bool through = strncmp(word, through_cc, strlen(through_cc)) == 0;
            command_add(&command, through ? word + strlen(through_cc) : word);
        }
    }
    int status = program_run(&command, said);
    command_free(&command);
    command_free(&planned);
    return status;
}

int linking_end(Linking *linking, const char *said)
{
    bool direct = linking->plan->directly[0] != '\0';
    int status =
        direct ? link_directly(linking, said) : link_by_cc(linking, linking->plan->quick, said);
    if (status != 0)
        status = link_by_cc(linking, "", said);
    linking_free(linking);
    return status;
}

void linking_free(Linking *linking)
{
    command_free(&linking->words);
}
