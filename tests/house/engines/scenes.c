// scenes.c - scenes that are made to be difficult, to cast and to light, for screens of all sizes,
// of many spheres, extremely far away, and random ones.
#include "tests/house/engines/scenes.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include <stdio.h>

// ---- what scenes are made of ------------------------------------------------------------------

enum { MOST = 12000, MOST_AT_RANDOM = 400, LIGHTS = 3 };

static Sphere spheres[MOST];
static Surface surfaces[MOST];
static Light lights[LIGHTS];
// The scene that is being made.
static Made *now;
// How a camera differs from that of an NFF viewpoint: not at all; its right is on the other side;
// its pixels are not square and its plane is near; its axes are off by as much as is allowed.
typedef enum { FRAME_USUAL, FRAME_MIRRORED, FRAME_STRETCHED, FRAME_LEANING, FRAMES } Frame;
static Frame frame_now;
// The default eye, the point that it looks at, roughly up, and a light.
static const vec3 front = {0, 0, 5}, middle = {0, 0, 0}, above = {0.1, 1, 0.2}, lamp = {3, 9, 6};

static unsigned long long state;

double uniform(double low, double high)
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

vec3 within(double most)
{
    double x = uniform(-most, most), y = uniform(-most, most), z = uniform(-most, most);
    return vec3_of(x, y, z);
}

static vec3 direction(void)
{
    return vec3_unit(within(1) + vec3_of(1e-9, 0, 0));
}

// The same random numbers after the same number.
static void begin(Made *made, unsigned long long number)
{
    now = made;
    frame_now = FRAME_USUAL;
    state = number;
    for (int i = 0; i < 8; i++)
        uniform(0, 1);
}

// One sphere more, of a color of its own, so that one taken for another shows; two of three
// mirror.
static void add(vec3 center, double radius)
{
    int i = now->scene.sphere_count;
    if (i == MOST)
        return;
    unsigned bits = (unsigned)(i + 1) * 0x9e3779b1U;
    Color color = vec3_of(bits >> 24 & 255, bits >> 16 & 255, bits >> 8 & 255) / 255;
    surfaces[i] = (Surface){.color = color, .diffuse = 0.5, .specular = i % 3 / 3.0, .shine = 7};
    spheres[i] = (Sphere){center, radius, i};
    now->scene.sphere_count = now->scene.surface_count = i + 1;
}

static void heap(vec3 at, double size, int count, double radius)
{
    for (int i = 0; i < count; i++)
        add(at + within(size), radius * uniform(0.3, 1));
}

static void light_up(vec3 position, LightKind kind)
{
    int i = now->scene.light_count++;
    lights[i] = (Light){position, vec3_of(0.7 - 0.2 * i, 0.5, 0.3 + 0.2 * i), kind};
}

// A light near the spheres around a place, on one of them, in the eye, far away, or distant.
static void light_somewhere(vec3 there, double size)
{
    const Sphere sphere = spheres[(int)uniform(0, now->scene.sphere_count)];
    const double far = fmin(size * power_of_ten(0, 15), 1e15);
    switch ((int)uniform(0, 6)) {
    case 0:
        light_up(there + 3 * size * direction(), LIGHT_POINT);
        break;
    case 1:
        light_up(sphere.center + sphere.radius * (1 + power_of_ten(-16, -1)) * direction(),
                 LIGHT_POINT);
        break;
    case 2:
        light_up(sphere.center + sphere.radius * direction(), LIGHT_POINT);
        break;
    case 3:
        light_up(now->camera.origin, LIGHT_POINT);
        break;
    case 4:
        light_up(there + far * direction(), LIGHT_POINT);
        break;
    default:
        light_up(power_of_ten(-12, 12) * direction(), LIGHT_DISTANT);
    }
}

// One to three of them, unless the scene has lights of its own.
static void light_at_random(vec3 there, double size)
{
    for (int i = now->scene.light_count > 0 ? 0 : (int)uniform(1, LIGHTS + 1); i > 0; i--)
        light_somewhere(there, size);
}

// Nothing but a camera; the angle is in degrees, across the width.
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
    now->depth = 5;
    now->scene = (Scene){.spheres = spheres,
                         .surfaces = surfaces,
                         .lights = lights,
                         .background = {0.1, 0.2, 0.3},
                         .ambient = {0.1, 0.1, 0.1}};
}

