// plot_handle.c - figures in a page: what can be dragged, where it is, and which options a drag
// gives.
//
// A handle's place on the canvas follows from the world by the figure's view (plot_view.c). A drag
// goes the other way: from the canvas to the numbers that move the handle, to as many digits as the
// canvas shows.
#include "common/figure/plot_internal.h"
#include "common/text.h"

#include <stdio.h>

enum { NUMBERS = 3, POINT = 3, FEW = 4 };

void plot_handle(Plot *plot, Handle handle)
{
    handle.panel = plot_view_panel(plot);
    if (plot->handle_count < MOST_HANDLES)
        plot->handles[plot->handle_count++] = handle;
}

void plot_handle_point(Plot *plot, const char *words, const char *option, vec3 point, vec3 across,
                       vec3 up)
{
    plot_handle(plot, (Handle){words, point, {option}, POINT, point, .along = {across, up}});
}

void plot_handle_vector(Plot *plot, const char *words, const char *option, vec3 from, vec3 vector,
                        vec3 across, vec3 up)
{
    plot_handle(plot,
                (Handle){words, from + vector, {option}, POINT, vector, .along = {across, up}});
}

void plot_handle_pixel(Plot *plot, vec3 place, Pixel pixel, Resolution size, vec3 across, vec3 down)
{
    plot_handle(plot, (Handle){.words = "the pixel",
                               .place = place,
                               .option = {"pixel"},
                               .count = 2,
                               .value = vec3_of(pixel.column, pixel.row, 0),
                               .along = {across, down},
                               .most = {size.width - 1, size.height - 1},
                               .whole = true});
}

void plot_handle_length(Plot *plot, const char *words, const char *option, double length,
                        vec3 place, vec3 along)
{
    vec3 value = vec3_of(length, 0, 0);
    plot_handle(
        plot, (Handle){words, place, {option}, 1, value, {along}, .least = {0.01}, .most = {1000}});
}

bool plot_is_dragged(const Plot *plot)
{
    return plot->is_live && plot_view_is_held(plot);
}

// ---- as JSON ------------------------------------------------------------------------------------

static int numbers_of(const Handle *handle)
{
    return handle->count < NUMBERS ? handle->count : NUMBERS;
}

// "origin": "-2,0.5,0", or two options with a number each.
static void print_options(FILE *out, const Handle *handle, vec3 value)
{
    enum { DIGITS = 12 };
    bool two = handle->option[1] != NULL;
    for (int i = 0; i < numbers_of(handle); i++) {
        fputs(i == 0 ? "" : two ? "\", " : ",", out);
        if (i == 0 || two)
            fprintf(out, "\"%s\": \"", handle->option[i]);
        fputs(number_text_to(value[i], DIGITS).s, out);
    }
    putc('"', out);
}

// Those that are dragged, or those that are typed.
static void print_handles(const Plot *plot, bool typed, FILE *out)
{
    const char *before = "\n";
    double uv[2];
    for (const Handle *handle = plot->handles; handle < plot->handles + plot->handle_count;
         handle++) {
        if (handle->typed != typed)
            continue;
        fprintf(out, "%s{\"words\": ", before);
        before = ",\n";
        json_print_string(out, handle->words);
        if (!typed && plot_view_spot(plot, handle->panel, handle->place, uv))
            fprintf(out, ", \"u\": %.2f, \"v\": %.2f", uv[0], uv[1]);
        fputs(", \"options\": {", out);
        print_options(out, handle, handle->value);
        fputs("}}", out);
    }
}

void plot_handles_print(const Plot *plot, FILE *out)
{
    fputs("{\"handles\": [", out);
    print_handles(plot, false, out);
    fputs("],\n\"typed\": [", out);
    print_handles(plot, true, out);
    fputs("],\n\"view\": \"", out);
    plot_view_print(plot, out);
    fputs("\"}\n", out);
}

// ---- a drag -------------------------------------------------------------------------------------

// The largest power of ten that moves a handle by at most a few units of the canvas.
static double step_of(const Handle *handle, double units)
{
    return handle->whole ? 1 : pow(10, floor(log10((double)FEW / units)));
}

static double rounded(double x, double step)
{
    return step >= 1 ? step * round(x / step) : round(x * round(1 / step)) / round(1 / step);
}

static double limited(const Handle *handle, int i, double x)
{
    bool any = handle->count == POINT || (handle->least[i] == 0 && handle->most[i] == 0);
    return any ? x : fmax(handle->least[i], fmin(handle->most[i], x));
}

// How far to go in both directions so that the handle moves by this much on the canvas. Where they
// are seen as one direction, only the longer one is used.
static void solve(const double a[2], const double b[2], const double by[2], double go[2])
{
    double aa = a[0] * a[0] + a[1] * a[1], bb = b[0] * b[0] + b[1] * b[1];
    double area = a[0] * b[1] - a[1] * b[0];
    go[0] = go[1] = 0;
    if (fabs(area) > 0.05 * sqrt(aa * bb) && area != 0) {
        go[0] = (by[0] * b[1] - by[1] * b[0]) / area;
        go[1] = (a[0] * by[1] - a[1] * by[0]) / area;
    } else if (aa >= bb && aa > 0) {
        go[0] = (by[0] * a[0] + by[1] * a[1]) / aa;
    } else if (bb > 0) {
        go[1] = (by[0] * b[0] + by[1] * b[1]) / bb;
    }
}

static vec3 dragged_to(const Plot *plot, const Handle *handle, double u, double v)
{
    double at[2], along[2][2], go[2];
    vec3 value = handle->value;
    if (!plot_view_spot(plot, handle->panel, handle->place, at))
        return value;
    for (int i = 0; i < 2; i++) {
        bool elsewhere = vec3_length(handle->way[0]) > 0;
        plot_view_way(plot, handle->panel, elsewhere ? handle->way[i] : handle->along[i], along[i]);
    }
    solve(along[0], along[1], (const double[]){u - at[0], v - at[1]}, go);
    if (handle->count == POINT)
        value += go[0] * handle->along[0] + go[1] * handle->along[1];
    for (int i = 0; i < numbers_of(handle); i++) {
        bool moves = handle->count < POINT ||
                     fabs(go[0] * handle->along[0][i]) + fabs(go[1] * handle->along[1][i]) > 0;
        if (handle->count < POINT)
            value[i] += go[i];
        int way = handle->count == POINT && fabs(handle->along[1][i]) > fabs(handle->along[0][i]);
        way = handle->count < POINT ? i : way;
        double units = hypot(along[way][0], along[way][1]);
        if (moves && units > 0)
            value[i] = limited(handle, i, rounded(value[i], step_of(handle, units)));
    }
    return value;
}

bool plot_handles_drag(const Plot *plot, const char *drag, FILE *out)
{
    int number, used = 0, count = 0;
    double u, v;
    while (count < plot->handle_count && !plot->handles[count].typed)
        count++;
    if (sscanf(drag, "%d,%lf,%lf%n", &number, &u, &v, &used) != 3 || drag[used] != '\0' ||
        number < 0 || number >= count) {
        fprintf(stderr,
                "--drag %s: expected HANDLE,U,V: a handle's number, below %d, and a place\n",
                word_text(drag).s, count);
        return false;
    }
    // All options, because a figure may choose numbers that go together.
    for (int i = 0; i < count; i++) {
        const Handle *handle = &plot->handles[i];
        fputs(i == 0 ? "{" : ", ", out);
        print_options(out, handle, i == number ? dragged_to(plot, handle, u, v) : handle->value);
    }
    fputs("}\n", out);
    return true;
}
