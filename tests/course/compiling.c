// compiling.c - one compile of an answer, by the commands of the plan.
#include "tests/course/compiling.h"

#include "tests/course/precompiled.h"
#include "tests/course/waiting_compiler.h"
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

EarlyCommands early_commands(const JudgingPlan *plan, const char *object, const char *source)
{
    EarlyCommands commands = {.planned = {.count = 0}};
    Command *command = &commands.compiler;
    command_words(&commands.planned, plan->compile_early);
    for (int i = 0; i < commands.planned.count; i++) {
        const char *word = commands.planned.words[i];
        if (strcmp(word, "|") == 0)
            command = &commands.assembler;
        else
            command_add(command, strcmp(word, "OBJECT") == 0   ? object
                                 : strcmp(word, "SOURCE") == 0 ? source
                                                               : word);
    }
    return commands;
}

void early_commands_free(EarlyCommands *commands)
{
    command_free(&commands->planned);
    command_free(&commands->compiler);
    command_free(&commands->assembler);
}

static int compile_early(const JudgingPlan *plan, const char *object, const char *source,
                         const char *said)
{
    EarlyCommands commands = early_commands(plan, object, source);
    int status = commands.assembler.count > 0
                     ? program_run_piped(&commands.compiler, &commands.assembler, said)
                     : program_run(&commands.compiler, said);
    early_commands_free(&commands);
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
    if (waiting_compiler_compiles(plan, chapter, source, said))
        return 0;
    if (plan->compile_early[0] != '\0' && precompiled_is_current(plan, chapter) &&
        compile_early(plan, object.s, source, said) == 0 && !names_precompiled(said))
        return 0;
    return compile(plan, object.s, source, said);
}
