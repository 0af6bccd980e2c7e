// show_verdicts.c - the records of the chapters, as a student reads them.
#include "tests/course/course.h"

#include "common/text.h"
#include "tests/judge/exercise.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    const char *stem;
    bool is_known; // there is a record of what is there now
    MissingAnswer missing;
    ChapterRecord record;
} Chapter;

TestSentence test_sentence(const FunctionRecord *function)
{
    TestSentence sentence;
    snprintf(sentence.s, sizeof sentence.s, "%s", function_value(function, "test"));
    for (char *c = sentence.s; *c != '\0'; c++)
        *c = *c == '_' ? ' ' : *c;
    return sentence;
}

const FunctionRecord *function_for_hint(const ChapterRecord *record)
{
    const FunctionRecord *wrong = first_that_is(record, "wrong"),
                         *blank = first_that_is(record, "unanswered");
    if (wrong != NULL || blank != NULL)
        return wrong != NULL ? wrong : blank;
    const FunctionRecord *last = NULL;
    for (int i = 0; i < record->function_count; i++)
        if (!function_is(&record->functions[i], "right"))
            last = &record->functions[i];
    return last;
}

// ---- what needs work ---------------------------------------------------------------------------

static void show_lines(const Page *page, const char *text)
{
    enum { MOST_LINES = 40 };
    if (text[0] != '\0')
        page_part(page, "compiler", "", text);
    char *copy = strdup(text);
    int count = 0;
    for (char *rest = copy, *line;
         rest != NULL && count < MOST_LINES && (line = strsep(&rest, "\n")) != NULL; count++)
        if (rest != NULL || line[0] != '\0')
            page_line(page, strncmp(line, "  help:", 7) == 0 ? YELLOW : PLAIN, "%s", line);
    free(copy);
}

static void show_header(const Page *page, const Exercise *exercise, const char *state)
{
    page_part(page, "function", exercise->name, "");
    Text line = text_of("%s  %s%s", exercise->stem, exercise->name, state),
         slide = text_of("slide: %s", exercise->slide);
    int room = page->columns - (int)strlen(line.s);
    bool fits = room > (int)strlen(slide.s);
    page_line(page, BOLD, "%s%*s", line.s, fits ? room : 0, fits ? slide.s : "");
}

// A sentence goes on after the colon: no capital, except for a letter that is a name.
static void show_mistake(const Page *page, const char *label, const char *formula, const char *why,
                         const char *besides)
{
    char words[2000];
    snprintf(words, sizeof words, "%s%s", why, besides);
    page_part(page, label, formula, words);
    bool is_word = islower((unsigned char)why[1]) || strncmp(why, "A ", 2) == 0;
    snprintf(words, sizeof words, "%s: %c%s%s", formula[0] != '\0' ? formula : "a known mistake",
             is_word ? tolower((unsigned char)why[0]) : why[0], why + 1, besides);
    if (!page->is_web)
        page_field(page, YELLOW, label, words);
}

