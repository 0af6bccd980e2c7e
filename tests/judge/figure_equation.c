// figure_equation.c - the parabola of a quadratic, and its roots on the t axis.
#include "tests/judge/figure.h"

#include "common/figure/beside.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/numbers.h"

#include <stdio.h>
#include <string.h>

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

static bool are_drawable(Roots roots)
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
        WIRE_GET(wrong->question, Quadratic, equation.right);
        equation.yours = equation.right;
        WIRE_GET(wrong->right, Roots, equation.right_roots);
        WIRE_GET(wrong->yours, Roots, equation.your_roots);
        return are_drawable(equation.your_roots) && is_finite(equation.right) &&
               (equation.right.a != 0 || equation.right.b != 0);
    }
    WIRE_GET(wrong->right, Quadratic, equation.right);
    WIRE_GET(wrong->yours, Quadratic, equation.yours);
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

static Roots shown(Roots roots, Range *t)
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
    Roots yours = equation.your_roots, seen = shown(yours, &t);
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
                  (Label){"right", "blue", .block = "curve", .row = rows / 6, .part = ANYWHERE});
        if (your_rows > 6) // else it is too high or too low to be seen
            plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "your_curve",
                                    .row = your_rows * 5 / 6, .part = ANYWHERE});
    }
    Axis axis = {
        t.low,     t.high, 1, 0, equation.right_roots.t, seen.t, equation.right_roots.count,
        seen.count};
    figure_axis(plot, &axis);
    if (equation.are_roots)
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){root_words(equation.right_roots, true).s,
                                   root_words(yours, seen.count == yours.count).s, ""});
    else
        beside_below(plot, wrong->function, wrong->why,
                     (BesideWords){quadratic_words(equation.right).s,
                                   quadratic_words(equation.yours).s, ""});
}
