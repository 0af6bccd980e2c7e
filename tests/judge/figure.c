// figure.c - a wrong answer beside the right one: the kind of figure, and its file.
#include "tests/judge/figure.h"

#include "common/figure/plot.h"
#include "common/image.h"
#include "common/ray.h"
#include "common/scene.h"
#include "common/screen.h"
#include "common/sphere.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/numbers.h"
#include "tests/judge/table.h"

#include <stdio.h>
#include <string.h>

// One call. The numbers are read from their beginning.
typedef struct Wrong {
    const char *function;
    const Numbers *corners; // of the image plane, from the eye, if the argument is a camera
    Numbers *question, *right, *yours;
    const char *why; // the mistake's sentence; empty if there is none
    bool (*draw)(Plot *plot, struct Wrong *wrong);
    bool is_drawn;
} Wrong;

// What was read is not a call, or not its results.
static bool is_bad(const Wrong *wrong)
{
    return wrong->question->bad || wrong->right->bad || wrong->yours->bad;
}

static const Exercise *exercise_of(const Wrong *wrong)
{
    return &exercises[exercise_number(wrong->function)];
}

// Which function the figure is about, the words below it, and why the answer is wrong.
static void say(Plot *plot, const Wrong *wrong, BesideWords words)
{
    beside_below(plot, wrong->function, wrong->why, words);
}

// From low to high.
typedef struct {
    double low, high;
} Range;

// In the text, as often as there is room.
static void replace_all(char *text, size_t size, const char *old, const char *new)
{
    size_t from = strlen(old), to = strlen(new);
    for (char *at = strstr(text, old); at != NULL; at = strstr(at + to, old)) {
        if (strlen(text) + to - from >= size)
            return;
        memmove(at + to, at + from, strlen(at + from) + 1);
        memcpy(at, new, to);
    }
}

static void range_add(Range *range, double x)
{
    range->low = fmin(range->low, x);
    range->high = fmax(range->high, x);
}

// A number that would make it many times as wide is left out: false.
static bool range_try(Range *range, double x)
{
    enum { TIMES = 8 };
    Range wider = *range;
    range_add(&wider, x);
    if (!(wider.high - wider.low <= TIMES * (range->high - range->low)))
        return false;
    *range = wider;
    return true;
}

// ---- the t axis --------------------------------------------------------------------------------

// The places of an answer: at most two; of a hit, also which sphere.
typedef struct {
    enum { DISTANCE, ROOTS, HIT } kind;
    int count, sphere;
    double t[2];
} Places;

static Places read_places(Numbers *numbers, const char *results)
{
    Roots roots = {0};
    Hit hit = {0};
    double t = NO_HIT;
    if (strcmp(results, "Roots") == 0) {
        NUMBERS_GET(numbers, Roots, roots);
        return (Places){ROOTS, roots.count, -1, {roots.t[0], roots.t[1]}};
    }
    if (strcmp(results, "Hit") == 0) {
        NUMBERS_GET(numbers, Hit, hit);
        return (Places){HIT, hit.t != NO_HIT, hit.sphere, {hit.t, NO_HIT}};
    }
    NUMBERS_GET(numbers, double, t);
    return (Places){DISTANCE, t != NO_HIT, -1, {t, NO_HIT}};
}

static bool are_drawable(Places places)
{
    bool good = places.count >= 0 && places.count <= 2;
    for (int i = 0; good && i < places.count; i++)
        good = isfinite(places.t[i]);
    return good;
}

// Those that are visible beside the others; t = 1 is 'unit' to the right.
static Places shown(Places places, Range *x, double unit)
{
    Places some = {.kind = places.kind, .sphere = places.sphere};
    for (int i = 0; i < places.count; i++)
        if (range_try(x, places.t[i] * unit))
            some.t[some.count++] = places.t[i];
    return some;
}

static Text place_words(Places places, bool all_shown)
{
    Text first = number_shown_to(places.t[0], TEXT_DIGITS);
    const char *beyond = all_shown ? "" : " (not in the figure)";
    return places.count == 0    ? text_of(places.kind == ROOTS ? "no root" : "no hit")
           : places.count == 2  ? text_of("t = %s and %s%s", first.s,
                                          number_shown_to(places.t[1], TEXT_DIGITS).s, beyond)
           : places.kind == HIT ? text_of("sphere %d at t = %s%s", places.sphere, first.s, beyond)
                                : text_of("t = %s%s", first.s, beyond);
}

// seen: those of yours that are visible, as 'drawn' says.
static void say_places(Plot *plot, const Wrong *wrong, Places right, Places yours, Places seen,
                       const char *drawn)
{
    Text off = {""};
    if (right.count == 1 && yours.count == 1 && isfinite(right.t[0]) && isfinite(yours.t[0]))
        off = text_of("off by %s", number_shown_to(yours.t[0] - right.t[0], 4).s);
    say(plot, wrong,
        (BesideWords){place_words(right, true).s, place_words(yours, seen.count == yours.count).s,
                      off.s, seen.count > 0 ? drawn : ""});
}

// Results on a t axis: a flat figure, in which t = 1 is 'unit' to the right.
typedef struct {
    double low, high; // of t
    double unit, y;
    Places right, yours;
} Axis;

