// labels.c - where a figure's labels stand.
//
// A place for a label has a cost: how far it is from what it names, and a fine for each thing it
// meets. Each label in turn takes the cheapest of its places while the others stay where they are,
// until none moves.
#include "common/figure/labels.h"
#include "common/figure/label_geometry.h"
#include "common/figure/label_places.h"

#include <float.h>
#include <stdlib.h>

// A search for a label's best place: its rank; the area of all places that were tried; and where
// the others stood. Only those in that area mattered.
typedef struct {
    int best; // NOTHING: there was no search
    Area tried;
    int *others; // as state_of says
    Area *there;
} Search;

enum { SEARCHES = 4, NOTHING = -1 };

typedef struct Standing {
    Place taken;
    bool is_away;              // only its leader is there
    Area box, all;             // and with its leader
    Search searches[SEARCHES]; // the last ones
    int next_search;
} Standing;

static void *room_for(int count, size_t size)
{
    void *items = calloc((size_t)count + 1, size);
    if (items == NULL)
        abort();
    return items;
}

Labels *labels_new(Area area)
{
    Labels *labels = room_for(1, sizeof *labels);
    labels->area = area;
    return labels;
}

static void free_searches(Standing *standing)
{
    for (int i = 0; i < SEARCHES; i++) {
        free(standing->searches[i].others);
        free(standing->searches[i].there);
    }
}

void labels_free(Labels *labels)
{
    for (int i = 0; labels->places != NULL && i < labels->count; i++) {
        free_places(&labels->places[i]);
        free_searches(&labels->standing[i]);
    }
    free(labels->places);
    free(labels->standing);
    for (int i = 0; i < ROWS; i++)
        free(labels->rows[i].drawn);
    free(labels->drawn);
    free(labels->labels);
    free(labels);
}

void *labels_one_more(void *items, int count, int *room, size_t size)
{
    if (count < *room)
        return items;
    *room = 2 * *room + 16;
    items = realloc(items, (size_t)*room * size);
    if (items == NULL)
        abort();
    return items;
}

void labels_disc(Labels *labels, Spot middle, double radius)
{
    labels_line(labels, middle, middle, 2 * radius);
}

int labels_add(Labels *labels, PlacedLabel label)
{
    labels->labels =
        labels_one_more(labels->labels, labels->count, &labels->room, sizeof(PlacedLabel));
    label.middle = label.from;
    label.leads = false;
    labels->labels[labels->count] = label;
    return labels->count++;
}

PlacedLabel labels_get(const Labels *labels, int number)
{
    return labels->labels[number];
}

// ---- how the labels stand -----------------------------------------------------------------------

static Area with(Area area, Spot spot)
{
    return (Area){smaller(area.left, spot.u), larger(area.right, spot.u),
                  smaller(area.bottom, spot.v), larger(area.top, spot.v)};
}

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
    labels->standing[number].is_away = false;
    put(labels, number, place->middle);
}

static void take_away(Labels *labels)
{
    const Spot nowhere = {-1e6, -1e6};
    for (int i = 0; i < labels->count; i++) {
        labels->standing[i].is_away = true;
        put(labels, i, nowhere);
    }
}

static int state_of(const Standing *standing)
{
    return 2 * standing->taken.number + standing->is_away;
}

// What a label there may meet of other labels is in this area.
static Area reach_of(const Labels *labels, int number, const Place *place)
{
    return grown(with_leader(box_of(&labels->labels[number], place->middle), place), APART + 1);
}

// What the other labels cost it in this place, as they stand. Stops at 'most', which is too much.
static double fines_of_labels(const Labels *labels, int number, const Place *place, double most)
{
    const Area box = box_of(&labels->labels[number], place->middle);
    const Area apart = grown(box, APART), clear = grown(box, CLEAR);
    const Area reach = reach_of(labels, number, place);
    double cost = 0;
    for (int i = 0; i < labels->count && cost < most; i++) {
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
    return place->cost + fines_of_labels(labels, number, place, INFINITY);
}

double labels_cost(const Labels *labels)
{
    double cost = 0;
    for (int i = 0; i < labels->count; i++)
        cost += cost_of(labels, i);
    return cost;
}

// ---- the cheapest place of a label --------------------------------------------------------------

static void forget_searches(Standing *standing)
{
    for (int i = 0; i < SEARCHES; i++)
        standing->searches[i].best = NOTHING;
}

// Would this search find the same now?
static bool is_valid(const Labels *labels, int number, const Search *search)
{
    for (int i = 0; search->best != NOTHING && i < labels->count; i++) {
        const Standing *other = &labels->standing[i];
        if (i != number && search->others[i] != state_of(other) &&
            (overlap(search->tried, other->all) || overlap(search->tried, search->there[i])))
            return false;
    }
    return search->best != NOTHING;
}

static void search_places(Labels *labels, int number, Search *search)
{
    double least = DBL_MAX;
    const Place *place;
    search->best = 0;
    search->tried = (Area){INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int rank = 0; (place = place_below(labels, number, rank, least)) != NULL; rank++) {
        double cost = place->cost + fines_of_labels(labels, number, place, least - place->cost);
        Area reach = reach_of(labels, number, place);
        search->tried = with(with(search->tried, (Spot){reach.left, reach.bottom}),
                             (Spot){reach.right, reach.top});
        if (cost < least) {
            least = cost;
            search->best = rank;
        }
    }
    if (search->others == NULL) {
        search->others = room_for(labels->count, sizeof *search->others);
        search->there = room_for(labels->count, sizeof *search->there);
    }
    for (int i = 0; i < labels->count; i++) {
        search->others[i] = state_of(&labels->standing[i]);
        search->there[i] = labels->standing[i].all;
    }
}

// The cheapest place while the others stay where they are.
static const Place *cheapest(Labels *labels, int number)
{
    Standing *standing = &labels->standing[number];
    const Search *found = NULL;
    for (int i = 0; i < SEARCHES && found == NULL; i++)
        if (is_valid(labels, number, &standing->searches[i]))
            found = &standing->searches[i];
    if (found == NULL) {
        Search *search = &standing->searches[standing->next_search];
        search_places(labels, number, search);
        standing->next_search = (standing->next_search + 1) % SEARCHES;
        found = search;
    }
    return place_below(labels, number, found->best, INFINITY);
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
        if (names_nothing(&labels->labels[i]) || cost_of(labels, i) < FINE)
            continue;
        find_places_anywhere(labels, i, EVERYWHERE);
        forget_searches(&labels->standing[i]);
        any = true;
    }
    if (any)
        settle(labels, ROUNDS);
}

void labels_place(Labels *labels)
{
    enum { NEAR = 2 * LEADER_FROM };
    labels->places = room_for(labels->count, sizeof *labels->places);
    labels->standing = room_for(labels->count, sizeof *labels->standing);
    for (int i = 0; i < labels->count; i++) {
        find_places(labels, i);
        labels->standing[i].taken.number = NOTHING;
        forget_searches(&labels->standing[i]);
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
    int thousandths = 0;
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        if (*c >= ' ' && *c < 127)
            thousandths += widths[*c - ' '];
        else if ((*c & 0xC0) == 0xC0) // the first byte of another character
            thousandths += OTHERS;
    }
    return thousandths / 1000.0 * size;
}
