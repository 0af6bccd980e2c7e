// slip_text.c - where values and terms begin and end, and how a slip is written down.
#include "tests/proof/generated/slip_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const Source *source;
static Slips *slips;
static int item;

void pen_begin(const Source *of, int function, Slips *into)
{
    source = of;
    item = function;
    slips = into;
}

// After the end of the function, everything has ended.
static bool is_inside(int i)
{
    return i >= source->items[item].from && i < source->items[item].to;
}

const char *text_of(int i)
{
    return is_inside(i) ? source->tokens[i].text : ";";
}

Kind kind_of(int i)
{
    return is_inside(i) ? source->tokens[i].kind : SIGN;
}

int closing(int i)
{
    return matching(source, i);
}

bool is(int i, const char *text)
{
    return strcmp(text_of(i), text) == 0;
}

bool is_one_of(int i, const char *words)
{
    char padded[100];
    snprintf(padded, sizeof padded, " %s ", text_of(i));
    return strstr(words, padded) != NULL;
}

// ---- expressions --------------------------------------------------------------------------------

// Whether a value ends here, so that an operator that follows has two sides.
bool ends_value(int i)
{
    Kind kind = kind_of(i);
    return kind == NUMBER || (kind == NAME && !is(i, "return")) || is(i, ")") || is(i, "]") ||
           is(i, "}");
}

int end_of_primary(int i)
{
    while (is_one_of(i, " - ! & * + "))
        i++;
    i = is(i, "(") || is(i, "{") ? matching(source, i) + 1 : i + 1;
    if (is(i, "{")) // (Type){ ... }
        i = matching(source, i) + 1;
    for (;;) {
        if (is(i, "(") || is(i, "["))
            i = matching(source, i) + 1;
        else if (is(i, ".") || is(i, "->"))
            i += 2;
        else
            return i;
    }
}

int start_of_primary(int end)
{
    int i = end - 1;
    for (;;) {
        if (is(i, ")") || is(i, "]") || is(i, "}"))
            i = matching(source, i);
        bool called = is(i, "(") || is(i, "[") || is(i, "{");
        if (called && (kind_of(i - 1) == NAME || is(i - 1, "]") || is(i - 1, ")")) &&
            !is(i - 1, "return"))
            i--;
        else if (is(i - 1, ".") || is(i - 1, "->"))
            i -= 2;
        else
            break;
    }
    bool sign = is(i - 1, "-") || is(i - 1, "!");
    return sign && !ends_value(i - 2) ? i - 1 : i;
}

int end_of_term(int i)
{
    i = end_of_primary(i);
    while (is(i, "*") || is(i, "/"))
        i = end_of_primary(i + 1);
    return i;
}

int start_of_term(int end)
{
    int i = start_of_primary(end);
    while ((is(i - 1, "*") || is(i - 1, "/")) && ends_value(i - 2))
        i = start_of_primary(i - 1);
    return i;
}

// One side of && or ||, from the sign on.
int end_of_condition(int i, int way)
{
    for (; !is_one_of(i, way > 0 ? " && || ? : ; , ) } " : " && || ? : ; , ( { = return ");
         i += way)
        if (is_one_of(i, way > 0 ? " ( [ { " : " ) ] } "))
            i = matching(source, i);
    return i;
}

// ---- writing slips ---------------------------------------------------------------------------

// Tokens from..to, separated by blanks.
const char *words_of(int from, int to)
{
    static char ring[4][SLIP_TEXT];
    static int turn;
    char *words = ring[turn++ % 4];
    size_t used = 0;
    words[0] = '\0';
    for (int i = from; i < to && used < SLIP_TEXT - 40; i++)
        used += (size_t)snprintf(words + used, SLIP_TEXT - used, "%s ", text_of(i));
    return words;
}

void slip(int from, int to, const char *format, ...)
{
    if (slips->count == MOST_SLIPS || to <= from || from <= source->items[item].body ||
        !is_inside(to))
        return;
    Slip *next = &slips->slips[slips->count];
    *next = (Slip){.item = item, .from = from, .to = to};
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(next->text, SLIP_TEXT, format, arguments);
    va_end(arguments);
    slips->count += length < SLIP_TEXT && to - from < 60;
}
