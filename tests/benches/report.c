// report.c - medians, quartiles and ratios, as text and as CSV.
//
// A ratio is taken round by round, between neighbours in time, and its median said. It is to the
// base: the better one of Embree's where there are peers, else the hierarchy one ray at a time.
#include "tests/benches/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Rays a second in the round where casting took that long.
static double rate(const Row *row, double seconds)
{
    return row->size.width * (double)row->size.height / seconds;
}

static double median_rate(const Row *row)
{
    return rate(row, quantile(row->cast, row->rounds, 0.5));
}

static double first_frame(const Row *row, int round)
{
    return row->build[round] + row->cast[round];
}

static int common_rounds(const Row *row, const Row *base)
{
    return row->rounds < base->rounds ? row->rounds : base->rounds;
}

// How many times as fast as the base, round by round; a share of 0.5 is the median.
static double ratio(const Row *row, const Row *base, bool with_build, double share)
{
    double ratios[MOST_ROUNDS];
    int rounds = common_rounds(row, base);
    for (int i = 0; i < rounds; i++)
        ratios[i] = with_build ? first_frame(base, i) / first_frame(row, i)
                               : rate(row, row->cast[i]) / rate(base, base->cast[i]);
    return quantile(ratios, rounds, share);
}

static const Row *base_of(const Row *rows, int count, int threads)
{
    const Row *base = NULL;
    for (int i = 0; i < count; i++)
        if (rows[i].threads == threads && rows[i].rounds > 0 &&
            strncmp(rows[i].engine->name, "embree", 6) == 0 &&
            (base == NULL || median_rate(&rows[i]) > median_rate(base)))
            base = &rows[i];
    for (int i = 0; i < count && base == NULL; i++)
        if (rows[i].threads == threads && rows[i].rounds > 0 &&
            strcmp(rows[i].engine->name, "bvh") == 0)
            base = &rows[i];
    return base;
}

static void add_up(Report *report, const Row *row, double times, double frame_times)
{
    int i = 0;
    while (i < report->sum_count &&
           (report->sums[i].engine != row->engine || report->sums[i].threads != row->threads))
        i++;
    if (i == MOST_ROWS)
        return;
    if (i == report->sum_count) {
        report->sums[i].engine = row->engine;
        report->sums[i].threads = row->threads;
        report->sums[i].least = INFINITY;
        report->sum_count++;
    }
    report->sums[i].scenes++;
    report->sums[i].log_sum += log(times);
    report->sums[i].frame_log_sum += log(frame_times);
    report->sums[i].least = fmin(report->sums[i].least, times);
}

// The text after the colon in the first line of /proc/cpuinfo that begins like this.
static void print_processor(void)
{
    char line[300];
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':') != NULL) {
            line[strcspn(line, "\n")] = '\0';
            printf("machine: %s, ", strchr(line, ':') + 2);
            break;
        }
    if (file != NULL)
        fclose(file);
}

void report_begin(Report *report)
{
    double load[1] = {0};
    getloadavg(load, 1);
    print_processor();
    printf("%ld processors", sysconf(_SC_NPROCESSORS_ONLN));
#if defined __x86_64__
    printf(", %s", __builtin_cpu_supports("avx512f") ? "AVX-512"
                   : __builtin_cpu_supports("avx2")  ? "AVX2"
                                                     : "no AVX2");
#endif
#ifdef __clang__
    printf("; compiler: %s", __VERSION__);
#else
    printf("; compiler: gcc %s", __VERSION__);
#endif
    printf("; load before: %.2f\n", load[0]);
    if (report->csv != NULL)
        fprintf(report->csv, "scene,spheres,engine,threads,width,height,rounds,rays_per_second,"
                             "lower_quartile,upper_quartile,build_ms,first_frame_ms,ratio,base,"
                             "pixels_different\n");
    if (report->ratios != NULL)
        fprintf(report->ratios,
                "scene,engine,threads,peer,rounds,times,lower_quartile,upper_quartile\n");
}