// Between round numbers of t: at most eight of them.
static double stride_of(const Axis *axis)
{
    static const double steps[] = {1, 2, 5};
    double step = 0, wide = axis->high - axis->low, power = pow(10, floor(log10(wide / 10)));
    for (int i = 0; wide / (step = power * steps[i % 3]) > 8; i++)
        power *= i % 3 == 2 ? 10 : 1;
    return step;
}

static bool is_taken(Places places, double tick, double stride)
{
    for (int i = 0; i < places.count; i++)
        if (fabs(places.t[i] - tick) < 0.3 * stride)
            return true;
    return false;
}

static void axis_row(Plot *plot, const Axis *axis, double t)
{
    plot_row_dot(plot, vec3_of(t * axis->unit, axis->y, 0), t);
}

static void axis_ticks(Plot *plot, const Axis *axis)
{
    double step = stride_of(axis);
    int row = 0;
    plot_block(plot, "ticks", "x y z t");
    for (double n = ceil(axis->low / step); n * step <= axis->high; n++, row++) {
        axis_row(plot, axis, n * step);
        if (is_taken(axis->right, n * step, step) || is_taken(axis->yours, n * step, step))
            continue;
        plot_name(plot, (Label){number_shown_to(n * step, 10).s, "grey", .block = "ticks",
                                .row = row, .aside = vec3_of(0, 1, 0)});
    }
}

static void axis_marks(Plot *plot, const Axis *axis, const char *name, Places places, Label label)
{
    plot_block(plot, name, "x y z t");
    for (int i = 0; i < places.count; i++) {
        axis_row(plot, axis, places.t[i]);
        label.block = name;
        label.row = i;
        plot_name(plot, label);
    }
}

// $axis and $ticks, with round numbers, except where the results are; $answer and $yours, x y z t,
// on the axis.
static void write_axis(Plot *plot, const Axis *axis)
{
    vec3 begin = vec3_of(axis->low * axis->unit, axis->y, 0);
    vec3 end = vec3_of((axis->high + 0.04 * (axis->high - axis->low)) * axis->unit, axis->y, 0);
    plot_vector(plot, "axis", begin, end - begin);
    plot_fit(plot, begin, 0);
    plot_fit(plot, end, 0);
    plot_name(plot, (Label){"$t$", "grey", .block = "axis", .part = 1});
    axis_marks(plot, axis, "answer", axis->right, (Label){"expected", "blue", .step = 1});
    axis_marks(plot, axis, "yours", axis->yours, (Label){"yours", "ink", .step = 2});
    axis_ticks(plot, axis);
}

// ---- rays and spheres --------------------------------------------------------------------------

enum { MOST_SPHERES = 100, MOST_NAMES = 12 };

typedef struct {
    Ray ray;
    int count;
    Sphere spheres[MOST_SPHERES];
    bool has_names;
} Section;

static Section read_section(Numbers *question, bool whole_scene)
{
    Scene scene;
    Section section = {.count = 1, .has_names = whole_scene};
    NUMBERS_GET(question, Ray, section.ray);
    if (!whole_scene) {
        NUMBERS_GET(question, Sphere, section.spheres[0]);
        return section;
    }
    numbers_get(question, &type_Scene, &scene);
    section.count = scene.sphere_count < MOST_SPHERES ? scene.sphere_count : MOST_SPHERES;
    for (int i = 0; i < section.count; i++)
        section.spheres[i] = scene.spheres[i];
    numbers_free_value(&type_Scene, &scene);
    return section;
}

// Along the ray and to its side, each sphere rotated around the ray into the paper: the first
// below.
static void write_spheres(Plot *plot, const Section *section, Range *x, Range *y)
{
    vec3 along = vec3_unit(section->ray.direction), below = vec3_of(0, 0, 0);
    plot_block(plot, "spheres", "along the ray, aside, radius, which");
    for (int i = 0; i < section->count; i++) {
        vec3 center = section->spheres[i].center - section->ray.origin;
        double r = section->spheres[i].radius, ahead = vec3_dot(center, along);
        vec3 away = center - ahead * along;
        if (vec3_length(below) == 0)
            below = away;
        double aside = vec3_length(away) * (vec3_dot(away, below) < 0 ? 1 : -1);
        plot_row(plot, ahead, aside, r, i);
        plot_circle(plot, vec3_of(ahead, aside, 0), r);
        plot_fit(plot, vec3_of(ahead, aside, 0), r);
        if (section->has_names && i < MOST_NAMES)
            plot_name(plot, (Label){number_shown_to(i, TEXT_DIGITS).s, "grey",
                                    .place = vec3_of(ahead, aside, 0), .ball = r});
        *x = i == 0 ? (Range){ahead - r, ahead + r} : *x;
        range_add(x, ahead - r);
        range_add(x, ahead + r);
        range_add(y, aside - r);
        range_add(y, aside + r);
    }
}

// From the axis to the ray.
static void plot_lines_up(Plot *plot, const Axis *axis, Places places)
{
    for (int i = 0; i < places.count; i++) {
        double x = places.t[i] * axis->unit;
        plot_line(plot, vec3_of(x, axis->y, 0), vec3_of(x, 0, 0), 0, 0);
    }
}

