// wrong_figure.c - figures of random wrong answers, as the judge draws them
// (tests/house/figures/ordinary.py).
//
//   wrong_figure list                     the functions whose wrong answers have a figure
//   wrong_figure FUNCTION NUMBER FOLDER   writes FOLDER/FUNCTION.gp: a random call and, of the
//   known
//                                         mistakes, one that answers it wrongly
//
// Nothing is written if no mistake has a figure for this call.
#include "common/scene.h"
#include "common/screen.h"
#include "exercises/02-cameras.h"
#include "exercises/05-quadratic.h"
#include "tests/judge/figure.h"
#include "tests/judge/message.h"
#include "tests/judge/right_answer.h"
#include "tests/judge/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double scale; // of the world

static Camera camera(void)
{
    Camera c = random_camera();
    double larger = 2 * tan(random_number(20, 100) / 2 * PI / 180),
           aspect = exp(random_number(-1, 1));
    c.origin = scale * random_vec3(-9, 9);
    c.distance = scale * random_number(0.5, 8);
    c.width = c.distance * larger * fmin(1, aspect);
    c.height = c.distance * larger * fmin(1, 1 / aspect);
    return c;
}

// From one to nine radii before the sphere, past its middle at up to 1.2 radii.
static Ray ray_past(Sphere sphere)
{
    vec3 along = random_unit(), aside = random_unit();
    aside = vec3_unit(aside - vec3_dot(aside, along) * along);
    vec3 past = sphere.center + random_number(0.02, 1.2) * sphere.radius * aside;
    return (Ray){past - random_number(1, 9) * sphere.radius * along,
                 scale * random_number(0.2, 5) * along};
}

static Sphere sphere(void)
{
    return (Sphere){scale * random_vec3(-6, 6), scale * random_number(0.3, 3), 0};
}

static void put_camera(Wire *wire)
{
    Camera c = camera();
    wire_put_value(wire, &type_Camera, &c);
}

static Resolution put_screen(Wire *wire, int width, int height)
{
    Resolution screen = {width, height};
    wire_put_value(wire, &type_Resolution, &screen);
    return screen;
}

static Resolution some_screen(void)
{
    return random_screen(4, 2000);
}

static void put_pixel(Wire *wire, Resolution screen)
{
    Pixel pixel = random_pixel(screen);
    wire_put_value(wire, &type_Pixel, &pixel);
}

static void ask_ray_of_pixel(Wire *wire)
{
    put_camera(wire);
    Resolution screen = some_screen();
    put_screen(wire, screen.width, screen.height);
    put_pixel(wire, screen);
}

static void ask_center(Wire *wire)
{
    put_pixel(wire, some_screen());
}

static void ask_point(Wire *wire)
{
    Resolution screen = some_screen();
    ScreenPoint point = {random_number(0, screen.width), random_number(0, screen.height)};
    wire_put_value(wire, &type_ScreenPoint, &point);
    put_screen(wire, screen.width, screen.height);
}

static void ask_place(Wire *wire)
{
    Resolution screen = some_screen();
    Normalized place = {random_number(0, 1), random_number(0, 1)};
    wire_put_value(wire, &type_Normalized, &place);
    put_screen(wire, screen.width, screen.height);
}

static void ask_look_at(Wire *wire)
{
    Camera c = camera(), blank = {0};
    vec3 leaning = c.up + random_number(-1, 1) * c.forward;
    LookAt view = {c.origin, c.origin + c.distance * c.forward, leaning, c.width,
                   c.width / c.height};
    Handedness world = random_number(0, 1) < 0.5 ? RIGHT_HANDED : LEFT_HANDED;
    wire_put_value(wire, &type_LookAt, &view);
    wire_put_value(wire, &type_Handedness, &world);
    wire_put_value(wire, &type_Camera, &blank);
}

static void ask_ray_and_sphere(Wire *wire)
{
    Sphere s = sphere();
    Ray ray = ray_past(s);
    wire_put_value(wire, &type_Ray, &ray);
    wire_put_value(wire, &type_Sphere, &s);
}

static void ask_object_quadratic(Wire *wire)
{
    Sphere s = sphere();
    Ray ray = ray_past(s);
    ray.origin -= s.center;
    wire_put_value(wire, &type_Ray, &ray);
    wire_put_value(wire, &type_double, &s.radius);
}

static void ask_quadratic(Wire *wire)
{
    double a = random_number(0.2, 5), t0 = random_number(-5, 5), t1 = t0 + random_number(0.1, 6);
    Quadratic q = {a, -a * (t0 + t1), a * t0 * t1};
    wire_put_value(wire, &type_Quadratic, &q);
}

