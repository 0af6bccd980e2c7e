// nff.h - an NFF file becomes a scene: what scene.c, nff_entity.c and nff_view.c share.
#ifndef COMMON_NFF_H
#define COMMON_NFF_H

#include "common/nff_line.h"
#include "common/scene.h"

typedef struct {
    NffLine line;
    Scene *scene;
    int view_line;       // where v stands; 0 before it
    int view_parts;      // which of its lines were there
    int cones, polygons; // that the toolkit has no use for
} NffReader;

// Reads all lines of the file. False where one is wrong: nff_wrong has said so.
bool nff_entities(NffReader *reader);

// ---- the viewpoint ----------------------------------------------------------------------------

bool nff_view(NffReader *reader);

// Which line of the viewpoint a word begins: from, at, up and so on. 0: none.
int nff_view_part(const char *word);
bool nff_read_view_part(NffReader *reader, int part);

// At the end of the file: was there a viewpoint, and all of it?
bool nff_view_is_complete(NffReader *reader);

#endif