static void look_from(vec3 from, double angle, int width, int height)
{
    look(from, middle, above, angle, width, height);
}

static Ray ray_of_a_pixel(void)
{
    int column = (int)uniform(0, now->size.width), row = (int)uniform(0, now->size.height);
    return pixel_ray(now->camera, now->size, (Pixel){column, row});
}

// The ray that leaves the surface seen by a ray; NaN if that meets nothing.
static Ray leaves_at(Ray ray)
{
    Hit hit = nearest_hit(ray, &now->scene);
    if (hit.sphere < 0)
        return (Ray){vec3_of(NAN, NAN, NAN), ray.direction};
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = surface_normal(spheres[hit.sphere], point);
    return (Ray){offset_from_surface(spheres[hit.sphere], point, normal),
                 mirror_direction(ray.direction, normal)};
}

// One that a ray touches so far away; or so nearly that rounding decides whether it is hit.
static void graze(Ray ray, double away, double radius)
{
    // As often as not where its outline is farthest left or right, above or below.
    vec3 across = once_in(2) ? direction() : once_in(2) ? now->camera.up : now->camera.right;
    vec3 ahead = vec3_unit(ray.direction), aside = vec3_unit(vec3_cross(ahead, across));
    double beside = radius + (once_in(2) ? 0 : uniform(-4e-16, 4e-16) * away);
    if (vec3_is_finite(ray.origin) && vec3_is_finite(aside))
        add(ray.origin + away * ahead + (once_in(2) ? beside : -beside) * aside, radius);
}

// Spheres that rays of the eye, of mirrors or to a light touch, near the end of the ray if it has
// one, up to most of their radii from its start.
static void graze_some(double unit, double most)
{
    const int light_count = now->scene.light_count;
    for (int i = (int)uniform(1, 30); i > 0; i--) {
        int way = (int)uniform(-1, light_count + 1);
        Ray ray = way < 0 ? ray_of_a_pixel() : leaves_at(ray_of_a_pixel());
        ray = way > 0 ? ray_to_light(ray.origin, lights[way - 1]) : ray;
        bool ends = way < 0 || (way > 0 && lights[way - 1].kind == LIGHT_POINT);
        double away = ends ? vec3_length(ray.direction) * (1 - power_of_ten(-12, -0.1))
                           : unit * power_of_ten(-2, log10(most));
        graze(ray, away, fmax(away / power_of_ten(0, log10(most)), 1e-12));
    }
}

// Two that the ray of a random pixel meets in the same place; the second is that many times larger.
static void add_meeting(double radius, double times, double away)
{
    Ray ray = ray_of_a_pixel();
    vec3 ahead = vec3_unit(ray.direction);
    for (int i = 0; i < 2; i++, radius *= times) {
        // From head on to hardly at all.
        vec3 aside = vec3_unit(vec3_cross(ahead, direction()));
        double angle = PI / 2 * (1 - power_of_ten(-4, 0));
        add(ray.origin + away * ahead + radius * (cos(angle) * ahead + sin(angle) * aside), radius);
    }
}

// ---- difficult ones ---------------------------------------------------------------------------

static void nothing(void)
{
    look_from(front, 60, 40, 30);
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
static void hardly_before_a_wall(void)
{
    look(front, middle, vec3_of(0, 1, 0), 4, 40, 30);
    add(vec3_of(0, 0, -1e3), 1e3);
    for (int i = 0; i < 60; i++)
        add(vec3_of(uniform(-0.16, 0.16), uniform(-0.12, 0.12), -0.019), 0.02);
}
static void outlines_through_pixel_centers(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 90, 32, 32);
    for (int i = 0; i < 16; i++)
        add(vec3_of((i + 0.5) / 2, 0, 0), 0.25);
    add(vec3_of(-2, -2, 0), 2);
    add(vec3_of(-2, 2, 1), 1);
}
static void of_one_pixel_where_tiles_meet(void)
{
    static const int places[] = {0, 3, 4, 7, 15, 16, 31, 32, 39};
    enum { PLACES = sizeof places / sizeof places[0] };
    look_from(front, 60, 40, 40);
    for (int i = 0; i < PLACES * PLACES; i++) {
        Pixel pixel = {places[i % PLACES], places[i / PLACES]};
        Ray ray = pixel_ray(now->camera, now->size, pixel);
        add(ray.origin + uniform(1, 2) * ray.direction, 0.01);
    }
}
static void touching_at_their_outlines(void)
{
    // All touch one ray in one place, and go different ways from there.
    look_from(front, 40, 40, 30);
    Ray ray = pixel_ray(now->camera, now->size, (Pixel){20, 15});
    vec3 place = ray.origin + 0.8 * ray.direction;
    vec3 ahead = vec3_unit(ray.direction), aside = vec3_unit(vec3_cross(ahead, above));
    for (int i = 0; i < 30; i++)
        add(place + 0.1 * (i + 1) * aside + 1e-7 * direction(), 0.1 * (i + 1));
}
static void at_both_ends_of_the_world(void)
{
    look_from(front, 40, 20, 15);
    add(vec3_of(1e308, 0, 0), 1);
    add(vec3_of(-1e308, 0, 0), 1);
    add(vec3_of(1e308, 1e308, 1e308), 1e308);
    add(middle, 1e308);
    add(middle, 1e-308);
    add(vec3_of(0, 0, 4), 1e-323);
    add(middle, 1);
}