static bool draw_section(Plot *plot, Wrong *wrong)
{
    const char *results = exercise_of(wrong)->results;
    Places right = read_places(wrong->right, results), yours = read_places(wrong->yours, results);
    Section section = read_section(wrong->question, right.kind == HIT);
    double unit = vec3_length(section.ray.direction);
    Range x = {0, unit}, y = {0, 0};
    if (is_bad(wrong) || !are_drawable(right) || !are_drawable(yours) ||
        right.count + yours.count == 0 || !(unit > 0))
        return false;
    plot_look_flat(plot);
    plot_number(plot, "unit", unit);
    write_spheres(plot, &section, &x, &y);
    for (int i = 0; i < right.count; i++)
        range_add(&x, right.t[i] * unit);
    bool has_eye = range_try(&x, 0), has_arrow = has_eye && range_try(&x, unit);
    Places seen = shown(yours, &x, unit);
    double wide = x.high - x.low, low = x.low - 0.04 * wide, high = x.high + 0.04 * wide;
    vec3 p = vec3_of(has_eye ? 0 : NAN, 0, 0), v = vec3_of(has_arrow ? unit : NAN, 0, 0);
    plot_vector(plot, "ray", vec3_of(low, 0, 0), vec3_of(high - low, 0, 0));
    plot_fit(plot, vec3_of(low, 0, 0), 0.015 * wide);
    plot_fit(plot, vec3_of(high, 0, 0), 0.015 * wide);
    plot_point(plot, "p", p);
    plot_vector(plot, "v", vec3_of(0, 0, 0), v);
    plot_name(plot, (Label){"$p$", "blue", .block = "p"});
    if (unit > 0.06 * wide)
        plot_name(plot, (Label){"$v$", "blue", .block = "v", .part = ANYWHERE});
    Axis axis = {low / unit, high / unit, unit, y.low - 0.09 * wide, right, seen};
    write_axis(plot, &axis);
    plot_lines_up(plot, &axis, right);
    plot_lines_up(plot, &axis, seen);
    say_places(plot, wrong, right, yours, seen, "dashed");
    return true;
}

// ---- the parabola of a quadratic, and its roots on the t axis ----------------------------------

enum { SAMPLES = 120 };

static double value(Quadratic q, double t)
{
    return (q.a * t + q.b) * t + q.c;
}

static bool is_finite(Quadratic q)
{
    return isfinite(q.a) && isfinite(q.b) && isfinite(q.c);
}

// The lowest or highest point of the parabola, by search: each step removes a third of the range.
static double turning_point(Quadratic q)
{
    double reach = 1 + (fabs(q.b) + fabs(q.c)) / fabs(q.a), low = -reach, high = reach;
    for (int i = 0; i < 200; i++) {
        double t = low + (high - low) / 3, u = high - (high - low) / 3;
        if ((value(q, t) < value(q, u)) == (q.a > 0))
            high = u;
        else
            low = t;
    }
    return (low + high) / 2;
}

// As far to both sides as the curve needs to return to 0 and go on as far again.
static Range range_of(Quadratic q, Places roots)
{
    if (q.a == 0) {
        double root = roots.count > 0 ? roots.t[0] : 0, aside = fmax(1, fabs(root));
        return (Range){root - aside, root + aside};
    }
    double middle = turning_point(q), depth = fabs(value(q, middle)), aside = 1e-3;
    double enough = depth > 1e-9 * (1 + fabs(q.c)) ? 2 * depth : fabs(q.a);
    while (fabs(value(q, middle + aside) - value(q, middle)) < enough)
        aside *= 1.1;
    return (Range){middle - aside, middle + aside};
}

static void add_values(Range *f, Quadratic q, Range t)
{
    for (int i = 0; i <= SAMPLES; i++)
        range_add(f, value(q, t.low + (t.high - t.low) * i / SAMPLES));
}

// The part of a curve that is not far above or below the other. f is drawn 'scale' times as high.
// Returns how many rows there are.
static int write_curve(Plot *plot, const char *name, Quadratic q, Range t, Range f, double scale)
{
    double room = 0.1 * (f.high - f.low);
    int rows = 0;
    bool begun = false;
    plot_block(plot, name, "x y z: t and f(t), scaled");
    for (int i = 0; i <= SAMPLES; i++) {
        double at = t.low + (t.high - t.low) * i / SAMPLES, height = value(q, at);
        bool seen = height >= f.low - room && height <= f.high + room;
        if (seen) {
            plot_row_point(plot, vec3_of(at, scale * height, 0));
            plot_fit(plot, vec3_of(at, scale * height, 0), 0);
            rows++;
        } else if (begun) { // two empty lines would end the block
            plot_gap(plot);
        }
        begun = seen;
    }
    return rows;
}

static Text quadratic_words(Quadratic q)
{
    return text_of("a = %s, b = %s, c = %s", number_shown_to(q.a, TEXT_DIGITS).s,
                   number_shown_to(q.b, TEXT_DIGITS).s, number_shown_to(q.c, TEXT_DIGITS).s);
}

