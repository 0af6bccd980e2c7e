// statements.c - slips of statements and of variables.
#include "tests/proof/generated/slip_text.h"

#include <stdio.h>
#include <string.h>

enum { MOST_VARIABLES = 60 };

static struct {
    const char *name, *type;
} variables[MOST_VARIABLES];
static int variable_count;

// TYPE [*] NAME followed by what ends a declaration; in a list the type of the one before.
void find_variables(int from, int to)
{
    const char *type = "";
    variable_count = 0;
    for (int i = from; i < to && variable_count < MOST_VARIABLES; i++) {
        if (kind_of(i) != NAME || !(is_one_of(i + 1, " = ; , ) [ ")))
            continue;
        bool pointer = is(i - 1, "*");
        bool declared = kind_of(i - 1 - pointer) == NAME && !is(i - 1 - pointer, "return") &&
                        (!pointer || is(i - 3, "const"));
        if (declared)
            type = text_of(i - 1 - pointer);
        if (declared) {
            variables[variable_count].name = text_of(i);
            variables[variable_count++].type = type;
        }
    }
}

bool is_variable_of(int i, const char *type)
{
    bool found = false;
    for (int v = 0; v < variable_count; v++)
        found = found || (is(i, variables[v].name) && strcmp(type, variables[v].type) == 0);
    return found;
}

static void another_variable(int i)
{
    if (kind_of(i) != NAME || is(i - 1, ".") || is(i - 1, "->") || kind_of(i - 1) == NAME)
        return;
    const char *type = NULL;
    for (int v = 0; v < variable_count; v++)
        if (is(i, variables[v].name))
            type = variables[v].type;
    for (int v = 0; type != NULL && v < variable_count; v++)
        if (strcmp(type, variables[v].type) == 0 && !is(i, variables[v].name))
            slip(i, i + 1, "%s", variables[v].name);
}

static int end_of_statement(int i)
{
    while (!is(i, ";")) {
        if (is_one_of(i, " ( [ { "))
            i = closing(i);
        i++;
    }
    return i + 1;
}

static void condition(int i)
{
    int close = closing(i + 1);
    slip(i + 2, close, "!(%s)", words_of(i + 2, close));
    slip(i + 2, close, "1");
    slip(i + 2, close, "0");
}

// a ? b : c
static void choice(int i)
{
    int colon = end_of_condition(i + 1, 1), to = end_of_condition(colon + 1, 1);
    int from = end_of_condition(i - 1, -1) + 1;
    if (!is(colon, ":"))
        return;
    slip(i + 1, to, "%s : %s", words_of(colon + 1, to), words_of(i + 1, colon));
    slip(from, i, "1");
    slip(from, i, "0");
}

void statement_slips(int from, int to)
{
    for (int i = from; i < to; i++) {
        another_variable(i);
        if (is(i, "?"))
            choice(i);
        if (is(i, "if")) {
            condition(i);
            slip(i, end_of_statement(i), ";");
        }
        bool begins = is_one_of(i - 1, " ; { } ") && kind_of(i) == NAME;
        int sign = begins ? end_of_primary(i) : i;
        if (begins && is_one_of(sign, " = += -= *= /= ") && !is(i - 1, ")"))
            slip(i, end_of_statement(i), ";");
        if (begins && is_one_of(sign, " += -= *= /= "))
            slip(sign, sign + 1, "=");
    }
}