static void facing_mirrors(void)
{
    look_from(vec3_of(0, 0.3, 1), 80, 40, 30);
    light_up(vec3_of(0.3, 1.5, 0), LIGHT_POINT);
    for (int i = 0; i < 6; i++)
        add(vec3_of(0, 0, i % 2 == 0 ? -1003 : 1003), 1000);
    heap(middle, 2, 20, 0.4);
}
static void tangent_to_one_another_and_lights(void)
{
    look(vec3_of(0, 0, 8), middle, vec3_of(0, 1, 0), 60, 31, 23);
    light_up(vec3_of(0, 1, 0), LIGHT_DISTANT);
    light_up(vec3_of(0, 4, 0), LIGHT_POINT);
    for (int i = -3; i <= 3; i++)
        for (int k = -3; k <= 3; k++)
            add(vec3_of(i, k, (i + k) % 2), i % 2 == 0 ? 0.5 : 0.75);
}
static void lights_on_surfaces(void)
{
    look_from(front, 60, 40, 30);
    add(middle, 1);
    add(vec3_of(2, 0, 0), 1);
    add(vec3_of(0, 2.25, 0), 0.25);
    light_up(vec3_of(1, 0, 0), LIGHT_POINT);
    light_up(vec3_of(0, 2, 0), LIGHT_POINT);
    // A light at the very place from which it is looked for.
    light_up(leaves_at(pixel_ray(now->camera, now->size, (Pixel){20, 15})).origin, LIGHT_POINT);
}
// Spheres smaller than the steps between the numbers of their places, so a point on one is its
// center, and has no normal.
static void smaller_than_rounding(void)
{
    vec3 there = vec3_of(1e5, -2e5, 1e5);
    look(there + 1e-9 * front, there, above, 1, 40, 30);
    light_up(there + 1e-6 * lamp, LIGHT_POINT);
    light_up(lamp, LIGHT_DISTANT);
    for (int i = 0; i < 60; i++)
        add(there + within(5e-11), 3e-12);
}
// At the corners of the boxes rays enter nearly all of them, more than can wait in a list, and hit
// only what is behind them.
static void overlapping_boxes(void)
{
    look_from(vec3_of(0, 0, 7), 50, 31, 23);
    now->depth = 1;
    light_up(vec3_of(3, 4, 5), LIGHT_POINT);
    add(vec3_of(0, 0, -25), 20);
    for (int i = 1; i < 1200; i++)
        add(within(0.4), 2);
}

static const struct {
    const char *name;
    void (*make)(void);
} difficult[] = {{"nothing", nothing},
                 {"the same, far and near", the_same_far_and_near},
                 {"close behind one another", close_behind_one_another},
                 {"hardly before a wall", hardly_before_a_wall},
                 {"outlines through pixel centers", outlines_through_pixel_centers},
                 {"of one pixel, where tiles meet", of_one_pixel_where_tiles_meet},
                 {"touching at their outlines", touching_at_their_outlines},
                 {"at both ends of the world", at_both_ends_of_the_world},
                 {"mirrors that face each other", facing_mirrors},
                 {"tangent to one another and lights", tangent_to_one_another_and_lights},
                 {"lights on surfaces", lights_on_surfaces},
                 {"smaller than rounding", smaller_than_rounding},
                 {"overlapping boxes", overlapping_boxes}};