// The equation is given, and its roots are the answer; or it is the answer itself.
static bool draw_equation(Plot *plot, Wrong *wrong)
{
    const char *results = exercise_of(wrong)->results;
    bool are_roots = strcmp(results, "Roots") == 0;
    Quadratic right, yours;
    Places right_roots = {.count = 0}, your_roots = {.count = 0};
    NUMBERS_GET(are_roots ? wrong->question : wrong->right, Quadratic, right);
    if (are_roots) {
        yours = right;
        right_roots = read_places(wrong->right, results);
        your_roots = read_places(wrong->yours, results);
    } else {
        NUMBERS_GET(wrong->yours, Quadratic, yours);
    }
    if (is_bad(wrong) || !are_drawable(your_roots) || !is_finite(yours) ||
        (right.a == 0 && !(are_roots && right.b != 0)))
        return false;
    Range t = range_of(right, right_roots), f = {0, 0};
    add_values(&f, right, t);
    Places seen = shown(your_roots, &t, 1);
    if (!are_roots && yours.a != 0) {
        Range other = range_of(yours, your_roots);
        if (range_try(&t, other.low) && range_try(&t, other.high))
            add_values(&f, yours, other);
    }
    if (t.low > 0 && t.low < t.high - t.low)
        t.low = 0;
    double scale = 0.4 * (t.high - t.low) / (f.high - f.low);
    plot_look_flat(plot);
    plot_number(plot, "are_roots", are_roots);
    plot_number(plot, "scale_of_f", scale);
    plot_label(plot, "equation", quadratic_words(right).s);
    int rows = write_curve(plot, "curve", right, t, f, scale);
    int your_rows = write_curve(plot, "your_curve", yours, t, f, scale);
    if (!are_roots) {
        plot_name(plot,
                  (Label){"expected", "blue", .block = "curve", .row = rows / 6, .part = ANYWHERE});
        if (your_rows > 6) // else it is too high or too low to be seen
            plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "your_curve",
                                    .row = your_rows * 5 / 6, .part = ANYWHERE});
    }
    write_axis(plot, &(Axis){t.low, t.high, 1, 0, right_roots, seen});
    if (are_roots)
        say_places(plot, wrong, right_roots, your_roots, seen, "as rings");
    else
        say(plot, wrong,
            (BesideWords){quadratic_words(right).s, quadratic_words(yours).s, "", "dashed"});
    return true;
}

// ---- places on the screen and in the unit square ------------------------------------------------

// A rectangle of the screen, where y counts down, or the unit square, where t counts up. A place as
// it is drawn, and $NAME: its corners, from the left and the top, or the bottom, on.
typedef struct {
    ScreenRectangle box;
    bool is_screen;
} Panel;

static vec3 drawn(Panel panel, const double place[2])
{
    return vec3_of(place[0], panel.is_screen ? -place[1] : place[1], 0);
}

static void write_panel(Plot *plot, const char *name, Panel panel)
{
    ScreenRectangle box = panel.box;
    const double corners[5][2] = {{box.left, box.top},
                                  {box.right, box.top},
                                  {box.right, box.bottom},
                                  {box.left, box.bottom},
                                  {box.left, box.top}};
    plot_block(plot, name, "x y z of the corners");
    for (int i = 0; i < 5; i++) {
        plot_row_point(plot, drawn(panel, corners[i]));
        plot_fit(plot, drawn(panel, corners[i]), 0);
    }
}

// Where it begins and ends, in words.
static void name_panel(Plot *plot, const char *name, Panel panel)
{
    ScreenRectangle box = panel.box;
    plot_name(plot, (Label){pair_shown_to(box.left, box.top, TEXT_DIGITS).s, "grey", .block = name,
                            .row = 0});
    plot_name(plot, (Label){pair_shown_to(box.right, box.bottom, TEXT_DIGITS).s, "grey",
                            .block = name, .row = 2});
}

static const Panel unit_square = {{0, 1, 0, 1}, false};

static Panel whole_screen(Resolution screen)
{
    return (Panel){{0, screen.width, 0, screen.height}, true};
}

static void get_pair(Numbers *numbers, double pair[2])
{
    NUMBERS_GET(numbers, double, pair[0]);
    NUMBERS_GET(numbers, double, pair[1]);
}

static void write_dot(Plot *plot, const char *name, Panel panel, const double place[2])
{
    plot_point(plot, name, drawn(panel, place));
    plot_label(plot, name, pair_shown_to(place[0], place[1], TEXT_DIGITS).s);
    plot_fit(plot, drawn(panel, place), 0);
}

static bool draw_place(Plot *plot, Wrong *wrong)
{
    const Room left_room = {0.03, 0.44, 0.06, 0.84}, right_room = {0.56, 0.97, 0.06, 0.84};
    const Exercise *types = exercise_of(wrong);
    bool has_given = strcmp(types->arguments, "Pixel") != 0;
    double given[2], right[2], yours[2];
    Panel from = unit_square, into = unit_square;
    if (has_given) {
        Resolution screen;
        get_pair(wrong->question, given);
        NUMBERS_GET(wrong->question, Resolution, screen);
        *(strcmp(types->results, "ScreenPoint") == 0 ? &into : &from) = whole_screen(screen);
    } else {
        Pixel pixel;
        NUMBERS_GET(wrong->question, Pixel, pixel);
        into = (Panel){{pixel.column, pixel.column + 1, pixel.row, pixel.row + 1}, true};
    }
    get_pair(wrong->right, right);
    get_pair(wrong->yours, yours);
    Range x = {into.box.left, into.box.right}, y = {into.box.top, into.box.bottom};
    range_add(&x, right[0]);
    range_add(&y, right[1]);
    if (is_bad(wrong) || !range_try(&x, yours[0]) || !range_try(&y, yours[1]))
        return false;
    plot_look_flat(plot);
    plot_number(plot, "has_given", has_given);
    if (has_given) {
        plot_room(plot, right_room, right_room);
        const Room arrow = {0.46, 0.54, 0.42, 0.48};
        plot_keep_clear(plot, arrow, arrow);
    }
    write_panel(plot, "into", into);
    name_panel(plot, "into", into);
    write_dot(plot, "right", into, right);
    write_dot(plot, "yours", into, yours);
    plot_name(plot, (Label){"expected", "blue", .block = "right"});
    plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "yours"});
    plot_panel(plot, 2);
    plot_room(plot, left_room, left_room);
    if (has_given) {
        write_panel(plot, "from", from);
        name_panel(plot, "from", from);
        write_dot(plot, "given", from, given);
        plot_name(plot, (Label){"{given}", "ink", .block = "given"});
    } else {
        plot_point(plot, "from", vec3_of(NAN, NAN, NAN));
        plot_point(plot, "given", vec3_of(NAN, NAN, NAN));
    }
    double by[2]; // rounding is not a difference
    for (int i = 0; i < 2; i++)
        by[i] = same_within(yours[i], right[i], 1e-12) ? 0 : yours[i] - right[i];
    say(plot, wrong,
        (BesideWords){pair_shown_to(right[0], right[1], TEXT_DIGITS).s,
                      pair_shown_to(yours[0], yours[1], TEXT_DIGITS).s,
                      text_of("off by %s", pair_shown_to(by[0], by[1], TEXT_DIGITS).s).s,
                      "as a ring"});
    return true;
}

