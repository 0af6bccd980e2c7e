// reading.c - how long scenes take to be read: by scene_load, and by sscanf, in turns.
//
// Usage: reading SCENE.nff... If the two did not read the same spheres, it prints no number.
#include "common/clock.h"
#include "tests/benches/by_sscanf.h"
#include "tests/benches/quantile.h"

#include <stdio.h>
#include <stdlib.h>

enum { ROUNDS = 15 };

static bool is_same(const Scene *a, const Scene *b)
{
    bool same = a->sphere_count == b->sphere_count;
    for (int i = 0; same && i < a->sphere_count; i++) {
        Sphere s = a->spheres[i], t = b->spheres[i];
        Color c = scene_surface(a, i)->color, d = scene_surface(b, i)->color;
        for (int k = 0; k < 3; k++)
            same = same && s.center[k] == t.center[k] && c[k] == d[k];
        same = same && s.radius == t.radius;
    }
    return same;
}

static bool measure(const char *path)
{
    double ours[ROUNDS], others[ROUNDS], ratios[ROUNDS];
    Message message = {""};
    int count = 0;
    for (int i = 0; i < ROUNDS; i++) {
        Scene mine, by_sscanf;
        double began = clock_seconds();
        bool read = scene_load(path, &mine, &message);
        double between = clock_seconds();
        read = scene_by_sscanf(path, &by_sscanf) && read;
        double ended = clock_seconds();
        if (!read || !is_same(&mine, &by_sscanf)) {
            fprintf(stderr, "%s: not the same spheres by sscanf. %s\n", path, message.text);
            return false;
        }
        ours[i] = between - began;
        others[i] = ended - between;
        ratios[i] = others[i] / ours[i];
        count = mine.sphere_count;
        scene_free(&mine);
        scene_free(&by_sscanf);
    }
    printf("  %9d %10.4g %12.4g   %.3g (%.3g..%.3g)\n", count, 1e3 * quantile(ours, ROUNDS, 0.5),
           1e3 * quantile(others, ROUNDS, 0.5), quantile(ratios, ROUNDS, 0.5),
           quantile(ratios, ROUNDS, 0.25), quantile(ratios, ROUNDS, 0.75));
    return true;
}

int main(int argc, char **argv)
{
    bool good = argc > 1;
    printf("reading a scene: medians of %d, in turns\n"
           "    spheres    ours ms    sscanf ms   times as long (quartiles)\n",
           ROUNDS);
    for (int i = 1; i < argc; i++)
        good = measure(argv[i]) && good;
    return good ? 0 : 1;
}
