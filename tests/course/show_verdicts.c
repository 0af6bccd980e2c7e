// show_verdicts.c - the records of the chapters, as a student reads them.
#include "tests/course/show_verdicts.h"

#include "tests/course/programs.h"
#include "tests/judge/exercise.h"
#include "tests/judge/show.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *stem;
    bool is_known; // there is a record of what is there now
    ChapterRecord record;
} Chapter;

static const Exercise *exercise_named(const char *name)
{
    const Exercise *exercise = exercises;
    while (exercise->name != NULL && strcmp(exercise->name, name) != 0)
        exercise++;
    return exercise->name != NULL ? exercise : NULL;
}

static const FunctionRecord *first_of(const ChapterRecord *record, const char *state)
{
    for (int i = 0; i < record->function_count; i++)
        if (strcmp(function_state(&record->functions[i]), state) == 0)
            return &record->functions[i];
    return NULL;
}

const FunctionRecord *function_for_debug(const ChapterRecord *record)
{
    return first_of(record, "wrong");
}

const FunctionRecord *function_for_hint(const ChapterRecord *record)
{
    const FunctionRecord *wrong = first_of(record, "wrong"),
                         *blank = first_of(record, "unanswered");
    if (wrong != NULL || blank != NULL)
        return wrong != NULL ? wrong : blank;
    const FunctionRecord *last = NULL;
    for (int i = 0; i < record->function_count; i++)
        if (strcmp(function_state(&record->functions[i]), "right") != 0)
            last = &record->functions[i];
    return last;
}

// ---- what needs work --------------------------------------------------------------------------

static void show_lines(const Page *page, const char *text)
{
    enum { MOST_LINES = 40 };
    char *copy = strdup(text);
    int count = 0;
    for (char *rest = copy, *line;
         rest != NULL && count < MOST_LINES && (line = strsep(&rest, "\n")) != NULL; count++)
        if (rest != NULL || line[0] != '\0')
            page_line(page, strncmp(line, "  help:", 7) == 0 ? YELLOW : PLAIN, line);
    free(copy);
}

static void show_header(const Page *page, const Exercise *exercise, const char *state)
{
    char line[400], slide[400];
    int column = snprintf(line, sizeof line, "%s  %s%s", exercise->stem, exercise->name, state);
    int length = snprintf(slide, sizeof slide, "slide: %s", exercise->slide);
    int room = page->columns - column;
    if (room >= length && column + length < (int)sizeof line)
        snprintf(line + column, sizeof line - (size_t)column, "%*s", room, slide);
    page_line(page, BOLD, line);
}

// A sentence goes on after the colon: no capital, except for a letter that is a name.
static void show_mistake(const Page *page, const char *label, const char *formula, const char *why,
                         const char *besides)
{
    char words[2000];
    bool is_word = islower((unsigned char)why[1]) || strncmp(why, "A ", 2) == 0;
    snprintf(words, sizeof words, "%s: %c%s%s", formula[0] != '\0' ? formula : "a known mistake",
             is_word ? tolower((unsigned char)why[0]) : why[0], why + 1, besides);
    page_field(page, YELLOW, label, words);
}

static void show_diagnosis(const Page *page, const FunctionRecord *function)
{
    const char *why = function_value(function, "why"), *also = function_value(function, "also why");
    bool in_part = function_value(function, "partly")[0] != '\0';
    if (why[0] != '\0') { // a handout's mistakes have no names

        show_mistake(page, "looks like", function_value(function, "formula"), why,
                     in_part ? " (Something else is also not right yet.)" : "");
        page_field(page, PLAIN, "you'd see", function_value(function, "picture"));
        if (also[0] != '\0')
            show_mistake(page, "and also", function_value(function, "also formula"), also, "");
    } else if (function_value(function, "law")[0] != '\0') {
        page_field(page, YELLOW, "but", function_value(function, "law"));
    }
}