// ---- a rectangle on the screen: the right one, yours, and the sphere's outline -----------------

// Too small to be seen as a rectangle: the layout marks its place.
static bool is_tiny(ScreenRectangle box, Resolution screen)
{
    return fabs(box.right - box.left) < 0.005 * screen.width &&
           fabs(box.bottom - box.top) < 0.005 * screen.height;
}

// The points of the sphere that are on its outline are a circle, nearer to the eye than the center.
// If the sphere is around the eye, beside it or behind it, there is none.
static void write_outline(Plot *plot, Camera c, Resolution screen, Sphere sphere)
{
    enum { POINTS = 120 };
    vec3 to = sphere.center - c.origin, axis = vec3_unit(to);
    double r = sphere.radius, nearer = 1 - r * r / vec3_dot(to, to);
    bool seen = vec3_dot(to, c.forward) > 1.001 * r;
    vec3 other = fabs(vec3_dot(axis, c.up)) < 0.9 ? c.up : c.right;
    vec3 one = vec3_unit(vec3_cross(axis, other)), two = vec3_cross(axis, one);
    plot_block(plot, "outline", "x y z of the sphere's outline");
    for (int i = 0; i <= POINTS; i++) {
        double angle = 2 * PI * i / POINTS;
        vec3 p = nearer * to + r * sqrt(fmax(nearer, 0)) * (cos(angle) * one + sin(angle) * two);
        double d = c.distance / vec3_dot(p, c.forward);
        double x = (0.5 + d * vec3_dot(p, c.right) / c.width) * screen.width;
        double y = (0.5 - d * vec3_dot(p, c.up) / c.height) * screen.height;
        // Beyond the screen there is nothing to see; a point there is moved to its edge.
        x = fmin(fmax(x, 0), screen.width);
        y = fmin(fmax(y, 0), screen.height);
        if (seen)
            plot_row_point(plot, vec3_of(x, -y, 0));
    }
    if (!seen)
        plot_row_point(plot, vec3_of(0, 0, 0));
}

static Text box_words(ScreenRectangle box)
{
    return text_of("x %s to %s, y %s to %s", number_shown_to(box.left, TEXT_DIGITS).s,
                   number_shown_to(box.right, TEXT_DIGITS).s,
                   number_shown_to(box.top, TEXT_DIGITS).s,
                   number_shown_to(box.bottom, TEXT_DIGITS).s);
}

static bool draw_rectangle(Plot *plot, Wrong *wrong)
{
    Camera camera;
    Resolution size;
    Sphere sphere;
    ScreenRectangle right, yours;
    NUMBERS_GET(wrong->question, Camera, camera);
    NUMBERS_GET(wrong->question, Resolution, size);
    NUMBERS_GET(wrong->question, Sphere, sphere);
    NUMBERS_GET(wrong->right, ScreenRectangle, right);
    NUMBERS_GET(wrong->yours, ScreenRectangle, yours);
    Range x = {0, size.width}, y = {0, size.height};
    if (is_bad(wrong) || !range_try(&x, yours.left) || !range_try(&x, yours.right) ||
        !range_try(&y, yours.top) || !range_try(&y, yours.bottom))
        return false;
    Panel screen = whole_screen(size);
    plot_look_flat(plot);
    write_panel(plot, "frame", screen);
    write_outline(plot, camera, size, sphere);
    write_panel(plot, "answer", (Panel){right, true});
    write_panel(plot, "yours", (Panel){yours, true});
    plot_number(plot, "is_tiny", is_tiny(yours, size));
    name_panel(plot, "frame", screen);
    plot_name(plot, (Label){"expected", "blue", .block = "answer", .row = 1, .part = ANYWHERE});
    plot_name(plot,
              (Label){"yours", "ink", .step = 2, .block = "yours", .row = 3, .part = ANYWHERE});
    say(plot, wrong, (BesideWords){box_words(right).s, box_words(yours).s, "", "dashed"});
    return true;
}

// ---- vectors from the eye to the image plane, rays, and cameras ---------------------------------

enum {
    GRID = 8,
    FAR = 20, // from the right one, as a multiple of its size: no farther is drawn
};

