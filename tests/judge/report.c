// report.c - what the judge found, as lines for a program.
#include "tests/judge/report.h"

#include <string.h>

static void put(FILE *out, const char *key, const char *value)
{
    if (value == NULL || value[0] == '\0')
        return;
    fprintf(out, "%s\t", key);
    for (const char *c = value; *c != '\0'; c++) {
        if (*c == '\n' || *c == '\t' || *c == '\\')
            fprintf(out, "\\%c", *c == '\n' ? 'n' : *c == '\t' ? 't' : '\\');
        else if (*c >= ' ' && *c < 127)
            putc(*c, out);
        else
            fprintf(out, "\\x%02x", (unsigned char)*c);
    }
    putc('\n', out);
}

static const char *state_of(const char *function, const Record *record)
{
    return strcmp(record->missing, function) == 0 ? "unanswered"
           : record->missing[0] != '\0'           ? "waiting"
           : record->ended == HOW_TIMED_OUT       ? "timed out"
           : record->ended == HOW_CRASHED         ? "crashed"
                                                  : "wrong";
}

void report_function(FILE *out, const char *function, const Outcome *failed, Diagnosis diagnosis)
{
    put(out, "function", function);
    if (failed == NULL) {
        put(out, "state", "right");
        return;
    }
    const Record *record = failed->record;
    put(out, "state", state_of(function, record));
    put(out, "test", failed->name);
    if (record->hidden) {
        put(out, "hidden", "yes");
    } else {
        put(out, "given", record->given);
        put(out, "expected", record->expected);
        put(out, "yours", record->missing[0] == '\0' ? record->yours : "");
    }
    put(out, "missing", record->missing);
    put(out, "how", record->expected[0] == '\0' ? failed->how : "");
    if (diagnosis.mistake != NULL) {
        put(out, "mistake", diagnosis.mistake->id);
        put(out, "formula", diagnosis.mistake->formula);
        put(out, "why", diagnosis.mistake->why);
        put(out, "picture", diagnosis.mistake->picture);
        put(out, "partly", diagnosis.in_part ? "yes" : "");
        if (diagnosis.other != NULL) {
            put(out, "also formula", diagnosis.other->formula);
            put(out, "also why", diagnosis.other->why);
        }
    }
    put(out, "law", diagnosis.law != NULL ? diagnosis.law : "");
}
