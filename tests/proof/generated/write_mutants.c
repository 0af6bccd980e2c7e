// write_mutants.c - writes mutants: functions with one slip or two, a line each.
#include "tests/proof/generated/write_mutants.h"

#include <stdio.h>
#include <string.h>

Source *sources[MOST_SOURCES];
int line = 1;

// Items at the top level of a source get names of their own: _ and the source's number, or _m and
// the mutant's number if they are on the way to a slip.
static void put_word(int number, const char *word, int item, const bool *copied, int mutant)
{
    if (item >= 0 && copied != NULL && copied[item])
        printf("%s_m%d ", word, mutant);
    else if (item >= 0)
        printf("%s_%d ", word, number);
    else
        printf("%s ", word);
}

static void put_tokens(int number, int from, int to, const bool *copied, int mutant)
{
    for (int i = from; i < to; i++)
        put_word(number, sources[number]->tokens[i].text, sources[number]->tokens[i].item, copied,
                 mutant);
}

static void put_text(int number, const char *text, const bool *copied, int mutant)
{
    char word[SLIP_TEXT];
    bool member = false;
    for (int used; text[0] != '\0'; text += used) {
        if (sscanf(text, "%399[A-Za-z_0-9.]%n", word, &used) == 1) {
            put_word(number, word, member ? -1 : item_named(sources[number], word), copied, mutant);
        } else {
            used = 1;
            putchar(text[0]);
        }
        if (text[0] != ' ')
            member = strchr(".>", text[used - 1]) != NULL;
    }
    putchar(' ');
}

static const Slip *slip_at(const Mutant *it, int i)
{
    if (it->one.to > 0 && it->one.from == i)
        return &it->one;
    return it->two.to > 0 && it->two.from == i ? &it->two : NULL;
}

static void put_head(int number, int item, const bool *copied, int mutant)
{
    const Item *function = &sources[number]->items[item];
    if (!token_is(sources[number], function->from, "static"))
        printf("static ");
    put_tokens(number, function->from, function->body, copied, mutant);
    printf("; ");
}

static void put_function(int number, int item, const Mutant *it, const bool *copied, int mutant)
{
    const Item *function = &sources[number]->items[item];
    if (!token_is(sources[number], function->from, "static"))
        printf("static ");
    for (int i = function->from; i < function->to; i++) {
        const Slip *slip = slip_at(it, i);
        if (slip == NULL) {
            put_tokens(number, i, i + 1, copied, mutant);
            continue;
        }
        put_text(number, slip->text, copied, mutant);
        i = slip->to - 1;
    }
}

void end_line(void)
{
    putchar('\n');
    line++;
}

// The functions on the way from the answer to what was changed, in a line.
void put_mutant(const Mutant *it, int mutant)
{
    const Source *source = sources[it->source];
    const bool *needed = source->reaches[source->entries[it->entry].item];
    bool copied[MOST_ITEMS] = {false};
    for (int i = 0; i < source->item_count; i++)
        copied[i] = needed[i] && (source->reaches[i][it->one.item] ||
                                  (it->two.to > 0 && source->reaches[i][it->two.item]));
    for (int i = 0; i < source->item_count; i++)
        if (copied[i])
            put_head(it->source, i, copied, mutant);
    for (int i = 0; i < source->item_count; i++)
        if (copied[i])
            put_function(it->source, i, it, copied, mutant);
    end_line();
}

static bool is_of_a_table(const Source *source, const Item *item)
{
    bool table = false;
    for (int i = item->from; i < item->to && !table; i++)
        table = token_is(source, i, "Mistake") || token_is(source, i, "Variant");
    return table;
}

// Everything of a source except its answers' tables: the declarations, then the functions.
void put_source(int number)
{
    const Source *source = sources[number];
    for (int item = 0; item < source->item_count; item++) {
        if (source->items[item].body > 0)
            put_head(number, item, NULL, 0);
        else if (!is_of_a_table(source, &source->items[item]))
            put_tokens(number, source->items[item].from, source->items[item].to, NULL, 0);
        end_line();
    }
    for (int item = 0; item < source->item_count; item++)
        if (source->items[item].body > 0) {
            put_function(number, item, &(Mutant){0}, NULL, 0);
            end_line();
        }
}

static void put_quoted(const char *text)
{
    for (; *text != '\0'; text++)
        printf(strchr("\"\\", *text) != NULL ? "\\%c" : "%c", *text);
}

// The old statement, and the new one.
static void put_slip(const Source *source, const Slip *slip)
{
    printf("%s:%d: ", source->items[slip->item].name, source->tokens[slip->from].line);
    int from = slip->from, to = slip->to;
    while (from > source->items[slip->item].body + 1 && slip->from - from < 25 &&
           strchr(";{}", source->tokens[from - 1].text[0]) == NULL)
        from--;
    while (to < source->items[slip->item].to - 1 && to - slip->to < 25 &&
           strchr(";{}", source->tokens[to].text[0]) == NULL)
        to++;
    for (int i = from; i <= to; i++) {
        if (i == slip->from)
            printf("[[");
        if (i == slip->to)
            printf(" => %s]] ", slip->text);
        if (i < to)
            put_quoted(source->tokens[i].text);
        if (i < to)
            putchar(' ');
    }
}

void put_row(const Mutant *it, int mutant)
{
    const Source *source = sources[it->source];
    const Entry *entry = &source->entries[it->entry];
    printf("{\"%s\", \"%s: %s\", \"", entry->exercise, source->path, entry->label);
    put_slip(source, &it->one);
    if (it->two.to > 0) {
        printf("; ");
        put_slip(source, &it->two);
    }
    printf("\", (AnyFunction *)%s_m%d},", source->items[entry->item].name, mutant);
    end_line();
}
