// entries.c - lines of KEY tab VALUE.
#include "tests/course/entries.h"

#include "tests/course/whole_text.h"

#include <stdlib.h>
#include <string.h>

void entry_put(FILE *out, const char *key, const char *value)
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

static int hex_digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

// In place, which never needs more room. False if a \ is followed by what entry_put does not write.
static bool decode(char *value)
{
    char *to = value;
    for (const char *from = value; *from != '\0';) {
        if (*from != '\\') {
            *to++ = *from++;
        } else if (from[1] == 'n' || from[1] == 't' || from[1] == '\\') {
            *to++ = from[1] == 'n' ? '\n' : from[1] == 't' ? '\t' : '\\';
            from += 2;
        } else if (from[1] == 'x' && hex_digit(from[2]) >= 0 && hex_digit(from[3]) >= 0) {
            *to++ = (char)(hex_digit(from[2]) * 16 + hex_digit(from[3]));
            from += 4;
        } else {
            return false;
        }
    }
    *to = '\0';
    return true;
}

bool entries_read(const char *path, Entries *entries)
{
    size_t size;
    *entries = (Entries){.text = whole_text(path, &size)};
    if (entries->text == NULL || memchr(entries->text, '\0', size) != NULL)
        return false;
    int lines = 0;
    for (const char *c = entries->text; *c != '\0'; c++)
        lines += *c == '\n';
    entries->entries = calloc((size_t)lines + 1, sizeof *entries->entries);
    if (entries->entries == NULL)
        return false;
    for (char *line = entries->text; *line != '\0';) {
        char *end = strchr(line, '\n'), *tab = strchr(line, '\t');
        if (end == NULL || tab == NULL || tab > end)
            return false;
        *end = *tab = '\0';
        if (!decode(tab + 1))
            return false;
        entries->entries[entries->count++] = (Entry){line, tab + 1};
        line = end + 1;
    }
    return true;
}

void entries_free(Entries *entries)
{
    free(entries->text);
    free(entries->entries);
    *entries = (Entries){0};
}

const char *entry_value(const Entry *entries, int count, const char *key)
{
    for (int i = 0; i < count; i++)
        if (strcmp(entries[i].key, key) == 0)
            return entries[i].value;
    return "";
}
