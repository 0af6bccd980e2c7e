// precompiled.c - the contracts that make has precompiled, and whether they are still the
// contracts.
#include "tests/course/precompiled.h"

#include "tests/course/programs.h"
#include "tests/course/whole_text.h"

#include <sys/stat.h>

typedef struct {
    struct timespec written; // the last of them
    uint64_t state;
} Files;

static bool is_later(struct timespec a, struct timespec b)
{
    return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
}

static void look_at(Files *files, const char *path)
{
    struct stat found;
    if (stat(path, &found) != 0)
        return;
    files->state = hash_bytes(files->state, &found.st_ino, sizeof found.st_ino);
    files->state = hash_bytes(files->state, &found.st_size, sizeof found.st_size);
    files->state = hash_bytes(files->state, &found.st_mtim, sizeof found.st_mtim);
    if (is_later(found.st_mtim, files->written))
        files->written = found.st_mtim;
}

static PlanPath precompiled(const JudgingPlan *plan, int chapter)
{
    PlanPath folder = path_of(plan->precompiled, "exercises", "");
    return path_of(folder.s, plan->chapters[chapter].stem, ".h.gch");
}

static void look_at_headers(Files *files, const JudgingPlan *plan, int chapter)
{
    Command headers = {.count = 0};
    command_words(&headers, plan->headers);
    for (int i = 0; i < headers.count; i++)
        look_at(files, headers.words[i]);
    command_free(&headers);
    look_at(files, path_of("exercises", plan->chapters[chapter].stem, ".h").s);
}

bool precompiled_is_current(const JudgingPlan *plan, int chapter)
{
    Files headers = {.state = HASH_BEGIN}, copy = {.state = HASH_BEGIN};
    look_at_headers(&headers, plan, chapter);
    look_at(&copy, precompiled(plan, chapter).s);
    bool is_there = copy.state != HASH_BEGIN;
    return !is_there || !is_later(headers.written, copy.written);
}

uint64_t precompiled_state(const JudgingPlan *plan, int chapter)
{
    Files all = {.state = HASH_BEGIN};
    look_at_headers(&all, plan, chapter);
    look_at(&all, precompiled(plan, chapter).s);
    look_at(&all, precompiled_source(plan, chapter).s);
    return all.state;
}

PlanPath precompiled_source(const JudgingPlan *plan, int chapter)
{
    return path_of(plan->precompiled, plan->chapters[chapter].stem, ".c");
}
