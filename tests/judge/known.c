// known.c - what is known of each stem, and which stem this run of the program is about.
#include "tests/judge/known.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_STEMS = 100 };

int answer_style;

static Stem stems[MOST_STEMS];
static int count;
static const Stem *chosen;

static Stem *find(const char *name, int length)
{
    for (int i = 0; i < count; i++)
        if ((int)strlen(stems[i].name) == length &&
            strncmp(stems[i].name, name, (size_t)length) == 0)
            return &stems[i];
    return NULL;
}

static Stem *find_or_add(const char *name, int length)
{
    Stem *stem = find(name, length);
    if (stem != NULL)
        return stem;
    if (count == MOST_STEMS || length >= (int)sizeof stem->name) {
        fprintf(stderr, "%.*s: more than %d stems, or its name is too long\n", length, name,
                MOST_STEMS);
        exit(2);
    }
    stem = &stems[count++];
    snprintf(stem->name, sizeof stem->name, "%.*s", length, name);
    return stem;
}

Stem *stem_of_file(const char *file)
{
    const char *const folders[] = {"tests/", "generated/"};
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++) {
        const char *at = strstr(file, folders[i]);
        if (at != NULL)
            return find_or_add(at + strlen(folders[i]),
                               (int)strcspn(at + strlen(folders[i]), "/."));
    }
    return find_or_add(file, (int)strcspn(file, "/."));
}

Stem *stem_named(const char *name)
{
    return find_or_add(name, (int)strlen(name));
}

void choose_stem(const char *name)
{
    chosen = name == NULL && count == 1 ? &stems[0]
             : name == NULL             ? NULL
                                        : find(name, (int)strlen(name));
    if (chosen == NULL) {
        fprintf(stderr, "%s: no such stem, expected one of:", name != NULL ? name : "");
        for (int i = 0; i < count; i++)
            fprintf(stderr, " %s", stems[i].name);
        fprintf(stderr, "\n");
        exit(2);
    }
    if (chosen->load != NULL)
        chosen->load();
}

const Stem *chosen_stem(void)
{
    return chosen;
}

// Compilers write the entries of a file in an order of their own. A program in a page may begin
// twice.
void add_known(const char *file, KindOfAnswer kind, KnownAnswer *answer)
{
    KnownAnswer **at = &stem_of_file(file)->known[kind];
    while (*at != NULL && *at != answer && (*at)->place < answer->place)
        at = &(*at)->next;
    if (*at == answer)
        return;
    answer->next = *at;
    *at = answer;
}

const KnownAnswer *known_answers(KindOfAnswer kind)
{
    return chosen->known[kind];
}
