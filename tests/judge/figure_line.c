// figure_line.c - what is on a t axis: where a ray meets spheres, and the roots of a quadratic.
#include "common/figure/beside.h"
#include "common/ray.h"
#include "common/scene.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/figure.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

// ---- the t axis --------------------------------------------------------------------------------

// Results on a t axis: a flat figure, in which t = 1 is 'unit' to the right.
typedef struct {
    double low, high; // of t
    double unit, y;
    const double *right, *yours; // the results
    int right_count, your_count;
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

static bool is_taken(const double *t, int count, double tick, double stride)
{
    for (int i = 0; i < count; i++)
        if (fabs(t[i] - tick) < 0.3 * stride)
            return true;
    return false;
}

static void axis_row(Plot *plot, const Axis *axis, double t)
{
    plot_row_dot(plot, 4, (const double[]){t * axis->unit, axis->y, 0, t});
}

static void axis_ticks(Plot *plot, const Axis *axis)
{
    double step = stride_of(axis);
    int row = 0;
    plot_block(plot, "ticks", "x y z t");
    for (double n = ceil(axis->low / step); n * step <= axis->high; n++, row++) {
        axis_row(plot, axis, n * step);
        if (is_taken(axis->right, axis->right_count, n * step, step) ||
            is_taken(axis->yours, axis->your_count, n * step, step))
            continue;
        char words[200];
        snprintf(words, sizeof words, "%s", number_text_to(n * step, 10).s);
        replace_all(words, sizeof words, "-", "\u2212");
        plot_name(plot, (Label){words, "grey", .block = "ticks", .row = row});
    }
    plot_block_end(plot);
}

static void axis_marks(Plot *plot, const Axis *axis, const char *name, const double *t, int count,
                       Label label)
{
    plot_block(plot, name, "x y z t");
    for (int i = 0; i < count; i++) {
        axis_row(plot, axis, t[i]);
        label.block = name;
        label.row = i;
        plot_name(plot, label);
    }
    plot_block_end(plot);
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
    axis_marks(plot, axis, "answer", axis->right, axis->right_count,
               (Label){"expected", "blue", .step = 1});
    axis_marks(plot, axis, "yours", axis->yours, axis->your_count,
               (Label){"yours", "ink", .step = 2});
    axis_ticks(plot, axis);
}

// The difference of 3.2 and 3.6: "off by 0.4"; empty if one of them is missing.
static Text off_text(double right, double yours)
{
    Text text = {""};
    if (isfinite(right) && isfinite(yours))
        snprintf(text.s, sizeof text.s, "off by %.60s", number_text_to(yours - right, 4).s);
    return text;
}

// ---- rays and spheres --------------------------------------------------------------------------

enum { MOST_SPHERES = 100, MOST_NAMES = 12 };

// The places of an answer: at most two; and which sphere, if the exercise asks for it.
typedef struct {
    int count, sphere;
    double t[2];
} Places;

static struct {
    Ray ray;
    int count;
    Sphere spheres[MOST_SPHERES];
    Places right, yours;
    bool are_roots, has_index;
} section;

static void read_spheres(Numbers *question, bool whole_scene)
{
    Scene scene;
    section.count = 1;
    if (!whole_scene) {
        NUMBERS_GET(question, Sphere, section.spheres[0]);
        return;
    }
    numbers_get(question, &type_Scene, &scene);
    section.count = scene.sphere_count < MOST_SPHERES ? scene.sphere_count : MOST_SPHERES;
    for (int i = 0; i < section.count; i++)
        section.spheres[i] = scene.spheres[i];
    numbers_free_value(&type_Scene, &scene);
}

static Places read_places(Numbers *numbers, const char *results)
{
    Places places = {0, -1, {NO_HIT, NO_HIT}};
    Roots roots = {0};
    Hit hit = {0};
    if (strcmp(results, "Roots") == 0) {
        NUMBERS_GET(numbers, Roots, roots);
        places = (Places){roots.count, -1, {roots.t[0], roots.t[1]}};
    } else if (strcmp(results, "Hit") == 0) {
        NUMBERS_GET(numbers, Hit, hit);
        places = (Places){hit.t != NO_HIT, hit.sphere, {hit.t, NO_HIT}};
    } else {
        NUMBERS_GET(numbers, double, places.t[0]);
        places.count = places.t[0] != NO_HIT;
    }
    return places;
}

static bool are_drawable(Places places)
{
    bool good = places.count >= 0 && places.count <= 2;
    for (int i = 0; good && i < places.count; i++)
        good = isfinite(places.t[i]);
    return good;
}

bool read_section(Wrong *wrong)
{
    const Exercise *types = &exercises[wrong->kept->exercise];
    section.has_index = strcmp(types->results, "Hit") == 0;
    section.are_roots = strcmp(types->results, "Roots") == 0;
    NUMBERS_GET(wrong->question, Ray, section.ray);
    read_spheres(wrong->question, section.has_index);
    section.right = read_places(wrong->right, types->results);
    section.yours = read_places(wrong->yours, types->results);
    return are_drawable(section.right) && are_drawable(section.yours) &&
           (section.right.count > 0 || section.yours.count > 0) &&
           vec3_length(section.ray.direction) > 0;
}

// Along the ray and to its side, each sphere rotated around the ray into the paper: the first
// below.
static void write_spheres(Plot *plot, Range *x, Range *y)
{
    vec3 along = vec3_unit(section.ray.direction), below = vec3_of(0, 0, 0);
    plot_block(plot, "spheres", "along the ray, aside, radius, which");
    for (int i = 0; i < section.count; i++) {
        vec3 center = section.spheres[i].center - section.ray.origin;
        double r = section.spheres[i].radius, ahead = vec3_dot(center, along);
        vec3 away = center - ahead * along;
        if (vec3_length(below) == 0)
            below = away;
        double aside = vec3_length(away) * (vec3_dot(away, below) < 0 ? 1 : -1);
        plot_row(plot, 4, (const double[]){ahead, aside, r, i});
        plot_circle(plot, vec3_of(ahead, aside, 0), r);
        plot_fit(plot, vec3_of(ahead, aside, 0), r);
        if (section.has_index && i < MOST_NAMES)
            plot_name(plot, (Label){number_text(i).s, "grey", .place = vec3_of(ahead, aside, 0),
                                    .ball = r});
        if (i == 0)
            *x = (Range){ahead - r, ahead + r};
        range_add(x, ahead - r);
        range_add(x, ahead + r);
        range_add(y, aside - r);
        range_add(y, aside + r);
    }
    plot_block_end(plot);
}

static Text words_of(Places places, bool all_shown)
{
    Text text;
    const char *beyond = all_shown ? "" : " (not in the figure)";
    if (places.count == 0)
        snprintf(text.s, sizeof text.s, section.are_roots ? "no root" : "no hit");
    else if (places.count == 2)
        snprintf(text.s, sizeof text.s, "t = %.40s and %.40s%s", number_text(places.t[0]).s,
                 number_text(places.t[1]).s, beyond);
    else if (section.has_index)
        snprintf(text.s, sizeof text.s, "sphere %d at t = %.40s%s", places.sphere,
                 number_text(places.t[0]).s, beyond);
    else
        snprintf(text.s, sizeof text.s, "t = %.40s%s", number_text(places.t[0]).s, beyond);
    return text;
}

// Those that are visible beside the others.
static Places shown(Places places, Range *x, double unit)
{
    Places some = {0, places.sphere, {0, 0}};
    for (int i = 0; i < places.count; i++)
        if (range_try(x, places.t[i] * unit))
            some.t[some.count++] = places.t[i];
    return some;
}

void write_section(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    double unit = vec3_length(section.ray.direction);
    Range x = {0, unit}, y = {0, 0};
    Places right = section.right, yours = section.yours;
    plot_look_flat(plot);
    plot_number(plot, "unit", unit);
    write_spheres(plot, &x, &y);
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
    Axis axis = {low / unit, high / unit, unit,        y.low - 0.09 * wide,
                 right.t,    seen.t,      right.count, seen.count};
    write_axis(plot, &axis);
    for (int i = 0; i < right.count; i++)
        plot_line(plot, vec3_of(right.t[i] * unit, axis.y, 0), vec3_of(right.t[i] * unit, 0, 0), 0,
                  0);
    for (int i = 0; i < seen.count; i++)
        plot_line(plot, vec3_of(seen.t[i] * unit, axis.y, 0), vec3_of(seen.t[i] * unit, 0, 0), 0,
                  0);
    Text off = {""};
    if (right.count == 1 && yours.count == 1)
        off = off_text(right.t[0], yours.t[0]);
    beside_below(plot, wrong->function, wrong->why,
                 (BesideWords){words_of(right, true).s,
                               words_of(yours, seen.count == yours.count).s, off.s,
                               seen.count > 0 ? "dashed" : ""});
}

// ---- the parabola of a quadratic, and its roots on the t axis ----------------------------------

enum { SAMPLES = 120 };

static struct {
    bool are_roots; // the equation is given; else it is the answer
    Quadratic right, yours;
    Roots right_roots, your_roots;
} equation;

static double value(Quadratic q, double t)
{
    return (q.a * t + q.b) * t + q.c;
}

static bool is_finite(Quadratic q)
{
    return isfinite(q.a) && isfinite(q.b) && isfinite(q.c);
}

static bool are_finite(Roots roots)
{
    bool good = roots.count >= 0 && roots.count <= 2;
    for (int i = 0; good && i < roots.count; i++)
        good = isfinite(roots.t[i]);
    return good;
}

bool read_equation(Wrong *wrong)
{
    equation.are_roots = strcmp(exercises[wrong->kept->exercise].results, "Roots") == 0;
    equation.right_roots = equation.your_roots = (Roots){0};
    if (equation.are_roots) {
        NUMBERS_GET(wrong->question, Quadratic, equation.right);
        equation.yours = equation.right;
        NUMBERS_GET(wrong->right, Roots, equation.right_roots);
        NUMBERS_GET(wrong->yours, Roots, equation.your_roots);
        return are_finite(equation.your_roots) && is_finite(equation.right) &&
               (equation.right.a != 0 || equation.right.b != 0);
    }
    NUMBERS_GET(wrong->right, Quadratic, equation.right);
    NUMBERS_GET(wrong->yours, Quadratic, equation.yours);
    return is_finite(equation.yours) && equation.right.a != 0;
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
static Range range_of(Quadratic q, Roots roots)
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
    plot_block_end(plot);
    return rows;
}

static Text quadratic_words(Quadratic q)
{
    Text text;
    snprintf(text.s, sizeof text.s, "a = %.40s, b = %.40s, c = %.40s", number_text(q.a).s,
             number_text(q.b).s, number_text(q.c).s);
    return text;
}

static Text root_words(Roots roots, bool all_shown)
{
    Text text;
    const char *beyond = all_shown ? "" : " (not in the figure)";
    if (roots.count == 0)
        snprintf(text.s, sizeof text.s, "no root");
    else if (roots.count == 1)
        snprintf(text.s, sizeof text.s, "t = %.40s%s", number_text(roots.t[0]).s, beyond);
    else
        snprintf(text.s, sizeof text.s, "t = %.40s and %.40s%s", number_text(roots.t[0]).s,
                 number_text(roots.t[1]).s, beyond);
    return text;
}

static Roots shown_roots(Roots roots, Range *t)
{
    Roots some = {0};
    for (int i = 0; i < roots.count; i++)
        if (range_try(t, roots.t[i]))
            some.t[some.count++] = roots.t[i];
    return some;
}

void write_equation(Plot *plot, void *given)
{
    const Wrong *wrong = given;
    Range t = range_of(equation.right, equation.right_roots), f = {0, 0};
    add_values(&f, equation.right, t);
    Roots yours = equation.your_roots, seen = shown_roots(yours, &t);
    if (!equation.are_roots && equation.yours.a != 0) {
        Range other = range_of(equation.yours, yours);
        if (range_try(&t, other.low) && range_try(&t, other.high))
            add_values(&f, equation.yours, other);
    }
    if (t.low > 0 && t.low < t.high - t.low)
        t.low = 0;
    double scale = 0.4 * (t.high - t.low) / (f.high - f.low);
    plot_look_flat(plot);
    plot_number(plot, "are_roots", equation.are_roots);
    plot_number(plot, "scale_of_f", scale);
    plot_label(plot, "equation", quadratic_words(equation.right).s);
    int rows = write_curve(plot, "curve", equation.right, t, f, scale);
    int your_rows = write_curve(plot, "your_curve", equation.yours, t, f, scale);
    if (!equation.are_roots) {
        plot_name(plot,
                  (Label){"expected", "blue", .block = "curve", .row = rows / 6, .part = ANYWHERE});
        if (your_rows > 6) // else it is too high or too low to be seen
            plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "your_curve",
                                    .row = your_rows * 5 / 6, .part = ANYWHERE});
    }
    Axis axis = {
        t.low,     t.high, 1, 0, equation.right_roots.t, seen.t, equation.right_roots.count,
        seen.count};
    write_axis(plot, &axis);
    if (equation.are_roots)
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){root_words(equation.right_roots, true).s,
                                   root_words(yours, seen.count == yours.count).s, "",
                                   seen.count > 0 ? "as rings" : ""});
    else
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){quadratic_words(equation.right).s,
                                   quadratic_words(equation.yours).s, "", "dashed"});
}
