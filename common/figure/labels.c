// labels.c - where a figure's labels stand.
//
// A place for a label has a cost: how far it is from what it names, and a fine for each thing it
// meets. Each label in turn takes the cheapest of its places while the others stay where they are,
// until none moves.
#include "common/figure/labels.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

// In units of the canvas: between a label and what is drawn, and between two labels; by how much it
// is nearer to what it names than to what another one names; how far from
// what it names a label may be without a leader, how short one may be, and between it and its text.
enum { CLEAR = 4, APART = 9, CLEARLY = 3, LEADER_FROM = 26, LEADER_LEAST = 8, LEADER_GAP = 3 };

// What meeting something costs, in units of the canvas, as distances cost. A leader costs
// something, and more where it crosses lines.
enum { FINE = LABEL_FINE, LEADER = 50, LEADER_CROSSES = 15 };

typedef struct {
    Spot from, to;
    double radius; // half its width; of a disc, from and to are its middle
    int first_row;
} Drawn;

// The canvas in rows, so that only what is near has to be looked at.
enum { ROWS = 20, ROW_HEIGHT = 28 };

typedef struct {
    int *drawn;
    int count, room;
} Row;

// Where a label may stand, and what that costs, whatever the other labels do.
typedef struct {
    PlacedLabel label;
    double cost;
    int number;
} Place;

typedef struct {
    Place *list;
    int count, room;
    const Place *taken;
} Places;

struct Labels {
    Area area;
    Drawn *drawn;
    int drawn_count, drawn_room;
    Row rows[ROWS];
    PlacedLabel *labels;
    int count, room;
    Places *places; // of each label
};

Labels *labels_new(Area area)
{
    Labels *labels = calloc(1, sizeof *labels);
    if (labels == NULL)
        abort();
    labels->area = area;
    return labels;
}

