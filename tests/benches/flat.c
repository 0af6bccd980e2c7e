// flat.c - how many rays a second: engines, scenes, threads, and peers, in one run.
//
// Usage: flat [-p] [-r ROUNDS] [-s WIDTHxHEIGHT] [-t THREADS]... [-e ENGINE]... [-l SECONDS]
// [-o FOLDER] SCENE...
//
// -p: also the peers, which are other ray tracers. -o: rays-per-second.csv and ratios.csv are
// written to this folder, and so are the peers' files.
//
// All that is measured of a scene takes turns, round after round, so that other work of the machine
// affects all of them alike; it prints medians and quartiles. Every picture is compared with that
// of the hierarchy first, and a picture that differs gets no number: of the engines each pixel, of
// peers what is sphere and what is not, but for one pixel in two thousand on silhouettes. An engine
// that would take more than SECONDS (3) casts a smaller picture; a peer that does is measured once.
// As long as all of a scene is fast, it has more rounds.
//
// A ratio is taken in each round, between neighbours in time; its median is printed. It is to the
// base: the faster way to use Embree if it takes part, otherwise the hierarchy one ray at a time.
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "tests/benches/measure.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// All rounds of one engine take about as long as this many pictures of SECONDS.
#define MOST_PICTURES 5
// More rounds of a scene, as long as all together take less than this many times SECONDS.
#define MORE_ROUNDS 3
enum { MOST_TIMES_ROUNDS = 5 };
enum { MOST_THREADS = 8, MOST_CHOSEN = 16, SMALLEST = 64 };

Measured measured = {.folder = "/tmp"};

typedef struct {
    int rounds, thread_counts, chosen;
    int threads[MOST_THREADS];
    const char *engines[MOST_CHOSEN];      // none: all
    bool with_peers, missing[MOST_CHOSEN]; // of the peers
    Resolution size;
    double longest;
} Plan;

enum { MOST_ROWS = 64 };

// One engine with one number of threads on one scene. Seconds.
typedef struct {
    const Engine *engine;
    int threads;
    bool peer;
    Resolution size;
    int different; // pixels, from the hierarchy's
    int rounds;
    double build[MOST_ROUNDS], cast[MOST_ROUNDS], spent;
} Row;

typedef struct {
    FILE *csv;
    FILE *ratios; // each engine beside each peer
    struct {
        const Engine *engine;
        int threads, scenes;
        double log_sum, least, frame_log_sum;
    } sums[MOST_ROWS];
    int sum_count;
} Report;

static bool is_chosen(const Plan *plan, const char *name)
{
    for (int i = 0; i < plan->chosen; i++)
        if (strcmp(plan->engines[i], name) == 0)
            return true;
    return plan->chosen == 0;
}

// ---- one picture -----------------------------------------------------------------------------

static bool work_begin(Work *work, Image *image, const Scene *scene, Resolution size, int threads)
{
    Message message;
    *work = (Work){.scene = scene, .image = image, .threads = threads};
    if (scene_camera(&scene->view, size, &work->camera) == CAMERA_OK &&
        image_create(image, size, &message))
        return true;
    fprintf(stderr, "%s: no camera, or no image\n", measured.scene_path);
    exit(1);
}

static bool cast_once(const Engine *engine, const Work *work, double *build, double *cast)
{
    Message message;
    measured.build = measured.cast = 0;
    double began = clock_seconds(), built = began;
    Work timed = *work;
    timed.built = &built;
    bool done = engine->cast(&timed, &message);
    double ended = clock_seconds();
    *build = measured.cast > 0 ? measured.build : built - began;
    *cast = measured.cast > 0 ? measured.cast : ended - built;
    if (!done)
        fprintf(stderr, "%s: %s: %s\n", measured.scene_path, engine->name, message.text);
    return done;
}

static bool is_background(const Scene *scene, const uint8_t *rgb)
{
    for (int i = 0; i < 3; i++)
        if (rgb[i] != byte_from_color(scene->background[i]))
            return false;
    return true;
}

// How many pixels. Peers may write other colors (gamma): their background is what they show at the
// first pixel where the hierarchy has background.
static int different(const Work *mine, const Image *expected, bool peer)
{
    size_t pixels = (size_t)expected->size.width * (size_t)expected->size.height;
    const uint8_t *theirs = NULL;
    int count = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *rgb = mine->image->rgb + 3 * i, *right = expected->rgb + 3 * i;
        bool background = is_background(mine->scene, right);
        if (background && theirs == NULL)
            theirs = rgb;
        bool same = peer ? background == (theirs != NULL && memcmp(rgb, theirs, 3) == 0)
                         : memcmp(rgb, right, 3) == 0;
        count += !same;
    }
    return count;
}

// ---- one engine, one number of threads -------------------------------------------------------

