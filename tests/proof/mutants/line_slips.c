// line_slips.c - the slips of the pen that can happen in one line of C.
//
// A line is read word by word, without its comment. Each word has its slips: the other sign, the
// next component, the function that is often confused with it, the number beside it.
#include "tests/proof/mutants/line_slips.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LINE = 400, MOST_SLIPS = 400 };

typedef struct {
    const char *word, *slips[3];
} Slip;

static const Slip slips_of_words[] = {
    {"+", {"-"}},
    {"-", {"+"}},
    {"*", {"/"}},
    {"/", {"*"}},
    {"%", {"/"}},
    {"+=", {"-="}},
    {"-=", {"+="}},
    {"*=", {"/="}},
    {"/=", {"*="}},
    {"++", {"--", " += 2"}},
    {"--", {"++"}},
    {"<", {"<=", ">"}},
    {"<=", {"<", ">"}},
    {">", {">=", "<"}},
    {">=", {">", "<"}},
    {"==", {"!="}},
    {"!=", {"=="}},
    {"&&", {"||"}},
    {"||", {"&&"}},
    {"!", {" "}},
    {"right", {"up"}},
    {"up", {"right"}},
    {"forward", {"right"}},
    {"across", {"upward", "up"}},
    {"upward", {"across"}},
    {"width", {"height"}},
    {"height", {"width"}},
    {"distance", {"width"}},
    {"upper_left", {"upper_right", "lower_left"}},
    {"upper_right", {"upper_left", "lower_right"}},
    {"lower_left", {"lower_right", "upper_left"}},
    {"lower_right", {"lower_left", "upper_right"}},
    {"column", {"row"}},
    {"row", {"column"}},
    {"x", {"y"}},
    {"y", {"x"}},
    {"origin", {"direction"}},
    {"direction", {"origin"}},
    {"at", {"eye"}},
    {"eye", {"at"}},
    {"s", {"t"}},
    {"t", {"s", "u"}},
    {"u", {"t"}},
    {"p", {"v"}},
    {"v", {"p"}},
    {"c", {"p"}},
    {"l", {"r"}},
    {"r", {"l"}},
    {"o", {"c"}},
    {"k", {"(-k)"}},
    {"size", {"speed"}},
    {"speed", {"size"}},
    {"sum", {"d", "a"}},
    {"half_b", {"a"}},
    {"product", {"lost"}},
    {"lost", {"product"}},
    {"even", {"q"}},
    {"fmin", {"fmax"}},
    {"fmax", {"fmin"}},
    {"tan", {"sin"}},
    {"sqrt", {" "}},
    {"fabs", {" "}},
    {"vec3_unit", {" "}},
    {"NO_HIT", {"0"}},
    {"RIGHT_HANDED", {"LEFT_HANDED"}},
    {"CAMERA_TOLERANCE", {"(1e3 * CAMERA_TOLERANCE)"}},
};

// After a point: the coefficients of a quadratic.
static const Slip slips_of_fields[] = {{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}};

typedef struct {
    const char *line;
    char declared[MOST_LINE]; // the variable that the line declares, or ""
    char *said[MOST_SLIPS];
    int count;
    void (*say)(const char *slip, void *context);
    void *context;
} Reading;

// A variable in its own first value could be anything.
static void change(Reading *reading, size_t at, size_t length, const char *other)
{
    char slip[2 * MOST_LINE];
    if (strcmp(other, reading->declared) == 0)
        return;
    snprintf(slip, sizeof slip, "%.*s%s%s", (int)at, reading->line, other,
             reading->line + at + length);
    for (int i = 0; i < reading->count; i++)
        if (strcmp(reading->said[i], slip) == 0)
            return;
    if (reading->count == MOST_SLIPS)
        abort();
    reading->said[reading->count++] = strdup(slip);
    reading->say(slip, reading->context);
}

static void find_declared(const char *code, char declared[MOST_LINE])
{
    char name[MOST_LINE];
    declared[0] = '\0';
    int end = 0;
    if (sscanf(code, " %*[A-Za-z_0-9] %399[a-z_] =%n", name, &end) == 1 && end > 0 &&
        code[end] == ' ')
        snprintf(declared, MOST_LINE, "%s", name);
}

