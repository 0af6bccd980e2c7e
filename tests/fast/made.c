// made.c - scenes that are made to be difficult, and random ones.
#include "tests/fast/made.h"

#include "exercises/04-pixel-ray.h"

#include <stdio.h>

enum { MOST = 12000, MOST_AT_RANDOM = 400 };

static Sphere spheres[MOST];
static Surface surfaces[MOST];
static Made *now; // what is being made
static Frame frame_now;

// ---- what they are made of --------------------------------------------------------------------

static unsigned long long state;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

static double power_of_ten(double low, double high)
{
    return pow(10, uniform(low, high));
}

static bool once_in(double times)
{
    return uniform(0, times) < 1;
}

static vec3 within(double most)
{
    double x = uniform(-most, most), y = uniform(-most, most), z = uniform(-most, most);
    return vec3_of(x, y, z);
}

static vec3 direction(void)
{
    return vec3_unit(within(1) + vec3_of(1e-9, 0, 0));
}

// Every sphere has a colour of its own, so that one taken for another shows.
static void add(vec3 center, double radius)
{
    int i = now->scene.sphere_count;
    unsigned color = (unsigned)(i + 1) * 0x9e3779b1U;
    if (i == MOST)
        return;
    surfaces[i].color =
        vec3_of(color >> 24 & 255, color >> 16 & 255, color >> 8 & 255) / vec3_of(255, 255, 255);
    spheres[i] = (Sphere){center, radius, i};
    now->scene.sphere_count = now->scene.surface_count = i + 1;
}

static void look(vec3 from, vec3 at, vec3 roughly_up, double angle, int width, int height)
{
    vec3 forward = vec3_unit(at - from), right = vec3_unit(vec3_cross(forward, roughly_up));
    double distance = vec3_length(at - from), wide = 2 * distance * tan(angle * PI / 360);
    Camera camera = {from,     right, vec3_cross(right, forward), forward,
                     distance, wide,  wide * height / width};
    if (frame_now == FRAME_MIRRORED)
        camera.right = -right;
    if (frame_now == FRAME_STRETCHED) {
        camera.distance *= 0.01;
        camera.width *= 0.01;
        camera.height *= 0.027;
    }
    if (frame_now == FRAME_LEANING) {
        camera.right = (1 + 5e-10) * right + 5e-10 * forward;
        camera.up = (1 - 5e-10) * camera.up + 5e-10 * right;
    }
    now->camera = camera;
    now->size = (Resolution){width, height};
    now->scene = (Scene){.spheres = spheres, .surfaces = surfaces};
}

static const vec3 above = {0.1, 1, 0.2}, middle = {0, 0, 0}, front = {0, 0, 5};

static void look_from(vec3 from, double angle, int width, int height)
{
    look(from, middle, above, angle, width, height);
}

// A sphere that the ray of a random pixel touches.
static void add_tangent(double radius, double away)
{
    Pixel pixel = {(int)uniform(0, now->size.width), (int)uniform(0, now->size.height)};
    Ray ray = pixel_ray(now->camera, now->size, pixel);
    vec3 ahead = vec3_unit(ray.direction), aside = vec3_unit(vec3_cross(ahead, direction()));
    add(ray.origin + away * ahead + radius * aside, radius);
}

// ---- difficult ones ---------------------------------------------------------------------------

