// plot_fit.c - figures: what has to be seen, $fit, which the layout chooses its window by.
#include "common/figure/gnuplot.h"
#include "common/figure/plot_internal.h"

#include <stdlib.h>

void plot_fit(Plot *plot, vec3 center, double radius)
{
    if (!vec3_is_finite(center) || !isfinite(radius))
        return;
    const double numbers[] = {center[0], center[1], center[2], radius};
    for (int i = 0; i < 4; i++)
        fprintf(plot->fit, "%s%c", gnuplot_number(numbers[i]).s, i < 3 ? ' ' : '\n');
    plot_view_fit(plot, center, radius);
}

void plot_fit_wrong(Plot *plot, vec3 place)
{
    enum { TIMES = 3 };
    const char *row;
    double x, y, z, radius, far = 0, away = INFINITY;
    vec3 first = place;
    int used, count = 0;
    for (size_t left = plot_right_rows(plot, "fit", &row); left > 0;
         left -= (size_t)used, row += used) {
        if (sscanf(row, "%lf %lf %lf %lf\n%n", &x, &y, &z, &radius, &used) != 4)
            return;
        vec3 seen = vec3_of(x, y, z);
        first = count++ == 0 ? seen : first;
        far = fmax(far, vec3_length(seen - first) + radius);
        away = fmin(away, vec3_length(place - seen));
    }
    if (away <= TIMES * far)
        plot_fit(plot, place, 0);
}

// The right parts must be visible, however wrong the others are.
void plot_fit_end(Plot *plot)
{
    fclose(plot->fit);
    const char *right = "";
    int size = (int)plot_right_rows(plot, "fit", &right);
    fprintf(plot->script, "$fit << EOD\n# x y z radius of what has to be seen\n%.*s%sEOD\n", size,
            right, plot->fit_text);
    free(plot->fit_text);
}
