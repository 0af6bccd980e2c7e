// nff_view.c - the viewpoint of an NFF file: where the picture is taken from, in seven lines.
#include "common/nff.h"

#include <string.h>

// The lines of a viewpoint; each must occur once.
enum { FROM = 1, AT = 2, UP = 4, ANGLE = 8, HITHER = 16, RESOLUTION = 32 };
static const struct {
    const char *word;
    int part;
} view_parts[] = {{"from", FROM},   {"at", AT},         {"up", UP},
                  {"angle", ANGLE}, {"hither", HITHER}, {"resolution", RESOLUTION}};
enum { VIEW_PARTS = sizeof view_parts / sizeof view_parts[0] };

bool nff_view(NffReader *reader)
{
    if (reader->view_line != 0)
        return nff_wrong(&reader->line, "a second viewpoint, the first is in line %d",
                         reader->view_line);
    reader->view_line = reader->line.number;
    return nff_numbers(&reader->line, "v, and nothing else", 0, 0, NULL);
}

static bool read_angle(NffLine *line, double *angle)
{
    if (!nff_numbers(line, "angle DEGREES", 1, 1, angle))
        return false;
    if (*angle <= 0 || *angle >= 180)
        return nff_wrong(line, "an angle of %g degrees, expected more than 0 and less than 180",
                         *angle);
    return true;
}

static bool read_resolution(NffLine *line, Resolution *size)
{
    double n[2];
    if (!nff_numbers(line, "resolution WIDTH HEIGHT", 2, 2, n))
        return false;
    for (int i = 0; i < 2; i++)
        if (n[i] != floor(n[i]) || n[i] < 1 || n[i] > IMAGE_MAX_SIDE)
            return nff_wrong(line, "a resolution of %g, expected a whole number from 1 to %d", n[i],
                             IMAGE_MAX_SIDE);
    *size = (Resolution){(int)n[0], (int)n[1]};
    return true;
}

int nff_view_part(const char *word)
{
    for (int i = 0; i < VIEW_PARTS; i++)
        if (strcmp(word, view_parts[i].word) == 0)
            return view_parts[i].part;
    return 0;
}

bool nff_read_view_part(NffReader *reader, int part)
{
    Viewpoint *view = &reader->scene->view;
    NffLine *line = &reader->line;
    if (reader->view_line == 0)
        return nff_wrong(line, "'%s' outside a viewpoint, expected 'v' before it", line->words[0]);
    if (reader->view_parts & part)
        return nff_wrong(line, "a second '%s' in one viewpoint", line->words[0]);
    reader->view_parts |= part;
    double hither;
    switch (part) {
    case FROM:
        return nff_vec3(line, "from X Y Z", &view->from);
    case AT:
        return nff_vec3(line, "at X Y Z", &view->at);
    case UP:
        return nff_vec3(line, "up X Y Z", &view->up);
    case ANGLE:
        return read_angle(line, &view->angle);
    case RESOLUTION:
        return read_resolution(line, &view->resolution);
    default:
        return nff_numbers(line, "hither DISTANCE", 1, 1, &hither);
    }
}

bool nff_view_is_complete(NffReader *reader)
{
    NffLine *line = &reader->line;
    if (reader->view_line == 0)
        return nff_wrong(line, "the end of the file, expected a viewpoint 'v' somewhere");
    for (int i = 0; i < VIEW_PARTS; i++) {
        if (view_parts[i].part == HITHER || (reader->view_parts & view_parts[i].part) != 0)
            continue;
        line->number = reader->view_line;
        return nff_wrong(line,
                         "a viewpoint without '%s', expected from, at, up, angle, "
                         "hither and resolution",
                         view_parts[i].word);
    }
    return true;
}
