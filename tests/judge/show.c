// show.c - one call of a test in words.
#include "tests/judge/show.h"

#include <string.h>

static void show_given(const Page *page, const char *given)
{
    while (*given != '\0') {
        char label[64], value[1300];
        int used = 0;
        if (sscanf(given, "%63[^\t]\t%1299[^\n]\n%n", label, value, &used) != 2)
            return;
        page_field(page, PLAIN, label, value);
        given += used;
    }
}

void show_call(const Page *page, const ShownCall *call)
{
    const char *yours = call->missing[0] != '\0' ? "not answered yet" : call->yours;
    if (call->hidden) {
        page_field(page, PLAIN, "given", "random numbers of this run, not shown");
        if (call->missing[0] != '\0')
            page_field(page, RED, "yours", yours);
        else if (call->expected[0] == '\0' && call->how[0] != '\0')
            page_field(page, RED, "it", call->how);
        return;
    }
    show_given(page, call->given);
    if (call->expected[0] != '\0') {
        page_field(page, GREEN, "expected", call->expected);
        page_field(page, RED, "yours", yours);
    } else {
        page_field(page, RED, "it", call->how);
    }
    page_printed(page, "it printed", call->printed);
}

void show_outcome(FILE *out, const Outcome *outcome)
{
    enum { COLUMNS = 79 };
    const Record *record = outcome->record;
    show_call(&(Page){out, COLUMNS, false},
              &(ShownCall){record->hidden, record->given, record->expected, record->yours,
                           record->missing, outcome->how, record->printed});
}