void labels_free(Labels *labels)
{
    for (int i = 0; labels->places != NULL && i < labels->count; i++)
        free(labels->places[i].list);
    free(labels->places);
    for (int i = 0; i < ROWS; i++)
        free(labels->rows[i].drawn);
    free(labels->drawn);
    free(labels->labels);
    free(labels);
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

// What is above or below the canvas is in the last row on that side.
static int row_of(double v)
{
    return (int)fmin(ROWS - 1, fmax(0, floor(v / ROW_HEIGHT)));
}

void labels_line(Labels *labels, Spot from, Spot to, double width)
{
    if (!isfinite(from.u) || !isfinite(from.v) || !isfinite(to.u) || !isfinite(to.v))
        return;
    labels->drawn =
        one_more(labels->drawn, labels->drawn_count, &labels->drawn_room, sizeof(Drawn));
    double reach = width / 2 + CLEAR;
    int first = row_of(fmin(from.v, to.v) - reach), last = row_of(fmax(from.v, to.v) + reach);
    for (int i = first; i <= last; i++) {
        Row *row = &labels->rows[i];
        row->drawn = one_more(row->drawn, row->count, &row->room, sizeof *row->drawn);
        row->drawn[row->count++] = labels->drawn_count;
    }
    labels->drawn[labels->drawn_count++] = (Drawn){from, to, width / 2, first};
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

// ---- distances ----------------------------------------------------------------------------------

static Area box_of(const PlacedLabel *label, Spot middle)
{
    return (Area){middle.u - label->width / 2, middle.u + label->width / 2,
                  middle.v - label->height / 2, middle.v + label->height / 2};
}

static Spot between(Spot from, Spot to, double part)
{
    return (Spot){from.u + part * (to.u - from.u), from.v + part * (to.v - from.v)};
}

// From the box to a spot; 0 inside.
static double away(Area box, Spot spot)
{
    double u = fmax(0, fmax(box.left - spot.u, spot.u - box.right));
    double v = fmax(0, fmax(box.bottom - spot.v, spot.v - box.top));
    return hypot(u, v);
}

// The part of a line between low and high in one direction: narrows first .. last, and is false if
// nothing is left.
static bool cut(double from, double to, double low, double high, double *first, double *last)
{
    double d = to - from;
    if (d == 0)
        return from >= low && from <= high;
    double a = (low - from) / d, b = (high - from) / d;
    *first = fmax(*first, fmin(a, b));
    *last = fmin(*last, fmax(a, b));
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
    return between(from, to, fmin(1, fmax(0, part)));
}

// From the box to a line: between two that do not meet, one of the corners or one of the ends is
// nearest.
static double distance(Area box, Spot from, Spot to)
{
    if (crosses(box, from, to))
        return 0;
    const Spot corners[] = {
        {box.left, box.bottom}, {box.right, box.bottom}, {box.left, box.top}, {box.right, box.top}};
    double least = fmin(away(box, from), away(box, to));
    for (int i = 0; i < 4; i++) {
        Spot on = nearest_on(from, to, corners[i]);
        least = fmin(least, hypot(on.u - corners[i].u, on.v - corners[i].v));
    }
    return least;
}

// From the box to what a label names.
static double from_named(Area box, const PlacedLabel *label)
{
    return fmax(0, distance(box, label->from, label->to) - label->radius);
}

static bool overlap(Area a, Area b)
{
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

static bool names_nothing(const PlacedLabel *label)
{
    return label->free || label->pinned;
}

static Area grown(Area box, double by)
{
    return (Area){box.left - by, box.right + by, box.bottom - by, box.top + by};
}

// ---- what a place costs
// ---------------------------------------------------------------------------

static bool touch(const PlacedLabel *label, const PlacedLabel *other)
{
    Spot on = nearest_on(other->from, other->to, label->from);
    return hypot(on.u - label->from.u, on.v - label->from.v) < 1;
}

// At least so far is a box from what a label names: quickly computed.
static double at_least_from(Area box, const PlacedLabel *label)
{
    double u = fmax(box.left - fmax(label->from.u, label->to.u),
                    fmin(label->from.u, label->to.u) - box.right);
    double v = fmax(box.bottom - fmax(label->from.v, label->to.v),
                    fmin(label->from.v, label->to.v) - box.top);
    return fmax(u, v) - label->radius;
}

// Is it nearer to what another label names than to what it names itself? (A spot on a line that
// another label names is never nearer than the line.)
static bool is_ambiguous(const Labels *labels, int number, Area box)
{
    const PlacedLabel *label = &labels->labels[number];
    double own = from_named(box, label) + CLEARLY;
    bool is_spot = label->from.u == label->to.u && label->from.v == label->to.v;
    for (int i = 0; i < labels->count && !names_nothing(label); i++) {
        const PlacedLabel *other = &labels->labels[i];
        if (i != number && !names_nothing(other) && at_least_from(box, other) <= own &&
            from_named(box, other) <= own && !(is_spot && touch(label, other)))
            return true;
    }
    return false;
}

static double leader_length(const PlacedLabel *label)
{
    return hypot(label->end.u - label->start.u, label->end.v - label->start.v);
}

// The label as it stands there: with a leader from its box to the nearest spot of what it names, if
// that is far, or if something else is nearer.
static PlacedLabel standing(const Labels *labels, int number, Spot middle)
{
    PlacedLabel label = labels->labels[number];
    Area box = grown(box_of(&label, middle), LEADER_GAP);
    label.middle = middle;
    label.end = nearest_on(label.from, label.to, middle);
    double from_middle = hypot(middle.u - label.end.u, middle.v - label.end.v);
    if (from_middle > label.radius) // the edge of the disc
        label.end = between(label.end, middle, label.radius / from_middle);
    label.start = (Spot){fmin(box.right, fmax(box.left, label.end.u)),
                         fmin(box.top, fmax(box.bottom, label.end.v))};
    double far = leader_length(&label);
    label.leads = !names_nothing(&label) &&
                  (far > LEADER_FROM ||
                   (far > LEADER_LEAST && is_ambiguous(labels, number, box_of(&label, middle))));
    return label;
}

static double outside(Area box, Area area)
{
    double over = fmax(fmax(area.left - box.left, box.right - area.right),
                       fmax(area.bottom - box.bottom, box.top - area.top));
    return over > 0 ? FINE + over : 0;
}

// What the other labels cost it, as they stand.
static double fines_of_labels(const Labels *labels, int number, const PlacedLabel *label)
{
    Area box = box_of(label, label->middle);
    double cost = 0;
    for (int i = 0; i < labels->count; i++) {
        const PlacedLabel *other = &labels->labels[i];
        if (i == number)
            continue;
        Area there = box_of(other, other->middle);
        cost += overlap(grown(box, APART), there) ? 2 * FINE : 0;
        cost += other->leads && crosses(grown(box, CLEAR), other->start, other->end) ? FINE : 0;
        cost += label->leads && crosses(grown(there, CLEAR), label->start, label->end) ? FINE : 0;
    }
    return cost;
}

static double fines_of_drawn(const Labels *labels, Area box)
{
    int first = row_of(box.bottom), last = row_of(box.top), meets = 0;
    for (int i = first; i <= last; i++)
        for (int k = 0; k < labels->rows[i].count; k++) {
            const Drawn *drawn = &labels->drawn[labels->rows[i].drawn[k]];
            bool is_counted = drawn->first_row < i && first < i; // in the row below
            meets +=
                !is_counted && crosses(grown(box, CLEAR + drawn->radius), drawn->from, drawn->to);
        }
    return meets * FINE;
}

// Two segments: do they cross?
static double side(Spot a, Spot b, Spot c)
{
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

static double crossings(const Labels *labels, const PlacedLabel *label)
{
    double cost = 0;
    for (int i = 0; i < labels->drawn_count && label->leads; i++) {
        const Drawn *drawn = &labels->drawn[i];
        cost += side(label->start, label->end, drawn->from) *
                                side(label->start, label->end, drawn->to) <=
                            0 &&
                        side(drawn->from, drawn->to, label->start) *
                                side(drawn->from, drawn->to, label->end) <=
                            0
                    ? LEADER_CROSSES
                    : 0;
    }
    return cost;
}

// ---- places to try
// --------------------------------------------------------------------------------

// What a place costs, whatever the other labels do.
static double cost_alone(const Labels *labels, const PlacedLabel *label, int number, double wish)
{
    Area box = box_of(label, label->middle);
    double far = names_nothing(label)
                     ? 0.1 * hypot(label->middle.u - label->from.u, label->middle.v - label->from.v)
                     : away(box, label->end);
    double leader = label->leads ? LEADER + crossings(labels, label) : 0;
    bool is_unclear = leader_length(label) <= LEADER_LEAST && is_ambiguous(labels, number, box);
    return wish + far + leader + (is_unclear ? FINE : 0) + outside(box, labels->area) +
           fines_of_drawn(labels, box);
}

static void try_place(Labels *labels, int number, Spot middle, double wish)
{
    Places *places = &labels->places[number];
    places->list = one_more(places->list, places->count, &places->room, sizeof(Place));
    PlacedLabel label = standing(labels, number, middle);
    double cost = cost_alone(labels, &label, number, wish);
    places->list[places->count] = (Place){label, cost, places->count};
    places->count++;
}

// Around a spot, in 16 directions.
static void try_around(Labels *labels, int number, Spot spot, double wish)
{
    static const double gaps[] = {6, 10, 16, 24, 36, 52, 74, 104, 144, 190};
    enum { DIRECTIONS = 16 };
    const PlacedLabel *label = &labels->labels[number];
    for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++) {
        for (int i = 0; i < DIRECTIONS; i++) {
            double angle = 2 * PI * i / DIRECTIONS, u = cos(angle), v = sin(angle);
            double gap = label->radius + gaps[g];
            // The box just touches the circle of this radius around the spot.
            double du = label->width / 2, dv = label->height / 2;
            double stretch = fmin(fabs(u) > 1e-9 ? (du + fabs(u) * gap) / fabs(u) : DBL_MAX,
                                  fabs(v) > 1e-9 ? (dv + fabs(v) * gap) / fabs(v) : DBL_MAX);
            try_place(labels, number, (Spot){spot.u + stretch * u, spot.v + stretch * v}, wish);
        }
    }
}

static void try_everywhere(Labels *labels, int number, double step)
{
    const PlacedLabel *label = &labels->labels[number];
    Area area = labels->area;
    for (double v = area.top - label->height / 2; v >= area.bottom + label->height / 2; v -= step)
        for (double u = area.left + label->width / 2; u <= area.right - label->width / 2; u += step)
            try_place(labels, number, (Spot){u, v}, 0);
}

static int by_cost(const void *a, const void *b)
{
    const Place *x = a, *y = b;
    return x->cost < y->cost ? -1 : x->cost > y->cost ? 1 : x->number - y->number;
}

// The place that a label names, or so near to it that the label is in the area.
static Spot within(Area area, const PlacedLabel *label)
{
    double u = label->width / 2, v = label->height / 2;
    return (Spot){fmax(area.left + u, fmin(area.right - u, label->from.u)),
                  fmax(area.bottom + v, fmin(area.top - v, label->from.v))};
}

// All places of a label, cheap ones first.
static void find_places(Labels *labels, int number)
{
    static const double parts[] = {0.5, 0.35, 0.65, 0.15, 0.85, 0, 1};
    const PlacedLabel *label = &labels->labels[number];
    labels->places[number].count = 0;
    if (label->free) {
        try_everywhere(labels, number, 10);
    } else if (!label->pinned) {
        bool is_stretch = label->from.u != label->to.u || label->from.v != label->to.v;
        for (int i = 0; i < (is_stretch ? 7 : 1); i++)
            try_around(labels, number, between(label->from, label->to, parts[i]),
                       4 * fabs(parts[i] - 0.5));
    }
    Places *places = &labels->places[number];
    if (places->count == 0) // pinned, or a block of text larger than the canvas
        try_place(labels, number, within(labels->area, label), 0);
    qsort(places->list, (size_t)places->count, sizeof(Place), by_cost);
}

// ---- all labels
// -----------------------------------------------------------------------------------

static void stand(Labels *labels, int number, const Place *place)
{
    labels->labels[number] = place->label;
    labels->places[number].taken = place;
}

// The cheapest place while the others stay where they are.
static const Place *cheapest(const Labels *labels, int number)
{
    const Places *places = &labels->places[number];
    const Place *best = places->list;
    double least = DBL_MAX;
    for (const Place *place = places->list;
         place < places->list + places->count && place->cost < least; place++) {
        double cost = place->cost + fines_of_labels(labels, number, &place->label);
        if (cost < least) {
            least = cost;
            best = place;
        }
    }
    return best;
}

// Each in turn takes its best place, until none moves: in so many rounds at most.
enum { ROUNDS = 6 };
static void settle(Labels *labels, int rounds)
{
    for (int round = 0, moved = 1; moved && round < rounds; round++) {
        moved = 0;
        for (int i = 0; i < labels->count; i++) {
            const Place *best = cheapest(labels, i);
            moved += best != labels->places[i].taken;
            stand(labels, i, best);
        }
    }
}

static double cost_of(const Labels *labels, int number)
{
    const Place *place = labels->places[number].taken;
    return place->cost + fines_of_labels(labels, number, &place->label);
}

double labels_cost(const Labels *labels)
{
    double cost = 0;
    for (int i = 0; i < labels->count; i++)
        cost += cost_of(labels, i);
    return cost;
}

static void take_away(Labels *labels)
{
    const Spot nowhere = {-1e6, -1e6};
    for (int i = 0; i < labels->count; i++)
        labels->labels[i].middle = nowhere;
}

// One label goes where it would stand if it were alone, and the others make room. Kept if that is
// better.
static void insist(Labels *labels, int number)
{
    const Place **before = calloc((size_t)labels->count, sizeof *before);
    if (before == NULL)
        abort();
    for (int i = 0; i < labels->count; i++)
        before[i] = labels->places[i].taken;
    double cost = labels_cost(labels);
    take_away(labels);
    stand(labels, number, cheapest(labels, number));
    for (int i = 0; i < labels->count; i++)
        if (i != number)
            stand(labels, i, cheapest(labels, i));
    settle(labels, 2);
    bool is_better = labels_cost(labels) < cost;
    for (int i = 0; i < labels->count && !is_better; i++)
        stand(labels, i, before[i]);
    free(before);
}

// A label that meets something may go anywhere, with a leader.
static void scatter(Labels *labels)
{
    bool any = false;
    for (int i = 0; i < labels->count && isfinite(labels->area.right); i++) {
        Places *places = &labels->places[i];
        if (names_nothing(&labels->labels[i]) || cost_of(labels, i) < FINE)
            continue;
        int taken = places->taken->number;
        try_everywhere(labels, i, 12);
        qsort(places->list, (size_t)places->count, sizeof(Place), by_cost);
        places->taken = places->list;
        while (places->taken->number != taken)
            places->taken++;
        any = true;
    }
    if (any)
        settle(labels, ROUNDS);
}

void labels_place(Labels *labels)
{
    enum { NEAR = 2 * LEADER_FROM };
    labels->places = calloc((size_t)labels->count + 1, sizeof *labels->places);
    if (labels->places == NULL)
        abort();
    for (int i = 0; i < labels->count; i++)
        find_places(labels, i);
    take_away(labels);
    settle(labels, ROUNDS);
    for (int i = 0; i < labels->count; i++)
        if (cost_of(labels, i) > NEAR)
            insist(labels, i);
    scatter(labels);
}

// ---- how wide a text is
// ---------------------------------------------------------------------------

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
    int thousandths = 0;
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        if (*c >= ' ' && *c < 127)
            thousandths += widths[*c - ' '];
        else if ((*c & 0xC0) == 0xC0) // the first byte of another character
            thousandths += OTHERS;
    }
    return thousandths / 1000.0 * size;
}
