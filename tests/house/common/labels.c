// labels.c - tests of common/figure/labels.c: where labels stand.
// Expected: nothing meets a label as long as there is room for it somewhere.
#include "common/figure/labels.h"

#include "tests/judge/test.h"

// A label in the middle of the canvas, and a disc around it that leaves room only at the edges:
// farther away than the places around a spot.
TEST(labels_place, a_label_without_room_near_by_goes_far_away)
{
    const Spot middle = {300, 300};
    Labels *labels = labels_new((Area){0, 600, 0, 600});
    labels_disc(labels, middle, 250);
    int number =
        labels_add(labels, (PlacedLabel){.from = middle, .to = middle, .width = 60, .height = 20});
    labels_place(labels);
    double cost = labels_cost(labels);
    PlacedLabel label = labels_get(labels, number);
    labels_free(labels);
    given("", "a disc of radius 250 on a canvas of 600");
    expect_law(cost < LABEL_FINE, "it meets nothing", "it meets something");
    expect_law(label.leads, "a leader shows what it names", "it has no leader");
}