// Each engine beside each peer.
static void write_ratios(FILE *csv, const char *scene, const Row *rows, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            const Row *row = &rows[i], *peer = &rows[k];
            if (row->peer || !peer->peer || row->threads != peer->threads ||
                common_rounds(row, peer) == 0)
                continue;
            fprintf(csv, "%s,%s,%d,%s,%d,%.4g,%.4g,%.4g\n", scene, row->engine->name, row->threads,
                    peer->engine->name, common_rounds(row, peer), ratio(row, peer, false, 0.5),
                    ratio(row, peer, false, 0.25), ratio(row, peer, false, 0.75));
        }
}

void report_scene(Report *report, const char *path, int spheres, const Row *rows, int count)
{
    const char *slash = strrchr(path, '/');
    const char *file = slash != NULL ? slash + 1 : path;
    int length = (int)strcspn(file, ".");
    printf("\n%.*s, %d spheres\n  %-12s %7s %9s %9s   %-15s %-19s %9s %11s\n", length, file,
           spheres, "engine", "threads", "picture", "Mrays/s", "quartiles", "times base",
           "build ms", "frame ms");
    for (int i = 0; i < count; i++) {
        const Row *row = &rows[i];
        const Row *base = base_of(rows, count, row->threads);
        if (row->rounds == 0)
            continue;
        double frames[MOST_ROUNDS];
        for (int k = 0; k < row->rounds; k++)
            frames[k] = first_frame(row, k);
        double middle = median_rate(row);
        double low = rate(row, quantile(row->cast, row->rounds, 0.75));
        double high = rate(row, quantile(row->cast, row->rounds, 0.25));
        double build = 1e3 * quantile(row->build, row->rounds, 0.5);
        double frame = 1e3 * quantile(frames, row->rounds, 0.5);
        double times = base == NULL ? NAN : ratio(row, base, false, 0.5);
        const char *name = base == NULL ? "" : base->engine->name;
        char quartiles[40], size[20], against[60];
        snprintf(quartiles, sizeof quartiles, "%.4g..%.4g", 1e-6 * low, 1e-6 * high);
        snprintf(size, sizeof size, "%dx%d", row->size.width, row->size.height);
        snprintf(against, sizeof against, "%.3g %s", times, name);
        printf("  %-12s %7d %9s %9.4g   %-15s %-19s %9.3g %11.4g", row->engine->name, row->threads,
               size, 1e-6 * middle, quartiles, against, build, frame);
        if (row->different > 0)
            printf("  (%d pixels differ)", row->different);
        printf("\n");
        if (report->csv != NULL)
            fprintf(report->csv, "%.*s,%d,%s,%d,%d,%d,%d,%.6g,%.6g,%.6g,%.5g,%.5g,%.4g,%s,%d\n",
                    length, file, spheres, row->engine->name, row->threads, row->size.width,
                    row->size.height, row->rounds, middle, low, high, build, frame, times, name,
                    row->different);
        if (base != NULL)
            add_up(report, row, times, ratio(row, base, true, 0.5));
    }
    if (report->ratios != NULL) {
        char scene[200];
        snprintf(scene, sizeof scene, "%.*s", length, file);
        write_ratios(report->ratios, scene, rows, count);
    }
    fflush(stdout);
}

void report_end(Report *report)
{
    printf("\nOver all scenes, times the base (geometric mean of the medians of the ratios)\n"
           "  %-12s %7s %9s %9s %9s %12s\n",
           "engine", "threads", "scenes", "casting", "least", "first frame");
    for (int i = 0; i < report->sum_count; i++)
        printf("  %-12s %7d %9d %9.3g %9.3g %12.3g\n", report->sums[i].engine->name,
               report->sums[i].threads, report->sums[i].scenes,
               exp(report->sums[i].log_sum / report->sums[i].scenes), report->sums[i].least,
               exp(report->sums[i].frame_log_sum / report->sums[i].scenes));
    if (report->csv != NULL)
        fclose(report->csv);
    if (report->ratios != NULL)
        fclose(report->ratios);
}
