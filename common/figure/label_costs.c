// label_costs.c - what a place for a label of a figure costs, whatever the other labels do.
#include "common/figure/label_geometry.h"
#include "common/figure/label_places.h"

#include <limits.h>
#include <stdlib.h>

// In units of the canvas: by how much a label is nearer to what it names than to what another one
// names; how short a leader may be.
enum { CLEARLY = 3, LEADER_LEAST = 8 };

enum { LEADER_CROSSES = 15 };

// From the box to what a label names.
static double from_named(Area box, const PlacedLabel *label)
{
    return larger(0, distance(box, label->from, label->to) - label->radius);
}

static bool touch(const PlacedLabel *label, const PlacedLabel *other)
{
    return spots_apart(nearest_on(other->from, other->to, label->from), label->from) < 1;
}

double label_at_least_from(Area box, const PlacedLabel *label)
{
    double u = larger(box.left - larger(label->from.u, label->to.u),
                      smaller(label->from.u, label->to.u) - box.right);
    double v = larger(box.bottom - larger(label->from.v, label->to.v),
                      smaller(label->from.v, label->to.v) - box.top);
    return larger(u, v) - label->radius;
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
        if (i != number && !names_nothing(other) && label_at_least_from(box, other) <= own &&
            from_named(box, other) <= own && !(is_spot && touch(label, other)))
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

// What is above or below the canvas is in the last row on that side.
static int row_of(double v)
{
    return (int)smaller(ROWS - 1, larger(0, v / ROW_HEIGHT));
}

void labels_line(Labels *labels, Spot from, Spot to, double width)
{
    if (!isfinite(from.u) || !isfinite(from.v) || !isfinite(to.u) || !isfinite(to.v))
        return;
    labels->drawn =
        labels_one_more(labels->drawn, labels->drawn_count, &labels->drawn_room, sizeof(Drawn));
    const Area ends = {smaller(from.u, to.u), larger(from.u, to.u), smaller(from.v, to.v),
                       larger(from.v, to.v)};
    const Area around = grown(ends, width / 2 + CLEAR);
    int first = row_of(around.bottom), last = row_of(around.top);
    const Drawn drawn = {from, to, width / 2, grown(around, SLACK), first};
    for (int i = first; i <= last; i++) {
        Row *row = &labels->rows[i];
        row->drawn = labels_one_more(row->drawn, row->count, &row->room, sizeof(Drawn));
        row->drawn[row->count++] = drawn;
    }
    labels->drawn[labels->drawn_count++] = drawn;
}

static bool meets(Area box, const Drawn *drawn)
{
    return overlap(drawn->around, box) &&
           crosses(grown(box, CLEAR + drawn->radius), drawn->from, drawn->to);
}

// How much of what is drawn the box meets: 'most' of it, or more, are 'most'. And the last of it.
static int count_met(const Labels *labels, Area box, int most, const Drawn **last_met)
{
    int first = row_of(box.bottom), last = row_of(box.top), met = 0;
    for (int i = first; i <= last; i++)
        for (int k = 0; k < labels->rows[i].count; k++) {
            const Drawn *drawn = &labels->rows[i].drawn[k];
            bool is_counted = drawn->first_row < i && first < i; // in the row below
            if (is_counted || !meets(box, drawn))
                continue;
            *last_met = drawn;
            if (++met >= most)
                return met;
        }
    return met;
}

// On which side of the line from a to b, which is ab long, is c?
static double side(Spot a, Spot ab, Spot c)
{
    return ab.u * (c.v - a.v) - ab.v * (c.u - a.u);
}

static Spot from_to(Spot a, Spot b)
{
    return (Spot){b.u - a.u, b.v - a.v};
}

// What crossing lines costs a leader.
static double crossings(const Labels *labels, Spot start, Spot end)
{
    double cost = 0;
    Spot along = from_to(start, end);
    for (int i = 0; i < labels->drawn_count; i++) {
        const Drawn *drawn = &labels->drawn[i];
        if (side(start, along, drawn->from) * side(start, along, drawn->to) > 0)
            continue;
        Spot line = from_to(drawn->from, drawn->to);
        if (side(drawn->from, line, start) * side(drawn->from, line, end) <= 0)
            cost += LEADER_CROSSES;
    }
    return cost;
}

// Is the way from the leader's start to its end longer?
static bool is_longer(Spot start, Spot end, double than)
{
    double length = nearly_long(from_to(start, end));
    return (fabs(length - than) > SLACK ? length : spots_apart(end, start)) > than;
}

static double far_from_named(const PlacedLabel *label, Area box, Spot middle, Spot end)
{
    return names_nothing(label) ? 0.1 * spots_apart(middle, label->from) : away(box, end);
}

// How many fines until the cost is as much as 'limit'.
static int fines_until(double limit, double cost)
{
    return limit - cost < INT_MAX ? 1 + (int)larger(0, (limit - cost) / FINE) : INT_MAX;
}

// The label has a leader from its box to the nearest spot of what it names, if that is far, or if
// something else is nearer.
bool find_cost(Labels *labels, int number, Candidate *c, double limit, Place *place)
{
    const PlacedLabel *label = &labels->labels[number];
    const Spot middle = c->middle;
    const Area box = box_of(label, middle), around = grown(box, LEADER_GAP);
    // Most places that meet something meet the same as the place before.
    if (c->at_least < FINE / 2 && c->at_least + FINE >= limit && labels->last_met != NULL &&
        meets(box, labels->last_met)) {
        c->at_least += FINE;
        return false;
    }
    Spot end = nearest_on(label->from, label->to, middle);
    if (label->radius > 0) { // the edge of the disc
        double from_middle = spots_apart(middle, end);
        if (from_middle > label->radius)
            end = between(end, middle, label->radius / from_middle);
    }
    Spot start = {smaller(around.right, larger(around.left, end.u)),
                  smaller(around.top, larger(around.bottom, end.v))};
    const bool names = !names_nothing(label);
    double out = outside(box, labels->area);
    bool leads = names && is_longer(start, end, LEADER_FROM), is_unclear = false;
    double at_least =
        c->wish + out + (leads ? LEADER : 0) - SLACK +
        (names ? nearly_long(aside(box, end)) : 0.1 * nearly_long(from_to(label->from, middle)));
    c->at_least = at_least;
    if (at_least >= limit)
        return false;
    int most = fines_until(limit, at_least);
    int met = count_met(labels, box, most, &labels->last_met);
    at_least += met * FINE;
    if (at_least < limit && names && !leads && is_ambiguous(labels, number, box)) {
        leads = is_longer(start, end, LEADER_LEAST);
        is_unclear = !leads;
        at_least += leads ? LEADER : FINE;
    }
    c->at_least = at_least;
    if (at_least >= limit || met >= most)
        return false;
    double leader = leads ? LEADER + crossings(labels, start, end) : 0;
    double cost = c->wish + far_from_named(label, box, middle, end) + leader +
                  (is_unclear ? FINE : 0) + out + met * FINE;
    // Of places that cost the same, the first is taken, however a machine rounds.
    const double parts = 1e7;
    *place = (Place){middle, start, end, round(cost * parts) / parts, c->number, leads};
    return true;
}
