// reward.c - the picture that is drawn after a chapter is right.
#include "tests/course/reward.h"

#include "tests/course/answer_pictures.h"
#include "tests/course/programs.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Of processor time.
enum { MOST_SECONDS = 20 };

// How the chapter's program draws its picture, FILE for its path, and the answers that it calls.
static const struct {
    const char *stem, *now, *picture, *drawn_by, *needs;
} rewards[] = {
    {"01-corners", "Your vectors reach all of the image plane.", "01-corners", "--picture NAME",
     "upper_left upper_right across_30_up_10 image_plane_vector"},
    {"02-cameras", "Your cameras now work in either world.", "02-cameras", "--picture NAME",
     "image_plane_vector camera_from_look_at"},
    {"03-screen", "Your pixels now know where they are.", "03-screen", "--picture NAME",
     "pixel_center screen_to_normalized"},
    {"04-pixel-ray", "Every pixel now has its ray.", "04-pixel-ray", "--picture NAME", "pixel_ray"},
    {"05-quadratic", "Your rays now meet spheres, at the right place.", "05-quadratic",
     "--picture NAME", "pixel_ray hit_sphere"},
    {"06-ray-casting", "Your rays now find what is nearest.", "three-spheres",
     "-o NAME chapters/06-ray-casting/three-spheres.nff",
     "camera_from_look_at width_from_angle pixel_ray hit_sphere nearest_hit cast_image_order"},
    {"07-shading", "Nothing is missing any more.", "still-something-missing", "-o NAME",
     "camera_from_look_at width_from_angle pixel_ray nearest_hit shade trace_ray"},
    {"08-fast", "Object order now asks only the pixels that a sphere can cover.", NULL, NULL, ""},
};
enum { REWARD_COUNT = sizeof rewards / sizeof rewards[0] };

static PlanPath picture_of(const JudgingPlan *plan, const char *name)
{
    char file[300];
    snprintf(file, sizeof file, "gallery/%s", name);
    return path_of(plan->built, file, ".png");
}

// By the chapter's program, linked with the answers as they were judged.
static bool draw(const Judging *judging, int chapter, int reward, PlanPath picture,
                 Answerers *answerers)
{
    const JudgingPlan *plan = judging->plan;
    PlanPath program = plan_file(plan, chapter, "program");
    mkdir(path_of(plan->built, "gallery", "").s, 0777);
    if (!link_with_answers(judging, chapter, plan->chapters[chapter].program, rewards[reward].needs,
                           program.s, answerers))
        return false;
    Command command = {.count = 0};
    command_add(&command, program.s);
    command_words_for(&command, rewards[reward].drawn_by, picture.s);
    bool good = program_run_for(&command, "/dev/null", MOST_SECONDS) == 0;
    command_free(&command);
    return good;
}

static int reward_of(const char *stem)
{
    int reward = 0;
    while (reward < REWARD_COUNT && strcmp(stem, rewards[reward].stem) != 0)
        reward++;
    return reward;
}

static void say_again(const Page *page, const JudgingPlan *plan)
{
    fprintf(page->out, "make exercises");
    if (strcmp(plan->answers, "exercises") != 0)
        fprintf(page->out, " ANSWERS=%s", plan->answers);
}

static void show_chapter_picture(const Page *page, const Judging *judging, int chapter, int reward)
{
    PlanPath picture = picture_of(judging->plan, rewards[reward].picture);
    Answerers by;
    if (!draw(judging, chapter, reward, picture, &by)) {
        fprintf(page->out, "  Its picture %s%s: ",
                by.missing[0] != '\0' ? "also needs " : "could not be drawn", by.missing);
        say_again(page, judging->plan);
        putc('\n', page->out);
    } else if (by.wrong[0] == '\0' && by.reference[0] == '\0') {
        fprintf(page->out, "  drawn by your own code: %s\n", picture.s);
    } else {
        say_picture(page, picture.s, "The chapter's picture.", &by, "");
    }
}

// The picture of README.md, by the programs that make builds of these answers. It takes a while, so
// make and the program show how far they are; if nobody would see that, only the command is
// printed.
static void reward_with_finale(const Page *page, const JudgingPlan *plan)
{
    PlanPath finale = path_of(plan->built, "gallery/finale", ".png");
    char answers[MOST_PLAN_PATH + 20];
    snprintf(answers, sizeof answers, "ANSWERS=%s", plan->answers);
    if (access(finale.s, F_OK) != 0) {
        fprintf(page->out,
                "The last picture is that of README.md, by your own code: make finale %s\n",
                answers);
        if (isatty(fileno(page->out)) != 1)
            return;
        const char *words[] = {"make", "--no-print-directory", "finale", answers};
        Command command = {.count = 0};
        for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
            command_add(&command, words[i]);
        program_run(&command, NULL);
        command_free(&command);
    } else {
        fprintf(page->out, "  %s\nis the picture of README.md, by your own code.\n", finale.s);
    }
}

void reward_all(const Page *page, const Judging *judging)
{
    const JudgingPlan *plan = judging->plan;
    fprintf(page->out, "All right, every chapter. You have written a ray caster.\n");
    fflush(page->out);
    const char *stem = "07-shading"; // whose picture is the deck's last slide
    int chapter = plan_chapter(plan, stem), reward = reward_of(stem);
    if (chapter >= 0 && reward < REWARD_COUNT)
        show_chapter_picture(page, judging, chapter, reward);
    fprintf(page->out, "All pictures: make ANSWERS=%s\n", plan->answers);
    reward_with_finale(page, plan);
}

void reward_chapter(const Page *page, const Judging *judging, int chapter, bool says_next)
{
    const JudgingPlan *plan = judging->plan;
    const char *stem = plan->chapters[chapter].stem;
    int reward = reward_of(stem);
    fprintf(page->out, "%s is right. %s\n", stem, reward < REWARD_COUNT ? rewards[reward].now : "");
    fflush(page->out);
    if (reward < REWARD_COUNT && rewards[reward].picture != NULL)
        show_chapter_picture(page, judging, chapter, reward);
    show_right_pictures(page, judging, chapter, says_next);
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
