// judging_plan.c - how answers are judged: the commands and files, as make wrote them down.
#include "tests/course/judging_plan.h"

#include <string.h>
#include <unistd.h>

static bool complain(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    return false;
}

bool plan_read(const char *path, JudgingPlan *plan)
{
    *plan = (JudgingPlan){0};
    if (!entries_read(path, &plan->all))
        return complain(path, "cannot be read as a plan of judging");
    const Entry *entries = plan->all.entries;
    int head = 0;
    while (head < plan->all.count && strcmp(entries[head].key, "chapter") != 0)
        head++;
    const struct {
        const char *key, **value;
        bool needed;
    } keys[] = {
        {"answers", &plan->answers, true},
        {"built", &plan->built, true},
        {"verdict", &plan->verdict, true},
        {"figures", &plan->figures, true},
        {"draw", &plan->draw, true},
        {"blanks", &plan->blanks, true},
        {"compile", &plan->compile, true},
        {"link", &plan->link, true},
        {"compile early", &plan->compile_early, false},
        {"precompiled", &plan->precompiled, false},
        {"headers", &plan->headers, false},
        {"hide", &plan->hide, false},
        {"quick", &plan->quick, false},
        {"lend", &plan->lend, false},
        {"judge", &plan->judge, true},
        {"used", &plan->used, false},
        {"drawing", &plan->drawing, true},
        {"spheres", &plan->spheres, true},
        {"reference", &plan->reference, false},
        {"libraries", &plan->libraries, false},
        {"directly", &plan->directly, false},
        {"shared", &plan->shared, false},
        {"loading", &plan->loading, false},
        {"lend shared", &plan->lend_shared, false},
        {"lent", &plan->lent, false},
    };
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        *keys[i].value = entry_value(entries, head, keys[i].key);
        if (keys[i].needed && (*keys[i].value)[0] == '\0')
            return complain(path, keys[i].key);
    }
    for (int i = head; i < plan->all.count;) {
        int end = i + 1;
        while (end < plan->all.count && strcmp(entries[end].key, "chapter") != 0)
            end++;
        if (plan->count == MOST_CHAPTERS)
            return complain(path, "too many chapters");
        plan->chapters[plan->count++] =
            (PlannedChapter){entries[i].value, entry_value(entries + i, end - i, "objects"),
                             entry_value(entries + i, end - i, "stands on"),
                             entry_value(entries + i, end - i, "right"),
                             entry_value(entries + i, end - i, "program")};
        i = end;
    }
    return true;
}

void plan_free(JudgingPlan *plan)
{
    entries_free(&plan->all);
    *plan = (JudgingPlan){0};
}

int plan_chapter(const JudgingPlan *plan, const char *stem)
{
    for (int i = 0; i < plan->count; i++)
        if (strcmp(plan->chapters[i].stem, stem) == 0)
            return i;
    return -1;
}

bool plan_depends_on(const JudgingPlan *plan, int chapter, int other)
{
    const char *stem = plan->chapters[other].stem;
    size_t length = strlen(stem);
    for (const char *word = plan->chapters[chapter].stands_on; *word != '\0';
         word += strspn(word, " ")) {
        size_t size = strcspn(word, " ");
        if (size == length && strncmp(word, stem, length) == 0)
            return true;
        word += size;
    }
    return false;
}

PlanPath path_of(const char *folder, const char *name, const char *ending)
{
    PlanPath path;
    if (snprintf(path.s, sizeof path.s, "%s/%s%s", folder, name, ending) >= (int)sizeof path.s)
        path.s[0] = '\0'; // which cannot be opened
    return path;
}

PlanPath plan_answer(const JudgingPlan *plan, int chapter)
{
    PlanPath path = path_of(plan->answers, plan->chapters[chapter].stem, ".c");
    return access(path.s, F_OK) == 0 ? path
                                     : path_of(plan->blanks, plan->chapters[chapter].stem, ".c");
}

PlanPath plan_file(const JudgingPlan *plan, int chapter, const char *name)
{
    PlanPath folder = path_of(plan->verdict, plan->chapters[chapter].stem, "");
    return path_of(folder.s, name, "");
}

PlanPath plan_beside(const JudgingPlan *plan, int chapter, const char *ending)
{
    return path_of(plan->verdict, plan->chapters[chapter].stem, ending);
}
