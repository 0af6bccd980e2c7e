// labels.c - tests of common/figure/labels.c: where labels stand.
//
// Expected: properties, of random drawings. Whether a line meets a box is found here by walking
// along it in short steps; widths of characters are those in the font's own table (hmtx).
#include "common/figure/labels.h"

#include "tests/judge/test.h"

#include <math.h>

enum { LINES = 14, DISCS = 4, LABELS = 7, DRAWINGS = 60 };

static const Area canvas = {10, 950, 10, 464};

typedef struct {
    Spot from[LINES], to[LINES], disc[DISCS];
    double radius[DISCS];
    PlacedLabel labels[LABELS];
} Drawing;

static Spot anywhere(void)
{
    return (Spot){random_number(100, 860), random_number(80, 400)};
}

static PlacedLabel some_label(Spot from, Spot to)
{
    return (PlacedLabel){
        .from = from, .to = to, .width = random_number(12, 150), .height = random_number(24, 60)};
}

// Labels name lines' ends and lines.
static Drawing some_drawing(void)
{
    Drawing drawing;
    for (int i = 0; i < LINES; i++) {
        drawing.from[i] = anywhere();
        drawing.to[i] = anywhere();
    }
    for (int i = 0; i < DISCS; i++) {
        drawing.disc[i] = anywhere();
        drawing.radius[i] = random_number(4, 40);
    }
    for (int i = 0; i < LABELS; i++)
        drawing.labels[i] =
            some_label(drawing.from[i], i % 2 == 0 ? drawing.from[i] : drawing.to[i]);
    return drawing;
}

// Lines and discs, beginning with number 'first'.
static Labels *labels_for(const Drawing *drawing, int first)
{
    Labels *labels = labels_new(canvas);
    for (int i = 0; i < LINES; i++) {
        int number = (first + i) % LINES;
        labels_line(labels, drawing->from[number], drawing->to[number], 2);
    }
    for (int i = 0; i < DISCS; i++) {
        int number = (first + i) % DISCS;
        labels_disc(labels, drawing->disc[number], drawing->radius[number]);
    }
    for (int i = 0; i < LABELS; i++)
        labels_add(labels, drawing->labels[i]);
    labels_place(labels);
    return labels;
}

static Area box_of(PlacedLabel label)
{
    return (Area){label.middle.u - label.width / 2, label.middle.u + label.width / 2,
                  label.middle.v - label.height / 2, label.middle.v + label.height / 2};
}

static double gap(Area box, Spot spot)
{
    return hypot(fmax(0, fmax(box.left - spot.u, spot.u - box.right)),
                 fmax(0, fmax(box.bottom - spot.v, spot.v - box.top)));
}

static double gap_to_line(Area box, Spot from, Spot to)
{
    int steps = 2 + (int)hypot(to.u - from.u, to.v - from.v);
    double least = INFINITY;
    for (int i = 0; i <= steps; i++) {
        double part = (double)i / steps;
        Spot spot = {from.u + part * (to.u - from.u), from.v + part * (to.v - from.v)};
        least = fmin(least, gap(box, spot));
    }
    return least;
}

static double gap_to_drawing(Area box, const Drawing *drawing)
{
    double least = INFINITY;
    for (int i = 0; i < LINES; i++)
        least = fmin(least, gap_to_line(box, drawing->from[i], drawing->to[i]));
    for (int i = 0; i < DISCS; i++)
        least = fmin(least, gap(box, drawing->disc[i]) - drawing->radius[i]);
    return least;
}

static bool is_inside(Area box)
{
    return box.left >= canvas.left && box.right <= canvas.right && box.bottom >= canvas.bottom &&
           box.top <= canvas.top;
}

