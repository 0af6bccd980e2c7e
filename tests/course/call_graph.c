// call_graph.c - which answers fail perhaps only because another one that they call is not right.
#include "tests/course/call_graph.h"

#include <string.h>

bool names_include(const char *names, const char *name)
{
    size_t length = strlen(name);
    for (const char *word = names + strspn(names, " "); *word != '\0'; word += strspn(word, " ")) {
        size_t size = strcspn(word, " ");
        if (size == length && strncmp(word, name, length) == 0)
            return true;
        word += size;
    }
    return false;
}

static void add(char names[MOST_NAMES], const char *name)
{
    size_t length = strlen(names);
    if (length + strlen(name) + 2 <= MOST_NAMES)
        snprintf(names + length, MOST_NAMES - length, "%s%s", length > 0 ? " " : "", name);
}

void names_that_may_excuse(const ChapterRecord *record, const FunctionRecord *wrong,
                           char names[MOST_NAMES])
{
    names[0] = '\0';
    const char *calls = function_value(wrong, "calls");
    for (int i = 0; i < record->function_count; i++) {
        const FunctionRecord *other = &record->functions[i];
        if (other != wrong && strcmp(function_state(other), "right") != 0 &&
            names_include(calls, other->name) &&
            !names_include(function_value(other, "calls"), wrong->name))
            add(names, other->name);
    }
}

void names_not_right(const ChapterRecord *earlier, const char *calls, const char *const *exercises,
                     char names[MOST_NAMES])
{
    names[0] = '\0';
    for (; *exercises != NULL; exercises++) {
        const FunctionRecord *function = record_function(earlier, *exercises);
        if ((function == NULL || strcmp(function_state(function), "right") != 0) &&
            names_include(calls, *exercises))
            add(names, *exercises);
    }
}
