// 08-boxes.c - a small hierarchy of boxes, and a picture of how many spheres each ray asks.
//
// Optional, after chapter 08. After each change: make optional TASK=boxes
#include "chapters/shared/task.h"
#include "common/answers.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <stdlib.h>

// All points between least and most, along each axis.
typedef struct {
    vec3 least, most;
} Box;

// Where the ray enters the box: the smallest t >= 0 at which it is inside, so 0 if it starts
// inside; or NO_HIT if it misses the box. Between which t is it between the two sides along x?
// Between which along y, along z? It is in the box when all three are true. A direction may be 0
// along an axis.
static double enters(Ray ray, Box box)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

// ---- the hierarchy ------------------------------------------------------------------------------

enum { SPHERES = 400, LEAF = 2 };

static Sphere spheres[SPHERES];

// Round a ball, along a spiral from pole to pole.
static void place_spheres(Sphere ball)
{
    for (int i = 0; i < SPHERES; i++) {
        double y = 1 - (2 * i + 1.0) / SPHERES, angle = 2.399963 * i;
        vec3 out = vec3_of(sqrt(1 - y * y) * cos(angle), y, sqrt(1 - y * y) * sin(angle));
        spheres[i] = (Sphere){ball.center + 1.15 * ball.radius * out, 0.12 * ball.radius, 0};
    }
}

static Box box_of(int from, int to)
{
    Box box = {vec3_of(INFINITY, INFINITY, INFINITY), vec3_of(-INFINITY, -INFINITY, -INFINITY)};
    for (int i = from; i < to; i++)
        for (int k = 0; k < 3; k++) {
            box.least[k] = fmin(box.least[k], spheres[i].center[k] - spheres[i].radius);
            box.most[k] = fmax(box.most[k], spheres[i].center[k] + spheres[i].radius);
        }
    return box;
}

static int axis;

static int compare(const void *a, const void *b)
{
    double x = ((const Sphere *)a)->center[axis], y = ((const Sphere *)b)->center[axis];
    return (x > y) - (x < y);
}

// A node is a range of spheres. Its children are the two halves along its longest side.
static Box boxes[2 * SPHERES];

static void build(int node, int from, int to)
{
    Box box = boxes[node] = box_of(from, to);
    if (to - from <= LEAF)
        return;
    vec3 side = box.most - box.least;
    axis = side[0] >= side[1] && side[0] >= side[2] ? 0 : side[1] >= side[2] ? 1 : 2;
    qsort(spheres + from, (size_t)(to - from), sizeof *spheres, compare);
    int middle = from + (to - from) / 2;
    build(node + 1, from, middle);
    build(node + 2 * (middle - from), middle, to);
}

typedef struct {
    Ray ray;
    double nearest;
    int asked;
} Search;

// The nearer child first; a box that begins beyond the nearest hit is not entered.
static void search(Search *search_, int node, int from, int to)
{
    if (to - from <= LEAF) {
        for (int i = from; i < to; i++, search_->asked++)
            search_->nearest = fmin(search_->nearest, hit_sphere(search_->ray, spheres[i]));
        return;
    }
    int middle = from + (to - from) / 2, left = node + 1, right = node + 2 * (middle - from);
    double enters_left = enters(search_->ray, boxes[left]);
    double enters_right = enters(search_->ray, boxes[right]);
    bool left_first = enters_left <= enters_right;
    for (int i = 0; i < 2; i++) {
        bool is_left = left_first == (i == 0);
        if ((is_left ? enters_left : enters_right) < search_->nearest)
            search(search_, is_left ? left : right, is_left ? from : middle, is_left ? middle : to);
    }
}

// Dark blue: no sphere is asked; red, yellow and white: many of them.
static Color color_of_count(int asked)
{
    double x = asked / 5.0;
    return vec3_of(fmin(x, 1), fmin(fmax(x - 0.6, 0), 1), asked == 0 ? 0.2 : fmax(x - 1.5, 0));
}

static Color color_of_pixel(const Drawing *drawing, Pixel pixel)
{
    static bool built;
    if (!built) {
        place_spheres(drawing->scene.spheres[0]);
        build(0, 0, SPHERES);
        built = true;
    }
    Search all = {pixel_ray(drawing->camera, drawing->image.size, pixel), NO_HIT, 0};
    if (enters(all.ray, boxes[0]) < NO_HIT)
        search(&all, 0, 0, SPHERES);
    double light = all.nearest < NO_HIT ? 1 : 0.6;
    return light * color_of_count(all.asked);
}

int main(int argc, char **argv)
{
    return task_run(argc, argv,
                    (Task){.purpose = "Draws how many of 400 spheres each ray asks.",
                           .scene = "exercises/optional/ball.nff",
                           .size = {256, 160},
                           .color = color_of_pixel});
}