static void expect_good_label(const Drawing *drawing, const Labels *labels, int i)
{
    PlacedLabel one = labels_get(labels, i);
    Area box = box_of(one);
    expect_law(gap_to_drawing(box, drawing) > 2, "some room around it", "it meets something");
    expect_law(is_inside(box), "inside the canvas", "outside");
    for (int j = 0; j < i; j++) {
        PlacedLabel other = labels_get(labels, j);
        expect_law(fabs(one.middle.u - other.middle.u) > (one.width + other.width) / 2 ||
                       fabs(one.middle.v - other.middle.v) > (one.height + other.height) / 2,
                   "apart from the others", "two overlap");
    }
    if (one.leads) {
        Area end = {one.end.u, one.end.u, one.end.v, one.end.v};
        expect_law(gap_to_line(end, one.from, one.to) < 1, "an end on it", "elsewhere");
        expect_law(gap(box, one.start) < 6, "a start at the label", "elsewhere");
    } else {
        expect_law(gap_to_line(box, one.from, one.to) < 40, "near it", "far");
    }
}

TEST(labels_place, labels_meet_nothing_and_are_near_what_they_name_or_have_a_leader)
{
    int leaders = 0;
    for (int k = 0; k < DRAWINGS; k++) {
        Drawing drawing = some_drawing();
        Labels *labels = labels_for(&drawing, 0);
        for (int i = 0; i < LABELS; i++) {
            given("drawing and label", "%d, %d", k, i);
            expect_good_label(&drawing, labels, i);
            leaders += labels_get(labels, i).leads;
        }
        labels_free(labels);
    }
    expect_law(leaders > 0, "some leaders in so many drawings", "none");
}

TEST(labels_place, a_label_with_room_beside_it_has_no_leader)
{
    for (int k = 0; k < DRAWINGS; k++) {
        Drawing drawing = some_drawing();
        PlacedLabel label = some_label(anywhere(), (Spot){0, 0});
        label.to = label.from;
        // Nothing else than one label, and all that is drawn.
        Labels *labels = labels_new(canvas);
        for (int i = 0; i < LINES; i++)
            labels_line(labels, drawing.from[i], drawing.to[i], 2);
        for (int i = 0; i < DISCS; i++)
            labels_disc(labels, drawing.disc[i], drawing.radius[i]);
        labels_add(labels, label);
        labels_place(labels);
        bool room = false;
        for (int i = 0; i < 4; i++) {
            double du = (int[]){1, -1, 0, 0}[i] * (label.width / 2 + 10),
                   dv = (int[]){0, 0, 1, -1}[i] * (label.height / 2 + 10);
            PlacedLabel there = label;
            there.middle = (Spot){label.from.u + du, label.from.v + dv};
            room =
                room || (is_inside(box_of(there)) && gap_to_drawing(box_of(there), &drawing) > 7);
        }
        given("drawing", "%d", k);
        if (room)
            expect_law(!labels_get(labels, 0).leads, "no leader", "a leader");
        labels_free(labels);
    }
}

// In the middle of a grid that is too narrow for any text.
static void shut_in(double half_width, double half_height)
{
    Labels *labels = labels_new(canvas);
    for (double u = -half_width; u <= half_width; u += 10)
        labels_line(labels, (Spot){480 + u, 240 - half_height}, (Spot){480 + u, 240 + half_height},
                    1);
    for (double v = -half_height; v <= half_height; v += 10)
        labels_line(labels, (Spot){480 - half_width, 240 + v}, (Spot){480 + half_width, 240 + v},
                    1);
    Spot middle = {480, 240};
    labels_add(labels, (PlacedLabel){.from = middle, .to = middle, .width = 40, .height = 26});
    labels_place(labels);
    PlacedLabel label = labels_get(labels, 0);
    expect_law(label.leads, "a leader", "none");
    expect_law(fabs(label.middle.u - 480) > half_width || fabs(label.middle.v - 240) > half_height,
               "outside of the grid", "in it");
    expect_pair(label.end.u, label.end.v, 480, 240, 1e-9);
    labels_free(labels);
}

TEST(labels_place, a_label_that_is_shut_in_has_a_leader)
{
    shut_in(60, 60);
    shut_in(300, 230); // out of the grid only far away
}

