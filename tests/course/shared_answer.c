// shared_answer.c - links an answer as a shared object: a third of the work of linking a program.
#include "tests/course/shared_answer.h"

#include "tests/course/object_symbols.h"
#include "tests/course/programs.h"
#include "tests/course/whole_text.h"
#include "tests/judge/exercise.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *stem;
    const char *names; // of the answering process and its libraries, a line each
    int found;         // exercises of the stem
} Fitting;

static bool is_among(const char *names, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = names; (at = strstr(at, name)) != NULL; at += length)
        if ((at == names || at[-1] == '\n') && at[length] == '\n')
            return true;
    return false;
}

// An answer may call those of its own chapter and of earlier ones.
static bool fits(const ObjectSymbol *symbol, void *given)
{
    Fitting *fitting = given;
    int number = exercise_number(symbol->name);
    int place = number < 0 ? 0 : strcmp(exercises[number].stem, fitting->stem);
    if (!symbol->is_plain)
        return false;
    if (!symbol->is_defined)
        return number >= 0 ? place <= 0 : is_among(fitting->names, symbol->name);
    fitting->found += number >= 0;
    return number >= 0 ? place == 0 && symbol->is_function
                       : !is_among(fitting->names, symbol->name);
}

static bool object_fits(const char *object, const char *stem, const char *names)
{
    Fitting fitting = {stem, names, 0};
    int wanted = 0;
    for (int i = 0; exercises[i].name != NULL; i++)
        wanted += strcmp(exercises[i].stem, stem) == 0;
    return object_symbols(object, fits, &fitting) && fitting.found == wanted;
}

// Those of the chapter and of earlier ones that are linked with it (in a handout).
static bool objects_fit(const JudgingPlan *plan, int chapter)
{
    size_t size;
    const char *stem = plan->chapters[chapter].stem;
    char *names = whole_text(path_of(plan->loading, stem, ".names").s, &size);
    bool fit = names != NULL;
    for (int i = 0; fit && i <= chapter; i++)
        if (i == chapter || plan_depends_on(plan, chapter, i))
            fit = object_fits(plan_file(plan, i, "answer.o").s, plan->chapters[i].stem, names);
    free(names);
    return fit;
}

bool shared_answer_link(const JudgingPlan *plan, int chapter, const char *program, const char *lent)
{
    PlanPath objects[MOST_CHAPTERS], shared = plan_file(plan, chapter, "answer.so");
    if (plan->shared[0] == '\0' || !objects_fit(plan, chapter))
        return false;
    Command command = {.count = 0}, names = {.count = 0};
    command_words(&names, lent);
    command_words(&command, plan->shared);
    command_add(&command, shared.s);
    for (int i = 0; i < names.count; i++)
        command_words_for(&command, plan->lend_shared, names.words[i]);
    for (int i = 0; i <= chapter; i++)
        if (i == chapter || plan_depends_on(plan, chapter, i)) {
            objects[i] = plan_file(plan, i, "answer.o");
            command_add(&command, objects[i].s);
        }
    if (names.count > 0)
        command_words(&command, plan->lent);
    bool linked = program_run(&command, "/dev/null") == 0;
    command_free(&command);
    command_free(&names);
    unlink(program);
    return linked && link(path_of(plan->loading, plan->chapters[chapter].stem, "").s, program) == 0;
}