// The fastest of a few casts, so that a moment's other work of the machine does not count; a slow
// one is cast only once.
static bool cast_fastest(const Engine *engine, const Work *work, double longest, double *cast)
{
    double build, again, spent = 0;
    *cast = INFINITY;
    for (int i = 0; i < 5 && spent < longest / 2; i++) {
        if (!cast_once(engine, work, &build, &again))
            return false;
        *cast = fmin(*cast, again);
        spent += build + again;
    }
    return true;
}

// Tries small pictures to find the largest that does not take too long, assuming one fixed time for
// all pictures and one time for each ray. Only the second picture shows the fixed time, so it may
// take as long as all rounds.
static Resolution size_for(const Engine *engine, const Scene *scene, const Plan *plan, int threads)
{
    Resolution size = plan->size, smaller;
    double cast, before = 0, longest = plan->longest;
    for (int part = SMALLEST; part > 1; part /= 4) {
        smaller = size;
        size = (Resolution){plan->size.width / part, plan->size.height / part};
        size.width = size.width > 0 ? size.width : 1;
        size.height = size.height > 0 ? size.height : 1;
        Work work;
        Image image;
        work_begin(&work, &image, scene, size, threads);
        bool done = cast_fastest(engine, &work, longest, &cast), first = part == SMALLEST;
        image_free(&image);
        if (!done || cast > longest)
            return first ? size : smaller;
        // A ray's share, in pictures of this size: the one before was a sixteenth of it.
        double share = first ? cast : fmax(0, cast - before) * 16 / 15;
        if (cast + (part * part - 1) * share < longest)
            break;
        if (cast + 15 * share > (first ? MOST_PICTURES : 1) * longest)
            return size;
        before = cast;
    }
    return plan->size;
}

// The hierarchy's picture of the scene, cast again only for another size.
static const Image *expected_picture(const Scene *scene, Resolution size)
{
    static Image expected;
    static const char *path;
    if (expected.rgb != NULL && path == measured.scene_path && expected.size.width == size.width &&
        expected.size.height == size.height)
        return &expected;
    image_free(&expected);
    Work work;
    double build, cast;
    work_begin(&work, &expected, scene, size, 2);
    if (!cast_once(engine_named("bvh"), &work, &build, &cast))
        exit(1);
    path = measured.scene_path;
    return &expected;
}

// Of a slow peer this is the only picture.
static bool is_same_picture(const Engine *engine, const Scene *scene, Row *row, double longest)
{
    Work work;
    Image image;
    double build, cast;
    work_begin(&work, &image, scene, row->size, row->threads);
    double began = clock_seconds();
    bool done = cast_once(engine, &work, &build, &cast);
    if (row->peer && clock_seconds() - began > longest) {
        row->build[0] = build;
        row->cast[0] = cast;
        row->rounds = 1;
        row->spent = INFINITY;
    }
    if (done) {
        row->different = different(&work, expected_picture(scene, row->size), row->peer);
        done = row->different <= (row->peer ? row->size.width * row->size.height / 2000 : 0);
        if (!done)
            fprintf(stderr, "%s: %s, %d threads: another picture, %d pixels\n", measured.scene_path,
                    engine->name, row->threads, row->different);
    }
    image_free(&image);
    return done;
}

static void measure_round(Row *row, const Scene *scene, const Plan *plan)
{
    if (row->rounds > 0 && row->spent > MOST_PICTURES * plan->longest)
        return;
    Work work;
    Image image;
    double build, cast;
    work_begin(&work, &image, scene, row->size, row->threads);
    memset(image.rgb, 1, 3 * (size_t)row->size.width * (size_t)row->size.height);
    if (cast_once(row->engine, &work, &build, &cast)) {
        row->build[row->rounds] = build;
        row->cast[row->rounds++] = cast;
        row->spent += build + cast;
    }
    image_free(&image);
}

// ---- the report ------------------------------------------------------------------------------

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

static FILE *file_in_folder(const char *name)
{
    char path[500];
    snprintf(path, sizeof path, "%.400s/%s", measured.folder, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    return file;
}

static void report_begin(Report *report)
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
    report->csv = file_in_folder("rays-per-second.csv");
    report->ratios = file_in_folder("ratios.csv");
    fprintf(report->csv, "scene,spheres,engine,threads,width,height,rounds,rays_per_second,"
                         "lower_quartile,upper_quartile,build_ms,first_frame_ms,ratio,base,"
                         "pixels_different\n");
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

static void report_scene(Report *report, const char *path, int spheres, const Row *rows, int count)
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
        fprintf(report->csv, "%.*s,%d,%s,%d,%d,%d,%d,%.6g,%.6g,%.6g,%.5g,%.5g,%.4g,%s,%d\n", length,
                file, spheres, row->engine->name, row->threads, row->size.width, row->size.height,
                row->rounds, middle, low, high, build, frame, times, name, row->different);
        if (base != NULL)
            add_up(report, row, times, ratio(row, base, true, 0.5));
    }
    char scene[200];
    snprintf(scene, sizeof scene, "%.*s", length, file);
    write_ratios(report->ratios, scene, rows, count);
    fflush(stdout);
}