static bool is_of_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static size_t length_of_number(const char *text)
{
    size_t length = strspn(text, "0123456789");
    if (strncmp(text, "0x", 2) == 0)
        length = 2 + strspn(text + 2, "0123456789abcdef");
    if (strncmp(text, "0x", 2) == 0 && text[length] == 'p') {
        length += text[length + 1] == '-' ? 2 : 1;
        length += strspn(text + length, "0123456789");
    } else if (text[length] == '.' && isdigit((unsigned char)text[length + 1])) {
        length += 1 + strspn(text + length + 1, "0123456789");
    }
    return length;
}

static size_t length_of_word(const char *text)
{
    static const char *const signs[] = {
        "->", "-=", "+=", "++", "--", "*=", "/=", "<=", ">=", "==", "!=", "&&", "||"};
    size_t length = 0;
    if (isdigit((unsigned char)text[0]))
        return length_of_number(text);
    while (is_of_name(text[length]))
        length++;
    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++)
        if (strncmp(text, signs[i], 2) == 0)
            return 2;
    return length > 0 ? length : 1;
}

// A length in pixels or a power of two is doubled; a small index is also the one before.
static void change_number(Reading *reading, size_t at, const char *word)
{
    char other[MOST_LINE];
    size_t length = strlen(word);
    const char *power = strpbrk(word, "p");
    if (power != NULL) {
        power += power[1] == '-' ? 2 : 1;
        snprintf(other, sizeof other, "%.*s%d", (int)(power - word), word, 2 * atoi(power));
    } else if (strcmp(word, "0.5") == 0) {
        change(reading, at, length, "0");
        snprintf(other, sizeof other, "1");
    } else if (strchr(word, '.') != NULL) {
        snprintf(other, sizeof other, "%.6g", atof(word) + 0.1);
    } else if (strcmp(word, "0") == 0) {
        snprintf(other, sizeof other, "1");
    } else if (strcmp(word, "1") == 0) {
        change(reading, at, length, "0");
        snprintf(other, sizeof other, "2");
    } else {
        snprintf(other, sizeof other, "%d", 2 * atoi(word));
    }
    change(reading, at, length, other);
}

// The other order: the cross product of b and a.
static void change_cross(Reading *reading, size_t at)
{
    char a[MOST_LINE], b[MOST_LINE], other[3 * MOST_LINE];
    int end = 0;
    if (sscanf(reading->line + at, "vec3_cross(%399[^(),], %399[^(),])%n", a, b, &end) != 2 ||
        end == 0)
        return;
    snprintf(other, sizeof other, "vec3_cross(%s, %s)", b, a);
    change(reading, at, (size_t)end, other);
}

static bool change_listed(Reading *reading, size_t at, const char *word, const Slip *slips,
                          size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (strcmp(word, slips[i].word) != 0)
            continue;
        for (int k = 0; k < 3 && slips[i].slips[k] != NULL; k++)
            change(reading, at, strlen(word), slips[i].slips[k]);
        return true;
    }
    return false;
}

static void change_word(Reading *reading, size_t at, const char *word, bool is_field)
{
    const size_t fields = sizeof slips_of_fields / sizeof slips_of_fields[0],
                 words = sizeof slips_of_words / sizeof slips_of_words[0];
    if ((is_field && change_listed(reading, at, word, slips_of_fields, fields)) ||
        change_listed(reading, at, word, slips_of_words, words))
        return;
    if (strncmp(word, "CAMERA_", strlen("CAMERA_")) == 0)
        change(reading, at, strlen(word), "CAMERA_NOT_UNIT");
    else if (isdigit((unsigned char)word[0]))
        change_number(reading, at, word);
    else if (strcmp(word, "vec3_cross") == 0)
        change_cross(reading, at);
}

void line_slips(const char *line, void (*say)(const char *slip, void *context), void *context)
{
    Reading reading = {.line = line, .say = say, .context = context};
    char code[MOST_LINE], word[MOST_LINE];
    bool after_point = false;
    snprintf(code, sizeof code, "%s", line);
    char *comment = strstr(code, "//");
    if (comment != NULL)
        *comment = '\0';
    find_declared(code, reading.declared);
    for (size_t at = strspn(code, " \t"); code[at] != '\0'; at += strspn(code + at, " \t")) {
        snprintf(word, sizeof word, "%.*s", (int)length_of_word(code + at), code + at);
        change_word(&reading, at, word, after_point);
        after_point = strcmp(word, ".") == 0;
        at += strlen(word);
    }
    for (int i = 0; i < reading.count; i++)
        free(reading.said[i]);
}
