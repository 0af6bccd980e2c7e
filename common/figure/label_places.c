// label_places.c - the places where one label of a figure may be, cheap ones first.
#include "common/figure/label_places.h"
#include "common/figure/label_geometry.h"

#include <float.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

static void add_candidate(Places *places, Candidate candidate)
{
    places->candidates = labels_one_more(places->candidates, places->candidate_count,
                                         &places->candidate_room, sizeof(Candidate));
    places->candidates[places->candidate_count++] = candidate;
}

static double cost_of_distance(double far)
{
    return larger(0, far) + (far > SURELY_LEADS ? LEADER : 0) - SLACK;
}

// ---- around what it names -----------------------------------------------------------------------

static const Spot *directions(void)
{
    static Spot found[DIRECTIONS];
    if (found[0].u == 0)
        for (int i = 0; i < DIRECTIONS; i++)
            found[i] = (Spot){cos(2 * PI * i / DIRECTIONS), sin(2 * PI * i / DIRECTIONS)};
    return found;
}

// To the spot, the line is 0 long.
static void find_around(Around *around, const PlacedLabel *label)
{
    static const double gaps[GAPS] = {6, 10, 16, 24, 36, 52, 74, 104, 144, 190};
    const double du = label->width / 2, dv = label->height / 2;
    const Spot line = {label->to.u - label->from.u, label->to.v - label->from.v};
    const double length = nearly_long(line);
    const Spot way = {length > 0 ? line.u / length : 0, length > 0 ? line.v / length : 0};
    const double high = du * fabs(way.v) + dv * fabs(way.u);
    around->length = length;
    around->wide = du * fabs(way.u) + dv * fabs(way.v);
    for (int i = 0; i < DIRECTIONS; i++)
        for (int g = 0; g < GAPS; g++) {
            const Spot direction = directions()[i];
            double u = fabs(direction.u), v = fabs(direction.v), gap = label->radius + gaps[g];
            // The box just touches the circle of this radius around the spot.
            double stretch = smaller(u > 1e-9 ? (du + u * gap) / u : DBL_MAX,
                                     v > 1e-9 ? (dv + v * gap) / v : DBL_MAX);
            Spot by = {stretch * direction.u, stretch * direction.v};
            double far = length > 0 ? fabs(way.v * by.u - way.u * by.v) - high
                                    : nearly_long(aside((Area){-du, du, -dv, dv}, by));
            around->by[i][g] = by;
            around->beside[i][g] = far - label->radius;
            around->along[i][g] = way.u * by.u + way.v * by.v;
        }
}

static void find_spots(Around *around, const PlacedLabel *label)
{
    static const double parts[SPOTS] = {0.5, 0.35, 0.65, 0.15, 0.85, 0, 1};
    bool is_stretch = label->from.u != label->to.u || label->from.v != label->to.v;
    around->count = is_stretch ? SPOTS : 1;
    for (int i = 0; i < around->count; i++) {
        around->parts[i] = parts[i];
        around->spots[i] = between(label->from, label->to, parts[i]);
        around->wishes[i] = 4 * fabs(parts[i] - 0.5);
    }
}

static double at_least_around(const Around *around, int spot, int direction, int gap)
{
    double at = around->parts[spot] * around->length + around->along[direction][gap];
    double beyond_end = larger(-at, at - around->length) - around->wide;
    double far = larger(around->beside[direction][gap], around->length > 0 ? beyond_end : 0);
    return around->wishes[spot] + cost_of_distance(far);
}

// Those that may cost less than 'limit' are candidates. In one direction, they cost ever more.
static void add_around(Places *places, double limit)
{
    Around *around = &places->around;
    for (int i = 0; i < around->count; i++)
        for (int k = 0; k < DIRECTIONS; k++) {
            for (int g = around->next[i][k]; g < GAPS; g++) {
                double at_least = at_least_around(around, i, k, g);
                if (at_least >= limit)
                    break;
                Spot spot = around->spots[i], by = around->by[k][g];
                int number = (i * GAPS + g) * DIRECTIONS + k;
                around->next[i][k] = (unsigned char)(g + 1);
                add_candidate(places, (Candidate){{spot.u + by.u, spot.v + by.v},
                                                  around->wishes[i],
                                                  at_least,
                                                  number});
            }
        }
}

// ---- anywhere -----------------------------------------------------------------------------------

// first, first + step .. last; returns how many.
static int numbers_from(double **numbers, double first, double last, double step)
{
    int count = 0, room = 0;
    for (double x = first; step > 0 ? x <= last : x >= last; x += step) {
        *numbers = labels_one_more(*numbers, count, &room, sizeof(double));
        (*numbers)[count++] = x;
    }
    return count;
}

// Which of these numbers, from the first to before the last, are at most so far from low .. high.
// They rise or fall.
static void find_part(const double *numbers, int count, double low, double high, double far,
                      int *first, int *last)
{
    for (*first = 0; *first < count; ++*first)
        if (numbers[*first] >= low - far && numbers[*first] <= high + far)
            break;
    for (*last = *first; *last < count; ++*last)
        if (numbers[*last] < low - far || numbers[*last] > high + far)
            break;
}

