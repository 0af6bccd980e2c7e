// nff_plain.c - the plain lines of an NFF file, by all threads that a program lends.
//
// Nearly all lines of a long scene are spheres: 's', four numbers, each after one space, and the
// end of the line. Such a line means the same wherever it is, so the parts of the file can be read
// at the same time. All other lines, and everything that is wrong, are left to nff_entity.c.
#include "common/nff.h"

#include "common/workers.h"

#include <limits.h>
#include <string.h>
#include <unistd.h>

// A thread reads this much text at a time, so that the text stays in its cache. After a line that
// is not plain, the next attempt begins with few bytes, and doubles as long as all lines are plain.
// So little work is done in vain.
enum { WINDOW = NFF_HELD, FIRST_ATTEMPT = 1 << 8 };
// The bytes of the shortest lines: s 0 0 0 1, and f 0 0 0 0 0 0 0 0.
enum { SHORTEST_SPHERE = 10, SHORTEST_FILL = 18 };

// Where a line begins in the file, and where its sphere or fill belongs in the scene.
typedef struct {
    off_t start;
    int sphere, fill;
} Place;

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

// Goes to the first line that is not plain, or to the end.
static const char *read_lines(const char *text, const char *end, Scene *scene, Place *place)
{
    const char *next;
    const char *const first = text;
    int sphere = place->sphere, fill = place->fill;
    double n[8];
    for (; text < end; text = next) {
        if ((next = read_plain(text, 's', 4, n)) != NULL) {
            if (!nff_sphere(n, fill - 1, &scene->spheres[sphere]))
                break;
            sphere++;
        } else {
            if ((next = read_plain(text, 'f', 8, n)) == NULL ||
                !nff_fill(n, &scene->surfaces[fill]))
                break;
            fill++;
        }
    }
    *place = (Place){place->start + (text - first), sphere, fill};
    return text;
}

// The size of the whole lines at the start of a text.
static size_t whole_lines(const char *text, size_t size)
{
    while (size > 0 && text[size - 1] != '\n')
        size--;
    return size;
}

// Room for all spheres and fills that are possible in this many bytes.
static bool make_room(NffReader *reader, int size)
{
    Scene *scene = reader->scene;
    const int spheres = size / SHORTEST_SPHERE, fills = size / SHORTEST_FILL;
    void *for_spheres = nff_room(scene->spheres, scene->sphere_count, spheres, sizeof(Sphere),
                                 reader->least_spheres);
    if (for_spheres != NULL)
        scene->spheres = for_spheres;
    void *for_fills = nff_room(scene->surfaces, scene->surface_count, fills, sizeof(Surface), 0);
    if (for_fills != NULL)
        scene->surfaces = for_fills;
    return ((for_spheres != NULL || spheres == 0) && for_fills != NULL) ||
           nff_wrong(&reader->line, "no memory for more than %d spheres", scene->sphere_count);
}

// All lines before this place were plain.
static void take(NffReader *reader, Place place)
{
    Scene *scene = reader->scene;
    reader->line.number += place.sphere - scene->sphere_count + place.fill - scene->surface_count;
    scene->sphere_count = place.sphere;
    scene->surface_count = place.fill;
}

// By the caller alone. This and read_by_all return false after the first line that is not plain, if
// there are no more lines, and if there is not enough memory.
static bool read_by_one(NffReader *reader, size_t most)
{
    NffLine *line = &reader->line;
    nff_hold(line, most);
    size_t held = (size_t)(line->end - line->next);
    const char *end = line->next + whole_lines(line->next, held < most ? held : most);
    if (end == line->next || !make_room(reader, (int)(end - line->next)))
        return false;
    Place place = {0, reader->scene->sphere_count, reader->scene->surface_count};
    line->next += read_lines(line->next, end, reader->scene, &place) - line->next;
    take(reader, place);
    return line->next == end;
}

// ---- by all threads ---------------------------------------------------------------------------

// The threads take windows of the file in turns. The one whose turn it is reads a window, and
// counts its spheres and fills. So the next one knows where its own belong, before the numbers are
// read.
typedef struct {
    int file;
    Scene *scene;
    int most_spheres, most_fills; // how many the scene has room for
    Place next;                   // of the next window
    Place stop;                   // of the first line that is known not to be plain
    bool stopped;                 // there is one
} Turns;