// If the judge has left one: a picture, or the script of a figure, which is drawn afterwards.
static void show_figure(const Page *page, const JudgingPlan *plan, const char *name,
                        ShownFigures *shown)
{
    static int has_gnuplot = -1;
    PlanPath picture = path_of(plan->figures, name, ".png"),
             script = path_of(plan->figures, name, ".gp");
    if (access(picture.s, F_OK) == 0) {
        page_field(page, PLAIN, "see", picture.s);
        return;
    }
    if (has_gnuplot < 0)
        has_gnuplot = program_is_there("gnuplot");
    if (has_gnuplot && access(script.s, F_OK) == 0) {
        page_field(page, PLAIN, "see", path_of(plan->figures, name, ".svg").s);
        if (shown->count < MOST_SHOWN && strlen(name) < sizeof shown->names[0])
            strcpy(shown->names[shown->count++], name);
    }
}

static void show_function(const Page *page, const JudgingPlan *plan, const Chapter *chapter,
                          const FunctionRecord *function, ShownFigures *shown)
{
    const Exercise *exercise = exercise_named(function->name);
    const char *state = function_value(function, "state");
    bool unanswered = strcmp(state, "unanswered") == 0;
    bool has_ended = strcmp(state, "crashed") == 0 || strcmp(state, "timed out") == 0;
    if (exercise == NULL)
        return;
    show_header(page, exercise, unanswered ? "  is not answered yet" : "");
    if (unanswered) {
        page_field(page, PLAIN, "asked", exercise->prompt);
    } else {
        char *sentence = strdup(function_value(function, "test"));
        for (char *c = sentence; c != NULL && *c != '\0'; c++)
            *c = *c == '_' ? ' ' : *c;
        page_words(page, PLAIN, 2, 2, sentence != NULL ? sentence : "");
        free(sentence);
    }
    show_call(page, &(ShownCall){
                        .hidden = function_value(function, "hidden")[0] != '\0',
                        .given = function_value(function, "given"),
                        .expected = function_value(function, "expected"),
                        .yours = function_value(function, "yours"),
                        .missing = function_value(function, "missing"),
                        .how = function_value(function, "how"),
                        .printed = function_value(function, "printed"),
                    });
    if (function_value(function, "comma")[0] == '\0')
        show_diagnosis(page, function);
    for (int i = 0; i < function->count; i++)
        if (strcmp(function->entries[i].key, "help") == 0) {
            char words[1000];
            snprintf(words, sizeof words, "help: %s", function->entries[i].value);
            page_words(page, YELLOW, 2, 8, words);
        }
    show_figure(page, plan, function->name, shown);
    char what[100];
    snprintf(what, sizeof what, "make %s EX=%.2s", has_ended ? "debug" : "hint", chapter->stem);
    page_field(page, PLAIN, "try", what);
    show_lines(page, record_value(&chapter->record, "warnings"));
    page_line(page, PLAIN, "");
}

static void show_troubles(const Page *page, const JudgingPlan *plan, const Chapter *chapter,
                          bool all, ShownFigures *shown)
{
    const char *state = chapter->is_known ? record_state(&chapter->record) : "stopped";
    const char *what = strcmp(state, "compiler") == 0  ? "does not compile:"
                       : strcmp(state, "linker") == 0  ? "cannot be linked:"
                       : strcmp(state, "stopped") == 0 ? "could not be judged:"
                                                       : NULL;
    if (what != NULL) {
        char line[200];
        snprintf(line, sizeof line, "%s  %s", chapter->stem, what);
        page_line(page, BOLD, line);
        show_lines(page, record_value(&chapter->record, "words"));
        page_line(page, PLAIN, "");
        return;
    }
    const char *states[] = {"wrong", "unanswered"};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < chapter->record.function_count; i++) {
            const FunctionRecord *function = &chapter->record.functions[i];
            if (strcmp(function_state(function), states[s]) != 0)
                continue;
            show_function(page, plan, chapter, function, shown);
            if (!all)
                return;
        }
}

