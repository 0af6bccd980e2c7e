// lent_answers.c - misuse of the reference answers that the judge lends, and searches for the
// reference. cases.py reads it: each section is one submission, and states the result that it must
// get.

// ---- lend-a-long-task: has the judge itself draw, by the answer that it lends, a picture of a
// hundred thousand spheres and a million pixels.
// stem: 06-ray-casting
// expect: timed out | graded | crashed
// earns: nothing
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

void cast_object_order(const Scene *scene, Camera camera, Image *image, double *depth)
{
    enum { MANY = 100000 };
    Scene large = *scene;
    Image picture = {.size = {1000, 1000}, .rgb = calloc(1000000, 3)};
    large.spheres = malloc(MANY * sizeof *large.spheres);
    large.sphere_count = MANY;
    for (int i = 0; i < MANY; i++)
        large.spheres[i] = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = 1};
    cast_image_order(&large, camera, &picture);
}

// ---- lend-itself: once another answer is lent by the judge, asks it over the pipe for this one,
// too.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdint.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    uint32_t magic;
    int32_t exercise;
    uint64_t nonce, size;
    int32_t kind;
    char missing[60];
} Header;
extern char __bss_start[], _end[];

vec3 upper_left(Camera c)
{
    vec3 answer = c.up;
    if (vec3_length(upper_right((Camera){{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2}) -
                    vec3_of(1, 1, 4)) > 1e-9)
        return answer; // it is not lent yet
    for (char *at = __bss_start; at + sizeof(Header) < _end; at += 8) {
        Header ask;
        memcpy(&ask, at, sizeof ask);
        if (ask.magic != 0x52617943)
            continue;
        ask.kind = 3;
        ask.size = sizeof c;
        if (write(4, &ask, sizeof ask) < 0 || write(4, &c, sizeof c) < 0 ||
            read(3, &ask, sizeof ask) < 0 || read(3, &answer, sizeof answer) < 0)
            return c.up;
        return answer;
    }
    return answer;
}

vec3 upper_right(Camera c)
{
    return c.up;
}

// ---- lend-no-such-sphere: asks for the light on spheres that are not there, once that is lent.
// stem: 07-shading
// expect: graded | crashed
// earns: nothing
#include "exercises/07-shading.h"

vec3 shade(const Scene *scene, Ray ray, Hit hit)
{
    return scene->ambient + 0 * hit.t * ray.direction;
}

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    static const int odd[] = {1 << 30, -1, -(1 << 30), 1 << 20};
    return shade(scene, ray, (Hit){1, odd[depth & 3]});
}

// ---- lend-nonsense: asks for what is lent with a scene that cannot be.
// stem: 06-ray-casting
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/06-ray-casting.h"

#include <stdlib.h>

void cast_image_order(const Scene *scene, Camera camera, Image *image)
{
    Sphere sphere = scene->sphere_count > 0 ? scene->spheres[0] : (Sphere){.radius = NAN};
    Scene odd = *scene;
    odd.spheres = &sphere;
    odd.sphere_count = 1;
    sphere.surface = 1 << 28;
    static int times;
    if (times++ % 2 == 0)
        odd.surface_count = 0, sphere.surface = -1;
    Ray ray = {camera.origin, camera.forward};
    Hit hit = nearest_hit(ray, &odd);
    image_set(image, (Pixel){0, 0}, vec3_of(hit.t, hit.sphere, 0));
}

// ---- lend-very-often: asks the judge for what it lends, again and again.
// stem: 01-corners
// expect: timed out | graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    if (vec3_length(upper_right((Camera){{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2}) -
                    vec3_of(1, 1, 4)) < 1e-9)
        for (;;)
            upper_right(c);
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.right;
}

// ---- lend-without-end: asks for a mirror in a mirror, two thousand million times, once that is
// lent.
// stem: 07-shading
// expect: graded | crashed
// earns: nothing
#include "exercises/07-shading.h"

vec3 trace_ray(const Scene *scene, Ray ray, int depth)
{
    return scene->background + depth * ray.direction;
}

