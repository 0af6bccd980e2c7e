// linking.c - one link of objects with answers, by the commands of the plan.
#include "tests/course/linking.h"

#include <stdlib.h>
#include <string.h>

Linking linking_begin(const JudgingPlan *plan, LinkedBy by, const char *program)
{
    Linking linking = {.by = plan->directly[0] != '\0' || by != LINK_DIRECTLY ? by : LINK_QUICKLY};
    if (linking.by == LINK_DIRECTLY) {
        char *words = strdup(plan->directly);
        char *objects = words != NULL ? strstr(words, " OBJECTS") : NULL;
        if (objects == NULL)
            abort();
        linking.rest = strdup(objects + strlen(" OBJECTS"));
        *objects = '\0';
        command_words_for(&linking.command, words, program);
        free(words);
        return linking;
    }
    command_words(&linking.command, plan->link);
    if (linking.by == LINK_QUICKLY)
        command_words(&linking.command, plan->quick);
    command_add(&linking.command, "-o");
    command_add(&linking.command, program);
    return linking;
}

void linking_add(Linking *linking, const char *objects)
{
    command_words(&linking->command, objects);
}

void linking_tell(Linking *linking, const char *option, const char *name)
{
    static const char through_cc[] = "-Wl,";
    bool through = strncmp(option, through_cc, strlen(through_cc)) == 0;
    if (linking->by == LINK_DIRECTLY && through)
        option += strlen(through_cc);
    command_words_for(&linking->command, option, name);
}

int linking_end(Linking *linking, const char *said)
{
    if (linking->rest != NULL)
        command_words(&linking->command, linking->rest);
    int status = program_run(&linking->command, said);
    command_free(&linking->command);
    free(linking->rest);
    return status;
}