static void nothing(void)
{
    look_from(front, 60, 40, 30);
}
static void around_the_eye(void)
{
    look_from(front, 60, 40, 30);
    add(front, 1);
    add(middle, 1);
    add(front, 30);
    add(front + vec3_of(0.1, 0.2, -0.1), 0.5);
}
static void touching_the_eye(void)
{
    look_from(front, 90, 40, 30);
    add(vec3_of(0, 0, 4), 1);
    add(vec3_of(1, 0, 5), 1);
    add(vec3_of(0, -2, 5), 2);
    add(vec3_of(0, 0, 6), 1);
    add(middle, 1);
}
static void nearly_touching_the_eye(void)
{
    look_from(front, 90, 40, 30);
    for (int i = -14; i <= -3; i++) {
        vec3 there = front + direction();
        add(there, 1 + pow(10, i));
        add(there, 1 - pow(10, i));
    }
    add(middle, 1);
}
static void beside_and_behind(void)
{
    look_from(front, 120, 40, 30);
    add(vec3_of(3, 0, 5), 2.5);
    add(vec3_of(-3, 0, 5.5), 2.9);
    add(vec3_of(0, 0, 9), 3.9);
    add(vec3_of(0, 4, 4), 3);
}
static void behind(void)
{
    look_from(front, 170, 40, 30);
    for (int i = 0; i < 50; i++)
        add(front + within(3) + vec3_of(0, 0, 4), uniform(0.1, 2));
}
static void partly_outside(void)
{
    // Beyond each edge and corner of the screen, and just not.
    look_from(front, 60, 37, 31);
    for (int i = 0; i < 60; i++)
        add_tangent(power_of_ten(-2, 1), uniform(1, 9));
}
static void coincident(void)
{
    look_from(front, 60, 40, 30);
    for (int i = 0; i < 8; i++)
        add(middle, 1);
    for (int i = 0; i < 8; i++)
        add(vec3_of(1, 1, 0), 0.5 + 1e-9 * i);
    for (int i = 0; i < 8; i++)
        add(vec3_of(-1, -1, 1e-12 * i), 0.5);
}
static void the_same_far_and_near(void)
{
    // Of the same outline, one behind the other: nearer ones come later.
    look_from(front, 60, 40, 30);
    for (int i = 20; i > 0; i--)
        add(front + vec3_of(0.1 * i, 0.05 * i, -i), 0.3 * i);
}
static void close_behind_one_another(void)
{
    // Many fronts within the precision of a float.
    look_from(front, 40, 40, 30);
    for (int i = 0; i < 60; i++)
        add(vec3_of(0, 0, 1e-7 * uniform(-3, 3)) + 0.01 * within(1), 1);
    for (int i = 0; i < 60; i++)
        add(front + vec3_of(0, 0, -1e3 - uniform(0, 1e-4)), 300);
}
static void outlines_through_pixel_centres(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 90, 32, 32);
    for (int i = 0; i < 16; i++)
        add(vec3_of((i + 0.5) / 2, 0, 0), 0.25);
    add(vec3_of(-2, -2, 0), 2);
    add(vec3_of(-2, 2, 1), 1);
}
static void tangent_to_one_another(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 60, 45, 45);
    for (int i = -3; i <= 3; i++)
        for (int k = -3; k <= 3; k++)
            add(vec3_of(i, k, (i + k) % 2), i % 2 == 0 ? 0.5 : 0.75);
}
static void tiny(void)
{
    look_from(front, 60, 40, 30);
    for (int i = 0; i < 300; i++)
        add(within(2), power_of_ten(-8, -1));
    add(vec3_of(0, 0, 4.999), 1e-6);
}
static void huge(void)
{
    look_from(front, 60, 40, 30);
    add(vec3_of(0, 0, -1e6), 9e5);
    add(vec3_of(0, -1e9, 0), 1e9 - 2);
    add(vec3_of(0, -1e9, 0), 1e9 - 2.00001);
    add(vec3_of(-1e9, 0, 0), 1e9 - 1);
    add(vec3_of(0, 1e6, 0), 1e6 - 3);
    add(vec3_of(0, 0, -1e12), 1e10);
    for (int i = 0; i < 20; i++)
        add(vec3_of(uniform(-2, 2), -2 + uniform(0, 0.1), uniform(-2, 2)), 0.1);
}
static void of_another_size(void)
{
    look_from(1e-6 * front, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(within(2e-6), 3e-7);
}
static void of_no_ordinary_size(void)
{
    look_from(1e16 * front, 60, 40, 30);
    for (int i = 0; i < 20; i++)
        add(within(2e16), 3e15);
    add(1e16 * front, 1e-14);
}
static void far_from_the_origin(void)
{
    vec3 there = vec3_of(1e7, -3e7, 2e7);
    look(there + front, there, above, 60, 40, 30);
    for (int i = 0; i < 50; i++)
        add(there + within(2), 0.4);
}
static void through_a_telescope(void)
{
    look_from(1e6 * front, 1e-5, 40, 30);
    for (int i = 0; i < 100; i++)
        add(vec3_of(uniform(-0.5, 0.5), uniform(-0.4, 0.4), uniform(-1e3, 1e3)), 0.1);
}
static void nearly_all_around(void)
{
    look_from(front, 179.9, 40, 30);
    for (int i = 0; i < 100; i++)
        add(front + uniform(1, 5) * direction(), 0.3);
}
static void in_one_another(void)
{
    look_from(front, 60, 61, 47);
    for (int i = 0; i < 40; i++)
        add(within(1), 1);
}

static const struct {
    const char *name;
    void (*make)(void);
} difficult[] = {{"nothing", nothing},
                 {"around the eye", around_the_eye},
                 {"touching the eye", touching_the_eye},
                 {"nearly touching the eye", nearly_touching_the_eye},
                 {"beside and behind the eye", beside_and_behind},
                 {"behind the eye", behind},
                 {"partly outside the screen", partly_outside},
                 {"coincident", coincident},
                 {"the same, far and near", the_same_far_and_near},
                 {"close behind one another", close_behind_one_another},
                 {"outlines through pixel centres", outlines_through_pixel_centres},
                 {"tangent to one another", tangent_to_one_another},
                 {"tiny", tiny},
                 {"huge", huge},
                 {"of another size", of_another_size},
                 {"of no ordinary size", of_no_ordinary_size},
                 {"far from the origin", far_from_the_origin},
                 {"through a telescope", through_a_telescope},
                 {"nearly all around", nearly_all_around},
                 {"in one another", in_one_another}};

bool made_difficult(Made *made, int number, Frame frame)
{
    static const char *const frames[FRAMES] = {"", ", mirrored", ", stretched", ", leaning"};
    if (number >= (int)(sizeof difficult / sizeof difficult[0]))
        return false;
    now = made;
    frame_now = frame;
    state = (unsigned long long)number + 1;
    difficult[number].make();
    snprintf(made->name, sizeof made->name, "%s%s", difficult[number].name, frames[frame]);
    return true;
}

// ---- sizes ------------------------------------------------------------------------------------

static void begin(Made *made, const char *name)
{
    now = made;
    frame_now = FRAME_USUAL;
    state = 1;
    snprintf(made->name, sizeof made->name, "%s", name);
}

void made_sized(Made *made, Resolution size)
{
    begin(made, "");
    snprintf(made->name, sizeof made->name, "%d x %d", size.width, size.height);
    look_from(front, 60, size.width, size.height);
    add(middle, 1);
    add(vec3_of(0, -1e5, 0), 1e5 - 1);
    for (int i = 0; i < 20; i++)
        add(within(2), uniform(0.05, 1));
}

void made_many(Made *made)
{
    begin(made, "many");
    look_from(front, 50, 40, 35);
    while (made->scene.sphere_count < MOST)
        add(within(2), uniform(0.01, 0.04));
}

void made_wide(Made *made)
{
    begin(made, "wide");
    look_from(front, 1, 1, 4096);
    made->camera.height = 2 * made->camera.distance;
    for (int i = 0; i < 5000; i++)
        add(within(1), uniform(2, 3));
}

// ---- random ones ------------------------------------------------------------------------------

static void add_odd(vec3 at, double unit)
{
    const vec3 eye = now->camera.origin;
    const Sphere earlier =
        spheres[now->scene.sphere_count > 0 ? (int)uniform(0, now->scene.sphere_count) : 0];
    const bool first = now->scene.sphere_count == 0;
    double radius = unit * power_of_ten(-2, 0);
    vec3 aside = direction();
    switch (first ? 4 : (int)uniform(0, 10)) {
    case 0: // the same again; or nearly
        add(earlier.center, earlier.radius);
        break;
    case 1:
        add(earlier.center + 1e-9 * earlier.radius * aside,
            earlier.radius * (1 + power_of_ten(-16, -6)));
        break;
    case 2: // touches another
        add(earlier.center + (earlier.radius + radius) * aside, radius);
        break;
    case 3: // round the eye
        add(eye + uniform(0, 0.999) * radius * aside, radius);
        break;
    case 4: // near the eye
        add(eye + radius * aside, radius * uniform(0.5, 1));
        break;
    case 5: // touches the eye, or nearly
        add(eye + radius * aside,
            radius * (1 + (once_in(2) ? 0 : power_of_ten(-15, -2)) * (once_in(2) ? 1 : -1)));
        break;
    case 6: // tiny
        add(at, unit * power_of_ten(-9, -3));
        break;
    case 7: // huge
        radius = unit * power_of_ten(1, 9);
        add(at + radius * aside, radius);
        break;
    default: // touches a ray
        add_tangent(radius, unit * power_of_ten(-1, 1));
    }
}

void made_at_random(Made *made, unsigned number)
{
    begin(made, "");
    snprintf(made->name, sizeof made->name, "random scene %u", number);
    state = number * 7919ULL + 1;
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
    frame_now = (Frame)uniform(0, FRAMES);
    const double unit = once_in(4) ? power_of_ten(-9, 9) : 1;
    const vec3 there = once_in(4) ? unit * within(power_of_ten(0, 6)) : middle;
    int width = (int)uniform(1, 90), height = (int)uniform(1, 70);
    if (once_in(8))
        *(once_in(2) ? &width : &height) = 1;
    double angle = once_in(8) ? power_of_ten(-2, 1) : uniform(10, 175);
    look(there + unit * within(3), there + unit * within(1), above, angle, width, height);
    const int count = (int)pow(MOST_AT_RANDOM, uniform(0, 1));
    const double size = power_of_ten(-2, 0), odd = once_in(2) ? 1e9 : once_in(2) ? 20 : 2;
    for (int i = 0; i < count; i++) {
        vec3 at = there + unit * within(2);
        if (once_in(odd))
            add_odd(at, unit);
        else
            add(at, unit * size * uniform(0.1, 1));
    }
}