bool made_difficult(Made *made, int number)
{
    static const char *const frames[FRAMES] = {"", ", mirrored", ", stretched", ", leaning"};
    enum { COUNT = sizeof difficult / sizeof difficult[0] };
    if (number >= COUNT * FRAMES)
        return false;
    begin(made, (unsigned long long)number + 1);
    frame_now = (Frame)(number % FRAMES);
    difficult[number / FRAMES].make();
    light_at_random(middle, 3);
    snprintf(made->name, sizeof made->name, "%s%s", difficult[number / FRAMES].name,
             frames[frame_now]);
    return true;
}

// ---- of any size ------------------------------------------------------------------------------

void made_sized(Made *made, Resolution size)
{
    begin(made, 1);
    snprintf(made->name, sizeof made->name, "%d x %d", size.width, size.height);
    look_from(front, 60, size.width, size.height);
    add(middle, 1);
    add(vec3_of(0, -1e5, 0), 1e5 - 1);
    for (int i = 0; i < 20; i++)
        add(within(2), uniform(0.05, 1));
    light_at_random(middle, 3);
}

void made_many(Made *made)
{
    begin(made, 1);
    snprintf(made->name, sizeof made->name, "many");
    look_from(front, 60, 29, 23);
    for (int i = 0; i < MOST; i++) {
        // Where threads may have their limits, spheres are in front of all others.
        int k = i / 1000;
        if (i % 1000 == 0)
            add(vec3_of(0.5 * (k % 4) - 1.2, 0.4 * (k / 4) - 0.6, 2.5), 0.1);
        else if (i % 1000 == 999)
            add(vec3_of(0.5 * (k % 4) - 0.95, 0.4 * (k / 4) - 0.6, 2.5), 0.1);
        else
            add(within(1), uniform(0.16, 0.3));
    }
}

void made_wide(Made *made)
{
    begin(made, 1);
    snprintf(made->name, sizeof made->name, "wide");
    look_from(front, 1, 1, 4096);
    made->camera.height = 0.5 * made->camera.distance;
    for (int i = 0; i < 4300; i++)
        add(within(1), uniform(2, 3));
}

void made_hidden(Made *made)
{
    begin(made, 1);
    snprintf(made->name, sizeof made->name, "hidden");
    look_from(front, 45, 160, 130);
    add(vec3_of(0.1, 0, 0), 1);
    add(vec3_of(-0.4, 0.3, 0.9), 0.6);
    while (made->scene.sphere_count < MOST)
        add(within(1.5), uniform(0.01, 0.05));
}

// ---- random ones -----------------------------------------------------------------------------

static void add_odd(vec3 at, double unit)
{
    const vec3 eye = now->camera.origin;
    const int count = now->scene.sphere_count;
    const Sphere earlier = now->scene.spheres[(int)uniform(0, count)]; // of none: not looked at
    double radius = unit * power_of_ten(-2, 0);
    vec3 aside = direction();
    switch (count == 0 ? 4 : (int)uniform(0, 10)) {
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
    case 8: // met by a ray where another is
        add_meeting(radius, power_of_ten(0, 4), unit * power_of_ten(-1, 1));
        break;
    default: // touches a ray
        graze(ray_of_a_pixel(), unit * power_of_ten(-1, 1), radius);
    }
}

void made_at_random(Made *made, unsigned number)
{
    begin(made, number * 7919ULL + 1);
    snprintf(made->name, sizeof made->name, "random scene %u", number);
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
    light_at_random(there, unit);
    made->depth = (int)uniform(0, 6);
    if (odd < 1e9)
        graze_some(unit * size, 1e9);
}

static void add_within_limits(vec3 center, double radius, double specular)
{
    int i = now->scene.sphere_count;
    add(center, fmin(fmax(radius, 1e-12), 1e14));
    surfaces[i].specular = specular;
}