static void show_diagnosis(const Page *page, const FunctionRecord *function)
{
    const char *why = function_value(function, "why"), *also = function_value(function, "also why");
    bool in_part = function_value(function, "partly")[0] != '\0';
    if (why[0] != '\0') {
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
    PlanPath picture = path_of(plan->figures.s, name, ".png"),
             script = path_of(plan->figures.s, name, ".gp");
    if (access(picture.s, F_OK) == 0) {
        page_part(page, "picture", picture.s, "");
        page_terminal(page, "  %-*s%s\n", PAGE_LABEL - 2, "see", picture.s);
        return;
    }
    if (has_gnuplot < 0)
        has_gnuplot = program_is_there("gnuplot");
    if (has_gnuplot && access(script.s, F_OK) == 0) {
        page_part(page, "figure", script.s, "");
        page_terminal(page, "  %-*s%s\n", PAGE_LABEL - 2, "see",
                      path_of(plan->figures.s, name, ".svg").s);
        if (shown->count < MOST_SHOWN && strlen(name) < sizeof shown->names[0])
            strcpy(shown->names[shown->count++], name);
    }
}

static bool is_blank(const Chapter *chapter)
{
    return chapter->is_known && strcmp(record_state(&chapter->record), "blank") == 0;
}

// Then the blank is judged. In another folder than exercises/ that may be intended.
static bool is_lost(const JudgingPlan *plan, const Chapter *chapter)
{
    return chapter->missing.is_missing && is_blank(chapter) &&
           (chapter->missing.like[0] != '\0' || strcmp(plan->answers, "exercises") == 0);
}

static void show_function(const Page *page, const JudgingPlan *plan, const Chapter *chapter,
                          const FunctionRecord *function, ShownFigures *shown)
{
    const char *state = function_value(function, "state");
    bool unanswered = strcmp(state, "unanswered") == 0;
    bool has_ended = strcmp(state, "crashed") == 0 || strcmp(state, "timed out") == 0;
    int number = exercise_number(function->name);
    if (number < 0)
        return;
    const Exercise *exercise = &exercises[number];
    const char *warnings = record_value(&chapter->record, "warnings");
    if (page->is_brief) // what comes first leaves a terminal first
        show_lines(page, warnings);
    show_header(page, exercise, unanswered ? "  is not answered yet" : "");
    if (unanswered) {
        page_field(page, PLAIN, "asked", exercise->prompt);
    } else {
        page_words(page, PLAIN, 2, 2, "%s", test_sentence(function).s);
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
        if (strcmp(function->entries[i].key, "help") == 0)
            page_words(page, YELLOW, 2, 8, "help: %s", function->entries[i].value);
    if (is_blank(chapter) && chapter->missing.like[0] != '\0')
        page_words(page, YELLOW, 2, 8, "help: there is also '%s'. Only %s.c is your answer.",
                   chapter->missing.like, chapter->stem);
    show_figure(page, plan, function->name, shown);
    page_terminal(page, "  %-*smake %s EX=%.2s\n", PAGE_LABEL - 2, "try",
                  has_ended ? "debug" : "hint", chapter->stem);
    if (!page->is_brief)
        show_lines(page, warnings);
    page_terminal(page, "\n");
}

void show_missing(const Page *page, const JudgingPlan *plan, const char *stem,
                  const MissingAnswer *missing)
{
    page_line(page, BOLD, "%s  %s/%s.c is missing", stem, plan->answers, stem);
    if (missing->like[0] != '\0')
        page_words(page, YELLOW, 2, 8, "help: there is '%s': rename it to %s.c.", missing->like,
                   stem);
    else
        page_words(page, YELLOW, 2, 8, "help: make reset EX=%.2s puts the blank there.", stem);
}

// NULL if there is a verdict.
static const char *trouble_of(const Chapter *chapter)
{
    const char *state = chapter->is_known ? record_state(&chapter->record) : "stopped";
    return strcmp(state, "compiler") == 0  ? "does not compile"
           : strcmp(state, "linker") == 0  ? "cannot be linked"
           : strcmp(state, "stopped") == 0 ? "could not be judged"
                                           : NULL;
}

static void show_troubles(const Page *page, const JudgingPlan *plan, const Chapter *chapter,
                          bool all, ShownFigures *shown)
{
    if (is_lost(plan, chapter)) {
        show_missing(page, plan, chapter->stem, &chapter->missing);
        page_terminal(page, "\n");
        return;
    }
    const char *what = trouble_of(chapter);
    if (what != NULL) {
        page_part(page, "trouble", chapter->stem, what);
        page_line(page, BOLD, "%s  %s:", chapter->stem, what);
        show_lines(page, record_value(&chapter->record, "words"));
        page_terminal(page, "\n");
        return;
    }
    const char *states[] = {"wrong", "unanswered"};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < chapter->record.function_count; i++) {
            const FunctionRecord *function = &chapter->record.functions[i];
            if (!function_is(function, states[s]))
                continue;
            show_function(page, plan, chapter, function, shown);
            if (!all)
                return;
        }
}

// ---- how far -----------------------------------------------------------------------------------

static void show_names(const Page *page, const char *label, const char *names)
{
    if (names[0] == '\0')
        return;
    page_part(page, "field", label, names);
    if (!page->is_web)
        page_words(page, PLAIN, 20, 21, "%s: %s", label, names);
}

static void append(char *list, size_t size, const char *separator, const char *format,
                   const char *a, const char *b)
{
    size_t length = strlen(list);
    length += (size_t)snprintf(list + length, size - length, "%s", length > 0 ? separator : "");
    if (length < size)
        snprintf(list + length, size - length, format, a, b);
}

// NAME, NAME (for OTHER, OTHER), ...
static void show_those(const Page *page, const Chapter *chapter, const char *label,
                       const char *state)
{
    char list[6000] = "";
    for (int i = 0; i < chapter->record.function_count; i++) {
        const FunctionRecord *function = &chapter->record.functions[i];
        char others[2000];
        if (!function_is(function, state))
            continue;
        put_names(others, sizeof others, function_because(function));
        const char *format = strcmp(state, "waiting") == 0 ? "%s (for %s)" : "%s%s";
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
        put_names(names, sizeof names, entry->value + length);
        snprintf(label, sizeof label, "depends on your %s, which is not right yet", stem);
        show_names(page, label, names);
        if (first[0] == '\0')
            strcpy(first, stem);
    }
}

static void show_progress(const Page *page, const JudgingPlan *plan, const Chapter *chapter,
                          bool is_next, char stands_on[64])
{
    const char *state = chapter->is_known ? record_state(&chapter->record) : "stopped";
    Text counted = text_of("%d of %d", functions_that_are(&chapter->record, "right"),
                           chapter->record.function_count);
    const char *trouble = trouble_of(chapter), *words = trouble != NULL               ? trouble
                                                        : strcmp(state, "right") == 0 ? "done"
                                                        : is_lost(plan, chapter)      ? "missing"
                                                        : strcmp(state, "blank") == 0 ? "not yet"
                                                                                      : counted.s;
    page_line(page, PLAIN, "  %-16s %s%s", chapter->stem, words, is_next ? "   <- next" : "");
    if (is_next && !is_lost(plan, chapter)) {
        if (!page->is_web) // a page shows the state of each
            show_those(page, chapter, "wrong", "wrong");
        show_those(page, chapter, "waiting", "waiting");
        show_dependencies(page, chapter, stands_on);
        if (!page->is_web)
            show_those(page, chapter, "not answered yet", "unanswered");
    }
    char extra[2000] = "", all[2400];
    for (int i = 0; i < chapter->record.function_count; i++)
        if (strcmp(function_value(&chapter->record.functions[i], "extra"), "wrong") == 0)
            append(extra, sizeof extra, ", ", "%s%s", chapter->record.functions[i].name, "");
    if (strcmp(state, "right") == 0 && extra[0] != '\0') {
        snprintf(all, sizeof all, "more digits in %s, see 'Losing digits'%s%s%s", extra,
                 page->is_web ? "" : " in chapters/", page->is_web ? "" : chapter->stem,
                 page->is_web ? "" : "/README.md");
        show_names(page, "extra, no marks", all);
    }
}

// Whether somebody has written an answer: it differs from the blank.
static bool is_begun(const JudgingPlan *plan, int chapter)
{
    size_t size, blank_size;
    char *text = whole_text(plan_answer(plan, chapter).s, &size);
    char *blank = whole_text(plan_blank(plan, chapter).s, &blank_size);
    bool differs =
        text != NULL && blank != NULL && (size != blank_size || memcmp(text, blank, size) != 0);
    free(text);
    free(blank);
    return differs;
}

Progress progress_so_far(const JudgingPlan *plan)
{
    Progress progress = {0, 0, 0};
    for (const Exercise *e = exercises; e->name != NULL; e++)
        progress.of++;
    for (int i = 0; i < plan->count; i++) {
        ChapterRecord record;
        if (judging_record(plan, i, &record))
            progress.right += functions_that_are(&record, "right");
        else if (is_begun(plan, i))
            progress.unjudged++;
        chapter_record_free(&record);
    }
    return progress;
}

static void show_progress_so_far(const Page *page, const JudgingPlan *plan)
{
    Progress progress = progress_so_far(plan);
    Text unjudged = text_of("; %d chapter%s not judged yet", progress.unjudged,
                            progress.unjudged == 1 ? "" : "s");
    page_line(page, PLAIN, "  %-16s %d of %d functions are right%s", "all chapters", progress.right,
              progress.of, progress.unjudged > 0 ? unjudged.s : "");
}

// Wrong comes before what is not answered yet. An answer with another name counts as wrong.
static bool is_wrong(const JudgingPlan *plan, const Chapter *chapter)
{
    return trouble_of(chapter) != NULL ||
           (is_lost(plan, chapter) && chapter->missing.like[0] != '\0') ||
           first_that_is(&chapter->record, "wrong") != NULL;
}

static bool is_right(const Chapter *chapter)
{
    return chapter->is_known && strcmp(record_state(&chapter->record), "right") == 0;
}

void show_faults(const Page *page, const JudgingPlan *plan)
{
    bool any = false;
    for (int i = 0; i < plan->count; i++) {
        Chapter chapter = {.stem = plan->chapters[i].stem};
        char names[4000] = "";
        chapter.is_known = judging_record(plan, i, &chapter.record);
        for (int k = 0; k < chapter.record.function_count; k++)
            if (function_is(&chapter.record.functions[k], "wrong"))
                append(names, sizeof names, ", ", "%s%s", chapter.record.functions[k].name, "");
        const char *trouble = trouble_of(&chapter);
        if (trouble != NULL || names[0] != '\0') {
            if (!any)
                page_line(page, PLAIN, "Not right in it ('make exercises' says more):");
            any = true;
            static const char padding[] = "~~~~~~~~~~~~~~~~~~~~"; // as blanks that do not break
            size_t length = strlen(chapter.stem), most = sizeof padding - 1;
            page_words(page, PLAIN, 2, 23, "%s%s %s%s", chapter.stem,
                       padding + (length < most ? length : most),
                       trouble != NULL ? trouble : "wrong: ", names);
        }
        chapter_record_free(&chapter.record);
    }
}

typedef struct {
    Chapter chapters[MOST_CHAPTERS]; // the chosen ones
    int count;
    const Chapter *next; // the first that is wrong, or else not answered yet; NULL if all are right
    bool wrong;
} Chosen;

static Chosen *chosen_read(const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS])
{
    static Chosen all;
    all.count = 0;
    all.next = NULL;
    all.wrong = false;
    for (int i = 0; i < plan->count; i++) {
        if (!chosen[i])
            continue;
        Chapter *chapter = &all.chapters[all.count++];
        chapter->stem = plan->chapters[i].stem;
        chapter->missing = missing_answer(plan->answers, chapter->stem);
        chapter->is_known = judging_record(plan, i, &chapter->record);
        all.wrong = all.wrong || !chapter->is_known || is_wrong(plan, chapter) ||
                    strcmp(record_state(&chapter->record), "wrong") == 0;
    }
    for (int i = all.count - 1; i >= 0; i--)
        if (!is_right(&all.chapters[i]) &&
            (is_wrong(plan, &all.chapters[i]) || all.next == NULL || !is_wrong(plan, all.next)))
            all.next = &all.chapters[i];
    return &all;
}

