// shaded.c - shadows and mirrors at full size: chapter 08 beside its peers, in one run.
//
// Usage: shaded [-p] [-r ROUNDS] [-s WIDTHxHEIGHT] [-t THREADS]... [-n SAMPLES]... [-d DEPTH]
// [-l SECONDS] [-e RENDERER]... [-o FOLDER] SCENE...
//
// -p: also the peers, which are other ray tracers. -o: shaded-pictures.csv is written to this
// folder, and so are the peers' files. SAMPLES are those in each direction of a pixel.
//
// All renderers of a scene take turns, round after round. The time includes building the hierarchy,
// and excludes reading the scene and writing the picture. Each ratio is taken in a round, to
// chapter 08's time in it. Pictures are compared first: peers compute in float, or have formulas of
// their own, so only the mean difference is limited. A renderer that takes longer than
// SECONDS (3) takes part in fewer rounds, but in one at least. If it would take MOST_SECONDS times
// as long, by what it took for fewer samples, it is left out, and the bench says so.
#include "chapters/shared/scene_camera.h"
#include "common/clock.h"
#include "tests/benches/measure.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// All rounds of one renderer take about as long as this many pictures of SECONDS.
#define MOST_PICTURES 5
#define MOST_SECONDS 20
// Of a byte, in the mean over all pixels.
#define MOST_DIFFERENT 2.0
enum { MOST_RENDERERS = 8, MOST_COUNTS = 8 };

Measured measured = {.folder = "/tmp"};

typedef struct {
    const Engine *renderer;
    int rounds; // -1: left out, fails, or draws another picture
    double seconds[MOST_ROUNDS], spent, different;
} Row;

// Over all scenes.
typedef struct {
    double log_sum, least;
    int scenes;
} Sum;

static struct {
    int rounds, threads[MOST_COUNTS], thread_counts, samples[MOST_COUNTS], sample_counts, depth;
    Resolution size;
    double longest;
    bool with_peers;
    const char *chosen[MOST_RENDERERS];
    int chosen_count, renderer_count;
    const Engine *renderers[MOST_RENDERERS]; // the first one is chapter 08's
    Sum sums[MOST_RENDERERS][MOST_COUNTS][MOST_COUNTS];
    FILE *csv;
} plan = {.rounds = 5, .depth = 3, .size = {1920, 1080}, .longest = 3};

static void stop(const char *what, const char *why)
{
    fprintf(stderr, "%s: %s\n", what, why);
    exit(1);
}

// Seconds, -1 if it fails; the picture is left in the image.
static double render_once(const Engine *renderer, const Work *work, Style style)
{
    Message message;
    measured.build = measured.cast = 0;
    double began = clock_seconds();
    if (!renderer->light(work, style, &message)) {
        fprintf(stderr, "%s: %s\n", renderer->name, message.text);
        return -1;
    }
    double took = clock_seconds() - began;
    return measured.cast > 0 ? measured.build + measured.cast : took;
}

static double mean_difference(const Image *one, const Image *other)
{
    size_t bytes = 3 * (size_t)one->size.width * (size_t)one->size.height;
    double sum = 0;
    for (size_t i = 0; i < bytes; i++)
        sum += abs(one->rgb[i] - other->rgb[i]);
    return sum / (double)bytes;
}

