// label_places.h - the places where one label of a figure may be, cheap ones first.
//
// A place has a cost: how far it is from what the label names, and a fine for each thing it meets.
// (What the other labels add to that is in labels.c.) A label has hundreds of places, and one of
// the first twenty is taken nearly always. So all of them have a lower bound, which is quickly
// computed, and a place gets its cost when places of that cost are asked for.
#ifndef COMMON_FIGURE_LABEL_PLACES_H
#define COMMON_FIGURE_LABEL_PLACES_H

#include "common/figure/labels.h"

#include <stddef.h>

// In units of the canvas: between a label and what is drawn, and between two labels; how far from
// what it names a label may be without a leader, and between a leader and its text.
enum { CLEAR = 4, APART = 9, LEADER_FROM = 26, LEADER_GAP = 3 };

// What meeting something costs, in units of the canvas, as distances cost. A leader costs
// something, and more if it crosses lines.
enum { FINE = LABEL_FINE, LEADER = 50 };

// Lower bounds are lower by so much, because of rounding.
#define SLACK 1e-6

typedef struct {
    Spot middle;
    Spot start, end; // of its leader
    double cost;
    int number;
    bool leads;
} Place;

// A place without its cost.
typedef struct {
    Spot middle;
    double wish;     // to be elsewhere
    double at_least; // it costs
    int number;
} Candidate;

// From what is so far away, a label there needs a leader, whatever else there is.
enum { SURELY_LEADS = LEADER_FROM + 2 * LEADER_GAP };

// Where a label may be around the spots that it names, in 16 directions, ever farther away.
enum { DIRECTIONS = 16, GAPS = 10, SPOTS = 7 };
typedef struct {
    Spot by[DIRECTIONS][GAPS];
    // The label named a line: at least so far are its boxes from the line, and so far they are
    // along it, where they are 'wide'.
    double beside[DIRECTIONS][GAPS], along[DIRECTIONS][GAPS];
    double length, wide;
    Spot spots[SPOTS];
    double parts[SPOTS], wishes[SPOTS];
    int count;                             // of spots
    unsigned char next[SPOTS][DIRECTIONS]; // those before are candidates
} Around;

// Places anywhere in the area, in rows and columns. Those in a part of them, from the first column
// to before the last one, are candidates.
typedef struct {
    double *us, *vs;
    int columns, rows, first_number;
    int left, right, top, bottom;
} Lattice;

typedef struct {
    Around around;
    Lattice lattice;
    Candidate *candidates;
    int candidate_count, candidate_room;
    Place *list; // by cost: all that cost less than 'known'; then others, unordered
    int count, room, ordered;
    double known;
} Places;

typedef struct {
    Spot from, to;
    double radius; // half its width; of a disc, from and to are its middle
    Area around;   // nothing outside meets it
    int first_row;
} Drawn;

// The canvas in rows, so that only what is near has to be looked at.
enum { ROWS = 20, ROW_HEIGHT = 28 };

typedef struct {
    Drawn *drawn;
    int count, room;
} Row;

struct Labels {
    Area area;
    Drawn *drawn;
    int drawn_count, drawn_room;
    Row rows[ROWS];
    const Drawn *last_met; // by a place that was tried
    PlacedLabel *labels;
    int count, room;
    Places *places; // of each label
    struct Standing *standing;
};

void *labels_one_more(void *items, int count, int *room, size_t size);

// It names no place.
static inline bool names_nothing(const PlacedLabel *label)
{
    return label->free || label->pinned;
}

// What a candidate costs, if it costs less than 'limit'. Else false, and the candidate knows at
// least how much it costs.
bool find_cost(Labels *labels, int number, Candidate *candidate, double limit, Place *place);

// At least so far is a box from what a label names: quickly computed.
double label_at_least_from(Area box, const PlacedLabel *label);

// Says which places a label has; adds places anywhere on the canvas, 'step' apart; frees them.
void find_places(Labels *labels, int number);
void find_places_anywhere(Labels *labels, int number, double step);
void free_places(Places *places);

// Place 'rank' of a label, from 0 for the cheapest, if it costs less than 'limit'. Else NULL.
const Place *place_below(Labels *labels, int number, int rank, double limit);

#endif