static void chosen_free(Chosen *all)
{
    for (int i = 0; i < all->count; i++)
        chapter_record_free(&all->chapters[i].record);
}

int chapter_that_is_next(const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS])
{
    Chosen *read = chosen_read(plan, chosen);
    int next = read->next != NULL ? plan_chapter(plan, read->next->stem) : -1;
    chosen_free(read);
    return next;
}

Standing show_verdicts(const Page *page, const JudgingPlan *plan, const bool chosen[MOST_CHAPTERS],
                       bool all, ShownFigures *shown)
{
    Chosen *read = chosen_read(plan, chosen);
    const Chapter *chapters = read->chapters, *next = read->next;
    int count = read->count;
    shown->count = 0;
    for (int i = 0; i < count; i++)
        if (all ? !is_right(&chapters[i]) : &chapters[i] == next)
            show_troubles(page, plan, &chapters[i], all, shown);
    char stands_on[64] = "";
    for (int i = 0; i < count; i++)
        if (!page->is_brief || next == NULL || &chapters[i] == next)
            show_progress(page, plan, &chapters[i], &chapters[i] == next, stands_on);
    show_progress_so_far(page, plan);
    if (next == NULL || !page->is_brief || stands_on[0] != '\0')
        page_terminal(page, "\n");
    if (next != NULL && (!page->is_brief || stands_on[0] != '\0')) {
        bool has_trouble = first_that_is(&next->record, "wrong") != NULL ||
                           first_that_is(&next->record, "unanswered") != NULL;
        const char *work = !has_trouble && stands_on[0] != '\0' ? stands_on : next->stem;
        page_terminal(page, "Next: %s/%s.c\n      the lesson is chapters/%s/README.md\n",
                      plan->answers, work, work);
    }
    bool is_done = next == NULL;
    chosen_free(read);
    return is_done ? ALL_RIGHT : read->wrong ? SOMETHING_WRONG : BLANKS_LEFT;
}

