// waiting_compiler.c - compilers that have read the contracts before an answer is saved.
#include "tests/course/waiting_compiler.h"

#include "tests/course/compiling.h"
#include "tests/course/precompiled.h"
#include "tests/course/programs.h"
#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct {
    bool is_there;
    WaitingProgram program;
    uint64_t state; // of the files that it has read
} waiting[MOST_CHAPTERS];
static pid_t parent; // which has started them: only there the pipes have no other end

void compilers_wait(const JudgingPlan *plan, const bool chapters[MOST_CHAPTERS])
{
    for (int i = 0; i < plan->count; i++) {
        PlanPath source = precompiled_source(plan, i);
        if (!chapters[i] || waiting[i].is_there || access(source.s, R_OK) != 0 ||
            !precompiled_is_current(plan, i))
            continue;
        waiting[i].state = precompiled_state(plan, i);
        EarlyCommands commands = early_commands(plan, "ahead", source.s);
        waiting[i].is_there =
            commands.assembler.count > 0 &&
            program_start_waiting(&commands.compiler, plan_file(plan, i, "ahead").s,
                                  &waiting[i].program);
        early_commands_free(&commands);
    }
    parent = getpid();
}

// After blank lines and comments that are a line each. A comment that goes on is not one of those.
static bool begins_with_contract(const char *text, const char *stem)
{
    const char *at = text + strspn(text, " \t\r\n");
    for (; strncmp(at, "//", 2) == 0; at += strspn(at, " \t\r\n"))
        at += strcspn(at, "\n");
    char include[MOST_PLAN_PATH];
    int length = snprintf(include, sizeof include, "#include \"exercises/%s.h\"", stem);
    return strncmp(at, include, (size_t)length) == 0 &&
           memchr(text, '\\', (size_t)(at - text)) == NULL;
}

bool may_be_included(const char *text, const char *stem)
{
    // Pragmas, also by their operator; a comment that goes on; and names of files.
    static const char *const differ[] = {"ragma",     "?\?/",   "include_next", "assert",
                                         "__INCLUDE", "__BASE", "__FILE"};
    for (size_t i = 0; i < sizeof differ / sizeof differ[0]; i++)
        if (strstr(text, differ[i]) != NULL)
            return false;
    return begins_with_contract(text, stem);
}

static bool is_empty(const char *path)
{
    struct stat found;
    return stat(path, &found) == 0 && found.st_size == 0;
}

bool waiting_compiler_compiles(const JudgingPlan *plan, int chapter, const char *source,
                               const char *said)
{
    if (!waiting[chapter].is_there || getpid() != parent)
        return false;
    if (waiting[chapter].state != precompiled_state(plan, chapter)) {
        program_end_waiting(&waiting[chapter].program);
        waiting[chapter].is_there = false;
        return false;
    }
    size_t size;
    char *text = whole_text(source, &size), include[MOST_PLAN_PATH + 20];
    bool good = text != NULL && strlen(text) == size && strpbrk(source, "\"\\") == NULL &&
                may_be_included(text, plan->chapters[chapter].stem);
    free(text);
    if (!good)
        return false;
    PlanPath object = plan_file(plan, chapter, "answer.o");
    EarlyCommands commands = early_commands(plan, object.s, source);
    // Not the text: the compiler compares the indentation of lines that it can read again.
    snprintf(include, sizeof include, "#include \"%s\"\n", source);
    good = program_feed(&waiting[chapter].program, include, &commands.assembler, said) == 0 &&
           is_empty(said) && is_empty(plan_file(plan, chapter, "ahead").s);
    waiting[chapter].is_there = false;
    early_commands_free(&commands);
    return good;
}
