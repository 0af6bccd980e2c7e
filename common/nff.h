// nff.h - an NFF file becomes a scene: what scene.c and the files nff_*.c share.
#ifndef COMMON_NFF_H
#define COMMON_NFF_H

#include "common/nff_line.h"
#include "common/scene.h"

typedef struct {
    NffLine line;
    Scene *scene;
    off_t file_size;      // 0 if it is not a regular file
    size_t least_spheres; // that there is room for
    int view_line;        // where v stands; 0 before it
    int view_parts;       // which of its lines were there
    int cones, polygons;  // that the toolkit has no use for
} NffReader;

// Reads all lines of the file. False where one is wrong: nff_wrong has said so.
bool nff_entities(NffReader *reader);

// ---- spheres and their fills ------------------------------------------------------------------

// The room of an array with this count of items: a power of two, not less than least.
size_t nff_room_of(size_t count, size_t least);

// Room for more items after count of them, in an array that has always had the same least. NULL if
// there is not enough memory.
void *nff_room(void *items, int count, int more, size_t size, size_t least);

// Spheres and fills of these numbers. False if one is out of range.
bool nff_sphere(const double *numbers, int surface, Sphere *sphere);
bool nff_fill(const double *numbers, Surface *fill);

// Reads the lines of spheres and fills that come next and are plain: each number after one space,
// and nothing wrong. The other lines are left to nff_next. False if there is not enough memory, or
// the file cannot be read.
bool nff_plain_lines(NffReader *reader);

// ---- the viewpoint ----------------------------------------------------------------------------

bool nff_view(NffReader *reader);

// Which line of the viewpoint a word begins: from, at, up and so on. 0: none.
int nff_view_part(const char *word);
bool nff_read_view_part(NffReader *reader, int part);

// At the end of the file: was there a viewpoint, and all of it?
bool nff_view_is_complete(NffReader *reader);

#endif
