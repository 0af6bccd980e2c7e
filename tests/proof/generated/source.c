// source.c - preprocessed C as tokens, and the items at its top level.
#include "tests/proof/generated/source.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REFERENCE "reference_"

// The preprocessor's line markers: # LINE "FILE" ...
typedef struct {
    int line;
    bool wanted;
} Place;

// The solutions, and a stem's known mistakes and variants of the right answer.
static bool is_answer(const char *path)
{
    const char *name = strrchr(path, '/');
    return strncmp(path, "solutions/", 10) == 0 ||
           (strncmp(path, "tests/", 6) == 0 && isdigit((unsigned char)path[6]) && name != NULL &&
            (strncmp(name, "/mistakes", 9) == 0 || strncmp(name, "/variants", 9) == 0));
}

static void place_from(Source *source, Place *place, const char *marker)
{
    char whole[200] = "";
    if (sscanf(marker, "# %d \"%199[^\"]\"", &place->line, whole) < 1)
        return;
    const char *path = strncmp(whole, "./", 2) == 0 ? whole + 2 : whole;
    place->wanted = is_answer(path);
    if (place->wanted && source->path[0] == '\0')
        snprintf(source->path, sizeof source->path, "%s", path);
}

static const char *after_token(const char *at, Kind *kind)
{
    static const char *const signs[] = {"...", "<<=", ">>=", "->", "++", "--", "<<", ">>",
                                        "<=",  ">=",  "==",  "!=", "&&", "||", "+=", "-=",
                                        "*=",  "/=",  "%=",  "&=", "|=", "^=", NULL};
    const char *end = at + 1;
    if (*at == '"' || *at == '\'') {
        *kind = STRING;
        while (*end != *at && *end != '\0')
            end += *end == '\\' ? 2 : 1;
        return end + 1;
    }
    if (isalpha((unsigned char)*at) || *at == '_') {
        *kind = NAME;
        while (isalnum((unsigned char)*end) || *end == '_')
            end++;
        return end;
    }
    if (isdigit((unsigned char)*at) || (*at == '.' && isdigit((unsigned char)at[1]))) {
        *kind = NUMBER;
        while (isalnum((unsigned char)*end) || *end == '.' ||
               ((*end == '-' || *end == '+') && strchr("eEpP", end[-1]) != NULL))
            end++;
        return end;
    }
    *kind = SIGN;
    for (int i = 0; signs[i] != NULL; i++)
        if (strncmp(at, signs[i], strlen(signs[i])) == 0)
            return at + strlen(signs[i]);
    return end;
}

static void take_tokens(Source *source, const char *line, const Place *place)
{
    for (const char *at = line; *at != '\0';) {
        Kind kind;
        if (isspace((unsigned char)*at)) {
            at++;
            continue;
        }
        const char *end = after_token(at, &kind);
        if (source->token_count == MOST_TOKENS) {
            fprintf(stderr, "%s: more than %d tokens\n", source->path, MOST_TOKENS);
            exit(1);
        }
        Token token = {strndup(at, (size_t)(end - at)), kind, place->line, -1};
        source->tokens[source->token_count++] = token;
        at = end;
    }
}

bool token_is(const Source *source, int i, const char *text)
{
    return i >= 0 && i < source->token_count && strcmp(source->tokens[i].text, text) == 0;
}

static int depth_of(const Source *source, int i)
{
    const char *text = source->tokens[i].text;
    bool sign = source->tokens[i].kind == SIGN && text[1] == '\0';
    return !sign ? 0 : strchr("([{", text[0]) != NULL ? 1 : strchr(")]}", text[0]) != NULL ? -1 : 0;
}

int matching(const Source *source, int i)
{
    int way = depth_of(source, i), depth = 0;
    for (; i >= 0 && i < source->token_count; i += way) {
        depth += depth_of(source, i);
        if (depth == 0)
            return i;
    }
    return source->token_count - 1;
}

int item_named(const Source *source, const char *name)
{
    for (int i = 0; i < source->item_count; i++)
        if (strcmp(source->items[i].name, name) == 0)
            return i;
    return -1;
}

// The name before the ( of a function; the last name before [, = or ; of a table or a type.
static const char *name_of(const Source *source, int from, int to)
{
    const char *name = "";
    for (int i = from; i < to; i++) {
        if (token_is(source, i, "{")) { // a type's members
            i = matching(source, i);
            continue;
        }
        if (strchr("(=[;", source->tokens[i].text[0]) != NULL && name[0] != '\0')
            break;
        if (source->tokens[i].kind == NAME)
            name = source->tokens[i].text;
    }
    return name;
}