static void report(const Row *row, const Row *ours, const char *scene, int spheres, int samples,
                   int threads, Sum *sum)
{
    double ratios[MOST_ROUNDS];
    int rounds = row->rounds < ours->rounds ? row->rounds : ours->rounds;
    for (int i = 0; i < rounds; i++)
        ratios[i] = row->seconds[i] / ours->seconds[i];
    double ms = 1e3 * quantile(row->seconds, rounds, 0.5), times = quantile(ratios, rounds, 0.5);
    double low = quantile(ratios, rounds, 0), high = quantile(ratios, rounds, 1);
    printf("  %-12s %7d %7d %9.4g   %-6.3g (%.3g to %.3g, %d rounds)", row->renderer->name,
           samples * samples, threads, ms, times, low, high, rounds);
    printf(row->different > 0 ? "  bytes differ by %.2g in the mean\n" : "\n", row->different);
    fflush(stdout);
    fprintf(plan.csv, "%s,%d,%s,%d,%d,%d,%.5g,%.4g,%.4g,%.4g,%.3g\n", scene, spheres,
            row->renderer->name, samples * samples, threads, rounds, ms, times, low, high,
            row->different);
    fflush(plan.csv);
    sum->log_sum += log(times);
    sum->least = sum->scenes++ == 0 ? times : fmin(sum->least, times);
}

// Whether a renderer would take too long for a scene, by its time for fewer samples.
static bool is_left_out(int renderer, double expected, int samples, int threads)
{
    if (renderer == 0 || expected <= MOST_SECONDS * plan.longest)
        return false;
    printf("  %-12s %7d %7d   left out: it would take about %.0f seconds\n",
           plan.renderers[renderer]->name, samples * samples, threads, expected);
    return true;
}

static void measure(const Scene *scene, const char *name, int sample_count, int thread_count)
{
    static Row rows[MOST_RENDERERS];
    Style style = {plan.samples[sample_count], plan.depth, 1};
    int threads = plan.threads[thread_count];
    Message message;
    Image right, image;
    if (!image_create(&right, plan.size, &message) || !image_create(&image, plan.size, &message))
        stop(name, message.text);
    Work work = {.scene = scene, .image = &image, .threads = threads};
    if (scene_camera(&scene->view, plan.size, &work.camera) != CAMERA_OK)
        stop(name, "no camera");
    // Of each renderer and number of threads: the seconds for one sample a pixel.
    static double seconds[MOST_RENDERERS][MOST_COUNTS];
    for (int i = 0; i < plan.renderer_count; i++) {
        double *each = &seconds[i][thread_count];
        *each = sample_count == 0 ? 0 : *each;
        bool out = is_left_out(i, *each * style.samples * style.samples, style.samples, threads);
        rows[i] = (Row){.renderer = plan.renderers[i], .rounds = out ? -1 : 0};
    }
    for (int round = 0; round < plan.rounds; round++)
        for (int i = 0; i < plan.renderer_count; i++) {
            Row *row = &rows[i];
            if (row->rounds < 0 || (round > 0 && row->spent > MOST_PICTURES * plan.longest))
                continue;
            work.image = i == 0 ? &right : &image;
            double took = render_once(row->renderer, &work, style);
            row->different = i == 0 ? 0 : mean_difference(&right, &image);
            if (took < 0 && i == 0)
                stop(name, "chapter 08 fails");
            if (took >= 0 && row->different > MOST_DIFFERENT)
                fprintf(stderr, "%s: %s: another picture\n", name, row->renderer->name);
            if (took < 0 || row->different > MOST_DIFFERENT) {
                row->rounds = -1;
                continue;
            }
            row->seconds[row->rounds++] = took;
            row->spent += took;
            seconds[i][thread_count] = took / (style.samples * style.samples);
        }
    for (int i = 0; i < plan.renderer_count; i++)
        if (rows[i].rounds > 0)
            report(&rows[i], &rows[0], name, scene->sphere_count, style.samples, threads,
                   &plan.sums[i][sample_count][thread_count]);
    image_free(&right);
    image_free(&image);
}

static void measure_scene(const char *path)
{
    Scene scene;
    Message message;
    char name[100];
    if (!scene_load(path, &scene, &message))
        stop(path, message.text);
    measured.scene_path = path;
    const char *slash = strrchr(path, '/'), *file = slash != NULL ? slash + 1 : path;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(file, "."), file);
    printf("\n%s, %d spheres, %d mirrors deep\n  %-12s %7s %7s %9s   %s\n", name,
           scene.sphere_count, plan.depth, "renderer", "samples", "threads", "ms",
           "times chapter 08's time");
    for (int s = 0; s < plan.sample_counts; s++)
        for (int t = 0; t < plan.thread_counts; t++)
            measure(&scene, name, s, t);
    scene_free(&scene);
}

