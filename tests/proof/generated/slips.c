// slips.c - every possible slip in a function.
//
// Operators, signs, constants, fields, names and arguments are replaced by others, terms and
// statements left out, operands swapped. Only tokens are looked at: the compiler finds the results
// that are not C.
#include "tests/proof/generated/slip_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void each_of(int from, int to, const char *words)
{
    char word[40];
    for (int used; sscanf(words, " %39s%n", word, &used) == 1; words += used)
        if (to - from != 1 || !is(from, word))
            slip(from, to, "%s", word);
}

// Signs with a side on either hand.
static void between(int i)
{
    if (!ends_value(i - 1))
        return;
    if (is(i, "+") || is(i, "-")) {
        int from = start_of_term(i), to = end_of_term(i + 1);
        slip(i, i + 1, is(i, "+") ? "-" : "+");
        slip(i, to, "%s", "");
        slip(from, is(i, "-") ? i : i + 1, "%s", "");
        if (is(i, "-"))
            slip(from, to, "%s - %s", words_of(i + 1, to), words_of(from, i));
    } else if (is(i, "*") || is(i, "/")) {
        int from = start_of_primary(i), to = end_of_primary(i + 1);
        slip(i, i + 1, is(i, "*") ? "/" : "*");
        slip(i, to, "%s", "");
        if (is(i, "*"))
            slip(from, i + 1, "%s", "");
        else
            slip(from, to, "%s / %s", words_of(i + 1, to), words_of(from, i));
    } else if (is(i, "&&") || is(i, "||")) {
        slip(i, i + 1, is(i, "&&") ? "||" : "&&");
        slip(i, end_of_condition(i + 1, 1), "%s", "");
        slip(end_of_condition(i - 1, -1) + 1, i + 1, "%s", "");
    }
}

static void number(int i)
{
    double value = strtod(text_of(i), NULL);
    if (is(i - 1, "[")) {
        each_of(i, i + 1, "0 1 2");
        return;
    }
    if (strpbrk(text_of(i), ".xeE") == NULL) {
        each_of(i, i + 1, "0 1 2 3");
        slip(i, i + 1, "%.0f", value + 1);
        slip(i, i + 1, "(%.0f)", value - 1);
    } else {
        each_of(i, i + 1, "0 1 (1/2)");
        slip(i, i + 1, "(%s * 2)", text_of(i));
        slip(i, i + 1, "(%s / 2)", text_of(i));
        slip(i, i + 1, "(1 - %s)", text_of(i));
    }
    slip(i, i + 1, "(-%s)", text_of(i));
}

static void instead(int i)
{
    static const char *const families[] = {
        " origin right up forward ",
        " distance width height ",
        " width height ",
        " column row ",
        " upper_left upper_right lower_left lower_right ",
        " eye at up ",
        " width aspect ",
        " origin direction ",
        " a b c ",
        " x y ",
        " s t ",
        " diffuse specular shine ",
        " ambient background color ",
        " center position ",
        " sphere_count light_count ",
        " < <= > >= ",
        " == != ",
        " += -= ",
        " *= /= ",
        " fmin fmax ",
        " sin cos tan ",
        " RIGHT_HANDED LEFT_HANDED ",
        " LIGHT_POINT LIGHT_DISTANT ",
        " floor ceil round ",
        " CAMERA_NO_DISTANCE CAMERA_NO_WIDTH CAMERA_NO_HEIGHT CAMERA_NOT_FINITE "
        "CAMERA_NO_RECTANGLE CAMERA_OFF_AXIS CAMERA_NO_DIRECTION CAMERA_UP_ALONG_VIEW ",
        NULL};
    bool member = is(i - 1, ".") || is(i - 1, "->");
    for (int family = 0; families[family] != NULL; family++) {
        bool of_members = family < 15;
        if (of_members == member && is_one_of(i, families[family]))
            each_of(i, i + 1, families[family]);
    }
}

// A call of this function of these arguments.
static void call(int i)
{
    int close = closing(i + 1), from = i + 2;
    if (is_one_of(i, " sqrt fabs vec3_unit copysign floor exponent pow isfinite "))
        slip(i, close + 1, "(%s)", words_of(from, end_of_condition(from, 1)));
    if (is_one_of(i, " vec3_dot reference_hit_sphere "))
        slip(i, close + 1, "fabs(%s)", words_of(i, close + 1));
    while (from < close) {
        int to = end_of_condition(from, 1), next = to < close ? end_of_condition(to + 1, 1) : to;
        if (to < close)
            slip(from, next, "%s, %s", words_of(to + 1, next), words_of(from, to));
        from = to + 1;
    }
}

// A number or a vector, as far as can be seen without knowing types.
static bool is_real(int from, int to)
{
    if (to - from == 1)
        return is_variable_of(from, "double") || is_variable_of(from, "vec3") ||
               is_variable_of(from, "Color");
    if (is(to - 1, ")") || is(to - 1, "]"))
        return kind_of(from) == NAME;
    return is_one_of(to - 1, " origin right up forward distance direction a b c x y s t radius "
                             "center position color ambient background diffuse specular shine eye "
                             "at aspect upper_left upper_right lower_left lower_right ") ||
           (is_one_of(to - 1, " width height ") && !is_one_of(to - 3, " screen size "));
}

// At the beginning of a value: another sign, another precision, another length.
static void value(int i)
{
    bool begins = !ends_value(i - 1) && !is(i - 1, ".") && !is(i - 1, "->") && !is(i - 1, "-");
    int to = end_of_primary(i);
    if (!begins || is(to, "=") || is(to, "++") || is(to, "{") || kind_of(to) == NAME ||
        is(i, "return") || is(i, "for") || is(i, "if") || is(i, "while"))
        return;
    const char *words = words_of(i, to);
    if (!is_real(i, to))
        return;
    if (!is(i - 1, "+"))
        slip(i, to, "-%s", words);
    if (to - i <= 4) {
        slip(i, to, "(int)(%s)", words);
        slip(i, to, "(float)(%s)", words);
        slip(i, to, "vec3_unit(%s)", words);
        slip(i, to, "(2 * %s)", words);
    }
}

void slips_of(const Source *source, int item, Slips *slips)
{
    int body = source->items[item].body, to = source->items[item].to - 1;
    pen_begin(source, item, slips);
    find_variables(source->items[item].from, to);
    for (int i = body + 1; i < to; i++) {
        between(i);
        instead(i);
        if (kind_of(i) == NUMBER)
            number(i);
        if (kind_of(i) == NAME && is(i + 1, "("))
            call(i);
        if (kind_of(i) == NAME || kind_of(i) == NUMBER || is(i, "("))
            value(i);
        if ((is(i, "-") || is(i, "!")) && !ends_value(i - 1))
            slip(i, i + 1, "%s", "");
    }
    statement_slips(body + 1, to);
}