static void find_items(Source *source)
{
    for (int from = 0, to; from < source->token_count; from = to) {
        int body = 0;
        for (to = from; to < source->token_count && !token_is(source, to, ";"); to++) {
            if (token_is(source, to, "{") && token_is(source, to - 1, ")"))
                body = to;
            if (depth_of(source, to) > 0)
                to = matching(source, to);
            if (body > 0)
                break;
        }
        to++;
        if (source->item_count == MOST_ITEMS) {
            fprintf(stderr, "%s: more than %d items\n", source->path, MOST_ITEMS);
            exit(1);
        }
        source->items[source->item_count++] = (Item){name_of(source, from, to), from, body, to};
    }
}

static void add_entry(Source *source, const char *exercise, const char *label, const char *function)
{
    Entry entry = {.item = item_named(source, function)};
    if (entry.item < 0 || source->entry_count == MOST_ENTRIES)
        return;
    snprintf(entry.exercise, sizeof entry.exercise, "%s", exercise);
    snprintf(entry.label, sizeof entry.label, "%s", label);
    source->entries[source->entry_count++] = entry;
}

static void unquoted(char *into, size_t size, const char *string)
{
    snprintf(into, size, "%.*s", (int)strlen(string) - 2, string + 1);
}

// Rows of tables: strings, of which the last is the exercise, and (AnyFunction *)(answer).
static void find_rows(Source *source)
{
    char label[100] = "", last[100] = "";
    for (int i = 0; i < source->token_count; i++) {
        const Token *token = &source->tokens[i];
        if (token_is(source, i, "{"))
            label[0] = last[0] = '\0';
        if (token->kind == STRING && token->text[0] == '"') {
            size_t used = strlen(label);
            snprintf(label + used, sizeof label - used, "%s", last);
            unquoted(last, sizeof last, token->text);
        }
        if (strcmp(token->text, "AnyFunction") == 0) {
            int name = i + 3;
            while (token_is(source, name, "("))
                name++;
            add_entry(source, last, label[0] != '\0' ? label : "a right answer",
                      source->tokens[name].text);
        }
    }
}

static bool is_member(const Source *source, int i)
{
    return token_is(source, i - 1, ".") || token_is(source, i - 1, "->");
}

// Members of a type that is declared; its types are named like others.
static bool is_declared_member(const Source *source, const Item *item, int i)
{
    bool named = token_is(source, i + 1, ";") || token_is(source, i + 1, ",") ||
                 token_is(source, i + 1, "[") || token_is(source, i + 1, ")");
    return token_is(source, item->from, "typedef") && named && i < item->to - 2;
}

static void name_tokens(Source *source)
{
    for (int n = 0; n < source->item_count; n++)
        for (int i = source->items[n].from; i < source->items[n].to; i++)
            if (source->tokens[i].kind == NAME && !is_member(source, i) &&
                !is_declared_member(source, &source->items[n], i))
                source->tokens[i].item = item_named(source, source->tokens[i].text);
}

static void reach(const Source *source, int item, bool *reached)
{
    reached[item] = true;
    for (int i = source->items[item].body; i < source->items[item].to; i++) {
        int called = source->items[item].body > 0 ? source->tokens[i].item : -1;
        if (called >= 0 && source->items[called].body > 0 && !reached[called])
            reach(source, called, reached);
    }
}

void source_read(Source *source, const char *preprocessed)
{
    static char line[200000];
    FILE *file = fopen(preprocessed, "r");
    Place place = {0};
    if (file == NULL) {
        perror(preprocessed);
        exit(1);
    }
    // The first marker names the source itself.
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#') {
            place_from(source, &place, line);
            continue;
        }
        if (place.wanted)
            take_tokens(source, line, &place);
        place.line++;
    }
    fclose(file);
    find_items(source);
    find_rows(source);
    for (int i = 0; i < source->item_count; i++)
        if (source->items[i].body > 0 && strncmp(source->items[i].name, REFERENCE, 10) == 0)
            add_entry(source, source->items[i].name + 10, "the solution", source->items[i].name);
    name_tokens(source);
    for (int i = 0; i < source->item_count; i++)
        reach(source, i, source->reaches[i]);
}