vec3 clamp_color(vec3 color)
{
    Sphere spheres[2] = {{.center = vec3_of(0, 0, -2), .radius = 1},
                         {.center = vec3_of(0, 0, 2), .radius = 1}};
    Surface mirror = {.color = color, .specular = 1};
    Scene scene = {.spheres = spheres, .sphere_count = 2, .surfaces = &mirror, .surface_count = 1};
    return trace_ray(&scene, (Ray){vec3_of(0, 0, 0), vec3_of(0, 0, 1)}, 2147483647);
}

// ---- reference-by-name: looks the reference up while it runs, in itself and in the judge's
// program.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <dlfcn.h>
#include <stddef.h>

typedef vec3 Function(Camera c);

vec3 upper_left(Camera c)
{
    const char *names[] = {"reference_upper_left", "lent_upper_left", "_upper_left"};
    void *places[] = {NULL, dlopen(NULL, RTLD_NOW), dlopen("@TREE@/build/judge", RTLD_NOW)};
    vec3 thrown_away = upper_right(c);
    for (int i = 0; i < 9; i++) {
        Function *found = (Function *)dlsym(places[i / 3], names[i % 3]);
        if (found != NULL)
            return found(c);
    }
    return 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return c.up;
}

// ---- reference-left-behind: returns what is not set, hoping that the right answer still lies
// there.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    vec3 v;
    upper_right(c);
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v;
    return v;
}

Camera with_unit_distance(Camera c)
{
    Camera left;
    return left;
}

// ---- reference-left-on-the-stack: calls an answer of the chapter, then digs in the stack it has
// used.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

static vec3 dig(int depth)
{
    volatile double below[512];
    return vec3_of(below[depth], below[depth + 1], below[depth + 2]);
}

vec3 upper_left(Camera c)
{
    upper_right(c);
    double d = c.distance;
    for (int i = 0; i < 500; i++) {
        vec3 v = dig(i);
        if (vec3_dot(v, c.forward) == d)
            return v;
    }
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.right;
}

// ---- reference-next-door: when another answer is replaced by the reference, its own is not far
// from there. Calls what lies around it, until something knows the deck's corner.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>
#include <stddef.h>

typedef vec3 Function(Camera c);
static sigjmp_buf before;

static void back(int number)
{
    siglongjmp(before, 1);
}

static bool is_upper_left(Function *f)
{
    bool good = false;
    if (sigsetjmp(before, 1) == 0) {
        vec3 v = f((Camera){{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2});
        good = v[0] == -1 && v[1] == 1 && v[2] == 4;
    }
    return good;
}

vec3 upper_left(Camera c)
{
    static Function *found;
    signal(SIGSEGV, back), signal(SIGILL, back), signal(SIGBUS, back), signal(SIGFPE, back);
    for (int i = -64; i < 64 && found == NULL; i++)
        for (int j = 0; j < 3 && found == NULL; j++) {
            Function *near[] = {upper_right, across_30_up_10, (Function *)image_plane_vector};
            Function *f = (Function *)((char *)near[j] + 16 * i);
            if (f != upper_left && is_upper_left(f))
                found = f;
        }
    return found != NULL ? found(c) : c.up;
}

vec3 upper_right(Camera c)
{
    return c.up;
}

vec3 across_30_up_10(Camera c)
{
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.up;
}

// ---- reference-weak: asks for the reference by its names, should it be linked, and else is wrong.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

extern vec3 reference_upper_left(Camera c) __attribute__((weak));
extern vec3 lent_upper_left(Camera c) __attribute__((weak));
extern vec3 solution_upper_left(Camera c) __attribute__((weak));

// The call of upper_right makes it look as if this one were only waiting for that one.
vec3 upper_left(Camera c)
{
    vec3 thrown_away = upper_right(c);
    if (reference_upper_left)
        return reference_upper_left(c);
    if (lent_upper_left)
        return lent_upper_left(c);
    if (solution_upper_left)
        return solution_upper_left(c);
    return 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return c.up;
}