// ---- the words below a figure that is drawn by wrong answers -----------------------------------

// On one line, with a minus sign where a hyphen is one.
static void put_words(FILE *out, const char *words, bool is_formula)
{
    for (; *words != '\0'; words++)
        if (is_formula && words[0] == '-' && words[1] == ' ')
            fputs("\u2212", out);
        else
            putc(*words == '\n' || *words == '\t' ? ' ' : *words, out);
}

static void put_note(FILE *out, const FunctionRecord *function)
{
    const char *formula = function_value(function, "formula"),
               *why = function_value(function, "why");
    fputs(function->name, out);
    if (why[0] == '\0') {
        fputs(" is not right yet.", out);
        return;
    }
    if (formula[0] != '\0') {
        fputs(" looks like ", out);
        put_words(out, formula, true);
    }
    fputs(": ", out);
    put_words(out, why, false);
}

void figure_note(FILE *out, const JudgingPlan *plan, int count, char *const *called)
{
    static ChapterRecord records[MOST_CHAPTERS];
    char reached[MOST_NAMES] = "";
    bool first = true;
    for (int i = 0; i < plan->count; i++)
        record_read(plan_beside(plan, i, ".record").s, &records[i]);
    for (int i = 0; i < count; i++)
        names_add(reached, sizeof reached, called[i]);
    // An answer that a wrong one calls is not to blame; an answer that one waits for is.
    for (bool grows = true; grows;) {
        grows = false;
        for (int i = 0; i < plan->count; i++)
            for (int k = 0; k < records[i].function_count; k++) {
                const FunctionRecord *function = &records[i].functions[k];
                if (names_include(reached, function->name) && !function_is(function, "wrong"))
                    grows |= names_add(reached, sizeof reached, function_because(function));
            }
    }
    for (int i = 0; i < plan->count; i++)
        for (int k = 0; k < records[i].function_count; k++) {
            const FunctionRecord *function = &records[i].functions[k];
            if (!names_include(reached, function->name) || !function_is(function, "wrong"))
                continue;
            if (!first)
                putc(' ', out);
            first = false;
            put_note(out, function);
        }
    if (!first)
        putc('\n', out);
    for (int i = 0; i < plan->count; i++)
        chapter_record_free(&records[i]);
}