// At least so much costs a label there.
static double at_least_there(const PlacedLabel *label, Spot there)
{
    return names_nothing(label)
               ? 0.1 * larger(fabs(there.u - label->from.u), fabs(there.v - label->from.v)) - SLACK
               : cost_of_distance(label_at_least_from(box_of(label, there), label));
}

// Those that may cost less than 'limit' are candidates.
static void add_anywhere(Places *places, const PlacedLabel *label, double limit)
{
    Lattice *lattice = &places->lattice;
    const Lattice was = *lattice;
    const Area named = {smaller(label->from.u, label->to.u), larger(label->from.u, label->to.u),
                        smaller(label->from.v, label->to.v), larger(label->from.v, label->to.v)};
    // How far it may be; a leader would cost more.
    const bool nothing = names_nothing(label);
    const double far = nothing ? 10 * limit : larger(smaller(limit, SURELY_LEADS), limit - LEADER);
    const double reach = far + label->radius + 1;
    const double du = nothing ? 0 : label->width / 2, dv = nothing ? 0 : label->height / 2;
    find_part(lattice->us, lattice->columns, named.left - du, named.right + du, reach,
              &lattice->left, &lattice->right);
    find_part(lattice->vs, lattice->rows, named.bottom - dv, named.top + dv, reach, &lattice->top,
              &lattice->bottom);
    for (int row = lattice->top; row < lattice->bottom; row++)
        for (int column = lattice->left; column < lattice->right; column++) {
            bool is_there =
                row >= was.top && row < was.bottom && column >= was.left && column < was.right;
            if (is_there)
                continue;
            Spot there = {lattice->us[column], lattice->vs[row]};
            int number = lattice->first_number + row * lattice->columns + column;
            add_candidate(places, (Candidate){there, 0, at_least_there(label, there), number});
        }
}

void find_places_anywhere(Labels *labels, int number, double step)
{
    const PlacedLabel *label = &labels->labels[number];
    const Area area = labels->area;
    Places *places = &labels->places[number];
    Lattice *lattice = &places->lattice;
    double du = label->width / 2, dv = label->height / 2;
    // Less of a margin, if there is no room for it.
    du += smaller(label->margin, larger(0, (area.right - area.left) / 2 - du));
    lattice->columns = numbers_from(&lattice->us, area.left + du, area.right - du, step);
    lattice->rows = numbers_from(&lattice->vs, area.top - dv, area.bottom + dv, -step);
    lattice->first_number = places->around.count * GAPS * DIRECTIONS;
    places->known = 0;
    places->ordered = 0;
}

// The place that a label names, or so near to it that the label is in the area.
static Spot within(Area area, const PlacedLabel *label)
{
    double u = label->width / 2, v = label->height / 2;
    return (Spot){larger(area.left + u, smaller(area.right - u, label->from.u)),
                  larger(area.bottom + v, smaller(area.top - v, label->from.v))};
}

void find_places(Labels *labels, int number)
{
    enum { EVERYWHERE = 10 };
    const PlacedLabel *label = &labels->labels[number];
    Places *places = &labels->places[number];
    if (label->free) {
        find_places_anywhere(labels, number, EVERYWHERE);
    } else if (!label->pinned) {
        find_around(&places->around, label);
        find_spots(&places->around, label);
    }
    // Pinned, or a block of text larger than the canvas.
    if (places->around.count == 0 && (places->lattice.columns == 0 || places->lattice.rows == 0)) {
        Spot there = within(labels->area, label);
        add_candidate(places, (Candidate){there, 0, at_least_there(label, there), 0});
    }
}

void free_places(Places *places)
{
    free(places->lattice.us);
    free(places->lattice.vs);
    free(places->candidates);
    free(places->list);
}

// ---- cheap ones first ---------------------------------------------------------------------------

static int by_cost(const void *a, const void *b)
{
    const Place *x = a, *y = b;
    return x->cost < y->cost ? -1 : x->cost > y->cost ? 1 : x->number - y->number;
}

// Finds all places that cost less than twice as much as those that are known, or less than 'most'.
static void find_more(Labels *labels, int number, double most)
{
    enum { FIRST = 8, LAST = 64 * FINE };
    Places *places = &labels->places[number];
    double limit = places->known < LAST ? larger(FIRST, 2 * places->known) : INFINITY;
    limit = smaller(limit, most);
    add_around(places, limit);
    add_anywhere(places, &labels->labels[number], limit);
    for (int i = 0; i < places->candidate_count;) {
        Place place;
        if (places->candidates[i].at_least < limit &&
            find_cost(labels, number, &places->candidates[i], limit, &place)) {
            places->list =
                labels_one_more(places->list, places->count, &places->room, sizeof(Place));
            places->list[places->count++] = place;
            places->candidates[i] = places->candidates[--places->candidate_count];
        } else {
            i++;
        }
    }
    places->known = limit;
    if (places->count > places->ordered)
        qsort(places->list + places->ordered, (size_t)(places->count - places->ordered),
              sizeof(Place), by_cost);
    while (places->ordered < places->count && !(places->list[places->ordered].cost >= limit))
        places->ordered++;
}

const Place *place_below(Labels *labels, int number, int rank, double limit)
{
    Places *places = &labels->places[number];
    while (rank >= places->ordered && places->known < limit)
        find_more(labels, number, limit);
    return rank < places->ordered && places->list[rank].cost < limit ? &places->list[rank] : NULL;
}
