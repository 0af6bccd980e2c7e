// report.c - the judge's findings, as lines for a program.
#include "tests/judge/report.h"

#include "tests/course/entries.h"
#include "tests/judge/exercise.h"
#include "tests/judge/process_transport.h"

#include <string.h>

static const char *state_of(const char *function, const Record *record)
{
    return strcmp(record->missing, function) == 0 ? "unanswered"
           : record->missing[0] != '\0'           ? "waiting"
           : record->ended == HOW_TIMED_OUT       ? "timed out"
           : record->ended == HOW_CRASHED         ? "crashed"
                                                  : "wrong";
}

static void put_calls(FILE *out, int exercise)
{
    char names[4000] = "";
    size_t length = 0;
    for (int other = 0; exercises[other].name != NULL; other++)
        if (other != exercise && call_has_entered(exercise, other) && length < sizeof names)
            length += (size_t)snprintf(names + length, sizeof names - length, "%s%s",
                                       length > 0 ? " " : "", exercises[other].name);
    entry_put(out, "calls", names);
}

void report_function(FILE *out, const char *function, const Outcome *failed, Diagnosis diagnosis)
{
    entry_put(out, "function", function);
    if (failed == NULL) {
        entry_put(out, "state", "right");
        put_calls(out, exercise_number(function));
        return;
    }
    const Record *record = failed->record;
    entry_put(out, "state", state_of(function, record));
    entry_put(out, "test", failed->name);
    if (record->hidden) {
        entry_put(out, "hidden", "yes");
    } else {
        entry_put(out, "given", record->given);
        entry_put(out, "expected", record->expected);
        entry_put(out, "yours", record->missing[0] == '\0' ? record->yours : "");
    }
    if (!record->hidden)
        entry_put(out, "printed", record->printed);
    char number[20];
    snprintf(number, sizeof number, "%d", record->cases);
    entry_put(out, "case", number);
    entry_put(out, "missing", record->missing);
    entry_put(out, "how", record->expected[0] == '\0' ? failed->how : "");
    if (diagnosis.mistake != NULL) {
        entry_put(out, "mistake", diagnosis.mistake->id);
        entry_put(out, "formula", diagnosis.mistake->formula);
        entry_put(out, "why", diagnosis.mistake->why);
        entry_put(out, "picture", diagnosis.mistake->picture);
        entry_put(out, "partly", diagnosis.in_part ? "yes" : "");
        if (diagnosis.other != NULL) {
            entry_put(out, "also formula", diagnosis.other->formula);
            entry_put(out, "also why", diagnosis.other->why);
        }
    }
    entry_put(out, "law", diagnosis.law != NULL ? diagnosis.law : "");
    put_calls(out, exercise_number(function));
}

void report_extra(FILE *out, const Outcome *failed)
{
    entry_put(out, "extra", failed == NULL ? "right" : "wrong");
}
