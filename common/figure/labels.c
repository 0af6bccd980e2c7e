// labels.c - where a figure's labels stand.
//
// A label has hundreds of places: around what it names, or anywhere. A place has a cost: how far it
// is from what the label names, and a fine for each thing it meets. Each label in turn takes the
// cheapest of its places while the others stay where they are, until none moves.
#include "common/figure/labels.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

// In units of the canvas: between a label and what is drawn, and between two labels; how far from
// what it names a label may be without a leader, between a leader and its text, and how short a
// leader may be; by how much a label is nearer to what it names than to what another one names.
enum { CLEAR = 4, APART = 9, LEADER_FROM = 26, LEADER_GAP = 3, LEADER_LEAST = 8, CLEARLY = 3 };

// What meeting something costs, in units of the canvas, as distances cost; a leader, and each line
// that it crosses.
enum { FINE = LABEL_FINE, LEADER = 50, LEADER_CROSSES = 15 };

// What the number of a mark costs on the other side of its axis, and what if it is left out.
enum { OTHER_SIDE = 40, LEFT_OUT = 60, SILENT = 400 };

// Sums of the same numbers may differ by so much, because of rounding.
#define SLACK 1e-6

typedef struct {
    Spot from, to;
    double radius; // half its width; of a disc, from and to are its middle
    Area around;   // nothing outside meets it
} Drawn;

typedef struct {
    Spot middle;
    Spot start, end; // of its leader
    double at_least; // it costs
    double cost;     // if it is known
    int number;
    bool leads, is_known;
} Place;

typedef struct {
    Place *places; // by what they cost at least
    int place_count, room;
    Place taken;
    Area box, all; // and with its leader
} Standing;

struct Labels {
    Area area;
    Drawn *drawn;
    int drawn_count, drawn_room;
    PlacedLabel *labels;
    int count, room;
    Standing *standing; // of each label
};

static void *room_for(int count, size_t size)
{
    void *items = calloc((size_t)count + 1, size);
    if (items == NULL)
        abort();
    return items;
}

static void *one_more(void *items, int count, int *room, size_t size)
{
    if (count < *room)
        return items;
    *room = 2 * *room + 16;
    items = realloc(items, (size_t)*room * size);
    if (items == NULL)
        abort();
    return items;
}

// ---- boxes, spots and lines ---------------------------------------------------------------------

// Of numbers, never of NaN: fmin and fmax take several times as long.
static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static Area box_of(const PlacedLabel *label, Spot middle)
{
    return (Area){middle.u - label->width / 2, middle.u + label->width / 2,
                  middle.v - label->height / 2, middle.v + label->height / 2};
}

static Area grown(Area box, double by)
{
    return (Area){box.left - by, box.right + by, box.bottom - by, box.top + by};
}