static void report_end(Report *report)
{
    printf("\nOver all scenes, times the base (geometric mean of the medians of the ratios)\n"
           "  %-12s %7s %9s %9s %9s %12s\n",
           "engine", "threads", "scenes", "casting", "least", "first frame");
    for (int i = 0; i < report->sum_count; i++)
        printf("  %-12s %7d %9d %9.3g %9.3g %12.3g\n", report->sums[i].engine->name,
               report->sums[i].threads, report->sums[i].scenes,
               exp(report->sums[i].log_sum / report->sums[i].scenes), report->sums[i].least,
               exp(report->sums[i].frame_log_sum / report->sums[i].scenes));
    fclose(report->csv);
    fclose(report->ratios);
}

// ---- all scenes ------------------------------------------------------------------------------

static int add_rows(Row *rows, int count, const Engine *list, const Scene *scene, const Plan *plan)
{
    for (const Engine *engine = list; engine->name != NULL; engine++) {
        if (list == peers && plan->missing[engine - peers])
            continue;
        for (int t = 0; is_chosen(plan, engine->name) && t < plan->thread_counts; t++) {
            Row *row = &rows[count];
            *row = (Row){.engine = engine, .threads = plan->threads[t], .peer = list == peers};
            // No peer is as slow as the plain loop.
            row->size = row->peer ? plan->size : size_for(engine, scene, plan, row->threads);
            if (count < MOST_ROWS && is_same_picture(engine, scene, row, plan->longest))
                count++;
        }
    }
    return count;
}

static void measure_scene(const char *path, const Plan *plan, Report *report)
{
    Scene scene;
    Message message;
    if (!scene_load(path, &scene, &message)) {
        fprintf(stderr, "%s\n", message.text);
        exit(1);
    }
    measured.scene_path = path;
    static Row rows[MOST_ROWS + 1];
    int count = add_rows(rows, 0, engines, &scene, plan);
    count = add_rows(rows, count, peers, &scene, plan);
    const double began = clock_seconds(), enough = MORE_ROUNDS * plan->longest;
    const int most = plan->rounds * MOST_TIMES_ROUNDS;
    for (int round = 0; round < (most < MOST_ROUNDS ? most : MOST_ROUNDS); round++) {
        if (round >= plan->rounds && clock_seconds() - began > enough)
            break;
        for (int i = 0; i < count; i++)
            measure_round(&rows[i], &scene, plan);
    }
    report_scene(report, path, scene.sphere_count, rows, count);
    scene_free(&scene);
}

static void find_peers(Plan *plan)
{
    for (const Engine *peer = peers; peer->name != NULL; peer++) {
        Message message = {""};
        bool wanted = plan->with_peers && is_chosen(plan, peer->name);
        plan->missing[peer - peers] = !wanted || !peer_is_here(peer, &message);
        if (wanted && plan->missing[peer - peers])
            fprintf(stderr, "%s\n", message.text);
    }
}

int main(int argc, char **argv)
{
    Plan plan = {.rounds = 7, .size = {1920, 1080}, .longest = 3};
    Report report = {0};
    for (int c; (c = getopt(argc, argv, "pr:s:t:e:l:o:")) != -1;)
        if (c == 'p')
            plan.with_peers = true;
        else if (c == 'r')
            plan.rounds = atoi(optarg);
        else if (c == 's' && sscanf(optarg, "%dx%d", &plan.size.width, &plan.size.height) == 2)
            continue;
        else if (c == 't' && plan.thread_counts < MOST_THREADS)
            plan.threads[plan.thread_counts++] = atoi(optarg);
        else if (c == 'e' && plan.chosen < MOST_CHOSEN)
            plan.engines[plan.chosen++] = optarg;
        else if (c == 'l')
            plan.longest = atof(optarg);
        else if (c == 'o')
            measured.folder = optarg;
        else
            return 2;
    if (plan.thread_counts == 0) {
        plan.threads[plan.thread_counts++] = 1;
        plan.threads[plan.thread_counts++] = 2;
    }
    if (plan.rounds < 1 || plan.rounds > MOST_ROUNDS)
        plan.rounds = MOST_ROUNDS;
    find_peers(&plan);
    report_begin(&report);
    for (int i = optind; i < argc; i++) {
        fprintf(stderr, "flat: scene %d of %d\n", i - optind + 1, argc - optind);
        measure_scene(argv[i], &plan, &report);
    }
    report_end(&report);
    return 0;
}