// The same labels, bit by bit.
static void expect_same(const Labels *labels, const Labels *others)
{
    for (int i = 0; i < LABELS; i++) {
        PlacedLabel one = labels_get(labels, i), other = labels_get(others, i);
        given("label", "%d", i);
        expect_pair(one.middle.u, one.middle.v, other.middle.u, other.middle.v, 0);
        expect_int(one.leads, other.leads);
    }
}

TEST(labels_place, the_order_of_what_is_drawn_does_not_matter)
{
    for (int k = 0; k < DRAWINGS; k++) {
        Drawing drawing = some_drawing();
        Labels *labels = labels_for(&drawing, 0),
               *others = labels_for(&drawing, 1 + k % (LINES - 1));
        expect_same(labels, others);
        labels_free(labels);
        labels_free(others);
    }
}

TEST(labels_place, each_label_is_nearest_to_what_it_names)
{
    for (int k = 0; k < DRAWINGS; k++) {
        Labels *labels = labels_new(canvas);
        Spot spots[LABELS];
        for (int i = 0; i < LABELS; i++) {
            spots[i] = anywhere();
            labels_disc(labels, spots[i], 5);
            labels_add(labels, some_label(spots[i], spots[i]));
        }
        labels_place(labels);
        for (int i = 0; i < LABELS; i++) {
            PlacedLabel label = labels_get(labels, i);
            for (int j = 0; j < LABELS && !label.leads; j++) {
                given("drawing, label and place", "%d, %d, %d", k, i, j);
                expect_law(gap(box_of(label), spots[i]) <= gap(box_of(label), spots[j]),
                           "nearest to its own place", "nearer to another one");
            }
        }
        labels_free(labels);
    }
}

TEST(labels_place, words_that_name_no_place_are_where_there_is_room)
{
    Drawing drawing = some_drawing();
    Labels *labels = labels_new(canvas);
    for (int i = 0; i < LINES; i++)
        labels_line(labels, drawing.from[i], drawing.to[i], 2);
    labels_add(labels, (PlacedLabel){.free = true, .from = {10, 464}, .width = 120, .height = 50});
    labels_place(labels);
    PlacedLabel label = labels_get(labels, 0);
    expect_law(is_inside(box_of(label)), "inside the canvas", "outside");
    expect_law(!label.leads, "no leader", "a leader");
    labels_free(labels);
    labels = labels_new(canvas);
    labels_add(labels, (PlacedLabel){.free = true, .from = {10, 464}, .width = 120, .height = 50});
    labels_place(labels);
    label = labels_get(labels, 0);
    expect_pair(label.middle.u, label.middle.v, 70, 439, 1e-9);
    labels_free(labels);
}

TEST(labels_place, nothing_to_place_and_what_is_not_finite_are_harmless)
{
    Labels *labels = labels_new(canvas);
    labels_line(labels, (Spot){NAN, 0}, (Spot){100, INFINITY}, 2);
    labels_disc(labels, (Spot){0, -INFINITY}, 3);
    labels_place(labels);
    expect_number(labels_cost(labels), 0, 0);
    labels_free(labels);
    labels = labels_new(canvas);
    labels_add(labels, (PlacedLabel){.free = true, .width = 5000, .height = 50});
    labels_place(labels); // it is larger than the canvas
    expect_law(labels_cost(labels) >= LABEL_FINE, "a fine", "none");
    labels_free(labels);
}

TEST(labels_text_width, text_is_as_wide_as_in_the_font)
{
    const struct {
        const char *text;
        double units; // of 2048
    } known[] = {{"A", 1401}, {"i", 569},  {"(", 799},  {"0", 1303}, {" ", 651},
                 {"−", 1716}, {"w", 1675}, {"=", 1716}, {",", 651},  {"m", 1995}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        given("text", "'%s'", known[i].text);
        expect_number(labels_text_width(known[i].text, 24), known[i].units / 2048 * 24, 0.02);
    }
    expect_number(labels_text_width("", 24), 0, 0);
    expect_number(labels_text_width("(0, 0)", 24), (2 * 799 + 2 * 1303 + 2 * 651) / 2048.0 * 24,
                  0.1);
}