static bool overlap(Area a, Area b)
{
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

static Spot between(Spot from, Spot to, double part)
{
    return (Spot){from.u + part * (to.u - from.u), from.v + part * (to.v - from.v)};
}

static double spots_apart(Spot a, Spot b)
{
    return sqrt((a.u - b.u) * (a.u - b.u) + (a.v - b.v) * (a.v - b.v));
}

// From the box to a spot, to the right or left and up or down; 0 inside.
static Spot aside(Area box, Spot spot)
{
    return (Spot){larger(0, larger(box.left - spot.u, spot.u - box.right)),
                  larger(0, larger(box.bottom - spot.v, spot.v - box.top))};
}

static double away(Area box, Spot spot)
{
    Spot by = aside(box, spot);
    return sqrt(by.u * by.u + by.v * by.v);
}

// The part of a line between low and high in one direction: narrows first .. last, and is false if
// nothing is left.
static bool cut(double from, double to, double low, double high, double *first, double *last)
{
    double d = to - from;
    if (d == 0)
        return from >= low && from <= high;
    double a = (low - from) / d, b = (high - from) / d;
    *first = larger(*first, smaller(a, b));
    *last = smaller(*last, larger(a, b));
    return *first <= *last;
}

static bool beyond(double a, double b, double low, double high)
{
    return (a < low && b < low) || (a > high && b > high);
}

static bool crosses(Area box, Spot from, Spot to)
{
    if (beyond(from.u, to.u, box.left, box.right) || beyond(from.v, to.v, box.bottom, box.top))
        return false;
    double first = 0, last = 1;
    return cut(from.u, to.u, box.left, box.right, &first, &last) &&
           cut(from.v, to.v, box.bottom, box.top, &first, &last);
}

// How near a line comes to a spot, and where.
static Spot nearest_on(Spot from, Spot to, Spot spot)
{
    double u = to.u - from.u, v = to.v - from.v, long2 = u * u + v * v;
    double part = long2 > 0 ? ((spot.u - from.u) * u + (spot.v - from.v) * v) / long2 : 0;
    return between(from, to, smaller(1, larger(0, part)));
}

// From the box to a line: between two that do not meet, one of the corners or one of the ends is
// nearest.
static double distance(Area box, Spot from, Spot to)
{
    if (from.u == to.u && from.v == to.v)
        return away(box, from);
    if (crosses(box, from, to))
        return 0;
    const Spot corners[] = {
        {box.left, box.bottom}, {box.right, box.bottom}, {box.left, box.top}, {box.right, box.top}};
    double least = smaller(away(box, from), away(box, to));
    for (int i = 0; i < 4; i++)
        least = smaller(least, spots_apart(nearest_on(from, to, corners[i]), corners[i]));
    return least;
}

static Area with(Area area, Spot spot)
{
    return (Area){smaller(area.left, spot.u), larger(area.right, spot.u),
                  smaller(area.bottom, spot.v), larger(area.top, spot.v)};
}

// On which side of the line from a to b is c?
static double side(Spot a, Spot b, Spot c)
{
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// ---- what there is ------------------------------------------------------------------------------

Labels *labels_new(Area area)
{
    Labels *labels = room_for(1, sizeof *labels);
    labels->area = area;
    return labels;
}

void labels_free(Labels *labels)
{
    for (int i = 0; labels->standing != NULL && i < labels->count; i++)
        free(labels->standing[i].places);
    free(labels->standing);
    free(labels->drawn);
    free(labels->labels);
    free(labels);
}

void labels_line(Labels *labels, Spot from, Spot to, double width)
{
    if (!isfinite(from.u) || !isfinite(from.v) || !isfinite(to.u) || !isfinite(to.v))
        return;
    labels->drawn =
        one_more(labels->drawn, labels->drawn_count, &labels->drawn_room, sizeof(Drawn));
    Area ends = with((Area){from.u, from.u, from.v, from.v}, to);
    labels->drawn[labels->drawn_count++] =
        (Drawn){from, to, width / 2, grown(ends, width / 2 + CLEAR + SLACK)};
}

void labels_disc(Labels *labels, Spot middle, double radius)
{
    labels_line(labels, middle, middle, 2 * radius);
}

int labels_add(Labels *labels, PlacedLabel label)
{
    labels->labels = one_more(labels->labels, labels->count, &labels->room, sizeof(PlacedLabel));
    label.middle = label.from;
    label.leads = false;
    labels->labels[labels->count] = label;
    return labels->count++;
}

PlacedLabel labels_get(const Labels *labels, int number)
{
    return labels->labels[number];
}

// ---- what a place costs, whatever the other labels do -------------------------------------------

static bool names_nothing(const PlacedLabel *label)
{
    return label->free || label->pinned;
}

static bool is_of_axis(const PlacedLabel *label)
{
    return label->aside.u != 0 || label->aside.v != 0;
}

// From the box to what a label names.
static double from_named(Area box, const PlacedLabel *label)
{
    return larger(0, distance(box, label->from, label->to) - label->radius);
}

static bool touch(const PlacedLabel *label, const PlacedLabel *other)
{
    return spots_apart(nearest_on(other->from, other->to, label->from), label->from) < 1;
}

// Is it nearer to what another label names than to what it names itself? (A spot on a line that
// another label names is never nearer than the line.)
static bool is_ambiguous(const Labels *labels, int number, Area box)
{
    const PlacedLabel *label = &labels->labels[number];
    double own = from_named(box, label) + CLEARLY;
    bool is_spot = label->from.u == label->to.u && label->from.v == label->to.v;
    for (int i = 0; i < labels->count; i++) {
        const PlacedLabel *other = &labels->labels[i];
        if (i != number && !names_nothing(other) && from_named(box, other) <= own &&
            !(is_spot && touch(label, other)))
            return true;
    }
    return false;
}

static double outside(Area box, Area area)
{
    double over = larger(larger(area.left - box.left, box.right - area.right),
                         larger(area.bottom - box.bottom, box.top - area.top));
    return over > 0 ? FINE + over : 0;
}

// How much of what is drawn the box meets.
static int count_met(const Labels *labels, Area box)
{
    int met = 0;
    for (int i = 0; i < labels->drawn_count; i++) {
        const Drawn *drawn = &labels->drawn[i];
        met += overlap(drawn->around, box) &&
               crosses(grown(box, CLEAR + drawn->radius), drawn->from, drawn->to);
    }
    return met;
}

// How many lines a leader crosses.
static int crossings(const Labels *labels, Spot start, Spot end)
{
    int count = 0;
    for (int i = 0; i < labels->drawn_count; i++) {
        Spot from = labels->drawn[i].from, to = labels->drawn[i].to;
        count += side(start, end, from) * side(start, end, to) <= 0 &&
                 side(from, to, start) * side(from, to, end) <= 0;
    }
    return count;
}

// One more place. At least it costs its distance; and a leader from its box to the nearest spot of
// what the label names, if that is far.
static void add_place(Labels *labels, int number, Spot middle, double wish, int place_number)
{
    const PlacedLabel *label = &labels->labels[number];
    Standing *standing = &labels->standing[number];
    const Area box = box_of(label, middle), around = grown(box, LEADER_GAP);
    Spot end = nearest_on(label->from, label->to, middle);
    double from_middle = spots_apart(middle, end);
    if (label->radius > 0 && from_middle > label->radius) // the edge of the disc
        end = between(end, middle, label->radius / from_middle);
    Spot start = {smaller(around.right, larger(around.left, end.u)),
                  smaller(around.top, larger(around.bottom, end.v))};
    bool leads =
        !names_nothing(label) && !is_of_axis(label) && spots_apart(end, start) > LEADER_FROM;
    double far = names_nothing(label) ? 0.1 * spots_apart(middle, label->from) : away(box, end);
    standing->places =
        one_more(standing->places, standing->place_count, &standing->room, sizeof(Place));
    standing->places[standing->place_count++] = (Place){
        .middle = middle,
        .start = start,
        .end = end,
        .at_least = wish + far + (leads ? LEADER : 0) + outside(box, labels->area),
        .number = place_number,
        .leads = leads,
    };
}

// All that it costs. It has a leader also if something else is nearer.
static void find_cost(const Labels *labels, int number, Place *place)
{
    const PlacedLabel *label = &labels->labels[number];
    const Area box = box_of(label, place->middle);
    place->cost = place->at_least;
    if (!names_nothing(label) && !place->leads && is_ambiguous(labels, number, box)) {
        place->leads = !is_of_axis(label) && spots_apart(place->end, place->start) > LEADER_LEAST;
        place->cost += place->leads ? LEADER : FINE;
    }
    if (place->leads)
        place->cost += LEADER_CROSSES * crossings(labels, place->start, place->end);
    place->cost += FINE * count_met(labels, box);
    // Of places that cost the same, the first is taken, however a machine rounds.
    const double parts = 1e7;
    place->cost = round(place->cost * parts) / parts;
    place->is_known = true;
}

// ---- the places of a label ----------------------------------------------------------------------

// In 16 directions around spots of what it names, ever farther away.
enum { DIRECTIONS = 16, GAPS = 10, SPOTS = 7 };

static void find_places_around(Labels *labels, int number)
{
    static const double gaps[GAPS] = {6, 10, 16, 24, 36, 52, 74, 104, 144, 190};
    static const double parts[SPOTS] = {0.5, 0.35, 0.65, 0.15, 0.85, 0, 1};
    const PlacedLabel *label = &labels->labels[number];
    const double du = label->width / 2, dv = label->height / 2;
    const bool is_stretch = label->from.u != label->to.u || label->from.v != label->to.v;
    for (int i = 0; i < (is_stretch ? SPOTS : 1); i++)
        for (int g = 0; g < GAPS; g++)
            for (int k = 0; k < DIRECTIONS; k++) {
                Spot spot = between(label->from, label->to, parts[i]);
                Spot direction = {cos(2 * PI * k / DIRECTIONS), sin(2 * PI * k / DIRECTIONS)};
                double u = fabs(direction.u), v = fabs(direction.v), gap = label->radius + gaps[g];
                // The box just touches the circle of this radius around the spot.
                double stretch = smaller(u > 1e-9 ? (du + u * gap) / u : DBL_MAX,
                                         v > 1e-9 ? (dv + v * gap) / v : DBL_MAX);
                Spot middle = {spot.u + stretch * direction.u, spot.v + stretch * direction.v};
                add_place(labels, number, middle, 4 * fabs(parts[i] - 0.5),
                          (i * GAPS + g) * DIRECTIONS + k);
            }
}

// Over its mark, below it, or nowhere.
static void find_places_of_axis(Labels *labels, int number)
{
    enum { GAP = 11 };
    const PlacedLabel *label = &labels->labels[number];
    const Spot nowhere = {-2e6 - 1e4 * number, -2e6}; // each label's own
    const double box =
        fabs(label->aside.u) * label->width / 2 + fabs(label->aside.v) * label->height / 2;
    for (int side = 1; side >= -1; side -= 2) {
        Spot middle = {label->from.u + side * (box + GAP) * label->aside.u,
                       label->from.v + side * (box + GAP) * label->aside.v};
        add_place(labels, number, middle, side > 0 ? 0 : OTHER_SIDE, side);
    }
    add_place(labels, number, nowhere, 0, 2);
    Place *last = &labels->standing[number].places[2];
    last->at_least = last->cost = label->says_what ? SILENT : LEFT_OUT;
    last->is_known = true;
    last->leads = false;
}

static void find_places_anywhere(Labels *labels, int number, double step)
{
    const PlacedLabel *label = &labels->labels[number];
    const Area area = labels->area;
    double du = label->width / 2, dv = label->height / 2;
    // Less of a margin, if there is no room for it.
    du += smaller(label->margin, larger(0, (area.right - area.left) / 2 - du));
    int place_number = SPOTS * GAPS * DIRECTIONS;
    for (double v = area.top - dv; v >= area.bottom + dv; v -= step)
        for (double u = area.left + du; u <= area.right - du; u += step)
            add_place(labels, number, (Spot){u, v}, 0, place_number++);
}

static int by_least_cost(const void *a, const void *b)
{
    const Place *x = a, *y = b;
    return x->at_least < y->at_least ? -1 : x->at_least > y->at_least ? 1 : x->number - y->number;
}

static void sort_places(Standing *standing)
{
    qsort(standing->places, (size_t)standing->place_count, sizeof(Place), by_least_cost);
}

static void find_places(Labels *labels, int number)
{
    enum { EVERYWHERE = 10 };
    const PlacedLabel *label = &labels->labels[number];
    const Area area = labels->area;
    const double u = label->width / 2, v = label->height / 2;
    if (is_of_axis(label))
        find_places_of_axis(labels, number);
    else if (label->free)
        find_places_anywhere(labels, number, EVERYWHERE);
    else if (!label->pinned)
        find_places_around(labels, number);
    // Pinned, or a block of text larger than the canvas: as near as it is on the canvas.
    if (labels->standing[number].place_count == 0)
        add_place(labels, number,
                  (Spot){larger(area.left + u, smaller(area.right - u, label->from.u)),
                         larger(area.bottom + v, smaller(area.top - v, label->from.v))},
                  0, 0);
    sort_places(&labels->standing[number]);
}

// ---- how the labels stand -----------------------------------------------------------------------

static Area with_leader(Area box, const Place *place)
{
    return place->leads ? with(with(box, place->start), place->end) : box;
}

static void put(Labels *labels, int number, Spot middle)
{
    Standing *standing = &labels->standing[number];
    standing->box = box_of(&labels->labels[number], middle);
    standing->all = with_leader(standing->box, &standing->taken);
}

static void stand(Labels *labels, int number, const Place *place)
{
    labels->standing[number].taken = *place;
    put(labels, number, place->middle);
}

// Only their leaders stay.
static void take_away(Labels *labels)
{
    const Spot nowhere = {-1e6, -1e6};
    for (int i = 0; i < labels->count; i++)
        put(labels, i, nowhere);
}

// What the other labels cost it in this place, as they stand.
static double fines_of_labels(const Labels *labels, int number, const Place *place)
{
    const Area box = box_of(&labels->labels[number], place->middle);
    const Area apart = grown(box, APART), clear = grown(box, CLEAR);
    const Area reach = grown(with_leader(box, place), APART + 1);
    double cost = 0;
    for (int i = 0; i < labels->count; i++) {
        const Standing *other = &labels->standing[i];
        const Place *there = &other->taken;
        if (i == number || !overlap(reach, other->all))
            continue;
        cost += overlap(apart, other->box) ? 2 * FINE : 0;
        cost += there->leads && crosses(clear, there->start, there->end) ? FINE : 0;
        cost +=
            place->leads && crosses(grown(other->box, CLEAR), place->start, place->end) ? FINE : 0;
    }
    return cost;
}

static double cost_of(const Labels *labels, int number)
{
    const Place *place = &labels->standing[number].taken;
    return place->cost + fines_of_labels(labels, number, place);
}

double labels_cost(const Labels *labels)
{
    double cost = 0;
    for (int i = 0; i < labels->count; i++)
        cost += cost_of(labels, i);
    return cost;
}

// The cheapest place while the others stay where they are. Most places need no look, because they
// are farther away than that.
static const Place *cheapest(Labels *labels, int number)
{
    const Standing *standing = &labels->standing[number];
    const Place *best = NULL;
    double least = INFINITY;
    for (int i = 0; i < standing->place_count && standing->places[i].at_least - SLACK <= least;
         i++) {
        Place *place = &standing->places[i];
        if (!place->is_known)
            find_cost(labels, number, place);
        if (place->cost > least)
            continue;
        double cost = place->cost + fines_of_labels(labels, number, place);
        bool is_first = best == NULL || place->cost < best->cost ||
                        (place->cost == best->cost && place->number < best->number);
        if (cost < least || (cost == least && is_first)) {
            least = cost;
            best = place;
        }
    }
    return best;
}

// ---- all labels ---------------------------------------------------------------------------------

// Each in turn takes its best place, until none moves: in so many rounds at most.
enum { ROUNDS = 6 };
static void settle(Labels *labels, int rounds)
{
    for (int round = 0, moved = 1; moved && round < rounds; round++) {
        moved = 0;
        for (int i = 0; i < labels->count; i++) {
            const Place *best = cheapest(labels, i);
            moved += best->number != labels->standing[i].taken.number;
            stand(labels, i, best);
        }
    }
}

// One label goes where it would stand if it were alone, and the others make room. Kept if that is
// better.
static void insist(Labels *labels, int number)
{
    Place *before = room_for(labels->count, sizeof *before);
    for (int i = 0; i < labels->count; i++)
        before[i] = labels->standing[i].taken;
    double cost = labels_cost(labels);
    take_away(labels);
    stand(labels, number, cheapest(labels, number));
    for (int i = 0; i < labels->count; i++)
        if (i != number)
            stand(labels, i, cheapest(labels, i));
    settle(labels, 2);
    bool is_better = labels_cost(labels) < cost;
    for (int i = 0; i < labels->count && !is_better; i++)
        stand(labels, i, &before[i]);
    free(before);
}

// A label that meets something may go anywhere, with a leader.
static void scatter(Labels *labels)
{
    enum { EVERYWHERE = 12 };
    bool any = false;
    for (int i = 0; i < labels->count && isfinite(labels->area.right); i++) {
        const PlacedLabel *label = &labels->labels[i];
        if (names_nothing(label) || is_of_axis(label) || cost_of(labels, i) < FINE)
            continue;
        find_places_anywhere(labels, i, EVERYWHERE);
        sort_places(&labels->standing[i]);
        any = true;
    }
    if (any)
        settle(labels, ROUNDS);
}

void labels_place(Labels *labels)
{
    enum { NEAR = 2 * LEADER_FROM };
    labels->standing = room_for(labels->count, sizeof *labels->standing);
    for (int i = 0; i < labels->count; i++) {
        find_places(labels, i);
        labels->standing[i].taken.number = -1;
    }
    take_away(labels);
    settle(labels, ROUNDS);
    for (int i = 0; i < labels->count; i++)
        if (cost_of(labels, i) > NEAR)
            insist(labels, i);
    scatter(labels);
    for (int i = 0; i < labels->count; i++) {
        const Place *taken = &labels->standing[i].taken;
        labels->labels[i].middle = taken->middle;
        labels->labels[i].leads = taken->leads;
        labels->labels[i].is_left_out = is_of_axis(&labels->labels[i]) && taken->number == 2;
        labels->labels[i].start = taken->start;
        labels->labels[i].end = taken->end;
    }
}

// ---- how wide a text is -------------------------------------------------------------------------

// Thousandths of its size, from U+0020 on: DejaVu Sans, in which the figures are drawn.
static const short widths[] = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838,
};

double labels_text_width(const char *text, double size)
{
    enum { OTHERS = 838 }; // minus, times and the like; few are wider
    enum {
        RAISED = 420,
        DOT = 318
    }; // of a power of ten: its digits and minus, and the dot before it
    int thousandths = 0;
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        if (*c >= ' ' && *c < 127)
            thousandths += widths[*c - ' '];
        else if (c[0] == 0xE2 && c[1] == 0x81) // U+2070 and so on
            thousandths += RAISED;
        else if (c[0] == 0xC2 && c[1] == 0xB7 && c[2] == ' ')
            thousandths += DOT;
        else if ((*c & 0xC0) == 0xC0) // the first byte of another character
            thousandths += OTHERS;
    }
    return thousandths / 1000.0 * size;
}