// How many lines begin with this letter. text[-1] is the end of the line before. The sum of a block
// fits in a byte, so compilers make vectors of the inner loop.
static int count_lines(const char *text, size_t size, char letter)
{
    enum { BLOCK = 128 };
    int count = 0;
    for (; size >= BLOCK; size -= BLOCK, text += BLOCK) {
        unsigned char some = 0;
        for (int i = 0; i < BLOCK; i++)
            some = (unsigned char)(some + ((text[i] == letter) & (text[i - 1] == '\n')));
        count += some;
    }
    for (; size > 0; size--, text++)
        count += text[0] == letter && text[-1] == '\n';
    return count;
}

// What one of the threads reads.
typedef struct {
    Turns *turns;
    char *window;
    size_t size; // of the whole lines in it; 0 if there are none, or no room for them
    Place place; // of the first line; then of the first one that is not plain, or of the end
} Reading;

static void read_window(void *given)
{
    Reading *reading = given;
    Turns *turns = reading->turns;
    const Place place = reading->place = turns->next;
    reading->size = 0;
    if (turns->stopped)
        return;
    ssize_t held = pread(turns->file, reading->window, WINDOW, place.start);
    size_t size = whole_lines(reading->window, held > 0 ? (size_t)held : 0);
    Place next = {place.start + (off_t)size, place.sphere + count_lines(reading->window, size, 's'),
                  place.fill + count_lines(reading->window, size, 'f')};
    if (next.sphere > turns->most_spheres || next.fill > turns->most_fills)
        return;
    turns->next = next;
    reading->size = size;
}

static void stop(void *given)
{
    Turns *turns = ((Reading *)given)->turns;
    const Place place = ((Reading *)given)->place;
    if (!turns->stopped || place.start < turns->stop.start)
        turns->stop = place;
    turns->stopped = true;
}

static void read_windows(void *given, int thread)
{
    (void)thread;
    char held[1 + WINDOW + NUMBER_PADDING] = "\n";
    Reading reading = {.turns = given, .window = held + 1};
    do {
        workers_one_at_a_time(read_window, &reading);
        const char *end = reading.window + reading.size;
        if (read_lines(reading.window, end, reading.turns->scene, &reading.place) < end)
            workers_one_at_a_time(stop, &reading);
    } while (reading.size > 0);
}

// The room that make_room has made, or less: lines can still be counted.
static int most_of(int count, int more, size_t least)
{
    const size_t room = nff_room_of((size_t)count + (size_t)more, least);
    const int most = count + INT_MAX / 8;
    return room < (size_t)most ? (int)room : most;
}

static bool read_by_all(NffReader *reader)
{
    NffLine *line = &reader->line;
    Scene *scene = reader->scene;
    if (!make_room(reader, WINDOW))
        return false;
    const Place first = {nff_tell(line), scene->sphere_count, scene->surface_count};
    Turns turns = {.file = fileno(line->file),
                   .scene = scene,
                   .most_spheres =
                       most_of(first.sphere, WINDOW / SHORTEST_SPHERE, reader->least_spheres),
                   .most_fills = most_of(first.fill, WINDOW / SHORTEST_FILL, 0),
                   .next = first};
    workers_do(workers_count(), read_windows, &turns);
    const Place last = turns.stopped ? turns.stop : turns.next;
    take(reader, last);
    return nff_seek(line, last.start) && !turns.stopped && last.start > first.start;
}

bool nff_plain_lines(NffReader *reader)
{
    const NffLine *line = &reader->line;
    const bool by_all = workers_count() > 1 && reader->file_size > 0;
    size_t size = FIRST_ATTEMPT;
    while (line->number < INT_MAX / 2) {
        const bool long_enough =
            by_all && size == WINDOW && reader->file_size - nff_tell(line) > WINDOW;
        if (!(long_enough ? read_by_all(reader) : read_by_one(reader, size)))
            break;
        size = size < WINDOW ? 2 * size : WINDOW;
    }
    return !line->failed;
}
