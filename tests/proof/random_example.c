// random_example.c - an example for the lecture, made from a number (tests/proof/examples.sh).
//
//   random_example NUMBER             prints it as chapters/example.h
//   random_example NUMBER --lessons   what lessons must hold then: FILE, and TEXTS after tabs, any
//   of them random_example NUMBER --figures   PROGRAM FIGURE OPTIONS: the figure must be the one
//   without options
//
// The results are found in another way than the chapters find them: component by component, and by
// the geometry of the chord. NUMBER 0 is the deck's example.
#include "common/text.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    Camera camera;
    double s, t;
    int width, height, x, y;
    vec3 p, v, center;
    double radius;
} Example;

static const Example deck = {
    .camera = {{2, 2, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4, 2, 2},
    .s = 0.3,
    .t = 0.1,
    .width = 640,
    .height = 480,
    .x = 300,
    .y = 400,
    .p = {-4, -1, 0},
    .v = {0.89, 0.45, 0},
    .center = {0, 0, 0},
    .radius = 1,
};

// ---- random numbers ---------------------------------------------------------------------------

static uint64_t state;

// SplitMix64.
static double between(double low, double high)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static int whole(int low, int high)
{
    return (int)floor(between(low, high + 1));
}

// With few digits, as people choose numbers.
static double rounded(double x, double step)
{
    return strtod(number_text(round(x / step) * step).s, NULL);
}

static vec3 random_place(double size, double step)
{
    vec3 v = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        v[i] = rounded(between(-size, size), step);
    return v;
}

// Along the axes, or turned in any way; of either hand.
static void random_frame(Camera *c)
{
    if (whole(0, 1) == 0) {
        int first = whole(0, 2), second = (first + whole(1, 2)) % 3;
        c->right = c->up = vec3_of(0, 0, 0);
        c->right[first] = whole(0, 1) ? 1 : -1;
        c->up[second] = whole(0, 1) ? 1 : -1;
    } else {
        vec3 leaning;
        do {
            c->right = random_place(1, 1e-3);
            leaning = random_place(1, 1e-3);
        } while (vec3_length(vec3_cross(c->right, leaning)) < 0.1);
        c->right = vec3_unit(c->right);
        c->up = vec3_unit(vec3_cross(leaning, c->right));
    }
    c->forward = (whole(0, 1) ? 1 : -1) * vec3_cross(c->right, c->up);
}

// Fields of view from 20 to 90 degrees, the sides at most as 2.5 to 1.
static Camera random_camera(void)
{
    Camera c = {.origin = random_place(10, 0.25)};
    double units = pow(10, whole(-1, 1)), half = tan(between(20, 90) / 2 * PI / 180);
    random_frame(&c);
    c.origin *= units;
    c.distance = rounded(between(1, 8), 0.25) * units;
    c.width = rounded(2 * half * c.distance, 0.05 * units);
    c.height = rounded(c.width * between(0.4, 1.5), 0.05 * units);
    return c;
}

// The ray goes to a point near the centre; how long v is says where t is 1.
static void random_ray(Example *e)
{
    double away;
    do {
        e->radius = rounded(between(0.5, 3), 0.25);
        e->center = whole(0, 1) ? vec3_of(0, 0, 0) : random_place(5, 0.5);
        e->p = e->center + random_place(8, 0.5);
        vec3 towards = e->center + random_place(0.5 * e->radius, 0.1) - e->p;
        e->v = vec3_of(0, 0, 0);
        for (int i = 0; i < 3; i++)
            e->v[i] = rounded(towards[i] / between(2, 6), 0.01);
        away = vec3_length(e->center - e->p);
    } while (away < 1.5 * e->radius || vec3_length(e->v) < 0.3 ||
             vec3_length(vec3_cross(e->center - e->p, e->v)) >
                 0.9 * e->radius * vec3_length(e->v) ||
             vec3_dot(e->center - e->p, e->v) < 0);
}

static Example example_number(int number)
{
    static const int sizes[][2] = {{320, 240},  {640, 480},   {800, 600}, {1024, 768},
                                   {1280, 720}, {1920, 1080}, {512, 512}, {600, 900}};
    if (number == 0)
        return deck;
    state = (uint64_t)number;
    Example e = {.camera = random_camera()};
    e.s = rounded(between(0.05, 0.95), 0.05);
    e.t = rounded(between(0.05, 0.95), 0.05);
    int size = whole(0, 7);
    e.width = sizes[size][0];
    e.height = sizes[size][1];
    e.x = whole(1, e.width - 1);
    e.y = whole(1, e.height - 1);
    random_ray(&e);
    return e;
}

// ---- as a file, as options --------------------------------------------------------------------

static void print_define(const char *name, vec3 v)
{
    printf("#define EXAMPLE_%s %.17g, %.17g, %.17g\n", name, v[0] + 0.0, v[1] + 0.0, v[2] + 0.0);
}

static void print_file(const Example *e)
{
    const Camera *c = &e->camera;
    print_define("EYE", c->origin);
    print_define("RIGHT", c->right);
    print_define("UP", c->up);
    print_define("FORWARD", c->forward);
    printf("#define EXAMPLE_DISTANCE %.17g\n#define EXAMPLE_WIDTH %.17g\n#define EXAMPLE_HEIGHT "
           "%.17g\n",
           c->distance, c->width, c->height);
    printf("#define EXAMPLE_PLACE %.17g, %.17g\n", e->s, e->t);
    printf("#define EXAMPLE_SCREEN %d, %d\n#define EXAMPLE_POINT %d, %d\n", e->width, e->height,
           e->x, e->y);
    print_define("RAY_ORIGIN", e->p);
    print_define("RAY_DIRECTION", e->v);
    print_define("CENTER", e->center);
    printf("#define EXAMPLE_RADIUS %.17g\n", e->radius);
}

static void print_option(const char *name, vec3 v)
{
    printf(" --%s %.17g,%.17g,%.17g", name, v[0] + 0.0, v[1] + 0.0, v[2] + 0.0);
}

static void print_camera(Camera c)
{
    print_option("eye", c.origin);
    print_option("right", c.right);
    print_option("up", c.up);
    print_option("forward", c.forward);
    printf(" --distance %.17g --width %.17g --height %.17g", c.distance, c.width, c.height);
}

static void print_figures(const Example *e)
{
    static const char *const of_cameras[] = {"camera-frame", "corner-vectors", "point-30-10",
                                             "double-dwh", "yours-and-right"};
    static const char *const of_rays[] = {"ray-sphere", "parabola", "discriminant", "world-object"};
    for (int i = 0; i < 5; i++) {
        printf("01-corners %s -s %.17g -t %.17g", of_cameras[i], e->s, e->t);
        print_camera(e->camera);
        printf("\n");
    }
    printf("02-cameras camera-forms");
    print_camera(e->camera);
    printf("\n03-screen screen-to-unit --size %dx%d --point %d,%d", e->width, e->height, e->x,
           e->y);
    printf("\n04-pixel-ray pixel-to-ray --size %dx%d --pixel %d,%d", e->width, e->height, e->x,
           e->y);
    print_camera(e->camera);
    printf("\n");
    for (int i = 0; i < 4; i++) {
        printf("05-quadratic %s", of_rays[i]);
        print_option("origin", e->p);
        print_option("direction", e->v);
        print_option("center", e->center);
        printf(" --radius %.17g\n", e->radius);
    }
}

// ---- what the lessons must hold ---------------------------------------------------------------

static vec3 along(Camera c, double right, double up)
{
    vec3 v = vec3_of(0, 0, 0);
    for (int i = 0; i < 3; i++)
        v[i] = c.distance * c.forward[i] + right * c.right[i] + up * c.up[i];
    return v;
}

// A last digit of 5 may be rounded up or down: both texts are given, with a tab between them.
static const double a_little[] = {1 + 1e-13, 1 - 1e-13};

static void holds(const char *stem, const char *before, double x, int digits, const char *after)
{
    printf("chapters/%s/README.md", stem);
    for (int i = 0; i < 2; i++)
        printf("\t%s%s%s", before, number_text_to(a_little[i] * x, digits).s, after);
    printf("\n");
}

static void holds_vector(const char *stem, const char *before, vec3 v, int digits,
                         const char *after)
{
    printf("chapters/%s/README.md", stem);
    for (int i = 0; i < 2; i++)
        printf("\t%s%s%s", before, vec3_text_to(a_little[i] * v, digits).s, after);
    printf("\n");
}

static void print_cameras(Camera c)
{
    const double w = c.width, h = c.height;
    const char *stem = "01-corners";
    holds_vector(stem, "| eye $p$ | ", c.origin, 6, " |");
    holds(stem, "| width $w$ | ", w, 6, " |");
    holds_vector(stem, "| upper left | 0 | 1 | ", along(c, -0.5 * w, 0.5 * h), 6, " |");
    holds_vector(stem, "| 30% across, 10% up | 0.3 | 0.1 | ", along(c, -0.2 * w, -0.4 * h), 6,
                 " |");
    holds(stem, "at the distance d = ", c.distance, 4, ". It is");
    stem = "02-cameras";
    holds_vector(stem, "| look-at | look-at point ", c.origin + along(c, 0, 0), 6, ",");
    holds(stem, "aspect ratio ", w / h, 6, " |");
    holds(stem, "this camera sees            ",
          2 * acos(c.distance / hypot(c.distance, w / 2)) * 180 / PI, 6, " degrees across");
}

static void print_screens(const Example *e)
{
    const Camera *c = &e->camera;
    const char *format = "chapters/%s/README.md\t%s%d%s%d%s\n";
    printf(format, "03-screen", "\\frac{", e->x, "}{", e->width, "}");
    printf(format, "03-screen", "A screen of ", e->width, " x ", e->height, " pixels");
    printf(format, "03-screen", "a screen of ", e->width, " by ", e->height, " pixels. Its origin");
    holds("04-pixel-ray", "\\frac{", e->x + 0.5, 9, "}{");
    holds_vector("04-pixel-ray", "  &= ",
                 along(*c, (2 * e->x + 1 - e->width) * c->width / (2 * e->width),
                       (e->height - 2 * e->y - 1) * c->height / (2 * e->height)),
                 9, "");
}

static void print_rays(const Example *e)
{
    const char *stem = "05-quadratic";
    double length = vec3_length(e->v);
    vec3 unit = e->v / length, to_center = e->center - e->p;
    double middle = vec3_dot(to_center, unit), off = vec3_length(to_center - middle * unit);
    double half = sqrt((e->radius - off) * (e->radius + off));
    holds_vector(stem, "$p$ = ", e->p, 6, "");
    holds(stem, "$a = ", length * length, 6, "$");
    holds(stem, "$t$ is ", (middle - half) / length, 6, " or");
    holds(stem, ", r is ", e->radius, 4, "");
    holds(stem, "    t                         ", (middle + half) / length, 6, " ");
    holds(stem, "  the hit, smallest t > 0     ", (middle - half) / length, 6, "");
}

static void print_lessons(const Example *e)
{
    print_cameras(e->camera);
    print_screens(e);
    print_rays(e);
}

int main(int argc, char **argv)
{
    int number = argc > 1 ? atoi(argv[1]) : -1;
    Example e = example_number(number < 0 ? 0 : number);
    if (argc == 2 && number >= 0)
        print_file(&e);
    else if (argc == 3 && strcmp(argv[2], "--lessons") == 0)
        print_lessons(&e);
    else if (argc == 3 && strcmp(argv[2], "--figures") == 0)
        print_figures(&e);
    else {
        fprintf(stderr, "Usage: random_example NUMBER [--lessons|--figures]\n");
        return 2;
    }
    return 0;
}
