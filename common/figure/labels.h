// labels.h - where a figure's labels stand: beside what they name, clear of everything else.
//
// All places are on the canvas, in its units, from the lower left. First comes what is drawn: lines
// and discs. Then come labels, each with the place or the stretch that it names. labels_place tries
// places around each of them, near ones first, and keeps those that meet nothing; where none is
// free near by, it takes one farther away and draws a leader, a thin line from the label to what it
// names.
#ifndef COMMON_FIGURE_LABELS_H
#define COMMON_FIGURE_LABELS_H

#include <stdbool.h>

typedef struct {
    double u, v;
} Spot;

// The part of the canvas in which labels may stand; it may be infinite.
typedef struct {
    double left, right, bottom, top;
} Area;

typedef struct {
    Spot from, to;  // what it names: two equal spots, or a stretch, anywhere along it
    double radius;  // or a disc around a spot
    bool free;      // it names no place: it stands where there is room, as near to from as possible
    bool pinned;    // it names no place: it stands at from, and the others keep out of its way
    Spot aside;     // the number of a mark on an axis: in this direction, or in the other one
    bool says_what; // of these, the one that says what they count: it is left out last
    double margin;  // if it is free: at least so far from the left and right of the area
    double width, height; // of its text
    Spot middle;          // where it stands (labels_place)
    bool is_left_out;     // or nowhere: a number of an axis that has no room
    bool leads;           // with a leader, from start to end
    Spot start, end;
} PlacedLabel;

typedef struct Labels Labels;

Labels *labels_new(Area area);
void labels_free(Labels *labels);

// What no label may cover: a line, as wide as it is drawn, and a disc.
void labels_line(Labels *labels, Spot from, Spot to, double width);
void labels_disc(Labels *labels, Spot middle, double radius);

// Returns its number: 0, 1, ...
int labels_add(Labels *labels, PlacedLabel label);

// Places all of them.
void labels_place(Labels *labels);

// How far they are from what they name, with what leaders cost, in units of the canvas; and at
// least LABEL_FINE more for each label that meets another one, or something drawn, or the edge, or
// is nearer to what another one names.
enum { LABEL_FINE = 1000 };
double labels_cost(const Labels *labels);

PlacedLabel labels_get(const Labels *labels, int number);

// How wide a text is in DejaVu Sans of this size. UTF-8.
double labels_text_width(const char *text, double size);

#endif
