// nff_plain.c - the plain lines of an NFF file, in parts, by the threads that a program lends.
//
// Nearly all lines of a long scene are spheres: 's', four numbers, each after one space, and the
// end of the line. Such a line means the same wherever it is, so the parts of the file can be read
// at the same time. All other lines, and everything that is wrong, are left to nff_entity.c.
#include "common/nff.h"

#include "common/workers.h"

#include <limits.h>
#include <string.h>

// A part is at most this many bytes. After a line that is not plain, the next attempt begins with
// few bytes, and doubles as long as all lines are plain. So little work is done in vain.
enum { PART = 1 << 16, MOST_PARTS = 32, FIRST_ATTEMPT = 1 << 8 };
// The bytes of the shortest lines: s 0 0 0 1, and f 0 0 0 0 0 0 0 0.
enum { SHORTEST_SPHERE = 10, SHORTEST_FILL = 18 };

typedef struct {
    const char *text, *end; // whole lines; later the first one that is not plain
    Scene *scene;
    int first_sphere, first_fill;        // where they belong in it
    int lines, sphere_count, fill_count; // first all that look so, then those that were read
} Part;

// A loop over the lines: the one after this.
static const char *next_line(const Part *part, const char *text)
{
    const char *stop = memchr(text, '\n', (size_t)(part->end - text));
    return stop == NULL ? part->end : stop + 1;
}

static void count_lines(void *given, int i)
{
    Part *part = (Part *)given + i;
    for (const char *text = part->text; text < part->end; text = next_line(part, text)) {
        part->sphere_count += *text == 's';
        part->fill_count += *text == 'f';
    }
}

// Reads a plain line of this letter and this count of numbers. Returns the next line, or NULL.
static const char *read_plain(const char *line, char letter, int count, double *numbers)
{
    const char *text = line;
    if (*text++ != letter)
        return NULL;
    for (int i = 0; i < count; i++)
        if (*text != ' ' || (text = read_padded_number(text + 1, &numbers[i])) == NULL)
            return NULL;
    return *text == '\n' && text - line <= NFF_LONGEST_LINE ? text + 1 : NULL;
}

static void read_lines(void *given, int i)
{
    Part *part = (Part *)given + i;
    double n[8];
    part->sphere_count = part->fill_count = 0;
    while (part->text < part->end) {
        int fill = part->first_fill + part->fill_count;
        const char *next = read_plain(part->text, 's', 4, n);
        if (next != NULL &&
            nff_sphere(n, fill - 1, &part->scene->spheres[part->first_sphere + part->sphere_count]))
            part->sphere_count++;
        else if (next == NULL && (next = read_plain(part->text, 'f', 8, n)) != NULL &&
                 nff_fill(n, &part->scene->surfaces[fill]))
            part->fill_count++;
        else
            return;
        part->text = next;
        part->lines++;
    }
}

// Cuts the text into parts at the ends of lines.
static int cut(const char *text, const char *end, Part *parts)
{
    int count = 0;
    while (text < end) {
        Part *part = &parts[count++];
        *part = (Part){.text = text, .end = end};
        if (end - text > PART)
            part->end = next_line(part, text + PART - NFF_LONGEST_LINE);
        text = part->end;
    }
    return count;
}

// The parts know where their spheres and fills belong, if all are plain.
static bool make_room(NffReader *reader, Part *parts, int count)
{
    Scene *scene = reader->scene;
    int spheres = 0, fills = 0;
    for (int i = 0; i < count; i++) {
        spheres += parts[i].sphere_count;
        fills += parts[i].fill_count;
    }
    void *for_spheres = nff_room(scene->spheres, scene->sphere_count, spheres, sizeof(Sphere),
                                 reader->least_spheres);
    if (for_spheres != NULL)
        scene->spheres = for_spheres;
    void *for_fills = nff_room(scene->surfaces, scene->surface_count, fills, sizeof(Surface), 0);
    if (for_fills != NULL)
        scene->surfaces = for_fills;
    if ((for_spheres == NULL && spheres > 0) || for_fills == NULL)
        return nff_wrong(&reader->line, "no memory for more than %d spheres", scene->sphere_count);
    spheres = scene->sphere_count;
    fills = scene->surface_count;
    for (int i = 0; i < count; i++) {
        parts[i].scene = scene;
        parts[i].first_sphere = spheres;
        parts[i].first_fill = fills;
        spheres += parts[i].sphere_count;
        fills += parts[i].fill_count;
    }
    return true;
}

// Takes the parts up to the first line that is not plain.
static void take(NffReader *reader, const Part *parts, int count)
{
    for (int i = 0; i < count; i++) {
        reader->line.number += parts[i].lines;
        reader->line.next += parts[i].text - reader->line.next;
        reader->scene->sphere_count += parts[i].sphere_count;
        reader->scene->surface_count += parts[i].fill_count;
        if (parts[i].text < parts[i].end)
            return;
    }
}

// The end of the last whole line among this many bytes; the start of them if there is none.
static const char *whole_lines(const NffLine *line, size_t size)
{
    size_t held = (size_t)(line->end - line->next);
    const char *end = line->next + (held < size ? held : size);
    while (end > line->next && end[-1] != '\n')
        end--;
    return end;
}

bool nff_plain_lines(NffReader *reader)
{
    // A part is at least PART less one line. One thread reads one part after the other: then the
    // text stays in the cache, and nobody has to count lines to know where its spheres belong.
    const int most_parts = workers_count() > 1 ? MOST_PARTS : 1;
    const size_t most = (size_t)most_parts * (PART - 2 * NFF_LONGEST_LINE);
    NffLine *line = &reader->line;
    Part parts[MOST_PARTS + 1];
    for (size_t attempt = FIRST_ATTEMPT;; attempt = 2 * attempt < most ? 2 * attempt : most) {
        nff_hold(line, attempt);
        const char *end = whole_lines(line, attempt);
        if (end == line->next || line->number > INT_MAX / 2)
            return true;
        int count = cut(line->next, end, parts);
        if (count > 1) {
            workers_do(count, count_lines, parts);
        } else {
            parts->sphere_count = (int)(end - line->next) / SHORTEST_SPHERE;
            parts->fill_count = (int)(end - line->next) / SHORTEST_FILL;
        }
        if (!make_room(reader, parts, count))
            return false;
        workers_do(count, read_lines, parts);
        take(reader, parts, count);
        if (line->next < end)
            return true;
    }
}
