// beside.c - a wrong answer beside the right one: two vectors, and the words on them.
#include "common/figure/plot.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void vector(Plot *plot, const char *name, vec3 from, vec3 v)
{
    plot_block(plot, name, "x y z of its start, x y z of the vector");
    plot_row_vector(plot, from, v);
    plot_fit(plot, from, 0);
    plot_fit(plot, from + v, 0);
}

void beside_vectors(Plot *plot, vec3 right_from, vec3 right, vec3 yours_from, vec3 yours)
{
    vector(plot, "answer", right_from, right);
    vector(plot, "yours", yours_from, yours);
    vector(plot, "off", right_from + right, yours_from + yours - right_from - right);
}

void beside_words(Plot *plot, BesideWords words)
{
    plot_label(plot, "answer", words.right);
    plot_label(plot, "yours", words.yours);
    plot_label(plot, "off", words.off);
    plot_text(plot, "drawn", words.drawn);
}

static void paragraph(Plot *plot, const char *color, const char *name, const char *words)
{
    char text[400];
    snprintf(text, sizeof text, "%s%s", name, words);
    if (words[0] != '\0')
        plot_below(plot, color, text);
}

void beside_below(Plot *plot, const char *asked, const char *why, BesideWords words)
{
    char yours[40];
    plot_text(plot, "asked", asked);
    plot_text(plot, "why", why);
    beside_words(plot, words);
    paragraph(plot, "blue", "expected: ", words.right);
    snprintf(yours, sizeof yours, "yours%s%s: ", words.drawn[0] != '\0' ? ", " : "", words.drawn);
    paragraph(plot, "ink", yours, words.yours);
    paragraph(plot, "ink", "", words.off);
    if (why[0] != '\0')
        plot_below(plot, "grey", why);
}

void beside_names(Plot *plot)
{
    plot_name(plot, (Label){"expected", "blue", .block = "answer", .part = 1});
    plot_name(plot, (Label){"yours", "ink", .step = 2, .block = "yours", .part = 1});
}

// So many halves, thirds, ... tenths; false where it is none of these.
static bool fraction(double x, int *numerator, int *denominator)
{
    for (int below = 1; below <= 10; below++)
        if (fabs(x * below - round(x * below)) < 1e-7 && fabs(x) < 100) {
            *numerator = (int)lround(x * below);
            *denominator = below;
            return true;
        }
    return false;
}

static void add_step(Text *sum, int numerator, int denominator, const char *step)
{
    size_t used = strlen(sum->s);
    char times[24] = "";
    int steps = abs(numerator);
    if (steps == 1 && denominator == 2)
        snprintf(times, sizeof times, "\u00bd ");
    else if (denominator > 1)
        snprintf(times, sizeof times, "%d/%d ", steps, denominator);
    else if (steps > 1)
        snprintf(times, sizeof times, "%d ", steps);
    snprintf(sum->s + used, sizeof sum->s - used, "%s%s%s",
             numerator < 0 ? (used > 0 ? " \u2212 " : "\u2212") : (used > 0 ? " + " : ""), times,
             step);
}

Text beside_off(Camera c, vec3 off)
{
    const double steps[] = {vec3_dot(off, c.forward) / c.distance, vec3_dot(off, c.right) / c.width,
                            vec3_dot(off, c.up) / c.height};
    static const char *const names[] = {"d f", "w r", "h u"};
    Text sum = {""}, text;
    bool simple = true;
    for (int i = 0; simple && i < 3; i++) {
        int numerator, denominator;
        simple = fraction(steps[i], &numerator, &denominator);
        if (simple && numerator != 0)
            add_step(&sum, numerator, denominator, names[i]);
    }
    snprintf(text.s, sizeof text.s, "off by %.70s%s%.70s", vec3_shown(off).s,
             simple && sum.s[0] != '\0' ? " = " : "", simple ? sum.s : "");
    return text;
}