static bool is_near(vec3 yours, vec3 right, double size)
{
    return vec3_is_finite(yours) && vec3_length(yours - right) <= FAR * size;
}

// From whose right side the figure is seen.
static void write_frame(Plot *plot, vec3 right, vec3 up, vec3 forward)
{
    plot_direction(plot, "right", right);
    plot_direction(plot, "up", up);
    plot_direction(plot, "forward", forward);
}

// To 9 digits.
static bool is_same_place(vec3 a, vec3 b)
{
    return vec3_length(a - b) <= 1e-9 * (1 + vec3_length(b));
}

// ---- a vector or a ray from the eye ------------------------------------------------------------

// Of the image plane, whose corners are seen from the eye, from the upper left on.
static void write_plane(Plot *plot, vec3 eye, const vec3 corners[4])
{
    plot_block(plot, "plane", "x y z of the corners, from the upper left on");
    for (int i = 0; i < 5; i++)
        plot_row_point(plot, eye + corners[i % 4]);
    plot_block(plot, "grid", "x y z of the two ends of a line");
    vec3 origin = eye + corners[3], across = corners[2] - corners[3], up = corners[0] - corners[3];
    for (int i = 1; i < GRID; i++) {
        double part = (double)i / GRID;
        plot_row_point(plot, origin + part * across);
        plot_row_point(plot, origin + part * across + up);
        plot_gap(plot);
        plot_row_point(plot, origin + part * up);
        plot_row_point(plot, origin + part * up + across);
        plot_gap(plot);
    }
    for (int i = 0; i < 4; i++)
        plot_fit(plot, eye + corners[i], 0);
}

// The length of a ray is free: it is drawn as long as the right one.
static Ray as_long_as(Ray ray, Ray right)
{
    ray.direction *= vec3_length(right.direction) / vec3_length(ray.direction);
    return ray;
}

static Text ray_words(Ray ray, bool with_origin)
{
    return with_origin ? text_of("from %s along %s", vec3_shown_to(ray.origin, 4).s,
                                 vec3_shown_to(ray.direction, 4).s)
                       : vec3_shown_to(ray.direction, TEXT_DIGITS);
}

static Text ray_off(Ray right, Ray yours)
{
    vec3 off = yours.origin - right.origin;
    vec3 cross = vec3_cross(yours.direction, right.direction);
    double angle = atan2(vec3_length(cross), vec3_dot(yours.direction, right.direction)) * 180 / PI;
    Text points = text_of("points off by %s\u00b0", number_shown_to(angle, 3).s);
    if (!(vec3_length(off) > 1e-9 * (1 + vec3_length(right.origin))))
        return points;
    return text_of(angle < 1e-6 ? "starts off by %s" : "starts off by %s, %s",
                   vec3_shown_to(off, 4).s, points.s);
}

static bool draw_vector(Plot *plot, Wrong *wrong)
{
    Camera c;
    vec3 corners[4] = {{0}};
    NUMBERS_GET(wrong->question, Camera, c);
    for (int i = 0; i < wrong->corners->count; i++)
        corners[i / 3][i % 3] = wrong->corners->at[i];
    bool is_ray = strcmp(exercise_of(wrong)->results, "Ray") == 0;
    Ray right = {.origin = c.origin}, yours = right;
    numbers_get(wrong->right, is_ray ? &type_Ray : &type_vec3,
                is_ray ? (void *)&right : &right.direction);
    numbers_get(wrong->yours, is_ray ? &type_Ray : &type_vec3,
                is_ray ? (void *)&yours : &yours.direction);
    double size = vec3_length(right.direction), length = vec3_length(yours.direction);
    if (is_bad(wrong) || wrong->corners->count != 12 || (is_ray && !(length > 0)) ||
        !is_near(yours.origin, right.origin, size) ||
        !(is_near(yours.direction, right.direction, size) || (is_ray && isfinite(length))))
        return false;
    write_frame(plot, c.right, c.up, c.forward);
    plot_point(plot, "eye", c.origin);
    plot_fit(plot, c.origin, 0);
    write_plane(plot, c.origin, corners);
    if (is_ray) {
        bool moved = !is_same_place(yours.origin, right.origin);
        say(plot, wrong,
            (BesideWords){ray_words(right, moved).s, ray_words(yours, moved).s,
                          ray_off(right, yours).s, "dashed"});
        yours = as_long_as(yours, right);
    } else {
        say(plot, wrong,
            (BesideWords){vec3_shown_to(right.direction, TEXT_DIGITS).s,
                          vec3_shown_to(yours.direction, TEXT_DIGITS).s,
                          beside_off(c, yours.direction - right.direction).s, "dashed"});
    }
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
    plot_look(plot, c.right, c.up, c.forward, 28, 16);
    plot_name(plot, (Label){"$p$", "blue", .block = "eye"});
    beside_names(plot);
    return true;
}

// ---- a ray in object coordinates ---------------------------------------------------------------