// ---- an answer that is not where it must be, and the file that it may be in --------------------

enum { LONGEST_PATH = 4096 };

// The letters and digits of the stem come first, whatever is between them.
static bool begins_like(const char *name, const char *stem)
{
    for (; *stem != '\0'; stem++) {
        if (!isalnum((unsigned char)*stem))
            continue;
        while (*name != '\0' && !isalnum((unsigned char)*name))
            name++;
        if (tolower((unsigned char)*name++) != *stem)
            return false;
    }
    return true;
}

// Not the answer, the other files of the exercise, nor what make reset has kept.
static bool may_be_answer(const char *name, const char *stem)
{
    const char *ending = strrchr(name, '.');
    return isdigit((unsigned char)name[0]) && begins_like(name, stem) &&
           (strncmp(name, stem, strlen(stem)) != 0 || strcmp(name + strlen(stem), ".c") != 0) &&
           strstr(name, ".backup-") == NULL &&
           (ending == NULL || (strcmp(ending, ".h") != 0 && strcmp(ending, ".hints") != 0 &&
                               strcmp(ending, ".o") != 0));
}

MissingAnswer missing_answer(const char *folder, const char *stem)
{
    MissingAnswer missing = {false, ""};
    char path[LONGEST_PATH];
    snprintf(path, sizeof path, "%s/%s.c", folder, stem);
    missing.is_missing = access(path, F_OK) != 0;
    DIR *files = opendir(folder);
    time_t newest = 0;
    for (const struct dirent *file; files != NULL && (file = readdir(files)) != NULL;) {
        struct stat is;
        snprintf(path, sizeof path, "%s/%s", folder, file->d_name);
        if (!may_be_answer(file->d_name, stem) || stat(path, &is) != 0 || !S_ISREG(is.st_mode) ||
            (missing.like[0] != '\0' && is.st_mtime <= newest))
            continue;
        newest = is.st_mtime;
        snprintf(missing.like, sizeof missing.like, "%s", file->d_name);
    }
    if (files != NULL)
        closedir(files);
    return missing;
}
