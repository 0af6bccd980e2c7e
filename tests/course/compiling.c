// compiling.c - one compile of an answer, by the commands of the plan.
#include "tests/course/compiling.h"

#include "tests/course/programs.h"
#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>

static int compile(const JudgingPlan *plan, const char *object, const char *source,
                   const char *said)
{
    Command command = {.count = 0};
    command_words(&command, plan->compile);
    command_add(&command, "-o");
    command_add(&command, object);
    command_add(&command, source);
    int status = program_run(&command, said);
    command_free(&command);
    return status;
}

// The plan's words with the names in their places; a '|' between the compiler and the assembler.
static int compile_early(const JudgingPlan *plan, const char *object, const char *source,
                         const char *said)
{
    Command planned = {.count = 0}, compiler = {.count = 0}, assembler = {.count = 0};
    bool is_piped = false;
    command_words(&planned, plan->compile_early);
    for (int i = 0; i < planned.count; i++) {
        const char *word = planned.words[i];
        if (strcmp(word, "|") == 0)
            is_piped = true;
        else
            command_add(is_piped ? &assembler : &compiler, strcmp(word, "OBJECT") == 0   ? object
                                                           : strcmp(word, "SOURCE") == 0 ? source
                                                                                         : word);
    }
    int status =
        is_piped ? program_run_piped(&compiler, &assembler, said) : program_run(&compiler, said);
    command_free(&planned);
    command_free(&compiler);
    command_free(&assembler);
    return status;
}

static bool names_precompiled(const char *said)
{
    size_t size;
    char *words = whole_text(said, &size);
    bool is_named = words == NULL || strstr(words, "precompiled/") != NULL;
    free(words);
    return is_named;
}

int compile_object(const JudgingPlan *plan, int chapter, const char *source, const char *said)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    if (plan->compile_early[0] != '\0' && compile_early(plan, object.s, source, said) == 0 &&
        !names_precompiled(said))
        return 0;
    return compile(plan, object.s, source, said);
}