static bool draw_ray(Plot *plot, Wrong *wrong)
{
    Ray ray, right, yours;
    Sphere sphere;
    NUMBERS_GET(wrong->question, Ray, ray);
    NUMBERS_GET(wrong->question, Sphere, sphere);
    NUMBERS_GET(wrong->right, Ray, right);
    NUMBERS_GET(wrong->yours, Ray, yours);
    double radius = sphere.radius;
    double size = radius + vec3_length(right.origin) + vec3_length(right.direction);
    if (is_bad(wrong) || !is_near(yours.origin, right.origin, size) ||
        !is_near(yours.direction, right.direction, size))
        return false;
    bool moved = !is_same_place(yours.origin, right.origin);
    // Seen from the side, with the sphere's center not in front of the ray.
    vec3 along = vec3_unit(right.direction);
    vec3 up = -right.origin - vec3_dot(-right.origin, along) * along;
    if (vec3_length(up) < 1e-6 * (1 + vec3_length(right.origin)))
        up = vec3_cross(along, fabs(along[0]) < 0.6 ? vec3_of(1, 0, 0) : vec3_of(0, 1, 0));
    up = vec3_unit(up);
    vec3 center = vec3_of(0, 0, 0), aside = vec3_cross(along, up);
    plot_number(plot, "radius", radius);
    write_frame(plot, aside, up, along);
    plot_look(plot, aside, up, along, 16, 12);
    plot_point(plot, "center", center);
    plot_circle(plot, center, radius);
    plot_fit(plot, center, radius);
    plot_name(plot, (Label){"$C$ = (0, 0, 0)", "ink", .block = "center"});
    beside_names(plot);
    say(plot, wrong,
        (BesideWords){ray_words(right, true).s, ray_words(yours, true).s,
                      moved ? ray_off(right, yours).s : "", "dashed"});
    beside_vectors(plot, right.origin, right.direction, yours.origin, yours.direction);
    return true;
}

// ---- a camera: ahead to the plane, its width, its height ---------------------------------------

static bool is_drawable(Camera c, double size)
{
    return vec3_is_finite(c.origin) && vec3_is_finite(c.right) && vec3_is_finite(c.up) &&
           vec3_is_finite(c.forward) && fabs(c.distance) * vec3_length(c.forward) <= FAR * size &&
           fabs(c.width) * vec3_length(c.right) <= FAR * size &&
           fabs(c.height) * vec3_length(c.up) <= FAR * size;
}

static void write_arms(Plot *plot, const char *name, Camera c)
{
    const vec3 arms[] = {c.distance * c.forward, c.width * c.right, c.height * c.up};
    plot_block(plot, name, "x y z of its start, x y z of the vector: d f, w r, h u");
    for (int i = 0; i < 3; i++) {
        plot_row_vector(plot, c.origin, arms[i]);
        plot_fit(plot, c.origin + arms[i], 0);
    }
    plot_fit(plot, c.origin, 0);
}

static void add_part(Text *words, const char *name, const char *value)
{
    size_t used = strlen(words->s);
    snprintf(words->s + used, sizeof words->s - used, "%s%s %s", used > 0 ? ", " : "", name, value);
}

static void compare_vectors(Text *right, Text *yours, const char *name, vec3 a, vec3 b)
{
    if (is_same_place(b, a))
        return;
    add_part(right, name, vec3_shown_to(a, 4).s);
    add_part(yours, name, vec3_shown_to(b, 4).s);
}

static void compare_numbers(Text *right, Text *yours, const char *name, double a, double b)
{
    if (fabs(a - b) <= 1e-9 * (1 + fabs(a)))
        return;
    add_part(right, name, number_shown_to(a, 4).s);
    add_part(yours, name, number_shown_to(b, 4).s);
}

// Only what differs.
static bool draw_camera(Plot *plot, Wrong *wrong)
{
    CameraFault fault = CAMERA_OK, your_fault = CAMERA_OK;
    Camera a, b;
    if (strcmp(exercise_of(wrong)->results, "Camera") != 0) {
        NUMBERS_GET(wrong->right, CameraFault, fault);
        NUMBERS_GET(wrong->yours, CameraFault, your_fault);
    }
    NUMBERS_GET(wrong->right, Camera, a);
    NUMBERS_GET(wrong->yours, Camera, b);
    double size = a.distance + a.width + a.height;
    if (is_bad(wrong) || fault != CAMERA_OK || your_fault != CAMERA_OK || !is_drawable(b, size) ||
        !is_near(b.origin, a.origin, size))
        return false;
    Text right = {""}, yours = {""};
    compare_numbers(&right, &yours, "d", a.distance, b.distance);
    compare_numbers(&right, &yours, "w", a.width, b.width);
    compare_numbers(&right, &yours, "h", a.height, b.height);
    compare_vectors(&right, &yours, "eye", a.origin, b.origin);
    compare_vectors(&right, &yours, "r", a.right, b.right);
    compare_vectors(&right, &yours, "u", a.up, b.up);
    compare_vectors(&right, &yours, "f", a.forward, b.forward);
    write_frame(plot, a.right, a.up, a.forward);
    plot_look(plot, a.right, a.up, a.forward, 28, 16);
    plot_point(plot, "eye", a.origin);
    write_arms(plot, "answer", a);
    write_arms(plot, "yours", b);
    plot_names(plot, {"$p$", "blue", .block = "eye"},
               {"$d f$", "pink", .block = "answer", .row = 0, .part = 1},
               {"$w r$", "orange", .block = "answer", .row = 1, .part = 1},
               {"$h u$", "green", .block = "answer", .row = 2, .part = 1});
    say(plot, wrong, (BesideWords){right.s, yours.s, "", "dashed"});
    return true;
}

// ---- the kind of figure, and its file -----------------------------------------------------------