// ---- how far ----------------------------------------------------------------------------------

static void show_names(const Page *page, const char *label, const char *names)
{
    char line[8000];
    if (names[0] == '\0')
        return;
    snprintf(line, sizeof line, "%s: %s", label, names);
    page_words(page, PLAIN, 20, 21, line);
}

static void append(char *list, size_t size, const char *separator, const char *format,
                   const char *a, const char *b)
{
    size_t length = strlen(list);
    length += (size_t)snprintf(list + length, size - length, "%s", length > 0 ? separator : "");
    if (length < size)
        snprintf(list + length, size - length, format, a, b);
}

// a b c -> a, b, c
static void put_commas(char *list, size_t size, const char *names)
{
    size_t length = 0;
    for (const char *c = names + strspn(names, " "); *c != '\0' && length + 3 < size; c++) {
        if (*c == ' ')
            list[length++] = ',';
        list[length++] = *c;
    }
    list[length] = '\0';
}

// NAME, NAME (for OTHER, OTHER), ...
static void show_those(const Page *page, const Chapter *chapter, const char *label,
                       const char *state)
{
    char list[6000] = "";
    for (int i = 0; i < chapter->record.function_count; i++) {
        const FunctionRecord *function = &chapter->record.functions[i];
        char others[2000];
        if (strcmp(function_state(function), state) != 0)
            continue;
        put_commas(others, sizeof others, function_because(function));
        const char *format = strcmp(state, "waiting") == 0  ? "%s (for %s)"
                             : strcmp(state, "unsure") == 0 ? "%s (it calls %s)"
                                                            : "%s%s";
        append(list, sizeof list, ", ", format, function->name, others);
    }
    show_names(page, label, list);
}

// The answers of earlier chapters that these call and that are not right. Stores the first of those
// chapters.
static void show_dependencies(const Page *page, const Chapter *chapter, char first[64])
{
    first[0] = '\0';
    for (int i = 0; i < chapter->record.head; i++) {
        const Entry *entry = &chapter->record.all.entries[i];
        if (strcmp(entry->key, "stands") != 0)
            continue;
        char stem[64], label[200], names[4000];
        int length = (int)strcspn(entry->value, " ");
        snprintf(stem, sizeof stem, "%.*s", length, entry->value);
        put_commas(names, sizeof names, entry->value + length);
        snprintf(label, sizeof label, "depends on your %s, which is not right yet", stem);
        show_names(page, label, names);
        if (first[0] == '\0')
            strcpy(first, stem);
    }
}

static void show_progress(const Page *page, const Chapter *chapter, bool is_next,
                          char stands_on[64])
{
    const char *state = chapter->is_known ? record_state(&chapter->record) : "stopped";
    char counted[40], line[200];
    int right = 0;
    for (int i = 0; i < chapter->record.function_count; i++)
        right += strcmp(function_state(&chapter->record.functions[i]), "right") == 0;
    snprintf(counted, sizeof counted, "%d of %d", right, chapter->record.function_count);
    const char *words = strcmp(state, "compiler") == 0  ? "does not compile"
                        : strcmp(state, "linker") == 0  ? "cannot be linked"
                        : strcmp(state, "stopped") == 0 ? "could not be judged"
                        : strcmp(state, "right") == 0   ? "done"
                        : strcmp(state, "blank") == 0   ? "not yet"
                                                        : counted;
    snprintf(line, sizeof line, "  %-16s %s%s", chapter->stem, words, is_next ? "   <- next" : "");
    page_line(page, PLAIN, line);
    if (is_next) {
        show_those(page, chapter, "wrong", "wrong");
        show_those(page, chapter, "waiting", "waiting");
        show_those(page, chapter, "cannot be judged yet", "unsure");
        show_dependencies(page, chapter, stands_on);
        show_those(page, chapter, "not answered yet", "unanswered");
    }
    char extra[2000] = "", all[2400];
    for (int i = 0; i < chapter->record.function_count; i++)
        if (strcmp(function_value(&chapter->record.functions[i], "extra"), "wrong") == 0)
            append(extra, sizeof extra, ", ", "%s%s", chapter->record.functions[i].name, "");
    if (strcmp(state, "right") == 0 && extra[0] != '\0') {
        snprintf(all, sizeof all, "more digits in %s, see 'Losing digits' in chapters/%s/README.md",
                 extra, chapter->stem);
        show_names(page, "extra, no marks", all);
    }
}