void made_far_apart(Made *made, unsigned number)
{
    begin(made, number * 7919ULL + 5);
    snprintf(made->name, sizeof made->name, "scene %u far apart", number);
    if (number % 20 == 1) { // four sizes at once; the light is in the eye
        look(middle, vec3_of(0, 0, -1), vec3_of(0, 1, 0), 60, 31, 23);
        light_up(middle, LIGHT_POINT);
        for (int i = 0; i < 4; i++) {
            double radius = power_of_ten(-0.7, 0) * (const double[]){1e-10, 1e2, 1e7, 1e14}[i];
            double away = uniform(10, 24) * radius;
            add(away * vec3_of(uniform(-0.4, 0.4), uniform(-0.3, 0.3), -1), radius);
        }
        return;
    }
    // A heap anywhere, seen from outside; or from among its spheres, and then often in mirrors.
    // Lengths are up to most times as large as the heap: so far that plain casts the scene, or not.
    const double most = once_in(6) ? 1e15 : once_in(2) ? power_of_ten(6, 9) : power_of_ten(0.5, 9);
    const double size = once_in(2) ? 1 : power_of_ten(-9, 11), least = uniform(-1, -0.1);
    const vec3 there =
        once_in(3) ? fmin(size * power_of_ten(0, log10(most)), 1e15) * direction() : middle;
    const bool far = once_in(2), odd = once_in(2);
    const double nearest = once_in(2) ? 0.5 : log10(most) - 1;
    const double away = far ? fmin(size * power_of_ten(nearest, log10(most)), 1e15) : 3 * size;
    const vec3 eye = there + away * (once_in(3) ? vec3_of(0, 0, 1) : direction());
    look(eye, there, above, far ? 2 * atan(1.5 * size / away) * 180 / PI : uniform(40, 130), 40,
         30);
    for (int i = (int)uniform(1, 40); i > 0; i--)
        add_within_limits(there + within(size), size * power_of_ten(least, 0), i % 3 / 3.0);
    for (int i = odd && once_in(2) ? (int)uniform(1, 5) : 0; i > 0; i--) { // around the heap
        double radius = size * fmin(power_of_ten(0.6, once_in(2) ? 4 : 14), most);
        add_within_limits(there + radius * uniform(0, 0.5) * direction(), radius, 0.7);
    }
    for (int i = odd && once_in(2) ? (int)uniform(1, 5) : 0; i > 0; i--) { // touching others
        const Sphere sphere = spheres[(int)uniform(0, now->scene.sphere_count)];
        double many = power_of_ten(0, fmin(14, log10(most)));
        double radius = once_in(2) ? sphere.radius / fmin(many, 1e10) : size * many;
        double gap = once_in(2) ? 0 : uniform(-1, 1) * power_of_ten(-16, -8) * sphere.radius;
        add_within_limits(sphere.center + (sphere.radius + radius + gap) * direction(), radius,
                          0.4);
    }
    light_at_random(there, size);
    made->depth = (int)uniform(0, 6);
    if (odd && once_in(2))
        graze_some(spheres[0].radius, fmin(most, 1e12));
}

// ---- far ones ---------------------------------------------------------------------------------

// Spheres in a heap, that many of their radii away, which fills the screen; the eye is anywhere.
void made_far(Made *made, unsigned number, double radii, double radius)
{
    begin(made, number * 104729ULL + 1);
    snprintf(made->name, sizeof made->name, "scene %u, %g radii of %g away", number, radii, radius);
    const double wide = once_in(2) ? 1.5 : 8;
    vec3 there = once_in(3) ? radii * radius * direction() : middle;
    vec3 eye = there + radii * radius * direction();
    // Not by an angle: in degrees it would lose its digits.
    look(eye, there, above, 1, (int)uniform(20, 50), (int)uniform(20, 50));
    made->camera.width = 4 * wide * radius;
    made->camera.height = made->camera.width * made->size.height / made->size.width;
    if (once_in(2)) { // the plane is near, as another angle would have it
        double nearer = 1 / radii;
        made->camera.distance *= nearer;
        made->camera.width *= nearer;
        made->camera.height *= nearer;
    }
    for (int i = (int)uniform(2, 40); i > 0; i--)
        add(there + wide * radius * within(1), radius * uniform(1, 1.5));
}

void made_edge(Made *made, unsigned number, double radii, double width)
{
    begin(made, number * 104729ULL + 2);
    snprintf(made->name, sizeof made->name, "edge %u, %g radii away, %g wide", number, radii,
             width);
    look(radii * direction(), middle, above, 1, 40, 30);
    vec3 edge = once_in(2) ? made->camera.right : made->camera.up;
    made->camera.origin += once_in(2) ? edge : -edge;
    made->camera.width = width;
    made->camera.height = 0.75 * width;
    add(middle, 1);
    add(vec3_of(0.1, 0.1, 0.1), 0.3);
}