// By the arguments and the results, as words (exercise.h); the first that fits. Arguments: how they
// begin.
static const struct {
    const char *arguments, *results;
    const char *layout;
    bool (*draw)(Plot *plot, Wrong *wrong); // false if that cannot be drawn
} kinds[] = {
    {"Camera", "vec3", "chapters/01-corners/figures/yours-and-right.gp", draw_vector},
    {"Camera", "Ray", "chapters/01-corners/figures/yours-and-right.gp", draw_vector},
    {"", "Camera", "tests/judge/layouts/camera.gp", draw_camera},
    {"", "CameraFault Camera", "tests/judge/layouts/camera.gp", draw_camera},
    {"", "Normalized", "tests/judge/layouts/place.gp", draw_place},
    {"", "ScreenPoint", "tests/judge/layouts/place.gp", draw_place},
    {"Camera", "ScreenRectangle", "tests/judge/layouts/rectangle.gp", draw_rectangle},
    {"Ray Sphere", "Ray", "tests/judge/layouts/ray.gp", draw_ray},
    {"Ray", "Quadratic", "tests/judge/layouts/equation.gp", draw_equation},
    {"Quadratic", "Roots", "tests/judge/layouts/equation.gp", draw_equation},
    {"Ray Sphere", "Roots", "tests/judge/layouts/section.gp", draw_section},
    {"Ray Sphere", "double", "tests/judge/layouts/section.gp", draw_section},
    {"Ray Scene", "Hit", "tests/judge/layouts/section.gp", draw_section},
};

static bool path_of(char *path, size_t size, const char *folder, const char *function,
                    const char *ending)
{
    return snprintf(path, size, "%s/%s%s", folder, function, ending) < (int)size;
}

void figure_forget(const char *folder, const char *function)
{
    static const char *const endings[] = {".gp", ".svg", ".txt", ".png"};
    char path[4096];
    for (int i = 0; i < 4; i++)
        if (path_of(path, sizeof path, folder, function, endings[i]))
            remove(path);
}

static void write_data(Plot *plot, void *given)
{
    Wrong *wrong = given;
    wrong->is_drawn = wrong->draw(plot, wrong);
}

static void write_figure(const char *path, Wrong *wrong)
{
    const Exercise *types = exercise_of(wrong);
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(types->results, kinds[i].results) != 0 ||
            strncmp(types->arguments, kinds[i].arguments, strlen(kinds[i].arguments)) != 0)
            continue;
        FILE *file = fopen(path, "w");
        if (file == NULL)
            return;
        wrong->draw = kinds[i].draw;
        Figure figure = {wrong->function, write_data};
        bool good = plot_script(file, kinds[i].layout, &figure, NULL, NULL, wrong);
        if (fclose(file) != 0 || !good || !wrong->is_drawn)
            remove(path);
        return;
    }
}

// Yours, expected, and where they differ, side by side: after the scene and the camera comes the
// image; the results are its pixels.
static bool write_pictures(Wrong *wrong, const char *path)
{
    Scene scene;
    Camera camera;
    Image yours, right = {0};
    Message message;
    numbers_get(wrong->question, &type_Scene, &scene);
    numbers_free_value(&type_Scene, &scene);
    NUMBERS_GET(wrong->question, Camera, camera);
    numbers_get(wrong->question, &type_Image, &yours);
    bool good = !wrong->question->bad && image_create(&right, yours.size, &message);
    if (good) {
        numbers_get_pixels(wrong->yours, &yours);
        numbers_get_pixels(wrong->right, &right);
        size_t bytes = 3 * (size_t)right.size.width * (size_t)right.size.height;
        good = !wrong->yours->bad && !wrong->right->bad &&
               memcmp(yours.rgb, right.rgb, bytes) != 0 &&
               picture_panels_write(&yours, &right, 0, path);
    }
    image_free(&right);
    image_free(&yours);
    return good;
}

// In the terminal, 'looks like' may be followed by a formula with hyphens for minus; here real
// minus signs are drawn.
static void why_of(char *why, size_t size, Diagnosis diagnosis)
{
    const Mistake *mistake = diagnosis.mistake;
    why[0] = '\0';
    if (mistake != NULL)
        snprintf(why, size, "%s%s%s", mistake->formula != NULL ? mistake->formula : "",
                 mistake->formula != NULL ? ": " : "", mistake->why);
    replace_all(why, size, "+-", "\u00b1");
    replace_all(why, size, "- ", "\u2212 ");
}

void figure_write(const char *folder, const Record *record, const Numbers *yours,
                  Diagnosis diagnosis)
{
    char path[4096], why[1000];
    const char *function = record->function;
    const Question *stopped_at = question_of(record);
    if (record->hidden || record->missing[0] != '\0' || yours == NULL || stopped_at == NULL)
        return;
    Numbers question = numbers_again(&stopped_at->arguments),
            right = numbers_again(&stopped_at->results[0]);
    Numbers answer = numbers_again(yours);
    why_of(why, sizeof why, diagnosis);
    Wrong wrong = {function, &stopped_at->corners, &question, &right, &answer, why, NULL, false};
    bool is_picture = strncmp(exercise_of(&wrong)->results, "Pixels", 6) == 0;
    if (!path_of(path, sizeof path, folder, function, is_picture ? ".png" : ".gp"))
        return;
    if (is_picture)
        write_pictures(&wrong, path);
    else
        write_figure(path, &wrong);
}