Progress progress_so_far(const JudgingPlan *plan)
{
    Progress progress = {0, 0};
    for (const Exercise *e = exercises; e->name != NULL; e++)
        progress.of++;
    for (int i = 0; i < plan->count; i++) {
        ChapterRecord record;
        if (record_read(plan_beside(plan, i, ".record").s, &record))
            for (int k = 0; k < record.function_count; k++)
                progress.right += strcmp(function_state(&record.functions[k]), "right") == 0;
        chapter_record_free(&record);
    }
    return progress;
}

static void show_progress_so_far(const Page *page, const JudgingPlan *plan)
{
    Progress progress = progress_so_far(plan);
    char line[100];
    snprintf(line, sizeof line, "  %-16s %d of %d functions are right", "all chapters",
             progress.right, progress.of);
    page_line(page, PLAIN, line);
}

// Wrong comes before what is not answered yet.
static bool is_wrong(const Chapter *chapter)
{
    const char *state = chapter->is_known ? record_state(&chapter->record) : "stopped";
    return strcmp(state, "compiler") == 0 || strcmp(state, "linker") == 0 ||
           strcmp(state, "stopped") == 0 || function_for_debug(&chapter->record) != NULL;
}

static bool is_right(const Chapter *chapter)
{
    return chapter->is_known && strcmp(record_state(&chapter->record), "right") == 0;
}

Standing show_verdicts(const Page *page, const Judging *judging, const bool chosen[MOST_CHAPTERS],
                       bool all, ShownFigures *shown)
{
    static Chapter chapters[MOST_CHAPTERS];
    const JudgingPlan *plan = judging->plan;
    int count = 0;
    const Chapter *next = NULL;
    bool wrong = false;
    shown->count = 0;
    for (int i = 0; i < plan->count; i++) {
        if (!chosen[i])
            continue;
        Chapter *chapter = &chapters[count++];
        chapter->stem = plan->chapters[i].stem;
        chapter->is_known = judging_record(judging, i, &chapter->record);
        wrong = wrong || !chapter->is_known || is_wrong(chapter) ||
                strcmp(record_state(&chapter->record), "wrong") == 0;
    }
    for (int i = count - 1; i >= 0; i--)
        if (!is_right(&chapters[i]) && (is_wrong(&chapters[i]) || next == NULL || !is_wrong(next)))
            next = &chapters[i];
    for (int i = 0; i < count; i++)
        if (all ? !is_right(&chapters[i]) : &chapters[i] == next)
            show_troubles(page, plan, &chapters[i], all, shown);
    char stands_on[64] = "";
    for (int i = 0; i < count; i++)
        show_progress(page, &chapters[i], &chapters[i] == next, stands_on);
    show_progress_so_far(page, plan);
    page_line(page, PLAIN, "");
    if (next != NULL) {
        bool has_trouble = function_for_debug(&next->record) != NULL ||
                           first_of(&next->record, "unanswered") != NULL;
        const char *work = !has_trouble && stands_on[0] != '\0' ? stands_on : next->stem;
        fprintf(page->out, "Next: %s/%s.c\n      the lesson is chapters/%s/README.md\n",
                plan->answers, work, work);
    }
    bool is_done = next == NULL;
    for (int i = 0; i < count; i++)
        chapter_record_free(&chapters[i].record);
    return is_done ? ALL_RIGHT : wrong ? SOMETHING_WRONG : BLANKS_LEFT;
}
