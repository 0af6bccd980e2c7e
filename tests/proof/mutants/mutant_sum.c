// mutant_sum.c - whether each mutant of the solutions was killed, except the equivalent ones.
#include "tests/proof/mutants/mutant_sum.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_EQUIVALENTS = 1000, MOST_STEMS = 32 };

// A line of tests/proof/equivalent-mutants. The same text may be a mutant of several lines.
typedef struct {
    char *stem, *text;
    int line;
    bool occurs, survives;
} Equivalent;

static Equivalent equivalents[MOST_EQUIVALENTS];
static int equivalent_count;

typedef struct {
    char *stem;
    int killed, survived, equivalent;
} Sum;

char *next_line(FILE *file)
{
    char *line = NULL;
    size_t room = 0;
    ssize_t length = getline(&line, &room, file);
    if (length < 0) {
        free(line);
        return NULL;
    }
    line[strcspn(line, "\n")] = '\0';
    return line;
}

FILE *open_or_end(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        perror(path);
        exit(2);
    }
    return file;
}

bool next_mutant(FILE *list, Mutant *mutant)
{
    *mutant = (Mutant){.stem = next_line(list)};
    char *line = mutant->stem != NULL ? strchr(mutant->stem, '\t') : NULL;
    char *text = line != NULL ? strchr(line + 1, '\t') : NULL;
    if (text == NULL) {
        mutant_free(mutant);
        return false;
    }
    *line = *text = '\0';
    mutant->line = atoi(line + 1);
    mutant->text = text + 1;
    return true;
}

void mutant_free(Mutant *mutant)
{
    free(mutant->stem);
    *mutant = (Mutant){.line = 0};
}

static char *trimmed(char *text)
{
    text += strspn(text, " \t");
    char *end = text + strlen(text);
    while (end > text && isspace((unsigned char)end[-1]))
        *--end = '\0';
    return text;
}

// stem | mutated line | reason. How many lines are none of that.
static int read_equivalents(const char *path)
{
    static const char bar[] = " | ";
    FILE *file = open_or_end(path);
    int number = 0, wrong = 0;
    for (char *line; (line = next_line(file)) != NULL;) {
        char *text = strstr(line, bar), *reason = text != NULL ? strstr(text + 1, bar) : NULL;
        bool is_comment = line[0] == '#' || line[strspn(line, " ")] == '\0';
        number++;
        if (is_comment || reason == NULL || equivalent_count == MOST_EQUIVALENTS) {
            if (!is_comment) {
                printf("not ok: %s:%d: expected: stem | mutated line | reason\n", path, number);
                wrong++;
            }
            free(line);
            continue;
        }
        *text = *reason = '\0';
        equivalents[equivalent_count++] =
            (Equivalent){trimmed(line), trimmed(text + strlen(bar)), number, false, false};
    }
    fclose(file);
    return wrong;
}

static Equivalent *equivalent_to(const char *stem, const char *text)
{
    for (int i = 0; i < equivalent_count; i++)
        if (strcmp(equivalents[i].stem, stem) == 0 && strcmp(equivalents[i].text, text) == 0)
            return &equivalents[i];
    return NULL;
}

// The list has all mutants of a stem in a row.
static Sum *sum_of(Sum sums[MOST_STEMS], int *count, const char *stem)
{
    if (*count == 0 || strcmp(sums[*count - 1].stem, stem) != 0) {
        if (*count == MOST_STEMS)
            abort();
        sums[(*count)++] = (Sum){.stem = strdup(stem)};
    }
    return &sums[*count - 1];
}

static void count_mutant(Sum *sum, const Mutant *mutant, bool survived)
{
    char *text = trimmed(mutant->text);
    Equivalent *equivalent = equivalent_to(mutant->stem, text);
    if (equivalent != NULL) {
        equivalent->occurs = true;
        equivalent->survives = equivalent->survives || survived;
    }
    sum->killed += !survived;
    sum->equivalent += survived && equivalent != NULL;
    sum->survived += survived && equivalent == NULL;
    if (survived && equivalent == NULL)
        printf("not ok: survived: solutions/%s.c:%d: %s\n", mutant->stem, mutant->line, text);
}

static int say_stale(const char *path)
{
    int stale = 0;
    for (int i = 0; i < equivalent_count; i++) {
        const Equivalent *it = &equivalents[i];
        if (!it->survives)
            printf("not ok: stale: %s:%d: %s\n", path, it->line,
                   it->occurs ? "not equivalent, a test fails" : "no such mutant");
        stale += !it->survives;
    }
    return stale;
}

int mutant_sum(const char *list, const char *results, const char *path)
{
    Sum sums[MOST_STEMS];
    int wrong = read_equivalents(path), good = 0, count = 0, number = 0;
    FILE *file = open_or_end(list);
    for (Mutant mutant; next_mutant(file, &mutant); mutant_free(&mutant)) {
        char name[4096];
        snprintf(name, sizeof name, "%s/%d", results, ++number);
        FILE *result = open_or_end(name);
        char *word = next_line(result);
        fclose(result);
        if (word == NULL || strcmp(word, "invalid") != 0)
            count_mutant(sum_of(sums, &count, mutant.stem), &mutant,
                         word == NULL || strcmp(word, "killed") != 0);
        free(word);
    }
    fclose(file);
    wrong += say_stale(path);
    for (int i = 0; i < count; i++) {
        const Sum *sum = &sums[i];
        int survived = sum->survived + sum->equivalent;
        printf("+ %s: %d mutants, %d killed, %d survived, %d of them equivalent\n", sum->stem,
               sum->killed + survived, sum->killed, survived, sum->equivalent);
        good += sum->killed + sum->equivalent;
        wrong += sum->survived;
        free(sums[i].stem);
    }
    printf("mutants: %d passed, %d failed\n", good, wrong);
    return wrong > 0 || good == 0 ? 1 : 0;
}