static void ask_scene(Wire *wire)
{
    enum { MOST = 6 };
    Sphere spheres[MOST];
    int count = (int)random_number(1, MOST + 1);
    for (int i = 0; i < count; i++)
        spheres[i] = sphere();
    Ray ray = ray_past(spheres[0]);
    Surface surface = {.diffuse = 1};
    Scene scene = {.view.resolution = {4, 3},
                   .spheres = spheres,
                   .sphere_count = count,
                   .surfaces = &surface,
                   .surface_count = 1};
    wire_put_value(wire, &type_Ray, &ray);
    wire_put_value(wire, &type_Scene, &scene);
}

static void ask_rectangle(Wire *wire)
{
    Camera c = camera();
    Resolution screen = some_screen();
    double far = c.distance * random_number(2, 6);
    Sphere s = {c.origin + far * c.forward + 0.3 * far * random_unit(),
                far * random_number(0.05, 0.3), 0};
    wire_put_value(wire, &type_Camera, &c);
    put_screen(wire, screen.width, screen.height);
    wire_put_value(wire, &type_Sphere, &s);
}

static const struct {
    const char *function;
    void (*ask)(Wire *wire);
} asked[] = {{"upper_left", put_camera},
             {"upper_right", put_camera},
             {"across_30_up_10", put_camera},
             {"with_unit_distance", put_camera},
             {"camera_from_look_at", ask_look_at},
             {"screen_to_normalized", ask_point},
             {"normalized_to_screen", ask_place},
             {"pixel_center", ask_center},
             {"pixel_ray", ask_ray_of_pixel},
             {"to_object_coordinates", ask_ray_and_sphere},
             {"object_quadratic", ask_object_quadratic},
             {"world_quadratic", ask_ray_and_sphere},
             {"quadratic_roots", ask_quadratic},
             {"sphere_roots", ask_ray_and_sphere},
             {"hit_sphere", ask_ray_and_sphere},
             {"nearest_hit", ask_scene},
             {"sphere_rectangle", ask_rectangle}};
enum { ASKED = sizeof asked / sizeof *asked };

// The nth mistake of this exercise; NULL: there are not so many.
static const Mistake *mistake_of(const char *function, int n)
{
    for (const Mistake *const *table = chosen_mistakes(); *table != NULL; table++)
        for (const Mistake *mistake = *table; mistake->id != NULL; mistake++)
            if (strcmp(mistake->exercise, function) == 0 && n-- == 0)
                return mistake;
    return NULL;
}

static bool is_same(const Wire *a, const Wire *b)
{
    return a->size == b->size && memcmp(a->bytes, b->bytes, a->size) == 0;
}

// Whether there is a figure of this mistake: on this call, it may be right.
static bool draw(const char *folder, Kept *kept, const Mistake *mistake)
{
    static Wire right;
    Record record = {.function = ""};
    char path[4096];
    snprintf(record.function, sizeof record.function, "%s", mistake->exercise);
    wire_clear(&kept->answer);
    kept->question.read = 0;
    if (!apply(kept->exercise, mistake->answer, &kept->question, &kept->answer) ||
        !right_answer(&record, kept, &right) || is_same(&right, &kept->answer))
        return false;
    figure_write(folder, &record, kept, (Diagnosis){.mistake = mistake});
    snprintf(path, sizeof path, "%s/%s.gp", folder, mistake->exercise);
    return access(path, R_OK) == 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "list") == 0) {
        for (int i = 0; i < ASKED; i++)
            puts(asked[i].function);
        return 0;
    }
    int k = 0;
    while (argc == 4 && k < ASKED && strcmp(argv[1], asked[k].function) != 0)
        k++;
    if (argc != 4 || k == ASKED) {
        fprintf(stderr, "Usage: %s list, or %s FUNCTION NUMBER FOLDER\n", argv[0], argv[0]);
        return 2;
    }
    Kept kept = {.exercise = exercise_number(argv[1])};
    choose_stem(exercises[kept.exercise].stem);
    switch_to_reference();
    random_begin(argv[2], true);
    scale = pow(10, random_number(-3, 3));
    asked[k].ask(&kept.question);
    int count = 0;
    while (mistake_of(argv[1], count) != NULL)
        count++;
    int first = (int)random_number(0, count);
    for (int i = 0; i < count; i++)
        if (draw(argv[3], &kept, mistake_of(argv[1], (first + i) % count)))
            break;
    wire_free(&kept.question);
    wire_free(&kept.answer);
    return 0;
}
