// answer_pictures.c - pictures that a student's answers draw: those so far, and a chapter's own.
//
// The objects that were judged are linked with what draws: nothing is compiled again. If a function
// is not answered, or did not come back when it was judged, the linker puts the reference in its
// place; a handout has none, and does without the picture.
#include "tests/course/course.h"

#include "tests/explain/source.h"
#include "tests/judge/exercise.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Who answers the functions that a picture is drawn by: names, with a blank between them.
enum { MOST_ANSWERS = 1000 };
typedef struct {
    char yours[MOST_ANSWERS], wrong[MOST_ANSWERS]; // by the student: right, and not right yet
    char reference[MOST_ANSWERS], missing[MOST_ANSWERS];
    // All that the reference answers, and the objects with all answers.
    char lent[MOST_ANSWERS], objects[20 * MOST_ANSWERS];
} Answerers;

// Of processor time. A wrong answer may need any.
enum { MOST_SECONDS = 5 };

#define TEXT(...) #__VA_ARGS__
#define PICTURE(name, function, shows, given, ...)                                                 \
    {name, #function, shows, given, TEXT(__VA_ARGS__)},
static const struct AnswerPicture {
    const char *name, *function, *shows, *given, *color;
} pictures[] = {
#include "tests/course/pictures/pictures.def"
};
typedef struct AnswerPicture AnswerPicture;
enum { PICTURE_COUNT = sizeof pictures / sizeof pictures[0] };

// Whether the picture is drawn by this exercise: it is a word of the expression for the color.
static bool needs_answer(const AnswerPicture *picture, const char *exercise)
{
    return text_word(picture->color, exercise) != NULL;
}

// One that only waits for another is right by itself, if the reference has shown that.
static bool is_right(const JudgingPlan *plan, const char *state)
{
    return strcmp(state, "right") == 0 || (plan->lend[0] != '\0' && strcmp(state, "waiting") == 0);
}

// NULL: it is not answered, or did not come back.
static const char *usable_state(const ChapterRecord *record, const char *name)
{
    const FunctionRecord *function = record_function(record, name);
    const char *state = function != NULL ? function_value(function, "state") : "unanswered";
    for (const char *const *word =
             (const char *const[]){"unanswered", "crashed", "timed out", NULL};
         *word != NULL; word++)
        if (strcmp(state, *word) == 0)
            return NULL;
    return function_state(function);
}

// Whose answers of a chapter there are.
static void choose_answers(const JudgingPlan *plan, int chapter, const char *needs,
                           Answerers *answerers)
{
    PlanPath object = plan_file(plan, chapter, "answer.o");
    ChapterRecord record;
    bool there = judging_record(plan, chapter, &record) && access(object.s, F_OK) == 0 &&
                 record.function_count > 0;
    bool has_reference = plan->reference[0] != '\0';
    if (there)
        names_add(answerers->objects, sizeof answerers->objects, object.s);
    for (const Exercise *e = exercises; e->name != NULL; e++) {
        if (strcmp(e->stem, plan->chapters[chapter].stem) != 0)
            continue;
        const char *state = there ? usable_state(&record, e->name) : NULL;
        char *list = state == NULL && !has_reference ? answerers->missing
                     : state == NULL                 ? answerers->reference
                     : is_right(plan, state)         ? answerers->yours
                                                     : answerers->wrong;
        if (names_include(needs, e->name))
            names_add(list, MOST_ANSWERS, e->name);
        if (state != NULL || !has_reference)
            continue;
        names_add(answerers->lent, sizeof answerers->lent, e->name);
        names_add(answerers->objects, sizeof answerers->objects, plan->chapters[chapter].right);
    }
    chapter_record_free(&record);
}

// Who answers those that matter, of a chapter and of those before it.
static Answerers answerers_of(const JudgingPlan *plan, int chapter, const char *needs)
{
    Answerers answerers = {.yours = ""};
    for (int i = chapter; i >= 0; i--)
        choose_answers(plan, i, needs, &answerers);
    return answerers;
}

// Links objects with the answers of a chapter and of those before: the student's, if they are
// judged; the reference's for the others, if there is one. needs: the functions that matter. False
// if one of them is missing, or the linker fails.
static bool link_with_answers(const JudgingPlan *plan, int chapter, const char *objects,
                              const char *needs, const char *program, Answerers *answerers)
{
    *answerers = answerers_of(plan, chapter, needs);
    if (answerers->missing[0] != '\0')
        return false;
    char *options = options_for(plan->reference, answerers->lent);
    int status = run_line("/dev/null", 0, "%s -o %s %s %s %s %s -lm", plan->link, program, options,
                          answerers->objects, objects, plan->libraries);
    free(options);
    return status == 0;
}

// ---- the pictures so far -----------------------------------------------------------------------

static bool draw(const JudgingPlan *plan, const char *program, const char *name,
                 const char *picture)
{
    mkdir(path_of(plan->built, "so-far", "").s, 0777);
    return run_line("/dev/null", MOST_SECONDS, "%s %s %s %s", program, plan->spheres, name,
                    picture) == 0;
}

// LABEL: NAME, NAME.
static void say_names(char *text, size_t size, const char *label, const char *names)
{
    char list[MOST_ANSWERS];
    size_t length = strlen(text);
    put_names(list, sizeof list, names);
    if (names[0] != '\0')
        snprintf(text + length, size - length, " %s: %s.", label, list);
}

// Says where a picture is, what it shows, who answered, and what is nobody's answer.
static void say_picture(const Page *page, const char *path, const char *shows, const Answerers *by,
                        const char *given)
{
    static char said[MOST_PLAN_PATH];
    char words[4000];
    if (page->is_brief && strcmp(said, path) == 0)
        return;
    snprintf(said, sizeof said, "%s", path);
    snprintf(words, sizeof words, "%s", shows);
    say_names(words, sizeof words, "Yours", by->yours);
    say_names(words, sizeof words, "Yours, not right yet", by->wrong);
    say_names(words, sizeof words, "By the reference", by->reference);
    size_t length = strlen(words);
    if (given[0] != '\0')
        snprintf(words + length, sizeof words - length, " %s", given);
    page_part(page, "picture", path, words);
    page_terminal(page, "  %-*s%s\n", PAGE_LABEL - 2, "picture", path);
    if (page->is_brief || page->is_web)
        return;
    page_words(page, PLAIN, PAGE_LABEL, PAGE_LABEL, "%s", words);
}

static bool show_picture(const Page *page, const JudgingPlan *plan, int chapter,
                         const AnswerPicture *picture, bool begins)
{
    char file[200], needs[MOST_ANSWERS] = "";
    snprintf(file, sizeof file, "so-far/%s", picture->name);
    for (const Exercise *e = exercises; e->name != NULL; e++)
        if (needs_answer(picture, e->name))
            names_add(needs, sizeof needs, e->name);
    PlanPath path = path_of(plan->built, file, ".png"),
             program = plan_file(plan, chapter, "picture");
    Answerers by;
    if (!link_with_answers(plan, chapter, plan->drawing, needs, program.s, &by) ||
        !draw(plan, program.s, picture->name, path.s))
        return false;
    if (begins && !page->is_brief)
        page_terminal(page, "\n");
    say_picture(page, path.s, picture->shows, &by, picture->given);
    return true;
}

// One picture shows what is wrong: that of the function, or one that needs it.
static const AnswerPicture *picture_of_wrong(const char *name)
{
    for (int i = 0; i < PICTURE_COUNT; i++)
        if (strcmp(pictures[i].function, name) == 0)
            return &pictures[i];
    for (int i = 0; i < PICTURE_COUNT; i++)
        if (needs_answer(&pictures[i], name))
            return &pictures[i];
    return NULL;
}

void set_mark(const char *path)
{
    FILE *file = fopen(path, "w");
    if (file != NULL)
        fclose(file);
}

void show_answer_pictures(const Page *page, const JudgingPlan *plan, int chapter, bool again)
{
    ChapterRecord record;
    judging_record(plan, chapter, &record);
    bool is_done = strcmp(record_state(&record), "right") == 0;
    bool begins = !is_done; // with an empty line
    const AnswerPicture *wrong = NULL;
    for (int i = 0; i < record.function_count && wrong == NULL; i++)
        if (function_is(&record.functions[i], "wrong") &&
            usable_state(&record, record.functions[i].name) != NULL)
            wrong = picture_of_wrong(record.functions[i].name);
    for (int i = 0, news = 0; i < PICTURE_COUNT; i++) {
        // On a brief page the last of those that have become right is enough.
        const AnswerPicture *picture = &pictures[page->is_brief ? PICTURE_COUNT - 1 - i : i];
        const FunctionRecord *function = record_function(&record, picture->function);
        PlanPath mark = path_of(plan->verdict.s, picture->name, ".drawn");
        if (function == NULL)
            continue;
        bool right = is_right(plan, function_state(function));
        if (!right)
            unlink(mark.s);
        // In the later chapters the chapter's own picture shows all of it.
        bool is_news = right && (again || access(mark.s, F_OK) != 0) &&
                       (!is_done || picture->given[0] != '\0');
        bool is_left_out = page->is_brief && picture != wrong && news > 0;
        news += is_news;
        bool shown = (picture == wrong || is_news) && !is_left_out &&
                     show_picture(page, plan, chapter, picture, begins);
        begins = begins && !shown;
        if (right && (shown || is_left_out || is_done))
            set_mark(mark.s);
    }
    chapter_record_free(&record);
}

// ---- the picture that is drawn after a chapter is right ----------------------------------------

// Of processor time.
enum { MOST_SECONDS_OF_CHAPTER = 20 };

// How the chapter's program draws its picture, and the answers that it calls. picture: NULL, it has
// none.
typedef struct {
    const char *stem, *now, *picture, *option, *scene, *needs;
} Reward;
static const Reward rewards[] = {
    {"01-corners", "Your vectors reach all of the image plane.", "01-corners", "--picture", "",
     "upper_left upper_right across_30_up_10 image_plane_vector"},
    {"02-cameras", "Your cameras now work in either world.", "02-cameras", "--picture", "",
     "image_plane_vector camera_from_look_at"},
    {"03-screen", "Your pixels now know where they are.", "03-screen", "--picture", "",
     "pixel_center screen_to_normalized"},
    {"04-pixel-ray", "Every pixel now has its ray.", "04-pixel-ray", "--picture", "", "pixel_ray"},
    {"05-quadratic", "Your rays now meet spheres, at the right place.", "05-quadratic", "--picture",
     "", "pixel_ray hit_sphere"},
    {"06-ray-casting", "Your rays now find what is nearest.", "three-spheres", "-o",
     "chapters/06-ray-casting/three-spheres.nff",
     "camera_from_look_at width_from_angle pixel_ray hit_sphere nearest_hit cast_image_order"},
    {"07-shading", "Nothing is missing any more.", "still-something-missing", "-o", "",
     "camera_from_look_at width_from_angle pixel_ray nearest_hit shade trace_ray"},
    {"08-fast", "Object order now asks only the pixels that a sphere can cover.", NULL, "", "", ""},
    {NULL, "", NULL, "", "", ""}, // any other chapter
};

static PlanPath picture_of(const JudgingPlan *plan, const char *name)
{
    char file[300];
    snprintf(file, sizeof file, "gallery/%s", name);
    return path_of(plan->built, file, ".png");
}

// By the chapter's program, linked with the answers as they were judged.
static bool draw_chapter(const JudgingPlan *plan, int chapter, const Reward *reward,
                         PlanPath picture, Answerers *answerers)
{
    PlanPath program = plan_file(plan, chapter, "program");
    mkdir(path_of(plan->built, "gallery", "").s, 0777);
    if (!link_with_answers(plan, chapter, plan->chapters[chapter].program, reward->needs, program.s,
                           answerers))
        return false;
    return run_line("/dev/null", MOST_SECONDS_OF_CHAPTER, "%s %s %s %s", program.s, reward->option,
                    picture.s, reward->scene) == 0;
}

static const Reward *reward_of(const JudgingPlan *plan, int chapter)
{
    const Reward *reward = rewards;
    while (reward->stem != NULL && strcmp(plan->chapters[chapter].stem, reward->stem) != 0)
        reward++;
    return reward;
}

static void say_again(const Page *page, const JudgingPlan *plan)
{
    page_terminal(page, "make exercises");
    if (strcmp(plan->answers, "exercises") != 0)
        page_terminal(page, " ANSWERS=%s", plan->answers);
}

static void show_chapter_picture(const Page *page, const JudgingPlan *plan, int chapter)
{
    const Reward *reward = reward_of(plan, chapter);
    if (reward->picture == NULL)
        return;
    PlanPath picture = picture_of(plan, reward->picture);
    Answerers by;
    if (!draw_chapter(plan, chapter, reward, picture, &by)) {
        if (by.missing[0] == '\0') {
            page_part(page, "words", "", "Its picture could not be drawn.");
            page_terminal(page, "  Its picture could not be drawn: make ANSWERS=%s says why\n",
                          plan->answers);
            return;
        }
        page_part(page, "field", "Its picture also needs", by.missing);
        page_terminal(page, "  Its picture also needs %s: ", by.missing);
        say_again(page, plan);
        page_terminal(page, "\n");
    } else if (by.wrong[0] == '\0' && by.reference[0] == '\0') {
        page_part(page, "picture", picture.s, "Drawn by your own code.");
        page_terminal(page, "  drawn by your own code: %s\n", picture.s);
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
        run_line(NULL, 0, "make --no-print-directory finale %s", answers);
    } else {
        fprintf(page->out, "  %s\nis the picture of README.md, by your own code.\n", finale.s);
    }
}

void reward_all(const Page *page, const JudgingPlan *plan)
{
    fprintf(page->out, "All right, every chapter. You have written a ray caster.\n");
    fflush(page->out);
    int chapter = plan_chapter(plan, "07-shading"); // whose picture is the deck's last slide
    if (chapter >= 0)
        show_chapter_picture(page, plan, chapter);
    fprintf(page->out, "All pictures: make ANSWERS=%s\n", plan->answers);
    reward_with_finale(page, plan);
}

void reward_line(const Page *page, const JudgingPlan *plan, int chapter)
{
    const char *stem = plan->chapters[chapter].stem;
    const Reward *reward = reward_of(plan, chapter);
    if (reward->picture == NULL) {
        fprintf(page->out, "%s is right.\n", stem);
        return;
    }
    Answerers by = answerers_of(plan, chapter, reward->needs);
    if (by.missing[0] != '\0')
        fprintf(page->out, "%s is right. Its picture also needs %s.\n", stem, by.missing);
    else
        fprintf(page->out, "%s is right: %s\n", stem, picture_of(plan, reward->picture).s);
}

void reward_draw(const Page *page, const JudgingPlan *plan, int chapter)
{
    const Reward *reward = reward_of(plan, chapter);
    Answerers by;
    if (reward->picture != NULL) {
        PlanPath picture = picture_of(plan, reward->picture);
        if (!draw_chapter(plan, chapter, reward, picture, &by) && by.missing[0] == '\0')
            fprintf(page->out, "%s could not be drawn: make ANSWERS=%s says why\n", picture.s,
                    plan->answers);
    }
    show_answer_pictures(page, plan, chapter, false);
}

void reward_chapter(const Page *page, const JudgingPlan *plan, int chapter)
{
    const char *now = reward_of(plan, chapter)->now;
    char words[300];
    snprintf(words, sizeof words, "%s is right. %s", plan->chapters[chapter].stem, now);
    page_part(page, "right", plan->chapters[chapter].stem, words);
    page_line(page, PLAIN, "%s", words);
    fflush(page->out);
    show_chapter_picture(page, plan, chapter);
    show_answer_pictures(page, plan, chapter, true);
    if (chapter + 1 < plan->count) {
        const char *next = plan->chapters[chapter + 1].stem;
        page_terminal(page, "Next: chapters/%s/README.md\n      and then ", next);
        say_again(page, plan);
        page_terminal(page, " EX=%.2s\n", next);
    } else {
        page_terminal(page, "Next: ");
        say_again(page, plan);
        page_terminal(page, ", to see that every chapter is.\n");
    }
}
