// answer_pictures.c - pictures that a student's answers draw: those so far, and a chapter's own.
//
// The objects that were judged are linked with what draws: nothing is compiled again. If a function
// is not answered, or did not come back when it was judged, the linker puts the reference in its
// place; a handout has none, and does without the picture.
#include "tests/course/answer_pictures.h"

#include "tests/course/call_graph.h"
#include "tests/course/linking.h"
#include "tests/course/programs.h"
#include "tests/judge/exercise.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Of processor time. A wrong answer may need any.
enum { MOST_SECONDS = 5 };

static const struct AnswerPicture {
    const char *name, *function, *needs, *shows, *given;
} pictures[] = {
#define PICTURE(draws, name, function, needs, shows, given) {name, function, needs, shows, given},
#include "tests/course/pictures/pictures.def"
};
typedef struct AnswerPicture AnswerPicture;
enum { PICTURE_COUNT = sizeof pictures / sizeof pictures[0] };

static void add_name(char list[MOST_ANSWERS], const char *name)
{
    size_t length = strlen(list);
    if (length + strlen(name) + 2 < MOST_ANSWERS)
        snprintf(list + length, MOST_ANSWERS - length, "%s%s", length > 0 ? " " : "", name);
}

// One that only waits for another is right by itself.
static bool is_right(const char *state)
{
    return strcmp(state, "right") == 0 || strcmp(state, "waiting") == 0;
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

// Whose answers of a chapter there are. Adds what the linker needs.
static void choose_answers(const Judging *judging, int chapter, const char *needs, Linking *linking,
                           Answerers *answerers)
{
    const JudgingPlan *plan = judging->plan;
    PlanPath object = plan_file(plan, chapter, "answer.o");
    ChapterRecord record;
    bool there = judging_record(judging, chapter, &record) && access(object.s, F_OK) == 0 &&
                 record.function_count > 0;
    bool has_reference = plan->reference[0] != '\0', uses_reference = false;
    for (const Exercise *e = exercises; e->name != NULL; e++) {
        if (strcmp(e->stem, plan->chapters[chapter].stem) != 0)
            continue;
        const char *state = there ? usable_state(&record, e->name) : NULL;
        char *list = state == NULL && !has_reference ? answerers->missing
                     : state == NULL                 ? answerers->reference
                     : is_right(state)               ? answerers->yours
                                                     : answerers->wrong;
        if (names_include(needs, e->name))
            add_name(list, e->name);
        if (state == NULL && has_reference) {
            linking_tell(linking, plan->reference, e->name);
            uses_reference = true;
        }
    }
    if (there)
        linking_add(linking, object.s);
    if (uses_reference)
        linking_add(linking, plan->chapters[chapter].right);
    chapter_record_free(&record);
}

bool link_with_answers(const Judging *judging, int chapter, const char *objects, const char *needs,
                       const char *program, Answerers *answerers)
{
    const JudgingPlan *plan = judging->plan;
    *answerers = (Answerers){.yours = ""};
    Linking linking = linking_begin(plan, program);
    for (int i = chapter; i >= 0; i--)
        choose_answers(judging, i, needs, &linking, answerers);
    if (answerers->missing[0] != '\0') {
        linking_free(&linking);
        return false;
    }
    linking_add(&linking, objects);
    linking_add(&linking, plan->libraries);
    return linking_end(&linking, "/dev/null") == 0;
}

// ---- the pictures so far ----------------------------------------------------------------------

static bool draw(const JudgingPlan *plan, const char *program, const char *name,
                 const char *picture)
{
    mkdir(path_of(plan->built, "so-far", "").s, 0777);
    Command command = {.count = 0};
    command_add(&command, program);
    command_words(&command, plan->spheres);
    command_add(&command, name);
    command_add(&command, picture);
    bool good = program_run_for(&command, "/dev/null", MOST_SECONDS) == 0;
    command_free(&command);
    return good;
}

// LABEL: NAME, NAME.
static void say_names(char *text, size_t size, const char *label, const char *names)
{
    size_t length = strlen(text);
    if (names[0] != '\0')
        length += (size_t)snprintf(text + length, size - length, " %s: ", label);
    for (const char *c = names; *c != '\0' && length + 3 < size; c++) {
        if (*c == ' ')
            text[length++] = ',';
        text[length++] = *c;
        text[length] = '\0';
    }
    if (names[0] != '\0')
        snprintf(text + length, size - length, ".");
}

void say_picture(const Page *page, const char *path, const char *shows, const Answerers *by,
                 const char *given)
{
    char words[4000];
    snprintf(words, sizeof words, "%s", shows);
    say_names(words, sizeof words, "Yours", by->yours);
    say_names(words, sizeof words, "Yours, not right yet", by->wrong);
    say_names(words, sizeof words, "By the reference", by->reference);
    size_t length = strlen(words);
    if (given[0] != '\0')
        snprintf(words + length, sizeof words - length, " %s", given);
    page_field(page, PLAIN, "picture", path);
    page_words(page, PLAIN, PAGE_LABEL, PAGE_LABEL, words);
}

static bool show_picture(const Page *page, const Judging *judging, int chapter,
                         const AnswerPicture *picture, bool begins)
{
    const JudgingPlan *plan = judging->plan;
    char file[200], needs[MOST_ANSWERS];
    snprintf(file, sizeof file, "so-far/%s", picture->name);
    snprintf(needs, sizeof needs, "%s %s", picture->function, picture->needs);
    PlanPath path = path_of(plan->built, file, ".png"),
             program = plan_file(plan, chapter, "picture");
    Answerers by;
    if (!link_with_answers(judging, chapter, plan->drawing, needs, program.s, &by) ||
        !draw(plan, program.s, picture->name, path.s))
        return false;
    if (begins)
        putc('\n', page->out);
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
        if (names_include(pictures[i].needs, name))
            return &pictures[i];
    return NULL;
}

static bool is_of(const AnswerPicture *picture, const char *stem)
{
    const Exercise *e = exercises;
    while (e->name != NULL && strcmp(e->name, picture->function) != 0)
        e++;
    return e->name != NULL && strcmp(e->stem, stem) == 0;
}

static void set_mark(const char *path)
{
    FILE *file = fopen(path, "w");
    if (file != NULL)
        fclose(file);
}

void show_answer_pictures(const Page *page, const Judging *judging, int chapter)
{
    const JudgingPlan *plan = judging->plan;
    ChapterRecord record;
    bool has_shown = false; // after an empty line
    judging_record(judging, chapter, &record);
    const AnswerPicture *wrong = NULL;
    for (int i = 0; i < record.function_count && wrong == NULL; i++)
        if (strcmp(function_state(&record.functions[i]), "wrong") == 0 &&
            usable_state(&record, record.functions[i].name) != NULL)
            wrong = picture_of_wrong(record.functions[i].name);
    for (int i = 0; i < PICTURE_COUNT; i++) {
        const AnswerPicture *picture = &pictures[i];
        const FunctionRecord *function = record_function(&record, picture->function);
        PlanPath mark = path_of(plan->verdict, picture->name, ".drawn");
        if (function == NULL)
            continue;
        bool right = is_right(function_state(function));
        if (!right)
            unlink(mark.s);
        if (picture != wrong && !(right && access(mark.s, F_OK) != 0))
            continue;
        bool shown = show_picture(page, judging, chapter, picture, !has_shown);
        has_shown = has_shown || shown;
        if (right && shown)
            set_mark(mark.s);
    }
    chapter_record_free(&record);
}

void show_right_pictures(const Page *page, const Judging *judging, int chapter, bool again)
{
    const JudgingPlan *plan = judging->plan;
    for (int i = 0; i < PICTURE_COUNT; i++) {
        const AnswerPicture *picture = &pictures[i];
        PlanPath mark = path_of(plan->verdict, picture->name, ".drawn");
        bool is_early = picture->given[0] != '\0';
        if (!is_of(picture, plan->chapters[chapter].stem))
            continue;
        // In the later chapters the chapter's own picture shows all of it.
        if (is_early && (again || access(mark.s, F_OK) != 0))
            show_picture(page, judging, chapter, picture, false);
        set_mark(mark.s);
    }
}
