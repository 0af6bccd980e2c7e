// mutate.c - writes wrong answers in C, a line each.
//
//   PROGRAM SEED MOST ERRORS PREPROCESSED...
//
// From each answer of the sources (a solution, a mistake, a variant of the right answer) with one
// or two slips. At most MOST of each exercise, chosen at random, the solution's own slips first.
// ERRORS is the compiler's output about an earlier result: lines that it names are left out.
#include "tests/proof/generated/write_mutants.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LINES = 60000 };

static int source_count;
static Mutant *chosen;
static int chosen_count, chosen_room;
static bool bad_line[MOST_LINES];
static uint64_t state;

// xorshift64* (Vigna, 'An experimental exploration of Marsaglia's xorshift generators, scrambled').
static uint64_t random_below(uint64_t limit)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return (state * 2685821657736338717u >> 16) % limit;
}

// ---- choosing -----------------------------------------------------------------------------------

// Slips in the answer and its helpers; another exercise that it calls has tests of its own.
static Slips *slips_of_entry(int number, const Entry *entry)
{
    static Slips slips;
    slips.count = 0;
    for (int i = 0; i < sources[number]->item_count; i++)
        if (sources[number]->reaches[entry->item][i] &&
            (i == entry->item || strncmp(sources[number]->items[i].name, "reference_", 10) != 0))
            slips_of(sources[number], i, &slips);
    return &slips;
}

static void choose(int source, int entry, Slip one, Slip two)
{
    if (chosen_count == chosen_room) {
        chosen_room = 2 * chosen_room + 1000;
        chosen = realloc(chosen, sizeof *chosen * (size_t)chosen_room);
        if (chosen == NULL)
            abort();
    }
    chosen[chosen_count++] = (Mutant){source, entry, one, two, false};
}

static bool overlap(const Slip *one, const Slip *two)
{
    return one->item == two->item && one->from < two->to && two->from < one->to;
}

// All single slips of the solution, as far as there is room, and a third as many pairs; a share for
// each other answer.
static void choose_from(int number, int entry, int wanted)
{
    Slips *slips = slips_of_entry(number, &sources[number]->entries[entry]);
    int singles = slips->count < wanted * 3 / 4 ? slips->count : wanted * 3 / 4;
    for (int i = 0; i < singles; i++) { // the first of a shuffle
        int other = i + (int)random_below((uint64_t)(slips->count - i));
        Slip kept = slips->slips[i];
        slips->slips[i] = slips->slips[other];
        slips->slips[other] = kept;
        choose(number, entry, slips->slips[i], (Slip){0});
    }
    for (int i = 0; i < wanted / 4 && slips->count > 1; i++) {
        const Slip *one = &slips->slips[random_below((uint64_t)slips->count)];
        const Slip *two = &slips->slips[random_below((uint64_t)slips->count)];
        if (!overlap(one, two))
            choose(number, entry, *one, *two);
    }
}

static bool is_solution(const Entry *entry)
{
    return strcmp(entry->label, "the solution") == 0;
}

// ---- writing ------------------------------------------------------------------------------------

static void put_all(void)
{
    const char *const heads[] = {
        "// Made by tests/proof/generated/mutate.c.",
        "#include \"exercises/01-corners.h\"",
        "#include \"exercises/02-cameras.h\"",
        "#include \"exercises/03-screen.h\"",
        "#include \"exercises/04-pixel-ray.h\"",
        "#include \"exercises/05-quadratic.h\"",
        "#include \"exercises/06-ray-casting.h\"",
        "#include \"exercises/07-shading.h\"",
        "#include \"tests/proof/generated/generated.h\"",
        "#include <stdlib.h>",
        "#include <string.h>",
    };
    for (size_t i = 0; i < sizeof heads / sizeof heads[0]; i++) {
        printf("%s", heads[i]);
        end_line();
    }
    for (int i = 0; i < source_count; i++)
        put_source(i);
    for (int i = 0; i < chosen_count; i++) {
        chosen[i].bad = line < MOST_LINES && bad_line[line];
        if (chosen[i].bad)
            end_line();
        else
            put_mutant(&chosen[i], i);
    }
    printf("static const Generated generated[] = {\n");
    for (int i = 0; i < chosen_count; i++)
        if (!chosen[i].bad)
            put_row(&chosen[i], i);
    printf("{0}};\nOF_STEM(generated)\n");
}

static void read_errors(const char *path)
{
    char text[4000];
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return;
    while (fgets(text, sizeof text, file) != NULL) {
        int bad;
        const char *at = strstr(text, ".c:");
        if (strstr(text, "error:") != NULL && at != NULL && sscanf(at, ".c:%d", &bad) == 1 &&
            bad > 0 && bad < MOST_LINES)
            bad_line[bad] = true;
    }
    fclose(file);
}

// The solution gets half of the room of an exercise; the other answers share the rest.
static void choose_all(int most)
{
    for (int s = 0; s < source_count; s++)
        for (int e = 0; e < sources[s]->entry_count; e++) {
            const Entry *entry = &sources[s]->entries[e];
            int others = 0;
            for (int o = 0; o < source_count; o++)
                for (int i = 0; i < sources[o]->entry_count; i++)
                    others += !is_solution(&sources[o]->entries[i]) &&
                              strcmp(sources[o]->entries[i].exercise, entry->exercise) == 0;
            int share = most / 2 / (others > 0 ? others : 1);
            choose_from(s, e, is_solution(entry) ? most / 2 : share < 4 ? 4 : share);
        }
}

int main(int argc, char **argv)
{
    if (argc < 5 || argc - 4 > MOST_SOURCES) {
        fprintf(stderr, "Usage: %s SEED MOST ERRORS PREPROCESSED...\n", argv[0]);
        return 2;
    }
    state = strtoull(argv[1], NULL, 10) * 2 + 1;
    read_errors(argv[3]);
    for (int i = 4; i < argc; i++) {
        sources[source_count] = calloc(1, sizeof(Source));
        if (sources[source_count] == NULL)
            abort();
        source_read(sources[source_count++], argv[i]);
    }
    choose_all(atoi(argv[2]));
    put_all();
    return 0;
}