static bool is_chosen(const char *name)
{
    for (int i = 0; i < plan.chosen_count; i++)
        if (strcmp(plan.chosen[i], name) == 0)
            return true;
    return plan.chosen_count == 0;
}

static void find_renderers(void)
{
    plan.renderers[plan.renderer_count++] = engine_named("bvh");
    for (const Engine *peer = peers; plan.with_peers && peer->name != NULL; peer++) {
        Message message;
        if ((peer->light == NULL && peer->cast != NULL) || !is_chosen(peer->name))
            continue;
        if (peer_is_here(peer, &message))
            plan.renderers[plan.renderer_count++] = peer;
        else
            fprintf(stderr, "%s\n", message.text);
    }
}

static void sum_up(void)
{
    printf("\nOver all scenes, times chapter 08's time (geometric mean of the medians)\n"
           "  %-12s %7s %7s %7s %9s %9s\n",
           "renderer", "samples", "threads", "scenes", "mean", "least");
    for (int i = 1; i < plan.renderer_count; i++)
        for (int s = 0; s < plan.sample_counts; s++)
            for (int t = 0; t < plan.thread_counts; t++) {
                Sum sum = plan.sums[i][s][t];
                if (sum.scenes > 0)
                    printf("  %-12s %7d %7d %7d %9.3g %9.3g\n", plan.renderers[i]->name,
                           plan.samples[s] * plan.samples[s], plan.threads[t], sum.scenes,
                           exp(sum.log_sum / sum.scenes), sum.least);
            }
}

// Those that were given; otherwise both 1 and 2.
static int one_and_two(int *numbers, int given)
{
    numbers[0] = given > 0 ? numbers[0] : 1;
    numbers[1] = given > 0 ? numbers[1] : 2;
    return given > 0 ? given : 2;
}

int main(int argc, char **argv)
{
    for (int c; (c = getopt(argc, argv, "pr:s:t:n:d:l:e:o:")) != -1;)
        if (c == 'p')
            plan.with_peers = true;
        else if (c == 'r')
            plan.rounds = atoi(optarg);
        else if (c == 's' && sscanf(optarg, "%dx%d", &plan.size.width, &plan.size.height) == 2)
            continue;
        else if (c == 't' && plan.thread_counts < MOST_COUNTS)
            plan.threads[plan.thread_counts++] = atoi(optarg);
        else if (c == 'n' && plan.sample_counts < MOST_COUNTS)
            plan.samples[plan.sample_counts++] = atoi(optarg);
        else if (c == 'd')
            plan.depth = atoi(optarg);
        else if (c == 'l')
            plan.longest = atof(optarg);
        else if (c == 'e' && plan.chosen_count < MOST_RENDERERS)
            plan.chosen[plan.chosen_count++] = optarg;
        else if (c == 'o')
            measured.folder = optarg;
        else
            return 2;
    plan.thread_counts = one_and_two(plan.threads, plan.thread_counts);
    plan.sample_counts = one_and_two(plan.samples, plan.sample_counts);
    if (plan.rounds < 1 || plan.rounds > MOST_ROUNDS)
        plan.rounds = MOST_ROUNDS;
    find_renderers();
    char path[500];
    snprintf(path, sizeof path, "%.400s/shaded-pictures.csv", measured.folder);
    if ((plan.csv = fopen(path, "w")) == NULL)
        stop(path, strerror(errno));
    fprintf(plan.csv, "scene,spheres,renderer,samples,threads,rounds,ms,times,least,most,"
                      "bytes_different\n");
    for (int i = optind; i < argc; i++)
        measure_scene(argv[i]);
    sum_up();
    fclose(plan.csv);
    return 0;
}
