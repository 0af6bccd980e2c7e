// reward.c - what a chapter that is right makes possible.
#include "tests/course/reward.h"

#include "tests/course/programs.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *stem, *now, *picture; // NULL: the chapter's own
} rewards[] = {
    {"01", "Your vectors reach all of the image plane.", NULL},
    {"02", "Your cameras now stand in either world.", NULL},
    {"03", "Your pixels now know where they are.", NULL},
    {"04", "Every pixel now has its ray.", NULL},
    {"05", "Your rays now meet spheres, at the right place.", NULL},
    {"06", "Your rays now find what is nearest.", "three-spheres"},
    {"", "Nothing is missing any more.", "still-something-missing"},
};

static PlanPath picture_of(const JudgingPlan *plan, const char *name)
{
    char file[300];
    snprintf(file, sizeof file, "gallery/%s", name);
    return path_of(plan->built, file, ".png");
}

// make knows how; what it would say is said below.
static bool draw(const JudgingPlan *plan, PlanPath picture)
{
    char answers[MOST_PLAN_PATH + 20];
    snprintf(answers, sizeof answers, "ANSWERS=%s", plan->answers);
    const char *words[] = {"make", "--no-print-directory", "-s", answers, "TRY=", picture.s};
    Command command = {.count = 0};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        command_add(&command, words[i]);
    bool good = program_run(&command, "/dev/null") == 0;
    command_free(&command);
    return good;
}

static void say_again(const Page *page, const JudgingPlan *plan)
{
    fprintf(page->out, "make exercises");
    if (strcmp(plan->answers, "exercises") != 0)
        fprintf(page->out, " ANSWERS=%s", plan->answers);
}

void reward_all(const Page *page, const JudgingPlan *plan)
{
    PlanPath last = picture_of(plan, "still-something-missing"),
             sunflower = picture_of(plan, "sunflower");
    fprintf(page->out, "All right, every chapter. You have written a ray caster.\n");
    fflush(page->out);
    if (draw(plan, last) && draw(plan, sunflower))
        fprintf(page->out,
                "  %s\n  %s\nwere drawn by your own code, every step from pixel to colour.\n"
                "All pictures: make ANSWERS=%s\n",
                last.s, sunflower.s, plan->answers);
}

void reward_chapter(const Page *page, const JudgingPlan *plan, int chapter, bool says_next)
{
    const char *stem = plan->chapters[chapter].stem;
    int i = 0;
    while (strncmp(stem, rewards[i].stem, strlen(rewards[i].stem)) != 0)
        i++;
    PlanPath picture = picture_of(plan, rewards[i].picture != NULL ? rewards[i].picture : stem);
    fprintf(page->out, "%s is right. %s\n", stem, rewards[i].now);
    fflush(page->out);
    if (draw(plan, picture)) {
        fprintf(page->out, "  drawn by your own code: %s\n", picture.s);
    } else {
        fprintf(page->out, "  Its picture needs answers of earlier chapters, too: ");
        say_again(page, plan);
        putc('\n', page->out);
    }
    if (!says_next)
        return;
    if (chapter + 1 < plan->count) {
        const char *next = plan->chapters[chapter + 1].stem;
        fprintf(page->out, "Next: chapters/%s/README.md\n      and then ", next);
        say_again(page, plan);
        fprintf(page->out, " EX=%.2s\n", next);
    } else {
        fprintf(page->out, "Next: ");
        say_again(page, plan);
        fprintf(page->out, ", to see that every chapter is.\n");
    }
}
